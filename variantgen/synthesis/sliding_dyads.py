"""The dyads with a sliding pair between or beside their two links: collars and slotted arms, pins in guides, yokes."""

from __future__ import annotations

from variantgen.synthesis.attachments import hinge_on, line_on
from variantgen.synthesis.directions import between, way
from variantgen.synthesis.draft import LETTERS, Draft, LayoutError, Link
from variantgen.synthesis.dyad_parts import FIXED, ROCKERS, RODS, check_angle, facts_of, new_pivot, on_bar, slide
from variantgen.synthesis.structures import FRAME, AssurGroup


def collar(draft: Draft, links: tuple[int, int], dyad: AssurGroup, uses: dict[int, str]) -> None:
    """RPR: a bar hinged to one link passes through a collar on the other, or carries a block in its slot."""
    ends = {links[0]: dyad.on, links[1]: dyad.to}
    bars = [link for link in links if uses[link]] or [draft.rng.choice(links)]
    bar, sleeve = bars[0], next(link for link in links if link != bars[0])
    if ends[bar] == FRAME:
        _slotted_arm(draft, bar, sleeve, ends[sleeve])
        return
    at = hinge_on(draft, ends[bar], ends[sleeve])
    if ends[sleeve] == FRAME:
        pivot = draft.pivot()
        distance = draft.length(at.point, pivot, draft.rng.choice(ROCKERS), 0.2)
        angle, fields, said = way(draft, at.point, pivot, at.towards)
        draft.polar(pivot, at.point, distance, angle, fields)
        new_pivot(draft, pivot)
        draft.position += [*said, ("instant_length", {"length": distance})]
        end = _far_end(draft, at.point, pivot, uses[bar])
        collared, key = pivot, "rod_through_fixed_collar"
        draft.position = [
            (k, f | ({"link": at.point + end} if f.get("link") == at.point + pivot else {})) for k, f in draft.position
        ]
        facts = {"rod": at.point + end, "pivot": pivot} | facts_of(at)
    else:
        to = hinge_on(draft, ends[sleeve], ends[bar])
        if draft.distance(at.point, to.point) < 20:
            raise LayoutError("hinges too near")
        end = _far_end(draft, at.point, to.point, uses[bar])
        collared, key = to.point, "rod_through_collar"
        facts = {"rod": at.point + end} | facts_of(at) | facts_of(to, "_to")
    made = draft.bar(bar, "rod", at.point, end, (end,))
    slide(draft, collared, made, "collar")
    draft.links[sleeve] = Link(collared, noun="collar", arm_only=True, line=(made.start, made.end))
    draft.sentences.append((key, facts))
    draft.asked.append([f"omega_{at.point}{end}", f"v_rel_{collared}"])


def _far_end(draft: Draft, start: str, through: str, used: str) -> str:
    """The end of a bar beyond the point through which it passes, at a printed distance where it is used."""
    end = draft.letter()
    if draft.lies_along_axis(start, through):
        draft.along_axes.add(frozenset((start, end)))
    size = draft.distance(start, through) * draft.rng.choice((1.35, 1.5, 1.6))
    angle = draft.direction(start, through)
    if "R" in used:
        whole = draft.length(start, end, size, 0.12)
        draft.polar(end, start, whole, angle, {"towards": through})
        for part in (start + through, through + start):
            draft.keep_between(part, whole)
        return end
    draft.place(end, start, size, angle)
    draft.points[end] = (
        "fraction",
        {"start": start, "end": through, "part": f"{size / draft.distance(start, through):.2f}"},
    )
    return end


def _slotted_arm(draft: Draft, arm: int, block: int, on: int) -> None:
    """An arm about a fixed pin with a slot for a block that is hinged to a moving link."""
    at = hinge_on(draft, on, FRAME)
    pivot, z = draft.pivot(), draft.z[at.point]
    base = draft.rng.choice(("O", ""))
    if at.point == "A" and base:
        axis = draft.rng.choice((0, 90, 180, 270))
        distance = draft.length("O", pivot, draft.rng.choice(RODS))
        draft.polar(pivot, "O", distance, axis, {"angle": f"{axis}*deg"} if axis else {})
        draft.position.append(("pivots_level" if axis % 180 == 0 else "pivots_upright", {"one": "O", "other": pivot}))
        if draft.upright == (axis % 180 == 90):
            draft.base = pivot if axis < 180 else f"-{pivot}"
            if axis < 180:
                draft.marks[0] = {**draft.marks[0], "from": pivot}
    else:
        distance = draft.length(at.point, pivot, draft.rng.choice(ROCKERS), 0.2)
        angle, fields, said = way(draft, at.point, pivot, at.towards)
        draft.polar(pivot, at.point, distance, angle, fields)
        draft.position += [*said, ("instant_length", {"length": distance})]
    if abs(z - draft.z[pivot]) < 20:
        raise LayoutError("hinges too near")
    new_pivot(draft, pivot)
    end = _far_end(draft, pivot, at.point, "R")
    draft.position = [
        (k, f | ({"link": pivot + end} if f.get("link") == at.point + pivot else {})) for k, f in draft.position
    ]
    made = draft.bar(arm, "arm", pivot, end, (end,))
    draft.hint("slotted", made.body)
    slide(draft, at.point, made, "block")
    draft.links[block] = Link(at.point, noun="block", arm_only=True, line=(made.start, made.end))
    draft.sentences.append(("slotted_arm", {"arm": made.body, "pivot": pivot} | facts_of(at)))
    draft.asked.append([f"omega_{made.body}", f"v_rel_{at.point}"])


