"""Inextensible rope or thread over fixed and movable pulleys, off and onto drums, between any two bodies."""

from __future__ import annotations

from collections.abc import Mapping
from itertools import pairwise
from typing import Annotated, ClassVar, TypeAlias

import numpy as np
from msgspec import Struct

from variantgen.mechanism.arithmetic import Complex, Flags, Real, cross, dot
from variantgen.mechanism.component import Angle, BodyName, PointName, Radius, Side, WordMeaning
from variantgen.mechanism.constructions.tangent import thread_direction
from variantgen.mechanism.joint import Joint, JointCircle, Strand
from variantgen.mechanism.rows import Placement, ScalarRow, Shape, Speeds

RopeSide: TypeAlias = Annotated[
    Side,
    WordMeaning(
        "of the circle, looking along the rope from its first bend to its last: on the left side of the circle the"
        " rope has the centre on its right, as where it goes up, over a pulley to the right, and down again"
    ),
]
# Of the radii at its ends: how short a straight piece of a moving rope may become.
_NEAR = 0.25
_UPRIGHT = 1e-6  # cosine of a direction: less is none


class Bend(Struct, frozen=True):
    """A station of a rope: an end, a pulley, or a drum or a wheel that the rope does not slip on.

    The rope touches the circle of ``radius`` about ``point`` on the left or right ``side`` of its way; radius 0 is the
    point itself. ``body``: the rope is wound on this body, so that its rotation takes up rope. ``fixed``: the point
    is at rest and needs no pivot (a pulley on a bracket, an anchor). ``along`` (rad): the direction that the straight
    pieces at this moving block keep in a ``parallel`` rope.
    """

    point: PointName
    radius: Radius = 0.0
    side: RopeSide = 1.0
    body: BodyName | None = None
    fixed: bool = False
    along: Angle | None = None
    belongs: ClassVar[Mapping[str, str]] = {"point": "body"}


