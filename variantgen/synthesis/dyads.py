"""The dyads, each laid out on links that have their places: constructions, joints, what is said of them."""

from __future__ import annotations

import math
from collections.abc import Callable

from variantgen.synthesis.attachments import hinge_on, line_on
from variantgen.synthesis.directions import between, off_line, way
from variantgen.synthesis.draft import Attachment, Draft, LayoutError, Link
from variantgen.synthesis.structures import FRAME, Dyad

_LEAST = 25  # degrees between two directions that determine a point
_RODS = (36, 40, 44, 48, 50, 54, 60, 64, 70)
_ROCKERS = (24, 28, 30, 32, 36, 40, 44, 50)
_FIXED = {0: "level", 90: "upright"}


def place_dyad(draft: Draft, place: int, dyad: Dyad, uses: dict[int, str]) -> None:
    """Lay out a dyad. ``uses`` has the joints that later dyads make on each link. Raises LayoutError."""
    _PLACING[dyad.kind](draft, (2 * place + 2, 2 * place + 3), dyad, uses)


def _check(angle: float) -> None:
    if not _LEAST <= angle <= 180 - _LEAST:
        raise LayoutError("a dead point is near")


def _pivot(draft: Draft) -> str:
    name = draft.pivot()
    draft.pivots.append(name)
    draft.joint("pivot", point=name)
    return name


def _two_rods(draft: Draft, links: tuple[int, int], dyad: Dyad, _: dict[int, str]) -> None:
    """RRR: two rods, the second one turning about a fixed pin, or both on moving links."""
    first, second = links if dyad.on != FRAME else links[::-1]
    on, to = (dyad.on, dyad.to) if dyad.on != FRAME else (dyad.to, dyad.on)
    if to != FRAME:
        _bridge(draft, (first, second), (on, to))
        return
    at = hinge_on(draft, on, to)
    joint = draft.letter()
    rod = draft.length(at.point, joint, draft.rng.choice(_RODS))
    angle, fields, said = way(draft, at.point, joint, at.towards)
    draft.polar(joint, at.point, rod, angle, fields)
    pivot = draft.pivot()
    rocker = draft.length(pivot, joint, draft.rng.choice(_ROCKERS))
    turned, back, told = way(draft, joint, pivot, at.point)
    draft.polar(pivot, joint, rocker, turned, back)
    _pivot(draft)
    _check(between(turned, angle))
    draft.bar(first, "rod", at.point, joint)
    draft.bar(second, "link", pivot, joint)
    draft.position += said + _turned_round(told, pivot + joint)
    draft.sentences.append(
        ("rod_and_rocker", {"rod": at.point + joint, "rocker": pivot + joint, "pivot": pivot} | _at(at))
    )
    draft.asked.append([f"v_{joint}", f"omega_{pivot}{joint}", f"omega_{at.point}{joint}"])


def _turned_round(said: list[tuple[str, dict[str, str]]], link: str) -> list[tuple[str, dict[str, str]]]:
    """The same of a link that is called from its other end."""
    return [(key, facts | {"link": link}) for key, facts in said]


def _at(at: Attachment, index: str = "") -> dict[str, str]:
    """The facts of an attachment for a sentence: its phrase, and the names of that."""
    return {f"at{index}": at.phrase} | {f"at{index}_{key}": value for key, value in at.facts.items()}


