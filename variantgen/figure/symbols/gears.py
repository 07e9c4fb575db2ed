"""Gear mesh: the pitch circles are discs of the bodies; a fixed gear is drawn here, with hatching."""

from __future__ import annotations

import cmath
import math

from variantgen.figure.board import Board
from variantgen.figure.drawing import MEDIUM, Arc, Layer
from variantgen.mechanism.joints.gears import Gears


def draw(board: Board, joint: Gears) -> None:
    """Add the fixed gear, if one is fixed: its pitch circle, hatched on the side of its body."""
    sketch = board.sketch
    centre, other = sketch.at[joint.centre], sketch.at[joint.other_centre]
    ray = (centre - other) / abs(centre - other)
    for point, way in ((joint.centre, ray if joint.inside else -ray), (joint.other_centre, ray)):
        sketch.occupy(point, way)
    if joint.other is not None:
        return
    gear = float(joint.radius) * sketch.scale
    radius = abs(centre - other) + (gear if joint.inside else -gear)
    sketch.arc(Arc(other, radius, Layer.GROUND, MEDIUM))
    if joint.inside:
        sketch.hatch_arc(other, radius, -math.pi, math.tau, outside=True)
    else:
        for middle in (cmath.phase(ray) + math.pi / 2, cmath.phase(ray) - math.pi / 2, cmath.phase(-ray)):
            sketch.hatch_arc(other, radius, middle - math.radians(24), math.radians(48), outside=False)
