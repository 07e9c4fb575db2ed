"""Given rotation of a body: arcs with arrows for omega and, where accelerations are asked, epsilon."""

from __future__ import annotations

import math
from collections.abc import Iterable, Sequence
from typing import Any

import numpy as np
from numpy.typing import NDArray

from variantgen.figure.board import Board
from variantgen.figure.drawing import Arc, Layer, RotationArc
from variantgen.figure.placement.choices import GAP
from variantgen.figure.placement.label_requests import along_arc, label_size
from variantgen.mechanism.drivers.rotation import Rotation
from variantgen.wording.formula import Symbol

SEEKS_ROOM = True
_SWEEP = math.radians(70)
_LONGEST = 16.0  # length of an arc, u
_RADII = (6.2, 8.4, 10.4)
_WIDER = 13.0  # radius of an arc inside a large ring of another body, u
_ROOMY = 16.0  # radius of a disc with room for arcs about its axis and the letter of the axis, u
_OF_PLATE, _ON_PLATE = (0.62, 0.5), (7.4, 11.0)  # radii of arcs on a plate: parts of the room there, bounds (u)
_OFF_RIM = (2.4, 4.8)
_LEAST = 5.0  # radius of an arc, u
_MARGIN = 0.8  # free space on both sides of an arc, u
_STRANGE = 14.0  # distance at which an arc cannot be taken for another one's, u
_APART = math.radians(115)  # between the two arcs of one body
_FINALISTS = 9
_FREE = 3.0  # cost of an arc that crosses nothing and whose letters cover nothing
_MOST_RADII = 4
_ROOM = math.radians(40)  # from an arc to the nearest link at its pivot
_ANGLES = np.radians(np.arange(0, 360, 15))
_WAYS = np.exp(1j * _ANGLES)
_ACROSS, _ALONG = np.abs(_WAYS.real), np.abs(_WAYS.imag)
# Above first: ties go to the place where a reader expects the arc.
_ANGLE_COSTS = 0.6 * (1 - np.sin(_ANGLES)) + 0.05 * np.abs(np.cos(_ANGLES)) + 0.001 * np.arange(_ANGLES.size)
# Costs of a line that crosses an arc, of one under its letters, of a link close by, of the other arc or one of another
# body near it, of a disc on which it lies without belonging there, of each step to a less usual radius.
_CROSSED, _COVERED, _CLOSE, _TOGETHER, _STRANGER, _ON_DISC, _UNUSUAL = 12.0, 5.0, 3.0, 100.0, 8.0, 20.0, 1.2


def draw(board: Board, driver: Rotation) -> None:
    """Add the arcs of the given rates."""
    sense = float(board.frame.sense)
    rates = {"omega": sense * float(driver.omega)}
    if board.accelerations:
        rates["epsilon"] = sense * float(driver.epsilon)
    symbols = {kind: board.rate(driver, kind) for kind, rate in rates.items() if rate}
    draw_arcs(board, driver.body, [(symbol, rates[kind]) for kind, symbol in symbols.items() if symbol is not None])


def draw_arcs(board: Board, body: str, rates: Sequence[tuple[Symbol, float]], about: str = "") -> None:
    """Add arcs with the symbols of rates of a body (positive counter-clockwise on paper), where there is most room.

    Their centre is the fixed point of the body, or what ``sketch.at`` has under the key ``about``.
    """
    if not rates:
        return
    sketch = board.sketch
    pivot = about or board.centre_of_rotation(body)
    radii = _radii(board, body, pivot)
    own = tuple(board.discs[body]) if any(d.body == body and d.centre == pivot for d in board.form.figure.discs) else ()
    taken: list[float] = []
    # The same for both arcs of a body: the second is too far from the first to meet it.
    costs = _costs_of_arcs(board, pivot, radii)
    for formula, rate in rates:
        radius, middle = _roomiest_arc(board, pivot, radii, costs, formula, taken)
        turn = math.copysign(_sweep(radius), rate)
        taken.append(middle)
        arc = sketch.arc_arrow(sketch.at[pivot], radius, middle - turn / 2, turn)
        sketch.rotations.append(RotationArc(formula, arc, own))
        sketch.label(along_arc(formula, sketch.at[pivot], radius, middle - turn / 2, turn))
        for part in (-0.5, 0.0, 0.5):
            sketch.busy.setdefault(pivot, []).append(middle + part * turn)


