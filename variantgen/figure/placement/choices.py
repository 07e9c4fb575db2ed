"""The candidates of labels with what they cost, and how labels are moved that cover each other."""

from __future__ import annotations

from collections.abc import Iterable, Sequence

import numpy as np
from msgspec import Struct, field
from numpy.typing import NDArray

from variantgen.figure.drawing import THIN, Layer, Path
from variantgen.figure.ink import crosses
from variantgen.figure.placement.label_requests import Costs, LabelRequest, Places

GAP = 0.8  # free space around a label, u
TIGHT = 0.45  # free space that a label never gives up (half of a bold line), u
# Costs of ink under a label, of less than the wished free space, of two labels over each other, of two that stand side
# by side so near that they read as a product.
INK, CLOSE, _LABEL, _PRODUCT = 100.0, 3.0, 300.0, 15.0
_BESIDE = 2.4  # u
_SWEEPS = 4
_AWAY = complex(1e6, 1e6)  # far from all paper
_LEADER_GAP = 0.35  # between a leader and its label or the symbol, u


class LabelChoice(Struct):
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
        number = self.taken - self.near if self.ends.size else -1
        return _leader(self.request, self.place, complex(self.ends[number])) if number >= 0 else None

    @property
    def on_ink(self) -> bool:
        """Whether the chosen place is on a line, or as bad as that."""
        return bool(self.costs[self.taken] >= INK)


def resolve_overlaps(choices: Sequence[LabelChoice], first: Iterable[int]) -> set[int]:
    """Move labels that cover each other until none does; those with the fewest good places move first.

    Returns those that still do.
    """
    conflicts = pending = set(first)
    if not pending:
        return conflicts
    standing = _Standing(choices)
    least: dict[int, float] = {}
    for _ in range(_SWEEPS):
        before = [choice.taken for choice in choices]
        least |= {i: -float(np.minimum.reduce(choices[i].costs)) for i in pending if i not in least}
        for i in sorted(pending, key=lambda i: (least[i], i)):
            standing.move(i, choices[i])
        conflicts = standing.conflicts()
        # A label that could be led to, but still lies on a line, tries again in view of what has moved.
        stuck = {i for i, choice in enumerate(choices) if choice.ends.size and choice.on_ink}
        done, pending = pending, conflicts | stuck
        # Who has not moved would not do so in view of the same places.
        if not pending or (pending <= done and before == [choice.taken for choice in choices]):
            break
    return conflicts


def conflicting(places: Places, boxes: Costs, figure: NDArray[np.intp] | None = None) -> list[int]:
    """The numbers of labels that cover another one (of the same ``figure``) or read together with it.

    ``boxes`` are half width and half height, shape (labels, 2).
    """
    dx, dy = np.abs(places.real[:, None] - places.real), np.abs(places.imag[:, None] - places.imag)
    width, height = boxes[:, :1] + boxes[:, 0], boxes[:, 1:] + boxes[:, 1]
    dx -= width
    found = (dx < TIGHT) & (dy < height + TIGHT)
    found |= (dx < _BESIDE) & (dy < 0.35 * height)
    if figure is not None:
        found &= figure[:, None] == figure
    # Each lies over itself.
    result: list[int] = (np.add.reduce(found, axis=0) > 1).nonzero()[0].tolist()
    return result


class _Standing:
    """Where all labels stand now: their places, boxes and leaders."""

    def __init__(self, choices: Sequence[LabelChoice]) -> None:
        self._places = np.array([choice.place for choice in choices])
        self._boxes = np.array([choice.request.box for choice in choices])
        self._leaders = [choice.leader for choice in choices]

    def conflicts(self) -> set[int]:
        """The numbers of labels that cover another one or read together with it."""
        return set(conflicting(self._places, self._boxes))

    def move(self, i: int, choice: LabelChoice) -> None:
        """Move a label to the candidate that costs least in view of the others."""
        self._places[i], self._leaders[i] = _AWAY, None
        choice.take(self._best(choice))
        self._places[i], self._leaders[i] = choice.place, choice.leader

    def _best(self, own: LabelChoice) -> int:
        """The candidate of a label that costs least in view of what stands."""
        costs: Costs = own.costs + self._overlaps(own)
        best = int(costs.argmin())
        # What its own leaders would cross only matters where one is wanted.
        if best >= own.near:
            costs[own.near :] += self._crossed_by_leaders(own)
            best = int(costs.argmin())
        return best

    def _overlaps(self, own: LabelChoice) -> Costs:
        """Cost of the labels and leaders under each candidate of a label."""
        places = own.places
        half_width, half_height = own.request.box
        # Shape (labels, candidates).
        across = np.abs(places.imag - self._places.imag[:, None])
        dx = np.abs(places.real - self._places.real[:, None])
        dx -= self._boxes[:, :1] + half_width
        space = np.maximum(dx, across - (self._boxes[:, 1:] + half_height))
        # Letters side by side on one line read as a product.
        product = dx < _BESIDE
        product &= across < 0.7 * half_height
        costs: Costs = _PRODUCT * np.add.reduce(product, axis=0)
        if (near := space < GAP).any():
            costs += CLOSE * np.add.reduce(near, axis=0) + _LABEL * np.add.reduce(space < TIGHT, axis=0)
        leaders = [leader.points for leader in self._leaders if leader]
        if leaders:
            starts, ends = np.array(leaders).T[..., None]
            ways = 0.5 * (ends - starts)
            crossed = crosses(starts + ways - places, ways, (half_width + TIGHT, half_height + TIGHT))
            costs += _LABEL * np.add.reduce(crossed, axis=0)
        return costs

    def _crossed_by_leaders(self, own: LabelChoice) -> Costs:
        """Cost of the labels that the leaders of a label would cross."""
        boxes = self._boxes + TIGHT
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
