"""The angles and segments of which a step speaks, marked in its figure: arcs with a letter or value, dashed lines."""

from __future__ import annotations

import cmath
import math
from collections.abc import Sequence

import numpy as np
from msgspec.structs import replace

from variantgen.figure.drawing import THIN, Arc, Layer
from variantgen.figure.equations.body_board import FigureSubject
from variantgen.figure.equations.surroundings import squares_to_segments
from variantgen.figure.motion.motion_board import MotionBoard
from variantgen.figure.placement.label_requests import along_arc, around
from variantgen.figure.sketch import Sketch
from variantgen.methods.steps.step_geometry import Corner, MarkedFoot
from variantgen.wording.formula import Formula, Symbol
from variantgen.wording.solution.formulas import Formulas
from variantgen.wording.solution.quantity_symbols import Symbols

_ARC, _WIDER = 7.0, 3.2  # radius of an arc; how much more that of a further one at the same vertex has, u
_BEYOND = 3.5  # how far a side that no line carries goes on beyond the arc, u
_ON_SIDE = (0.6, 0.8, 1.0)  # where a line must lie on a side, in radii of the arc
_FOOT_SQUARE = 2.2  # the same at the foot of a perpendicular, u
_SQUARE = 3.2  # side of the mark of a right angle, u
_LEAST_LEG = 1.8  # a perpendicular that is shorter, or has its foot nearer to a point, is not drawn, u
_NARROW = math.radians(20)  # a smaller angle is marked farther from its vertex
_LEAST = math.radians(4)  # a smaller one not at all
_SAME = math.radians(1)
_ON_LINE = 1.0  # from a line that is a side of an angle, u
_RIGHT = math.radians(0.01)
MOST_ANGLES = 4  # in a figure


def draw_geometry(board: MotionBoard, subject: FigureSubject, symbols: Symbols, most: int, body: str = "") -> int:
    """Mark what can be seen in the figure, but not more than so many angles; returns how many there are.

    ``body`` is that whose centre stands at the place ``centre``.
    """
    sketch = board.sketch
    _draw_segments(board, subject.geometry.segments)
    for foot in subject.geometry.feet:
        _draw_foot(board, foot)
    formulas = Formulas(symbols, subject.mechanism.variant.family.length_unit)
    seen: list[tuple[complex, float, float, float]] = []
    for corner in (_placed(board, corner) for corner in subject.geometry.corners):
        own = corner.centre == body and "centre" in sketch.at
        key = "centre" if own and corner.at_centre else corner.vertex
        seen_points = {*board.shown, *(("P", "Q") if own else ())}
        if corner.centre and not own:
            # The ray to a centre that is not drawn is seen where a vector lies on its line.
            if corner.at_centre or key not in board.shown or _drawn_lines(board, key, corner) < 2:
                continue
        elif not _is_seen(corner, seen_points):
            continue
        sides = _on_lines(board, key, corner) if corner.either else corner.sides
        at, sweep = sketch.at[key], cmath.phase(sides[1] / sides[0])
        start = cmath.phase(sides[0])
        if sweep < 0:
            start, sweep = start + sweep, -sweep
        same = [other for other in seen if abs(other[0] - at) < 1e-6]
        known = any(_gap(s, start) < _SAME and abs(w - sweep) < _SAME for _, s, w, _ in same)
        if known or sweep < _LEAST or len(seen) >= most:
            continue
        least = 1.4 * _ARC if sweep < _NARROW else _ARC
        radius = max([least, *(other[-1] + _WIDER for other in same)])
        seen.append((at, start, sweep, radius))
        _draw_sides(board, key, sides, radius, _beside(board, subject, corner))
        if abs(sweep - math.pi / 2) < _RIGHT:
            first, second = (_SQUARE * side / abs(side) for side in sides)
            sketch.path((at + first, at + first + second, at + second), Layer.MARK, THIN)
            continue
        sketch.arc(Arc(at, radius, Layer.MARK, THIN, start, sweep))
        sketch.label(along_arc(_name(corner, formulas), at, radius, start, sweep, inner=True))
        for part in (0.0, 0.25, 0.5, 0.75, 1.0):
            sketch.busy.setdefault(key, []).append(start + part * sweep)
    return len(seen)


def _is_seen(corner: Corner, points: set[str]) -> bool:
    """Whether a figure has the vertex of an angle and a point of its sides; both points of a part, or with a centre."""
    ends = points & set(corner.ends)
    return corner.vertex in points and len(ends) >= min(len(corner.ends), 2 if corner.centre or corner.is_part else 1)


def _placed(board: MotionBoard, corner: Corner) -> Corner:
    """An angle whose vertex is not in the figure at the point where more of its sides are drawn, the nearest first."""
    if corner.vertex in board.shown or corner.is_part:
        return corner
    points = [name for name in corner.carried if name in board.shown]
    drawn = {name: _drawn_lines(board, name, corner) for name in points}
    place = max(points, key=lambda name: drawn[name], default="")
    return replace(corner, vertex=place, either=True) if place and drawn[place] else corner


