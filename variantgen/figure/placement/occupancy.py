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
        self._low, self._sums = 0j, np.zeros((1, 1), dtype=np.int32)
        if len(segments):
            ends = segments.ravel()
            self._low = complex(ends.real.min() - _EDGE, ends.imag.min() - _EDGE)
            columns = int((ends.real.max() + _EDGE - self._low.real) / CELL) + 2
            rows = int((ends.imag.max() + _EDGE - self._low.imag) / CELL) + 2
            cells = np.zeros((rows, columns), dtype=np.int32)
            points = (_samples(segments) - self._low) / CELL
            cells[points.imag.astype(np.intp) + 1, points.real.astype(np.intp) + 1] = 1
            # Sums along columns would cost four times as much as sums along rows: in between, the table is turned.
            np.add.accumulate(cells, axis=1, out=cells)
            self._sums = np.ascontiguousarray(cells.T)
            np.add.accumulate(self._sums, axis=1, out=self._sums)
        columns, rows = self._sums.shape
        self._last = np.array([[columns - 1], [columns - 1], [rows - 1], [rows - 1]])

    def taken(self, places: Places, half_width: Sides, half_height: Sides) -> Counts:
        """Number of inked cells that the box about each place touches; half sides of shapes that go with the places."""
        x, y = places.real - self._low.real, places.imag - self._low.imag
        bounds = np.array([x - half_width, x + half_width, y - half_height, y + half_height])
        bounds *= 1 / CELL
        # What is below zero becomes zero or less: the outermost cells are empty.
        cells = bounds.reshape(4, -1).astype(np.intp)
        cells += _BEYOND
        np.minimum(np.maximum(cells, 0, out=cells), self._last, out=cells)
        left_and_right, low_and_high = cells[:2], cells[2:]
        sums = self._sums.ravel().take(low_and_high[:, None] + left_and_right * self._sums.shape[1])
        result: Counts = (sums[1, 1] - sums[0, 1] - sums[1, 0] + sums[0, 0]).reshape(bounds.shape[1:])
        return result


def _samples(segments: Segments) -> Places:
    """Points along all segments, nearer to each other than a cell."""
    start, step = segments[:, 0], segments[:, 1] - segments[:, 0]
    count = (np.abs(step) / (_STEP * CELL)).astype(np.intp) + 2
    ends = count.cumsum()
    part = np.arange(ends[-1]) - (ends - count).repeat(count)
    result: Places = start.repeat(count) + part / (count - 1).repeat(count) * step.repeat(count)
    return result
