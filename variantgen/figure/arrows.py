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
_SLIDES = np.array([0.0, 2.5, 5.0, 8.0, 11.0, -3.0, -6.0, -9.0, -12.0, -15.0])  # along it, u
_HALF_LANE = 0.8  # half the width of the paper that an arrow takes, u
_ROOT = 4.5  # part of an arrow at its point that may lie on what meets there, u
_PAST = 1.6  # free paper beyond a head, u
_OFF = 1.0  # between an arrow and its letters, u
_BEHIND = 16.0  # depth behind a wall in which an arrow seems to be in it, u
_LONG_WALL = 12.0  # shorter hatched lines are bases of hinges, u
_PLAINLY = 0.8  # by which letters are nearer to their own arrow than to the other one, u
_TOLD_APART = 1.8  # distance aside of two opposite arrows, u
# Costs of a line that is crossed and of each u on it, of a wall before the arrow, of an arrow that reads as one with
# another, of one in line with another, of letters over a line, of an arrow beside its point, outside a disc
# of its point, of distance, of shortness.
_CROSSED, _ON_LINE, _WALL, _DOUBLE, _IN_LINE, _COVERED, _BESIDE, _OFF_DISC = (6.0, 0.8, 14.0, 60.0, 6.0, 4.0, 1.5, 9.0)
_ASIDE, _ALONG, _SLID, _SHORT = 0.3, 0.4, 0.08, np.array([0.0, 1.5, 4.0])


@dataclass(frozen=True)
class _Grid:
    """The places of an arrow: lanes aside, in each the same feet and lengths; costs have the shape (lanes, places)."""

    lanes: NDArray[np.float64]
    feet: NDArray[np.float64]
    lengths: NDArray[np.float64]
    shortness: NDArray[np.float64]


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
        size = label_size(symbol)
        foot, tip = _roomiest(board, centre, way, length, start, root, size, drawn, reserved)
        drawn.append((foot, tip))
        reserved += _place_of_letters(board, foot, tip, size)
        sketch.arrow(foot, tip, Layer.VECTOR, weight=weight)
        sketch.label(along_arrow(symbol, foot, tip))
        sketch.occupy(point, tip - sketch.at[point])


def directed(rate: float, way: complex) -> complex:
    """The direction of a rate along a unit vector; zero for no rate."""
    return math.copysign(1.0, rate) * way if rate else 0j


