"""Arrows of given motion: from the point where that hides nothing, else beside it, where they cross least."""

from __future__ import annotations

import math
from collections.abc import Sequence
from functools import cache

import numpy as np
from msgspec import Struct
from numpy.typing import NDArray

from variantgen.figure.board import Board
from variantgen.figure.drawing import MEDIUM, Layer
from variantgen.figure.obstacles import lanes_met
from variantgen.figure.placement.choices import GAP
from variantgen.figure.placement.label_requests import along_arrow, label_size
from variantgen.wording.formula import Symbol

_LENGTHS = (11.0, 8.8)  # of velocities, of accelerations, u
_WEIGHTS = (0.75, MEDIUM)
_SHORTER = np.array([1.0, 0.8, 0.65])
_LANES = np.array([0.0, 3.0, -3.0, 4.4, -4.4, 6.2, -6.2, 8.4, -8.4, 11.0, -11.0])  # aside of the point, u
_SLIDES = np.array([0.0, 3.0, 6.5, 10.0, -3.5, -7.0, -10.5, -14.0])  # along it, u
# Places that are compared at once, the first and the one past the last, and how many lanes they are in.
_ROUNDS = ((0, 1, 1), (1, 64, len(_LANES)), (64, None, len(_LANES)))
_HALF_LANE = 0.8  # half the width of the paper that an arrow takes, u
_ROOT = 4.5  # part of an arrow at its point that may lie on what meets there, u
_FAR = 28.0  # from the point: farther lines meet no arrow, u
_PAST = 1.6  # free paper beyond a head, u
_OFF = 1.0  # between an arrow and its letters, u
_BEHIND = 16.0  # depth behind a wall in which an arrow seems to be in it, u
_LONG_WALL = 12.0  # shorter hatched lines are bases of hinges, u
_PLAINLY = 0.8  # by which letters are nearer to their own arrow than to the other one, u
_PARALLEL = 0.97  # cosine of the angle between two arrows on one line
_TOLD_APART, _PLAINLY_APART = 1.8, 4.0  # distances aside of two opposite arrows: seen if looked for, at once, u
_SIDE_BY_SIDE = 3.5  # length over which two arrows lie beside each other, u
# Costs of a line that is crossed and of each u on it, of a wall before the arrow, of an arrow that reads as one with
# another, of one in line with another, of letters over a line, of an arrow beside its point, outside a disc
# of its point, tail to tail with another one, of distance, of shortness.
_CROSSED, _ON_LINE, _WALL, _DOUBLE, _IN_LINE, _COVERED, _BESIDE, _OFF_DISC, _TAIL_TO_TAIL = (
    6.0,
    0.8,
    14.0,
    60.0,
    6.0,
    4.0,
    1.5,
    9.0,
    5.0,
)
_ASIDE, _ALONG, _SLID, _SHORT = 0.3, 0.4, 0.08, np.array([0.0, 1.5, 4.0])


class _Wanted(Struct, frozen=True):
    """An arrow that is wanted: a place, its direction (unit), its length, where it begins if it begins there (u).

    ``root`` is the part that may lie on what meets at the place, ``letters`` width and height of its symbol.
    """

    centre: complex
    way: complex
    length: float
    start: float
    root: float
    letters: tuple[float, float]


class _Places:
    """Places where an arrow may lie, shape (P,) each: number and distance aside of the lane, tail and head along it."""

    def __init__(self, arrow: _Wanted, number: NDArray[np.intp], along: NDArray[np.float64]) -> None:
        self.number, self.lane = number, _LANES[number]
        # In the lane of the point itself an arrow begins at its symbol.
        self.tail = along[0] + (self.lane == 0) * arrow.start
        self.length = along[1]
        self.head = self.tail + self.length

    def parts(self, arrow: _Wanted, part: float) -> NDArray[np.complex128]:
        """The point of each arrow at a part of its length."""
        result: NDArray[np.complex128] = arrow.centre + arrow.way * (self.tail + part * self.length + 1j * self.lane)
        return result


