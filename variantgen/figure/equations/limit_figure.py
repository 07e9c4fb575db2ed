"""The limit positions of a slider or a rocker that a rod drives from the pin of a crank, beside the position shown."""

from __future__ import annotations

import math
from collections.abc import Sequence
from functools import partial

from variantgen.errors import InputError, Problem
from variantgen.figure.drawing import THIN, Layer
from variantgen.figure.equations.body_board import FigureSubject
from variantgen.figure.making import Making
from variantgen.figure.motion.contact_letters import draw_dot
from variantgen.figure.motion.motion_board import MotionBoard, draw_on_mechanism
from variantgen.mechanism.rows import Placement
from variantgen.wording.formula import Symbol
from variantgen.wording.formula.tree import Index


def draw_limits(subject: FigureSubject, points: Sequence[str]) -> Making:
    """The mechanism with both limit positions dashed; ``points`` are pivot, crank pin and end of the rod, or also the
    centre about which this end swings. Raises InputError where there are no such positions.
    """
    known = subject.mechanism.places
    if len(points) not in (3, 4) or not all(point in known for point in points):
        raise _no_limits("the solution has no limit positions")
    annotate = partial(_annotate, tuple(points))
    return draw_on_mechanism(subject.mechanism, annotate)


def _annotate(points: tuple[str, ...], board: MotionBoard, stretch: float) -> None:
    pivot, pin, end, *centres = (board.sketch.at[point] for point in points)
    guides = board.linkage.guides(Placement(board.sketch.at, board.frame))
    if centres:
        limit_at = partial(_on_circle, pivot, centres[0], end)
    elif points[2] in guides:
        limit_at = partial(_on_line, pivot, guides[points[2]], end)
    else:
        raise _no_limits("the solution has no limit positions")
    crank, rod = abs(pin - pivot), abs(end - pin)
    for number, (distance, side) in enumerate(((rod + crank, 1.0), (rod - crank, -1.0)), start=1):
        limit = limit_at(distance)
        top = pivot + side * crank * (limit - pivot) / distance
        # The rod over its crank lies on it: its whole length is seen from the pin on.
        corners = [top if side < 0 else pivot, limit, *centres]
        board.sketch.path(corners, Layer.GROUND, THIN, dash="dashed")
        for place, name in ((limit, points[2]), (top, points[1])):
            draw_dot(board, place, _numbered(board.symbol(name), number))


def _numbered(letter: Symbol, number: int) -> Symbol:
    """The letter of a point with the number of the position."""
    return letter._replace(index=(*letter.index, Index(str(number))))


def _on_line(pivot: complex, way: complex, end: complex, distance: float) -> complex:
    """The place on the guide of a slider at a distance from the pivot, on the side on which the slider is."""
    foot = end + ((pivot - end) * way.conjugate()).real * way
    along = _leg(distance, abs(pivot - foot))
    return foot + math.copysign(along, ((end - foot) * way.conjugate()).real) * way


def _on_circle(pivot: complex, centre: complex, end: complex, distance: float) -> complex:
    """The place on the circle of a rocker at a distance from the pivot, on the side on which the rocker is."""
    base, arm = centre - pivot, abs(end - centre)
    along = (distance**2 + abs(base) ** 2 - arm**2) / (2 * abs(base))
    aside = math.copysign(_leg(distance, along), ((end - pivot) * base.conjugate()).imag)
    return pivot + complex(along, aside) * base / abs(base)


def _leg(hypotenuse: float, other: float) -> float:
    """A leg of a right triangle. Raises InputError where there is none."""
    square = hypotenuse**2 - other**2
    if square <= 0:
        raise _no_limits("the crank does not make a whole turn")
    return math.sqrt(square)


def _no_limits(why: str) -> InputError:
    return InputError(Problem(why, key="view", value="limit_positions"))
