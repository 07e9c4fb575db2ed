"""Where there is ink, on grids with summed-area tables: how much of a box is taken costs four look-ups."""

from __future__ import annotations

from collections.abc import Sequence
from typing import Any

import numpy as np
from numpy.typing import NDArray

from variantgen.figure.ink import Segments, Sides

CELL = 0.5  # side of a cell, u: below the free space that a label keeps
_STEP = 0.75  # of samples along a segment, cells: no cell that a segment crosses in the middle is missed
_EDGE = 2.0  # empty border, u
_SUM = np.uint16  # of cells: differences of sums are right even where a sum is too large for it

Places = NDArray[np.complex128]
Counts = NDArray[np.uint16]


class Occupancy:
    """The cells of the papers of some figures that lines run through, given the segments of each, shape (S, 2).

    A line is found to within one cell; outside the grid nothing is taken.
    """

    def __init__(self, figures: Sequence[Segments]) -> None:
        # What has no line has a line at one place, and an empty table.
        ends = [segments.ravel() if len(segments) else np.zeros(2, dtype=complex) for segments in figures]
        count = np.array([len(own) for own in ends])
        first = count.cumsum() - count
        every = np.concatenate(ends)
        x, y = every.real, every.imag
        self._left, self._low = np.minimum.reduceat(x, first) - _EDGE, np.minimum.reduceat(y, first) - _EDGE
        columns = ((np.maximum.reduceat(x, first) + _EDGE - self._left) / CELL).astype(np.int32) + 2
        self._rows = ((np.maximum.reduceat(y, first) + _EDGE - self._low) / CELL).astype(np.int32) + 2
        self._last_column, self._last_row = columns - 1, self._rows - 1
        sizes = columns * self._rows
        self._start = sizes.cumsum(dtype=np.int32) - sizes
        inked_x, inked_y, each = _samples(every[0::2], every[1::2])
        figure = np.arange(len(figures)).repeat(np.add.reduceat(each, first // 2))
        column = ((inked_x - self._left[figure]) / CELL).astype(np.intp) + 1
        row = ((inked_y - self._low[figure]) / CELL).astype(np.intp) + 1
        self._sums = np.zeros(int(sizes.sum()), dtype=_SUM)
        self._sums[self._start[figure] + row * columns[figure] + column] = 1
        for number, (start, size) in enumerate(zip(self._start.tolist(), sizes.tolist(), strict=True)):
            own = self._sums[start : start + size]
            if not len(figures[number]):
                own[:] = 0
            # Sums of its own type, and along rows, take a fraction of the time: in between, the table is turned.
            table = np.add.accumulate(own.reshape(self._rows[number], -1), axis=1, dtype=_SUM)
            turned = np.ascontiguousarray(table.T)
            np.add.accumulate(turned, axis=1, dtype=_SUM, out=own.reshape(-1, self._rows[number]))

    def taken(self, places: Places, half_width: Sides, half_height: Sides, figure: Any = 0) -> Counts:
        """Number of inked cells that the box about each place touches, on the paper of each ``figure`` (number).

        Half sides and figures have shapes that go with the places.
        """
        x, y = places.real - self._left[figure], places.imag - self._low[figure]
        column = self._cells(x, half_width, self._last_column[figure])
        row = self._cells(y, half_height, self._last_row[figure])
        column *= self._rows[figure]
        column += self._start[figure]
        sums = self._sums.take(row[:, None] + column)
        result: Counts = sums[1, 1] - sums[0, 1] - sums[1, 0] + sums[0, 0]
        return result

    @staticmethod
    def _cells(middle: NDArray[np.float64], half: Sides, last: NDArray[np.int32]) -> NDArray[np.int32]:
        """The cells of the low and the high side of boxes: those that sums end with; shape (2, ...)."""
        bounds = np.array([middle - half, middle + half])
        bounds *= 1 / CELL
        # What is below zero becomes zero or less: the outermost cells are empty.
        cells = bounds.astype(np.int32)
        cells[1] += 1
        return np.minimum(np.maximum(cells, 0, out=cells), last, out=cells)


def _samples(start: Places, end: Places) -> tuple[NDArray[np.float64], NDArray[np.float64], NDArray[np.intp]]:
    """x and y of points along all segments, nearer to each other than a cell, and how many each segment has."""
    step = end - start
    count = (np.abs(step) / (_STEP * CELL)).astype(np.intp) + 2
    ends = count.cumsum()
    part = np.arange(ends[-1]) - (ends - count).repeat(count)
    part = part / (count - 1).repeat(count)
    x = start.real.repeat(count) + part * step.real.repeat(count)
    y = start.imag.repeat(count) + part * step.imag.repeat(count)
    return x, y, count
