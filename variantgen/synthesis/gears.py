"""A gear about a fixed axis at the end of a mechanism, in mesh with a gear on a link about another fixed axis."""

from __future__ import annotations

from variantgen.synthesis.draft import PINION, Datum, Draft, LayoutError
from variantgen.synthesis.dyad_parts import new_pivot
from variantgen.synthesis.structures import AssurGroup

_RADII = (14, 16, 18, 20, 22, 24, 26)  # cm
_ROOM = 0.62  # of a link, from its axis, that a gear on it may take
_APART = (0.6, 1.7)  # of the radii, one over the other; but they differ by a fifth at least


def gear_in_mesh(draft: Draft, links: tuple[int, int], dyad: AssurGroup, _: dict[int, str]) -> None:
    """WR: the gear on a link about a fixed axis drives another one."""
    link = draft.links[dyad.on]
    axis = next((name for name in draft.bodies.get(link.body, ()) if name in draft.pivots), None)
    if axis is None:
        raise LayoutError("the link does not turn about a fixed axis")
    driving, driven = draft.rng.choice(_RADII), draft.rng.choice(_RADII)
    nearest = min(draft.distance(axis, name) for name in draft.bodies[link.body] if name != axis)
    ratio = driving / driven
    if driving > _ROOM * nearest or not _APART[0] <= ratio <= _APART[1] or 0.8 < ratio < 1.25:
        raise LayoutError("gears that do not go together")
    on_link, own = ("R", "r") if driving > driven else ("r", "R")
    draft.data |= {"R": Datum("cm", max(driving, driven), 2, 2), "r": Datum("cm", min(driving, driven), 2, 2)}
    angle = draft.rng.choice((0, 90, 180, 270))
    way = {"angle": f"{angle}*deg"} if angle else {}
    pivot = draft.pivot()
    draft.place(pivot, axis, driving + driven, angle)
    draft.points[pivot] = "polar", {"origin": axis, "distance": "R + r", **way}
    new_pivot(draft)
    draft.wheels += [(axis, on_link), (pivot, own)]
    draft.bodies[PINION] = [pivot]
    draft.symbols[PINION] = "1"
    fields = {"body": PINION, "centre": pivot, "radius": own, "other_centre": axis, "other": link.body}
    draft.joint("gears", **fields)
    draft.hint("discs", {"centre": axis, "radius": on_link, "name": on_link})
    draft.hint("discs", {"centre": pivot, "radius": own, "name": own, "body": PINION})
    draft.sentences.append(("gear_in_mesh", {"link": link.body, "on_link": on_link, "own": own}))
    draft.asked.append([f"omega_{PINION}", f"omega_{link.body}"])
