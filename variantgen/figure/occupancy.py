"""Where there is ink, on a grid with a summed-area table: how much of a box is taken costs four look-ups."""

from __future__ import annotations

import numpy as np
from numpy.typing import NDArray

from variantgen.figure.ink import Segments

CELL = 0.5  # side of a cell, u: below the free space that a label keeps
_STEP = 0.75  # of samples along a segment, cells: no cell that a segment crosses in the middle is missed
_EDGE = 2.0  # empty border, u

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
        np.cumsum(cells, axis=0, out=cells)
        np.cumsum(cells, axis=1, out=cells)
        self._taken = cells

    def taken(self, places: Places, half_width: NDArray[np.float64], half_height: NDArray[np.float64]) -> Counts:
        """Number of inked cells that the box about each place touches; half sides per place, shape (P,)."""
        x, y = places.real - self._low.real, places.imag - self._low.imag
        left, right = self._cell(x - half_width, 1), self._cell(x + half_width, 1, 1)
        low, high = self._cell(y - half_height, 0), self._cell(y + half_height, 0, 1)
        sums = self._taken
        result: Counts = sums[high, right] - sums[low, right] - sums[high, left] + sums[low, left]
        return result

    def _cell(self, x: NDArray[np.float64], axis: int, more: int = 0) -> NDArray[np.intp]:
        cell = np.floor(x * (1 / CELL)).astype(np.intp) + more
        return np.minimum(np.maximum(cell, 0), self._taken.shape[axis] - 1)


def _samples(segments: Segments) -> Places:
    """Points along all segments, nearer to each other than a cell."""
    start, step = segments[:, 0], segments[:, 1] - segments[:, 0]
    count = (np.abs(step) / (_STEP * CELL)).astype(np.intp) + 2
    owner = np.repeat(np.arange(len(segments)), count)
    first = np.cumsum(count) - count
    part = (np.arange(owner.size) - first[owner]) / (count[owner] - 1)
    result: Places = start[owner] + part * step[owner]
    return result
