"""What the dyads have in common when they are laid out: pivots, blocks on bars, the facts of an attachment."""

from __future__ import annotations

from variantgen.synthesis.draft import Attachment, Draft, LayoutError, Link

LEAST = 25  # degrees between two directions that determine a point
RODS = (36, 40, 44, 48, 50, 54, 60, 64, 70)
ROCKERS = (24, 28, 30, 32, 36, 40, 44, 50)
FIXED = {0: "level", 90: "upright"}


def check_angle(angle: float) -> None:
    """Raise LayoutError where two directions that determine a point are nearly one."""
    if not LEAST <= angle <= 180 - LEAST:
        raise LayoutError("a dead point is near")


def new_pivot(draft: Draft, name: str) -> None:
    """A fixed pivot at a point that has its place already."""
    draft.pivots.append(name)
    draft.joint("pivot", point=name)


def facts_of(at: Attachment, index: str = "") -> dict[str, str]:
    """The facts of an attachment for a sentence: its phrase, and the names of that."""
    return {f"at{index}": at.phrase} | {f"at{index}_{key}": value for key, value in at.facts.items()}


def slide(draft: Draft, block: str, bar: Link, noun: str) -> None:
    """A block (what it is called: ``noun``) between the ends of a bar."""
    draft.joint("slot", point=block, body=bar.body, along=[bar.start, bar.end])
    draft.inside.append((block, bar.start, bar.end))
    draft.relative.append(
        ("groove" if bar.noun == "groove" else "bar", {"point": block, "bar": bar.body, "block": noun})
    )


def on_bar(draft: Draft, bar: Link, point: str) -> list[tuple[str, dict[str, str]]]:
    """A block somewhere on a bar: in its middle, or at a printed distance from its start (in a groove, its slider)."""
    if bar.noun == "groove":
        slider = draft.bodies[bar.body][0]
        distance = draft.length(slider, point, draft.rng.choice((16, 18, 20)), 0.12)
        draft.polar(point, slider, distance, draft.direction(bar.start, bar.end), {"towards": bar.end})
        return [("instant_length", {"length": distance})]
    if draft.rng.random() < 0.5:
        draft.points[point] = "fraction", {"start": bar.start, "end": bar.end}
        draft.z[point] = 0.5 * (draft.z[bar.start] + draft.z[bar.end])
        return [("halfway", {"point": point, "bar": bar.body})]
    part = draft.rng.choice((0.4, 0.5, 0.6)) * draft.distance(bar.start, bar.end)
    distance = draft.length(bar.start, point, part, 0.12)
    draft.keep_between(distance, bar.start + bar.end)
    angle = draft.direction(bar.start, bar.end)
    draft.polar(point, bar.start, distance, angle, {"towards": bar.end})
    return [("instant_length", {"length": distance})]
