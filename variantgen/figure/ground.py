"""What rests behind a mechanism that is drawn in many positions: its walls, as long as in all, and what never moves."""

from __future__ import annotations

import cmath
import math
from collections.abc import Iterable, Sequence
from typing import NamedTuple, TypeAlias

import numpy as np

from variantgen.figure.drawing import Arc, Layer, Line, Path, Strokes
from variantgen.figure.sketch import RoundWall, Sketch, Wall

_SAME = 1e-4  # distance below which two lines are the same, u
_ASIDE = 4.0  # at most between the faces of one wall, which may lie on either side of a slider, u

Key: TypeAlias = tuple[object, ...]


class Ground(NamedTuple):
    """The lines behind a mechanism in one position, and those of them that are hatched."""

    lines: list[Line]
    walls: list[Wall]
    round_walls: list[RoundWall]


def resting_ground(first: Ground, others: Sequence[Ground]) -> list[Line]:
    """What rests behind a mechanism: its walls in the position ``first``, as long as in all; lines that never move."""
    walls = _lengthened(first.walls, [other.walls for other in others])
    rounds = _lengthened_arcs(first.round_walls, [other.round_walls for other in others])
    sketch = Sketch({}, 1.0)
    for wall in walls:
        sketch.path((wall.start, wall.end), Layer.GROUND)
        sketch.hatch(wall.start, wall.end, wall.normal)
    for round_wall in dict.fromkeys(rounds):
        sketch.hatch_arc(*round_wall)
    for line in first.lines:
        for old, new in zip(first.round_walls, rounds, strict=True):
            if isinstance(line, Arc) and _along(line, old):
                sketch.arc(line._replace(start=new.start, sweep=new.sweep))
            elif isinstance(line, Path) and (end := _closing(line, old)) is not None and new.sweep < math.tau:
                turn = cmath.rect(1.0, (new.sweep - old.sweep if end else 0.0) + new.start - old.start)
                sketch.add(line._replace(points=tuple([old.centre + turn * (p - old.centre) for p in line.points])))
    everywhere = [{rounded(line) for line in _bare(other)} for other in others]
    return [*sketch.lines, *(line for line in _bare(first) if all(rounded(line) in lines for lines in everywhere))]


def moving_ground(ground: Ground, resting: Iterable[Line]) -> list[Line]:
    """The lines of a position that are neither at rest nor walls: of slots in moving bodies."""
    known = {rounded(line) for line in resting}
    return [line for line in _bare(ground) if rounded(line) not in known]


def rounded(line: Line) -> Key:
    """What two equal lines have in common."""

    def near(place: complex) -> tuple[int, int]:
        return round(place.real / _SAME), round(place.imag / _SAME)

    match line:
        case Path(points, layer):
            return (layer, *(near(point) for point in points))
        case Strokes(segments, layer):
            return (layer, *(near(point) for segment in segments for point in segment))
        case Arc(centre, radius, layer):
            return (layer, near(centre), near(complex(radius, line.sweep)), near(line.at(0)))


def _bare(ground: Ground) -> list[Line]:
    """The lines that are no part of a wall."""
    faces = {rounded(Path((wall.start, wall.end), Layer.GROUND)) for wall in ground.walls}
    return [
        line
        for line in ground.lines
        if not isinstance(line, Strokes)
        and rounded(line) not in faces
        and not (isinstance(line, Arc) and any(_along(line, wall) for wall in ground.round_walls))
        and not (isinstance(line, Path) and any(_closing(line, wall) is not None for wall in ground.round_walls))
    ]


def _along(arc: Arc, wall: RoundWall) -> bool:
    """Whether an arc is the face of a wall, or the other edge of a slot."""
    return abs(arc.centre - wall.centre) < _SAME and (arc.start, arc.sweep) == (wall.start, wall.sweep)


def _closing(path: Path, wall: RoundWall) -> int | None:
    """Which end of a round slot (0, 1) a line closes; None for another line."""
    rays = [point - wall.centre for point in path.points]
    for end, angle in enumerate((wall.start, wall.start + wall.sweep)):
        if all(abs((ray * cmath.rect(1.0, -angle)).imag) < _SAME and abs(ray) > _SAME for ray in rays):
            return end
    return None


def _lengthened(walls: Sequence[Wall], others: Sequence[Sequence[Wall]]) -> list[Wall]:
    """Walls that reach as far as in all positions."""
    found = []
    for number, wall in enumerate(walls):
        way = (wall.end - wall.start) / abs(wall.end - wall.start)
        ends = [wall.start, wall.end]
        for other in others if not wall.bearing else ():
            if number < len(other) and _same_line(wall, other[number], way):
                ends += other[number][:2]
        along = [((end - wall.start) * way.conjugate()).real for end in ends]
        found.append(wall._replace(start=wall.start + min(along) * way, end=wall.start + max(along) * way))
    return found


def _same_line(wall: Wall, other: Wall, way: complex) -> bool:
    """Whether the wall of another position is this one, perhaps seen from its other side."""
    aside = [abs(((end - wall.start) * way.conjugate()).imag) for end in other[:2]]
    return max(aside) < _ASIDE and abs(aside[0] - aside[1]) < _SAME


def _lengthened_arcs(walls: Sequence[RoundWall], others: Sequence[Sequence[RoundWall]]) -> list[RoundWall]:
    """Round walls that reach as far as in all positions, at most once round."""
    found = []
    for number, wall in enumerate(walls):
        same = [
            other[number]
            for other in others
            if number < len(other) and abs(other[number].centre - wall.centre) < _SAME
            and abs(other[number].radius - wall.radius) < _ASIDE
        ]  # fmt: skip
        middles = np.unwrap([one.start + one.sweep / 2 for one in same or [wall]])
        low, high = float(middles.min()) - wall.sweep / 2, float(middles.max()) + wall.sweep / 2
        whole = high - low >= math.tau
        found.append(
            wall._replace(start=-math.pi, sweep=math.tau) if whole else wall._replace(start=low, sweep=high - low)
        )
    return found
