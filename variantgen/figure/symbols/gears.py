"""Gear mesh: two pitch circles that touch, in dashes and dots; what is toothed lies on the side of its body.

A rack has a pitch line (see :mod:`variantgen.figure.symbols.rolling`).

The contours of moving gears are discs of their bodies; a fixed gear is drawn here, with hatching.
"""

from __future__ import annotations

import cmath
import math

from variantgen.figure.board import Board
from variantgen.figure.drawing import MEDIUM, THIN, Arc, Layer
from variantgen.mechanism.joints.gears import Gears
from variantgen.mechanism.joints.rolling import Rolling

_TOOTH, _OF_RADIUS = 1.2, 0.1  # from the pitch circle to the contour of a gear: at most (u), part of the radius


def contour(board: Board, centre: str, radius: float) -> float:
    """The radius (u) of the contour of a disc about a point: that of its pitch circle less the teeth, if it is a gear.

    A ring has its body outside.
    """
    for joint in board.scene.joints:
        if isinstance(joint, Gears):
            own, other = _pitch_radii(board, joint)
            if centre == joint.centre and math.isclose(radius, own, rel_tol=1e-6):
                return _contour(radius, False)
            if centre == joint.other_centre and math.isclose(radius, other, rel_tol=1e-6):
                return _contour(radius, joint.inside)
        if isinstance(joint, Rolling) and board.is_rack(joint.on) and centre == joint.centre:
            own = abs(board.sketch.at[joint.contact] - board.sketch.at[centre])
            if math.isclose(radius, own, rel_tol=1e-6):
                return _contour(radius, False)
    return radius


def is_moving(board: Board, centre: str, radius: float) -> bool:
    """Whether a disc without a body of its own is a gear that is fixed to a moving link."""
    for joint in board.scene.joints:
        if isinstance(joint, Gears) and joint.other and centre == joint.other_centre:
            return math.isclose(radius, _pitch_radii(board, joint)[1], rel_tol=1e-6)
        if isinstance(joint, Rolling) and board.is_rack(joint.on) and centre == joint.centre:
            return True
    return False


def draw(board: Board, joint: Gears) -> None:
    """Add the pitch circles and the fixed gear, if one is fixed: its contour, hatched on the side of its body."""
    sketch = board.sketch
    centre, other = sketch.at[joint.centre], sketch.at[joint.other_centre]
    ray = (centre - other) / abs(centre - other)
    for point, way in ((joint.centre, ray if joint.inside else -ray), (joint.other_centre, ray)):
        sketch.occupy(point, way)
    own, radius = _pitch_radii(board, joint)
    for place, pitch in ((centre, own), (other, radius)):
        pitch_circle(board, place, pitch)
    if joint.other is not None:
        return
    body = _contour(radius, joint.inside)
    sketch.arc(Arc(other, body, Layer.GROUND, MEDIUM))
    if joint.inside:
        sketch.hatch_arc(other, body, -math.pi, math.tau, outside=True)
    else:
        for middle in (cmath.phase(ray) + math.pi / 2, cmath.phase(ray) - math.pi / 2, cmath.phase(-ray)):
            sketch.hatch_arc(other, body, middle - math.radians(24), math.radians(48), outside=False)


def tooth(pitch: float) -> float:
    """From the pitch circle of a radius, or the pitch line of its rack, to the contour (u)."""
    return min(_TOOTH, _OF_RADIUS * pitch)


def _contour(pitch: float, ring: bool) -> float:
    return pitch + tooth(pitch) if ring else pitch - tooth(pitch)


def pitch_circle(board: Board, centre: complex, radius: float) -> None:
    """Add a pitch circle, once for a gear in two meshes."""
    circle = Arc(centre, radius, Layer.DISC, THIN, dash="dashdot")
    drawn = [line for line in board.sketch.lines if isinstance(line, Arc) and line.dash == circle.dash]
    if not any(abs(line.centre - centre) + abs(line.radius - radius) < 1e-6 for line in drawn):
        board.sketch.arc(circle)


def _pitch_radii(board: Board, joint: Gears) -> tuple[float, float]:
    """The radii of the two pitch circles, u."""
    own = float(joint.radius) * board.sketch.scale
    between = abs(board.sketch.at[joint.centre] - board.sketch.at[joint.other_centre])
    return own, between + (own if joint.inside else -own)
