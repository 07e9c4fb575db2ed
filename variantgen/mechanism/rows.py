"""The form in which joints and drivers state their constraints at the levels of position, velocity, acceleration.

Every constraint is linear in the velocities: a :class:`ScalarRow` is one real equation, a :class:`VectorRow` gives
the velocity of one point by that of a pole and the angular velocities of bodies. At the level of accelerations the
same coefficients stand before the accelerations, and a term quadratic in the velocities is added.
"""

from __future__ import annotations

from collections.abc import Mapping
from typing import Protocol, TypeAlias

import numpy as np
from msgspec import Struct, field

from variantgen.mechanism.arithmetic import Complex, Flags, Real, from_parts, unit_vector


class Frame(Struct, frozen=True):
    """How a scene is laid on the paper: left and right exchanged (``sense`` -1), then a rotation (``turn``).

    Constructions work in the scene's own frame; everything after that works on paper. ``turn`` is a unit complex
    number, both may be arrays over the batch.
    """

    turn: Complex = 1.0
    sense: Real = 1.0

    @property
    def plain(self) -> bool:
        """Whether everything lies on paper as in the scene, for all variants."""
        return isinstance(self.turn, float) and isinstance(self.sense, float) and self.turn == self.sense == 1.0

    def place(self, z: Complex) -> Complex:
        """A point or vector of the scene, on paper."""
        if self.plain:
            return z
        result: Complex = self.turn * from_parts(self.sense * np.real(z), np.imag(z))
        return result

    def unplace(self, z: Complex) -> Complex:
        """The inverse of :meth:`place`: what is on paper, in the scene."""
        back = np.conj(self.turn) * z
        result: Complex = from_parts(self.sense * np.real(back), np.imag(back))
        return result

    def direction(self, angle: Real) -> Complex:
        """Unit vector on paper of a direction given in the scene's own frame (rad)."""
        return self.place(unit_vector(angle))


class Placement(Struct, frozen=True):
    """A configuration: positions of points (m) and, in verification, rotations of bodies since the start (rad)."""

    z: Mapping[str, Complex]
    frame: Frame = Frame()
    turned: Mapping[str, Real] = field(default_factory=dict)


class Speeds(Struct, frozen=True):
    """Velocities of points (m/s) and angular velocities of bodies (rad/s) that are already known."""

    v: Mapping[str, Complex]
    omega: Mapping[str, Real]


class Shape(Struct, frozen=True):
    """Which points and bodies a row couples.

    ``given_point`` names the point whose velocity a vector row gives, ``pole`` the point whose velocity it starts from.
    """

    points: tuple[str, ...] = ()
    bodies: tuple[str, ...] = ()
    given_point: str | None = None
    pole: str | None = None


class ScalarRow(Struct, frozen=True):
    """``sum Re(conj(c_P) v_P) + sum k_b omega_b = rate`` with ``points`` c_P and ``bodies`` k_b."""

    points: Mapping[str, Complex]
    bodies: Mapping[str, Real] = field(default_factory=dict)


class VectorRow(Struct, frozen=True):
    """``v_point = v_pole + sum c_b omega_b`` with ``bodies`` c_b (v_pole where the shape names a pole).

    At the level of accelerations the quadratic term is added.
    """

    point: str
    bodies: Mapping[str, Complex] = field(default_factory=dict)


Row: TypeAlias = ScalarRow | VectorRow


class Constraint(Protocol):
    """The interface of a joint or a driver for the solver and the verification, which know nothing else of it."""

    def shapes(self) -> tuple[Shape, ...]:
        """The structure of the rows, without numbers."""
        ...

    def rows(self, at: Placement) -> tuple[Row, ...]:
        """The rows with their coefficients, in the order of ``shapes``."""
        ...

    def rates(self, order: int) -> tuple[Real, ...]:
        """Right-hand side per row: prescribed velocity (order 1) or acceleration (order 2); zero for joints."""
        ...

    def quadratic(self, at: Placement, speeds: Speeds) -> tuple[Complex, ...]:
        """Per row, what the velocities add at the level of accelerations.

        Real and on the left-hand side for a scalar row, complex and on the right-hand side for a vector row.
        """
        ...

    def residual(self, moved: Placement, start: Placement, time: Real) -> tuple[Real, ...]:
        """The residual of the constraint at the level of positions, ``time`` seconds after the start (m or rad).

        Written without the rows, so that the two can be checked against each other.
        """
        ...


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
