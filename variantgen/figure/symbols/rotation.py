"""Given rotation of a body: arcs with arrows for omega and, where accelerations are asked, epsilon."""

from __future__ import annotations

import cmath
import math

from variantgen.figure.board import Board
from variantgen.figure.labels import along_arc
from variantgen.mechanism.drivers.rotation import Rotation
from variantgen.wording.formula import Symbol

_SWEEP = math.radians(62)
_RADII = (6.4, 8.8)
# Above first: ties go to the place where a reader expects the arc.
_ANGLES = tuple(math.radians(a) for a in (60, 80, 100, 120, 40, 140, 20, 160, 0, 180, 200, 220, 240, 260, 280, 300, 320, 340))


def draw(board: Board, driver: Rotation) -> None:
    """Add the arcs about the fixed point of the body, where there is most room."""
    sketch = board.sketch
    pivot = board.pivot_of(driver.body)
    sense = float(board.frame.sense)
    rates = [("omega", sense * float(driver.omega)), ("epsilon", sense * float(driver.epsilon))]
    for radius, (kind, rate) in zip(_RADII, rates, strict=True):
        if rate == 0 or (kind == "epsilon" and not board.accelerations):
            continue
        turn = math.copysign(_SWEEP, rate)
        formula = board.symbol(f"{kind}_{driver.body}")
        middle = min(_ANGLES, key=lambda angle: _cost(board, pivot, radius, angle, turn, formula))
        request = along_arc(formula, sketch.at[pivot], radius, middle - turn / 2, turn)
        sketch.arc_arrow(sketch.at[pivot], radius, middle - turn / 2, turn)
        sketch.label(request)
        for part in (-0.5, 0.0, 0.5):
            sketch.busy.setdefault(pivot, []).append(middle + part * turn)


def _cost(board: Board, pivot: str, radius: float, middle: float, turn: float, formula: Symbol) -> float:
    """What an arc about this angle would cross, and what its label would."""
    sketch = board.sketch
    centre = sketch.at[pivot]
    arc = [centre + cmath.rect(radius, middle + part * turn) for part in (-0.5, -0.25, 0.0, 0.25, 0.55)]
    request = along_arc(formula, centre, radius, middle - turn / 2, turn)
    crossing = sketch.crossings(arc, 0.7)
    room = max(0.0, math.radians(40) - sketch.freedom(pivot, middle))
    return 3 * crossing + sketch.least_cost(request) + 4 * room
