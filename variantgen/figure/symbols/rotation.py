"""Given rotation of a body: arcs with arrows for omega and, where accelerations are asked, epsilon."""

from __future__ import annotations

import math

from variantgen.figure.board import Board
from variantgen.figure.labels import along_arc
from variantgen.mechanism.drivers.rotation import Rotation

_SWEEP = math.radians(62)
_RADII = (6.4, 8.8)


def draw(board: Board, driver: Rotation) -> None:
    """Add the arcs about the fixed point of the body, where there is most room."""
    sketch = board.sketch
    pivot = board.pivot_of(driver.body)
    sense = float(board.frame.sense)
    rates = [("omega", sense * float(driver.omega)), ("epsilon", sense * float(driver.epsilon))]
    for radius, (kind, rate) in zip(_RADII, rates, strict=True):
        if rate == 0 or (kind == "epsilon" and not board.accelerations):
            continue
        angles = [math.radians(15 * k) for k in (4, 5, 3, 6, 2, 7, 1, 8, 0, *range(9, 24))]
        middle = sketch.freest(pivot, angles, math.radians(45))
        turn = math.copysign(_SWEEP, rate)
        sketch.arc_arrow(sketch.at[pivot], radius, middle - turn / 2, turn)
        sketch.label(along_arc(board.symbol(f"{kind}_{driver.body}"), sketch.at[pivot], radius, middle - turn / 2, turn))
        for part in (-0.5, 0.0, 0.5):
            sketch.busy[pivot].append(middle + part * turn)
