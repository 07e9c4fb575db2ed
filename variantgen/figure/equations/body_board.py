"""The board of a figure of one step: the bodies concerned, enlarged, with stubs of what is joined to them."""

from __future__ import annotations

from collections.abc import Callable, Iterable, Mapping, Sequence
from dataclasses import dataclass, fields

import numpy as np

from variantgen.families.quantities import Quantity
from variantgen.figure.build import mechanism
from variantgen.figure.contact_letters import draw_dot
from variantgen.figure.drawing import THIN, Layer, Line
from variantgen.figure.equations.surroundings import Surroundings, largest
from variantgen.figure.ink import segments_of
from variantgen.figure.label_requests import along_arrow, around
from variantgen.figure.motion_board import LEAST, MotionBoard
from variantgen.figure.sketch import Sketch
from variantgen.mechanism.motion import Motion
from variantgen.variants.variant import Variant
from variantgen.wording.formula import Formula, Symbol
from variantgen.wording.language import Language

WIDE, HIGH = 92.0, 60.0  # room for a figure but for its labels, u
_BODY_WIDE, _BODY_HIGH = 60.0, 44.0  # room for the bodies, u
_LANE = 2.3  # between arrows that would lie on each other, u
_LANES = (0.0, 1.0, -1.0, 2.0, -2.0, 3.0)
_AXIS = 11.0  # length of an axis, u
_SAMPLES = np.linspace(0.0, 1.0, 12)


@dataclass(frozen=True)
class Subject:
    """A variant of a solved batch and what is asked of it, for figures in a language."""

    variant: Variant
    motion: Motion
    index: int
    asked: Sequence[Quantity]
    language: Language

    def board(self, marks: bool, scale: float | None = None, poses: Mapping[str, float] | None = None) -> MotionBoard:
        """The mechanism, with the data of the statement (``marks``) or without."""
        plain = mechanism(
            self.variant, self.motion, self.index, self.asked, self.language, marks, scale=scale, poses=poses
        )
        return MotionBoard(**{spec.name: getattr(plain, spec.name) for spec in fields(plain)})


class BodyBoard:
    """Draws some ``bodies`` of a mechanism and the ``points`` to which the figure speaks, as large as there is room."""

    def __init__(self, subject: Subject, bodies: Iterable[str], points: Iterable[str]) -> None:
        self.subject = subject
        self._statement = subject.board(marks=True)
        self._bodies = tuple(bodies)
        points = tuple(points)
        self.named = self._statement.shown
        shown = {*self.named, *points}
        members = [self._statement.scene.bodies[body] for body in self._bodies]
        self.points = tuple(dict.fromkeys([*points, *(name for member in members for name in member if name in shown)]))

    def place(self, point: str) -> complex:
        """The place of a point (m)."""
        return complex(self.subject.motion.z[point][self.subject.index])

    def scale(self, spread: Callable[[float], Sequence[complex]] = lambda scale: (), size: float = 1.0) -> float:
        """The largest scale (u per metre) at which the bodies have room with what is ``spread`` at a scale."""
        bodies = self._surroundings(self._statement).extent()
        known = self._statement.sketch.scale
        most = known * min(largest(bodies, size * _BODY_WIDE, size * _BODY_HIGH), 1e3)
        if not np.isfinite(most) or most >= 999 * known:
            most = known
        low, high = 0.05 * most, most
        for _ in range(14):
            middle = 0.5 * (low + high) if low < 0.999 * high else high
            extent = [place * middle / known for place in bodies]
            if largest([*extent, *spread(middle)], WIDE, HIGH) >= 1.0:
                low = middle
            else:
                high = middle
        extent = [place * most / known for place in bodies]
        return most if largest([*extent, *spread(most)], WIDE, HIGH) >= 1.0 else low

    def drawn(self, scale: float) -> MotionBoard:
        """The board at a scale with the bodies on it."""
        board = self.subject.board(False, scale, self._statement.poses)
        kept = self._surroundings(board)
        whole = board.sketch
        board.sketch = Sketch(whole.at, whole.scale, busy=whole.busy, symbol_radius=whole.symbol_radius)
        for line in whole.lines:
            for piece in kept.pieces(line):
                board.sketch.add(piece)
        for request in whole.requests:
            if kept.names(request.own):
                board.sketch.label(request)
        board.shown = tuple(name for name in board.shown if name in self.points)
        return board

    def _surroundings(self, board: MotionBoard) -> Surroundings:
        at, discs = board.sketch.at, board.form.figure.discs
        members = [tuple(at[p] for p in board.scene.bodies[b] if p in self.points) for b in self._bodies]
        own = {d.body for d in discs if d.body in self._bodies or d.centre == self.points[0]}
        rims = [(at[d.centre], r) for d in discs if d.body in own for r in board.discs.get(d.body, ())]
        points = [at[name] for name in self.points if name in at]
        return Surroundings(tuple(points), tuple(members), tuple(rims))


