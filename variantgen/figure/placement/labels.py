"""Placement of labels by optimisation: candidates for each, cost for collisions, deterministic.

A place costs by what its box would cover (lines, other labels), by how far it is, and by how near it comes to things
that it does not name. Every label first takes its best place. Labels that then cover each other are moved in turn. A
label that finds no free place near what it names, or only one where it would be read with another arrow, goes farther
off and gets a thin leader.
"""

from __future__ import annotations

from collections.abc import Iterable, Sequence
from itertools import accumulate, pairwise
from typing import NamedTuple

import numpy as np
from numpy.typing import NDArray

from variantgen.figure.drawing import Label, Path
from variantgen.figure.ink import Segments, Sides
from variantgen.figure.placement.choices import CLOSE, GAP, INK, TIGHT, LabelChoice, conflicting, resolve_overlaps
from variantgen.figure.placement.label_requests import Costs, LabelRequest, Places, far_from
from variantgen.figure.placement.misleading_places import MISREAD, MisleadingPlaces
from variantgen.figure.placement.occupancy import Occupancy

# Costs of each cell of ink under a label, of a leader and of each line that it crosses, with that of an arrow between
# all others.
_INK_CELL, _LEADER, _CUT, _CUT_BY_VECTOR = 2.0, 30.0, 4.0, 10.0
_FAR = 35.0  # cost from which on the letter of a vector is so far off or so misleading that a leader may be better
_FIRST = 10  # candidates of each label that are asked first what they could be mistaken for
_ON_LEADER = np.linspace(0.0, 1.0, 24)[:, None]  # places along a leader that are looked at


class WantedLabels(NamedTuple):
    """The labels that a figure wants, lines to keep clear of, shape (S, 2), and named points beside those of labels."""

    requests: Sequence[LabelRequest]
    segments: Segments
    strangers: Sequence[complex]


class PlacedLabels(NamedTuple):
    """Labels, the leaders of those that are far from what they name, and whether one of them may be hard to read."""

    labels: list[Label]
    leaders: list[Path]
    doubtful: bool


NOTHING_PLACED = PlacedLabels([], [], False)


def place_labels(figures: Sequence[WantedLabels]) -> list[PlacedLabels]:
    """Labels where they cost least, of several figures at once: the arrays of one are so small that calls would cost.

    Each figure wants a label at least.
    """
    papers = _Papers(figures)
    choices = papers.near_choices()
    first = papers.conflicting(choices)
    conflicts = [resolve_overlaps(own, of) for own, of in zip(choices, first, strict=True)]
    misread = papers.add_misread(choices, [number for number, of in enumerate(first) if of])
    crowded = [_crowded(own) | of for own, of in zip(choices, conflicts, strict=True)]
    if any(crowded):
        papers.add_leaders(choices, crowded)
        conflicts = [resolve_overlaps(own, of) if of else of for own, of in zip(choices, crowded, strict=True)]
        led = {number for number, of in enumerate(crowded) if of}
        misread = misread - led | {number for number, _ in papers.misread(choices, sorted(led))}
    doubtful = [
        bool(of) or number in misread or any(choice.on_ink for choice in own)
        for number, (own, of) in enumerate(zip(choices, conflicts, strict=True))
    ]
    return [
        PlacedLabels([_label(c) for c in own], [leader for c in own if (leader := c.leader)], of)
        for own, of in zip(choices, doubtful, strict=True)
    ]


def _crowded(choices: Sequence[LabelChoice]) -> set[int]:
    """The labels whose places are so bad that a leader may be better."""
    return {i for i, c in enumerate(choices) if c.costs[c.taken] >= (_FAR if c.request.vector else INK)}


def _label(choice: LabelChoice) -> Label:
    request = choice.request
    half_width, half_height = request.box
    return Label(request.formula, choice.place, (2 * half_width, 2 * half_height), arrow=request.arrow)


