"""Arrows of given motion: from the point where that hides nothing, else beside it, where they cross least."""

from __future__ import annotations

import math
from collections.abc import Sequence
from dataclasses import dataclass

import numpy as np
from numpy.typing import NDArray

from variantgen.figure.board import Board
from variantgen.figure.drawing import MEDIUM, Layer
from variantgen.figure.placement.label_requests import along_arrow, label_size
from variantgen.figure.placement.labels import GAP
from variantgen.wording.formula import Symbol

_LENGTHS = (11.0, 8.8)  # of velocities, of accelerations, u
_WEIGHTS = (0.75, MEDIUM)
_SHORTER = np.array([1.0, 0.8, 0.65])
_LANES = np.array([0.0, 3.0, -3.0, 4.4, -4.4, 6.2, -6.2, 8.4, -8.4, 11.0, -11.0])  # aside of the point, u
_SLIDES = np.array([0.0, 3.0, 6.5, 10.0, -3.5, -7.0, -10.5, -14.0])  # along it, u
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


@dataclass(frozen=True)
class _Wanted:
    """An arrow that is wanted: a place, its direction (unit), its length, where it begins if it begins there (u).

    ``root`` is the part that may lie on what meets at the place, ``letters`` width and height of its symbol.
    """

    centre: complex
    way: complex
    length: float
    start: float
    root: float
    letters: tuple[float, float]


class _Grid:
    """Places of an arrow: lanes aside, in each the same slides and lengths.

    ``lanes`` have the shape (L, 1), ``tails`` (where the arrow begins, along its way) and costs (L, P), all else (P,).
    """

    def __init__(self, arrow: _Wanted, lanes: NDArray[np.float64], slides: NDArray[np.float64]) -> None:
        self.lanes = lanes[:, None]
        self.slides = np.repeat(slides, len(_SHORTER))
        self.lengths = arrow.length * np.tile(_SHORTER, len(slides))
        self.shortness = np.tile(_SHORT, len(slides))
        # In the lane of the point itself an arrow begins at its symbol.
        self.tails = np.where(self.lanes == 0, arrow.start, self.slides)
        self.heads = self.tails + self.lengths

    def parts(self, arrow: _Wanted, part: float) -> NDArray[np.complex128]:
        """The point of each arrow at a part of its length, shape (L, P)."""
        result: NDArray[np.complex128] = arrow.centre + arrow.way * (self.tails + part * self.lengths + 1j * self.lanes)
        return result


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
    drawn: list[tuple[complex, complex]] = []
    reserved: list[tuple[complex, complex]] = []
    for way, symbol, length, weight in zip(ways, symbols, _LENGTHS, _WEIGHTS, strict=True):
        if way == 0 or symbol is None:
            continue
        start = sketch.symbol_radius.get(point, 1.1) if place is None else 0.0
        arrow = _Wanted(centre, way, length, start, root, label_size(symbol))
        foot, tip = _roomiest(board, arrow, drawn, reserved)
        drawn.append((foot, tip))
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
    """Foot and tip of the arrow that costs least; the first of those that cost the same.

    ``drawn`` are the arrows of the point so far, ``reserved`` the diagonals of the boxes that their letters need.
    """
    # Most arrows begin at their point: what costs less than any place beside it is not compared with the others.
    for lanes, slides in ((_LANES[:1], _SLIDES[:1]), (_LANES, _SLIDES)):
        grid = _Grid(arrow, lanes, slides)
        costs = _far(grid) + _crossing(board, arrow, grid, reserved) + _walled(board, arrow, grid)
        costs += _confused(arrow, grid, drawn) + _OFF_DISC * _off_disc(board, arrow, grid)
        lane, place = divmod(int(np.argmin(costs)), len(grid.slides))
        if costs[lane, place] < _BESIDE:
            break
    foot = arrow.centre + arrow.way * complex(grid.tails[lane, place], lanes[lane])
    return foot, foot + float(grid.lengths[place]) * arrow.way


