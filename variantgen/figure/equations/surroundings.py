"""What of a mechanism is drawn in a figure of one body: the body itself and stubs of what is joined to it."""

from __future__ import annotations

import math
from collections.abc import Iterable, Iterator, Sequence
from dataclasses import dataclass
from itertools import combinations

import numpy as np
from numpy.typing import NDArray

from variantgen.figure.drawing import THIN, Arc, Line, Path, Strokes
from variantgen.figure.ink import segments_of

STUB = 8.5  # how much of what is joined to the body at a point is drawn, u
_NEAR = 1.7  # half the width of a bar, and what lies on it, u
_JOINED = 4.5  # how near to a point what is joined to it there comes, u: the guide below a slider
_LEAST = 6.0  # a shorter piece of a line away from all points only crosses the body, u
_STEP = 0.35  # between the places of a line that are looked at, u
_MOST = 4000  # of them
_SAGITTA = 0.05
_LIGHTER = 0.6  # lines of the mechanism in proportion to those of the statement

Places = NDArray[np.complex128]


@dataclass(frozen=True)
class Surroundings:
    """The places (u) near the ``points`` of a body, near the bars between its ``members`` and its ``rims``."""

    points: tuple[complex, ...]
    members: tuple[tuple[complex, ...], ...]
    rims: tuple[tuple[complex, float], ...]

    def extent(self) -> list[complex]:
        """Places on the outline of what is drawn."""
        found = [*self.points, *(place for member in self.members for place in member)]
        return found + [c + r * way for c, r in self.rims for way in (1, 1j, -1, -1j)]

    def names(self, own: Iterable[complex]) -> bool:
        """Whether a label that names one of these places belongs to what is drawn."""
        places = np.array(list(own), dtype=complex)
        return bool(np.mean(self._at_points(places, 1.0) | self._on_bodies(places)) > 0.5)

    def pieces(self, line: Line) -> Iterator[Line]:
        """What of a line lies in the surroundings, lighter than in the figure of a statement."""
        light = THIN if line.weight <= THIN else max(THIN, _LIGHTER * line.weight)
        light = 0.0 if line.weight == 0 else light
        if isinstance(line, Strokes):
            middles = np.array([0.5 * (start + end) for start, end in line.segments], dtype=complex)
            kept = self._at_points(middles, STUB)
            if not kept.all():
                kept &= self._near_joined(middles)
            if kept.any():
                yield Strokes(tuple(s for s, near in zip(line.segments, kept, strict=True) if near), line.layer, light)
            return
        chords = np.array(segments_of(line, _SAGITTA), dtype=complex)
        if self._misses(chords):
            return
        filled = bool(line.fill)
        if filled and bool(np.all(self._is_inside(chords[:, 0]))):
            yield line._replace(weight=light)
            return
        outline = np.append(chords[:, 0], chords[-1, 1])
        for run in self._runs(outline):
            if isinstance(line, Arc) and line.full and len(run) > 2 and abs(run[0] - run[-1]) < 1e-9:
                yield line._replace(weight=light)
            else:
                yield Path(tuple(run.tolist()), line.layer, light, dash=line.dash)

    def _misses(self, chords: Places) -> bool:
        """Whether lines lie far from everything (or are too short to be seen)."""
        outline = self.extent()
        low = complex(min(p.real for p in outline), min(p.imag for p in outline)) - STUB * (1 + 1j)
        high = complex(max(p.real for p in outline), max(p.imag for p in outline)) + STUB * (1 + 1j)
        return bool(
            np.max(chords.real) < low.real
            or np.min(chords.real) > high.real
            or np.max(chords.imag) < low.imag
            or np.min(chords.imag) > high.imag
        )

    def _runs(self, outline: Places) -> Iterator[Places]:
        """The runs of an outline that are drawn: corners and ends."""
        steps = np.abs(np.diff(outline))
        total = float(np.sum(steps))
        step = max(_STEP, total / _MOST)
        counts = np.maximum(1, np.ceil(steps / step)).astype(int)
        corners = np.concatenate(([0], np.cumsum(counts)))
        places = np.concatenate(
            [
                start + (end - start) * np.arange(n) / n
                for start, end, n in zip(outline, outline[1:], counts, strict=False)
            ]
            + [outline[-1:]]
        )
        close, on_bodies = self._at_points(places, STUB), self._on_bodies(places)
        if not close.all():
            close &= self._near_joined(places)
        inside = close | on_bodies
        edges = np.flatnonzero(np.diff(np.concatenate(([0], inside.astype(int), [0]))))
        for first, last in zip(edges[::2], edges[1::2] - 1, strict=True):
            length = float(np.sum(np.abs(np.diff(places[first : last + 1]))))
            if length > _LEAST or (close[first : last + 1].any() and length > 0):
                within = corners[(corners > first) & (corners < last)]
                yield places[np.concatenate(([first], within, [last]))]

    def _is_inside(self, places: Places) -> NDArray[np.bool_]:
        return self._at_points(places, STUB) | self._on_bodies(places)

    def _at_points(self, places: Places, within: float) -> NDArray[np.bool_]:
        own = np.array(self.points, dtype=complex)
        found: NDArray[np.bool_] = np.any(np.abs(places[:, None] - own) <= within, axis=1)
        return found

    def _near_joined(self, places: Places) -> NDArray[np.bool_]:
        """Which places of a long line are near a point that the line is joined to: it passes by the others."""
        gaps = np.abs(places[:, None] - np.array(self.points, dtype=complex))
        found: NDArray[np.bool_] = np.any((gaps <= STUB) & (gaps.min(axis=0) <= _JOINED), axis=1)
        return found

    def _on_bodies(self, places: Places) -> NDArray[np.bool_]:
        found = np.zeros(len(places), dtype=bool)
        for centre, radius in self.rims:
            found |= np.abs(np.abs(places - centre) - radius) <= _NEAR
        for member in self.members:
            for start, end in combinations(member, 2):
                found |= distance_to_segment(places, start, end) <= _NEAR
        return found


def distance_to_segment(places: Places, start: complex, end: complex) -> NDArray[np.float64]:
    """Distances from places of shape (N,) to a segment, shape (N,)."""
    way = end - start
    if abs(way) < 1e-9:
        return np.abs(places - start)
    part = np.clip(((places - start) * way.conjugate()).real / abs(way) ** 2, 0.0, 1.0)
    found: NDArray[np.float64] = np.abs(places - start - part * way)
    return found


def size_of(extent: Sequence[complex]) -> complex:
    """Width and height of the box about places."""
    x, y = [p.real for p in extent], [p.imag for p in extent]
    return complex(max(x) - min(x), max(y) - min(y)) if extent else 0j


def largest(extent: Sequence[complex], width: float, height: float) -> float:
    """In what proportion places may be enlarged so that they fit into a box."""
    size = size_of(extent)
    return min(width / size.real if size.real else math.inf, height / size.imag if size.imag else math.inf)