@cache
def _every_place(length: float) -> tuple[NDArray[np.intp], NDArray[np.float64]]:
    """Number of the lane, shape (P,); tail along it, length and cost where nothing is in the way, shape (3, P).

    The cheapest are the first: distance from the point costs, and shortness.
    """
    shape = (len(_LANES), len(_SLIDES), len(_SHORTER))
    number, slide, short = (every.ravel() for every in np.indices(shape))
    # In the lane of the point an arrow begins at the point.
    kept = (number > 0) | (slide == 0)
    number, slide, short = number[kept], slide[kept], short[kept]
    tail, own = _SLIDES[slide], length * _SHORTER[short]
    costs = (number > 0) * (_BESIDE + _ASIDE * np.abs(_LANES[number])) + _SLID * np.abs(tail) + _SHORT[short]
    costs = costs + _ALONG * np.maximum(0.0, np.maximum(tail, -tail - own))
    order = np.argsort(costs, kind="stable")
    return number[order], np.array([tail, own, costs])[:, order]


def draw_arrows(
    board: Board,
    point: str,
    ways: tuple[complex, complex],
    symbols: tuple[Symbol | None, Symbol | None],
    place: complex | None = None,
    root: float = _ROOT,
) -> None:
    """Velocity and acceleration of a point (or of the ``place`` beside which they are drawn).

    ``ways`` are their directions (unit, zero for a rate that is zero); what has no symbol is not given and not drawn.
    An arrow from the point may lie on what meets there as far as its ``root`` (u).
    """
    sketch = board.sketch
    centre = sketch.at[point] if place is None else place
    given = [
        (way, symbol, length, weight)
        for way, symbol, length, weight in zip(ways, symbols, _LENGTHS, _WEIGHTS, strict=True)
        if way and symbol is not None
    ]
    drawn: list[tuple[complex, complex]] = []
    reserved: list[tuple[complex, complex]] = []
    for way, symbol, length, weight in given:
        start = sketch.symbol_radius.get(point, 1.1) if place is None else 0.0
        arrow = _Wanted(centre, way, length, start, root, label_size(symbol))
        foot, tip = _roomiest(board, arrow, drawn, reserved)
        drawn.append((foot, tip))
        if len(drawn) < len(given):
            reserved += _place_of_letters(board, foot, tip, arrow.letters)
        sketch.arrow(foot, tip, Layer.VECTOR, weight=weight)
        sketch.label(along_arrow(symbol, foot, tip))
        sketch.occupy(point, tip - sketch.at[point])


def directed(rate: float, way: complex) -> complex:
    """The direction of a rate along a unit vector; zero for no rate."""
    return math.copysign(1.0, rate) * way if rate else 0j


def _roomiest(
    board: Board, arrow: _Wanted, drawn: Sequence[tuple[complex, complex]], reserved: Sequence[tuple[complex, complex]]
) -> tuple[complex, complex]:
    """Foot and tip of the arrow that costs least; of those that cost the same the one nearer to its point.

    ``drawn`` are the arrows of the point so far, ``reserved`` the diagonals of the boxes that their letters need.
    """
    numbers, places = _every_place(arrow.length)
    lines = board.sketch.obstacles.seen_along(arrow.centre, arrow.way, _FAR, reserved)
    best, found = math.inf, (arrow.centre, arrow.centre)
    # Most arrows begin at their point, most others near it: what cannot be cheaper is not compared.
    for first, last, lanes in _ROUNDS:
        if best <= places[2, first]:
            break
        some = _Places(arrow, numbers[first:last], places[:2, first:last])
        costs = places[2, first:last] + _crossing(arrow, lines, _LANES[:lanes], some) + _walled(board, arrow, some)
        costs += _confused(arrow, some, drawn) + _OFF_DISC * _off_disc(board, arrow, some)
        at = int(costs.argmin())
        if costs[at] < best:
            best, foot = float(costs[at]), arrow.centre + arrow.way * complex(some.tail[at], some.lane[at])
            found = foot, foot + float(some.length[at]) * arrow.way
    return found


def _place_of_letters(
    board: Board, foot: complex, tip: complex, letters: tuple[float, float]
) -> list[tuple[complex, complex]]:
    """The diagonals of the box in which the letters of an arrow find most room."""
    way = (tip - foot) / abs(tip - foot)
    half = 0.5 * complex(*letters)
    across = _OFF + half.real * abs(way.imag) + half.imag * abs(way.real)
    ahead = _OFF + half.real * abs(way.real) + half.imag * abs(way.imag)
    middle = foot + 0.6 * (tip - foot)
    places = [middle + 1j * way * across, middle - 1j * way * across, tip + ahead * way]
    covered = board.sketch.crossings(places, (half.real + GAP, half.imag + GAP))
    best = places[int(np.argmin(covered))]
    wide = half + complex(_PLAINLY, _PLAINLY)
    return [(best - wide, best + wide), (best - wide.conjugate(), best + wide.conjugate())]


