"""Whether a mechanism that is laid out can be read: hinges apart and off foreign links, no crossings, sane lengths."""

from __future__ import annotations

import cmath
import math
from collections.abc import Iterator, Mapping
from itertools import combinations
from typing import Any, TypeAlias

import numpy as np
from numpy.typing import NDArray

from variantgen.synthesis.draft import Draft, Wheel

Bar: TypeAlias = tuple[str, str]
_SMALLEST = 80.0  # cm: while the first links are laid out, the mechanism counts as large as this
_APART, _CLEAR, _BASE = 0.09, 0.06, 1.5  # of hinges; of a hinge from a foreign link; more of a fixed one: sizes
_FOLDED, _STRAIGHT = 18, 10  # degrees between two links at a common hinge, and from one straight line
_GUIDE = 0.13  # of the whole: half the line of a fixed guide
_MARKED = 0.2  # of the whole, between the corners of two marked angles, whose arcs would meet
# Of the whole: what the end of a rack and the rim of a wheel keep from foreign links on all draws.
_STILL_CLEAR, _OFF_RIM = 0.04, 0.02
_OFF_WHEEL = 1.4  # radii of a wheel that others keep from its centre
_MARGIN = 0.2  # of its guide, at each end, that a block keeps clear
_RATIO = 4.0  # longest over shortest length
_LONGEST, _LARGEST = 3.2, 300.0  # longer over shorter side of the whole; cm


def crowded(draft: Draft) -> str:
    """What is too near to what, or crosses it; nothing where the figure is clear."""
    screens = (_near, _on_bars, _on_racks, _on_wheels, _bars, _blocks, _on_guides, _marks, _lengths)
    return next(filter(None, (screen(draft) for screen in screens)), "")


def too_long(draft: Draft) -> str:
    """Whether the whole is too long for its width, or too large."""
    wide, high = _sides(draft)
    if max(wide, high) > _LONGEST * min(wide, high):
        return "too long"
    return "too large" if max(wide, high) > _LARGEST else ""


def crossed(draft: Draft, z: Mapping[str, NDArray[np.complex128]]) -> NDArray[np.bool_]:
    """On which of N variants of a draft two links cross that nothing joins, or one a guide or a wheel, or one is at the
    end of a rack; ``z`` has its points, in cm, shape (N,) each.
    """
    found = np.zeros(next(iter(z.values())).shape, dtype=bool)
    places = np.array([z[name] for name in _visible(draft)])
    size = np.maximum(np.ptp(places.real, axis=0), np.ptp(places.imag, axis=0))
    for point, bar in _near_guides(draft):
        found |= _cross(_with_guide(draft, z, point, size), ("start", "end"), bar)
    for end, bar in _near_racks(draft):
        found |= _off(z, end, bar) < _STILL_CLEAR * size
    for wheel in draft.wheels:
        for bar in _off_wheel(draft, wheel):
            found |= _off(z, wheel.centre, bar) < wheel.largest + _OFF_RIM * size
    for one, other in combinations(draft.bars, 2):
        if not _joined(draft, one, other):
            found |= _cross(z, one, other)
    return found


def _near(draft: Draft) -> str:
    size = _size(draft)
    for one, other in combinations(_visible(draft), 2):
        need = _APART * (_BASE if one in draft.pivots or other in draft.pivots else 1.0)
        if draft.distance(one, other) < need * size:
            return f"{one} near {other}"
    return ""


def _on_bars(draft: Draft) -> str:
    """A point on a link that it neither belongs to nor slides on."""
    slid, size, visible = _slid(draft), _size(draft), _visible(draft)
    for bar in draft.bars:
        members = _members(draft, bar)
        for name in visible:
            if name in members or (name, bar) in slid:
                continue
            need = _CLEAR * (_BASE if name in draft.pivots else 1.0)
            if _off(draft.z, name, bar) < need * size:
                return f"{name} on {bar[0]}{bar[1]}"
    return ""


