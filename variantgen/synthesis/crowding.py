"""Whether a mechanism that is laid out can be read: hinges apart and off foreign links, no crossings, sane lengths."""

from __future__ import annotations

import cmath
import math
from collections.abc import Iterator, Mapping
from itertools import combinations
from typing import Any

import numpy as np
from numpy.typing import NDArray

from variantgen.synthesis.draft import Draft, Wheel
from variantgen.synthesis.seen import Bar, Seen, cross, off
from variantgen.synthesis.slide_room import rooms

_APART, _CLEAR = 0.09, 0.06  # of hinges; of a hinge from a foreign link: sizes
_BASE, _BOTH_FIXED = 1.5, 2.0  # as many times as much: of a fixed hinge, of two
_FOLDED, _STRAIGHT = 18, 10  # degrees between two links at a common hinge, and from one straight line
_GUIDE = 0.13  # of the whole: half the line of a fixed guide
_MARKED, _STILL_MARKED = 0.25, 0.2  # of the whole, between the corners of two marked angles; on all draws
_ARC = 0.13  # of the whole: the radius of the arc of a marked angle, and of the arrows about the driving link
_OFF_RIM = 0.02  # of the whole: what the rim of a wheel keeps from foreign links on all draws
# Radii of a wheel that others keep from its centre; more of the first axis: sizes.
_OFF_WHEEL, _PIVOT_OFF_RIM = 1.4, 0.13
_MARGIN = 0.2  # of its guide, at each end, that a block keeps clear
_AXES = {"+x": 1 + 0j, "-x": -1 + 0j, "+y": 1j, "-y": -1j}
_PARTS = [place / 16 for place in range(17)]  # of a bar that is looked at
_RATIO = 4.0  # longest over shortest length
_LONGEST, _LARGEST = 3.2, 300.0  # longer over shorter side of the whole; cm


def crowded(draft: Draft) -> str:
    """What is too near to what, or crosses it; nothing where the figure is clear."""
    seen = Seen(draft)
    screens = (_near, _on_bars, _at_slides, _on_wheels, _bars, _blocks, _on_guides, _marks, _lengths)
    return next(filter(None, (screen(seen) for screen in screens)), "")


def too_long(draft: Draft) -> str:
    """Whether the whole is too long for its width, or too large."""
    wide, high = Seen(draft).sides
    if max(wide, high) > _LONGEST * min(wide, high):
        return "too long"
    return "too large" if max(wide, high) > _LARGEST else ""


def crossed(draft: Draft, z: Mapping[str, NDArray[np.complex128]]) -> NDArray[np.bool_]:
    """On which of N variants of a draft two links cross that nothing joins, or one a guide or a wheel, or something
    slides where there is no room to show it; ``z`` has its points, in cm, shape (N,) each.
    """
    seen = Seen(draft)
    found = np.zeros(next(iter(z.values())).shape, dtype=bool)
    places = np.array([z[name] for name in seen.visible])
    size = np.maximum(np.ptp(places.real, axis=0), np.ptp(places.imag, axis=0))
    for one, other in _corners(seen):
        found |= np.abs(z[one] - z[other]) < _STILL_MARKED * size
    for point, bar in _near_guides(seen):
        found |= cross(_with_guide(seen, z, point, size), ("start", "end"), bar)
    for room in rooms(seen):
        found |= room.measured(z, size) < room.still
    for wheel in draft.wheels:
        for bar in _off_wheel(seen, wheel):
            found |= off(z, wheel.centre, bar) < wheel.largest + _OFF_RIM * size
    for first, second in combinations(draft.bars, 2):
        if not _joined(seen, first, second):
            found |= cross(z, first, second)
    return found


def _near(seen: Seen) -> str:
    for one, other in combinations(seen.visible, 2):
        pivots = (one in seen.draft.pivots) + (other in seen.draft.pivots)
        need = _APART * (1.0, _BASE, _BOTH_FIXED)[pivots]
        if seen.draft.distance(one, other) < need * seen.size:
            return f"{one} near {other}"
    return ""