def _drawn_lines(board: MotionBoard, key: str, corner: Corner) -> int:
    """On how many of the lines of its sides something is drawn at a point."""
    return sum(any(board.sketch.is_taken(key, way, math.radians(2)) for way in (side, -side)) for side in corner.sides)


def _on_lines(board: MotionBoard, key: str, corner: Corner) -> tuple[complex, complex]:
    """The sides of an angle between lines, or the vertical one: that of which more sides are drawn."""
    first, second = corner.sides
    pairs = ((first, second), (-first, -second))
    drawn = [sum(board.sketch.is_taken(key, side, math.radians(2)) for side in pair) for pair in pairs]
    return pairs[drawn[1] > drawn[0]]


def _draw_segments(board: MotionBoard, segments: Sequence[tuple[str, str]]) -> None:
    """Dashed lines between points of the figure that nothing joins."""
    sketch = board.sketch
    for first, second in segments:
        if first in board.shown and second in board.shown:
            way = sketch.at[second] - sketch.at[first]
            if abs(way) > 2 * _SQUARE and not sketch.is_taken(first, way, _SAME):
                sketch.path((sketch.at[first], sketch.at[second]), Layer.GROUND, THIN, dash="dashed")
                sketch.occupy(first, way)
                sketch.occupy(second, -way)


def _draw_foot(board: MotionBoard, foot: MarkedFoot) -> None:
    """The perpendicular to its foot with its letter and a right angle; its line where nothing is drawn of it."""
    sketch = board.sketch
    if not {foot.apex, *foot.line} <= {*board.shown} or foot.letter in sketch.at:
        return
    at = sketch.at[foot.letter] = sketch.scale * foot.place
    down = sketch.at[foot.apex] - at
    ends = sorted((sketch.at[name] for name in foot.line), key=lambda place: abs(place - at))
    along = ends[-1] - at
    shorter = min(abs(down), abs(along))
    if shorter < _LEAST_LEG:
        return
    sketch.path((sketch.at[foot.apex], at), Layer.GROUND, THIN, dash="dashed")
    sketch.occupy(foot.apex, -down)
    beyond = len(ends) == 1 or ((ends[0] - at) * along.conjugate()).real > 0
    if beyond and abs(ends[0] - at) > 1.0:
        sketch.path((ends[0], at), Layer.GROUND, THIN, dash="dashed")
    if len(foot.line) == 2:
        _draw_segments(board, [(foot.line[0], foot.line[1])])
    if shorter >= _SQUARE:
        first, second = (_FOOT_SQUARE * way / abs(way) for way in (down, along))
        sketch.path((at + first, at + first + second, at + second), Layer.MARK, THIN)
    sketch.circle(at, 0.35, Layer.HINGE, fill="ink")
    sketch.label(around(Symbol(foot.letter), at, 0.5))


def _name(corner: Corner, formulas: Formulas) -> Formula:
    """The letter of an angle; the value of one that is named by its points."""
    name = corner.value.name
    return formulas.measured(corner.value) if name is None or name.kind == "angle" else formulas.symbol(corner.value)


def _beside(board: MotionBoard, subject: FigureSubject, corner: Corner) -> list[complex]:
    """The ways (u) to points on the sides that one body has with the vertex: a disc is drawn without such lines."""
    bodies = [members for members in subject.form.bodies.values() if corner.vertex in members]
    at = board.sketch.at
    own = [name for name in corner.carried if name in board.shown and any(name in members for members in bodies)]
    return [at[name] - at[corner.vertex] for name in own]


def _draw_sides(
    board: MotionBoard, key: str, sides: tuple[complex, complex], radius: float, links: Sequence[complex]
) -> None:
    """Thin lines along the sides of an angle that nothing lies on as far as its arc; whole ``links`` on them."""
    sketch = board.sketch
    at, ways = sketch.at[key], [side / abs(side) for side in sides]
    taken = [way for way in ways if sketch.is_taken(key, way, math.radians(2))]
    seen = dict(zip(taken, _carried(sketch, [at + radius * part * way for way in taken for part in _ON_SIDE])))
    for way in ways:
        if not seen.get(way):
            ends = [link for link in links if abs(link) > radius and abs(cmath.phase(link / way)) < _SAME]
            sketch.path((at, at + (max(ends, key=abs) if ends else (radius + _BEYOND) * way)), Layer.GROUND, THIN)


def _carried(sketch: Sketch, places: Sequence[complex]) -> list[bool]:
    """Whether some line runs by all of the places on a side, which follow each other side by side."""
    if not places:
        return []
    drawn = sketch.obstacles.segments()
    squares = squares_to_segments(np.array(places)[:, None], drawn[:, 0], drawn[:, 1])
    near = np.minimum.reduce(squares, axis=1) < _ON_LINE**2
    result: list[bool] = np.logical_and.reduce(near.reshape(-1, len(_ON_SIDE)), axis=1).tolist()
    return result


def _gap(first: float, second: float) -> float:
    """The angle between two directions (rad)."""
    return abs((first - second + math.pi) % math.tau - math.pi)
