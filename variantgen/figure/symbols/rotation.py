"""Given rotation of a body: arcs with arrows for omega and, where accelerations are asked, epsilon."""

from __future__ import annotations

import math
from typing import Any

import numpy as np
from numpy.typing import NDArray

from variantgen.figure.board import Board
from variantgen.figure.drawing import Arc, Layer
from variantgen.figure.labels import GAP, along_arc, label_size
from variantgen.mechanism.drivers.rotation import Rotation
from variantgen.wording.formula import Symbol

_SWEEP = math.radians(62)
_RADII = (6.2, 10.4)
_OFF_RIM = 2.4
_SAMPLES = 11  # of an arc: closer together than a line and its head are wide
_LONGEST = 16.0  # length of an arc, u
_STRANGE = 14.0  # distance at which an arc cannot be taken for another one's, u
_ROOMY = 14.0  # radius of a disc in which two arcs with their letters find room, u
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
        turn = math.copysign(min(_SWEEP, _LONGEST / radius), rate)
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
    """Radii of the two arcs: about the pivot or, for a small disc or one of several driven bodies, outside the rim."""
    rim = max(board.discs.get(driver.body, [0.0]))
    alone = sum(isinstance(other, Rotation) for other in board.scene.drivers) == 1
    if rim == 0:
        # The arcs of a crank do not run along the rim of a wheel about the same axis.
        centred = [disc for disc in board.form.figure.discs if disc.centre == pivot and not disc.arc]
        rims = [
            r for disc in centred for r in board.discs[disc.body] if _RADII[0] - _OFF_RIM < r < _RADII[1] + _OFF_RIM
        ]
        rim = max(rims, default=0.0)
    if rim == 0 or (alone and rim > _ROOMY):
        return _RADII
    return rim + _OFF_RIM, rim + 2 * _OFF_RIM


def _roomiest(board: Board, pivot: str, radius: float, turn: float, formula: Symbol, other: float | None) -> float:
    """The direction in which the arc and the label at its middle cross least of what is drawn already."""
    sketch = board.sketch
    centre = sketch.at[pivot]
    width, height = label_size(formula)
    ways = np.exp(1j * np.array(_ANGLES))
    parts = np.exp(1j * turn * np.linspace(-0.5, 0.56, _SAMPLES))
    arcs = (centre + radius * ways[:, None] * parts[None, :]).ravel()
    names = centre + ways * (radius + 0.7 + 0.5 * (width * np.abs(ways.real) + height * np.abs(ways.imag)))
    crossed = np.minimum(sketch.crossings(arcs, (0.7, 0.7)), 1).reshape(-1, _SAMPLES).mean(axis=1)
    covered = np.minimum(sketch.crossings(names, (0.5 * width + GAP, 0.5 * height + GAP)), 3)
    room = np.array([max(0.0, math.radians(40) - sketch.freedom(pivot, angle)) for angle in _ANGLES])
    apart = [math.pi if other is None else abs(math.remainder(angle - other, math.tau)) for angle in _ANGLES]
    too_close = np.array(apart) < _SWEEP + math.radians(50)
    inside = _on_other_discs(board, centre, arcs).reshape(-1, _SAMPLES).mean(axis=1)
    strange = _near_other_arcs(board, names) + 0.5 * _near_other_arcs(board, centre + radius * ways)
    return _ANGLES[int(np.argmin(15 * crossed + 5 * covered + 4 * room + 100 * too_close + 8 * strange + 15 * inside))]


def _on_other_discs(board: Board, centre: complex, places: NDArray[Any]) -> NDArray[np.bool_]:
    """Which places lie on discs about other points, or close to them."""
    found = np.zeros(len(places), dtype=bool)
    for disc in board.form.figure.discs:
        other = board.sketch.at[disc.centre]
        radius = max(board.discs.get(disc.body, [0.0])) + _OFF_RIM
        if abs(other - centre) > radius:
            found |= np.abs(places - other) < radius
        elif abs(other - centre) > _OFF_RIM:
            # Inside a ring: not across it.
            found |= np.abs(places - other) > radius - 2 * _OFF_RIM
    return found


def _near_other_arcs(board: Board, places: NDArray[Any]) -> NDArray[np.float64]:
    """How close places are to arcs of rotation drawn before: 1 on such an arc, 0 from ``_STRANGE`` on."""
    arcs = [line for line in board.sketch.lines if isinstance(line, Arc) and line.layer == Layer.VECTOR]
    seen = np.array([arc.at(part) for arc in arcs for part in (0.0, 0.25, 0.5, 0.75, 1.0)], dtype=complex)
    if not seen.size:
        return np.zeros(len(places))
    gaps = np.min(np.abs(places[:, None] - seen[None, :]), axis=1)
    return np.asarray(np.maximum(0.0, 1.0 - gaps / _STRANGE))
