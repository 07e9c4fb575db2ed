"""A draft as its screens see it: what is visible, how large it is, which points are on which bars."""

from __future__ import annotations

from collections.abc import Mapping
from typing import Any, TypeAlias

import numpy as np

from variantgen.synthesis.draft import Draft

Bar: TypeAlias = tuple[str, str]
_SMALLEST = 80.0  # cm: while the first links are laid out, the mechanism counts as large as this
_ON_LINE = 1e-6  # of a bar: how far off its line a point of it may be by rounding


class Seen:
    """A draft with what its screens ask for again and again."""

    def __init__(self, draft: Draft) -> None:
        self.draft, self.z = draft, draft.z
        self.members = {bar: members_of(draft, bar) for bar in draft.bars}
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


def members_of(draft: Draft, bar: Bar) -> list[str]:
    """The points of a link by two of them."""
    one, other = bar
    return next((points for points in draft.bodies.values() if one in points and other in points), list(bar))


def _lies_along(draft: Draft, bar: Bar, line: Bar) -> bool:
    """Whether a bar of a link is on the line of two of its points, not another one of the same link."""
    z, step = draft.z, draft.z[line[1]] - draft.z[line[0]]
    return all(abs(((z[end] - z[line[0]]) / step).imag) < _ON_LINE for end in bar)


def off(z: Mapping[str, Any], name: str, bar: Bar) -> Any:
    """How far a point is from a segment; numbers or arrays."""
    start, step = z[bar[0]], z[bar[1]] - z[bar[0]]
    part = ((z[name] - start) / step).real
    part = min(max(part, 0.0), 1.0) if isinstance(part, float) else np.clip(part, 0.0, 1.0)
    return abs(z[name] - start - part * step)


def cross(z: Mapping[str, Any], one: Bar, other: Bar) -> Any:
    """Whether two segments cross; numbers or arrays."""
    a, b, c, d = (z[name] for name in (*one, *other))

    def side(p: Any, q: Any, r: Any) -> Any:
        return ((q - p).conjugate() * (r - p)).imag

    return (side(a, b, c) * side(a, b, d) < 0) & (side(c, d, a) * side(c, d, b) < 0)
