"""The figure of a vector equation: the body concerned, and at the point the vectors of the equation and its axes."""

from __future__ import annotations

import math
from collections.abc import Iterator, Sequence

from variantgen.errors import InputError, Problem
from variantgen.figure.drawing import BOLD, MEDIUM, THIN, Layer
from variantgen.figure.equations.body_board import (
    BodyBoard,
    FigureSubject,
    draw_axes,
    draw_point,
    draw_vectors,
    sizes,
    with_room,
)
from variantgen.figure.equations.marked_geometry import MOST_ANGLES, draw_geometry
from variantgen.figure.equations.surroundings import largest
from variantgen.figure.making import Making, Unlettered
from variantgen.figure.motion.motion_board import MotionBoard, named_together
from variantgen.figure.motion.vectors import Vectors, vectors_of
from variantgen.methods.steps.point_vectors import Arrow, PointEquation, PointVectors
from variantgen.wording.formula import Formula, to_plain

LONGEST = 56.0  # length of the longest vector, u
_COLUMN = 104.0  # u: in a column a wider figure has too short vectors, so it is drawn without marks of angles
_NOTHING = 1e-9  # of the longest vector: there is none
# Lengths of vectors and size of the bodies, in proportion to the usual ones, tried until letters find room.
_SIZES = ((1.0, 1.0), (1.25, 1.0), (1.0, 0.75), (1.4, 0.7), (0.8, 1.0), (1.1, 0.9), (1.3, 0.8))
_SHARE, _BESIDE_RODS = 0.75, 0.42  # of the room for a figure that its vectors have; rods do not become short
_STRAIGHT = math.sin(math.radians(6))  # two vectors with a smaller angle make no parallelogram


def equation_figure(subject: FigureSubject, named: Vectors, equation: PointEquation) -> Making:
    """The figure. Raises InputError where all vectors are zero."""
    arrows = _arrows(equation)
    longest = max((abs(arrow.vector) for arrow in arrows), default=0.0)
    shown = [arrow for arrow in arrows if abs(arrow.vector) > _NOTHING * longest]
    if not shown:
        raise InputError(Problem("all vectors of the equation are zero", key="view", value=equation.point))
    known = subject.mechanism.places
    met = [name for arrow in shown for name in (arrow.name.of, arrow.name.about) if name in known]
    others = [name for name in dict.fromkeys(met) if _is_on(subject, equation, name)]
    ends = [end for rod in equation.rods for end in rod]
    points = dict.fromkeys((equation.point, *others, *ends))

    def tries(room: complex) -> Iterator[Unlettered]:
        bodies = BodyBoard(subject, equation.bodies, points, rods=equation.rods, room=room)
        return _tries(bodies, named, equation, shown)

    return with_room(tries)


def draw_equation(subject: FigureSubject, order: int, vectors: Sequence[PointVectors], which: str) -> Making:
    """The figure of the equation of an order with the number ``which`` (none: the first); InputError without one."""
    named = vectors_of(subject.mechanism, order, vectors)
    equations = named.found.equations
    number = int(which or 1)
    if not 1 <= number <= len(equations):
        raise InputError(Problem("the solution has no such vector equation", key="view", value=which or "1"))
    return equation_figure(subject, named, equations[number - 1])


def _is_on(subject: FigureSubject, equation: PointEquation, name: str) -> bool:
    """Whether a point belongs to one of the bodies of the equation."""
    return any(name in subject.form.bodies.get(body, ()) for body in equation.bodies)


def _arrows(equation: PointEquation) -> list[Arrow]:
    """The vectors of an equation, each once."""
    found: dict[object, Arrow] = {}
    for arrow in equation.terms or (*equation.left, *equation.right):
        found.setdefault(arrow.name, arrow)
    return list(found.values())


def _tries(bodies: BodyBoard, named: Vectors, equation: PointEquation, arrows: Sequence[Arrow]) -> Iterator[Unlettered]:
    """The figure with vectors and bodies of several sizes; marks of angles go where there is room for them."""
    axes = [(axis.way, axis.letter) for axis in equation.axes if axis.letter]
    for number, (stretch, size) in enumerate(_SIZES):
        base, longest = _base(bodies, named, equation, arrows, stretch * LONGEST, size)
        marked = MOST_ANGLES + 1
        for most in (MOST_ANGLES, 2, 0) if number == 0 else (0,):
            if most < marked:  # else there is nothing to leave out
                board = base.copied() if most else base
                marked = draw_geometry(board, bodies.subject, named.symbols, most)
                draw_axes(board, board.sketch.at[equation.point], axes, longest)
                yield board.draft(_COLUMN if marked else math.inf)


def _base(
    bodies: BodyBoard, named: Vectors, equation: PointEquation, arrows: Sequence[Arrow], longest: float, size: float
) -> tuple[MotionBoard, float]:
    """The bodies with the vectors, and the length of the longest one (u)."""
    place = bodies.place(equation.point)
    letters = {arrow.name: named.symbols.letter(arrow.name) for arrow in arrows}
    # Equal vectors are one arrow with both names; none is left out, however short.
    together = named_together([(letters[a.name], a.vector) for a in arrows], math.inf)
    drawn, _ = _tips(together, longest, bodies.subject.least)
    share = _BESIDE_RODS if equation.rods else _SHARE
    # Else they would leave none for the bodies.
    longest *= min(1.0, largest([0j, *drawn], share * bodies.room.real, share * bodies.room.imag))

    def spread(longest: float) -> list[tuple[complex, complex]]:
        drawn, _ = _tips(together, longest, bodies.subject.least)
        return [(place, 0j), *((place, 1.1 * vector) for vector in drawn)]

    scale, longest = bodies.fitted(spread, longest, size)
    drawn, lengthened = _tips(together, longest, bodies.subject.least)
    board = bodies.drawn(scale)
    draw_point(board, equation.point)
    at = board.sketch.at[equation.point]
    if not lengthened:
        _draw_parallelogram(board, at, equation, longest / max(abs(arrow.vector) for arrow in arrows))
    bold = {to_plain(letters[arrow.name]) for arrow in equation.left if arrow.name in letters}
    names = [formula for formula, _ in together]
    weights = [BOLD if to_plain(name).split(" = ")[0] in bold else MEDIUM for name in names]
    draw_vectors(board, at, list(zip(names, drawn, weights, strict=True)), [])
    board.sketch.lengthened = lengthened
    for _, vector in together:
        board.sketch.occupy(equation.point, vector)
    return board, longest


def _tips(named: Sequence[tuple[Formula, complex]], longest: float, least: float) -> tuple[list[complex], bool]:
    """The vectors as they are drawn (u), and whether any is lengthened to be seen."""
    lengths, lengthened = sizes([abs(vector) for _, vector in named], longest, least)
    return [size * vector / abs(vector) for size, (_, vector) in zip(lengths, named, strict=True)], lengthened


def _draw_parallelogram(board: MotionBoard, at: complex, equation: PointEquation, scale: float) -> None:
    """Dashed lines from the tips of two vectors to that of their sum."""
    drawn = {arrow.name for arrow in _arrows(equation)}
    if len(equation.left) != 1 or len(equation.right) != 2 or not drawn >= {arrow.name for arrow in equation.right}:
        return
    whole, first, second = (scale * arrow.vector for arrow in (*equation.left, *equation.right))
    if abs((first.conjugate() * second).imag) > _STRAIGHT * abs(first) * abs(second) > 0:
        for part in (first, second):
            board.sketch.path((at + part, at + whole), Layer.GROUND, THIN, dash="dashed")
