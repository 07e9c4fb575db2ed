"""A parallel rope, as hoists are drawn: strands side by side, sheaves between them, whatever the places say of radii.

A moving block has as many sheaves as the rope passes it; its strands stand side by side along its way. A sheave at rest
spans the two strands that it joins, or lies in the corner that they make.
"""

from __future__ import annotations

import cmath
from dataclasses import dataclass
from itertools import pairwise

from variantgen.figure.board import Board
from variantgen.figure.drawing import BOLD, MEDIUM, Arc, Layer
from variantgen.figure.sketch import HINGE
from variantgen.mechanism.joints.rope import Rope

RADIUS = 2.2  # of a sheave, u
BRACKET = 4.5
HALF_LOAD = 3.0
_SYMMETRIC = 0.05  # of the radius: loads on both sides of a sheave, as far from its middle
_BEFORE = 5.8  # from a block in its guide to its sheaves, u
_STEM = 4.0  # from the hinge of a sheave to the load under it, u


@dataclass
class Strand:
    """A straight piece on paper: its ends, which lie on its line, and the direction from the first to the second."""

    start: complex
    end: complex
    way: complex


def strands(board: Board, joint: Rope) -> list[Strand]:
    """The straight pieces of a parallel rope, each at its place beside the others."""
    aside = _slots(board, joint)
    found = []
    for i, (first, second) in enumerate(pairwise(joint.path)):
        ends = [board.sketch.at[first.point], board.sketch.at[second.point]]
        angle = joint.way(first, second)
        if angle is None:
            way = (ends[1] - ends[0]) / abs(ends[1] - ends[0])
            found.append(Strand(ends[0], ends[1], way))
            continue
        way = complex(board.frame.direction(angle))
        way = way if ((ends[1] - ends[0]) * way.conjugate()).real > 0 else -way
        own = [aside.get((i, "leaves")), aside.get((i + 1, "comes"))]
        for k in (0, 1):
            shift = own[k]
            if shift is not None:
                ends[k] += shift
        for k in (0, 1):  # at a station at rest, the strand is where its block has it
            if own[k] is None and own[1 - k] is not None:
                ends[k] = ends[1 - k] + ((ends[k] - ends[1 - k]) * way.conjugate()).real * way
        found.append(Strand(ends[0], ends[1], (ends[1] - ends[0]) / abs(ends[1] - ends[0])))
    return found


def _slots(board: Board, joint: Rope) -> dict[tuple[int, str], complex]:
    """How far from its moving station each strand stands: by station on the path, and whether it comes or leaves."""
    found: dict[tuple[int, str], complex] = {}
    last = len(joint.path) - 1
    for point in dict.fromkeys(bend.point for bend in joint.path if bend.along is not None and not bend.fixed):
        visits = [i for i, bend in enumerate(joint.path) if bend.point == point]
        places = [
            (i, way) for i in visits for way in ("comes", "leaves") if (i, way) not in ((0, "comes"), (last, "leaves"))
        ]
        along = joint.path[visits[0]].along
        across = 1j * complex(board.frame.direction(0.0 if along is None else along))
        # The first strand stands on the side of the station that it comes from.
        before, after = joint.path[max(visits[0] - 1, 0)].point, joint.path[min(visits[-1] + 1, last)].point
        lean = ((board.sketch.at[before] - board.sketch.at[after]) * across.conjugate()).real
        across = across if lean >= 0 else -across
        middle = (len(places) - 1) / 2
        before_block = 0j if point in board.loads or len(places) == 1 else _BEFORE * _towards(board, joint, visits[0])
        half = _half_gap(board, joint, visits, across) or RADIUS
        found |= {place: before_block + 2 * half * (middle - n) * across for n, place in enumerate(places)}
    return found


def _half_gap(board: Board, joint: Rope, visits: list[int], across: complex) -> float:
    """The radius with which a sheave holds two moving ends of the rope upright on both of its sides; 0 for no such."""
    ends = [joint.path[i] for i in (visits[0] - 1, visits[0] + 1) if 0 <= i < len(joint.path)]
    alone = [bend.along is not None and not bend.fixed and not _has_sheave(board, bend.point) for bend in ends]
    if len(visits) != 1 or len(ends) != 2 or not all(alone):
        return 0.0
    middle = board.sketch.at[joint.path[visits[0]].point]
    first, second = (((board.sketch.at[bend.point] - middle) * across.conjugate()).real for bend in ends)
    return first if first > HINGE and abs(first + second) < _SYMMETRIC * first else 0.0


def draw(board: Board, joint: Rope) -> None:
    """Add the strands, the sheaves and what carries them, loads and anchors."""
    pieces = strands(board, joint)
    last = len(joint.path) - 1
    for i, bend in enumerate(joint.path):
        if bend.body is not None:
            continue
        if 0 < i < last:
            _sheave(board, joint, i, pieces[i - 1], pieces[i])
        elif bend.fixed:
            place, along = (pieces[0].start, pieces[0].way) if i == 0 else (pieces[-1].end, -pieces[-1].way)
            base(board, place, -along)
        else:
            place, along = (pieces[0].start, pieces[0].way) if i == 0 else (pieces[-1].end, -pieces[-1].way)
            middle = board.sketch.at[bend.point]
            if abs(place - middle) > 1e-6:
                _join(board, middle, place, along)
            if _is_load(board, bend.point) and not _has_sheave(board, bend.point):
                _load(board, bend.point, middle, _towards(board, joint, i))
    for piece in pieces:
        board.sketch.path((piece.start, piece.end), Layer.THREAD, MEDIUM)


