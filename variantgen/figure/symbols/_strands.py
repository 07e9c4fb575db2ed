"""Where the straight pieces of parallel ropes stand: side by side, upright at their blocks, on the rims of drums.

The places of a file say little of that: a block has a sheave for each time that a rope passes it, and its strands are
as far apart as these are wide. A strand that has its place from elsewhere, by a drum, a load of its own or another
block, keeps it, and the sheave of the block is as wide as that demands, or stands aside.
"""

from __future__ import annotations

from collections.abc import Sequence
from typing import NamedTuple

from msgspec import Struct

from variantgen.figure.board import Board
from variantgen.figure.sketch import HINGE
from variantgen.figure.symbols.guide import HALF_LOAD, ground_side
from variantgen.mechanism.constructions.tangent import thread_direction
from variantgen.mechanism.joints.guide import Guide
from variantgen.mechanism.joints.rope import Bend, Rope

RADIUS = 2.2  # of a sheave, u
_LEAST = 1.4  # radius of a sheave where there is little room
_WIDEST = 12.0  # from a block to a strand beside it, for which its sheave is made wide
_CLEAR = 0.8  # between a strand and the load beside it
_BEFORE = 5.8  # from a block in its guide to its sheaves, u


class StrandLine(Struct):
    """A straight piece on paper: its ends, which lie on its line, and the direction from the first to the second."""

    start: complex
    end: complex
    way: complex


class StrandEnd(NamedTuple):
    """Where a strand is fastened to a moving station: rope, station on its path, whether the strand leaves it."""

    rope: int
    station: int
    leaves: bool


def parallel_ropes(board: Board) -> list[Rope]:
    """The parallel ropes of the scene."""
    return [joint for joint in board.scene.joints if isinstance(joint, Rope) and joint.parallel]


def all_strands(board: Board) -> list[list[StrandLine]]:
    """The straight pieces of each parallel rope."""
    return _Strands(board).found()


