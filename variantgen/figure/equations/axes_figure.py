"""The figure of the coordinate method: the mechanism with the axes x and y at their origin and the given angles."""

from __future__ import annotations

from collections.abc import Sequence
from functools import partial

from variantgen.figure.drawing import MEDIUM, Drawing, Layer
from variantgen.figure.equations.body_board import FigureSubject
from variantgen.figure.equations.marked_geometry import MOST_ANGLES, draw_geometry
from variantgen.figure.motion.motion_board import MotionBoard, draw_on_mechanism
from variantgen.figure.motion.vectors import Vectors, vectors_of
from variantgen.figure.placement.label_requests import around
from variantgen.methods.steps.point_vectors import PointVectors
from variantgen.wording.formula import Symbol

_AXIS = 17.0  # length of an axis, u
_HEAD = 2.2


def draw_coordinate_axes(subject: FigureSubject, vectors: Sequence[PointVectors]) -> Drawing:
    """The figure. Raises InputError where nothing can be drawn."""
    named = vectors_of(subject.variant, subject.motion, subject.index, subject.asked, 1, subject.language, vectors)
    annotate = partial(_annotate, subject, named)
    return draw_on_mechanism(subject.variant, subject.motion, subject.index, subject.asked, subject.language, annotate)


def _annotate(subject: FigureSubject, named: Vectors, board: MotionBoard, stretch: float) -> None:
    """The axes from the origin of the coordinates, then the angles."""
    sketch = board.sketch
    origin = next((name for name in board.shown if abs(sketch.at[name]) < 1e-6), "")
    for axis, letter in ((1 + 0j, "x"), (1j, "y")):
        tip = stretch * _AXIS * axis
        sketch.arrow(0j, tip, Layer.MARK, MEDIUM, _HEAD)
        sketch.label(around(Symbol(letter), tip, 0.3))
        if origin:
            sketch.occupy(origin, axis)
    draw_geometry(board, subject, named.symbols, MOST_ANGLES)
