"""Distinct variants for any number of students, however their draws were split.

Everyone has a sequence of draws of their own and a priority. In the order of priority each takes the first of their own
draws that nobody before has, and that is not nearly the same as one that somebody before in the same group has
(:mod:`variantgen.variants.similarity`). Where the ranges leave no room for the second demand, only the first is met.
"""

from __future__ import annotations

from collections.abc import Callable, Iterator, Sequence
from typing import Any

import numpy as np
from msgspec import Struct
from numpy.typing import NDArray

from variantgen.variants.similarity import Traits

TRIES = 10  # draws in which somebody looks for data that are not nearly those of another
# With more near neighbours than this, on average, there is no room to keep the variants of a group apart.
_CROWD = 12.0
_FEW = 10_000  # places that are compared along a line; of more, a tree finds the near ones sooner
_COUNTED = 10_000  # places whose near ones are counted together
_LIMIT = 1.0 + 1e-4  # of single precision
_NO_PAIRS = np.empty((0, 2), dtype=np.intp)

# The next draw of some owners after the attempts that they have used: (owners, attempts) -> traits.
More = Callable[[Sequence[int], Sequence[int]], Traits]


class DistinctDraws(Struct, frozen=True):
    """Who has to take another than their first draw, and by which attempt; who has nearly the same data as another."""

    again: dict[int, int]
    alike: tuple[int, ...]


class TooFewError(Exception):
    """There are fewer distinct variants than owners; ``owner`` is one who found none."""

    def __init__(self, owner: int, owners: Sequence[int], identities: NDArray[np.uint64]) -> None:
        super().__init__(owner)
        self.owner, self._owners, self._identities = owner, owners, identities

    def found(self, counts: Callable[[int], bool]) -> int:
        """The number of distinct variants that the owners with ``counts`` true have seen."""
        own = [counts(owner) for owner in self._owners]
        return int(np.unique(self._identities[np.array(own)]).size)


def assign_distinct(first: Traits, priority: Callable[[int], bytes], more: More, kept: int = 0) -> DistinctDraws:
    """Give everyone a draw, from the first draw of each owner 0 .. N-1. Raises TooFewError.

    The last ``kept`` of them keep theirs, whatever it is.
    """
    pool = _Pool(first, priority, kept)
    idle = seen = 0
    while wanting := pool.choose():
        before, seen = seen, pool.contested
        idle = 0 if seen > before else idle + len(wanting)
        # One unseen variant among n is missed by 20 n draws with a probability of 2e-9.
        if idle > 100 + 20 * seen:
            raise pool.too_few(wanting[0])
        pool.add(wanting, more(wanting, [pool.used(owner) for owner in wanting]))
    return pool.distinct()


class _Pool:
    """All draws so far, and which of them everyone takes."""

    def __init__(self, first: Traits, priority: Callable[[int], bytes], kept: int) -> None:
        self.traits = first
        self._count = len(first)
        self._kept = range(self._count - kept, self._count)
        self._owner = list(range(self._count))
        self._more: dict[int, list[int]] = {}  # draws of owners with several, after their first
        self._priority = priority
        self._taken: dict[int, int] = {}
        self._alike: set[int] = set()  # owners who gave up looking
        self._crowds, self._near = _compared(first)
        self.contested = 0  # distinct variants that several want, or that somebody drew in vain

    def add(self, owners: Sequence[int], drawn: Traits) -> None:
        """One more draw of each of some owners."""
        for place, owner in enumerate(owners, start=len(self.traits)):
            self._more.setdefault(owner, []).append(place)
        self._owner += owners
        self.traits = Traits.joined([self.traits, drawn])
        self._near |= _near(self.traits, set(drawn.room.tolist()) - self._crowds)

    def used(self, owner: int) -> int:
        """The attempts that an owner has used."""
        return int(self.traits.attempt[self._draws(owner)[-1]])

    def too_few(self, owner: int) -> TooFewError:
        """The error for an owner who finds nothing."""
        return TooFewError(owner, self._owner, self.traits.identity)

    def distinct(self) -> DistinctDraws:
        """What was chosen."""
        again = {owner: int(self.traits.attempt[taken]) for owner, taken in self._taken.items() if taken != owner}
        everyone = range(self._kept.start if self._crowds else 0)
        crowded = {i for i in everyone if int(self.traits.room[self._taken.get(i, i)]) in self._crowds}
        return DistinctDraws(dict(sorted(again.items())), tuple(sorted(self._alike | crowded)))

    def choose(self) -> list[int]:
        """Choose for everyone; the owners for whom no draw is left, in order."""
        same = dict(_equal(self.traits.identity))
        near = self._near
        self._alike = set()
        # Whoever has one draw that nobody else wants takes it: nothing is to be decided.
        contested = {self._owner[i] for i in (*same, *near)} | self._more.keys()
        draws = [i for owner in contested for i in self._draws(owner)]
        self.contested = len(set(self.traits.identity[np.array(draws, dtype=int)].tolist()))
        held = set(self._kept)
        contested.difference_update(self._kept)
        wanting = []
        self._taken = {}
        for owner in sorted(contested, key=self._priority):
            draws = self._draws(owner)
            free = [i for i in draws if not any(other in held for other in same.get(i, ()))]
            apart = [i for i in free if not any(other in held for other in near.get(i, ()))]
            apart = [i for i in apart if i in draws[:TRIES]]
            if apart or (free and len(draws) >= TRIES):
                self._taken[owner] = (apart or free)[0]
                held.add(self._taken[owner])
                if not apart:
                    self._alike.add(owner)
            else:
                wanting.append(owner)
        return sorted(wanting)

    def _draws(self, owner: int) -> list[int]:
        return [owner, *self._more.get(owner, ())]


