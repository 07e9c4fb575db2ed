"""Given motion of a point: arrows for velocity and, where accelerations are asked, acceleration."""

from __future__ import annotations

import math

import numpy as np

from variantgen.figure.board import Board
from variantgen.figure.drawing import MEDIUM, Layer
from variantgen.figure.labels import along_arrow
from variantgen.mechanism.drivers.travel import Travel

_LENGTH = 11.0
_ASIDE = 3.6


def draw(board: Board, driver: Travel) -> None:
    """Add the arrows; the acceleration is drawn beside the velocity, so that neither hides the other."""
    sketch = board.sketch
    point = sketch.at[driver.point]
    way = complex(board.frame.direction(driver.angle))
    start = sketch.reach.get(driver.point, 1.1)
    rates = [("v", float(driver.v)), ("a", float(driver.a) if board.accelerations else 0.0)]
    for kind, rate in rates:
        if rate == 0:
            continue
        ahead = math.copysign(1.0, rate) * way
        if kind == "v":
            foot, tip = point + ahead * start, point + ahead * (start + _LENGTH)
        else:
            foot = point + _roomier_side(board, point, ahead, max(start, _ASIDE))
            tip = foot + 0.8 * _LENGTH * ahead
        sketch.arrow(foot, tip, Layer.VECTOR, weight=0.75 if kind == "v" else MEDIUM)
        sketch.label(along_arrow(board.symbol(f"{kind}_{driver.point}"), foot, tip))
        sketch.occupy(driver.point, tip - point)


def _roomier_side(board: Board, point: complex, ahead: complex, gap: float) -> complex:
    """The way aside to a parallel arrow that crosses less of what is drawn already; below or right if equal."""
    sides = sorted((gap * 1j * ahead, -gap * 1j * ahead), key=lambda side: (round(side.imag, 6), -round(side.real, 6)))
    lanes = [[point + side + part * 1.2 * _LENGTH * ahead for part in (0.0, 0.25, 0.5, 0.75, 1.0)] for side in sides]
    crossed = [int(np.sum(board.sketch.crossings(lane, (1.2, 1.2)))) for lane in lanes]
    return sides[0] if crossed[0] <= crossed[1] else sides[1]
