"""What of a mechanism is drawn in a figure of one body: the body itself and stubs of what is joined to it."""

from __future__ import annotations

import math
from collections.abc import Iterator, Sequence
from functools import cached_property
from itertools import chain, combinations, compress

import numpy as np
from msgspec import Struct
from numpy.typing import NDArray

from variantgen.figure.drawing import THIN, Arc, Line, Path, Strokes
from variantgen.figure.ink import corners_of, spaced

STUB = 8.5  # how much of what is joined to the body at a point is drawn, u
_NEAR = 1.7  # half the width of a bar, and what lies on it, u
_JOINED = 4.5  # how near to a point what is joined to it there comes, u: the guide below a slider
_LEAST = 6.0  # a shorter piece of a line away from all points only crosses the body, u
_ACROSS = 0.8  # so does one with its ends on both sides of a bar or a rim, as far from it, u
_SMALL = 3.0  # radius of circles that are symbols, u
_STEP = 0.35  # between the places of a line that are looked at, u
_MOST = 4000  # of them
_SAGITTA = 0.05
_LIGHTER = 0.6  # lines of the mechanism in proportion to those of the statement

Places = NDArray[np.complex128]


class Surroundings(Struct, frozen=True, dict=True):
    """The places (u) near the ``points`` of a body, near the bars between its ``members`` and its ``rims``.

    What is nearer to one of the ``others``, the points that are not drawn, is its symbol or its part of a link.
    """

    points: tuple[complex, ...]
    members: tuple[tuple[complex, ...], ...]
    rims: tuple[tuple[complex, float], ...]
    others: tuple[complex, ...] = ()

    def extent(self) -> list[complex]:
        """Places on the outline of what is drawn."""
        found = [*self.points, *(place for member in self.members for place in member)]
        return found + [c + r * way for c, r in self.rims for way in (1, 1j, -1, -1j)]

    def names(self, own: Sequence[complex]) -> bool:
        """Whether a label that names these places belongs to what is drawn: most of them lie there."""
        return 2 * sum(map(self._is_inside, own)) > len(own)

    def pieces(self, lines: Sequence[Line]) -> Iterator[Line]:
        """What of lines lies in the surroundings, in their order, lighter than in the figure of a statement."""
        seen = [line for line in lines if not self._misses(line)]
        if not seen:
            return
        outlines = [_outline(line) for line in seen]
        corners, ends = np.array([*chain(*outlines)], dtype=complex), np.cumsum([len(outline) for outline in outlines])
        steps = np.zeros_like(corners)
        steps[:-1] = corners[1:] - corners[:-1]
        steps[ends - 1] = 0.0
        counts = np.maximum(1, np.minimum(np.ceil(np.abs(steps) / _STEP), _MOST)).astype(int)
        # All places that are looked at, those of all lines in a row; where the corners are among them.
        places, at = spaced(corners, steps, counts), np.cumsum(counts) - counts
        first_corners = [0, *ends[:-1].tolist()]
        starts = at[first_corners]
        gaps, to_others = _squares(places, self.points), _squares(places, self.others)
        foreign = np.minimum.reduce(to_others, axis=0, initial=STUB**2)
        near, on_bodies = gaps <= foreign, self._on_bodies(places)
        anywhere = np.logical_or.reduce(near, axis=0)
        # A long line passes by the points that it is not joined to.
        joined = np.minimum.reduceat(gaps, starts, axis=1) <= _JOINED**2
        joined |= np.logical_and.reduceat(anywhere, starts)
        lengths = [*(starts[1:] - starts[:-1]).tolist(), len(places) - starts[-1]]
        close = np.logical_or.reduce(near & joined.repeat(lengths, axis=1), axis=0)
        inside = close | on_bodies
        whole = np.logical_and.reduceat(inside, starts) & np.logical_or.reduceat(close, starts)
        filled = np.logical_and.reduceat((anywhere | on_bodies)[at], first_corners)
        spans = zip(first_corners, ends.tolist(), whole.tolist(), filled.tolist(), strict=True)
        for line, outline, (first, end, is_whole, is_filled) in zip(seen, outlines, spans, strict=True):
            if isinstance(line, Strokes):
                yield from self._strokes(line, places[at[first:end]], close[at[first:end]])
            elif line.fill and is_filled:
                yield line._replace(weight=_light(line))
            elif is_whole and len(set(outline)) > 1 and not self._is_foreign(line):
                yield _lighter(line, outline)
            else:
                own = slice(at[first], at[end - 1] + 1)
                seen_there = close if self._is_foreign(line) else inside
                yield from self._kept(line, places[own], at[first:end] - at[first], close[own], seen_there[own])

    @cached_property
    def _box(self) -> tuple[complex, complex]:
        """Lower left and upper right corner of what is drawn."""
        low, high = corners_about(self.extent())
        return low - STUB * (1 + 1j), high + STUB * (1 + 1j)

    def _misses(self, line: Line) -> bool:
        """Whether a line lies far from everything (or is too short to be seen)."""
        low, high = self._box
        if isinstance(line, Arc):
            ends = [line.centre + line.radius * way for way in (1 + 1j, -1 - 1j)]
        else:
            ends = list(line.points) if isinstance(line, Path) else list(chain.from_iterable(line.segments))
            first = ends[0]
            if low.real <= first.real <= high.real and low.imag <= first.imag <= high.imag:
                return False
        x, y = [place.real for place in ends], [place.imag for place in ends]
        return max(x) < low.real or min(x) > high.real or max(y) < low.imag or min(y) > high.imag

    def _is_inside(self, place: complex) -> bool:
        """Whether a place is a point, or lies on a body."""
        if any(abs(place - point) <= 1.0 for point in self.points):
            return True
        if any(abs(abs(place - centre) - radius) <= _NEAR for centre, radius in self.rims):
            return True
        return any(_is_beside(place, *ends) for member in self.members for ends in combinations(member, 2))

    def _strokes(self, line: Strokes, middles: Places, close: NDArray[np.bool_]) -> Iterator[Line]:
        """Those of the strokes with these middles that lie near points, or behind what the body rolls on."""
        kept = (close | self._on_rims(middles)).tolist()
        if any(kept):
            yield Strokes(tuple(compress(line.segments, kept)), line.layer, _light(line))

    def _kept(
        self,
        line: Path | Arc,
        places: Places,
        corners: NDArray[np.intp],
        close: NDArray[np.bool_],
        inside: NDArray[np.bool_],
    ) -> Iterator[Line]:
        """What is drawn of a line that has its ``corners`` at these numbers of its ``places``."""
        edges = (np.flatnonzero(inside[1:] != inside[:-1]) + 1).tolist()
        edges = [*([0] if inside[0] else []), *edges, *([len(inside)] if inside[-1] else [])]
        for first, after in zip(edges[::2], edges[1::2], strict=True):
            last = after - 1
            length = float(np.abs(places[first + 1 : after] - places[first:last]).sum())
            if close[first:after].any():
                is_seen = length > 0
            else:
                is_seen = length > _LEAST and not self._crossed(*places[[first, (first + last) // 2, last]].tolist())
            if not is_seen:
                continue
            within = corners[(corners > first) & (corners < last)]
            run = places[np.concatenate(([first], within, [last]))]
            yield _lighter(line, run.tolist())

    def _is_foreign(self, line: Line) -> bool:
        """Whether a line is the rim of another body."""
        if not isinstance(line, Arc) or not line.full or line.radius < _SMALL:
            return False
        return all(abs(line.centre - centre) > _NEAR for centre, _ in self.rims)

    def _crossed(self, first: complex, middle: complex, last: complex) -> bool:
        """Whether a line with these places on it leads from one side of a bar or a rim to the other."""
        sides = [
            (abs(first - centre) - radius, abs(last - centre) - radius)
            for centre, radius in self.rims
            if abs(abs(middle - centre) - radius) <= _NEAR
        ]
        for start, end in (ends for member in self.members for ends in combinations(member, 2) if ends[0] != ends[1]):
            way = (end - start) / abs(end - start)
            part = (middle - start) / way
            if abs(part.imag) <= _NEAR and 0 <= part.real <= abs(end - start):
                sides.append((((first - start) / way).imag, ((last - start) / way).imag))
        return any(low * high < 0 and min(abs(low), abs(high)) > _ACROSS for low, high in sides)

    def _on_rims(self, places: Places) -> NDArray[np.bool_]:
        found = np.zeros(len(places), dtype=bool)
        for centre, radius in self.rims:
            found |= np.abs(np.abs(places - centre) - radius) <= _NEAR
        return found

    def _on_bodies(self, places: Places) -> NDArray[np.bool_]:
        found = self._on_rims(places)
        for member in self.members:
            if len(member) > 1:
                ends = np.array(list(combinations(member, 2)), dtype=complex)
                found |= (squares_to_segments(places, ends[:, :1], ends[:, 1:]) <= _NEAR**2).any(axis=0)
        return found


def _light(line: Line) -> float:
    """The weight of a line of the mechanism."""
    if line.weight == 0:
        return 0.0
    return THIN if line.weight <= THIN else max(THIN, _LIGHTER * line.weight)


def _lighter(line: Path | Arc, run: Sequence[complex]) -> Line:
    """What of a line leads from one of these places to the next."""
    if isinstance(line, Arc) and line.full and len(run) > 2 and abs(run[0] - run[-1]) < 1e-9:
        return line._replace(weight=_light(line))
    return Path(tuple(run), line.layer, _light(line), dash=line.dash)


def _outline(line: Line) -> list[complex]:
    """The corners of a line in a row; of strokes their middles, each for itself."""
    if isinstance(line, Strokes):
        return [0.5 * (start + end) for start, end in line.segments]
    return corners_of(line, _SAGITTA)


def _squares(places: Places, points: Sequence[complex]) -> NDArray[np.float64]:
    """The squares of the distances of places of shape (N,) from points, shape (P, N)."""
    steps = places - np.array(points, dtype=complex)[:, None]
    found: NDArray[np.float64] = steps.real**2 + steps.imag**2
    return found


def squares_to_segments(places: Places, starts: Places, ends: Places) -> NDArray[np.float64]:
    """The squares of the distances from places to segments between ends, whose shapes go together.

    Places of shape (N,) and ends of shape (S, 1) give (S, N).
    """
    ways = ends - starts
    squares = ways.real**2 + ways.imag**2
    x, y = places.real - starts.real, places.imag - starts.imag
    part = (x * ways.real + y * ways.imag) / np.where(squares > 1e-18, squares, 1.0)
    np.minimum(np.maximum(part, 0.0, out=part), 1.0, out=part)
    x -= part * ways.real
    y -= part * ways.imag
    found: NDArray[np.float64] = x * x + y * y
    return found


def _is_beside(place: complex, start: complex, end: complex) -> bool:
    """Whether a place lies on the bar between two ends."""
    way = end - start
    square = way.real**2 + way.imag**2
    part = ((place - start) * way.conjugate()).real / square if square > 1e-18 else 0.0
    return abs(place - start - min(max(part, 0.0), 1.0) * way) <= _NEAR


def corners_about(places: Sequence[complex]) -> tuple[complex, complex]:
    """Lower left and upper right corner of the box about places."""
    x, y = [p.real for p in places], [p.imag for p in places]
    return complex(min(x), min(y)), complex(max(x), max(y))


def size_of(extent: Sequence[complex]) -> complex:
    """Width and height of the box about places."""
    if not extent:
        return 0j
    low, high = corners_about(extent)
    return high - low


def largest(extent: Sequence[complex], width: float, height: float) -> float:
    """In what proportion places may be enlarged so that they fit into a box."""
    size = size_of(extent)
    return min(width / size.real if size.real else math.inf, height / size.imag if size.imag else math.inf)
