"""The circle on which a wheel rolls: an arc with hatching when it is fixed."""

from __future__ import annotations

import cmath
import math

from variantgen.figure.board import Board
from variantgen.figure.drawing import BOLD, Arc, Layer
from variantgen.mechanism.joints.rolling_on_circle import RollingOnCircle

_HALF_SWEEP = math.radians(62)


def draw(board: Board, joint: RollingOnCircle) -> None:
    """Add the arc about the contact; the circle of a moving body is drawn as a disc of that body."""
    sketch = board.sketch
    centre, around = sketch.at[joint.centre], sketch.at[joint.around]
    ray = (centre - around) / abs(centre - around)
    wheel = float(joint.radius) * sketch.scale
    radius = abs(centre - around) + (wheel if joint.inside else -wheel)
    sketch.occupy(joint.centre, ray if joint.inside else -ray)
    if joint.on is not None:
        return
    # A small wheel on a large circle needs a short arc.
    half = min(_HALF_SWEEP, max(3.2 * wheel / radius, math.radians(28)))
    start = cmath.phase(ray) - half
    if board.is_disc(joint.around):
        start, half = -math.pi, math.pi
    sketch.arc(Arc(around, radius, Layer.GROUND, BOLD, start, 2 * half))
    sketch.hatch_arc(around, radius, start, 2 * half, outside=joint.inside)
