"""The room of what shows that something slides: bearings of yokes, blocks in one slot, the two ends of a rack."""

from __future__ import annotations

from collections.abc import Callable, Iterator, Mapping
from itertools import combinations
from typing import Any, TypeAlias

from msgspec import Struct

from variantgen.families.family import TOOTHED_RACK
from variantgen.synthesis.crowding.seen import Seen
from variantgen.synthesis.crowding.segments import Bar, off

Places: TypeAlias = Mapping[str, Any]  # numbers or arrays, cm
# What they keep from each other in the layout and on all draws, in parts of the whole.
_BEARING = 0.1, 0.07
_BLOCKS = 0.11, 0.075
_RACK_END = 0.06, 0.04
# How far a rod at the slider of a rack is from lying along it: sine of the angle, 1 for an obtuse one.
_RACK_START = 0.77, 0.64


class Clearance(Struct, frozen=True):
    """What something keeps from something else, measured from places and the size of the whole.

    ``first``: how much it is to be in the layout, ``still`` on all draws; ``fault``: what is wrong where it is less.
    """

    measured: Callable[[Places, Any], Any]
    first: float
    still: float
    fault: str


def clearances(seen: Seen) -> Iterator[Clearance]:
    """All that is to be looked at."""
    yield from _bearings(seen)
    yield from _blocks(seen)
    yield from _racks(seen)


def _of_point(one: str, other: str) -> Callable[[Places, Any], Any]:
    return lambda z, size: abs(z[one] - z[other]) / size


def _of_bar(point: str, bar: Bar) -> Callable[[Places, Any], Any]:
    return lambda z, size: off(z, point, bar) / size


def _bearings(seen: Seen) -> Iterator[Clearance]:
    """Hinges and links at the bearing of a yoke."""
    for stem in seen.draft.hints.get("stems", ()):
        yoke = next(points for points in seen.draft.bodies.values() if stem in points)
        for name in seen.visible:
            if name not in yoke:
                yield Clearance(_of_point(stem, name), *_BEARING, f"{name} at the bearing of a yoke")
        for bar in seen.draft.bars:
            if not {*bar} & {*yoke}:
                yield Clearance(_of_bar(stem, bar), *_BEARING, f"{bar[0]}{bar[1]} at the bearing of a yoke")


def _blocks(seen: Seen) -> Iterator[Clearance]:
    """Two blocks in one slot, or a block beside the slider to which the slot belongs."""
    for slot in seen.draft.hints.get("grooves", ()):
        own = next(points for points in seen.draft.bodies.values() if {*slot} <= {*points})
        riding = [point for point, *ends in seen.draft.inside if {*ends} == {*slot}]
        riding += [own[0]] if own[1:] == slot else []  # a slider with its slot across it, not a yoke
        for one, other in combinations(riding, 2):
            yield Clearance(_of_point(one, other), *_BLOCKS, f"{one} beside {other} in a slot")


def _racks(seen: Seen) -> Iterator[Clearance]:
    """A link at the end of a rack, which no point marks; a rod over its start."""
    for body, noun in seen.draft.nouns.items():
        if noun != TOOTHED_RACK:
            continue
        slider, end = seen.draft.bodies[body]
        for bar in seen.draft.bars:
            if slider not in bar:
                yield Clearance(_of_bar(end, bar), *_RACK_END, f"{bar[0]}{bar[1]} at the end of a rack")
            elif end not in bar:
                fault = f"{bar[0]}{bar[1]} over the start of a rack"
                yield Clearance(_off_start(slider, end, bar), *_RACK_START, fault)


def _off_start(slider: str, end: str, bar: Bar) -> Callable[[Places, Any], Any]:
    far = bar[1] if bar[0] == slider else bar[0]

    def measured(z: Places, _: Any) -> Any:
        turn = (z[far] - z[slider]) / (z[end] - z[slider])
        return (abs(turn.imag) / abs(turn)) * (turn.real > 0) + 1.0 * (turn.real <= 0)

    return measured