def _on_bars(seen: Seen) -> str:
    """A point on a link that it neither belongs to nor slides on."""
    for bar, members in seen.members.items():
        for name in seen.visible:
            if name in members or (name, bar) in seen.slid:
                continue
            need = _ARC if name == "O" else _CLEAR * (_BASE if name in seen.draft.pivots else 1.0)
            if off(seen.z, name, bar) < need * seen.size:
                return f"{name} on {bar[0]}{bar[1]}"
    return ""


def _at_slides(seen: Seen) -> str:
    """A link or a point in the way of what shows that something slides."""
    return next((room.told for room in rooms(seen) if room.measured(seen.z, seen.size) < room.first), "")


def _on_wheels(seen: Seen) -> str:
    """A link or a point in the way of a wheel."""
    for wheel in seen.draft.wheels:
        need = _OFF_WHEEL * wheel.radius
        if wheel.centre != "O" and seen.draft.distance(wheel.centre, "O") < wheel.radius + _PIVOT_OFF_RIM * seen.size:
            return "the driving link at the wheel"
        for bar in _off_wheel(seen, wheel):
            if off(seen.z, wheel.centre, bar) < need:
                return f"{bar[0]}{bar[1]} on the wheel"
        for name in seen.visible:
            if name not in (wheel.centre, *wheel.touching) and seen.draft.distance(wheel.centre, name) < need:
                return f"{name} on the wheel"
    return ""


def _off_wheel(seen: Seen, wheel: Wheel) -> list[Bar]:
    """The bars that must not lie across a wheel: those that neither end at its centre nor touch it."""
    return [bar for bar in seen.draft.bars if not {wheel.centre, *wheel.touching} & set(bar)]


def _bars(seen: Seen) -> str:
    """Two links that cross, or that lie on each other."""
    for one, other in combinations(seen.draft.bars, 2):
        if seen.members[one] == seen.members[other]:
            continue
        if not _joined(seen, one, other):
            if cross(seen.z, one, other):
                return "links cross"
        elif _folded(seen, one, other):
            return "links lie on each other"
    return ""


def _blocks(seen: Seen) -> str:
    """A block at the end of its guide, or a link of it that lies along the guide."""
    for point, start, end in seen.draft.inside:
        guide = seen.z[end] - seen.z[start]
        for bar in seen.draft.bars:
            members = seen.members[bar]
            if point in members and not {start, end} <= set(members):
                far = bar[1] if point == bar[0] else bar[0]
                angle = abs(math.degrees(cmath.phase((seen.z[far] - seen.z[point]) / guide)))
                if min(angle, 180 - angle) < _FOLDED:
                    return f"{bar[0]}{bar[1]} along the guide of {point}"
        part = ((seen.z[point] - seen.z[start]) / (seen.z[end] - seen.z[start])).real
        if not _MARGIN <= part <= 1 - _MARGIN:
            return f"{point} at the end of its guide"
    return ""


def _on_guides(seen: Seen) -> str:
    """A link across the line of a fixed guide, or a point on it; the guide on the line from which an angle is told."""
    size, base = seen.size, ("O", seen.draft.base)
    for point, bar in _near_guides(seen):
        if cross(_with_guide(seen, seen.z, point, size), ("start", "end"), bar):
            return f"{bar[0]}{bar[1]} across the guide of {point}"
    for point, _ in _guides(seen):
        z, own = _with_guide(seen, seen.z, point, size), _riding(seen, point)
        for name in seen.visible:
            if name not in own and off(z, name, ("start", "end")) < _CLEAR * size:
                return f"{name} on the guide of {point}"
        if base[1] in set(z) - own and min(off(z, name, base) for name in (point, "start", "end")) < _APART * size:
            return f"the guide of {point} on the line O{base[1]}"
    return ""


def _guides(seen: Seen) -> list[tuple[str, float]]:
    """The sliders in fixed guides and the directions of these (degrees); the bearing of a yoke is on its own bar."""
    stems = seen.draft.hints.get("stems", ())
    guides = [fields for kind, fields in seen.draft.joints if kind == "guide" and fields["point"] not in stems]
    return [(fields["point"], float(fields.get("angle", 0))) for fields in guides]


