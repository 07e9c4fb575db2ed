"""Where the named points lie, each seen from one that is known already."""

from __future__ import annotations

from collections.abc import Mapping

from variantgen.figure.alt_text.alt_text import AltText
from variantgen.figure.alt_text.directions import compass

_APART = 1e-6  # u


def positions(alt_text: AltText) -> list[str]:
    """``A above and to the right of O`` for each point but the first, fixed hinges first, along the bodies."""
    board = alt_text.board
    between = {point: ends for body in board.form.bodies for point, ends in alt_text.between[body].items()}
    waiting = [point for point in board.shown if point not in between or point in alt_text.fixed]
    if not waiting:
        return []
    known = [_first(alt_text, waiting)]
    waiting.remove(known[0])
    found = []
    while waiting:
        point, origin = _next(alt_text, waiting, known)
        waiting.remove(point)
        known.append(point)
        # What lies between two points that are known is known from the parts.
        known += [name for name, ends in between.items() if name not in known and set(ends) <= set(known)]
        place = alt_text.place(alt_text.at(point) - alt_text.at(origin), alt_text.name(origin))
        found.append(f"{alt_text.name(point)} {place}")
    return found


def _first(alt_text: AltText, points: list[str]) -> str:
    """Where a reader starts: a fixed hinge, the centre of a disc, or the first point."""
    centres = [circle.mark.centre for circle in alt_text.circles]
    return next(
        (point for known in (alt_text.fixed, alt_text.resting, centres) for point in points if point in known),
        points[0],
    )


def _next(alt_text: AltText, waiting: list[str], known: list[str]) -> tuple[str, str]:
    """The next point and the one that it is seen from: fixed hinges, then along bodies, then across joints."""
    hinge = next((point for point in waiting if point in alt_text.fixed), None)
    if hinge is not None:
        return hinge, known[0]
    point, origin = _neighbour(waiting, known, alt_text.companions) or (waiting[0], "")
    if not origin:
        point, origin = _neighbour(waiting, known, alt_text.coupled) or (waiting[0], known[0])
    return point, _level_with(alt_text, point, known) or origin


def _neighbour(waiting: list[str], known: list[str], near: Mapping[str, set[str]]) -> tuple[str, str] | None:
    """The first point that has a known one near it, with the first such one; None if there is none."""
    pairs = ((point, origin) for point in waiting if point in near for origin in known if origin in near[point])
    return next(pairs, None)


def _level_with(alt_text: AltText, point: str, known: list[str]) -> str:
    """A known point at rest or centre of a disc exactly above, below or beside the point; nothing if none is."""
    place = alt_text.at(point)
    for origin in known:
        if origin in alt_text.anchors:
            step = place - alt_text.at(origin)
            if abs(step) > _APART and len(compass(step)) == 1:
                return origin
    return ""
