"""Placement of labels by optimisation: candidates for each, cost for collisions, deterministic.

Every label has candidate positions. A position costs by what its box would cover (lines, symbols, other labels), by
how far it is, and by how close it comes to things it does not belong to. Labels are placed one after the other, then
each is tried again in view of the others until nothing improves.
"""

from __future__ import annotations

import cmath
import math
from collections.abc import Sequence
from dataclasses import dataclass

import numpy as np
from numpy.typing import NDArray

from variantgen.figure.drawing import LETTER, Label
from variantgen.figure.metrics import size
from variantgen.wording.formula import Formula

GAP = 0.8  # free space around a label, u
# Costs of a line through a label (counted up to a number), of two labels over each other, of a label nearer to another
# point than to its own, and of a rate nearer to another one's arrow than to its own, which would be misread.
_LINE, _MOST_LINES, _LABEL, _STRANGER, _MISREAD = 20.0, 6, 300.0, 12.0, 60.0
_WIDE = math.radians(50)
_SWEEPS = 3

Segments = NDArray[np.complex128]


def label_size(formula: Formula) -> tuple[float, float]:
    """Width and height of a label (u)."""
    width, height = size(formula)
    return LETTER * width, LETTER * height


Places = NDArray[np.complex128]
Costs = NDArray[np.float64]


@dataclass(frozen=True)
class Request:
    """A label to be placed: the formula, the point it names, candidate centres and their own costs, shape (P,).

    ``extent`` are further points of what it names (an arc), that no other label should be nearer to than to its own.
    """

    formula: Formula
    anchor: complex
    places: Places
    costs: Costs
    extent: tuple[complex, ...] = ()

    @property
    def box(self) -> tuple[float, float]:
        """Half width and half height (u)."""
        width, height = label_size(self.formula)
        return 0.5 * width, 0.5 * height


_WAYS = np.exp(1j * (math.tau * np.arange(16) / 16 + math.pi / 4))
_RINGS = np.array([0.0, 1.6, 3.6, 6.0])
_AROUND_COSTS = (2.0 * np.arange(4)[:, None] + (0.3 * (np.arange(16) % 4 != 0) + 0.01 * np.arange(16))[None, :]).ravel()
_PARTS = np.array([0.5, 0.42, 0.58, 0.34, 0.66, 0.26, 0.74])
_ARC_PARTS = np.array([0.5, 0.35, 0.65, 0.2, 0.8, 0.0, 1.0])
_ARC_RINGS = np.array([0.7, 2.2, 4.5, 7.5])
_ARC_COSTS = (np.array([0.0, 1.5, 3.0, 6.0])[None, :] + 4 * np.abs(_ARC_PARTS - 0.5)[:, None]).ravel()


def around(formula: Formula, point: complex, clear: float) -> Request:
    """Candidates around a point, whose symbol has the radius ``clear`` (u)."""
    width, height = label_size(formula)
    with np.errstate(divide="ignore"):
        support = np.minimum(0.5 * width / np.abs(_WAYS.real), 0.5 * height / np.abs(_WAYS.imag))
    places = point + _WAYS[None, :] * (clear + 0.5 + _RINGS[:, None] + support[None, :])
    return Request(formula, point, places.ravel(), _AROUND_COSTS)


def along_line(formula: Formula, start: complex, end: complex, clear: float = 0.9) -> Request:
    """Candidates on both sides of a line, best near its middle."""
    width, height = label_size(formula)
    normal = 1j * (end - start) / abs(end - start)
    support = clear + 0.5 * (width * abs(normal.real) + height * abs(normal.imag))
    middle = start + _PARTS * (end - start)
    costs = 10 * np.abs(_PARTS - 0.5)
    places = np.concatenate((middle + support * normal, middle - support * normal))
    return Request(formula, 0.5 * (start + end), places, np.concatenate((costs, costs + 0.2)))


def along_arrow(formula: Formula, start: complex, end: complex) -> Request:
    """Candidates beside an arrow, best near its head, and before its head."""
    beside = along_line(formula, start, end)
    way = (end - start) / abs(end - start)
    half_width, half_height = beside.box
    support = half_width * abs(way.real) + half_height * abs(way.imag)
    ahead = end + way * (np.array([1.0, 2.5, 5.0, 8.0, 11.0]) + support)
    far, farther = (along_line(formula, start, end, clear) for clear in (3.5, 7.0))
    near_head = 2 * np.abs((beside.places - 0.6 * end - 0.4 * start) / abs(end - start))
    costs = np.concatenate(
        (beside.costs + near_head, [1.5, 3.0, 5.0, 8.0, 11.0], far.costs + 7.0, farther.costs + 10.0)
    )
    extent = tuple(start + part * (end - start) for part in (0.0, 0.25, 0.5, 0.75))
    return Request(formula, end, np.concatenate((beside.places, ahead, far.places, farther.places)), costs, extent)


