"""Placement of labels by optimisation: candidates for each, cost for collisions, deterministic.

A place costs by what its box would cover (lines, other labels), by how far it is, and by how near it comes to things
that it does not name. Every label first takes its best place. Labels that then cover each other are moved in turn. A
label that finds no free place near what it names, or only one where it would be read with another arrow, goes farther
off and gets a thin leader.
"""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import dataclass, field
from itertools import islice
from typing import NamedTuple

import numpy as np

from variantgen.figure.drawing import THIN, Label, Layer, Path
from variantgen.figure.ink import Segments, Sides, boxes_crossed, crosses
from variantgen.figure.placement.label_requests import Costs, LabelRequest, Places, far_from
from variantgen.figure.placement.misleading_places import MISREAD, MisleadingPlaces
from variantgen.figure.placement.occupancy import Occupancy

GAP = 0.8  # free space around a label, u
_TIGHT = 0.45  # free space that a label never gives up (half of a bold line), u
# Costs of ink under a label and per cell of it, of less than the wished free space, of two labels over each other, of a
# leader and of each line that it crosses, with that of an arrow between all others.
_INK, _INK_CELL, _CLOSE, _LABEL, _LEADER, _CUT, _CUT_BY_VECTOR = 100.0, 2.0, 3.0, 300.0, 30.0, 4.0, 10.0
_FAR = 35.0  # cost from which on the letter of a vector is so far off or so misleading that a leader may be better
_PRODUCT = 15.0  # of two labels that stand side by side so near that they read as a product
_BESIDE = 2.4  # u
_FIRST = 10  # candidates of each label that are asked first what they could be mistaken for
_SWEEPS = 4
_AWAY = complex(1e6, 1e6)  # far from all paper
_LEADER_GAP = 0.35  # between a leader and its label or the symbol, u
_ON_LEADER = np.linspace(0.0, 1.0, 24)  # places along a leader that are looked at


@dataclass
class _Choice:
    """The candidates of one label with what they cost apart from other labels, and the one that is taken.

    The last ones need a leader: to the ``ends``, shape (L,).
    """

    request: LabelRequest
    places: Places
    costs: Costs
    taken: int
    place: complex
    ends: Places = field(default_factory=lambda: np.zeros(0, dtype=complex))

    def take(self, number: int) -> None:
        """Choose a candidate."""
        self.taken, self.place = number, complex(self.places[number])

    @property
    def near(self) -> int:
        """The number of candidates that need no leader."""
        return len(self.places) - len(self.ends)

    @property
    def leader(self) -> Path | None:
        """The leader of the chosen place, where it needs one."""
        number = self.taken - self.near
        return _leader(self.request, self.place, complex(self.ends[number])) if number >= 0 else None

    @property
    def on_ink(self) -> bool:
        """Whether the chosen place is on a line, or as bad as that."""
        return bool(self.costs[self.taken] >= _INK)


class Placed(NamedTuple):
    """Labels, the leaders of those that are far from what they name, and whether one of them may be hard to read."""

    labels: list[Label]
    leaders: list[Path]
    doubtful: bool


def place_labels(requests: Sequence[LabelRequest], segments: Segments, strangers: Sequence[complex]) -> Placed:
    """Labels where they cost least.

    ``segments`` (shape (S, 2)) are lines to keep clear of, ``strangers`` further named points.
    """
    if not requests:
        return Placed([], [], False)
    occupancy = Occupancy(segments)
    misleading = MisleadingPlaces(requests, strangers, occupancy)
    choices = _near_choices(requests, occupancy, misleading)
    first = _conflicting(choices)
    conflicts, misread = set[int](), False
    if first:
        conflicts = _resolve_overlaps(choices, first)
        misread = _add_misread(choices, misleading)
    worst = {i for i, c in enumerate(choices) if c.costs[c.taken] >= (_FAR if c.request.vector else _INK)}
    if crowded := sorted(worst | conflicts):
        _add_leaders(choices, crowded, occupancy)
        conflicts = _resolve_overlaps(choices, crowded)
        misread = bool(_misread(choices, misleading))
    labels = [
        Label(c.request.formula, c.place, (2 * c.request.box[0], 2 * c.request.box[1]), arrow=c.request.arrow)
        for c in choices
    ]
    doubtful = bool(conflicts) or misread or any(choice.on_ink for choice in choices)
    return Placed(labels, [leader for c in choices if (leader := c.leader)], doubtful)


