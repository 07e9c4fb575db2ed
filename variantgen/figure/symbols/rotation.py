"""Given rotation of a body: arcs with arrows for omega and, where accelerations are asked, epsilon."""

from __future__ import annotations

import math

import numpy as np

from variantgen.figure.board import Board
from variantgen.figure.labels import GAP, along_arc, label_size
from variantgen.mechanism.drivers.rotation import Rotation
from variantgen.wording.formula import Symbol

_SWEEP = math.radians(62)
_RADII = (6.4, 8.8)
_OFF_RIM = 2.4
# Above first: ties go to the place where a reader expects the arc.
_ANGLES = tuple(
    math.radians(a) for a in (60, 80, 100, 120, 40, 140, 20, 160, 0, 180, 200, 220, 240, 260, 280, 300, 320, 340)
)


def draw(board: Board, driver: Rotation) -> None:
    """Add the arcs about the fixed point of the body, where there is most room."""
    sketch = board.sketch
    pivot = board.centre_of_rotation(driver.body)
    sense = float(board.frame.sense)
    rates = [("omega", sense * float(driver.omega)), ("epsilon", sense * float(driver.epsilon))]
    # The two arcs never lie side by side: which label and which sense belong together must be plain.
    placed: float | None = None
    for radius, (kind, rate) in zip(_radii(board, driver, pivot), rates, strict=True):
        if rate == 0 or (kind == "epsilon" and not board.accelerations):
            continue
        turn = math.copysign(_SWEEP, rate)
        formula = board.rate(driver, kind)
        if formula is None:
            continue
        middle = _roomiest(board, pivot, radius, turn, formula, placed)
        placed = middle
        request = along_arc(formula, sketch.at[pivot], radius, middle - turn / 2, turn)
        sketch.arc_arrow(sketch.at[pivot], radius, middle - turn / 2, turn)
        sketch.label(request)
        for part in (-0.5, 0.0, 0.5):
            sketch.busy.setdefault(pivot, []).append(middle + part * turn)


def _radii(board: Board, driver: Rotation, pivot: str) -> tuple[float, float]:
    """Radii of the two arcs: about the pivot or, where another given rotation is drawn there, outside the rim."""
    others = [other for other in board.scene.drivers if isinstance(other, Rotation) and other is not driver]
    if not any(board.centre_of_rotation(other.body) == pivot for other in others):
        return _RADII
    rim = max(board.discs.get(driver.body, [0.0]))
    return (rim + _OFF_RIM, rim + 2 * _OFF_RIM) if rim > _RADII[0] else _RADII


def _roomiest(board: Board, pivot: str, radius: float, turn: float, formula: Symbol, other: float | None) -> float:
    """The direction in which the arc and the label at its middle cross least of what is drawn already."""
    sketch = board.sketch
    centre = sketch.at[pivot]
    width, height = label_size(formula)
    ways = np.exp(1j * np.array(_ANGLES))
    parts = np.exp(1j * turn * np.array([-0.5, -0.25, 0.0, 0.25, 0.55]))
    arcs = (centre + radius * ways[:, None] * parts[None, :]).ravel()
    names = centre + ways * (radius + 0.7 + 0.5 * (width * np.abs(ways.real) + height * np.abs(ways.imag)))
    crossed = np.minimum(sketch.crossings(arcs, (0.7, 0.7)), 1).reshape(-1, 5).sum(axis=1)
    covered = np.minimum(sketch.crossings(names, (0.5 * width + GAP, 0.5 * height + GAP)), 3)
    room = np.array([max(0.0, math.radians(40) - sketch.freedom(pivot, angle)) for angle in _ANGLES])
    apart = [math.pi if other is None else abs(math.remainder(angle - other, math.tau)) for angle in _ANGLES]
    too_close = np.array(apart) < _SWEEP + math.radians(50)
    return _ANGLES[int(np.argmin(3 * crossed + 5 * covered + 4 * room + 100 * too_close))]
