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
_STRANGER, _MISREAD, _BARRIER = 12.0, 60.0, 14.0
_BETWEEN = np.array([0.4, 0.55, 0.7, 0.85, 1.0])  # places on the way from a label to what it names
_PLAINLY = 0.2  # how much nearer to its own arrow than to another the name of an arrow stands, u
_OWN = 1.0  # where that way ends before a line or symbol that is named, u


def misleading_costs(
    requests: Sequence[LabelRequest],
    strangers: Sequence[complex],
    places: Places,
    owner: NDArray[np.intp],
    occupancy: Occupancy,
) -> Costs:
    """Cost of each candidate that could be taken to name something else, shape (N,).

    It is nearer to a foreign point (or a foreign arrow) than to what the label names, or a line runs between.
    """
    points = np.array([p for r in requests for p in r.own] + list(strangers), dtype=complex)
    count = [len(r.own) for r in requests]
    dx, dy = places.real[:, None] - points.real, places.imag[:, None] - points.imag
    squares = dx * dx + dy * dy
    # A stranger at the very place that a label names is no stranger.
    same = np.abs(points[: sum(count), None] - points) < 1e-6
    mine = np.logical_or.reduceat(same, np.cumsum([0, *count[:-1]]), axis=0)[owner]
    own = np.where(mine, squares, np.inf)
    own_at = own.argmin(axis=1)
    nearest = own[np.arange(len(own)), own_at]
    way = points[own_at] - places
    clear = np.array([r.clear for r in requests])[owner]
    way *= np.maximum(0.0, 1.0 - (clear + _OWN) / np.sqrt(nearest))
    between = places[:, None] + _BETWEEN * way[:, None]
    barred = np.logical_or.reduce(occupancy.taken(between.ravel(), 0.05, 0.05).reshape(between.shape) > 0, axis=1)
    foreign = np.where(mine, np.inf, squares)
    nearer = np.minimum.reduce(foreign, axis=1) < nearest
    result: Costs = _STRANGER * nearer + _BARRIER * barred
    arrow = np.array([bool(r.extent) for r in requests])
    if arrow.any():
        on_arrow = np.repeat([*arrow, False], [*count, len(strangers)])
        misread = arrow[owner] & (np.minimum.reduce(foreign[:, on_arrow], axis=1) < nearest)
        result += _MISREAD * (misread | _nearer_to_other_arrow(requests, places, owner))
    return result


def _nearer_to_other_arrow(
    requests: Sequence[LabelRequest], places: Places, owner: NDArray[np.intp]
) -> NDArray[np.bool_]:
    """Which candidates for the name of a straight arrow have a box that is nearer to another straight arrow."""
    named = [i for i, request in enumerate(requests) if request.vector]
    found = np.zeros(len(places), dtype=bool)
    of = np.flatnonzero(np.isin(owner, named))
    if len(named) < 2 or not of.size:
        return found
    arrows = np.array([requests[i].arrow for i in named], dtype=complex)
    boxes = np.array([r.box for r in requests])[owner[of]]
    gaps = gaps_to_box(places[of, None], (boxes[:, :1], boxes[:, 1:]), arrows)
    mine = np.searchsorted(named, owner[of])
    rows = np.arange(len(of))
    own = gaps[rows, mine]
    gaps[rows, mine] = np.inf
    found[of] = np.minimum.reduce(gaps, axis=1) < own + _PLAINLY
    return found