def _near_choices(
    requests: Sequence[LabelRequest], occupancy: Occupancy, misleading: MisleadingPlaces
) -> list[_Choice]:
    """The candidates of all labels with their costs, computed at once; of each the best one is taken."""
    count = [len(r.places) for r in requests]
    # A row for each label; what is not filled costs more than anything.
    places, costs = np.zeros((len(count), max(count)), dtype=complex), np.full((len(count), max(count)), np.inf)
    for row, (request, size) in enumerate(zip(requests, count, strict=True)):
        places[row, :size], costs[row, :size] = request.places, request.costs
    boxes = np.array([r.box for r in requests])
    costs += _ink_costs(occupancy, places, boxes[:, :1], boxes[:, 1:])
    _add_misleading(misleading, places, costs)
    best = costs.argmin(axis=1).tolist()
    return [
        _Choice(request, own[:size], cost[:size], taken, complex(own[taken]))
        for request, own, cost, size, taken in zip(requests, places, costs, count, best, strict=True)
    ]


def _add_misleading(misleading: MisleadingPlaces, places: Places, costs: Costs) -> None:
    """Add what a candidate could be mistaken for, but only to those that may win; shape (labels, candidates).

    The best few of each label are asked first; where one of them stays better than all others, nothing else matters.
    """
    best = costs.argsort(axis=1, kind="stable")[:, :_FIRST]
    label = np.arange(len(costs))[:, None]
    low = costs[label, best] < _INK
    first = low.nonzero()[0], best[low]
    costs[first] += misleading.costs(places[first], first[0])
    least = np.minimum.reduce(costs[label, best], axis=1, keepdims=True, where=low, initial=_INK)
    rest = costs < least
    rest[first] = False
    if rest.any():
        costs[rest] += misleading.costs(places[rest], rest.nonzero()[0])


def _misread(choices: Sequence[_Choice], misleading: MisleadingPlaces) -> list[int]:
    """The labels that would be read with another arrow where they stand."""
    taken = np.array([choice.place for choice in choices])
    found: list[int] = np.flatnonzero(misleading.misread(taken, np.arange(len(choices)))).tolist()
    return found


def _add_misread(choices: Sequence[_Choice], misleading: MisleadingPlaces) -> bool:
    """Add what a place costs that is read with another arrow, where a label has moved to one that was not asked.

    Returns whether there is such a label.
    """
    found = _misread(choices, misleading)
    for i in found:
        choice = choices[i]
        new = choice.costs < MISREAD
        choice.costs[new] += MISREAD * misleading.misread(choice.places[new], np.full(int(new.sum()), i))
    return bool(found)


def _ink_costs(occupancy: Occupancy, places: Places, half_width: Sides, half_height: Sides) -> Costs:
    """Cost of the lines under or close to the box about each place; the half sides have shapes like the places."""
    wide, high = (np.array([half + _TIGHT, half + GAP]) for half in (half_width, half_height))
    under, close = occupancy.taken(places, wide, high)
    result: Costs = (under > 0) * _INK + _INK_CELL * under + (close > 0) * _CLOSE
    return result


def _add_leaders(choices: list[_Choice], crowded: Sequence[int], occupancy: Occupancy) -> None:
    """Add far candidates to some choices."""
    requests = [choices[i].request for i in crowded]
    far = [far_from(request) for request in requests]
    count = [len(places) for places, _, _ in far]
    places, costs, ends = (np.concatenate(parts) for parts in zip(*far, strict=True))
    ink = _ink_costs(occupancy, places, *np.array([request.box for request in requests]).T.repeat(count, axis=1))
    costs += _LEADER + ink
    # The leader from the edge of the symbol to the label: how many of its pieces run over ink. Where the label itself
    # would stand on a line, that is no matter.
    free = np.flatnonzero(ink < _INK)
    clear = np.array([request.clear + 0.8 for request in requests]).repeat(count)[free]
    steps = places[free] - ends[free]
    start = ends[free] + clear * steps / np.abs(steps)
    samples = start[:, None] + _ON_LEADER * (places[free] - start)[:, None]
    cut = occupancy.taken(samples, 0.05, 0.05) > 0
    each = np.array([_CUT_BY_VECTOR if request.vector else _CUT for request in requests]).repeat(count)[free]
    costs[free] += each * (cut[:, 0] + np.add.reduce(cut[:, 1:] & ~cut[:, :-1], axis=1))
    last = np.cumsum(count).tolist()
    for i, size, end in zip(crowded, count, last, strict=True):
        choice, own = choices[i], slice(end - size, end)
        choice.places = np.concatenate((choice.places, places[own]))
        choice.costs = np.concatenate((choice.costs, costs[own]))
        choice.ends = ends[own]


