"""Figures of the velocities of one body: by its velocity centre with the rays to it, or by equal projections."""

from __future__ import annotations

from collections.abc import Sequence
from functools import partial

from variantgen.errors import InputError, Problem
from variantgen.figure.drawing import BOLD, MEDIUM, THIN, Drawing, Layer
from variantgen.figure.equations.body_board import BodyBoard, FigureSubject, draw_point, draw_vectors, sizes
from variantgen.figure.motion.centre_rays import draw_centre, plane_bodies
from variantgen.figure.motion.motion_board import MotionBoard, named_together
from variantgen.figure.motion.motion_data import motion_data
from variantgen.figure.motion.vectors import Vectors, vectors_of
from variantgen.figure.placement.least_crowded import first_roomy
from variantgen.figure.symbols.rotation import draw_arcs
from variantgen.methods.linkage.instant import Instant
from variantgen.methods.steps.point_vectors import PointVectors
from variantgen.wording.formula import Symbol
from variantgen.wording.solution.quantity_symbols import centre_letters

_LONGEST = 21.0  # length of the longest velocity, u
_SIZES = (1.0, 1.3, 0.8)  # of the vectors, tried until letters find room
_NOTHING = 1e-9  # of the largest velocity or rate
_SQUARE = 2.4  # side of a right-angle mark, u
_LEAST_BODY = 20.0  # a body that would be smaller is drawn larger, and the rays to its centre broken, u
_BROKEN = 17.0  # length of a ray up to its break, and from there to the centre, u
_BEYOND = 48.0  # distance of a centre behind a break from the middle of the body, u


def draw_centre_figure(subject: FigureSubject, vectors: Sequence[PointVectors], body: str, centre: bool) -> Drawing:
    """The figure of the velocities of a body, with its ``centre`` or with equal projections on the body.

    Raises InputError where no point of it moves.
    """
    found = motion_data(subject.variant, subject.motion, subject.index, subject.asked, 1)
    named = vectors_of(subject.variant, subject.motion, subject.index, subject.asked, 1, subject.language, vectors)
    now = found.now
    if body not in now.scene.bodies:
        raise InputError(Problem("the mechanism has no such body", key="view", value=body))
    fastest = max(abs(v) for v in now.v.values())
    points = [name for name in now.scene.bodies[body] if name in named.telling(found.chain.points)]
    moving = [name for name in points if abs(now.v[name]) > _NOTHING * fastest]
    if not moving:
        raise InputError(Problem("no point of the body moves", key="view", value=body))
    make = partial(_Figure, subject, named, now, body, moving)
    return first_roomy(
        partial(make(stretch).by_centre if centre else make(stretch).by_projections) for stretch in _SIZES
    )