def _bridge(draft: Draft, links: tuple[int, int], ends: tuple[int, int]) -> None:
    """Two rods from two moving links to a common pin."""
    one, other = hinge_on(draft, ends[0], ends[1]), hinge_on(draft, ends[1], ends[0])
    joint = draft.letter()
    span = draft.distance(one.point, other.point)
    if span < 16:
        raise LayoutError("hinges too near")
    angle = math.radians(draft.rng.uniform(50, 110))
    skew = draft.rng.uniform(0.8, 1.25)
    first, side = 0.5 * span / math.sin(0.5 * angle) * skew, draft.rng.choice(("left", "right"))
    a = draft.value(draft.length(one.point, joint, first))
    b = draft.value(draft.length(other.point, joint, first / skew**2))
    start, step = draft.z[one.point], draft.z[other.point] - draft.z[one.point]
    if not abs(a - b) < span < a + b:
        raise LayoutError("does not assemble")
    along = 0.5 * (span + (a * a - b * b) / span)
    across = math.sqrt(a * a - along * along) * (1 if side == "left" else -1)
    draft.z[joint] = start + (along + 1j * across) * step / span
    draft.points[joint] = "circle_circle", {
        "first": one.point, "first_distance": one.point + joint,
        "second": other.point, "second_distance": other.point + joint, "side": side,
    }  # fmt: skip
    _check(between(draft.direction(joint, one.point), draft.direction(joint, other.point)))
    draft.bar(links[0], "rod", one.point, joint)
    draft.bar(links[1], "rod", other.point, joint)
    rods = {"rod": one.point + joint, "other": other.point + joint, "point": joint}
    draft.sentences.append(("two_rods", rods | _at(one) | _at(other, "_to")))
    draft.asked.append([f"v_{joint}", f"omega_{one.point}{joint}", f"omega_{other.point}{joint}"])


def _rod_and_slider(draft: Draft, links: tuple[int, int], dyad: Dyad, _: dict[int, str]) -> None:
    """RRP: a rod and the slider at its end, in a fixed guide or on a moving link."""
    if dyad.on == FRAME:
        _rocker_with_block(draft, links, dyad)
    elif dyad.to == FRAME:
        _fixed_guide(draft, links, dyad)
    else:
        _moving_guide(draft, links, dyad)


def _fixed_guide(draft: Draft, links: tuple[int, int], dyad: Dyad) -> None:
    at = hinge_on(draft, dyad.on, dyad.to)
    slider = draft.letter()
    rod = draft.length(at.point, slider, draft.rng.choice(_RODS))
    guide = draft.rng.choice((0, 90))
    if at.point == "A" and draft.rng.random() < 0.4:
        _through_pivot(draft, at, slider, rod, guide)
        through = "O"
    else:
        angle, fields, said = way(draft, at.point, slider, at.towards, 0.25)
        draft.polar(slider, at.point, rod, angle, fields)
        draft.position += said
        through = ""
    if off_line(draft.direction(at.point, slider), guide) > 90 - _LEAST:
        raise LayoutError("a dead point is near")
    draft.joint("guide", point=slider, **({"angle": guide} if guide else {}))
    draft.bar(links[0], "rod", at.point, slider)
    draft.links[links[1]] = Link(slider, guide=guide, mates={links[0]})
    key = "rod_and_slider_through" if through else "rod_and_slider"
    facts = {"rod": at.point + slider, "slider": slider, "way": _FIXED[guide], "through": through}
    draft.sentences.append((key, facts | _at(at)))
    draft.asked.append([f"v_{slider}", f"omega_{at.point}{slider}"])


def _through_pivot(draft: Draft, at: Attachment, slider: str, rod: str, guide: int) -> None:
    """A slider whose line of motion passes through the axis of the crank."""
    u = 1j if guide else 1
    z, branch = draft.z[at.point] - draft.z["O"], draft.rng.choice((1, -1))
    along, off = (z / u).real, (z / u).imag
    if abs(off) > 0.8 * draft.value(rod) or abs(off) < 8:
        raise LayoutError("does not assemble")
    draft.z[slider] = draft.z["O"] + u * (along + branch * math.sqrt(draft.value(rod) ** 2 - off * off))
    fields = {"through": "O", "centre": at.point, "distance": rod, "branch": "ahead" if branch > 0 else "behind"}
    draft.points[slider] = "line_circle", fields | ({"angle": f"{guide}*deg"} if guide else {})


