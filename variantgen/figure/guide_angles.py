"""The angle of an inclined guide with the horizontal, at an end of its ground line, where there is room for it."""

from __future__ import annotations

import cmath
import math

import numpy as np

from variantgen.figure.board import Board
from variantgen.figure.drawing import THIN, Arc, Layer
from variantgen.figure.placement.label_requests import along_arc, label_size
from variantgen.wording.formula import Formula

_SIDE = 9.0  # of the angle, u
_ARC = 6.5  # radius, u
_OFF = 1.2  # between the arc and its label, u
_ROOM = 2  # lines that the angle and its label may cross


def draw_guide_angle(board: Board, point: str, label: Formula) -> None:
    """The acute angle between the line of a guide, drawn on beyond its ground, and a horizontal line.

    Of the two ends that one is taken where less is crossed; nothing is drawn where both are crowded.
    """
    ends = board.grounds.get(point)
    if ends is None:
        return
    way = (ends[1] - ends[0]) / abs(ends[1] - ends[0])
    level = math.copysign(1.0, way.real)
    choices = [(ends[1], way, complex(level)), (ends[0], -way, complex(-level))]
    crossed, k = min((_crossed(board, *choice, label), k) for k, choice in enumerate(choices))
    if crossed > _ROOM:
        return
    corner, ahead, ray = choices[k]
    sketch = board.sketch
    for end in (ahead, ray):
        sketch.path((corner, corner + _SIDE * end), Layer.GROUND, THIN)
    start, sweep = cmath.phase(ray), cmath.phase(ahead / ray)
    sketch.arc(Arc(corner, _ARC, Layer.MARK, THIN, start, sweep))
    sketch.label(along_arc(label, corner, _ARC, start, sweep))


def _crossed(board: Board, corner: complex, ahead: complex, ray: complex, label: Formula) -> int:
    """How many lines pass through the angle or the place of its label."""
    middle = (ahead + ray) / abs(ahead + ray)
    half = [0.5 * side for side in label_size(label)]
    beside = corner + (_ARC + _OFF + math.hypot(*half)) * middle
    rays = [corner + part * _SIDE * end for end in (ahead, ray) for part in (0.3, 0.6, 1.0)]
    lines = board.sketch.crossings(np.array([*rays, corner + _ARC * middle]), (1.0, 1.0))
    letters = board.sketch.crossings(np.array([beside]), (half[0], half[1]))
    return int(np.sum(lines) + np.sum(letters))