def draw_point(board: MotionBoard, point: str) -> None:
    """A dot and its letter for a point that the mechanism is not drawn with."""
    if point not in board.shown:
        draw_dot(board, board.sketch.at[point], point)
        board.shown = (*board.shown, point)


def draw_vectors(
    board: MotionBoard, place: complex, named: Sequence[tuple[Formula, complex, float]], others: list[complex]
) -> list[tuple[complex, complex]]:
    """Arrows (name, vector in u, weight) from one place; those that would lie on each other side by side.

    ``others`` are the places of arrows drawn before; where these arrows are is added to them. Returns their starts and
    tips.
    """
    found: list[tuple[complex, complex]] = []
    for name, vector, weight in sorted(named, key=lambda item: -abs(item[1])):
        start = place + _lane(place, vector, others)
        board.sketch.arrow(start, start + vector, Layer.SLIDER, weight)
        board.sketch.label(along_arrow(name, start, start + vector))
        others += (start + vector * (0.25 + 0.75 * _SAMPLES)).tolist()
        found.append((start, start + vector))
    return found


def _lane(place: complex, vector: complex, others: Sequence[complex]) -> complex:
    """The least shift across a vector with which it does not lie on the arrows drawn before."""
    if not others:
        return 0j
    side = 1j * vector / abs(vector)
    known = np.array(others)
    best = (-1.0, 0j)
    for lane in _LANES:
        shift = lane * _LANE * side
        tips = place + shift + vector * np.array([0.5, 0.75, 1.0])
        free = float(np.min(np.abs(known[:, None] - tips)))
        if free > 0.8 * _LANE:
            return shift
        best = max(best, (free, shift), key=lambda item: item[0])
    return best[1]


def sizes(lengths: Sequence[float], longest: float, true_scale: bool) -> tuple[list[float], bool]:
    """Lengths (u) at which vectors of the given magnitudes are drawn, and whether any is lengthened to be seen."""
    scale = longest / max(lengths)
    found = [scale * length for length in lengths]
    if true_scale:
        return found, False
    return [max(length, LEAST) for length in found], min(found) < LEAST


def draw_axes(board: MotionBoard, place: complex, axes: Sequence[tuple[complex, str]], longest: float) -> None:
    """Thin arrows from one place beside a point, clear of its vectors, with their letters."""
    if not axes:
        return
    drawn = np.array([p for path in board.sketch.lines for s in _ends(path) for p in s], dtype=complex)
    ways = np.exp(1j * np.radians(np.arange(0, 360, 15)))
    best = (-1.0, place)
    for radius in (0.55 * longest, 0.8 * longest, 1.05 * longest):
        for way in ways.tolist():
            origin = place + radius * way
            arms = np.concatenate([origin + _SAMPLES * (_AXIS + 3.0) * axis for axis, _ in axes])
            free = float(np.min(np.abs(arms[:, None] - drawn))) - 0.05 * radius
            best = max(best, (min(free, 5.0) - 0.03 * radius, origin), key=lambda item: item[0])
    origin = best[1]
    for axis, letter in axes:
        board.sketch.arrow(origin, origin + _AXIS * axis, Layer.MARK, THIN, 1.8)
        if letter:
            board.sketch.label(around(Symbol(letter), origin + _AXIS * axis, 0.3))


def _ends(line: Line) -> Iterable[tuple[complex, complex]]:
    """Pieces of a line, short enough to stand for all its places."""
    for start, end in segments_of(line, 0.5):
        count = max(1, int(abs(end - start) / 3.0))
        for i in range(count):
            yield start + (end - start) * i / count, start + (end - start) * (i + 1) / count
