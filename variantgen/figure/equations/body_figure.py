"""Figures of the motion of one body: its vectors with its velocity or acceleration centre, by equal projections, alone.

The kinds: ``centre`` (velocities and P, or accelerations and Q with the angle mu to each ray), ``projections``
(velocities with their components on the line of two points), ``contacts`` (velocities of the centre of a wheel and of
the points at which it touches others), ``points`` (no more than the vectors).
"""

from __future__ import annotations

import cmath
import math
from collections.abc import Callable, Iterator, Sequence
from functools import partial

from variantgen.algebra.name import Name
from variantgen.errors import InputError, Problem
from variantgen.figure.drawing import BOLD, MEDIUM, THIN, Arc, Layer
from variantgen.figure.equations.body_board import (
    BodyBoard,
    FigureSubject,
    draw_point,
    draw_vectors,
    sizes,
    with_room,
)
from variantgen.figure.equations.marked_geometry import MOST_ANGLES, draw_geometry
from variantgen.figure.equations.surroundings import STUB
from variantgen.figure.making import Making, Unlettered
from variantgen.figure.motion.centre_rays import draw_centre, plane_bodies
from variantgen.figure.motion.contact_letters import ContactPoint, draw_dot, touching_points
from variantgen.figure.motion.motion_board import HEAD, MotionBoard
from variantgen.figure.motion.motion_data import motion_data
from variantgen.figure.motion.vectors import Vectors, vectors_of
from variantgen.figure.placement.label_requests import along_arc
from variantgen.figure.symbols.rotation import draw_arcs
from variantgen.methods.linkage.instant import Instant
from variantgen.methods.steps.point_vectors import PointVectors
from variantgen.wording.formula import Formula, Symbol
from variantgen.wording.solution.quantity_symbols import centre_letters

_LONGEST = 46.0  # length of the longest vector, u
_SIZES = (1.0, 1.3, 0.8)  # of the vectors, tried until letters find room
_MOST_MARKED = (MOST_ANGLES, 2, 0)  # of the angles, at the usual size
_NOTHING = 1e-9  # of the largest vector or rate
_SQUARE = 2.4  # side of a right-angle mark, u
_LEAST_BODY = 20.0  # a body that would be smaller is drawn without its cranks, u
_WHOLE_CRANK = STUB + 2.0  # but for shorter ones, of which the stub would show the axis, u
_ROUND = (8.0, -8.0, 8.0j, -8.0j)  # room for the arc about a centre, u
_MU_ARC = 6.5  # radius of the arc between an acceleration and the ray to Q, u
_MANY_RAYS = 4


def draw_body_figure(
    subject: FigureSubject, vectors: Sequence[PointVectors], body: str, kind: str, order: int = 1
) -> Making:
    """The figure of the velocities (``order`` 1) or accelerations (2) of a body, of a ``kind``.

    Raises InputError where there is no such body, or no point of it has a vector.
    """
    found = motion_data(subject.mechanism, order, points_move=False)
    named, now = vectors_of(subject.mechanism, order, vectors), found.now
    if body not in now.scene.bodies:
        raise InputError(Problem("the mechanism has no such body", key="view", value=body))
    own = now.v if order == 1 else now.a
    largest = max(abs(vector) for vector in own.values())
    shown = named.telling(found.chain.points)
    telling = [name for name in now.scene.bodies[body] if name in shown]
    moving = {name: own[name] for name in telling if abs(own[name]) > _NOTHING * largest}
    touching = {}
    if order == 1 and kind in ("centre", "contacts"):
        touching = touching_points(named.task, now, subject.mechanism.shown, body, resting=kind == "contacts")
    if kind == "contacts":
        moving = {name: vector for name, vector in moving.items() if name in {c.centre for c in touching.values()}}
    if not moving and not any(contact.velocity for contact in touching.values()):
        raise InputError(Problem("no point of the body moves", key="view", value=body))
    make = partial(BodyFigure, subject, named, now, body, order, moving, touching)
    return with_room(lambda room: _tries(partial(make, room), kind))


def _tries(make: Callable[[float], BodyFigure], kind: str) -> Iterator[Unlettered]:
    """The figure with vectors of several sizes; marks of angles go where there is room for them."""
    for stretch in _SIZES:
        figure = make(stretch)
        kinds: dict[str, Callable[[], MotionBoard]] = {
            "centre": figure.by_centre,
            "projections": figure.by_projections,
            "contacts": partial(figure.by_vectors, figure.alone),
            "points": partial(figure.by_vectors, figure.bodies if figure.order == 1 else figure.alone),
        }
        base = kinds[kind]()
        marked = MOST_ANGLES + 1
        for most in _MOST_MARKED if stretch == _SIZES[0] else (0,):
            if most < marked:  # else there is nothing to leave out
                draft, marked = figure.completed(base.copied() if most else base, kind, most)
                yield draft