def along_arc(
    formula: Formula, centre: complex, radius: float, start: float, sweep: float, inner: bool = False
) -> Request:
    """Candidates outside an arc, best at its middle; with ``inner`` also inside a wide one."""
    width, height = label_size(formula)
    ways = np.exp(1j * (start + _ARC_PARTS * sweep))
    support = 0.5 * (width * np.abs(ways.real) + height * np.abs(ways.imag))
    places = centre + ways[:, None] * (radius + _ARC_RINGS[None, :] + support[:, None])
    middle = centre + cmath.rect(radius, start + 0.5 * sweep)
    extent = tuple(centre + cmath.rect(radius, start + part * sweep) for part in (0.0, 0.25, 0.75, 1.0))
    found, costs = places.ravel(), _ARC_COSTS
    if inner and abs(sweep) > _WIDE:
        found = np.concatenate((found, centre + 0.6 * radius * ways))
        costs = np.concatenate((costs, 2.5 + 4 * np.abs(_ARC_PARTS - 0.5)))
    return Request(formula, middle, found, costs, extent)


def place_labels(requests: Sequence[Request], segments: Segments, strangers: Sequence[complex]) -> list[Label]:
    """Labels where they cost least; ``segments`` has shape (S, 2), ``strangers`` are other named points."""
    if not requests:
        return []
    known = [*strangers, *(r.anchor for r in requests)]
    arrows = [point for r in requests if r.extent for point in (r.anchor, *r.extent)]
    fixed = [
        r.costs
        + _line_costs(r, segments)
        + _STRANGER * _nearer(r, known)
        + _MISREAD * (_nearer(r, arrows) if r.extent else 0.0)
        for r in requests
    ]
    places, boxes = [r.places for r in requests], [r.box for r in requests]
    chosen = [-1] * len(requests)
    order = sorted(range(len(requests)), key=lambda i: -float(np.min(fixed[i])))
    for _ in range(_SWEEPS):
        before = list(chosen)
        for i in order:
            cost = fixed[i] + _label_costs(i, places, boxes, chosen)
            chosen[i] = int(np.argmin(cost))
        if chosen == before:
            break
    return [
        Label(r.formula, complex(r.places[k]), (2 * r.box[0], 2 * r.box[1]))
        for r, k in zip(requests, chosen, strict=True)
    ]


def _line_costs(request: Request, segments: Segments) -> NDArray[np.float64]:
    """Cost of the segments that cross the box of each candidate."""
    hx, hy = request.box
    crossed = boxes_crossed(request.places, (hx + GAP, hy + GAP), segments)
    result: NDArray[np.float64] = _LINE * np.minimum(crossed, _MOST_LINES)
    return result


def boxes_crossed(
    places: NDArray[np.complex128], half_sides: tuple[float, float], segments: Segments
) -> NDArray[np.int64]:
    """Number of segments that cross the box about each place (separating axes of box and segment), shape (P,)."""
    hx, hy = half_sides
    middle = 0.5 * (segments[:, 0] + segments[:, 1])[None, :] - places[:, None]
    half = 0.5 * (segments[:, 1] - segments[:, 0])[None, :]
    dx, dy = np.abs(half.real), np.abs(half.imag)
    crossing = (np.abs(middle.real) <= hx + dx) & (np.abs(middle.imag) <= hy + dy)
    crossing &= np.abs(half.real * middle.imag - half.imag * middle.real) <= hx * dy + hy * dx
    result: NDArray[np.int64] = np.sum(crossing, axis=1)
    return result


def _nearer(request: Request, strangers: Sequence[complex]) -> NDArray[np.float64]:
    """1 for each candidate that is nearer to a foreign point than to what the label names, else 0."""
    own = np.array([request.anchor, *request.extent])
    others = np.array([p for p in strangers if np.min(np.abs(p - own)) > 1e-6], dtype=complex)
    if not others.size:
        return np.zeros(len(request.places))
    nearest, mine = (np.min(np.abs(request.places[:, None] - points[None, :]), axis=1) for points in (others, own))
    return np.where(nearest < mine, 1.0, 0.0)


def _label_costs(
    i: int, places: Sequence[NDArray[np.complex128]], boxes: Sequence[tuple[float, float]], chosen: Sequence[int]
) -> NDArray[np.float64]:
    """Cost of the overlaps of each candidate of label i with the labels that are placed."""
    others = [j for j, k in enumerate(chosen) if k >= 0 and j != i]
    if not others:
        return np.zeros(len(places[i]))
    taken = np.array([places[j][chosen[j]] for j in others])
    reach = np.array([(boxes[i][0] + boxes[j][0] + GAP, boxes[i][1] + boxes[j][1] + GAP) for j in others])
    gap = places[i][:, None] - taken[None, :]
    overlaps = (np.abs(gap.real) < reach[:, 0]) & (np.abs(gap.imag) < reach[:, 1])
    result: NDArray[np.float64] = _LABEL * np.sum(overlaps, axis=1)
    return result
