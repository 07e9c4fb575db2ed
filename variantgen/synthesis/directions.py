"""How the direction of a new link is said: by words (horizontal, perpendicular) or by an angle."""

from __future__ import annotations

import math

from variantgen.synthesis.draft import Draft, Facts

_MARKED = (45, 60, 75, 105, 120, 135)
_OFF_AXES, _INCLINED = (30, 40, 50, 60, 120, 130, 140, 150), 0.7  # where no link is near to measure from
_AXES = (0, 90, 180, 270)


def way(draft: Draft, at: str, new: str, far: str, words: float = 0.55) -> tuple[float, Facts, list[tuple[str, Facts]]]:
    """The direction of a link from the point ``at`` to ``new``: degrees, fields of ``polar``, what the position says.

    ``far`` is another point of the link on which it hangs; ``words``: how often it is said without a number. The
    angle is marked only when :func:`marked` is called, so that a direction that leads nowhere leaves no datum.
    """
    if not far and draft.rng.random() < _INCLINED:
        size, turn = draft.rng.choice(_OFF_AXES), draft.rng.choice((1, -1))
        name = draft.angle(size, at, "+x", new)
        fields = {"angle": f"{'' if turn > 0 else '-'}{name}"}
        return float(turn * size), fields, [("incline", {"angle": name, "link": at + new})]
    if not far or draft.rng.random() < words:
        angle = draft.rng.choice(_AXES)
        key = "level" if angle % 180 == 0 else "upright"
        return float(angle), {"angle": f"{angle}*deg"} if angle else {}, [(key, {"link": at + new})]
    base = draft.direction(at, far)
    if draft.rng.random() < 0.25:
        turn = draft.rng.choice((90, -90))
        draft.hint("right_angles", {"at": at, "from": far, "to": new})
        return base + turn, {"towards": far, "angle": f"{turn}*deg"}, [("square", {"one": at + far, "link": at + new})]
    size, turn = draft.rng.choice(_MARKED), draft.rng.choice((1, -1))
    name = draft.angle(size, at, far, new)
    fields = {"towards": far, "angle": f"{'' if turn > 0 else '-'}{name}"}
    return base + turn * size, fields, [("angle", {"angle": name, "one": at + far, "other": at + new})]


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