def _moving_guide(draft: Draft, links: tuple[int, int], dyad: Dyad) -> None:
    """A rod from one moving link to a block that slides on another one."""
    bar, at = line_on(draft, dyad.to), hinge_on(draft, dyad.on, dyad.to)
    block, start, end = draft.letter(), draft.z[bar.start], draft.z[bar.end]
    part = draft.rng.uniform(0.3, 0.75)
    goal = start + part * (end - start)
    rod = draft.length(at.point, block, abs(goal - draft.z[at.point]), 0.15)
    u = (end - start) / abs(end - start)
    foot = ((draft.z[at.point] - start) / u).real
    off = ((draft.z[at.point] - start) / u).imag
    reach = draft.value(rod) ** 2 - off * off
    if draft.value(rod) < 20 or reach <= 0:
        raise LayoutError("does not assemble")
    branch = 1 if part * abs(end - start) > foot else -1
    draft.z[block] = start + u * (foot + branch * math.sqrt(reach))
    draft.points[block] = "line_circle", {
        "through": bar.start, "towards": bar.end, "centre": at.point, "distance": rod,
        "branch": "ahead" if branch > 0 else "behind",
    }  # fmt: skip
    if off_line(draft.direction(at.point, block), draft.direction(bar.start, bar.end)) > 90 - _LEAST:
        raise LayoutError("a dead point is near")
    _slide(draft, block, bar)
    draft.bar(links[0], "rod", at.point, block)
    draft.links[links[1]] = Link(block, mates={links[0]}, line=(bar.start, bar.end))
    facts = {"rod": at.point + block, "slider": block, "noun": bar.noun, "bar": bar.body} | _at(at)
    draft.sentences.append(("rod_and_block", facts))
    draft.asked.append([f"v_rel_{block}", f"omega_{at.point}{block}", f"v_{block}"])


def _slide(draft: Draft, block: str, bar: Link) -> None:
    """A block between the ends of a bar."""
    draft.joint("slot", point=block, body=bar.body, along=[bar.start, bar.end])
    draft.inside.append((block, bar.start, bar.end))
    draft.slides.append(block)


def _on_bar(draft: Draft, bar: Link, point: str) -> list[tuple[str, dict[str, str]]]:
    """A block somewhere on a bar: in its middle, or at a printed distance from its start (in a groove, its slider)."""
    if bar.noun == "groove":
        slider = draft.bodies[bar.body][0]
        distance = draft.length(slider, point, draft.rng.choice((16, 18, 20)), 0.12)
        draft.polar(point, slider, distance, draft.direction(bar.start, bar.end), {"towards": bar.end})
        return []
    if draft.rng.random() < 0.5:
        draft.points[point] = "fraction", {"start": bar.start, "end": bar.end}
        draft.z[point] = 0.5 * (draft.z[bar.start] + draft.z[bar.end])
        return [("halfway", {"point": point, "bar": bar.body})]
    part = draft.rng.choice((0.4, 0.6, 0.7)) * draft.distance(bar.start, bar.end)
    distance = draft.length(bar.start, point, part, 0.12)
    angle = draft.direction(bar.start, bar.end)
    draft.polar(point, bar.start, distance, angle, {"towards": bar.end})
    return [("instant_length", {"length": distance})]


def _rocker_with_block(draft: Draft, links: tuple[int, int], dyad: Dyad) -> None:
    """A link turning about a fixed pin, with a block at its end that slides on a moving link."""
    bar, block = line_on(draft, dyad.to), draft.letter()
    draft.position += _on_bar(draft, bar, block)
    pivot = draft.pivot()
    rocker = draft.length(pivot, block, draft.rng.choice(_ROCKERS))
    angle, fields, said = way(draft, block, pivot, draft.bodies[bar.body][0])
    draft.polar(pivot, block, rocker, angle, fields)
    _pivot(draft)
    if off_line(angle, draft.direction(bar.start, bar.end)) > 90 - _LEAST:
        raise LayoutError("a dead point is near")
    draft.position += _turned_round(said, pivot + block)
    _slide(draft, block, bar)
    draft.bar(links[0], "link", pivot, block)
    draft.links[links[1]] = Link(block, mates={links[0]}, line=(bar.start, bar.end))
    facts = {"rocker": pivot + block, "pivot": pivot, "slider": block, "noun": bar.noun, "bar": bar.body}
    draft.sentences.append(("rocker_with_block", facts))
    draft.asked.append([f"omega_{pivot}{block}", f"v_rel_{block}", f"v_{block}"])