def _far(grid: _Grid) -> NDArray[np.float64]:
    """Cost of the distance from the point, and of shortness."""
    along = np.maximum(0.0, np.maximum(grid.slides, -grid.slides - grid.lengths))
    costs = np.where(grid.lanes == 0, 0.0, _BESIDE + _ASIDE * np.abs(grid.lanes)) + _ALONG * along
    costs = costs + _SLID * np.abs(grid.slides) + grid.shortness
    result: NDArray[np.float64] = np.where((grid.lanes == 0) & (grid.slides != 0), np.inf, costs)
    return result


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
    board: Board, arrow: _Wanted, grid: _Grid, reserved: Sequence[tuple[complex, complex]]
) -> NDArray[np.float64]:
    """Cost of the lines under each arrow and just beyond its head, and under its letters."""
    way, letters = arrow.way, arrow.letters
    across = 0.5 * (letters[0] * abs(way.imag) + letters[1] * abs(way.real))
    half = 0.5 * (letters[0] * abs(way.real) + letters[1] * abs(way.imag))
    own, beside, count = grid.lanes[:, 0], _OFF + across, len(grid.lanes)
    lanes = np.concatenate((own, own, own + beside, own - beside))
    widths = np.repeat((_HALF_LANE, across, across, across), count)
    low, high = board.sketch.obstacles.lanes_met(arrow.centre, way, lanes, widths, _FAR, reserved)
    begin = np.where(grid.lanes == 0, np.maximum(grid.tails, arrow.root), grid.tails - 0.6)
    end = grid.heads + _PAST
    shared = np.minimum(high[:count, None], end[..., None]) - np.maximum(low[:count, None], begin[..., None])
    met = np.minimum((shared >= 0).sum(axis=2), 4)
    costs: NDArray[np.float64] = _CROSSED * met + _ON_LINE * np.maximum(shared, 0.0).sum(axis=2)
    middle = grid.tails + 0.6 * grid.lengths
    spots = [(grid.heads + _OFF, grid.heads + _OFF + 2 * half), *[(middle - half, middle + half)] * 2]
    covered = [
        np.sum((low[i : i + count, None] < last[..., None]) & (high[i : i + count, None] > first[..., None]), axis=2)
        for i, (first, last) in zip((count, 2 * count, 3 * count), spots, strict=True)
    ]
    best: NDArray[np.float64] = np.minimum(np.min(covered, axis=0), 3)
    return costs + _COVERED * best


def _walled(board: Board, arrow: _Wanted, grid: _Grid) -> NDArray[np.float64]:
    """Cost of arrows on the hatched side of a wall."""
    costs = np.zeros(grid.tails.shape)
    for start, end, away in board.sketch.walls:
        long = abs(end - start)
        if long < _LONG_WALL:
            continue
        behind = np.zeros(grid.tails.shape, dtype=bool)
        for part in (0.4, 1.0):
            step = grid.parts(arrow, part) - start
            along, depth = (step * np.conj((end - start) / long)).real, (step * np.conj(away)).real
            behind |= (along > 0) & (along < long) & (depth > 0.2) & (depth < _BEHIND)
        costs += _WALL * behind
    return costs


def _off_disc(board: Board, arrow: _Wanted, grid: _Grid) -> NDArray[np.float64]:
    """Of how many discs with the point inside an arrow is outside."""
    found = np.zeros(grid.tails.shape)
    for disc in board.form.figure.discs:
        radii = board.discs.get(disc.body, []) if disc.body else []
        at = board.sketch.at[disc.centre]
        if radii and abs(arrow.centre - at) < max(radii) - 1.0:
            found += np.abs(grid.parts(arrow, 0.5) - at) > max(radii)
    return found


def _confused(arrow: _Wanted, grid: _Grid, drawn: Sequence[tuple[complex, complex]]) -> NDArray[np.float64]:
    """Cost of arrows that would read as one with another arrow of the point."""
    costs = np.zeros(grid.tails.shape)
    for foot, tip in drawn:
        first, last = ((end - arrow.centre) / arrow.way for end in (foot, tip))
        cosine = ((last - first) / abs(last - first)).real
        if abs(cosine) > _PARALLEL:
            aside = np.abs(grid.lanes - 0.5 * (first + last).imag)
            costs += (_DOUBLE if cosine < 0 else _IN_LINE) * (aside < _TOLD_APART)
            if cosine < 0:
                # Tail to tail, a little aside, two opposite arrows still look like one: side by side they do not.
                shared = np.minimum(grid.heads, first.real) - np.maximum(grid.tails, last.real)
                costs += _TAIL_TO_TAIL * ((aside < _PLAINLY_APART) & (shared < _SIDE_BY_SIDE))
    return costs