class _Strands:
    """The ends of strands at all blocks, placed one block after the other."""

    def __init__(self, board: Board) -> None:
        self.board, self.ropes = board, parallel_ropes(board)
        self.placed: dict[StrandEnd, complex] = {}
        moving = [(b.point, b.along) for rope in self.ropes for b in rope.path if b.along is not None and not b.fixed]
        for point, along in dict(moving).items():
            self._settle(point, complex(board.frame.direction(along)))

    def found(self) -> list[list[StrandLine]]:
        """The pieces of each rope."""
        return [[self._piece(number, i) for i in range(len(rope.path) - 1)] for number, rope in enumerate(self.ropes)]

    def _at(self, bend: Bend) -> complex:
        return self.board.sketch.at[bend.point]

    def _circle(self, bend: Bend) -> tuple[complex, float, float]:
        """Centre, radius (u) and side on paper of a drum; any other station is a point here."""
        radius = float(bend.radius) * self.board.sketch.scale if bend.body is not None else 0.0
        return self._at(bend), radius, float(self.board.frame.sense * bend.side)

    def _piece(self, number: int, i: int) -> StrandLine:
        """A piece of a rope: along the way of its block, at its ends; between stations at rest straight on."""
        rope = self.ropes[number]
        first, second = rope.path[i : i + 2]
        angle = rope.way(first, second)
        if angle is None:
            return _between(self._circle(first), self._circle(second))
        way = complex(self.board.frame.direction(angle))
        way = way if ((self._at(second) - self._at(first)) * way.conjugate()).real > 0 else -way
        strand_ends = (StrandEnd(number, i, True), StrandEnd(number, i + 1, False))
        ends = [
            self.placed.get(strand_end, self._rim(bend, way))
            for strand_end, bend in zip(strand_ends, (first, second), strict=True)
        ]
        for k, bend in enumerate((first, second)):
            # At a station at rest, the strand is where its block has it.
            if strand_ends[k] not in self.placed and strand_ends[1 - k] in self.placed and bend.body is None:
                ends[k] = ends[1 - k] + ((ends[k] - ends[1 - k]) * way.conjugate()).real * way
        return StrandLine(ends[0], ends[1], (ends[1] - ends[0]) / abs(ends[1] - ends[0]))

    def _rim(self, bend: Bend, way: complex) -> complex:
        """Where a strand of this direction touches a drum; any other station itself."""
        centre, radius, side = self._circle(bend)
        return centre + 1j * side * radius * way

    def _settle(self, point: str, along: complex) -> None:
        """Give each strand at a block its place."""
        strand_ends = [strand_end for number in range(len(self.ropes)) for strand_end in self._sheaves(number, point)]
        middle = self.board.sketch.at[point]
        for number, rope in enumerate(self.ropes):
            ends = [StrandEnd(number, 0, True), StrandEnd(number, len(rope.path) - 1, False)]
            hooks = [
                strand_end
                for strand_end in ends
                if rope.path[strand_end.station].point == point and strand_end not in strand_ends
            ]
            self.placed |= dict.fromkeys(hooks, middle)  # the end of a rope on the hook of a block
        if not strand_ends:
            return
        if point not in self.board.loads:
            middle += _BEFORE * self._towards(strand_ends[0])
        across = 1j * along
        across = across if self._leans(strand_ends, middle, across) else -across
        wanted = [self._wanted(strand_end, along, middle, across) for strand_end in strand_ends]
        offsets = _spread(wanted, self._spacing(strand_ends, middle, across))
        if not any(place for place in wanted):
            offsets = self._above_ground(point, wanted, offsets, across)
        self.placed |= {
            strand_end: middle + offset * across for strand_end, offset in zip(strand_ends, offsets, strict=True)
        }

    def _sheaves(self, number: int, point: str) -> list[StrandEnd]:
        """The ends of strands of a rope at a block that it passes, in order; none for a rope that only ends there."""
        path = self.ropes[number].path
        visits = [i for i, bend in enumerate(path) if bend.point == point and bend.along is not None]
        strand_ends = [StrandEnd(number, i, leaves) for i in visits for leaves in (False, True)]
        strand_ends = [strand_end for strand_end in strand_ends if 0 <= _other(strand_end) < len(path)]
        return strand_ends if len(strand_ends) > 1 else []

    def _towards(self, strand_end: StrandEnd) -> complex:
        """The direction from a block to where a strand leads, along its way."""
        path = self.ropes[strand_end.rope].path
        own, other = path[strand_end.station], path[_other(strand_end)]
        way = complex(self.board.frame.direction(0.0 if own.along is None else own.along))
        return way if ((self._at(other) - self._at(own)) * way.conjugate()).real > 0 else -way

    def _leans(self, strand_ends: Sequence[StrandEnd], middle: complex, across: complex) -> bool:
        """Whether the first strand stands on the side of ``across``: where the rope comes from, or does not go to."""

        def aside(bend: Bend) -> float:
            return ((self._at(bend) - middle) * across.conjugate()).real

        first, last = strand_ends[0], strand_ends[-1]
        before = self.ropes[first.rope].path[: first.station][::-1]
        after = self.ropes[last.rope].path[last.station + 1 :]
        nearest = aside(before[0]) if before else 0.0
        nearest -= aside(after[0]) if after else 0.0
        leans = [nearest, *map(aside, before), *(-aside(bend) for bend in after)]
        return next((lean > 0 for lean in leans if abs(lean) > HINGE), True)

    def _wanted(self, strand_end: StrandEnd, along: complex, middle: complex, across: complex) -> float | None:
        """How far across a strand has to stand for what is at its other end; None where that is indifferent."""
        path = self.ropes[strand_end.rope].path
        other = path[_other(strand_end)]
        back = StrandEnd(strand_end.rope, _other(strand_end), not strand_end.leaves)
        if back in self.placed:
            place = self.placed[back]
        elif other.body is not None:
            way = self._towards(strand_end)
            place = self._rim(other, way if strand_end.leaves else -way)
        elif not other.fixed and other.along is not None and not self._sheaves(strand_end.rope, other.point):
            place = self._at(other)  # a load, or a hook
        else:
            return None
        return ((place - middle) * across.conjugate()).real

    def _spacing(self, strand_ends: Sequence[StrandEnd], middle: complex, across: complex) -> float:
        """Half the distance of the strands: less where else one of them would run along the side of a load."""
        found = RADIUS
        for strand_end, side in ((strand_ends[0], 1.0), (strand_ends[-1], -1.0)):
            path = self.ropes[strand_end.rope].path
            beyond = _other(strand_end) + (1 if strand_end.leaves else -1)
            if not path[_other(strand_end)].fixed or not 0 <= beyond < len(path) or not _is_end(path, beyond):
                continue
            aside = side * ((self._at(path[beyond]) - middle) * across.conjugate()).real
            if path[beyond].point in self.board.loads and aside > 0:
                found = min(found, (aside - HALF_LOAD - _CLEAR) / (len(strand_ends) - 1))
        return max(found, _LEAST)

    def _above_ground(
        self, point: str, wanted: Sequence[float | None], offsets: list[float], across: complex
    ) -> list[float]:
        """All strands on the free side of a block that slides on the ground."""
        guide = next((j for j in self.board.scene.joints if isinstance(j, Guide) and j.point == point), None)
        if guide is None or point in self.board.loads:
            return offsets
        down = (ground_side(self.board, guide) * across.conjugate()).real
        if all(place is None for place in wanted):
            lowest = max(down * offset for offset in offsets)
            return [offset - down * lowest for offset in offsets]
        return [-down * abs(offset) for offset in offsets]  # from the strand at the block itself upwards


def _other(strand_end: StrandEnd) -> int:
    """The station at the other end of the strand of which this is an end."""
    return strand_end.station + (1 if strand_end.leaves else -1)


def _is_end(path: Sequence[Bend], i: int) -> bool:
    return i in (0, len(path) - 1)


def _between(first: tuple[complex, float, float], second: tuple[complex, float, float]) -> StrandLine:
    """The piece between two circles or points."""
    way = complex(thread_direction(*first, *second)[0])
    ends = [centre + 1j * side * radius * way for centre, radius, side in (first, second)]
    return StrandLine(ends[0], ends[1], way)


def _spread(wanted: Sequence[float | None], half: float) -> list[float]:
    """How far across the strands of a block stand (u), the first one on the positive side where nothing is wanted."""
    count = len(wanted)
    usual = [2 * half * ((count - 1) / 2 - k) for k in range(count)]
    if count == 2:
        return _of_one_sheave(wanted, usual)
    for k, beside in ((0, 1), (count - 1, count - 2)):
        place = wanted[k]
        if place is None:
            continue
        outwards = 1.0 if k == 0 else -1.0
        if outwards * (place - usual[beside]) < 2 * _LEAST or abs(place) > _WIDEST:
            usual = [offset + place - usual[k] for offset in usual]
        usual[k] = place
    return usual


def _of_one_sheave(wanted: Sequence[float | None], usual: Sequence[float]) -> list[float]:
    """The two strands of a block with one sheave: this is as wide as they demand, or stands aside."""
    first, second = wanted
    if first is not None and second is not None and abs(first - second) > 2 * _LEAST:
        return [first, second]
    for k, place in enumerate(wanted):
        if place is not None:
            pair = [place, -place] if _LEAST < abs(place) < _WIDEST else [place, place + usual[1 - k] - usual[k]]
            return pair if k == 0 else pair[::-1]
    return [*usual]
