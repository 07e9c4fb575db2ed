"""Given motion of a point: arrows for velocity and, where accelerations are asked, acceleration."""

from __future__ import annotations

import math

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
    aside = way * 1j
    if sketch.freedom(driver.point, math.atan2(aside.imag, aside.real)) < 0.5:
        aside = -aside
    for kind, rate in rates:
        if rate == 0:
            continue
        ahead = math.copysign(1.0, rate) * way
        foot = point + ahead * start if kind == "v" else point + aside * max(start, _ASIDE)
        tip = foot + ahead * (_LENGTH if kind == "v" else 0.8 * _LENGTH)
        sketch.arrow(foot, tip, Layer.VECTOR, weight=0.75 if kind == "v" else MEDIUM)
        sketch.label(along_arrow(board.symbol(f"{kind}_{driver.point}"), foot, tip))
        sketch.occupy(driver.point, tip - point)
