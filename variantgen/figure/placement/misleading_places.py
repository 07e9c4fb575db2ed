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
_BETWEEN = np.array([[0.4], [0.55], [0.7], [0.85], [1.0]])  # places on the way from a label to what it names
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
        # What each label names, and the strangers of its figure, those on arrows and lines first. The shape is (points,
        # labels), since numpy is quick along the last axis.
        self._own = _columns([r.own for r in requests])
        self._extended = max(map(len, extended))
        every = np.concatenate((_columns(extended), _columns(points)))[:, figure]
        # A stranger at the very place that a label names is no stranger.
        mine = np.logical_or.reduce([np.abs(every - places) < 1e-6 for places in self._own])
        self._strangers = np.where(mine, _AWAY, every)
        self._clear = np.array([r.clear + _OWN for r in requests])
        self._half_width, self._half_height = np.array([r.box for r in requests]).T
        self._is_extended = np.array([bool(r.extent) for r in requests])
        self._arrow_of = np.array(arrow_of)
        starts, tips = ([[arrow[end] for arrow in own] for own in arrows] for end in (0, 1))
        self._arrows = np.stack((_columns(starts), _columns(tips)), axis=-1)

    def costs(self, places: Places, owner: NDArray[np.intp]) -> Costs:
        """Cost of each candidate of the labels ``owner`` that could be taken to name something else, shape (N,).

        It is nearer to a foreign point (or a foreign arrow) than to what the label names, or a line runs between.
        """
        figure = self._figure[owner]
        steps = self._own[:, owner] - places
        squares = _squares(steps)
        nearest = np.minimum.reduce(squares, axis=0)
        way = steps[squares.argmin(axis=0), np.arange(len(places))]
        way *= np.maximum(0.0, 1.0 - self._clear[owner] / np.sqrt(nearest))
        between = places + _BETWEEN * way
        inked = self._occupancy.taken(between, 0.05, 0.05, figure)
        squares = _squares(self._strangers[:, owner] - places)
        foreign = np.minimum.reduce(squares[: self._extended], axis=0, initial=np.inf)
        other = np.minimum.reduce(squares[self._extended :], axis=0, initial=np.inf)
        result: Costs = _STRANGER * (np.minimum(foreign, other) < nearest)
        result += _BARRIER * (np.maximum.reduce(inked, axis=0) > 0)
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
        half_sides = self._half_width[label], self._half_height[label]
        gaps = gaps_to_box(places[of], half_sides, self._arrows[:, self._figure[label]])
        at = self._arrow_of[label], np.arange(len(of))
        own = gaps[at]
        gaps[at] = np.inf
        found[of] = np.minimum.reduce(gaps, axis=0) < own + _PLAINLY
        return found


def _squares(steps: Places) -> NDArray[np.float64]:
    result: NDArray[np.float64] = steps.real**2 + steps.imag**2
    return result


def _columns(places: Sequence[Sequence[complex]]) -> Places:
    """Columns of places, the shorter ones filled up with one that is far away."""
    most = max(map(len, places))
    rows = [[*known, *[_AWAY] * (most - len(known))] for known in places]
    return np.array(rows, dtype=complex).reshape(len(places), most).T