class Rope(Joint, frozen=True):
    """The length of the rope along its ``path`` of bends is constant.

    With u_j the direction of straight piece j (from bend j to j+1), l_j its length, n_j = i u_j, and for a drum of
    radius r and side s (+1 left) at the first bend (0) or the last (N)::

        sum u_j.(v_(j+1) - v_j) + s_0 r_0 omega_0 - s_N r_N omega_N = 0
        sum u_j.(a_(j+1) - a_j) + s_0 r_0 epsilon_0 - s_N r_N epsilon_N + sum (n_j.(v_(j+1) - v_j))^2 / l_j = 0

    because piece j turns at the rate ``n_j.(v_(j+1) - v_j) / l_j``; pulleys in between turn freely, and the rope may
    pass a point several times. In a ``parallel`` rope, as in hoists, a piece at a moving block runs ``along`` the way
    of the block and keeps that direction: its length is the distance of its ends in this direction, whatever the radii.
    Parts of a rope that comes back to the drum where it began are a ``belt``, as texts call it. What is ``closing``
    brings a belt back: it is seen, and has no equation, as it says nothing new.
    """

    path: tuple[Bend, ...]
    parallel: bool = False
    belt: bool = False
    closing: bool = False

    @property
    def _drums(self) -> tuple[tuple[Bend, float], ...]:
        """Drums at the ends: the bend and the sign of its rotation in the row."""
        ends = [(self.path[0], 1.0), (self.path[-1], -1.0)] if self.path else []
        return tuple(end for end in ends if end[0].body is not None)

    def shapes(self) -> tuple[Shape, ...]:
        """One scalar row on the moving stations and the drums."""
        if self.closing:
            return ()
        points = tuple(dict.fromkeys(bend.point for bend in self.path if not bend.fixed))
        bodies = tuple(dict.fromkeys(bend.body for bend, _ in self._drums if bend.body is not None))
        return (Shape(points, bodies),)

    def circles(self, at: Placement) -> tuple[JointCircle, ...]:
        """The pulleys and drums (ends of the rope have the radius 0)."""
        return tuple(JointCircle(bend.point, bend.radius, bend.body or "") for bend in self.path)

    def hanging(self) -> tuple[str, ...]:
        """Free ends: loads, or points of bodies that the rope is tied to; all that moves upright on a parallel rope."""
        if self.parallel:
            upright = [b for b in self.path if b.along is not None and bool(np.all(np.abs(np.cos(b.along)) < _UPRIGHT))]
            return tuple(dict.fromkeys(bend.point for bend in upright if not bend.fixed))
        ends = (self.path[0], self.path[-1]) if self.path else ()
        return tuple(end.point for end in ends if end.body is None and not end.fixed)

    def strands(self, at: Placement) -> tuple[Strand, ...]:
        """The pieces at the fixed stations without a body; a parallel rope keeps its directions wherever they are."""
        if self.parallel:
            return ()
        return tuple(
            Strand(bend.point, bend.radius, other.point, ray)
            for ends, (ray, _) in zip(pairwise(self.path), self.pieces(at), strict=True)
            for bend, other in (ends, ends[::-1])
            if bend.fixed and bend.body is None
        )

    def sound(self, at: Placement) -> Flags:
        """No two stations overlap."""
        good: Flags = True
        for (first, second), (_, length) in zip(pairwise(self.path), self.pieces(at), strict=True):
            if self.way(first, second) is not None:
                good = good & (length > 0)
                continue
            gap = np.abs(at.z[second.point] - at.z[first.point])
            lever = np.abs(first.side * first.radius - second.side * second.radius)
            good = good & (gap > lever) & (gap > 0)
        return good

    def intact(self, moved: Placement, start: Placement) -> Flags:
        """No load has come up to its pulley: straight pieces keep their direction and do not shrink to nothing."""
        good = self.sound(moved)
        pieces = zip(pairwise(self.path), self.pieces(start), self.pieces(moved), strict=True)
        for (first, second), (before, then), (after, now) in pieces:
            near = _NEAR * (first.radius + second.radius)
            good = good & (dot(before, after) > 0) & ((now > near) | (now >= then))
        return good

    def resting(self) -> tuple[str, ...]:
        """The fixed stations."""
        return tuple(bend.point for bend in self.path if bend.fixed)

    def mistake(self) -> str:
        """What is wrong with the path, if anything."""
        if len(self.path) < 2:
            return "a rope needs at least two bends: its ends"
        if any(bend.body is not None for bend in self.path[1:-1]):
            return (
                "only the first and the last bend may name a body: split the rope at a wheel that it does not slip on"
            )
        for first, second in pairwise(self.path):
            if first.point == second.point:
                return f"the rope comes to {first.point} twice in a row: name what it passes in between"
        return ""

    def way(self, first: Bend, second: Bend) -> Real | None:
        """The direction (rad) that the piece between two stations keeps; None where its circles decide."""
        if not self.parallel:
            return None
        return first.along if first.along is not None else second.along

    def pieces(self, at: Placement) -> list[tuple[Complex, Real]]:
        """Unit vector and length (m) of each straight piece."""
        sense = at.frame.sense
        found: list[tuple[Complex, Real]] = []
        for first, second in pairwise(self.path):
            way = self.way(first, second)
            if way is not None:
                along = at.frame.direction(way)
                gap = dot(along, at.z[second.point] - at.z[first.point])
                found.append((np.where(gap < 0, -1.0, 1.0) * along, np.abs(gap)))
                continue
            ray, length, _ = thread_direction(
                at.z[first.point],
                first.radius,
                sense * first.side,
                at.z[second.point],
                second.radius,
                sense * second.side,
            )
            found.append((ray, length))
        return found

    def rows(self, at: Placement) -> tuple[ScalarRow, ...]:
        """The velocity row of the class docstring."""
        return () if self.closing else (self.row(at),)

    def row(self, at: Placement) -> ScalarRow:
        """What keeps the length of the rope, whether it is an equation of the scene or follows from others."""
        points: dict[str, Complex] = {}
        turning: dict[str, Real] = {}
        for (first, second), (ray, _) in zip(pairwise(self.path), self.pieces(at), strict=True):
            for bend, sign in ((first, -1.0), (second, 1.0)):
                if not bend.fixed:
                    points[bend.point] = points.get(bend.point, 0.0) + sign * ray
        for bend, sign in self._drums:
            assert bend.body is not None
            lever = sign * at.frame.sense * bend.side * bend.radius
            turning[bend.body] = turning.get(bend.body, 0.0) + lever
        return ScalarRow(points, turning)

    def quadratic(self, at: Placement, speeds: Speeds) -> tuple[Complex, ...]:
        """``sum (n_j.(v_(j+1) - v_j))^2 / l_j``."""
        if self.closing:
            return ()
        total: Real = 0.0
        for (first, second), (ray, length) in zip(pairwise(self.path), self.pieces(at), strict=True):
            ends = [0.0 if bend.fixed else speeds.v[bend.point] for bend in (first, second)]
            swing = 0.0 if self.way(first, second) is not None else dot(1j * ray, ends[1] - ends[0])
            total = total + swing * swing / length
        return (total,)

    def residual(self, moved: Placement, start: Placement, time: Real) -> tuple[Real, ...]:
        """Change of the rope's length (m): straight pieces and wraps.

        A piece that swings by the angle q winds ``s r q`` onto the circle that it ends on and ``s r q`` off the
        circle that it starts from; a drum that turns by p takes up or gives out ``s r p``.
        """
        if self.closing:
            return ()
        before, after = self.pieces(start), self.pieces(moved)
        swung = [
            np.arctan2(cross(then, now), dot(then, now)) for (then, _), (now, _) in zip(before, after, strict=True)
        ]
        change: Real = sum(now - then for (_, then), (_, now) in zip(before, after, strict=True))
        sense = start.frame.sense
        for (first, second), turn in zip(pairwise(self.path), swung, strict=True):
            change = change + sense * (second.side * second.radius - first.side * first.radius) * turn
        for bend, sign in self._drums:
            assert bend.body is not None
            change = change + sign * sense * bend.side * bend.radius * moved.turned[bend.body]
        return (change,)