def _crossing(
    arrow: _Wanted, lines: NDArray[np.complex128], lanes: NDArray[np.float64], some: _Places
) -> NDArray[np.float64]:
    """Cost of the ``lines`` (seen along the arrow) under each arrow and just beyond its head, and under its letters.

    ``lanes`` are those of the places.
    """
    way, letters = arrow.way, arrow.letters
    across = 0.5 * (letters[0] * abs(way.imag) + letters[1] * abs(way.real))
    half = 0.5 * (letters[0] * abs(way.real) + letters[1] * abs(way.imag))
    beside = _OFF + across
    # The lanes of the arrows, and those of letters before them and on both sides.
    strips = np.concatenate((lanes, lanes, lanes + beside, lanes - beside))
    met = lanes_met(lines, strips, np.repeat((_HALF_LANE, across, across, across), len(lanes)))
    low, high = (ends.reshape(4, len(lanes), -1).take(some.number, axis=1) for ends in met)
    begin = np.where(some.lane == 0, np.maximum(some.tail, arrow.root), some.tail - 0.6)
    shared = np.minimum(high[0], (some.head + _PAST)[:, None]) - np.maximum(low[0], begin[:, None])
    crossed = np.minimum((shared >= 0).sum(axis=1), 4)
    middle = some.tail + 0.6 * some.length - half
    letter = np.array([some.head + _OFF, middle, middle])[..., None]
    covered = ((low[1:] < letter + 2 * half) & (high[1:] > letter)).sum(axis=2).min(axis=0)
    costs = _CROSSED * crossed + _ON_LINE * np.maximum(shared, 0.0).sum(axis=1)
    result: NDArray[np.float64] = costs + _COVERED * np.minimum(covered, 3)
    return result


def _walled(board: Board, arrow: _Wanted, some: _Places) -> NDArray[np.float64] | float:
    """Cost of arrows on the hatched side of a wall."""
    walls = [wall for wall in board.sketch.walls if abs(wall.end - wall.start) >= _LONG_WALL]
    if not walls:
        return 0.0
    parts = np.array([some.parts(arrow, 0.4), some.parts(arrow, 1.0)])
    costs: NDArray[np.float64] = np.zeros(len(some.tail))
    for start, end, away, _ in walls:
        # From the middle of the wall: along it, and behind it.
        seen = (parts - 0.5 * (start + end)) * (1j * away.conjugate())
        behind = (np.abs(seen.real) < 0.5 * abs(end - start)) & (seen.imag > 0.2) & (seen.imag < _BEHIND)
        costs += _WALL * behind.any(axis=0)
    return costs


def _off_disc(board: Board, arrow: _Wanted, some: _Places) -> NDArray[np.float64]:
    """Of how many discs with the point inside an arrow is outside."""
    found = np.zeros(len(some.tail))
    for disc in board.form.figure.discs:
        radii = board.discs.get(disc.body, []) if disc.body else []
        at = board.sketch.at[disc.centre]
        if radii and abs(arrow.centre - at) < max(radii) - 1.0:
            found += np.abs(some.parts(arrow, 0.5) - at) > max(radii)
    return found


def _confused(arrow: _Wanted, some: _Places, drawn: Sequence[tuple[complex, complex]]) -> NDArray[np.float64]:
    """Cost of arrows that would read as one with another arrow of the point."""
    costs = np.zeros(len(some.tail))
    for foot, tip in drawn:
        first, last = ((end - arrow.centre) / arrow.way for end in (foot, tip))
        cosine = ((last - first) / abs(last - first)).real
        if abs(cosine) > _PARALLEL:
            aside = np.abs(some.lane - 0.5 * (first + last).imag)
            costs += (_DOUBLE if cosine < 0 else _IN_LINE) * (aside < _TOLD_APART)
            if cosine < 0:
                # Tail to tail, a little aside, two opposite arrows still look like one: side by side they do not.
                shared = np.minimum(some.head, first.real) - np.maximum(some.tail, last.real)
                costs += _TAIL_TO_TAIL * ((aside < _PLAINLY_APART) & (shared < _SIDE_BY_SIDE))
    return costs
