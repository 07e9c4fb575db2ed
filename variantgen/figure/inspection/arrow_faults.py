"""What is wrong with the arrows of a finished figure: given motion, rotation, dimensions and radii."""

from __future__ import annotations

import math
from collections.abc import Sequence
from itertools import combinations, pairwise

import numpy as np
from msgspec import Struct

from variantgen.figure.drawing import BOLD, MEDIUM, THIN, Arc, Drawing, Layer, Line, Path, RotationArc, Strokes
from variantgen.figure.ink import segments_of
from variantgen.wording.formula import to_plain

_TOUCH = 0.35  # free space between an arrow and the line beside it, u
_ROOT = 4.0  # part of an arrow at its point that may lie on what meets there, u
_BEYOND = 1.0  # a line that continues an arrow by more than this seems to be its shaft, u
_SLOT, _BLOCK = 2.0, 3.0  # half a slot, half a block at which an arrow along the slot begins, u
_PARALLEL = math.cos(math.radians(12))
_LANE = 1.6  # distance between two opposite arrows that are told apart, u
_BEHIND = 16.0  # depth behind a wall in which an arrow seems to be in it, u
_LONG_WALL = 12.0  # shorter hatched lines are bases of hinges, u
_GRAZE = 1.0  # distance from a rim at which a radius seems to touch it, u
_GRAZED = 2.5  # length over which it does, u
_READABLE, _READABLE_ON_PLATE = 5.5, 9.0  # length of an arc of rotation, u
_SAMPLES = np.linspace(0.0, 1.0, 41)

Shaft = tuple[complex, complex]


class ArrowInspection(Struct, frozen=True):
    """The faults of the arrows of a figure, each with the names or places of what has it.

    ``crossed``: arrows of motion over links, rims, threads, supports or other arrows; ``doubled``: two opposite arrows
    that read as one with two heads; ``behind``: arrows behind a wall or over hatching; ``continued``: arrows whose line
    goes on past the head; ``radii``: dimension lines and radii over links, rims and arrows; ``grazing``: those that
    run along a rim; ``small``: arcs of rotation that are too short to be read; ``foreign``: those that seem to show the
    rotation of another body.
    """

    crossed: tuple[str, ...]
    doubled: tuple[str, ...]
    behind: tuple[str, ...]
    continued: tuple[str, ...]
    radii: tuple[str, ...]
    grazing: tuple[str, ...]
    small: tuple[str, ...]
    foreign: tuple[str, ...]

    @property
    def by_kind(self) -> dict[str, list[str]]:
        """The faults in words, by the names of the fields."""
        words = {
            "crossed": "the arrow {} crosses a line",
            "doubled": "the arrows {} read as one with two heads",
            "behind": "the arrow {} lies behind a wall",
            "continued": "a line goes on past the head of the arrow {}",
            "radii": "the dimension {} crosses a line",
            "grazing": "the dimension {} runs along a rim",
            "small": "the arc {} is too small",
            "foreign": "the arc {} seems to belong to another body",
        }
        return {kind: [text.format(name) for name in getattr(self, kind)] for kind, text in words.items()}


def inspect_arrows(drawing: Drawing) -> ArrowInspection:
    """The faults of all arrows of a statement figure."""
    named: dict[Shaft, str] = {}
    for label in drawing.labels:
        if label.arrow is not None:
            named.setdefault(label.arrow, to_plain(label.formula))
    dimensions = _dimensions(drawing)
    return ArrowInspection(
        tuple(name for arrow, name in named.items() if _is_crossed(arrow, drawing.lines)),
        tuple(f"{named[a]}, {named[b]}" for a, b in combinations(named, 2) if _is_double(a, b)),
        tuple(name for arrow, name in named.items() if any(_is_behind(arrow, wall) for wall in _walls(drawing))),
        tuple(name for arrow, name in named.items() if _is_continued(arrow, drawing.lines)),
        tuple(_place(d) for d in dimensions if _crosses_parts(d, drawing.lines)),
        tuple(_place(d) for d in dimensions if _grazes(d, drawing.lines)),
        tuple(to_plain(turn.formula) for turn in drawing.rotations if _is_small(turn, drawing.lines)),
        tuple(to_plain(turn.formula) for turn in drawing.rotations if _is_foreign(turn, drawing.lines)),
    )


def _place(shaft: Shaft) -> str:
    return f"at ({shaft[1].real:.0f}, {shaft[1].imag:.0f})"


def _dimensions(drawing: Drawing) -> list[Shaft]:
    """Start and tip of dimension lines and radii: thin strokes with a filled head."""
    lines = [line for line in drawing.lines if isinstance(line, Path) and line.layer == Layer.MARK]
    return [
        (shaft.points[0], head.points[0])
        for shaft, head in pairwise(lines)
        if len(shaft.points) == 2 and len(head.points) == 3 and head.closed and head.fill == "ink"
    ]


