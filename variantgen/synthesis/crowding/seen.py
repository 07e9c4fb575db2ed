"""A draft as those see it who judge whether it can be read: what belongs together, and what must keep off what."""

from __future__ import annotations

import cmath
import math
from collections.abc import Iterator, Mapping
from itertools import combinations
from typing import Any

from variantgen.synthesis.crowding.segments import Bar
from variantgen.synthesis.draft import Draft, Wheel

_SMALLEST = 80.0  # cm: while the first links are laid out, the mechanism counts as large as this
_ON_LINE = 1e-6  # of a bar: how far off its line a point of it may be by rounding
_GUIDE = 0.13  # of the whole: half the line of a fixed guide


class Seen:
    """A draft with what its screens ask for again and again."""

    def __init__(self, draft: Draft) -> None:
        self.draft, self.z = draft, draft.z
        self.members = {bar: _members(draft, bar) for bar in draft.bars}
        self.slid = {
            (point, bar)
            for point, start, end in draft.inside
            for bar, members in self.members.items()
            if start in members and end in members and _lies_along(draft, bar, (start, end))
        }
        hidden = draft.hints.get("hidden", ())
        self.visible = [name for name in draft.z if name not in hidden]
        places = [draft.z[name] for name in self.visible]
        places += [draft.z[wheel.centre] + wheel.radius * way for wheel in draft.wheels for way in (1 + 1j, -1 - 1j)]
        x, y = [place.real for place in places], [place.imag for place in places]
        self.sides = max(x) - min(x), max(y) - min(y)
        self.size = max(_SMALLEST, *self.sides)

    def joined(self, one: Bar, other: Bar) -> bool:
        """Whether two links have a common point or one slides on the other."""
        first, second, slid = self.members[one], self.members[other], self.slid
        sliding = any((point, one) in slid for point in second) or any((point, other) in slid for point in first)
        return sliding or bool(set(first) & set(second))

    def corners(self) -> Iterator[tuple[str, str]]:
        """Pairs of corners of marked angles."""
        return combinations(sorted({mark["at"] for mark in self.draft.marks}), 2)

    def off_wheel(self, wheel: Wheel) -> list[Bar]:
        """The bars that must not lie across a wheel: those that neither end at its centre nor touch it."""
        return [bar for bar in self.draft.bars if not {wheel.centre, *wheel.touching} & set(bar)]

    def guides(self) -> list[tuple[str, float]]:
        """The sliders in fixed guides and their directions (degrees); the bearing of a yoke is on its own bar."""
        stems = self.draft.hints.get("stems", ())
        fixed = [fields for kind, fields in self.draft.joints if kind == "guide" and fields["point"] not in stems]
        return [(fields["point"], float(fields.get("angle", 0))) for fields in fixed]

    def near_guides(self) -> Iterator[tuple[str, Bar]]:
        """Sliders in fixed guides, and the bars that must not lie across: none ends there or slides on the pin."""
        slid, grooves = self.slid, [set(ends) for ends in self.draft.hints.get("grooves", ())]
        for point, _ in self.guides():
            for bar in (bar for bar in self.draft.bars if set(bar) not in grooves or point not in self.members[bar]):
                through = point in self.members[bar] and point not in bar
                if through or (not {*bar} <= self.riding(point) and (point, bar) not in slid):
                    yield point, bar

    def riding(self, point: str) -> set[str]:
        """A point and those of its bodies."""
        return {point}.union(*(members for members in self.draft.bodies.values() if point in members))

    def with_guide(self, z: Mapping[str, Any], point: str, size: Any) -> Mapping[str, Any]:
        """Places with the ``start`` and the ``end`` of the line of a guide; ``size`` is that of the whole, as ``z``."""
        half = _GUIDE * size * cmath.rect(1.0, math.radians(dict(self.guides())[point]))
        return {**z, "start": z[point] - half, "end": z[point] + half}


def _lies_along(draft: Draft, bar: Bar, line: Bar) -> bool:
    """Whether a bar of a link is on the line of two of its points, not another one of the same link."""
    z, step = draft.z, draft.z[line[1]] - draft.z[line[0]]
    return all(abs(((z[end] - z[line[0]]) / step).imag) < _ON_LINE for end in bar)


def _members(draft: Draft, bar: Bar) -> list[str]:
    """The points of a link by two of them."""
    one, other = bar
    return next((points for points in draft.bodies.values() if one in points and other in points), list(bar))