class _Figure:
    """The velocities of the ``moving`` points of a body."""

    def __init__(
        self, subject: FigureSubject, named: Vectors, now: Instant, body: str, moving: Sequence[str], stretch: float
    ) -> None:
        self.named, self.now, self.body, self.moving = named, now, body, moving
        lengths, self._lengthened = sizes([abs(now.v[name]) for name in moving], stretch * _LONGEST)
        self._vectors = {
            name: length * now.v[name] / abs(now.v[name]) for name, length in zip(moving, lengths, strict=True)
        }
        self._bodies = BodyBoard(subject, (body, *self._cranks()), moving)
        self._alone = BodyBoard(subject, (body,), moving)

    def _cranks(self) -> list[str]:
        """The bodies on fixed axes that lead points of the body: they say where its velocities are directed."""
        bodies, fixed = self.now.scene.bodies, self.named.task.fixed
        return [
            other
            for other, members in bodies.items()
            if other != self.body and set(members) & set(self.moving) and fixed & set(members)
        ]

    def by_centre(self) -> Drawing:
        """With the centre, the rays to it and the sense of rotation about it."""
        omega = self.now.omega[self.body]
        turns = abs(omega) > _NOTHING * max(abs(rate) for rate in self.now.omega.values())
        if not turns:
            return self._finished(self._board(self._bodies, self._bodies.scale(self._tips)))
        first = self.moving[0]
        centre = self.now.z[first] + 1j * self.now.v[first] / omega
        scale = self._bodies.scale(lambda scale: [*self._tips(scale), scale * centre])
        whole = self._bodies.scale(self._tips)
        size = max((abs(self.now.z[p] - self.now.z[q]) for p in self.moving for q in self.moving), default=0.0)
        if size * scale >= _LEAST_BODY or scale > 0.6 * whole or len(self.moving) < 2:
            board = self._board(self._bodies, scale)
            board.sketch.at["centre"] = scale * centre
            rays = [(board.sketch.at[name], scale * centre) for name in self.moving]
        else:
            board, rays = self._broken(centre)
        for start, end in rays:
            if abs(end - start) > 2 * _SQUARE:
                board.sketch.path((start, end), Layer.GROUND, THIN, dash="dashed")
        for name in self.moving:
            if abs(self.now.z[name] - centre) * board.sketch.scale > 2 * _SQUARE:
                self._mark_right_angle(board, name, centre)
            board.sketch.occupy(name, centre - self.now.z[name])
            if abs(centre - self.now.z[name]) > 0:
                board.sketch.occupy("centre", self.now.z[name] - centre)
        draw_centre(board, board.sketch.at["centre"], self._letter(centre))
        draw_arcs(board, self.body, [(self.named.rate(self.body), omega)], "centre")
        return self._finished(board)

    def _broken(self, centre: complex) -> tuple[MotionBoard, list[tuple[complex, complex]]]:
        """The body with a centre that is far away: rays in their directions with a break."""
        middle = sum(self.now.z[name] for name in self.moving) / len(self.moving)
        ahead = (centre - middle) / abs(centre - middle)
        scale = self._alone.scale(lambda scale: [*self._tips(scale), scale * middle + _BEYOND * ahead])
        board = self._board(self._alone, scale)
        place = board.sketch.at["centre"] = scale * middle + _BEYOND * ahead
        rays = []
        for name in self.moving:
            start = board.sketch.at[name]
            way = (centre - self.now.z[name]) / abs(centre - self.now.z[name])
            for end, foot in ((start + _BROKEN * way, start), (place - _BROKEN * way, place)):
                rays.append((foot, end))
                board.sketch.path((end - (1.0 + 0.8j) * way, end + (1.0 + 0.8j) * way), Layer.MARK, THIN)
        return board, rays

    def by_projections(self) -> Drawing:
        """With the projections of two velocities on the line through their points."""
        board = self._board(self._alone, self._alone.scale(self._tips))
        if len(self.moving) > 1 and not self._lengthened:
            first, second = self.moving[:2]
            way = self.now.z[second] - self.now.z[first]
            way /= abs(way)
            for name in (first, second):
                at, vector = board.sketch.at[name], self._vectors[name]
                part = (vector * way.conjugate()).real * way
                if abs(part) > 3.0 and abs(vector - part) > 1.0:
                    board.sketch.arrow(at, at + part, Layer.SLIDER, MEDIUM, 2.6)
                    board.sketch.path((at + vector, at + part), Layer.GROUND, THIN, dash="dashed")
        return self._finished(board)

    def _tips(self, scale: float) -> list[complex]:
        return [scale * self.now.z[name] + 1.1 * vector for name, vector in self._vectors.items()]

    def _board(self, bodies: BodyBoard, scale: float) -> MotionBoard:
        """The bodies with the velocities."""
        board = bodies.drawn(scale)
        for name, vector in self._vectors.items():
            draw_point(board, name)
            symbol, _ = self.named.own(name)
            (formula, _), *_ = named_together([(symbol, vector)], 1.0)
            draw_vectors(board, board.sketch.at[name], [(formula, vector, BOLD)], [])
            board.sketch.occupy(name, vector)
        board.sketch.lengthened = self._lengthened
        return board

    def _mark_right_angle(self, board: MotionBoard, name: str, centre: complex) -> None:
        start, ahead = board.sketch.at[name], self._vectors[name] / abs(self._vectors[name])
        side = (centre - self.now.z[name]) / abs(centre - self.now.z[name])
        corner = (start + _SQUARE * side, start + _SQUARE * (side + ahead), start + _SQUARE * ahead)
        board.sketch.path(corner, Layer.LINK, THIN)

    def _letter(self, centre: complex) -> Symbol:
        """The letter of the centre as the solution has it."""
        form, size = self.named.task.form, self.named.task.size * self.named.task.length_unit
        names = {body: form.symbols.get(body, body) for body in plane_bodies(self.now)}
        places = []
        for body in names:
            first, omega = self.now.scene.bodies[body][0], self.now.omega[body]
            places += [self.now.z[first] + 1j * self.now.v[first] / omega] if omega else []
        shown = self._bodies.named
        others = [p for p in shown if all(abs(self.now.z[p] - place) > 1e-6 * size for place in places)]
        return centre_letters(names, others).get(self.body, Symbol("P"))

    @staticmethod
    def _finished(board: MotionBoard) -> Drawing:
        return board.sketch.finish({name: board.sketch.at[name] for name in board.shown})