def _roomiest(
    board: Board,
    centre: complex,
    way: complex,
    length: float,
    start: float,
    root: float,
    letters: tuple[float, float],
    drawn: Sequence[tuple[complex, complex]],
    reserved: Sequence[tuple[complex, complex]],
) -> tuple[complex, complex]:
    """Foot and tip of the arrow that costs least; the first of those that cost the same.

    ``drawn`` are the arrows of the point so far, ``reserved`` the diagonals of the boxes that their letters need.
    """
    lengths = length * np.tile(_SHORTER, len(_SLIDES))
    feet = np.repeat(_SLIDES, len(_SHORTER))
    grid = _Grid(_LANES, feet, lengths, np.tile(_SHORT, len(_SLIDES)))
    # In the lane of the point itself an arrow begins at its symbol.
    lanes = grid.lanes[:, None]
    along = np.maximum(0.0, np.maximum(feet, -feet - lengths))
    costs = np.where(lanes == 0, 0.0, _BESIDE + _ASIDE * np.abs(lanes)) + _ALONG * along + _SLID * np.abs(feet)
    costs = costs + grid.shortness + np.where((lanes == 0) & (feet != 0), np.inf, 0.0)
    tails = np.where(lanes == 0, start, feet)
    costs += _crossing(board, centre, way, grid, tails, root, letters, reserved)
    costs += _walled(board, centre, way, grid, tails) + _confused(centre, way, grid, tails, drawn)
    costs += _OFF_DISC * _off_disc(board, centre, way, grid, tails)
    lane, place = divmod(int(np.argmin(costs)), len(feet))
    foot = centre + way * complex(tails[lane, place], grid.lanes[lane])
    return foot, foot + lengths[place] * way


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
    board: Board,
    centre: complex,
    way: complex,
    grid: _Grid,
    tails: NDArray[np.float64],
    root: float,
    letters: tuple[float, float],
    reserved: Sequence[tuple[complex, complex]],
) -> NDArray[np.float64]:
    """Cost of the lines under each arrow and just beyond its head, and under its letters."""
    across = 0.5 * (letters[0] * abs(way.imag) + letters[1] * abs(way.real))
    half = 0.5 * (letters[0] * abs(way.real) + letters[1] * abs(way.imag))
    beside = _OFF + across
    count = len(grid.lanes)
    lanes = np.concatenate((grid.lanes, grid.lanes, grid.lanes + beside, grid.lanes - beside))
    widths = np.repeat((_HALF_LANE, across, across, across), count)
    low, high = board.sketch.obstacles.lanes_met(centre, way, lanes, widths, reserved)
    heads = tails + grid.lengths
    at_point = grid.lanes[:, None] == 0
    from_, to = np.where(at_point, np.maximum(tails, root), tails - 0.6), heads + _PAST
    shared = np.minimum(high[:count, None], to[..., None]) - np.maximum(low[:count, None], from_[..., None])
    met = np.minimum((shared >= 0).sum(axis=2), 4)
    costs: NDArray[np.float64] = _CROSSED * met + _ON_LINE * np.maximum(shared, 0.0).sum(axis=2)
    middle = tails + 0.6 * grid.lengths
    spots = [(heads + _OFF, heads + _OFF + 2 * half), (middle - half, middle + half), (middle - half, middle + half)]
    covered = [
        np.sum((low[i : i + count, None] < end[..., None]) & (high[i : i + count, None] > begin[..., None]), axis=2)
        for i, (begin, end) in zip((count, 2 * count, 3 * count), spots, strict=True)
    ]
    best: NDArray[np.float64] = np.minimum(np.min(covered, axis=0), 3)
    return costs + _COVERED * best


def _walled(
    board: Board, centre: complex, way: complex, grid: _Grid, tails: NDArray[np.float64]
) -> NDArray[np.float64]:
    """Cost of arrows on the hatched side of a wall."""
    costs = np.zeros(tails.shape)
    for start, end, away in board.sketch.walls:
        long = abs(end - start)
        if long < _LONG_WALL:
            continue
        behind = np.zeros(tails.shape, dtype=bool)
        for part in (0.3, 0.6, 1.0):
            step = centre + way * (tails + part * grid.lengths + 1j * grid.lanes[:, None]) - start
            along, depth = (step * np.conj((end - start) / long)).real, (step * np.conj(away)).real
            behind |= (along > 0) & (along < long) & (depth > 0.2) & (depth < _BEHIND)
        costs += _WALL * behind
    return costs


def _off_disc(
    board: Board, centre: complex, way: complex, grid: _Grid, tails: NDArray[np.float64]
) -> NDArray[np.float64]:
    """Of how many discs with the point inside an arrow is outside."""
    middles = centre + way * (tails + 0.5 * grid.lengths + 1j * grid.lanes[:, None])
    found = np.zeros(tails.shape)
    for body, radii in board.discs.items():
        for disc in board.form.figure.discs:
            at = board.sketch.at[disc.centre]
            if disc.body == body and abs(centre - at) < max(radii) - 1.0:
                found += np.abs(middles - at) > max(radii)
    return found


def _confused(
    centre: complex, way: complex, grid: _Grid, tails: NDArray[np.float64], drawn: Sequence[tuple[complex, complex]]
) -> NDArray[np.float64]:
    """Cost of arrows that would read as one with another arrow of the point."""
    costs = np.zeros(tails.shape)
    for foot, tip in drawn:
        first, last = ((end - centre) / way for end in (foot, tip))
        cosine = ((last - first) / abs(last - first)).real
        if abs(cosine) > 0.97:
            near = np.abs(grid.lanes[:, None] - 0.5 * (first + last).imag) < _TOLD_APART
            costs += (_DOUBLE if cosine < 0 else _IN_LINE) * near
    return costs