class BodyFigure:
    """The vectors of the ``moving`` points of a body and of the points at which it is ``touching`` others."""

    def __init__(
        self,
        subject: FigureSubject,
        named: Vectors,
        now: Instant,
        body: str,
        order: int,
        moving: dict[str, complex],
        touching: dict[str, ContactPoint],
        room: complex,
        stretch: float,
    ) -> None:
        self.subject, self.named, self.now, self.body, self.order = subject, named, now, body, order
        self.moving = list(moving)
        self._touching = touching
        self._shown = {**moving, **{name: contact.velocity for name, contact in touching.items() if contact.velocity}}
        self._places = {**{name: now.z[name] for name in moving}, **{n: c.place for n, c in touching.items()}}
        self._longest = stretch * _LONGEST
        further = [contact.place for contact in touching.values()]
        # The wheel itself, where only points of its rim are at rest or move.
        points = self.moving or list(now.scene.bodies[body][:1])
        self._room = room
        self.bodies = BodyBoard(subject, (body, *self._cranks()), points, further, room=room)
        self.alone = BodyBoard(subject, (body,), points, further, room=room)

    def _cranks(self) -> list[str]:
        """The bodies on fixed axes that lead points of the body: they say where its velocities are directed."""
        bodies, fixed = self.now.scene.bodies, self.named.task.fixed
        return [
            other
            for other, members in bodies.items()
            if other != self.body and set(members) & set(self.moving) and fixed & set(members)
        ]

    def _reach(self, crank: str) -> float:
        """How far the axis of a crank is from the point of the body that it leads (m)."""
        members = self.now.scene.bodies[crank]
        fixed = self.named.task.fixed
        return min(
            abs(self.now.z[p] - self.now.z[q]) for p in members if p in self.moving for q in fixed & set(members)
        )

    def by_centre(self) -> MotionBoard:
        """With the centre and the rays to it."""
        centre = self._centre()
        if centre is None:
            return self.by_vectors(self.bodies)

        def spread(longest: float) -> list[tuple[complex, complex]]:
            return [*self._tips(longest), *((centre, way) for way in _ROUND)]

        scale, longest = self.bodies.fitted(spread, self._longest)
        size = max((abs(self.now.z[p] - self.now.z[q]) for p in self.moving for q in self.moving), default=0.0)
        small = size > 0 and size * scale < _LEAST_BODY
        needed = self.order == 1 and (not small or self.subject.geometry.feet)
        bodies = self.bodies if needed else self.alone
        if not needed:
            scale, longest = bodies.fitted(spread, self._longest)
            if short := [crank for crank in self._cranks() if self._reach(crank) * scale < _WHOLE_CRANK]:
                # It would be a hinge without a letter.
                bodies = BodyBoard(self.subject, (self.body, *short), self.moving, room=self._room)
                scale, longest = bodies.fitted(spread, self._longest)
        board = self._board(bodies, scale, longest)
        board.sketch.at["centre"] = scale * centre
        rays = [(board.sketch.at[name], scale * centre) for name in self.moving[:_MANY_RAYS]]
        for start, end in rays:
            if abs(end - start) > 2 * _SQUARE:
                # Above the shade of a plate.
                board.sketch.path((start, end), Layer.SLIDER, THIN, dash="dashed")
        for name in self.moving:
            if abs(self.now.z[name] - centre) * board.sketch.scale > 2 * _SQUARE:
                if self.order == 1:
                    self._mark_right_angle(board, name, centre)
                else:
                    self._mark_mu(board, name, centre)
            board.sketch.occupy(name, centre - self.now.z[name])
            if abs(centre - self.now.z[name]) > 0:
                board.sketch.occupy("centre", self.now.z[name] - centre)
        draw_centre(board, board.sketch.at["centre"], self._letter(centre))
        return board

    def by_projections(self) -> MotionBoard:
        """With the projections of two velocities on the line through their points."""
        board = self.by_vectors(self.alone)
        if len(self.moving) > 1 and not self._lengthened:
            first, second = self.moving[:2]
            way = self.now.z[second] - self.now.z[first]
            way /= abs(way)
            for name in (first, second):
                at, vector = board.sketch.at[name], self._vectors[name]
                part = (vector * way.conjugate()).real * way
                if abs(part) > 2 * HEAD and abs(vector - part) > 1.0:
                    board.sketch.arrow(at, at + part, Layer.SLIDER, MEDIUM, HEAD)
                    board.sketch.path((at + vector, at + part), Layer.GROUND, THIN, dash="dashed")
        return board

    def by_vectors(self, bodies: BodyBoard) -> MotionBoard:
        """With the vectors (and points of contact) alone."""
        return self._board(bodies, *bodies.fitted(self._tips, self._longest))

    def completed(self, board: MotionBoard, kind: str, most: int) -> tuple[Unlettered, int]:
        """The figure with at most so many angles, and how many it has; the sense of the rate goes where room is left.

        A body that does not turn, and so has no centre, has nothing marked in its figure with the centre.
        """
        centre, marked = "centre" in board.sketch.at, 0
        if centre or kind != "centre":
            # The angles mu are enough beside an acceleration centre.
            most = 0 if self.order == 2 and centre else most
            marked = draw_geometry(board, self.subject, self.named.symbols, most, self.body)
        if centre or (kind == "contacts" and self._rate()):
            turns = [(self.named.rate(self.body), self._rate())]
            draw_arcs(board, self.body, turns, "centre" if centre else "")
        return board.draft(), marked

    def _rate(self) -> float:
        rates = self.now.omega if self.order == 1 else self.now.epsilon
        return rates[self.body]

    def _centre(self) -> complex | None:
        """The velocity or acceleration centre (m); None where the body does not turn."""
        omega, first = self.now.omega[self.body], self.moving[0]
        if self.order == 2:
            below = omega**2 - 1j * self.now.epsilon[self.body]
            return self.now.z[first] + self.now.a[first] / below if below else None
        if abs(omega) <= _NOTHING * max(abs(rate) for rate in self.now.omega.values()):
            return None
        return self.now.z[first] + 1j * self.now.v[first] / omega

    def _drawn(self, longest: float) -> tuple[dict[str, complex], bool]:
        """The vectors as they are drawn (u), and whether any is lengthened to be seen."""
        lengths, lengthened = sizes([abs(vector) for vector in self._shown.values()], longest, self.subject.least)
        drawn = zip(self._shown.items(), lengths, strict=True)
        return {name: length * vector / abs(vector) for (name, vector), length in drawn}, lengthened

    def _tips(self, longest: float) -> list[tuple[complex, complex]]:
        """The places of points (m) and how far beyond their vectors reach (u)."""
        return [(self._places[name], 1.1 * vector) for name, vector in self._drawn(longest)[0].items()]

    def _board(self, bodies: BodyBoard, scale: float, longest: float) -> MotionBoard:
        """The bodies with the vectors, of which the longest has this length (u)."""
        self._vectors, self._lengthened = self._drawn(longest)
        board = bodies.drawn(scale)
        for name, contact in self._touching.items():
            if name not in board.shown:
                board.sketch.at[name] = scale * contact.place
                letter = self._letter(contact.place) if contact.rests else name
                draw_dot(board, board.sketch.at[name], letter)
        for name, vector in self._vectors.items():
            if name not in self._touching:
                draw_point(board, name)
            draw_vectors(board, board.sketch.at[name], [(self._symbol(name), vector, BOLD)], [])
            board.sketch.occupy(name, vector)
        board.sketch.lengthened = self._lengthened
        return board

    def _symbol(self, name: str) -> Formula:
        if name in self._touching:
            return self.named.symbols.letter(Name("v", name))
        return self.named.own(name)[0]

    def _mark_right_angle(self, board: MotionBoard, name: str, centre: complex) -> None:
        start, ahead = board.sketch.at[name], self._vectors[name] / abs(self._vectors[name])
        side = (centre - self.now.z[name]) / abs(centre - self.now.z[name])
        corner = (start + _SQUARE * side, start + _SQUARE * (side + ahead), start + _SQUARE * ahead)
        board.sketch.path(corner, Layer.LINK, THIN)

    def _mark_mu(self, board: MotionBoard, name: str, centre: complex) -> None:
        """The angle between an acceleration and the ray to the acceleration centre."""
        vector = self._vectors[name]
        sweep = cmath.phase((centre - self.now.z[name]) / vector)
        if abs(sweep) < math.radians(3):
            return
        start, at = cmath.phase(vector), board.sketch.at[name]
        board.sketch.arc(Arc(at, _MU_ARC, Layer.MARK, THIN, start, sweep))
        letter = self.named.symbols.letter(Name("mu", self.body))
        board.sketch.label(along_arc(letter, at, _MU_ARC, start, sweep, inner=True))

    def _letter(self, centre: complex) -> Symbol:
        """The letter of the centre as the solution has it."""
        form, size = self.named.task.form, self.named.task.size * self.named.task.length_unit
        names = {body: form.symbols.get(body, body) for body in plane_bodies(self.now)}
        if self.order == 2:
            return Symbol("Q", centre_letters(names, ()).get(self.body, Symbol("P")).index)
        others = [p for p in self.bodies.named if all(abs(self.now.z[p] - q) > 1e-6 * size for q in self._all(names))]
        return centre_letters(names, others).get(self.body, Symbol("P"))

    def _all(self, bodies: dict[str, str]) -> Iterator[complex]:
        """The velocity centres of bodies."""
        for body in bodies:
            first, omega = self.now.scene.bodies[body][0], self.now.omega[body]
            if omega:
                yield self.now.z[first] + 1j * self.now.v[first] / omega
