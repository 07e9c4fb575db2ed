"""Where the ink of a figure is: straight segments that follow its lines."""

from __future__ import annotations

import cmath
import math
from collections.abc import Iterable
from functools import cache

import numpy as np
from numpy.typing import NDArray

from variantgen.figure.drawing import Arc, Line, Path, Strokes

Segments = NDArray[np.complex128]
Spans = NDArray[np.float64]
Sides = float | NDArray[np.float64]
_CORNERS = np.array([[1, 1, -1, -1], [1, -1, 1, -1]])  # signs of x and y at the corners of a box
_SAGITTA = 0.04  # how far the chords of an arc may stay inside it, u


def corners_of(line: Path | Arc, sagitta: float = _SAGITTA) -> list[complex]:
    """Where the segments that follow a line meet, and its ends; those of an arc stay within ``sagitta`` (u) of it."""
    if isinstance(line, Path):
        return [*line.points, line.points[0]] if line.closed else list(line.points)
    step = 2 * math.acos(max(0.0, 1 - sagitta / max(line.radius, sagitta)))
    count = max(2, math.ceil(abs(line.sweep) / step))
    centre, radius = line.centre, line.radius
    if line.start == 0 and line.sweep == math.tau:
        return [centre + radius * way for way in _around(count)]
    part = line.sweep / count
    return [centre + cmath.rect(radius, line.start + number * part) for number in range(count + 1)]


def segments_of(lines: Iterable[Line], sagitta: float = _SAGITTA) -> tuple[Segments, list[int]]:
    """The segments that follow lines, shape (S, 2), and how many each line has."""
    starts: list[complex] = []
    ends: list[complex] = []
    counts = []
    for line in lines:
        if isinstance(line, Strokes):
            starts += [start for start, _ in line.segments]
            ends += [end for _, end in line.segments]
            counts.append(len(line.segments))
        else:
            corners = corners_of(line, sagitta)
            starts += corners[:-1]
            ends += corners[1:]
            counts.append(len(corners) - 1)
    return np.array((starts, ends), dtype=complex).T, counts


def spaced(starts: Segments, steps: Segments, counts: NDArray[np.intp]) -> Segments:
    """Places at equal distances on segments, so many on each, from its start and without its end, shape (P,)."""
    ends = counts.cumsum()
    part = np.arange(ends[-1]) - (ends - counts).repeat(counts)
    result: Segments = starts.repeat(counts) + part / counts.repeat(counts) * steps.repeat(counts)
    return result


@cache
def _around(count: int) -> tuple[complex, ...]:
    """Unit vectors around a circle."""
    return tuple([cmath.rect(1.0, math.tau / count * number) for number in range(count + 1)])


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
    The half sides may also be given for each box and segment, shape (P, S).
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
    return _crossing(middle.real, middle.imag, half.real, half.imag, half_sides)


def _crossing(
    x: NDArray[np.float64],
    y: NDArray[np.float64],
    way_x: NDArray[np.float64],
    way_y: NDArray[np.float64],
    half_sides: tuple[Sides, Sides],
) -> NDArray[np.bool_]:
    """The same with plain numbers."""
    hx, hy = half_sides
    dx, dy = np.abs(way_x), np.abs(way_y)
    result: NDArray[np.bool_] = np.abs(x) <= hx + dx
    result &= np.abs(y) <= hy + dy
    result &= np.abs(way_x * y - way_y * x) <= hx * dy + hy * dx
    return result


def gaps_to_box(
    place: complex | NDArray[np.complex128], half_sides: tuple[Sides, Sides], segments: Segments
) -> NDArray[np.float64]:
    """Distance of each segment from a box (zero where they cross), shape (S,).

    Of several boxes at once, places and half sides have shapes that go with that of the segments but for its last axis:
    places of shape (P,) with segments of shape (S, P, 2) give gaps of shape (S, P).
    """
    hx, hy = half_sides
    start, end = segments[..., 0], segments[..., 1]
    start_x, start_y, end_x, end_y = start.real - place.real, start.imag - place.imag, end.real - place.real, end.imag - place.imag
    step_x, step_y = end_x - start_x, end_y - start_y
    # Ends of the segments to the box, corners of the box to the segments: the nearest pair is one of these.
    found = np.minimum(_square_to_box(start_x, start_y, hx, hy), _square_to_box(end_x, end_y, hx, hy))
    square = step_x * step_x + step_y * step_y
    signs = _CORNERS.reshape(2, 4, *[1] * square.ndim)
    x, y = start_x - signs[0] * hx, start_y - signs[1] * hy
    part = -(x * step_x + y * step_y) / np.where(square > 0, square, 1.0)
    np.minimum(np.maximum(part, 0, out=part), 1, out=part)
    x += part * step_x
    y += part * step_y
    x *= x
    x += y * y
    gaps = np.sqrt(np.minimum(found, np.minimum.reduce(x, axis=0)))
    middle_x, middle_y = 0.5 * (start_x + end_x), 0.5 * (start_y + end_y)
    gaps[_crossing(middle_x, middle_y, 0.5 * step_x, 0.5 * step_y, half_sides)] = 0.0
    return gaps


def _square_to_box(x: NDArray[np.float64], y: NDArray[np.float64], hx: Sides, hy: Sides) -> NDArray[np.float64]:
    """The square of the distance of places (from the centre of a box) from the box."""
    aside, above = np.maximum(np.abs(x) - hx, 0), np.maximum(np.abs(y) - hy, 0)
    aside *= aside
    aside += above * above
    return aside
