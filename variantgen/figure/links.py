"""The links of a mechanism: bars, slotted arms, bent links, plates, grooves, hatched walls."""

from __future__ import annotations

from collections.abc import Sequence
from itertools import combinations, pairwise

from variantgen.figure.board import Board
from variantgen.figure.drawing import MEDIUM, THIN, Layer
from variantgen.figure.sketch import Sketch

_HALF_SLOT = 1.6
_FILLET = 2.6  # side of the filled corner of a bent link, u
_BENT = 0.05  # sine of the least angle of a bend


def draw_links(board: Board) -> None:
    """Bars, bent links, thin lines of reference, plates and grooves, from the hints of the family."""
    sketch = board.sketch
    for body, start, end in board.form.bars:
        a, b = sketch.at[start], sketch.at[end]
        if body in board.form.figure.slotted:
            _draw_slotted(sketch, a, b)
        else:
            sketch.path((a, b), Layer.LINK)
        sketch.occupy(start, b - a)
        sketch.occupy(end, a - b)
        for point in board.form.bodies[body][2:]:
            for far in (a, b):
                sketch.occupy(point, far - sketch.at[point])
    for names in board.form.figure.thin:
        sketch.path([sketch.at[name] for name in names], Layer.GROUND, THIN)
        _occupy_both_ways(sketch, names)
    for names in board.form.figure.axial:
        sketch.path([sketch.at[name] for name in names], Layer.GROUND, THIN, dash="dashdot")
        _occupy_both_ways(sketch, names)
    for names in board.form.figure.lines:
        sketch.path([sketch.at[name] for name in names], Layer.LINK)
        _occupy_both_ways(sketch, names)
    for body in board.form.figure.plates:
        names = board.form.bodies[body]
        sketch.path([sketch.at[name] for name in names], Layer.DISC, closed=True, fill="shade")
        _occupy_both_ways(sketch, (*names, names[0]))
    _draw_welded_corners(board)
    for groove in board.form.figure.grooves:
        _draw_groove(sketch, sketch.at[groove[0]], sketch.at[groove[-1]])


def _draw_welded_corners(board: Board) -> None:
    """A filled corner where a bar and a further line of the same link meet: no hinge."""
    strokes = [(start, end) for _, start, end in board.form.bars]
    strokes += [pair for names in board.form.figure.lines for pair in pairwise(names)]
    for point in board.shown:
        if len(board.owners(point)) != 1:
            continue
        place = board.sketch.at[point]
        far = [b if a == point else a for a, b in strokes if point in (a, b)]
        ways = [(board.sketch.at[name] - place) / abs(board.sketch.at[name] - place) for name in far]
        for first, second in combinations(ways, 2):
            if abs((first * second.conjugate()).imag) > _BENT:
                corner = (place, place + _FILLET * first, place + _FILLET * second)
                board.sketch.path(corner, Layer.LINK, 0.0, closed=True, fill="ink")


def _draw_groove(sketch: Sketch, start: complex, end: complex) -> None:
    """A slot closed at both ends, over what lies below it."""
    side = _HALF_SLOT * 1j * (end - start) / abs(end - start)
    sketch.path((start - side, end - side, end + side, start + side), Layer.LINK, MEDIUM, closed=True, fill="paper")


def _occupy_both_ways(sketch: Sketch, names: Sequence[str]) -> None:
    for first, second in pairwise(names):
        step = sketch.at[second] - sketch.at[first]
        sketch.occupy(first, step)
        sketch.occupy(second, -step)


def _draw_slotted(sketch: Sketch, start: complex, end: complex) -> None:
    """A slotted arm: a bar from its pivot to the slot, then two edges closed at the ends."""
    way = (end - start) / abs(end - start)
    side, near = _HALF_SLOT * 1j * way, start + min(6.0, 0.2 * abs(end - start)) * way
    sketch.path((start, near), Layer.LINK)
    sketch.path((near - side, end - side, end + side, near + side), Layer.LINK, MEDIUM, closed=True, fill="paper")


def draw_walls(board: Board) -> None:
    """Hatched lines, on the side away from the mechanism."""
    sketch = board.sketch
    seen = [sketch.at[name] for name in board.shown]
    middle = sum(seen) / len(seen)
    for names in board.form.figure.walls:
        for first, second in pairwise(names):
            a, b = sketch.at[first], sketch.at[second]
            normal = 1j * (b - a) / abs(b - a)
            away = -normal if ((middle - a) * normal.conjugate()).real > 0 else normal
            sketch.path((a, b), Layer.GROUND)
            sketch.hatch(a, b, away)
        _occupy_both_ways(sketch, names)