def _collar(draft: Draft, links: tuple[int, int], dyad: Dyad, uses: dict[int, str]) -> None:
    """RPR: a bar hinged to one link passes through a collar on the other, or carries a block in its slot."""
    ends = {links[0]: dyad.on, links[1]: dyad.to}
    bars = [link for link in links if uses[link]] or [draft.rng.choice(links)]
    bar, collar = bars[0], next(link for link in links if link != bars[0])
    if ends[bar] == FRAME:
        _slotted_arm(draft, bar, collar, ends[collar])
        return
    at = hinge_on(draft, ends[bar], ends[collar])
    if ends[collar] == FRAME:
        pivot = draft.pivot()
        distance = draft.length(at.point, pivot, draft.rng.choice(_ROCKERS), 0.2)
        angle, fields, said = way(draft, at.point, pivot, at.towards)
        draft.polar(pivot, at.point, distance, angle, fields)
        _pivot(draft)
        draft.position += [*said, ("instant_length", {"length": distance})]
        end = _far_end(draft, at.point, pivot, uses[bar])
        collared, key = pivot, "rod_through_fixed_collar"
        draft.position = [
            (k, f | ({"link": at.point + end} if f.get("link") == at.point + pivot else {})) for k, f in draft.position
        ]
        facts = {"rod": at.point + end, "pivot": pivot} | _at(at)
    else:
        to = hinge_on(draft, ends[collar], ends[bar])
        if draft.distance(at.point, to.point) < 20:
            raise LayoutError("hinges too near")
        end = _far_end(draft, at.point, to.point, uses[bar])
        collared, key = to.point, "rod_through_collar"
        facts = {"rod": at.point + end} | _at(at) | _at(to, "_to")
    made = draft.bar(bar, "rod", at.point, end, (end,))
    _slide(draft, collared, made)
    draft.links[collar] = Link(collared, arm_only=True, line=(made.start, made.end), mates={ends[collar]})
    draft.sentences.append((key, facts))
    draft.asked.append([f"omega_{at.point}{end}", f"v_rel_{collared}"])


def _far_end(draft: Draft, start: str, through: str, used: str) -> str:
    """The end of a bar beyond the point through which it passes, at a printed distance where it is used."""
    end = draft.letter()
    size = draft.distance(start, through) * draft.rng.choice((1.35, 1.5, 1.6))
    angle = draft.direction(start, through)
    if "R" in used:
        draft.polar(end, start, draft.length(start, end, size, 0.12), angle, {"towards": through})
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
        distance = draft.length("O", pivot, draft.rng.choice(_RODS))
        draft.polar(pivot, "O", distance, axis, {"angle": f"{axis}*deg"} if axis else {})
        draft.position.append(("pivots_level" if axis % 180 == 0 else "pivots_upright", {"one": "O", "other": pivot}))
    else:
        distance = draft.length(at.point, pivot, draft.rng.choice(_ROCKERS), 0.2)
        angle, fields, said = way(draft, at.point, pivot, at.towards)
        draft.polar(pivot, at.point, distance, angle, fields)
        draft.position += [*said, ("instant_length", {"length": distance})]
    if abs(z - draft.z[pivot]) < 20:
        raise LayoutError("hinges too near")
    _pivot(draft)
    end = _far_end(draft, pivot, at.point, "R")
    draft.position = [
        (k, f | ({"link": pivot + end} if f.get("link") == at.point + pivot else {})) for k, f in draft.position
    ]
    made = draft.bar(arm, "link", pivot, end, (end,))
    draft.hint("slotted", made.body)
    _slide(draft, at.point, made)
    draft.links[block] = Link(at.point, arm_only=True, line=(made.start, made.end), mates={on})
    draft.sentences.append(("slotted_arm", {"arm": made.body, "pivot": pivot} | _at(at)))
    draft.asked.append([f"omega_{made.body}", f"v_rel_{at.point}"])