def _cut(shaft: Shaft, root: float) -> Shaft:
    """An arrow without its root, which may lie on what meets at its point."""
    start, tip = shaft
    return start + min(root, 0.4 * abs(tip - start)) * (tip - start) / abs(tip - start), tip


def _meets(shaft: Shaft, segments: np.ndarray, gap: float) -> bool:
    """Whether any segment comes nearer to an arrow than a gap."""
    if not len(segments):
        return False
    start, way = shaft[0], (shaft[1] - shaft[0]) / abs(shaft[1] - shaft[0])
    local = (segments - start) * np.conj(way)
    low, high = local[:, 0], local[:, 1]
    # Clipped to the length of the arrow: the least distance aside, zero where the sides differ.
    step = high - low
    along = np.where(np.abs(step.real) > 1e-12, step.real, 1e-12)
    near = np.clip((0.0 - low.real) / along, 0, 1), np.clip((abs(shaft[1] - start) - low.real) / along, 0, 1)
    first, last = (low + part * step for part in near)
    inside = (np.maximum(low.real, high.real) >= 0) & (np.minimum(low.real, high.real) <= abs(shaft[1] - start))
    over = (first.imag <= 0) != (last.imag <= 0)
    return bool(np.any(inside & (over | (np.minimum(np.abs(first.imag), np.abs(last.imag)) < gap))))


def _segments(lines: Sequence[Line]) -> np.ndarray:
    return segments_of(lines)[0]


def _is_own(line: Line, shaft: Shaft) -> bool:
    """Whether a line is the shaft or the head of an arrow."""
    return isinstance(line, Path) and line.points[0] in shaft and line.layer in (Layer.VECTOR, Layer.MARK)


def _is_crossed(shaft: Shaft, lines: Sequence[Line]) -> bool:
    """Whether an arrow of motion lies over a line of the mechanism, a dimension or another arrow.

    Thin lines of reference may be crossed, and a circle or slot along which the arrow points.
    """
    others = [
        line
        for line in lines
        if not _is_own(line, shaft)
        and line.layer != Layer.LABEL
        and not _is_tangent(line, shaft)
        and not (line.layer in (Layer.GROUND, Layer.MARK) and line.weight <= THIN and not _is_head(line, lines))
    ]
    return _meets(_cut(shaft, _ROOT), _segments(others), _TOUCH)


def _is_tangent(line: Line, shaft: Shaft) -> bool:
    """Whether an arrow begins on an arc (or between the edges of a slot) and points along it."""
    if not isinstance(line, Arc) or line.layer >= Layer.HINGE:
        return False
    way = (shaft[1] - shaft[0]) / abs(shaft[1] - shaft[0])
    arm = (shaft[0] - line.centre) * way.conjugate()
    return abs(abs(arm.imag) - line.radius) < _SLOT and abs(arm.real) < _BLOCK


def _is_head(line: Line, lines: Sequence[Line]) -> bool:
    """Whether a line belongs to a dimension: hatching and thin lines without heads do not."""
    return isinstance(line, Path) and line.layer == Layer.MARK and len(line.points) == 2


def _is_double(first: Shaft, second: Shaft) -> bool:
    """Whether two arrows point away from each other (or at each other) on one line, close together."""
    ways = [(tip - start) / abs(tip - start) for start, tip in (first, second)]
    if (ways[0] * ways[1].conjugate()).real > -_PARALLEL:
        return False
    aside = abs(((second[0] - first[0]) * ways[0].conjugate()).imag)
    gap = min(abs(first[0] - second[0]), abs(first[1] - second[1]))
    return aside < _LANE and gap < 4 * _LANE


def _walls(drawing: Drawing) -> list[tuple[complex, complex, complex]]:
    """Ends of the hatched straight lines and the direction (unit) to the side of the hatching."""
    found = []
    for line in drawing.lines:
        if not isinstance(line, Strokes) or len(line.segments) < 3:
            continue
        feet = [foot for foot, _ in line.segments]
        way = feet[-1] - feet[0]
        bent = max(abs(((foot - feet[0]) * way.conjugate()).imag) for foot in feet) / abs(way) if way else 1.0
        if abs(way) < _LONG_WALL or bent > 0.05:
            continue
        normal = 1j * way / abs(way)
        stroke = line.segments[0][1] - line.segments[0][0]
        found.append((feet[0], feet[-1], normal if (stroke * normal.conjugate()).real > 0 else -normal))
    return found


