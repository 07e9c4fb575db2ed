"""Arrows of given motion: velocity from the point, acceleration beside it."""

from __future__ import annotations

import math

import numpy as np

from variantgen.figure.board import Board
from variantgen.figure.drawing import MEDIUM, Layer
from variantgen.figure.placement.label_requests import along_arrow
from variantgen.wording.formula import Symbol

_LENGTH = 11.0
_ASIDE = 3.6
_WIDER = 2.8
_LETTERS = 2.6
_OFF_WALL = 3.4


def velocity_arrow(board: Board, point: str, ahead: complex, symbol: Symbol | None) -> None:
    """An arrow from the symbol at a point in the direction ``ahead`` (unit); none for a velocity that is not given."""
    if symbol is not None:
        start = board.sketch.at[point] + ahead * board.sketch.symbol_radius.get(point, 1.1)
        _arrow(board, point, start, start + _LENGTH * ahead, symbol, 0.75)


def acceleration_arrow(board: Board, point: str, ahead: complex, symbol: Symbol | None, beside: bool = True) -> None:
    """A thinner arrow; ``beside`` the point, so that neither hides a velocity along the same line."""
    if symbol is None:
        return
    start = board.sketch.symbol_radius.get(point, 1.1)
    place = board.sketch.at[point]
    foot = place + (_roomier_side(board, place, ahead, max(start, _ASIDE)) if beside else ahead * start)
    _arrow(board, point, foot, foot + (0.8 if beside else 1.15) * _LENGTH * ahead, symbol, MEDIUM)


def arrows_beside(
    board: Board,
    point: str,
    place: complex,
    ways: tuple[complex, complex],
    symbols: tuple[Symbol | None, Symbol | None],
) -> None:
    """Velocity and acceleration along a link, on different sides of it; ``ways`` are directions, zero for none."""
    gap = max(board.sketch.symbol_radius.get(point, 1.1), _ASIDE)
    taken = 0j
    for way, symbol, weight, length in zip(ways, symbols, (0.75, MEDIUM), (1.0, 0.8), strict=True):
        if way == 0 or symbol is None:
            continue
        aside = _roomier_side(board, place, way, gap, taken)
        taken = aside
        _arrow(board, point, place + aside, place + aside + length * _LENGTH * way, symbol, weight)


def arrows_off_wall(
    board: Board, point: str, ways: tuple[complex, complex], symbols: tuple[Symbol | None, Symbol | None]
) -> None:
    """Velocity and acceleration of a point that slides along a wall: behind the hatching, one after the other.

    ``ways`` are the two directions (zero for a rate that is zero).
    """
    seen = [board.sketch.at[name] for name in board.shown]
    place = board.sketch.at[point]
    inner = sum(seen) / len(seen) - place
    covered = 0j
    for way, symbol, weight in zip(ways, symbols, (0.75, MEDIUM), strict=True):
        if way == 0 or symbol is None:
            continue
        aside = 1j * way if (inner * (1j * way).conjugate()).real < 0 else -1j * way
        foot = place + _OFF_WALL * aside + (covered if (covered * way.conjugate()).real > 0 else 0)
        _arrow(board, point, foot, foot + 0.9 * _LENGTH * way, symbol, weight)
        covered = (0.9 * _LENGTH + 1.5) * way


def _arrow(board: Board, point: str, foot: complex, tip: complex, symbol: Symbol, weight: float) -> None:
    sketch = board.sketch
    sketch.arrow(foot, tip, Layer.VECTOR, weight=weight)
    sketch.label(along_arrow(symbol, foot, tip))
    sketch.occupy(point, tip - sketch.at[point])


def _roomier_side(board: Board, point: complex, ahead: complex, gap: float, taken: complex = 0j) -> complex:
    """The way aside to a parallel arrow that crosses least of what is drawn already; near, below, right if equal.

    Not on the side on which another arrow has ``taken`` its place.
    """
    sides = sorted((1j * ahead, -1j * ahead), key=lambda side: (round(side.imag, 6), -round(side.real, 6)))
    ways = [symbol_radius * side for symbol_radius in (gap, gap + _WIDER) for side in sides]
    ways = [way for way in ways if (way * taken.conjugate()).real <= 0]
    parts = np.array([0.0, 0.25, 0.5, 0.75, 1.0]) * 1.2 * _LENGTH * ahead
    lanes = np.array([point + way + parts for way in ways])
    # Beyond the arrow its letters need room.
    beyond = np.array([point + way * (1 + _LETTERS / abs(way)) + parts for way in ways])
    places = np.concatenate((lanes, beyond)).ravel()
    crossed = np.minimum(board.sketch.crossings(places, (1.2, 1.2)), 2).reshape(2, len(ways), -1).sum(axis=2)
    return ways[int(np.argmin(crossed[0] + 0.5 * crossed[1]))]


def directed(rate: float, way: complex) -> complex:
    """The direction of a rate along a unit vector; zero for no rate."""
    return math.copysign(1.0, rate) * way if rate else 0j