class _Papers:
    """The figures with what is on them: arrays have a row for each label of all figures."""

    def __init__(self, figures: Sequence[WantedLabels]) -> None:
        self._requests = [request for figure in figures for request in figure.requests]
        count = [len(figure.requests) for figure in figures]
        self._first = [0, *accumulate(count)]  # the number of the first label of each figure
        self._figure = np.arange(len(figures)).repeat(count)
        self._occupancy = Occupancy([figure.segments for figure in figures])
        strangers = [figure.strangers for figure in figures]
        self._misleading = MisleadingPlaces(self._requests, self._figure, strangers, self._occupancy)

    def near_choices(self) -> list[list[LabelChoice]]:
        """The candidates of all labels with their costs, by figure; of each label the best one is taken."""
        count = [len(r.places) for r in self._requests]
        # What is not filled costs more than anything.
        places, costs = np.zeros((len(count), max(count)), dtype=complex), np.full((len(count), max(count)), np.inf)
        for row, (request, size) in enumerate(zip(self._requests, count, strict=True)):
            places[row, :size], costs[row, :size] = request.places, request.costs
        boxes = np.array([r.box for r in self._requests])
        costs += self._ink_costs(places, boxes[:, :1], boxes[:, 1:], self._figure[:, None])
        self._add_misleading(places, costs)
        best = costs.argmin(axis=1).tolist()
        choices = [
            LabelChoice(request, own[:size], cost[:size], taken, complex(own[taken]))
            for request, own, cost, size, taken in zip(self._requests, places, costs, count, best, strict=True)
        ]
        return [choices[start:end] for start, end in pairwise(self._first)]

    def conflicting(self, choices: Sequence[Sequence[LabelChoice]]) -> list[list[int]]:
        """The labels of each figure that cover another one or read together with it."""
        places = np.array([choice.place for own in choices for choice in own])
        found = conflicting(places, np.array([r.box for r in self._requests]), self._figure)
        return [[i - first for i in found if first <= i < after] for first, after in pairwise(self._first)]

    def misread(self, choices: Sequence[Sequence[LabelChoice]], figures: Sequence[int]) -> list[tuple[int, int]]:
        """The labels of some figures that would be read with another arrow where they stand: figure, number there."""
        asked = [(figure, i) for figure in figures for i in range(len(choices[figure]))]
        if not asked:
            return []
        places = np.array([choices[figure][i].place for figure, i in asked])
        found = self._misleading.misread(places, np.array([self._first[figure] + i for figure, i in asked]))
        return [asked[number] for number in np.flatnonzero(found).tolist()]

    def add_misread(self, choices: Sequence[Sequence[LabelChoice]], figures: Sequence[int]) -> set[int]:
        """Add what a place costs that is read with another arrow, where a label has moved to one that was not asked.

        Returns those of the figures that have such a label.
        """
        found = self.misread(choices, figures)
        for figure, i in found:
            choice = choices[figure][i]
            new = choice.costs < MISREAD
            owner = np.full(int(new.sum()), self._first[figure] + i)
            choice.costs[new] += MISREAD * self._misleading.misread(choice.places[new], owner)
        return {figure for figure, _ in found}

    def add_leaders(self, choices: Sequence[Sequence[LabelChoice]], crowded: Sequence[Iterable[int]]) -> None:
        """Add far candidates to the ``crowded`` choices of each figure."""
        owner = [(figure, i) for figure, of in enumerate(crowded) for i in sorted(of)]
        own = [choices[figure][i] for figure, i in owner]
        requests = [choice.request for choice in own]
        far = [far_from(request) for request in requests]
        count = [len(places) for places, _, _ in far]
        places, costs, ends = (np.concatenate(parts) for parts in zip(*far, strict=True))
        figure = np.array([figure for figure, _ in owner]).repeat(count)
        half_width, half_height = np.array([request.box for request in requests]).T.repeat(count, axis=1)
        ink = self._ink_costs(places, half_width, half_height, figure)
        costs += _LEADER + ink
        # The leader from the edge of the symbol to the label: how many of its pieces run over ink. Where the label
        # itself would stand on a line, that is no matter.
        free = np.flatnonzero(ink < INK)
        clear = np.array([request.clear + 0.8 for request in requests]).repeat(count)[free]
        steps = places[free] - ends[free]
        start = ends[free] + clear * steps / np.abs(steps)
        samples = start + _ON_LEADER * (places[free] - start)
        cut = self._occupancy.taken(samples, 0.05, 0.05, figure[free]) > 0
        each = np.array([_CUT_BY_VECTOR if request.vector else _CUT for request in requests]).repeat(count)[free]
        costs[free] += each * (cut[0] + np.add.reduce(cut[1:] & ~cut[:-1], axis=0))
        for choice, size, end in zip(own, count, accumulate(count), strict=True):
            part = slice(end - size, end)
            choice.places = np.concatenate((choice.places, places[part]))
            choice.costs = np.concatenate((choice.costs, costs[part]))
            choice.ends = ends[part]

    def _ink_costs(self, places: Places, half_width: Sides, half_height: Sides, figure: NDArray[np.intp]) -> Costs:
        """Cost of the lines under or close to the box about each place; the other arrays have shapes like places."""
        wide, high = (np.array([half + TIGHT, half + GAP]) for half in (half_width, half_height))
        under, close = self._occupancy.taken(places, wide, high, figure)
        result: Costs = (under > 0) * INK + _INK_CELL * under + (close > 0) * CLOSE
        return result

    def _add_misleading(self, places: Places, costs: Costs) -> None:
        """Add what a candidate could be mistaken for, but only to those that may win; shape (labels, candidates).

        The best few of each label are asked first; where one of them stays better than all others, nothing else
        matters.
        """
        best = costs.argsort(axis=1, kind="stable")[:, :_FIRST]
        label = np.arange(len(costs))[:, None]
        low = costs[label, best] < INK
        first = low.nonzero()[0], best[low]
        costs[first] += self._misleading.costs(places[first], first[0])
        least = np.minimum.reduce(costs[label, best], axis=1, keepdims=True, where=low, initial=INK)
        rest = costs < least
        rest[first] = False
        if rest.any():
            costs[rest] += self._misleading.costs(places[rest], rest.nonzero()[0])
