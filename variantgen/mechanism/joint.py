"""What a joint is: a constraint for the solver, and what figures, solutions, checks and messages ask of it."""

from __future__ import annotations

from collections.abc import Mapping
from typing import Protocol

import numpy as np
from msgspec import Struct

from variantgen.mechanism.arithmetic import Complex, Flags, Real
from variantgen.mechanism.rows import Constraint, Placement, Shape


class Sliding(Struct, frozen=True):
    """A point slides on a body: along the line through two points of it or, without ``line``, about ``centre``."""

    point: str
    body: str
    line: tuple[str, str] | None = None
    centre: str = ""

    def tangent(self, at: Mapping[str, Complex]) -> Complex:
        """Unit vector along the path on the body."""
        if self.line is not None:
            way = at[self.line[1]] - at[self.line[0]]
        else:
            way = 1j * (at[self.point] - at[self.centre])
        return way / np.abs(way)

    def curvature(self, at: Mapping[str, Complex]) -> Complex:
        """Vector from the point to the centre of its path over the square of the radius (1/m); 0 for a line."""
        if self.line is not None:
            return 0.0
        ray = at[self.centre] - at[self.point]
        return ray / np.abs(ray) ** 2


class BodyContact(Struct, frozen=True):
    """Two bodies touch at a place (m) without slip; each is given by its name and one of its points.

    ``other`` is None where the first touches something at rest.
    """

    place: Complex
    body: tuple[str, str]
    other: tuple[str, str] | None = None


class GroundWheel(Struct, frozen=True):
    """A wheel of a body rolls on what is at rest: on a line at ``contact``, or on a circle ``around`` a point."""

    body: str
    centre: str
    contact: str = ""
    around: str = ""


class JointCircle(Struct, frozen=True):
    """A circle that rolls, meshes or carries a rope: about a point, of a ``body`` ("" where it is at rest or free)."""

    centre: str
    radius: Real
    body: str = ""


class Strand(Struct, frozen=True):
    """A straight piece of a rope from a ``station`` at rest that is no body, a circle of ``radius`` (m) about a point.

    ``end`` is the point of the station at its other end, ``ray`` the unit vector on paper along it.
    """

    station: str
    radius: Real
    end: str
    ray: Complex


class Pair(Constraint, Protocol):
    """A joint: its constraint, and what figures, checks and messages ask of it."""

    def contact_at(self, at: Placement) -> BodyContact | None:
        """Where two bodies touch without slip, if they do."""
        ...

    def circles(self, at: Placement) -> tuple[JointCircle, ...]:
        """The circles of wheels, gears, pulleys that the joint takes for granted (m)."""
        ...

    def when_surplus(self) -> str:
        """What to write instead where the motion that this joint demands is demanded elsewhere too; "" for nothing."""
        ...

    def hanging(self) -> tuple[str, ...]:
        """Points that hang free at the end of a rope, if any do."""
        ...

    def strands(self, at: Placement) -> tuple[Strand, ...]:
        """What leads from stations at rest that are no bodies, so that their places tell its direction."""
        ...

    def landmarks(self) -> tuple[str, ...]:
        """Points at rest by which the joint is described, though they are no part of the mechanism."""
        ...

    def sound(self, at: Placement) -> Flags:
        """Whether the joint can be as it is described: circles that touch, points that are apart."""
        ...

    def intact(self, moved: Placement, start: Placement) -> Flags:
        """Whether the joint is still what it was at the start, a short way ago: no load has run past its pulley."""
        ...

    def marked(self, moved: Placement, start: Placement) -> Mapping[str, Complex]:
        """Where places are now that the joint names and that no body carries along: the contact of a wheel."""
        ...

    def resting(self) -> tuple[str, ...]:
        """Points that the joint takes to be at rest."""
        ...

    def mistake(self) -> str:
        """What an author got wrong that names and dimensions cannot tell, if anything."""
        ...

    def sliding(self) -> Sliding | None:
        """Which point slides on which moving body, if any does."""
        ...

    def on_ground(self) -> GroundWheel | None:
        """Which wheel rolls on what is at rest, if one does."""
        ...

    def locked(self) -> tuple[str, str] | None:
        """Two bodies that keep their orientation to each other, if they do: a sleeve that does not swivel, its bar."""
        ...


class Joint(Struct, frozen=True):
    """Common part of the joints: nothing is prescribed, so all rates are zero; nothing slides on a body."""

    def shapes(self) -> tuple[Shape, ...]:
        """The structure of the rows (each joint says)."""
        return ()

    def rates(self, order: int) -> tuple[Real, ...]:
        """Zero for each row: a joint does not prescribe motion."""
        return tuple(0.0 for _ in self.shapes())

    def sliding(self) -> Sliding | None:
        """Which point slides on which moving body (a sleeve or a slot says)."""
        return None

    def on_ground(self) -> GroundWheel | None:
        """Which wheel rolls on what is at rest (rolling says)."""
        return None

    def locked(self) -> tuple[str, str] | None:
        """Two bodies that keep their orientation to each other (a sleeve that does not swivel says)."""
        return None

    def contact_at(self, at: Placement) -> BodyContact | None:
        """Where two bodies touch without slip (rolling and gears say)."""
        return None

    def circles(self, at: Placement) -> tuple[JointCircle, ...]:
        """None (rolling, gears and ropes say)."""
        return ()

    def when_surplus(self) -> str:
        """Nothing (rolling says)."""
        return ""

    def hanging(self) -> tuple[str, ...]:
        """Points that hang free at the end of a rope (a rope says)."""
        return ()

    def strands(self, at: Placement) -> tuple[Strand, ...]:
        """What leads from stations at rest (a rope says)."""
        return ()

    def landmarks(self) -> tuple[str, ...]:
        """Points at rest by which the joint is described (the centre of a fixed arc)."""
        return ()

    def sound(self, at: Placement) -> Flags:
        """Always (joints of circles and lines check their geometry)."""
        return True

    def intact(self, moved: Placement, start: Placement) -> Flags:
        """Whether it is sound in its new place (a rope looks at its straight pieces too)."""
        return self.sound(moved)

    def marked(self, moved: Placement, start: Placement) -> Mapping[str, Complex]:
        """Nothing (rolling on a line says where the contact is)."""
        return {}

    def resting(self) -> tuple[str, ...]:
        """The landmarks."""
        return self.landmarks()

    def mistake(self) -> str:
        """Nothing (a rope checks its path)."""
        return ""
