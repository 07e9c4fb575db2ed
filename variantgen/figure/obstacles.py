"""What is drawn so far as obstacles: which lines cross boxes, circles, rays and lanes."""

from __future__ import annotations

from collections.abc import Sequence
from typing import Any, TypeAlias

import numpy as np
from msgspec import Struct, field
from msgspec.structs import replace
from numpy.typing import NDArray

from variantgen.figure.drawing import Arc, Path, Strokes
from variantgen.figure.ink import Sides, boxes_crossed_by, corners_of, spans_of

Outline: TypeAlias = Path | Arc | Strokes | Sequence[complex]
_SAGITTA = 0.12  # of the chords that stand for an arc, u


class Obstacles(Struct):
    """The segments of all lines of a sketch, in the order in which they were drawn; made when they are asked for."""

    _new: list[tuple[Outline, float]] = field(default_factory=list)  # with the weights of the lines, u
    _known: NDArray[np.complex128] = field(default_factory=lambda: np.zeros((0, 2), dtype=complex))
    _weights: list[float] = field(default_factory=list)  # of the lines of these segments, u
    _spans: NDArray[np.float64] = field(default_factory=lambda: np.zeros((6, 0)))

    def add(self, outline: Outline, weight: float) -> None:
        """Add the segments that follow a line, or from corner to corner of what stands for it."""
        self._new.append((outline, weight))

    def copied(self) -> Obstacles:
        """The same, to which others are added."""
        self.segments()
        return replace(self, _new=[], _weights=[*self._weights])

    def segments(self) -> NDArray[np.complex128]:
        """All segments, shape (S, 2)."""
        if self._new:
            starts: list[complex] = []
            ends: list[complex] = []
            for outline, weight in self._new:
                if isinstance(outline, Strokes):
                    starts += [start for start, _ in outline.segments]
                    ends += [end for _, end in outline.segments]
                else:
                    corners = corners_of(outline, _SAGITTA) if isinstance(outline, Path | Arc) else outline
                    starts += corners[:-1]
                    ends += corners[1:]
                self._weights += [weight] * (len(self._known) + len(starts) - len(self._weights))
            self._new.clear()
            self._known = np.concatenate((self._known, np.array((starts, ends), dtype=complex).T))
        return self._known

    def crossings(self, places: Sequence[complex] | NDArray[Any], half_sides: tuple[Sides, Sides]) -> NDArray[np.int64]:
        """How many of the lines drawn so far cross the box about each place, shape (P,)."""
        return boxes_crossed_by(self._spans_of_all(), np.asarray(places), half_sides)

    def _spans_of_all(self) -> NDArray[np.float64]:
        """What of all segments is compared with boxes."""
        segments = self.segments()
        if self._spans.shape[1] != len(segments):
            self._spans = np.concatenate((self._spans, spans_of(segments[self._spans.shape[1] :])), axis=1)
        return self._spans

    def met_near_circles(
        self, centre: complex, radii: NDArray[np.float64], margin: float
    ) -> tuple[NDArray[np.complex128], NDArray[np.intp]]:
        """Where lines come nearer than ``margin`` (u) to circles about a centre: directions (unit), which circle.

        Shape (K,) each. A place is where a line gets nearer or farther than that, or where a segment begins in between:
        so a line that runs along the circle (an arc about the same centre) is met too.
        """
        spans = self._spans_of_all()
        far, size = np.hypot(spans[0] - centre.real, spans[1] - centre.imag), np.hypot(spans[4], spans[5])
        least, most = min(radii.tolist()) - margin, max(radii.tolist()) + margin
        seen = ((far - size < most) & (far + size > least)).nonzero()[0]
        segments = self._known[seen] - centre
        start, step = segments[:, 0], segments[:, 1] - segments[:, 0]
        arm = np.abs(start)
        begun, begins = (np.abs(arm - radii[:, None]) < margin).nonzero()
        # |start + t step| = radius
        squares = np.concatenate((radii - margin, radii + margin)) ** 2
        a, b = step.real**2 + step.imag**2, start.real * step.real + start.imag * step.imag
        root = b * b - a * (arm * arm - squares[:, None])
        circle, line = ((root >= 0) & (a > 0)).nonzero()
        a, b, root = a[line], b[line], np.sqrt(root[circle, line])
        t = np.concatenate(((-b - root) / a, (-b + root) / a))
        on = ((t >= 0) & (t <= 1)).nonzero()[0]
        met = on % max(1, len(line))
        places = np.concatenate((start[line[met]] + t[on] * step[line[met]], start[begins]))
        return places / np.abs(places), np.concatenate((circle[met] % len(radii), begun))

    def weight_on_rays(
        self, centre: complex, angles: NDArray[np.float64], start: float, end: float
    ) -> NDArray[np.float64]:
        """Weights (u) of the lines that each ray from a centre crosses between two distances, shape (A,)."""
        segments = self.segments() - centre
        seen = np.abs(segments[:, 0]) - np.abs(segments[:, 1] - segments[:, 0]) < end
        first, second = segments[seen, 0], segments[seen, 1]
        way = np.exp(1j * angles)[:, None]
        # How far the ends are to the left of each ray; where the ray meets the line between them.
        low = way.real * first.imag - way.imag * first.real
        high = way.real * second.imag - way.imag * second.real
        over = (low <= 0) != (high <= 0)
        place = (first.real * second.imag - first.imag * second.real) / np.where(over, high - low, 1.0)
        over &= (place > start) & (place < end)
        result: NDArray[np.float64] = over @ np.array(self._weights)[seen]
        return result

    def seen_along(
        self, centre: complex, way: complex, far: float, further: Sequence[tuple[complex, complex]] = ()
    ) -> NDArray[np.complex128]:
        """The segments (and ``further`` ones) near a centre as seen from there in a direction (unit), shape (S, 2).

        The direction is their real axis; along it and aside they are not farther than ``far`` (u).
        """
        every = np.concatenate((self.segments(), np.array(further, dtype=complex).reshape(-1, 2)))
        local: NDArray[np.complex128] = (every - centre) * way.conjugate()
        middle, half = 0.5 * (local[:, 0] + local[:, 1]), 0.5 * (local[:, 1] - local[:, 0])
        near = np.abs(middle.real) - np.abs(half.real) < far
        near &= np.abs(middle.imag) - np.abs(half.imag) < far
        return local[near]


def lanes_met(
    lines: NDArray[np.complex128], lanes: NDArray[np.float64], half_widths: NDArray[np.float64]
) -> tuple[NDArray[np.float64], NDArray[np.float64]]:
    """From where to where segments (shape (S, 2)) run in each lane along the real axis, shape (L, S) each.

    A lane is the paper within a half width of a line parallel to the axis, which is moved to the left by ``lanes``;
    shape (L,) both. A line that is nowhere in a lane goes from infinity to minus infinity.
    """
    start, step = lines[:, 0], lines[:, 1] - lines[:, 0]
    rise = np.where(np.abs(step.imag) > 1e-9, step.imag, 1e-9)
    middle, half = (lanes[:, None] - start.imag) / rise, half_widths[:, None] / np.abs(rise)
    first, last = np.maximum(middle - half, 0.0), np.minimum(middle + half, 1.0)
    one, other = start.real + first * step.real, start.real + last * step.real
    within = first <= last
    return np.where(within, np.minimum(one, other), np.inf), np.where(within, np.maximum(one, other), -np.inf)
