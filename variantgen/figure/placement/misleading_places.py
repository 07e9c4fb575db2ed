"""Places of labels that could be taken to name something else, and what they cost."""

from __future__ import annotations

from collections.abc import Sequence

import numpy as np
from numpy.typing import NDArray

from variantgen.figure.ink import gaps_to_box
from variantgen.figure.placement.label_requests import Costs, LabelRequest, Places
from variantgen.figure.placement.occupancy import Occupancy

# Costs of a label nearer to another point than to its own, of a rate nearer to another one's arrow than to its own
# (which would be misread), of a line between a label and what it names.
_STRANGER, MISREAD, _BARRIER = 12.0, 60.0, 14.0
_BETWEEN = np.array([0.4, 0.55, 0.7, 0.85, 1.0])  # places on the way from a label to what it names
_PLAINLY = 0.2  # how much nearer to its own arrow than to another the name of an arrow stands, u
_OWN = 1.0  # where that way ends before a line or symbol that is named, u


class MisleadingPlaces:
    """The points and arrows of a figure that labels could be taken to name.

    ``strangers`` are named points beside those of the ``requests``.
    """

    def __init__(self, requests: Sequence[LabelRequest], strangers: Sequence[complex], occupancy: Occupancy) -> None:
        self._occupancy = occupancy
        self._points = np.array([*(p for r in requests for p in r.own), *strangers], dtype=complex)
        count = [len(r.own) for r in requests]
        first = np.array([0, *count[:-1]]).cumsum()
        # A stranger at the very place that a label names is no stranger.
        same = np.abs(self._points[: sum(count), None] - self._points) < 1e-6
        self._own = np.logical_or.reduceat(same, first, axis=0)
        self._clear = np.array([r.clear + _OWN for r in requests])
        self._boxes = np.array([r.box for r in requests])
        self._extended = np.array([bool(r.extent) for r in requests])
        self._on_extended = np.repeat([*self._extended, False], [*count, len(strangers)])
        arrows = [r.arrow for r in requests]
        self._arrows = np.array([arrow for arrow in arrows if arrow is not None], dtype=complex)
        # The number of the arrow that a label names, or -1.
        self._arrow_of = np.array([arrow is not None for arrow in arrows]).cumsum() - 1
        self._arrow_of[[arrow is None for arrow in arrows]] = -1

    def costs(self, places: Places, owner: NDArray[np.intp]) -> Costs:
        """Cost of each candidate of the labels ``owner`` that could be taken to name something else, shape (N,).

        It is nearer to a foreign point (or a foreign arrow) than to what the label names, or a line runs between.
        """
        steps = self._points - places[:, None]
        squares = steps.real**2 + steps.imag**2
        mine = self._own[owner]
        own = np.where(mine, squares, np.inf)
        rows, own_at = np.arange(len(own)), own.argmin(axis=1)
        nearest = own[rows, own_at]
        way = steps[rows, own_at]
        way *= np.maximum(0.0, 1.0 - self._clear[owner] / np.sqrt(nearest))
        between = places[:, None] + _BETWEEN * way[:, None]
        inked = self._occupancy.taken(between, 0.05, 0.05)
        squares[mine] = np.inf
        result: Costs = _STRANGER * (np.minimum.reduce(squares, axis=1) < nearest)
        result += _BARRIER * (np.maximum.reduce(inked, axis=1) > 0)
        if self._extended.any():
            foreign = np.minimum.reduce(squares[:, self._on_extended], axis=1)
            misread = self._extended[owner] & (foreign < nearest)
            result += MISREAD * (misread | self.misread(places, owner))
        return result

    def misread(self, places: Places, owner: NDArray[np.intp]) -> NDArray[np.bool_]:
        """Which places would put the name of a straight arrow nearer to another one; shape ``(places,)``."""
        found = np.zeros(len(places), dtype=bool)
        mine = self._arrow_of[owner]
        of = np.flatnonzero(mine >= 0)
        if len(self._arrows) < 2 or not of.size:
            return found
        boxes = self._boxes[owner[of]]
        gaps = gaps_to_box(places[of, None], (boxes[:, :1], boxes[:, 1:]), self._arrows)
        at = np.arange(len(of)), mine[of]
        own = gaps[at]
        gaps[at] = np.inf
        found[of] = np.minimum.reduce(gaps, axis=1) < own + _PLAINLY
        return found
