"""Whether a mechanism that is laid out can be read: hinges apart and off foreign links, no crossings, sane lengths."""

from __future__ import annotations

import cmath
import math
from collections.abc import Mapping
from itertools import combinations

from variantgen.synthesis.crowding.clearances import clearances
from variantgen.synthesis.crowding.seen import Seen
from variantgen.synthesis.crowding.segments import Bar, cross, off
from variantgen.synthesis.draft import Draft

_APART, _CLEAR = 0.09, 0.06  # of hinges; of a hinge from a foreign link: sizes
_BASE, _BOTH_FIXED = 1.5, 2.0  # as many times as much: of a fixed hinge, of two
_FOLDED, _STRAIGHT = 18, 10  # degrees between two links at a common hinge, and from one straight line
_MARKED = 0.25  # of the whole, between the corners of two marked angles
_ARC = 0.13  # of the whole: the radius of the arc of a marked angle, and of the arrows about the driving link
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
    return next(
        (clearance.fault for clearance in clearances(seen) if clearance.measured(seen.z, seen.size) < clearance.first),
        "",
    )


def _on_wheels(seen: Seen) -> str:
    """A link or a point in the way of a wheel."""
    for wheel in seen.draft.wheels:
        need = _OFF_WHEEL * wheel.radius
        if wheel.centre != "O" and seen.draft.distance(wheel.centre, "O") < wheel.radius + _PIVOT_OFF_RIM * seen.size:
            return "the driving link at the wheel"
        for bar in seen.off_wheel(wheel):
            if off(seen.z, wheel.centre, bar) < need:
                return f"{bar[0]}{bar[1]} on the wheel"
        for name in seen.visible:
            if name not in (wheel.centre, *wheel.touching) and seen.draft.distance(wheel.centre, name) < need:
                return f"{name} on the wheel"
    return ""


def _bars(seen: Seen) -> str:
    """Two links that cross, or that lie on each other."""
    for one, other in combinations(seen.draft.bars, 2):
        if seen.members[one] == seen.members[other]:
            continue
        if not seen.joined(one, other):
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
    for point, bar in seen.near_guides():
        if cross(seen.with_guide(seen.z, point, size), ("start", "end"), bar):
            return f"{bar[0]}{bar[1]} across the guide of {point}"
    for point, _ in seen.guides():
        z, own = seen.with_guide(seen.z, point, size), seen.riding(point)
        for name in seen.visible:
            if name not in own and off(z, name, ("start", "end")) < _CLEAR * size:
                return f"{name} on the guide of {point}"
        if base[1] in set(z) - own and min(off(z, name, base) for name in (point, "start", "end")) < _APART * size:
            return f"the guide of {point} on the line O{base[1]}"
    return ""


def _marks(seen: Seen) -> str:
    """Two marked angles at hinges that have no room for both arcs, or a link across an arc."""
    for one, other in seen.corners():
        if seen.draft.distance(one, other) < _MARKED * seen.size:
            return f"angles at {one} and {other}"
    for mark in seen.draft.marks:
        for bar in seen.draft.bars:
            if mark["at"] not in seen.members[bar] and _in_sector(seen, mark, bar, _ARC * seen.size):
                return f"{bar[0]}{bar[1]} across the angle at {mark['at']}"
    return ""


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


def _folded(seen: Seen, one: Bar, other: Bar) -> bool:
    """Whether two links with a common hinge lie nearly on each other, or one goes on where the other ends."""
    for hinge in set(seen.members[one]) & set(seen.members[other]):
        ways = [[seen.z[end] - seen.z[hinge] for end in bar if end != hinge] for bar in (one, other)]
        angles = [abs(math.degrees(cmath.phase(p / q))) for p in ways[0] for q in ways[1]]
        if any(angle < _FOLDED or angle > 180 - _STRAIGHT for angle in angles):
            return True
    return False
