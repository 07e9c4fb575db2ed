"""How the direction of a new link is said: by words (horizontal, perpendicular) or by an angle."""

from __future__ import annotations

import math

from variantgen.synthesis.draft import Draft, Facts

_MARKED = (45, 60, 75, 105, 120, 135)
_OFF_AXES, _INCLINED = (30, 40, 50, 60), 0.7  # where no link is near to measure from
_AXES = (0, 90, 180, 270)


def way(draft: Draft, at: str, new: str, far: str, words: float = 0.55) -> tuple[float, Facts, list[tuple[str, Facts]]]:
    """The direction of a link from the point ``at`` to ``new``: degrees, fields of ``polar``, what the position says.

    ``far`` is another point of the link on which it hangs; ``words``: how often it is said without a number.
    """
    if not far and draft.rng.random() < _INCLINED:
        return _inclined(draft, at, new)
    if not far or draft.rng.random() < words:
        return _along_axis(draft, at, new, draft.rng.choice(_AXES))
    base = draft.direction(at, far)
    if draft.rng.random() < 0.25:
        turn = draft.rng.choice((90, -90))
        if draft.lies_along_axis(at, far):  # then this one does as well, which is said shorter
            return _along_axis(draft, at, new, round(base + turn) % 360)
        draft.hint("right_angles", {"at": at, "from": far, "to": new})
        facts = {"one": _named(draft, at, far), "link": at + new}
        return base + turn, {"towards": far, "angle": f"{turn}*deg"}, [("square", facts)]
    size, turn = draft.rng.choice(_MARKED), draft.rng.choice((1, -1))
    name = draft.angle(size, at, far, new)
    fields = {"towards": far, "angle": f"{'' if turn > 0 else '-'}{name}"}
    return base + turn * size, fields, [("angle", {"angle": name, "one": at + far, "other": at + new})]


def _inclined(draft: Draft, at: str, new: str) -> tuple[float, Facts, list[tuple[str, Facts]]]:
    """At an acute angle with the horizontal, marked on the side of the link."""
    size, turn = draft.rng.choice(_OFF_AXES), draft.rng.choice((1, -1))
    aside = sum((draft.z[end] - draft.z[at]).real for bar in draft.bars if at in bar for end in bar)
    # The ground of a slider in a vertical guide is on the side away from its rods.
    back = aside < 0 if _is_upright_slider(draft, at) else draft.rng.random() < 0.5
    name = draft.angle(size, at, "-x" if back else "+x", new)
    said = [("incline", {"angle": name, "link": at + new})]
    if back:
        return float(180 - turn * size), {"angle": f"180*deg {'-' if turn > 0 else '+'} {name}"}, said
    return float(turn * size), {"angle": f"{'' if turn > 0 else '-'}{name}"}, said


def _is_upright_slider(draft: Draft, point: str) -> bool:
    guides = [fields for kind, fields in draft.joints if kind == "guide"]
    return any(fields["point"] == point and fields.get("angle") == 90 for fields in guides)


def _along_axis(draft: Draft, at: str, new: str, angle: int) -> tuple[float, Facts, list[tuple[str, Facts]]]:
    """Horizontal or vertical."""
    draft.along_axes.add(frozenset((at, new)))
    key = "level" if angle % 180 == 0 else "upright"
    return float(angle), {"angle": f"{angle}*deg"} if angle else {}, [(key, {"link": at + new})]


def _named(draft: Draft, one: str, other: str) -> str:
    """The name of the link of two points; one that is being laid out is called from its start, ``other``."""
    links = (body for body, points in draft.bodies.items() if {one, other} <= {*points} and body not in draft.nouns)
    return next(links, other + one)


def between(one: float, other: float) -> float:
    """The angle of two directions, from 0 to 180 degrees."""
    return abs((one - other + 180) % 360 - 180)


def off_line(one: float, other: float) -> float:
    """The angle of two lines, from 0 to 90 degrees."""
    angle = between(one, other)
    return min(angle, 180 - angle)


def rounded(angle: float) -> float:
    """An angle from -180 to 180 degrees."""
    return math.remainder(angle, 360)