def _on_racks(draft: Draft) -> str:
    """A link at the end of a rack, which no point marks."""
    size = _size(draft)
    for end, bar in _near_racks(draft):
        if _off(draft.z, end, bar) < _CLEAR * size:
            return f"{bar[0]}{bar[1]} at the end of a rack"
    return ""


def _near_racks(draft: Draft) -> Iterator[tuple[str, Bar]]:
    """The ends of racks beyond their wheels, and the bars that are not hinged to the slider of the rack."""
    for body, noun in draft.nouns.items():
        if noun == "rack":
            slider, end = draft.bodies[body]
            yield from ((end, bar) for bar in draft.bars if slider not in bar)


def _on_wheels(draft: Draft) -> str:
    """A link or a point in the way of a wheel."""
    for wheel in draft.wheels:
        need = _OFF_WHEEL * wheel.radius
        for bar in _off_wheel(draft, wheel):
            if _off(draft.z, wheel.centre, bar) < need:
                return f"{bar[0]}{bar[1]} on the wheel"
        for name in _visible(draft):
            if name not in (wheel.centre, *wheel.touching) and draft.distance(wheel.centre, name) < need:
                return f"{name} on the wheel"
    return ""


def _off_wheel(draft: Draft, wheel: Wheel) -> list[Bar]:
    """The bars that must not lie across a wheel: those that neither end at its centre nor touch it."""
    return [bar for bar in draft.bars if not {wheel.centre, *wheel.touching} & set(bar)]


def _bars(draft: Draft) -> str:
    """Two links that cross, or that lie on each other."""
    for one, other in combinations(draft.bars, 2):
        if _members(draft, one) == _members(draft, other):
            continue
        if not _joined(draft, one, other):
            if _cross(draft.z, one, other):
                return "links cross"
        elif _folded(draft, one, other):
            return "links lie on each other"
    return ""


def _blocks(draft: Draft) -> str:
    """A block at the end of its guide, or a link of it that lies along the guide."""
    for point, start, end in draft.inside:
        guide = draft.z[end] - draft.z[start]
        for bar in draft.bars:
            members = _members(draft, bar)
            if point in members and not {start, end} <= set(members):
                far = bar[1] if point == bar[0] else bar[0]
                angle = abs(math.degrees(cmath.phase((draft.z[far] - draft.z[point]) / guide)))
                if min(angle, 180 - angle) < _FOLDED:
                    return f"{bar[0]}{bar[1]} along the guide of {point}"
        part = ((draft.z[point] - draft.z[start]) / (draft.z[end] - draft.z[start])).real
        if not _MARGIN <= part <= 1 - _MARGIN:
            return f"{point} at the end of its guide"
    return ""


def _on_guides(draft: Draft) -> str:
    """A link across the line of a fixed guide, or a point on it."""
    size = _size(draft)
    for point, bar in _near_guides(draft):
        if _cross(_with_guide(draft, draft.z, point, size), ("start", "end"), bar):
            return f"{bar[0]}{bar[1]} across the guide of {point}"
    for point, _ in _guides(draft):
        z, own = _with_guide(draft, draft.z, point, size), _riding(draft, point)
        for name in _visible(draft):
            if name not in own and _off(z, name, ("start", "end")) < _CLEAR * size:
                return f"{name} on the guide of {point}"
    return ""


def _guides(draft: Draft) -> list[tuple[str, float]]:
    """The sliders in fixed guides and the directions of these (degrees); the bearing of a yoke is on its own bar."""
    stems = draft.hints.get("stems", ())
    guides = [fields for kind, fields in draft.joints if kind == "guide" and fields["point"] not in stems]
    return [(fields["point"], float(fields.get("angle", 0))) for fields in guides]


def _near_guides(draft: Draft) -> Iterator[tuple[str, Bar]]:
    """Sliders in fixed guides, and the bars that must not lie across these: none ends there or slides on the pin."""
    slid, grooves = _slid(draft), [set(ends) for ends in draft.hints.get("grooves", ())]
    for point, _ in _guides(draft):
        for bar in (bar for bar in draft.bars if set(bar) not in grooves or point not in _members(draft, bar)):
            through = point in _members(draft, bar) and point not in bar
            if through or (not {*bar} <= _riding(draft, point) and (point, bar) not in slid):
                yield point, bar