def _two_guides(draft: Draft, links: tuple[int, int], dyad: Dyad, _: dict[int, str]) -> None:
    """PRP: a pin in a fixed guide and on a moving link."""
    moving = dyad.to if dyad.on == FRAME else dyad.on
    if FRAME not in (dyad.on, dyad.to):
        raise LayoutError("both guides move")
    bar, block, guide = line_on(draft, moving), draft.letter(), draft.rng.choice((0, 90))
    draft.position += _on_bar(draft, bar, block)
    _check(between(guide, draft.direction(bar.start, bar.end)))
    draft.joint("guide", point=block, **({"angle": guide} if guide else {}))
    _slide(draft, block, bar)
    fixed, riding = links if dyad.on == FRAME else links[::-1]
    draft.links[fixed] = Link(block, guide=guide, mates={riding})
    draft.links[riding] = Link(block, line=(bar.start, bar.end), mates={fixed})
    facts = {"slider": block, "noun": bar.noun, "bar": bar.body, "way": _FIXED[guide]}
    draft.sentences.append(("pin_in_two_guides", facts))
    draft.asked.append([f"v_{block}", f"v_rel_{block}"])


def _yoke(draft: Draft, links: tuple[int, int], dyad: Dyad, _: dict[int, str]) -> None:
    """RPP: a block on a moving link in the slot of a yoke that moves along a fixed guide."""
    if dyad.to != FRAME or dyad.on == FRAME:
        raise LayoutError("the yoke slides on a moving link")
    at = hinge_on(draft, dyad.on, dyad.to)
    guide, out = draft.rng.choice((0, 90)), draft.rng.choice((0, 180))
    end, size = draft.letter(), 30
    foot, top, low, stem = (f"{letter}{end}" for letter in ("H", "K", "L", "S"))
    turn = draft.rng.choice((1, -1))
    draft.place(foot, at.point, 16, guide + 90 * turn)
    draft.place(top, foot, size, guide + 90)
    draft.place(low, foot, size, guide - 90)
    draft.place(end, foot, 56, guide + out)
    draft.place(stem, foot, 36, guide + out)
    body = f"yoke{end}"
    draft.bodies[body] = [foot, end, stem, top, low]
    draft.symbols[body] = ""
    draft.nouns[body] = "yoke"
    for point in (foot, stem, top, low):
        draft.hint("hidden", point)
    draft.hint("stems", stem)
    draft.hint("grooves", [top, low])
    draft.joint("translation", body=body)
    draft.joint("guide", point=stem, **({"angle": guide} if guide else {}))
    draft.joint("slot", point=at.point, body=body, along=[top, low])
    draft.bars.append((foot, end))
    draft.slides.append(at.point)
    draft.links[links[0]] = Link(at.point, guide=guide, arm_only=True, mates={dyad.on})
    draft.links[links[1]] = Link(end, guide=guide, body=body)
    draft.sentences.append(("yoke", {"point": end, "way": _FIXED[guide]} | _at(at)))
    draft.asked.append([f"v_{end}", f"v_rel_{at.point}"])


_PLACING: dict[str, Callable[[Draft, tuple[int, int], Dyad, dict[int, str]], None]] = {
    "RRR": _two_rods,
    "RRP": _rod_and_slider,
    "RPR": _collar,
    "PRP": _two_guides,
    "RPP": _yoke,
}
