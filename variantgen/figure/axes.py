"""The axes of a figure: x and y where components, directions or coordinates are asked, a line that is named for others.

Axes of directions stand where the paper is free; axes that coordinates are counted from stand at the origin of the
scene.
"""

from __future__ import annotations

from collections.abc import Mapping, Sequence

import numpy as np

from variantgen.families.quantities import Quantity, line_ends
from variantgen.figure.board import Board
from variantgen.figure.drawing import MEDIUM, Layer
from variantgen.figure.placement.label_requests import around
from variantgen.figure.sketch import DOT
from variantgen.wording.formula import Symbol

_LENGTH = 10.0
_BOX = 17.0  # side of the square that axes and letters take, u
_STEP = 4.0
_LETTERS = 3.5  # half the side of the square that a letter takes, u
_LONGER = np.arange(13.0, 41.0, 3.0)  # lengths of axes at the origin, u
_WAYS = {"x": 1.0 + 0j, "y": 1j}
_ON_PAPER = 1e-6  # u: points are in one place


def has_axes(asked: Sequence[Quantity]) -> bool:
    """Whether what is asked refers to axes."""
    return any(quantity.refers_to_axes or quantity.line for quantity in asked)


def draw_axes(board: Board, asked: Sequence[Quantity]) -> None:
    """Add the axes that the asked quantities refer to."""
    if any(quantity.is_coordinate for quantity in asked):
        _draw_at_origin(board)
    elif any(quantity.refers_to_axes for quantity in asked):
        _draw_where_free(board, _WAYS)
    for line, sides in lines_of(asked).items():
        _draw_where_free(board, {("∥" if side == "along" else "⟂") + line: _way(board, line, side) for side in sides})


def lines_of(asked: Sequence[Quantity]) -> dict[str, list[str]]:
    """The lines that components are taken along (``along``) or across (``across``), with these sides."""
    found: dict[str, list[str]] = {}
    for quantity in asked:
        side = quantity.component.partition("_")[0]
        if quantity.line and side not in found.setdefault(quantity.line, []):
            found[quantity.line].append(side)
    return found


def origin_point(board: Board) -> str:
    """The shown point that lies at the origin of the scene, or ''."""
    return next((point for point in board.shown if abs(board.sketch.at[point]) < _ON_PAPER), "")


def _way(board: Board, line: str, side: str) -> complex:
    """The unit vector along the line of two points, or across it to the left."""
    ends = line_ends(line, board.sketch.at)
    assert ends is not None, "the name of the quantity has been read"
    step = board.sketch.at[ends[1]] - board.sketch.at[ends[0]]
    return step / abs(step) * (1 if side == "along" else 1j)


def _draw_at_origin(board: Board) -> None:
    """Axes from the origin, each as long as its letter needs to be clear of the mechanism; a dot where no point is."""
    sketch = board.sketch
    if not origin_point(board):
        sketch.circle(0j, DOT, Layer.HINGE, fill="ink")
    for letter, way in _WAYS.items():
        tips = _LONGER * way
        crossed = sketch.crossings(tips, (_LETTERS, _LETTERS))
        tip = complex(tips[int(np.argmin(20.0 * crossed + np.abs(tips)))])
        sketch.arrow(0j, tip, Layer.VECTOR, MEDIUM)
        sketch.label(around(Symbol(letter), tip, 0.3))


def _draw_where_free(board: Board, ways: Mapping[str, complex]) -> None:
    """Add arrows from one place where a square of paper is free, near the lower left corner if possible."""
    sketch = board.sketch
    low, high = sketch.corners()
    half = 0.5 * _BOX
    x = np.arange(low.real - _BOX, high.real + _BOX, _STEP) + half
    y = np.arange(low.imag - _BOX, high.imag + _BOX, _STEP) + half
    middles = (x[None, :] + 1j * y[:, None]).ravel()
    crossed = sketch.crossings(middles, (half, half))
    # Paper beyond the mechanism costs more than a longer way from the corner.
    beyond = np.maximum(0, np.maximum(low.real - (middles.real - half), middles.real + half - high.real))
    beyond += np.maximum(0, np.maximum(low.imag - (middles.imag - half), middles.imag + half - high.imag))
    cost = np.abs(middles - low) + 6 * beyond + 1e3 * crossed
    for disc in board.form.figure.discs:  # axes in a wheel would seem to turn with it
        cost += 90.0 * (np.abs(middles - sketch.at[disc.centre]) < max(board.discs.get(disc.body, [0.0])))
    start = complex(middles[int(np.argmin(cost))]) - 0.3 * _BOX * sum(ways.values())
    for name, way in ways.items():
        tip = start + _LENGTH * way
        sketch.arrow(start, tip, Layer.VECTOR, MEDIUM)
        sketch.label(around(Symbol(name), tip, 0.3))