def two_guides(draft: Draft, links: tuple[int, int], dyad: AssurGroup, _: dict[int, str]) -> None:
    """PRP: a pin in a fixed guide and on a moving link."""
    moving = dyad.to if dyad.on == FRAME else dyad.on
    if FRAME not in (dyad.on, dyad.to):
        raise LayoutError("both guides move")
    bar, block, guide = line_on(draft, moving), draft.letter(), draft.rng.choice((0, 90))
    draft.position += on_bar(draft, bar, block)
    check_angle(between(guide, draft.direction(bar.start, bar.end)))
    draft.joint("guide", point=block, **({"angle": guide} if guide else {}))
    slide(draft, block, bar, "pin")
    fixed, riding = links if dyad.on == FRAME else links[::-1]
    draft.links[fixed] = Link(block, noun="pin", guide=guide)
    draft.links[riding] = Link(block, noun="pin", line=(bar.start, bar.end))
    facts = {"slider": block, "noun": bar.noun, "bar": bar.body, "way": FIXED[guide]}
    draft.sentences.append(("pin_in_two_guides", facts))
    draft.asked.append([f"v_{block}", f"v_rel_{block}"])


def yoke(draft: Draft, links: tuple[int, int], dyad: AssurGroup, uses: dict[int, str]) -> None:
    """RPP: a block on a moving link in the slot of a yoke that moves along a fixed guide.

    Where a way leads on from the yoke to another moving link, angles depend on where the end of the yoke is: then the
    foot of the slot has a letter, and lengths say it.
    """
    if dyad.to != FRAME or dyad.on == FRAME:
        raise LayoutError("the yoke slides on a moving link")
    at = hinge_on(draft, dyad.on, dyad.to)
    guide, out = draft.rng.choice((0, 90)), draft.rng.choice((0, 180))
    end, size = draft.letter(), 30
    foot, top, low, stem = (f"{letter}{end}" for letter in ("H", "K", "L", "S"))
    up, ahead = guide + 90 * draft.rng.choice((1, -1)), guide + out
    if "M" in uses[links[1]]:
        foot = next(letter for letter in LETTERS if letter not in (*draft.points, end))
        for start, point, value, angle in ((at.point, foot, 16, up), (foot, end, 56, ahead)):
            draft.polar(point, start, draft.length(start, point, value, 0.12), angle, {"angle": f"{angle % 360}*deg"})
        draft.position.append(("instant_length", {"length": at.point + foot}))
    else:
        draft.place(foot, at.point, 16, up)
        draft.place(end, foot, 56, ahead)
        draft.hint("hidden", foot)
    draft.place(top, foot, size, guide + 90)
    draft.place(low, foot, size, guide - 90)
    draft.place(stem, foot, 36, ahead)
    body = f"yoke{end}"
    draft.bodies[body] = [foot, end, stem, top, low]
    draft.symbols[body] = ""
    draft.nouns[body] = "yoke"
    for point in (stem, top, low):
        draft.hint("hidden", point)
    draft.hint("stems", stem)
    draft.hint("grooves", [top, low])
    draft.joint("translation", body=body)
    draft.joint("guide", point=stem, **({"angle": guide} if guide else {}))
    draft.joint("slot", point=at.point, body=body, along=[top, low])
    draft.bars += [(foot, end), (low, top)]
    draft.inside.append((at.point, low, top))
    draft.relative.append(("yoke", {"point": at.point, "block": "block"}))
    draft.links[links[0]] = Link(at.point, noun="block", guide=guide, arm_only=True)
    draft.links[links[1]] = Link(end, noun="yoke", guide=guide, body=body)
    said = end if foot in draft.hints["hidden"] else foot + end
    facts = {"point": said, "way": FIXED[guide], "across": FIXED[90 - guide]}
    draft.sentences.append(("yoke", facts | facts_of(at)))
    draft.asked.append([f"v_{end}", f"v_rel_{at.point}"])