def _riding(draft: Draft, point: str) -> set[str]:
    """A point and those of its bodies."""
    return {point}.union(*(members for members in draft.bodies.values() if point in members))


def _with_guide(draft: Draft, z: Mapping[str, Any], point: str, size: Any) -> Mapping[str, Any]:
    """Places with the ``start`` and the ``end`` of the line of a guide; ``size`` is that of the whole, as ``z``."""
    half = _GUIDE * size * cmath.rect(1.0, math.radians(dict(_guides(draft))[point]))
    return {**z, "start": z[point] - half, "end": z[point] + half}


def _marks(draft: Draft) -> str:
    """Two marked angles at hinges that have no room for both arcs."""
    size = _size(draft)
    for one, other in combinations(sorted({mark["at"] for mark in draft.marks}), 2):
        if draft.distance(one, other) < _MARKED * size:
            return f"angles at {one} and {other}"
    return ""


def _lengths(draft: Draft) -> str:
    sizes = [datum.value for datum in draft.data.values() if datum.unit == "cm"]
    return "lengths differ too much" if max(sizes) > _RATIO * min(sizes) else ""


def _visible(draft: Draft) -> list[str]:
    hidden = set(draft.hints.get("hidden", ()))
    return [name for name in draft.z if name not in hidden]


def _sides(draft: Draft) -> tuple[float, float]:
    z = [draft.z[name] for name in _visible(draft)]
    x, y = [place.real for place in z], [place.imag for place in z]
    return max(x) - min(x), max(y) - min(y)


def _size(draft: Draft) -> float:
    return max(_SMALLEST, *_sides(draft))


def _members(draft: Draft, bar: Bar) -> list[str]:
    """The points of a link by two of them."""
    one, other = bar
    return next((points for points in draft.bodies.values() if one in points and other in points), list(bar))


def _slid(draft: Draft) -> set[tuple[str, Bar]]:
    """Blocks with the bars, as they are drawn, on which they slide."""
    return {
        (point, bar)
        for point, start, end in draft.inside
        for bar in draft.bars
        if {start, end} <= set(_members(draft, bar))
    }


def _joined(draft: Draft, one: Bar, other: Bar) -> bool:
    """Whether two links have a common point or one slides on the other."""
    first, second, slid = _members(draft, one), _members(draft, other), _slid(draft)
    sliding = any((point, one) in slid for point in second) or any((point, other) in slid for point in first)
    return sliding or bool(set(first) & set(second))


def _off(z: Mapping[str, Any], name: str, bar: Bar) -> Any:
    """How far a point is from a segment; numbers or arrays."""
    start, step = z[bar[0]], z[bar[1]] - z[bar[0]]
    part = ((z[name] - start) / step).real
    part = min(max(part, 0.0), 1.0) if isinstance(part, float) else np.clip(part, 0.0, 1.0)
    return abs(z[name] - start - part * step)


def _cross(z: Mapping[str, Any], one: Bar, other: Bar) -> Any:
    """Whether two segments cross; numbers or arrays."""
    a, b, c, d = (z[name] for name in (*one, *other))

    def side(p: Any, q: Any, r: Any) -> Any:
        return ((q - p).conjugate() * (r - p)).imag

    return (side(a, b, c) * side(a, b, d) < 0) & (side(c, d, a) * side(c, d, b) < 0)


def _folded(draft: Draft, one: Bar, other: Bar) -> bool:
    """Whether two links with a common hinge lie nearly on each other, or one goes on where the other ends."""
    for hinge in set(_members(draft, one)) & set(_members(draft, other)):
        ways = [[draft.z[end] - draft.z[hinge] for end in bar if end != hinge] for bar in (one, other)]
        angles = [abs(math.degrees(cmath.phase(p / q))) for p in ways[0] for q in ways[1]]
        if any(angle < _FOLDED or angle > 180 - _STRAIGHT for angle in angles):
            return True
    return False
