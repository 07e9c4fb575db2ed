"""The mechanism as the base of figures of its motion: vectors of points to one scale, arcs of true rotation."""

from __future__ import annotations

import math
from collections.abc import Callable, Sequence
from functools import partial

import numpy as np
from msgspec.structs import asdict

from variantgen.figure.board import Board
from variantgen.figure.build import Mechanism
from variantgen.figure.drawing import BOLD, Layer
from variantgen.figure.making import Making, Unlettered
from variantgen.figure.motion.plans import EQUAL
from variantgen.figure.placement.label_requests import along_arrow
from variantgen.figure.placement.least_crowded import first_roomy
from variantgen.wording.formula import Equation, Formula, Symbol

LONGEST = 17.0  # length of the longest vector of a figure, u
LONGEST_OF_MANY = 27.0  # the same where many vectors start at one point
LEAST = 9.7  # vectors shorter than this are drawn with this length, 8 mm on paper, so that they are seen, u
NOTHING = 0.02  # vectors shorter than this are none, u
HEAD = 2.6  # length of the head of an arrow, u
_MOST = 92.0  # width and height of a figure but for its labels, u
_LEAST_SIZE = 0.3  # of the mechanism in proportion to that of the statement
_TRIES = 6
# Sizes of vectors and mechanism, in proportion to the usual ones, that are tried until letters find room.
_SIZES = ((1.0, 1.0), (1.35, 1.2), (0.8, 1.0))
_ASIDE = (0.0, 2.2, 3.4, 4.8)  # how far an arrow is moved off a line on which it would lie, u
_HALF_LANE = 0.35  # half the width of the paper that an arrow takes, u
_SAMPLES = np.linspace(0.3, 1.0, 15)
_COVERED = 0.3  # part of an arrow that may lie on other lines


class MotionBoard(Board):
    """A board on which the motion of all points and bodies is shown, not only what is given.

    Vectors shorter than ``least`` (u) are drawn with this length.
    """

    least: float = LEAST

    def centre_of_rotation(self, body: str) -> str:
        """The pivot, or the middle of a bar or plate without a fixed point."""
        members = self.scene.bodies[body]
        if self.fixed & set(members) or not any(body == bar for bar, *_ in self.form.bars):
            return super().centre_of_rotation(body)
        key, (start, end) = f"middle of {body}", (self.sketch.at[name] for name in members[:2])
        self.sketch.at[key] = 0.5 * (start + end)
        for way in (end - start, start - end):
            self.sketch.occupy(key, way)
        return key

    def vector(self, point: str, vector: complex, name: Formula, weight: float = BOLD) -> bool:
        """Add an arrow (``vector`` in u) from a point; moved aside where it would lie on other lines.

        Returns whether it starts at the point itself. Nothing is drawn of a vector that is next to none.
        """
        if abs(vector) < NOTHING:
            return False
        if abs(vector) < self.least:
            vector *= self.least / abs(vector)
            self.sketch.lengthened = True
        start = self.sketch.at[point] + self._aside(self.sketch.at[point], vector)
        # Below the hinges: the arrow comes out of the circle.
        self.sketch.arrow(start, start + vector, Layer.SLIDER, weight, head_of(vector))
        self.sketch.label(along_arrow(name, start, start + vector))
        self.sketch.occupy(point, vector)
        return abs(start - self.sketch.at[point]) < 1e-9

    def _aside(self, start: complex, vector: complex) -> complex:
        """The least shift across the vector with which it does not lie on what is drawn already."""
        way = vector / abs(vector)
        best = (math.inf, 0j)
        for step in _ASIDE:
            for side in (1j, -1j) if step else (1j,):
                lane = start + step * side * way + _SAMPLES * vector
                covered = np.count_nonzero(self.sketch.crossings(lane, (_HALF_LANE, _HALF_LANE))) / _SAMPLES.size
                if covered <= _COVERED:
                    return step * side * way
                if covered < best[0]:
                    best = (covered, step * side * way)
        return best[1]


def draw_on_mechanism(
    mechanism: Mechanism,
    annotate: Callable[[MotionBoard, float], None],
    true_scale: bool = False,
) -> Making:
    """The mechanism without data, with what ``annotate`` adds, of a size with which everything finds room.

    ``annotate`` gets the board and the size of its vectors (in proportion to the usual one), which is varied until all
    letters find room. With ``true_scale`` no vector is lengthened to be seen.
    """
    poses, least = mechanism.board().poses, 0.0 if true_scale else LEAST

    def drawn(stretch: float, size: float) -> Unlettered:
        """The figure with vectors of one size on a mechanism of at most one size."""
        return _fitted(partial(mechanism.board, marks=False, poses=poses), annotate, stretch, size, least)

    return first_roomy(drawn(*sizes) for sizes in _SIZES)


def _fitted(
    base: Callable[..., Board],
    annotate: Callable[[MotionBoard, float], None],
    stretch: float,
    size: float,
    least: float,
) -> Unlettered:
    """The figure on a mechanism of the size with which everything is on the paper."""
    for _ in range(_TRIES):
        plain = base(size=size)
        board = MotionBoard(**asdict(plain))
        board.least = least
        annotate(board, stretch)
        low, high = board.sketch.corners()
        excess = max((high - low).real, (high - low).imag) / _MOST
        if excess <= 1 or size <= _LEAST_SIZE:
            break
        size = max(_LEAST_SIZE, 0.96 * size / excess)
    return board.draft()


def head_of(vector: complex) -> float:
    """The length of the head of an arrow (u): never more than half of it."""
    return min(HEAD, 0.5 * abs(vector))


def scale_of(vectors: Sequence[complex], length: float = LONGEST) -> float:
    """Figure units per m/s or m/s^2, so that the longest vector has the given length (u)."""
    longest = max((abs(vector) for vector in vectors), default=0.0)
    return length / longest if longest and math.isfinite(longest) else 0.0


def named_together(named: Sequence[tuple[Symbol, complex]], scale: float) -> list[tuple[Formula, complex]]:
    """Vectors of one point; those that are equal are one arrow with both names, what is next to none is left out."""
    found: list[tuple[Formula, complex]] = []
    for symbol, vector in named:
        if scale * abs(vector) < NOTHING:
            continue
        same = next((i for i, (_, other) in enumerate(found) if abs(other - vector) < EQUAL * abs(vector)), None)
        if same is None:
            found.append((symbol, vector))
        elif isinstance(first := found[same][0], Symbol):
            found[same] = (Equation(first, symbol), vector)
    return found
