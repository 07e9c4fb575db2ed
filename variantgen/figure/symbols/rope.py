"""Rope: straight pieces, wraps, pulleys with hinge or bracket, anchors, loads."""

from __future__ import annotations

import cmath
import math
from collections.abc import Iterator
from itertools import pairwise

from variantgen.figure.board import Board
from variantgen.figure.drawing import BOLD, MEDIUM, Arc, Layer
from variantgen.figure.sketch import HINGE
from variantgen.figure.symbols import _hoist
from variantgen.figure.symbols.guide import HALF_LOAD, UPRIGHT
from variantgen.mechanism.constructions.tangent import thread_direction
from variantgen.mechanism.joints.guide import Guide
from variantgen.mechanism.joints.rope import Bend, Rope


def draw(board: Board, joint: Rope) -> None:
    """Add the rope and what carries it; drums and wheels that are bodies are drawn as discs."""
    if joint.parallel:
        _hoist.draw(board, joint)
        return
    ways = []
    for first, second in pairwise(joint.path):
        start, end, way = _straight(board, first, second)
        board.sketch.path((start, end), Layer.THREAD, MEDIUM)
        ways.append(way)
    last = len(joint.path) - 1
    for i, bend in enumerate(joint.path):
        if bend.body is not None:
            continue
        arriving = ways[i - 1] if i > 0 else None
        leaving = ways[i] if i < last else None
        if arriving is not None and leaving is not None:
            _pulley(board, bend, arriving, leaving)
        else:
            _end(board, joint, bend, ways[0] if i == 0 else -ways[-1])


def _circle(board: Board, bend: Bend) -> tuple[complex, float, float]:
    """Centre and radius in u, and the side on paper."""
    return board.sketch.at[bend.point], float(bend.radius) * board.sketch.scale, float(board.frame.sense * bend.side)


def piece_on_paper(board: Board, joint: Rope, number: int) -> tuple[complex, complex]:
    """The ends (u) of a straight piece, from bend ``number`` to the next one."""
    if joint.parallel:
        strand = next(strands for rope, strands in _hoist.ropes_with_strands(board) if rope is joint)[number]
        return strand.start, strand.end
    return _straight(board, *joint.path[number : number + 2])[:2]


def _straight(board: Board, first: Bend, second: Bend) -> tuple[complex, complex, complex]:
    """The ends (u) of a straight piece, and its direction."""
    start, radius, side = _circle(board, first)
    end, end_radius, end_side = _circle(board, second)
    way = complex(thread_direction(start, radius, side, end, end_radius, end_side)[0])
    return start + 1j * side * radius * way, end + 1j * end_side * end_radius * way, way


def _pulley(board: Board, bend: Bend, arriving: complex, leaving: complex) -> None:
    sketch = board.sketch
    centre, radius, side = _circle(board, bend)
    if radius > 0 and not board.is_disc(bend.point):
        sketch.circle(centre, radius, Layer.DISC, MEDIUM)
    # The rope bends towards the centre: clockwise about a pulley on its right (side +1), which decides a half turn.
    turn = (-side * cmath.phase(leaving / arriving)) % math.tau
    sweep = -side * (turn if turn < math.tau - 1e-6 else 0.0)
    sketch.arc(Arc(centre, radius, Layer.THREAD, BOLD, cmath.phase(1j * side * arriving), sweep))
    sketch.circle(centre, HINGE, Layer.HINGE, fill="paper")
    board.sized(bend.point, HINGE)
    for taken in (1j * side * arriving, 1j * side * leaving):
        sketch.occupy(bend.point, taken)
    if bend.fixed and bend is next(own for own, _ in _passing(board, bend.point)):
        # One bracket holds the pulley from the side towards which the ropes do not pull.
        pull = sum(pull for _, pull in _passing(board, bend.point))
        away = -pull / abs(pull) if abs(pull) > 0.2 else -1j * side * arriving
        _support(board, centre, away, radius + _hoist.BRACKET)


def _passing(board: Board, point: str) -> Iterator[tuple[Bend, complex]]:
    """The bends of ropes over a pulley, each with what it pulls by."""
    for rope in board.scene.joints:
        if isinstance(rope, Rope) and not rope.parallel:
            for before, bend, after in zip(rope.path, rope.path[1:], rope.path[2:], strict=False):
                if bend.point == point:
                    yield bend, _straight(board, bend, after)[2] - _straight(board, before, bend)[2]


def _support(board: Board, centre: complex, away: complex, length: float) -> None:
    sketch = board.sketch
    foot = centre + length * away
    sketch.path((centre + HINGE * away, foot), Layer.LINK, 0.8 * BOLD)
    _hoist.base(board, foot, away)


def _end(board: Board, joint: Rope, bend: Bend, along: complex) -> None:
    """An anchor, a load, or nothing where the rope is tied to a point of a body; ``along`` leads into the rope."""
    sketch = board.sketch
    place = sketch.at[bend.point]
    if bend.fixed:
        _hoist.base(board, place, -along)
    elif bend.point in board.loads and not _slides(board, bend.point):
        # The block of a load that hangs stands square to the rope.
        corners = [place + HALF_LOAD * complex(x, y) * along for x, y in ((-1, -1), (1, -1), (1, 1), (-1, 1))]
        sketch.path(corners, Layer.SLIDER, closed=True, fill="paper")
        board.sized(bend.point, HALF_LOAD, box=corners)
        for taken in (along, -along):
            sketch.occupy(bend.point, taken)


def _slides(board: Board, point: str) -> bool:
    """Whether a load is pulled along a slope or the ground, where its guide is drawn."""
    guides = [joint for joint in board.scene.joints if isinstance(joint, Guide) and joint.point == point]
    return any(abs(complex(board.frame.direction(guide.angle)).real) > UPRIGHT for guide in guides)
