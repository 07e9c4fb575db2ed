"""The shortest way between two points along segments of known length and direction."""

from __future__ import annotations

import heapq
from collections.abc import Iterator, Mapping
from itertools import pairwise
from typing import Protocol

from variantgen.methods.geometry.legs import Leg
from variantgen.methods.geometry.located_point import ORIGIN, LocatedPoint
from variantgen.methods.linkage.problem import Task

# What a segment costs: itself, a length and a direction that have still to be worked out, a system of equations, an end
# that the figure does not show, so that the text should not name it.
_SEGMENT, _LENGTH, _DIRECTION, _SYSTEM, _UNSEEN = 1, 2, 4, 8, 5


class KnownSegments(Protocol):
    """The known segments between points (:class:`variantgen.methods.geometry.geometry.Geometry`)."""

    task: Task

    def legs_to(self, point: str, start: str) -> tuple[Leg, ...]:
        """The way to a point from one before it."""

    def has_coordinates(self, *points: str) -> bool:
        """Whether coordinates are worked out."""

    def has_direction(self, start: str, end: str) -> bool:
        """Whether a direction is given or worked out."""

    def has_length(self, start: str, end: str) -> bool:
        """Whether a length is given or worked out."""


class ShortestPaths:
    """Ways over points; ``places`` are in the order in which they can be placed."""

    def __init__(self, geometry: KnownSegments, places: Mapping[str, LocatedPoint]) -> None:
        self._geometry = geometry
        self._places = places
        self.rank = {name: i for i, name in enumerate((ORIGIN, *places))}

    def legs(self, start: str, end: str, before: str = "") -> list[Leg]:
        """The legs of the cheapest way, over points placed ``before`` another one if that is named.

        Raises LookupError where there is none.
        """
        limit = self.rank[before] if before else max(self.rank[start], self.rank[end]) + 1
        path = self._path(start, end, limit)
        return [leg for one, two in pairwise(path) for leg in self._step(one, two)]

    def _step(self, one: str, two: str) -> Iterator[Leg]:
        if self.rank[one] < self.rank[two]:
            yield from self._geometry.legs_to(two, one)
        else:
            yield from (leg.reversed() for leg in self._geometry.legs_to(one, two))

    def _path(self, start: str, end: str, limit: int) -> list[str]:
        """Points of the cheapest way (Dijkstra)."""
        edges = self._edges(limit)
        waiting: list[tuple[int, int, list[str]]] = [(0, 0, [start])]
        done: set[str] = set()
        count = 0
        while waiting:
            cost, _, path = heapq.heappop(waiting)
            here = path[-1]
            if here == end:
                return path
            if here in done:
                continue
            done.add(here)
            for there, price in edges.get(here, ()):
                count += 1
                heapq.heappush(waiting, (cost + price, count, [*path, there]))
        raise LookupError(f"no way from {start} to {end}")

    def _edges(self, limit: int) -> dict[str, list[tuple[str, int]]]:
        found: dict[str, list[tuple[str, int]]] = {}
        for name, place in self._places.items():
            if self.rank[name] >= limit:
                continue
            for other in self._from(name, place):
                price = self._price(name, other)
                found.setdefault(name, []).append((other, price))
                found.setdefault(other, []).append((name, price))
        return found

    def _from(self, name: str, place: LocatedPoint) -> list[str]:
        """Neighbours that were placed before, the plainest first; the origin too, once coordinates are known."""
        others = [other for other in place.neighbours() if self.rank[other] < self.rank[name]]
        return [*others, *([ORIGIN] if ORIGIN not in others and self._geometry.has_coordinates(name) else [])]

    def _price(self, name: str, other: str) -> int:
        geometry = self._geometry
        if other == ORIGIN:
            return _SYSTEM if self._places[name].in_system and not geometry.has_coordinates(name) else _SEGMENT
        known = geometry.has_direction(other, name), geometry.has_length(other, name)
        unseen = 0 if {name, other}.isdisjoint(geometry.task.form.figure.hidden) else _UNSEEN
        return _SEGMENT + unseen + (0 if known[0] else _DIRECTION) + (0 if known[1] else _LENGTH)