def _resolve_overlaps(choices: list[_Choice], first: Sequence[int]) -> set[int]:
    """Move labels that cover each other until none does; those with the fewest good places move first.

    Returns those that still do.
    """
    conflicts = pending = set(first)
    standing = _Standing(choices)
    for _ in range(_SWEEPS):
        before = [choice.taken for choice in choices]
        for i in sorted(pending, key=lambda i: (-float(choices[i].costs.min()), i)):
            standing.take(i)
            choices[i].take(standing.best(choices[i]))
            standing.put(i, choices[i])
        conflicts = set(_conflicting(choices))
        # A label that could be led to, but still lies on a line, tries again in view of what has moved.
        stuck = {i for i, choice in enumerate(choices) if choice.ends.size and choice.on_ink}
        done, pending = pending, conflicts | stuck
        # Who has not moved would not do so in view of the same places.
        if not pending or (pending <= done and before == [choice.taken for choice in choices]):
            break
    return conflicts


def _conflicting(choices: Sequence[_Choice]) -> list[int]:
    """Labels that cover another one or read together with it."""
    # Plain numbers: there are a few dozen pairs at most, and most are far apart.
    known = sorted((c.place.real, c.place.imag, *c.request.box, i) for i, c in enumerate(choices))
    widest = max(half_width for _, _, half_width, _, _ in known)
    found: set[int] = set()
    for number, (x, y, half_width, half_height, i) in enumerate(known):
        for other_x, other_y, other_width, other_height, j in islice(known, number + 1, None):
            dx, width = other_x - x, half_width + other_width
            if dx >= half_width + widest + _BESIDE:
                break
            dy, height = abs(other_y - y), half_height + other_height
            if (dx < width + _TIGHT and dy < height + _TIGHT) or (dx < width + _BESIDE and dy < 0.35 * height):
                found |= {i, j}
    return sorted(found)


class _Standing:
    """Where all labels stand now: their places, boxes and leaders."""

    def __init__(self, choices: Sequence[_Choice]) -> None:
        self._places = np.array([choice.place for choice in choices])
        self._boxes = np.array([choice.request.box for choice in choices])
        self._leaders = [choice.leader for choice in choices]

    def take(self, i: int) -> None:
        """Take a label away from the paper."""
        self._places[i], self._leaders[i] = _AWAY, None

    def put(self, i: int, choice: _Choice) -> None:
        """Put a label to its chosen place."""
        self._places[i], self._leaders[i] = choice.place, choice.leader

    def best(self, own: _Choice) -> int:
        """The candidate of a label that costs least in view of what stands."""
        costs = self._overlaps(own)
        best = int((own.costs + costs).argmin())
        # What its own leaders would cross only matters where one is wanted.
        if best >= own.near:
            costs[own.near :] += self._crossed_by_leaders(own)
            best = int((own.costs + costs).argmin())
        return best

    def _overlaps(self, own: _Choice) -> Costs:
        """Cost of the labels and leaders under each candidate of a label."""
        half_width, half_height = own.request.box
        across = np.abs(own.places.imag[:, None] - self._places.imag)
        dx = np.abs(own.places.real[:, None] - self._places.real) - (self._boxes[:, 0] + half_width)
        space = np.maximum(dx, across - (self._boxes[:, 1] + half_height))
        # Letters side by side on one line read as a product.
        product = (dx < _BESIDE) & (across < 0.7 * half_height)
        costs: Costs = _PRODUCT * np.add.reduce(product, axis=1)
        if (near := space < GAP).any():
            costs += _CLOSE * np.add.reduce(near, axis=1) + _LABEL * np.add.reduce(space < _TIGHT, axis=1)
        leaders = [leader.points for leader in self._leaders if leader]
        if leaders:
            box = (half_width + _TIGHT, half_height + _TIGHT)
            costs += _LABEL * boxes_crossed(own.places, box, np.array(leaders))
        return costs

    def _crossed_by_leaders(self, own: _Choice) -> Costs:
        """Cost of the labels that the leaders of a label would cross."""
        boxes = self._boxes + _TIGHT
        ways = 0.5 * (own.places[own.near :] - own.ends)
        middles = own.ends + ways - self._places[:, None]
        crossed: Costs = _LABEL * np.add.reduce(crosses(middles, ways, (boxes[:, :1], boxes[:, 1:])), axis=0)
        return crossed


def _leader(request: LabelRequest, place: complex, to: complex) -> Path | None:
    """A thin line from the edge of the symbol to the edge of the label; none where the two nearly touch."""
    step = place - to
    way = step / abs(step)
    half_width, half_height = request.box
    to_edge = min(
        half_width / abs(way.real) if way.real else np.inf, half_height / abs(way.imag) if way.imag else np.inf
    )
    start = to + (request.clear + (_LEADER_GAP if request.clear else 0.0)) * way
    end = place - (to_edge + _LEADER_GAP) * way
    if ((end - start) * way.conjugate()).real < 1.0:
        return None
    return Path((start, end), Layer.LABEL, THIN)