def _is_behind(shaft: Shaft, wall: tuple[complex, complex, complex]) -> bool:
    """Whether an arrow is on the hatched side of a wall, near it."""
    start, end, away = wall
    way = (end - start) / abs(end - start)
    for part in (0.3, 0.6, 1.0):
        step = shaft[0] + part * (shaft[1] - shaft[0]) - start
        along, depth = (step * way.conjugate()).real, (step * away.conjugate()).real
        if 0 < along < abs(end - start) and 0.2 < depth < _BEHIND:
            return True
    return False


def _is_continued(shaft: Shaft, lines: Sequence[Line]) -> bool:
    """Whether a straight line goes on past the head in the direction of the arrow."""
    start, tip = shaft
    way = (tip - start) / abs(tip - start)
    straight = [line for line in lines if isinstance(line, Path) and not _is_own(line, shaft)]
    for first, second in _segments(straight):
        if abs(second - first) < 1e-9 or abs(((second - first) / abs(second - first) * way.conjugate()).real) < 0.99:
            continue
        ends = sorted(((end - tip) * way.conjugate() for end in (first, second)), key=lambda z: z.real)
        if ends[0].real < 0.8 and ends[1].real > _BEYOND and max(abs(z.imag) for z in ends) < 0.6:
            return True
    return False


def _crosses_parts(shaft: Shaft, lines: Sequence[Line]) -> bool:
    """Whether a dimension lies over a link, a rim, a thread, a support or an arrow; where it begins and ends it may."""
    start, tip = shaft
    way = (tip - start) / abs(tip - start)
    others = [
        line
        for line in lines
        if not _is_own(line, shaft)
        and line.weight >= MEDIUM
        and line.layer < Layer.LABEL
        and not (isinstance(line, Arc) and line.full and abs(line.centre - start) < 1e-6)
    ]
    ends = min(_ROOT, 0.3 * abs(tip - start)), min(0.9, 0.2 * abs(tip - start))
    return _meets((start + ends[0] * way, tip - ends[1] * way), _segments(others), 0.2)


def _grazes(shaft: Shaft, lines: Sequence[Line]) -> bool:
    """Whether a dimension runs along the rim of a circle for a while."""
    places = shaft[0] + _SAMPLES * (shaft[1] - shaft[0])
    step = abs(shaft[1] - shaft[0]) / (len(_SAMPLES) - 1)
    for line in lines:
        if isinstance(line, Arc) and line.layer < Layer.HINGE and line.radius > 3.0:
            arms = places - line.centre
            turn = np.remainder(np.angle(arms) - line.start, math.tau)
            near = (np.abs(np.abs(arms) - line.radius) < _GRAZE) & (line.full | (turn <= line.sweep))
            across = abs(np.abs(arms[0]) - line.radius) < _GRAZE and abs(np.abs(arms[-1]) - line.radius) < _GRAZE
            if step * np.count_nonzero(near) > _GRAZED and not across:
                return True
    return False


def _is_small(turn: RotationArc, lines: Sequence[Line]) -> bool:
    """Whether an arc of rotation is too short, for its own sake or for the plate in which it stands."""
    plates = [line.points for line in lines if isinstance(line, Path) and line.fill == "shade" and len(line.points) > 2]
    middle = turn.arc.at(0.5)
    least = _READABLE
    for corners in plates:
        away = [_from_line(middle, a, b) for a, b in pairwise((*corners, corners[0]))]
        if all(x > 0 for x in away) or all(x < 0 for x in away):
            centre = sum(corners) / len(corners)
            room = min(abs(_from_line(centre, a, b)) for a, b in pairwise((*corners, corners[0])))
            least = min(_READABLE_ON_PLATE, max(_READABLE, 0.9 * room))
    return abs(turn.arc.sweep) * turn.arc.radius < least


def _from_line(place: complex, start: complex, end: complex) -> float:
    """Distance of a place from a line, positive on its left (u)."""
    return float(((place - start) * ((end - start) / abs(end - start)).conjugate()).imag)


def _is_foreign(turn: RotationArc, lines: Sequence[Line]) -> bool:
    """Whether an arc runs along the rim of a wheel about the same centre that is not of its body.

    The rim of a wheel at rest is none: it has no rotation that could be meant.
    """
    rims = {
        line.radius
        for line in lines
        if isinstance(line, Arc)
        and line.full
        and line.layer == Layer.DISC
        and line.weight >= BOLD
        and abs(line.centre - turn.arc.centre) < 1e-6
    }
    if not rims:
        return False
    if turn.rims:
        nearest = min(rims, key=lambda rim: abs(rim - turn.arc.radius))
        return min(abs(nearest - rim) for rim in turn.rims) > 2.5
    return turn.arc.radius > min(rims)
