"""The whole mechanism with what a step marks in it: angles, perpendiculars, the axes of the coordinate method."""

from __future__ import annotations

from collections.abc import Sequence
from functools import partial

from variantgen.figure.drawing import MEDIUM, Layer
from variantgen.figure.equations.body_board import FigureSubject
from variantgen.figure.equations.marked_geometry import MOST_ANGLES, draw_geometry
from variantgen.figure.making import Making
from variantgen.figure.motion.motion_board import MotionBoard, draw_on_mechanism
from variantgen.figure.motion.vectors import Vectors, vectors_of
from variantgen.figure.placement.label_requests import around
from variantgen.methods.steps.point_vectors import PointVectors
from variantgen.wording.formula import Symbol

_AXIS = 17.0  # length of an axis, u
_HEAD = 2.2


def draw_marked_mechanism(subject: FigureSubject, vectors: Sequence[PointVectors], axes: bool) -> Making:
    """The figure, with the ``axes`` or without. Raises InputError where nothing can be drawn."""
    named = vectors_of(subject.mechanism, 1, vectors)
    annotate = partial(_annotate, subject, named, axes)
    return draw_on_mechanism(subject.mechanism, annotate)


def _annotate(subject: FigureSubject, named: Vectors, axes: bool, board: MotionBoard, stretch: float) -> None:
    """The axes from the origin of the coordinates, then what is marked."""
    if axes:
        _draw_axes(board, stretch)
    draw_geometry(board, subject, named.symbols, MOST_ANGLES)


def _draw_axes(board: MotionBoard, stretch: float) -> None:
    sketch = board.sketch
    origin = next((name for name in board.shown if abs(sketch.at[name]) < 1e-6), "")
    for axis, letter in ((1 + 0j, "x"), (1j, "y")):
        tip = stretch * _AXIS * axis
        sketch.arrow(0j, tip, Layer.MARK, MEDIUM, _HEAD)
        sketch.label(around(Symbol(letter), tip, 0.3))
        if origin:
            sketch.occupy(origin, axis)
