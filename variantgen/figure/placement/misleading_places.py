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
_AWAY = complex(1e6, 1e6)  # where there is no point, u


class MisleadingPlaces:
    """The points and arrows of some figures that labels could be taken to name.

    ``figure`` is the number of the figure of each request, ``strangers`` are named points of each figure beside those
    of its requests.
    """

    def __init__(
        self,
        requests: Sequence[LabelRequest],
        figure: NDArray[np.intp],
        strangers: Sequence[Sequence[complex]],
        occupancy: Occupancy,
    ) -> None:
        self._occupancy, self._figure = occupancy, figure
        points: list[list[complex]] = [[*places] for places in strangers]
        extended: list[list[complex]] = [[] for _ in strangers]
        arrows: list[list[tuple[complex, complex]]] = [[] for _ in strangers]
        arrow_of = []
        for request, number in zip(requests, figure.tolist(), strict=True):
            (extended if request.extent else points)[number] += request.own
            arrow = request.arrow
            # The number of the arrow that a label names, or -1.
            arrow_of.append(-1 if arrow is None else len(arrows[number]))
            if arrow is not None:
                arrows[number].append(arrow)
        # Those of arrows and lines first; shape (figures, points).
        self._extended = max(map(len, extended))
        self._points = np.concatenate((_rows(extended), _rows(points)), axis=1)
        count = np.array([len(r.own) for r in requests])
        own = np.array([p for r in requests for p in r.own])
        # A stranger at the very place that a label names is no stranger.
        same = np.abs(self._points[figure.repeat(count)] - own[:, None]) < 1e-6
        self._own = np.logical_or.reduceat(same, count.cumsum() - count, axis=0)
        self._clear = np.array([r.clear + _OWN for r in requests])
        self._boxes = np.array([r.box for r in requests])
        self._is_extended = np.array([bool(r.extent) for r in requests])
        self._arrow_of = np.array(arrow_of)
        self._arrows = np.full((len(arrows), max(map(len, arrows)), 2), _AWAY)
        for row, known in zip(self._arrows, arrows, strict=True):
            row[: len(known)] = np.array(known, dtype=complex).reshape(-1, 2)

    def costs(self, places: Places, owner: NDArray[np.intp]) -> Costs:
        """Cost of each candidate of the labels ``owner`` that could be taken to name something else, shape (N,).

        It is nearer to a foreign point (or a foreign arrow) than to what the label names, or a line runs between.
        """
        figure = self._figure[owner]
        steps = self._points[figure] - places[:, None]
        squares = steps.real**2 + steps.imag**2
        mine = self._own[owner]
        own = np.where(mine, squares, np.inf)
        rows, own_at = np.arange(len(own)), own.argmin(axis=1)
        nearest = own[rows, own_at]
        way = steps[rows, own_at]
        way *= np.maximum(0.0, 1.0 - self._clear[owner] / np.sqrt(nearest))
        between = places[:, None] + _BETWEEN * way[:, None]
        inked = self._occupancy.taken(between, 0.05, 0.05, figure[:, None])
        squares[mine] = np.inf
        foreign = np.minimum.reduce(squares[:, : self._extended], axis=1, initial=np.inf)
        other = np.minimum.reduce(squares[:, self._extended :], axis=1, initial=np.inf)
        result: Costs = _STRANGER * (np.minimum(foreign, other) < nearest)
        result += _BARRIER * (np.maximum.reduce(inked, axis=1) > 0)
        misread = self._is_extended[owner] & (foreign < nearest)
        result += MISREAD * (misread | self.misread(places, owner))
        return result

    def misread(self, places: Places, owner: NDArray[np.intp]) -> NDArray[np.bool_]:
        """Which places would put the name of a straight arrow nearer to another one; shape ``(places,)``."""
        found = np.zeros(len(places), dtype=bool)
        of = np.flatnonzero(self._arrow_of[owner] >= 0)
        if not of.size:
            return found
        label = owner[of]
        boxes = self._boxes[label]
        gaps = gaps_to_box(places[of, None], (boxes[:, :1], boxes[:, 1:]), self._arrows[self._figure[label]])
        at = np.arange(len(of)), self._arrow_of[label]
        own = gaps[at]
        gaps[at] = np.inf
        found[of] = np.minimum.reduce(gaps, axis=1) < own + _PLAINLY
        return found


def _rows(places: Sequence[Sequence[complex]]) -> Places:
    """Rows of places, the shorter ones filled up with one that is far away."""
    found = np.full((len(places), max(map(len, places))), _AWAY)
    for row, known in zip(found, places, strict=True):
        row[: len(known)] = known
    return found
