"""Where the ink of a figure is: straight segments that follow its lines."""

from __future__ import annotations

import math
from functools import cache
from itertools import pairwise

import numpy as np
from numpy.typing import NDArray

from variantgen.figure.drawing import Line, Path, Strokes

Segments = NDArray[np.complex128]
Spans = NDArray[np.float64]
Sides = float | NDArray[np.float64]
_SAGITTA = 0.04  # how far the chords of an arc may stay inside it, u


def segments_of(line: Line, sagitta: float = _SAGITTA) -> list[tuple[complex, complex]]:
    """Segments along a line; those of an arc stay within ``sagitta`` (u) of it."""
    if isinstance(line, Strokes):
        return list(line.segments)
    if isinstance(line, Path):
        return list(pairwise((*line.points, line.points[0]) if line.closed else line.points))
    step = 2 * math.acos(max(0.0, 1 - sagitta / max(line.radius, sagitta)))
    count = max(2, math.ceil(abs(line.sweep) / step))
    return list(pairwise((line.centre + line.radius * _directions(line.start, line.sweep, count)).tolist()))


def spaced(starts: Segments, steps: Segments, counts: NDArray[np.intp]) -> Segments:
    """Places at equal distances on segments, so many on each, from its start and without its end, shape (P,)."""
    ends = counts.cumsum()
    part = np.arange(ends[-1]) - (ends - counts).repeat(counts)
    result: Segments = starts.repeat(counts) + part / counts.repeat(counts) * steps.repeat(counts)
    return result


def _directions(start: float, sweep: float, count: int) -> NDArray[np.complex128]:
    """Unit vectors along an arc, at the ends of its parts."""
    if start == 0 and sweep == math.tau:
        return _around(count)
    result: NDArray[np.complex128] = np.exp(1j * (start + sweep / count * np.arange(count + 1)))
    return result


@cache
def _around(count: int) -> NDArray[np.complex128]:
    """Unit vectors around a circle."""
    result: NDArray[np.complex128] = np.exp(1j * (math.tau / count * np.arange(count + 1)))
    return result


def boxes_crossed(
    places: NDArray[np.complex128], half_sides: tuple[Sides, Sides], segments: Segments
) -> NDArray[np.int64]:
    """Number of segments that cross the box about each place (separating axes of box and segment), shape (P,).

    The half sides are the same for all boxes or arrays of shape (P, 1).
    """
    return boxes_crossed_by(spans_of(segments), places, half_sides)


def spans_of(segments: Segments) -> Spans:
    """What of segments is compared with boxes: x and y of the middles and of the halves, sizes of these; (6, S)."""
    middle, half = 0.5 * (segments[:, 0] + segments[:, 1]), 0.5 * (segments[:, 1] - segments[:, 0])
    return np.array([middle.real, middle.imag, half.real, half.imag, np.abs(half.real), np.abs(half.imag)])


def boxes_crossed_by(
    spans: Spans, places: NDArray[np.complex128], half_sides: tuple[Sides, Sides]
) -> NDArray[np.int64]:
    """Number of segments that cross the box about each place, shape (P,).

    The same as :func:`boxes_crossed` for segments that are asked again and again: ``spans`` are :func:`spans_of` them.
    """
    hx, hy = half_sides
    middle_x, middle_y, way_x, way_y, dx, dy = spans
    x, y = middle_x - places.real[:, None], middle_y - places.imag[:, None]
    near = np.abs(x) <= hx + dx
    near &= np.abs(y) <= hy + dy
    # Few segments are near a box: only of them it is asked on which side of its corners they pass.
    at = near.ravel().nonzero()[0]
    if not at.size:
        return np.zeros(len(places), dtype=np.int64)
    box, line = np.divmod(at, len(dx))
    half_width = (hx * dy + hy * dx)[..., line] if isinstance(hx, float) else (hx * dy + hy * dx).ravel()[at]
    passed = np.abs(way_x[line] * y.ravel()[at] - way_y[line] * x.ravel()[at]) <= half_width
    result: NDArray[np.int64] = np.bincount(box[passed], minlength=len(places))
    return result


def crosses(
    middle: NDArray[np.complex128], half: NDArray[np.complex128], half_sides: tuple[Sides, Sides]
) -> NDArray[np.bool_]:
    """Which segments (middle from the centre of the box, half their vector) cross a box; shapes broadcast."""
    hx, hy = half_sides
    dx, dy = np.abs(half.real), np.abs(half.imag)
    crossing = (np.abs(middle.real) <= hx + dx) & (np.abs(middle.imag) <= hy + dy)
    result: NDArray[np.bool_] = crossing & (
        np.abs(half.real * middle.imag - half.imag * middle.real) <= hx * dy + hy * dx
    )
    return result


def gaps_to_box(
    place: complex | NDArray[np.complex128], half_sides: tuple[Sides, Sides], segments: Segments
) -> NDArray[np.float64]:
    """Distance of each segment from a box (zero where they cross), shape (S,).

    Of several boxes at once with places and half sides of the shape (P, 1): shape (P, S).
    """
    hx, hy = half_sides
    start, end = segments[:, 0] - place, segments[:, 1] - place
    step = end - start
    # Ends of the segments to the box, corners of the box to the segments: the nearest pair is one of these.
    ends = np.array((start, end))
    outside = np.hypot(np.maximum(np.abs(ends.real) - hx, 0), np.maximum(np.abs(ends.imag) - hy, 0)).min(axis=0)
    square = step.real**2 + step.imag**2
    corners = np.array([hx + 1j * hy, hx - 1j * hy, -hx + 1j * hy, -hx - 1j * hy])
    from_corners = start - (corners if corners.ndim > 1 else corners[:, None])
    part = -(from_corners * np.conj(step)).real / np.where(square > 0, square, 1.0)
    gaps = np.minimum(outside, np.abs(from_corners + np.minimum(np.maximum(part, 0), 1) * step).min(axis=0))
    return np.where(crosses(0.5 * (start + end), 0.5 * step, half_sides), 0.0, gaps)
