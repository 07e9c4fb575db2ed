"""Block in a slot curved as a circular arc; hatched where the slot is fixed."""

from __future__ import annotations

import cmath
import math

from variantgen.figure.board import Board
from variantgen.figure.drawing import MEDIUM, THIN, Arc, Layer
from variantgen.figure.sketch import HINGE
from variantgen.mechanism.joints.arc_slot import ArcSlot

_HALF_WIDTH, _HALF_BLOCK = 1.5, 2.4
_HALF_SWEEP = math.radians(48)
_BEYOND = math.radians(18)


def draw(board: Board, joint: ArcSlot) -> None:
    """Add the two edges of the slot about the point, and the block."""
    if joint.point in board.form.figure.bare:
        return
    sketch = board.sketch
    place, centre = sketch.at[joint.point], sketch.at[joint.centre]
    radius, middle = abs(place - centre), cmath.phase(place - centre)
    inner, outer = radius - _HALF_WIDTH, radius + _HALF_WIDTH
    start, sweep = _extent(board, joint, radius, middle)
    if joint.centre in board.shown:
        sketch.path((centre, place), Layer.GROUND, THIN, dash="dashdot")
        sketch.occupy(joint.centre, place - centre)
    for edge in (inner, outer):
        sketch.arc(Arc(centre, edge, Layer.GROUND, MEDIUM, start, sweep))
    for angle in (start, start + sweep):
        sketch.path((centre + cmath.rect(inner, angle), centre + cmath.rect(outer, angle)), Layer.GROUND, MEDIUM)
    if joint.body is None:
        inside = _comes_from_inside(board, joint, radius)
        sketch.hatch_arc(centre, outer if inside else inner, start, sweep, outside=inside)
    ray = cmath.rect(1.0, middle)
    corners = [
        place + x * _HALF_BLOCK * 1j * ray + y * 0.8 * _HALF_WIDTH * ray
        for x, y in ((-1, -1), (1, -1), (1, 1), (-1, 1))
    ]
    sketch.path(corners, Layer.SLIDER, closed=True, fill="paper")
    sketch.circle(place, HINGE, Layer.HINGE, fill="paper")
    for taken in (1j * ray, -1j * ray):
        sketch.occupy(joint.point, taken)
    board.sized(joint.point, _HALF_BLOCK, box=corners)


def _comes_from_inside(board: Board, joint: ArcSlot, radius: float) -> bool:
    """Whether the link that ends in the slot comes from the side of the centre."""
    centre = board.sketch.at[joint.centre]
    links = [name for body in board.owners(joint.point) for name in board.form.bodies[body] if name != joint.point]
    return all(abs(board.sketch.at[name] - centre) < radius for name in links[:1])


def _extent(board: Board, joint: ArcSlot, radius: float, middle: float) -> tuple[float, float]:
    """Start and sweep of the slot: about the block or, where the body has another point on the arc, about that one."""
    centre = board.sketch.at[joint.centre]
    members = board.form.bodies.get(joint.body or "", ())
    for name in members:
        step = board.sketch.at[name] - centre
        if name != joint.point and abs(abs(step) - radius) < 1e-6 * radius:
            anchor = cmath.phase(step)
            away = abs(math.remainder(middle - anchor, math.tau))
            half = min(max(_HALF_SWEEP, away + _BEYOND), math.radians(170))
            return anchor - half, 2 * half
    return middle - _HALF_SWEEP, 2 * _HALF_SWEEP