def _sweep(radius: float) -> float:
    """Angle of an arc: a wide one is not longer than a narrow one."""
    return min(_SWEEP, _LONGEST / radius)


def _radii(board: Board, body: str, pivot: str) -> NDArray[np.float64]:
    """Radii of an arc, the usual ones first: about the pivot, along the rim of a disc of the body, or to fit a plate.

    An arc keeps off the rims of discs about the same axis, and inside those of other bodies that turn: outside it would
    show their rotation.
    """
    if pivot not in board.scene.bodies[body] and body in board.form.figure.plates:
        return _on_plate(board, body, pivot)
    about = [disc for disc in board.form.figure.discs if not disc.arc and disc.centre == pivot]
    rims = sorted(r for disc in about for r in board.discs.get(disc.body, []))
    own = max((r for disc in about if disc.body == body for r in board.discs[disc.body]), default=0.0)
    strange = [r for disc in about if disc.body not in ("", body) for r in board.discs.get(disc.body, [])]
    least = math.inf if own else min(strange, default=math.inf)
    alone = sum(isinstance(other, Rotation) for other in board.scene.drivers) == 1
    inner = list(_RADII) if not own or alone else []
    along = [rim + off for rim in rims for off in _OFF_RIM]
    # Inside a small step of a drum arcs would leave no room for the letter of the axis.
    found = along + inner if len(rims) > 1 and rims[0] < _ROOMY else inner + along
    found += [_WIDER] if least < math.inf else []
    if own > 2 * _LEAST:
        found.append(own - 3.0)
    clear = [r for r in found if _LEAST <= r < least and all(abs(r - rim) > _OFF_RIM[0] - 0.1 for rim in rims)]
    return np.array(clear[:_MOST_RADII] or [max(rims, default=0.0) + off for off in _OFF_RIM])


def _on_plate(board: Board, body: str, middle: str) -> NDArray[np.float64]:
    """Radii of an arc about the middle of a plate, in proportion to the room there."""
    corners = np.array([board.sketch.at[name] for name in board.scene.bodies[body]]) - board.sketch.at[middle]
    sides = np.roll(corners, -1) - corners
    room = float(np.min(np.abs((corners * np.conj(sides)).imag) / np.abs(sides)))
    return np.clip(room * np.array(_OF_PLATE), *_ON_PLATE)


def _costs_of_arcs(board: Board, pivot: str, radii: NDArray[np.float64]) -> NDArray[np.float64]:
    """What arcs of each radius in each direction cost without their letters, shape (radii, angles)."""
    centre = board.sketch.at[pivot]
    costs = _ANGLE_COSTS + _CLOSE * np.maximum(0.0, _ROOM - board.sketch.freedom(pivot, _ANGLES))
    costs = costs + _CROSSED * _crossed(board, centre, radii)
    return costs + _ON_DISC * _on_other_discs(board, centre, centre + _WAYS * radii[:, None])


def _roomiest_arc(
    board: Board,
    pivot: str,
    radii: NDArray[np.float64],
    costs: NDArray[np.float64],
    formula: Symbol,
    taken: Sequence[float],
) -> tuple[float, float]:
    """Radius and direction of the middle of the arc that crosses least, with letters that cover least.

    ``costs`` are those of the arcs without letters. It is not mistaken for another one: the arcs of one body (``taken``
    directions) never lie side by side. A less usual radius is tried only where no arc of the radii before it is free.
    """
    best = (math.inf, 0.0, 0.0)
    directions = _roomiest_directions(board, pivot, radii, costs, formula, taken)
    for number, (radius, cost, angle) in enumerate(directions):
        if best[0] < _FREE:
            break
        best = min(best, (cost + _UNUSUAL * number, radius, angle))
    return best[1], best[2]


