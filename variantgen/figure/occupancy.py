"""Where there is ink, on a grid with a summed-area table: how much of a box is taken costs four look-ups."""

from __future__ import annotations

import numpy as np
from numpy.typing import NDArray

from variantgen.figure.ink import Segments, Sides

CELL = 0.5  # side of a cell, u: below the free space that a label keeps
_STEP = 0.75  # of samples along a segment, cells: no cell that a segment crosses in the middle is missed
_EDGE = 2.0  # empty border, u
_BEYOND = np.array([[0], [1], [0], [1]])  # from the cells of the bounds of a box to those that its sums end with

Places = NDArray[np.complex128]
Counts = NDArray[np.int64]


class Occupancy:
    """The cells of the paper that lines run through.

    A line is found to within one cell; outside the grid nothing is taken.
    """

    def __init__(self, segments: Segments) -> None:
        self._taken = np.zeros((1, 1), dtype=np.int32)
        self._low = 0j
        if not len(segments):
            return
        ends = segments.ravel()
        self._low = complex(ends.real.min() - _EDGE, ends.imag.min() - _EDGE)
        columns = int((ends.real.max() + _EDGE - self._low.real) / CELL) + 2
        rows = int((ends.imag.max() + _EDGE - self._low.imag) / CELL) + 2
        cells = np.zeros((rows, columns), dtype=np.int32)
        points = (_samples(segments) - self._low) / CELL
        cells[points.imag.astype(np.intp) + 1, points.real.astype(np.intp) + 1] = 1
        np.add.accumulate(cells, axis=0, out=cells)
        np.add.accumulate(cells, axis=1, out=cells)
        self._taken = cells

    def taken(self, places: Places, half_width: Sides, half_height: Sides) -> Counts:
        """Number of inked cells that the box about each place touches; half sides for all or per place, shape (P,)."""
        x, y = places.real - self._low.real, places.imag - self._low.imag
        bounds = np.array([x - half_width, x + half_width, y - half_height, y + half_height])
        cells = np.floor(bounds * (1 / CELL)).astype(np.intp) + _BEYOND
        rows, columns = self._taken.shape
        np.minimum(np.maximum(cells, 0, out=cells), [[columns - 1], [columns - 1], [rows - 1], [rows - 1]], out=cells)
        left_and_right, low_and_high = cells[:2], cells[2:]
        sums = self._taken.ravel()[low_and_high[:, None] * columns + left_and_right]
        result: Counts = sums[1, 1] - sums[0, 1] - sums[1, 0] + sums[0, 0]
        return result


def _samples(segments: Segments) -> Places:
    """Points along all segments, nearer to each other than a cell."""
    start, step = segments[:, 0], segments[:, 1] - segments[:, 0]
    count = (np.abs(step) / (_STEP * CELL)).astype(np.intp) + 2
    owner = np.repeat(np.arange(len(segments)), count)
    first = np.cumsum(count) - count
    part = (np.arange(owner.size) - first[owner]) / (count[owner] - 1)
    result: Places = start[owner] + part * step[owner]
    return result
