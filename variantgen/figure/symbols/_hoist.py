"""A parallel rope, as hoists are drawn: strands side by side, sheaves between them, whatever the places say of radii.

A moving block has as many sheaves as the rope passes it; its strands stand side by side along its way. A sheave at rest
spans the two strands that it joins, or lies in the corner that they make.
"""

from __future__ import annotations

import cmath
from collections.abc import Iterator, Mapping, Sequence
from itertools import pairwise
from typing import NamedTuple

from variantgen.figure.board import Board
from variantgen.figure.drawing import BOLD, MEDIUM, Arc, Layer
from variantgen.figure.sketch import HINGE
from variantgen.figure.symbols._strands import RADIUS, StrandLine, all_strands, parallel_ropes
from variantgen.figure.symbols.guide import HALF_LOAD
from variantgen.mechanism.joints.rope import Rope

BRACKET = 4.5
_HALF_BASE, _HATCH = 3.8, 2.2  # of a support: half its width, and its height with some room
_BESIDE, _NARROW = 1.0, 1.5  # between a support and a strand beside it, u; half its least width
_STEM = 4.0  # from the hinge of a sheave to the load under it, u
_BELOW = 1.5  # from a wide sheave to the load under it, u


class Sheave(NamedTuple):
    """A sheave on paper: the rope on it begins at the angle ``start``; ``away`` is whence it is held."""

    centre: complex
    radius: float
    start: float
    sweep: float
    away: complex


def draw(board: Board, joint: Rope) -> None:
    """Add the strands, the sheaves and what carries them, loads and anchors."""
    every = [(rope, strands, _sheaves(rope, strands)) for rope, strands in ropes_with_strands(board)]
    pieces, sheaves = next((strands, own) for rope, strands, own in every if rope is joint)
    discs = [sheave for _, _, own in every for sheave in own.values()]
    lines = [piece for _, strands, _ in every for piece in strands]
    last = len(joint.path) - 1
    for i, bend in enumerate(joint.path):
        if i in sheaves:
            _draw_sheave(board, joint, i, sheaves[i])
        if 0 < i < last or bend.body is not None:
            continue
        piece = pieces[0 if i == 0 else -1]
        place, along = (piece.start, piece.way) if i == 0 else (piece.end, -piece.way)
        if bend.fixed:
            foot = _clear_of(discs, place, along)
            piece.start, piece.end = (foot, piece.end) if i == 0 else (piece.start, foot)
            base(board, foot, -along, _half_base(piece, foot, lines))
            continue
        middle = board.sketch.at[bend.point]
        if abs(place - middle) > 1e-6:
            _join(board, middle, place, along)
        if _is_load(board, bend.point) and not _has_sheave(board, bend.point):
            _load(board, bend.point, middle, _towards(board, joint, i))
    for piece in pieces:
        board.sketch.path((piece.start, piece.end), Layer.THREAD, MEDIUM)
    if joint is every[-1][0]:
        for rope, strands, own in every:
            _name_at_rest(board, rope, strands, own)


def _name_at_rest(board: Board, joint: Rope, pieces: Sequence[StrandLine], sheaves: Mapping[int, Sheave]) -> None:
    """The names of stations at rest stand where these are drawn."""
    ends = {0: pieces[0].start, len(joint.path) - 1: pieces[-1].end}
    for i, bend in enumerate(joint.path):
        if bend.fixed and bend.point in board.shown:
            board.sketch.at[bend.point] = (
                sheaves[i].centre if i in sheaves else ends.get(i, board.sketch.at[bend.point])
            )
            board.sized(bend.point, sheaves[i].radius if i in sheaves else _HATCH)


def ropes_with_strands(board: Board) -> Iterator[tuple[Rope, list[StrandLine]]]:
    """Each parallel rope with its straight pieces."""
    return zip(parallel_ropes(board), all_strands(board), strict=True)


def _clear_of(discs: Sequence[Sheave], place: complex, along: complex) -> complex:
    """An anchor further along its rope where its base would lie over a sheave."""
    for disc in discs:
        step = (disc.centre - place) * along.conjugate()
        before, beside = step.real, max(0.0, abs(step.imag) - _HALF_BASE)
        if (
            abs(before) < disc.radius + _HATCH
            and beside < disc.radius
            and abs(complex(before, beside)) < disc.radius + _HATCH
        ):
            return place + (before + disc.radius + _HATCH) * along
    return place


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
    return _count(board, point) > 0


def _count(board: Board, point: str) -> int:
    """How often ropes pass a point."""
    return sum(bend.point == point for rope in _ropes(board) for bend in rope.path[1:-1])


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