def _equal(keys: NDArray[np.uint64]) -> Iterator[tuple[int, list[int]]]:
    """For each place that has the same key as others all the places with that key."""
    for members in _runs(keys):
        listed = members.tolist()
        yield from ((i, listed) for i in listed)


def _runs(keys: NDArray[np.uint64]) -> Iterator[NDArray[np.intp]]:
    """The places of each key that occurs more than once."""
    order = np.argsort(keys, kind="stable")
    _, starts, counts = np.unique(keys[order], return_index=True, return_counts=True)
    several = counts > 1
    for start, count in zip(starts[several], counts[several], strict=True):
        yield order[start : start + count]


def _compared(first: Traits) -> tuple[set[int], dict[int, list[int]]]:
    """The crowds, which are rooms in which the first draws lie too close together to be kept apart, and the near ones
    of each draw that has any in the other rooms.
    """
    crowds: set[int] = set()
    near: dict[int, list[int]] = {}
    for members in _runs(first.room):
        pairs = _pairs_unless_crowd(first.place[members])
        if pairs is None:
            crowds.add(int(first.room[members[0]]))
        else:
            _add_pairs(near, members[pairs])
    return crowds, near


def _near(found: Traits, rooms: set[int]) -> dict[int, list[int]]:
    """The near ones of each draw in some rooms that has any."""
    inside = np.isin(found.room, np.array(list(rooms), dtype=np.uint64)).nonzero()[0]
    near: dict[int, list[int]] = {}
    for members in _runs(found.room[inside]):
        _add_pairs(near, inside[members][_close_pairs(found.place[inside[members]])])
    return near


def _add_pairs(near: dict[int, list[int]], pairs: NDArray[np.intp]) -> None:
    """Note pairs, shape (P, 2), for both of each."""
    for a, b in pairs.tolist():
        near.setdefault(a, []).append(b)
        near.setdefault(b, []).append(a)


def _pairs_unless_crowd(places: NDArray[np.float32]) -> NDArray[np.intp] | None:
    """The close pairs of places, or nothing if they have more near ones than :data:`_CROWD` on average: then not all
    are looked for.
    """
    most, found = _CROWD * len(places), 0
    if len(places) <= _FEW:
        pairs = [_NO_PAIRS]
        for some in _pairs_along_line(places):
            pairs.append(some)
            found += 2 * len(some)
            if found > most:
                return None
        return np.concatenate(pairs)
    tree = _tree(places)
    for start in range(0, len(places), _COUNTED):
        own = places[start : start + _COUNTED]
        found += int(tree.query_ball_point(own, _LIMIT, p=np.inf, return_length=True).sum()) - len(own)
        if found > most:
            return None
    return _pairs_of_tree(tree)


def _close_pairs(places: NDArray[np.float32]) -> NDArray[np.intp]:
    """Pairs of places, shape (P, 2), that differ by at most 1 in every coordinate."""
    if len(places) > _FEW:
        return _pairs_of_tree(_tree(places))
    return np.concatenate([_NO_PAIRS, *_pairs_along_line(places)])


def _pairs_along_line(places: NDArray[np.float32]) -> Iterator[NDArray[np.intp]]:
    """The close pairs, shape (P, 2), in the order of the widest coordinate: next neighbours, next but one and so on."""
    if not places.shape[1]:
        places = np.zeros((len(places), 1), dtype=np.float32)
    wide = np.argsort(-np.ptp(places, axis=0))
    order = np.argsort(places[:, wide[0]], kind="stable")
    line = places[order][:, wide].astype(np.float64)
    behind = np.searchsorted(line[:, 0], line[:, 0] + _LIMIT, side="right")
    second = line[:, min(1, len(wide) - 1)].copy()
    for step in range(1, int((behind - np.arange(len(line))).max())):
        # Few are close in the second coordinate too: only of them all others are compared.
        first = (np.abs(second[step:] - second[:-step]) <= _LIMIT).nonzero()[0]
        first = first[(np.abs(line[first + step] - line[first]) <= _LIMIT).all(axis=1)]
        yield np.stack((order[first], order[first + step]), axis=1)


def _pairs_of_tree(tree: Any) -> NDArray[np.intp]:
    return np.asarray(tree.query_pairs(_LIMIT, p=np.inf, output_type="ndarray"))


def _tree(places: NDArray[np.float32]) -> Any:
    from scipy.spatial import cKDTree  # for large rooms only: the import takes as long as ten sheets

    return cKDTree(places)
