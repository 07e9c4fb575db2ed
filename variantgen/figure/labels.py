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
_LINE, _LABEL, _STRANGER = 20.0, 40.0, 3.0
_SWEEPS = 3

Segments = NDArray[np.complex128]


def label_size(formula: Formula) -> tuple[float, float]:
    """Width and height of a label (u)."""
    width, height = size(formula)
    return LETTER * width, LETTER * height


@dataclass(frozen=True)
class Request:
    """A label to be placed: the formula, the point it names, candidate centres and their own costs."""

    formula: Formula
    anchor: complex
    places: tuple[complex, ...]
    costs: tuple[float, ...]

    @property
    def box(self) -> tuple[float, float]:
        """Half width and half height (u)."""
        width, height = label_size(self.formula)
        return 0.5 * width, 0.5 * height


def around(formula: Formula, point: complex, clear: float, directions: int = 16) -> Request:
    """Candidates around a point, whose symbol has the radius ``clear`` (u)."""
    half = 0.5 * complex(*label_size(formula))
    places, costs = [], []
    for ring, extra in enumerate((0.0, 1.6, 3.6, 6.0)):
        for k in range(directions):
            way = cmath.rect(1.0, math.tau * k / directions + math.pi / 4)
            support = min(
                half.real / abs(way.real) if way.real else math.inf, half.imag / abs(way.imag) if way.imag else math.inf
            )
            places.append(point + way * (clear + 0.5 + extra + support))
            costs.append(2.0 * ring + 0.3 * (k % 4 != 0) + 0.01 * k)
    return Request(formula, point, tuple(places), tuple(costs))


def along_line(formula: Formula, start: complex, end: complex, clear: float = 0.9) -> Request:
    """Candidates on both sides of a line, best near its middle."""
    half = 0.5 * complex(*label_size(formula))
    way = (end - start) / abs(end - start)
    places, costs = [], []
    for part in (0.5, 0.42, 0.58, 0.34, 0.66, 0.26, 0.74):
        for side in (1j, -1j):
            normal = side * way
            support = half.real * abs(normal.real) + half.imag * abs(normal.imag)
            places.append(start + part * (end - start) + normal * (clear + support))
            costs.append(10 * abs(part - 0.5) + (0.2 if side == -1j else 0.0))
    return Request(formula, 0.5 * (start + end), tuple(places), tuple(costs))


def along_arrow(formula: Formula, start: complex, end: complex) -> Request:
    """Candidates beside an arrow, best near its head, and before its head."""
    beside = along_line(formula, start, end)
    way = (end - start) / abs(end - start)
    half_width, half_height = beside.box
    support = half_width * abs(way.real) + half_height * abs(way.imag)
    ahead = [end + way * (1.0 + support), end + way * (2.5 + support)]
    costs = [cost + 2 * abs((place - 0.6 * end - 0.4 * start) / abs(end - start)) for cost, place in zip(beside.costs, beside.places, strict=True)]
    return Request(formula, end, (*beside.places, *ahead), (*costs, 1.5, 3.0))


def along_arc(formula: Formula, centre: complex, radius: float, start: float, sweep: float) -> Request:
    """Candidates outside (then inside) an arc, best at its middle."""
    half = 0.5 * complex(*label_size(formula))
    places, costs = [], []
    for part in (0.5, 0.35, 0.65, 0.2, 0.8, 0.0, 1.0):
        way = cmath.rect(1.0, start + part * sweep)
        support = half.real * abs(way.real) + half.imag * abs(way.imag)
        for distance, cost in ((radius + 0.7, 0.0), (radius + 2.2, 1.5), (radius + 4.5, 3.0), (radius + 7.5, 6.0)):
            places.append(centre + way * (distance + support))
            costs.append(cost + 4 * abs(part - 0.5))
    middle = centre + cmath.rect(radius, start + 0.5 * sweep)
    return Request(formula, middle, tuple(places), tuple(costs))


def place_labels(requests: Sequence[Request], segments: Segments, strangers: Sequence[complex]) -> list[Label]:
    """Labels at the positions with the least cost; ``segments`` has shape (S, 2), ``strangers`` are named points."""
    if not requests:
        return []
    fixed = [np.array(r.costs) + _line_costs(r, segments) + _stranger_costs(r, strangers) for r in requests]
    places, boxes = [np.array(r.places) for r in requests], [r.box for r in requests]
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
        Label(r.formula, r.places[k], (2 * r.box[0], 2 * r.box[1])) for r, k in zip(requests, chosen, strict=True)
    ]


def _line_costs(request: Request, segments: Segments) -> NDArray[np.float64]:
    """Cost of the segments that cross the box of each candidate."""
    hx, hy = request.box
    crossed = boxes_crossed(np.array(request.places), (hx + GAP, hy + GAP), segments)
    result: NDArray[np.float64] = _LINE * np.minimum(crossed, 3)
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


def _stranger_costs(request: Request, strangers: Sequence[complex]) -> NDArray[np.float64]:
    """Cost of being nearer to another named point than to the own one."""
    others = np.array([p for p in strangers if abs(p - request.anchor) > 1e-6], dtype=complex)
    if not others.size:
        return np.zeros(len(request.places))
    places = np.array(request.places)
    nearest = np.min(np.abs(places[:, None] - others[None, :]), axis=1)
    return np.where(nearest < np.abs(places - request.anchor), _STRANGER, 0.0)


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