def _roomiest_directions(
    board: Board,
    pivot: str,
    radii: NDArray[np.float64],
    costs: NDArray[np.float64],
    formula: Symbol,
    taken: Sequence[float],
) -> Iterable[tuple[float, float, float]]:
    """Radius, cost and direction of the best arc of each radius.

    All radii are compared at once: that takes no longer than two of them, one after the other.
    """
    sketch = board.sketch
    centre = sketch.at[pivot]
    half_width, half_height = (0.5 * side for side in label_size(formula))
    places = centre + _WAYS * (radii[:, None] + 1.0 + half_width * _ACROSS + half_height * _ALONG)
    middles = centre + _WAYS * radii[:, None]
    for other in taken:
        gap = np.abs(np.remainder(_ANGLES - other + math.pi, math.tau) - math.pi)
        costs = costs + _TOGETHER * (gap < _APART)
    costs = costs + _STRANGER * _near_other_arcs(board, places, middles)
    # What the letters would cover is asked only of the arcs that are best without it.
    best = costs.argsort(axis=1, kind="stable")[:, :_FINALISTS]
    rows = np.arange(len(radii))[:, None]
    covered = sketch.crossings(places[rows, best].ravel(), (half_width + GAP, half_height + GAP))
    total = costs[rows, best] + _COVERED * np.minimum(covered, 4).reshape(best.shape)
    chosen = total.argmin(axis=1)[:, None]
    angles = _ANGLES[best[rows, chosen]]
    return zip(radii.tolist(), total[rows, chosen].ravel().tolist(), angles.ravel().tolist(), strict=True)


def _crossed(board: Board, centre: complex, radii: NDArray[np.float64]) -> NDArray[np.float64]:
    """How many lines the arc of each radius in each direction meets or nearly meets, shape (radii, angles)."""
    ways, owner = board.sketch.obstacles.met_near_circles(centre, radii, _MARGIN)
    cosines = _WAYS.real[:, None] * ways.real + _WAYS.imag[:, None] * ways.imag
    least = np.array([math.cos(0.5 * _sweep(radius) + _MARGIN / radius) for radius in radii.tolist()])
    angle, met = (cosines > least[owner]).nonzero()
    count = np.bincount(owner[met] * _ANGLES.size + angle, minlength=len(radii) * _ANGLES.size)
    return np.minimum(count, 5).astype(float).reshape(len(radii), -1)


def _on_other_discs(board: Board, centre: complex, places: NDArray[Any]) -> NDArray[np.bool_] | bool:
    """Which places lie on discs about other points, or close to them."""
    found: NDArray[np.bool_] | bool = False
    for disc in board.form.figure.discs:
        other = board.sketch.at[disc.centre]
        radius = max(board.discs.get(disc.body, [0.0])) + _OFF_RIM[0]
        if abs(other - centre) > radius:
            found = found | (np.abs(places - other) < radius)
    return found


def _near_other_arcs(board: Board, places: NDArray[Any], middles: NDArray[Any]) -> NDArray[np.float64] | float:
    """How close letters (and, half as bad, arcs) are to arcs of rotation drawn before: 1 on such an arc, 0 far away."""
    arcs = [line for line in board.sketch.lines if isinstance(line, Arc) and line.layer == Layer.VECTOR]
    if not arcs:
        return 0.0
    seen = np.array([arc.at(part) for arc in arcs for part in (0.0, 0.5, 1.0)])
    near = [
        np.maximum(0.0, 1.0 - np.min(np.abs(every[..., None] - seen), axis=-1) / _STRANGE)
        for every in (places, middles)
    ]
    return np.asarray(near[0] + 0.5 * near[1])
