"""The axes x and y of a figure: drawn when components or directions are asked."""

from __future__ import annotations

import numpy as np

from variantgen.figure.board import Board
from variantgen.figure.drawing import MEDIUM, Layer
from variantgen.figure.placement.label_requests import around
from variantgen.wording.formula import Symbol

_LENGTH = 10.0
_BOX = 17.0  # side of the square that axes and letters take, u
_STEP = 4.0


def draw_axes(board: Board) -> None:
    """Add the axes where a square of paper is free, near the lower left corner if possible."""
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
    origin = complex(middles[int(np.argmin(cost))]) - complex(0.3, 0.3) * _BOX
    for way, letter in ((1.0, "x"), (1j, "y")):
        tip = origin + _LENGTH * way
        sketch.arrow(origin, tip, Layer.VECTOR, MEDIUM)
        sketch.label(around(Symbol(letter), tip, 0.3))