def _towards(board: Board, joint: Rope, i: int) -> complex:
    """The direction from the block at a station to the next one (or the one before), along its way."""
    bend, other = joint.path[i], joint.path[i + 1 if i + 1 < len(joint.path) else i - 1]
    way = complex(board.frame.direction(0.0 if bend.along is None else bend.along))
    step = board.sketch.at[other.point] - board.sketch.at[bend.point]
    return way if (step * way.conjugate()).real > 0 else -way


def _ropes(board: Board) -> list[Rope]:
    return [joint for joint in board.scene.joints if isinstance(joint, Rope)]


def _has_sheave(board: Board, point: str) -> bool:
    """Whether a rope passes a point."""
    return any(bend.point == point for rope in _ropes(board) for bend in rope.path[1:-1])


def _is_load(board: Board, point: str) -> bool:
    """Whether a point hangs free: nothing hangs on it in turn."""
    below = [
        board.sketch.at[other.point].imag < board.sketch.at[point].imag
        for rope in _ropes(board)
        for pair in pairwise(rope.path)
        for own, other in (pair, pair[::-1])
        if own.point == point
    ]
    return point in board.loads and not any(below)


def _sheave(board: Board, joint: Rope, i: int, arriving: Strand, leaving: Strand) -> None:
    """The sheave between two strands, whose ends are moved to where it takes them up."""
    bend, sketch = joint.path[i], board.sketch
    bends = (leaving.way * arriving.way.conjugate()).real
    if bends > 1 - 1e-6:
        return  # the rope goes straight on
    if bends < -0.99:
        centre = (arriving.end + leaving.start) / 2
        radius = abs(arriving.end - leaving.start) / 2
    else:
        turn = cmath.phase(leaving.way / arriving.way)
        normal = 1j * arriving.way if turn > 0 else -1j * arriving.way
        radius = RADIUS
        step = leaving.start - arriving.end
        cross = (arriving.way.conjugate() * leaving.way).imag
        corner = arriving.end + arriving.way * ((step.conjugate() * leaving.way).imag / cross)
        back = radius * abs(cmath.tan(turn / 2))
        arriving.end, leaving.start = corner - back * arriving.way, corner + back * leaving.way
        centre = arriving.end + radius * normal
    if radius < HINGE:
        return
    sketch.circle(centre, radius, Layer.DISC, MEDIUM)
    sweep = cmath.phase((leaving.start - centre) / (arriving.end - centre))
    if bends < -0.99:
        over = (1j * (arriving.end - centre) / radius * arriving.way.conjugate()).real
        sweep = cmath.pi if over > 0 else -cmath.pi
    sketch.arc(Arc(centre, radius, Layer.THREAD, BOLD, cmath.phase(arriving.end - centre), sweep))
    sketch.circle(centre, HINGE, Layer.HINGE, fill="paper")
    pull = leaving.way - arriving.way
    away = -pull / abs(pull)
    if bend.fixed:
        foot = centre + (radius + BRACKET) * away
        sketch.path((centre + HINGE * away, foot), Layer.LINK, 0.8 * BOLD)
        base(board, foot, away)
    else:
        _hang(board, bend.point, centre, -_towards(board, joint, i))
    board.sized(bend.point, radius)
    for taken in (-away, away):
        sketch.occupy(bend.point, taken)


def _hang(board: Board, point: str, centre: complex, away: complex) -> None:
    """Join a sheave to the middle of its block, and the load to the block."""
    sketch = board.sketch
    middle = sketch.at[point]
    if abs(centre - middle) > 1e-6:
        _join(board, middle, centre, -away)
    if _is_load(board, point):
        place = middle + (HINGE + _STEM + HALF_LOAD) * away
        sketch.path((middle + HINGE * away, place), Layer.LINK, 0.8 * BOLD)
        _load(board, point, place, -away, clear=False)


def _join(board: Board, middle: complex, place: complex, along: complex) -> None:
    """The frame of a block: forward from its middle, then aside to a sheave or to the end of a rope."""
    forward = middle + ((place - middle) * along.conjugate()).real * along
    board.sketch.path(
        [middle, forward, place] if abs(forward - place) > 1e-6 else [middle, place], Layer.LINK, 0.8 * BOLD
    )


def _load(board: Board, point: str, place: complex, along: complex, clear: bool = True) -> None:
    """A block square to the rope that leads away from it ``along``."""
    corners = [place + HALF_LOAD * complex(x, y) * along for x, y in ((-1, -1), (1, -1), (1, 1), (-1, 1))]
    board.sketch.path(corners, Layer.SLIDER, closed=True, fill="paper")
    if clear:
        board.sized(point, HALF_LOAD, box=corners)
        for taken in (along, -along):
            board.sketch.occupy(point, taken)


def base(board: Board, foot: complex, away: complex) -> None:
    """A hatched support that faces against ``away``."""
    start, end = foot - 3.0j * away, foot + 3.0j * away
    board.sketch.path((start, end), Layer.LINK)
    board.sketch.hatch(start, end, away)