def _sheaves(joint: Rope, pieces: Sequence[StrandLine]) -> dict[int, Sheave]:
    """The sheaves of a rope by the number of their station; the strands then end where these take them up."""
    found = {}
    for i, bend in enumerate(joint.path[1:-1], 1):
        sheave = _between(pieces[i - 1], pieces[i]) if bend.body is None else None
        if sheave is not None:
            found[i] = sheave
    return found


def _between(arriving: StrandLine, leaving: StrandLine) -> Sheave | None:
    """The sheave between two strands, whose ends are moved to where it takes them up; None where there is no bend."""
    bends = (leaving.way * arriving.way.conjugate()).real
    if bends > 1 - 1e-6:
        return None  # the rope goes straight on
    if bends < -0.99:
        centre = (arriving.end + leaving.start) / 2
        radius = abs(arriving.end - leaving.start) / 2
        over = (1j * (arriving.end - centre) * arriving.way.conjugate()).real
        sweep = cmath.pi if over > 0 else -cmath.pi
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
        sweep = cmath.phase((leaving.start - centre) / (arriving.end - centre))
    if radius < HINGE:
        return None
    pull = leaving.way - arriving.way
    return Sheave(centre, radius, cmath.phase(arriving.end - centre), sweep, -pull / abs(pull))


def _draw_sheave(board: Board, joint: Rope, i: int, sheave: Sheave) -> None:
    """A sheave with the rope on it, and what carries it."""
    bend, sketch = joint.path[i], board.sketch
    centre, radius, away = sheave.centre, sheave.radius, sheave.away
    sketch.circle(centre, radius, Layer.DISC, MEDIUM)
    sketch.arc(Arc(centre, radius, Layer.THREAD, BOLD, sheave.start, sheave.sweep))
    sketch.circle(centre, HINGE, Layer.HINGE, fill="paper")
    if bend.fixed:
        foot = centre + (radius + BRACKET) * away
        sketch.path((centre + HINGE * away, foot), Layer.LINK, 0.8 * BOLD)
        base(board, foot, away)
    else:
        _hang(board, joint, i, sheave)
    board.sized(bend.point, radius)
    for taken in (-away, away):
        sketch.occupy(bend.point, taken)


def _hang(board: Board, joint: Rope, i: int, sheave: Sheave) -> None:
    """Join a sheave to the middle of its block, and the load to the block, or to a sheave that is the only one."""
    sketch, point = board.sketch, joint.path[i].point
    middle, away = sketch.at[point], -_towards(board, joint, i)
    alone = _is_load(board, point) and abs(sheave.centre - middle) < RADIUS and _count(board, point) == 1
    if alone:
        middle = sheave.centre
    elif abs(sheave.centre - middle) > 1e-6:
        _join(board, middle, sheave.centre, -away)
    if _is_load(board, point):
        far = max(HINGE + _STEM, sheave.radius + _BELOW if abs(sheave.centre - middle) < sheave.radius else 0.0)
        place = middle + (far + HALF_LOAD) * away
        sketch.path((middle + HINGE * away, place), Layer.LINK, 0.8 * BOLD)
        _load(board, point, place, -away, clear=False)


def _join(board: Board, middle: complex, place: complex, along: complex) -> None:
    """The frame of a block: forward from its middle, then aside to a sheave or to the end of a rope."""
    forward = middle + ((place - middle) * along.conjugate()).real * along
    corner = [forward] if min(abs(forward - middle), abs(forward - place)) > 1e-6 else []
    board.sketch.path([middle, *corner, place], Layer.LINK, 0.8 * BOLD)


def _load(board: Board, point: str, place: complex, along: complex, clear: bool = True) -> None:
    """A block square to the rope that leads away from it ``along``."""
    corners = [place + HALF_LOAD * complex(x, y) * along for x, y in ((-1, -1), (1, -1), (1, 1), (-1, 1))]
    board.sketch.path(corners, Layer.SLIDER, closed=True, fill="paper")
    if clear:
        board.sized(point, HALF_LOAD, box=corners)
        for taken in (along, -along):
            board.sketch.occupy(point, taken)


def base(board: Board, foot: complex, away: complex, half: float = 3.0) -> None:
    """A hatched support that faces against ``away``, of some ``half`` width (u)."""
    start, end = foot - half * 1j * away, foot + half * 1j * away
    board.sketch.path((start, end), Layer.LINK)
    board.sketch.hatch(start, end, away)


def _half_base(own: StrandLine, foot: complex, others: Sequence[StrandLine]) -> float:
    """Half the width of a support: less where another strand runs close by."""
    gaps = [3.0 + _BESIDE]
    for strand in others:
        along = [((end - foot) * own.way.conjugate()) for end in (strand.start, strand.end)]
        if strand is not own and min(along[0].real, along[1].real) < 0 < max(along[0].real, along[1].real):
            gaps.append(min(abs(end.imag) for end in along))
    return max(min(gaps) - _BESIDE, _NARROW)