def _near_guides(seen: Seen) -> Iterator[tuple[str, Bar]]:
    """Sliders in fixed guides, and the bars that must not lie across these: none ends there or slides on the pin."""
    slid, grooves = seen.slid, [set(ends) for ends in seen.draft.hints.get("grooves", ())]
    for point, _ in _guides(seen):
        for bar in (bar for bar in seen.draft.bars if set(bar) not in grooves or point not in seen.members[bar]):
            through = point in seen.members[bar] and point not in bar
            if through or (not {*bar} <= _riding(seen, point) and (point, bar) not in slid):
                yield point, bar


def _riding(seen: Seen, point: str) -> set[str]:
    """A point and those of its bodies."""
    return {point}.union(*(members for members in seen.draft.bodies.values() if point in members))


def _with_guide(seen: Seen, z: Mapping[str, Any], point: str, size: Any) -> Mapping[str, Any]:
    """Places with the ``start`` and the ``end`` of the line of a guide; ``size`` is that of the whole, as ``z``."""
    half = _GUIDE * size * cmath.rect(1.0, math.radians(dict(_guides(seen))[point]))
    return {**z, "start": z[point] - half, "end": z[point] + half}


def _marks(seen: Seen) -> str:
    """Two marked angles at hinges that have no room for both arcs, or a link across an arc."""
    for one, other in _corners(seen):
        if seen.draft.distance(one, other) < _MARKED * seen.size:
            return f"angles at {one} and {other}"
    for mark in seen.draft.marks:
        for bar in seen.draft.bars:
            if mark["at"] not in seen.members[bar] and _in_sector(seen, mark, bar, _ARC * seen.size):
                return f"{bar[0]}{bar[1]} across the angle at {mark['at']}"
    return ""


def _corners(seen: Seen) -> Iterator[tuple[str, str]]:
    """Pairs of corners of marked angles."""
    return combinations(sorted({mark["at"] for mark in seen.draft.marks}), 2)


def _in_sector(seen: Seen, mark: Mapping[str, str], bar: Bar, radius: float) -> bool:
    """Whether a bar comes nearer than the arc of a marked angle, within that angle."""
    if off(seen.z, mark["at"], bar) >= radius:
        return False
    corner = seen.z[mark["at"]]
    rays = [_AXES.get(mark[end]) or seen.z[mark[end]] - corner for end in ("from", "to")]
    sweep = cmath.phase(rays[1] / rays[0])
    for part in _PARTS:
        step = seen.z[bar[0]] + part * (seen.z[bar[1]] - seen.z[bar[0]]) - corner
        if abs(step) < radius and 0 <= cmath.phase(step / rays[0]) / sweep <= 1:
            return True
    return False


def _lengths(seen: Seen) -> str:
    sizes = [datum.value for datum in seen.draft.data.values() if datum.unit == "cm"]
    return "lengths differ too much" if max(sizes) > _RATIO * min(sizes) else ""


def _joined(seen: Seen, one: Bar, other: Bar) -> bool:
    """Whether two links have a common point or one slides on the other."""
    first, second, slid = seen.members[one], seen.members[other], seen.slid
    sliding = any((point, one) in slid for point in second) or any((point, other) in slid for point in first)
    return sliding or bool(set(first) & set(second))


def _folded(seen: Seen, one: Bar, other: Bar) -> bool:
    """Whether two links with a common hinge lie nearly on each other, or one goes on where the other ends."""
    for hinge in set(seen.members[one]) & set(seen.members[other]):
        ways = [[seen.z[end] - seen.z[hinge] for end in bar if end != hinge] for bar in (one, other)]
        angles = [abs(math.degrees(cmath.phase(p / q))) for p in ways[0] for q in ways[1]]
        if any(angle < _FOLDED or angle > 180 - _STRAIGHT for angle in angles):
            return True
    return False
