"""The dyads, each laid out on links that have their places: constructions, joints, what is said of them."""

from __future__ import annotations

import math
from collections.abc import Callable

from variantgen.synthesis.attachments import hinge_on, line_on
from variantgen.synthesis.directions import between, off_line, way
from variantgen.synthesis.draft import WHEEL, Attachment, Draft, LayoutError, Link
from variantgen.synthesis.dyad_parts import (
    FIXED,
    LEAST,
    ROCKERS,
    RODS,
    check_angle,
    facts_of,
    new_pivot,
    on_bar,
    slide,
)
from variantgen.synthesis.gears import gear, rack
from variantgen.synthesis.sliding_dyads import collar, two_guides, yoke
from variantgen.synthesis.structures import FRAME, AssurGroup

_SHORTEST = 14  # of two rods to a common pin, cm
_WELL = 0.96  # of two lengths of a four-bar linkage, at most, the two others together, so that a crank turns
_PIVOTS_TOLD = 0.35  # how often a four-bar linkage is given by its lengths


def place_dyad(draft: Draft, place: int, dyad: AssurGroup, uses: dict[int, str]) -> None:
    """Lay out a dyad. ``uses`` has the joints that later dyads make on each link. Raises LayoutError."""
    _PLACING[dyad.kind](draft, (2 * place + 2, 2 * place + 3), dyad, uses)


def _two_rods(draft: Draft, links: tuple[int, int], dyad: AssurGroup, _: dict[int, str]) -> None:
    """RRR: two rods, the second one turning about a fixed pin, or both on moving links."""
    first, second = links if dyad.on != FRAME else links[::-1]
    on, to = (dyad.on, dyad.to) if dyad.on != FRAME else (dyad.to, dyad.on)
    if to != FRAME:
        _bridge(draft, (first, second), (on, to))
        return
    at = hinge_on(draft, on, to)
    joint = draft.letter()
    rod = draft.length(at.point, joint, draft.rng.choice(RODS))
    if at.point == "A" and not draft.sentences and draft.rng.random() < _PIVOTS_TOLD:
        pivot = _pivots_in_line(draft, at, joint, rod)
    else:
        angle, fields, said = way(draft, at.point, joint, at.towards)
        draft.polar(joint, at.point, rod, angle, fields)
        pivot = draft.pivot()
        name = draft.link_about(pivot, joint)
        rocker = draft.length(pivot, joint, draft.rng.choice(ROCKERS), name=name)
        turned, back, said_back = way(draft, joint, pivot, at.point)
        draft.polar(pivot, joint, rocker, turned, back)
        draft.position += said + _turned_round(said_back, name)
    new_pivot(draft, pivot)
    check_angle(between(draft.direction(joint, pivot), draft.direction(joint, at.point)))
    draft.bar(first, _rod_at(at), at.point, joint)
    name = draft.bar(second, "link", pivot, joint, name=draft.link_about(pivot, joint)).body
    facts = {"rod": at.point + joint, "rocker": name, "pivot": pivot, "joint": joint}
    draft.sentences.append(("rod_and_rocker", facts | facts_of(at)))
    draft.asked.append([f"v_{joint}", f"omega_{name}", f"omega_{at.point}{joint}"])


def _pivots_in_line(draft: Draft, at: Attachment, joint: str, rod: str) -> str:
    """The four-bar linkage by its four lengths; the angle of the driving link is that with the line of the pivots."""
    axis = 90 if draft.upright else 0
    draft.z[joint] = draft.z["O"]  # its letter is taken
    draft.points[joint] = "coordinates", {}
    pivot = draft.pivot()
    frame = draft.length("O", pivot, draft.rng.choice(RODS))
    draft.polar(pivot, "O", frame, axis, {"angle": f"{axis}*deg"} if axis else {})
    rocker = draft.length(pivot, joint, draft.rng.choice(ROCKERS), name=draft.link_about(pivot, joint))
    _meet(draft, joint, (at.point, rod), (pivot, rocker), draft.rng.choice(("left", "right")))
    # Grashof's condition, on all draws where it holds well here: the driving link turns full circle.
    crank, others = draft.value("OA"), (frame, rod, rocker)
    whole = sum(map(draft.value, others))
    if all(crank + 2 * draft.value(name) < _WELL * whole for name in others):
        draft.require += [f"OA + 2 * {name} < {' + '.join(others)} - 1*cm" for name in others]
    draft.base = pivot
    draft.marks[0] = {**draft.marks[0], "from": pivot}
    draft.position.append(("pivots_upright" if axis else "pivots_level", {"one": "O", "other": pivot}))
    return pivot


def _meet(draft: Draft, joint: str, one: tuple[str, str], other: tuple[str, str], side: str) -> None:
    """A joint at printed distances from two points (each with the name of its distance), on a side of their line.

    Raises LayoutError where it does not exist.
    """
    (first, first_distance), (second, second_distance) = one, other
    start, step = draft.z[first], draft.z[second] - draft.z[first]
    span, a, b = abs(step), draft.value(first_distance), draft.value(second_distance)
    if not abs(a - b) < span < a + b:
        raise LayoutError("does not assemble")
    along = 0.5 * (span + (a * a - b * b) / span)
    across = math.sqrt(a * a - along * along) * (1 if side == "left" else -1)
    draft.z[joint] = start + (along + 1j * across) * step / span
    draft.points.pop(joint, None)  # after those that it is made from
    draft.points[joint] = "circle_circle", {
        "first": first, "first_distance": first_distance,
        "second": second, "second_distance": second_distance, "side": side,
    }  # fmt: skip


def _rod_at(at: Attachment) -> str:
    """What a rod to a slider, a wheel or a link about a fixed axis is called: a coupler on the driving link."""
    return "coupler" if at.point == "A" else "rod"


def _turned_round(said: list[tuple[str, dict[str, str]]], link: str) -> list[tuple[str, dict[str, str]]]:
    """The same of a link that is called from its other end."""
    return [(key, facts | {"link": link}) for key, facts in said]


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
    a, b = draft.length(one.point, joint, first), draft.length(other.point, joint, first / skew**2)
    if min(draft.value(a), draft.value(b)) < _SHORTEST:
        raise LayoutError("short rods")
    _meet(draft, joint, (one.point, a), (other.point, b), side)
    check_angle(between(draft.direction(joint, one.point), draft.direction(joint, other.point)))
    draft.bar(links[0], "rod", one.point, joint)
    draft.bar(links[1], "rod", other.point, joint)
    rods = {"rod": one.point + joint, "other": other.point + joint, "point": joint}
    draft.sentences.append(("two_rods", rods | facts_of(one) | facts_of(other, "_to")))
    draft.asked.append([f"v_{joint}", f"omega_{one.point}{joint}", f"omega_{other.point}{joint}"])


def _rod_and_slider(draft: Draft, links: tuple[int, int], dyad: AssurGroup, _: dict[int, str]) -> None:
    """RRP: a rod and the slider at its end, in a fixed guide or on a moving link."""
    if dyad.on == FRAME:
        _rocker_with_block(draft, links, dyad)
    elif dyad.to == FRAME:
        _fixed_guide(draft, links, dyad)
    else:
        _moving_guide(draft, links, dyad)


def _fixed_guide(draft: Draft, links: tuple[int, int], dyad: AssurGroup) -> None:
    at = hinge_on(draft, dyad.on, dyad.to)
    slider = draft.letter()
    rod = draft.length(at.point, slider, draft.rng.choice(RODS))
    guide = draft.rng.choice((0, 90))
    if at.point == "A" and draft.rng.random() < 0.4:
        _through_pivot(draft, at, slider, rod, guide)
        through = "O"
    else:
        angle, fields, said = way(draft, at.point, slider, at.towards, 0.25)
        draft.polar(slider, at.point, rod, angle, fields)
        draft.position += said
        through = ""
    if off_line(draft.direction(at.point, slider), guide) > 90 - LEAST:
        raise LayoutError("a dead point is near")
    draft.joint("guide", point=slider, **({"angle": guide} if guide else {}))
    draft.bar(links[0], _rod_at(at), at.point, slider)
    draft.links[links[1]] = Link(slider, noun="slider", guide=guide)
    key = "rod_and_slider_through" if through else "rod_and_slider"
    facts = {"rod": at.point + slider, "slider": slider, "way": FIXED[guide], "through": through}
    draft.sentences.append((key, facts | facts_of(at)))
    draft.asked.append([f"v_{slider}", f"omega_{at.point}{slider}"])


def _rod_and_wheel(draft: Draft, links: tuple[int, int], dyad: AssurGroup, _: dict[int, str]) -> None:
    """RRW: a rod and the wheel at its end, which rolls on a horizontal line."""
    at = hinge_on(draft, dyad.on, dyad.to)
    centre = draft.letter()
    rod = draft.length(at.point, centre, draft.rng.choice(RODS))
    angle, fields, said = way(draft, at.point, centre, at.towards, 0.25)
    draft.polar(centre, at.point, rod, angle, fields)
    draft.position += said
    if off_line(angle, 0) > 90 - LEAST:
        raise LayoutError("a dead point is near")
    if (draft.z[centre] - draft.z[at.point]).imag > 0:
        raise LayoutError("the rod comes from below the line")
    draft.radius("r", draft.rng.choice((16, 18, 20)))
    draft.polar("P", centre, "r", -90, {"angle": "-90*deg"})
    draft.joint("rolling", body=WHEEL, centre=centre, contact="P")
    draft.bodies[WHEEL] = [centre, "P"]
    draft.symbols[WHEEL] = "1"
    draft.wheel(centre, "r")
    draft.hint("hidden", "P")  # and its radius is given
    draft.hint("discs", {"centre": centre, "radius": "r", "name": "r", "body": WHEEL})
    draft.bar(links[0], _rod_at(at), at.point, centre)
    draft.links[links[1]] = Link(centre, noun="wheel")
    draft.sentences.append(("rod_and_wheel", {"rod": at.point + centre, "point": centre} | facts_of(at)))
    draft.asked.append([f"v_{centre}", f"omega_{WHEEL}", f"omega_{at.point}{centre}"])


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
    if branch > 0 and draft.upright == (guide == 90) and draft.value(rod) > 1.1 * draft.value("OA"):
        draft.base = slider  # which is ahead of O with every longer rod
        draft.marks[0] = {**draft.marks[0], "from": slider}
        draft.require.append(f"{rod} > OA")
    else:  # no side of an angle shows the line of motion
        draft.hint("axial", ["O", slider])


def _moving_guide(draft: Draft, links: tuple[int, int], dyad: AssurGroup) -> None:
    """A rod from one moving link to a block that slides on another one."""
    bar, at = line_on(draft, dyad.to), hinge_on(draft, dyad.on, dyad.to)
    block, start, end = draft.letter(), draft.z[bar.start], draft.z[bar.end]
    part = draft.rng.uniform(0.3, 0.75)
    goal = start + part * (end - start)
    rod = draft.length(at.point, block, abs(goal - draft.z[at.point]), 0.15)
    u = (end - start) / abs(end - start)
    foot = ((draft.z[at.point] - start) / u).real
    off = ((draft.z[at.point] - start) / u).imag
    square = draft.value(rod) ** 2 - off * off
    if draft.value(rod) < 20 or square <= 0:
        raise LayoutError("does not assemble")
    branch = 1 if part * abs(end - start) > foot else -1
    draft.z[block] = start + u * (foot + branch * math.sqrt(square))
    draft.points[block] = "line_circle", {
        "through": bar.start, "towards": bar.end, "centre": at.point, "distance": rod,
        "branch": "ahead" if branch > 0 else "behind",
    }  # fmt: skip
    if off_line(draft.direction(at.point, block), draft.direction(bar.start, bar.end)) > 90 - LEAST:
        raise LayoutError("a dead point is near")
    slide(draft, block, bar, "slide")
    draft.bar(links[0], "rod", at.point, block)
    draft.links[links[1]] = Link(block, noun="slide", line=(bar.start, bar.end))
    facts = {"rod": at.point + block, "slider": block, "noun": bar.noun, "bar": bar.body} | facts_of(at)
    draft.sentences.append(("rod_and_block", facts))
    draft.asked.append([f"v_rel_{block}", f"omega_{at.point}{block}", f"v_{block}"])


def _rocker_with_block(draft: Draft, links: tuple[int, int], dyad: AssurGroup) -> None:
    """A link turning about a fixed pin, with a block at its end that slides on a moving link."""
    bar, block = line_on(draft, dyad.to), draft.letter()
    draft.position += on_bar(draft, bar, block)
    pivot = draft.pivot()
    name = draft.link_about(pivot, block)
    rocker = draft.length(pivot, block, draft.rng.choice(ROCKERS), name=name)
    angle, fields, said = way(draft, block, pivot, draft.bodies[bar.body][0])
    draft.polar(pivot, block, rocker, angle, fields)
    new_pivot(draft, pivot)
    if off_line(angle, draft.direction(bar.start, bar.end)) > 90 - LEAST:
        raise LayoutError("a dead point is near")
    draft.position += _turned_round(said, name)
    slide(draft, block, bar, "slide")
    draft.bar(links[0], "link", pivot, block, name=name)
    draft.links[links[1]] = Link(block, noun="slide", line=(bar.start, bar.end))
    facts = {"rocker": name, "pivot": pivot, "slider": block, "noun": bar.noun, "bar": bar.body}
    draft.sentences.append(("rocker_with_block", facts))
    draft.asked.append([f"omega_{name}", f"v_rel_{block}", f"v_{block}"])


_PLACING: dict[str, Callable[[Draft, tuple[int, int], AssurGroup, dict[int, str]], None]] = {
    "RRR": _two_rods,
    "RRP": _rod_and_slider,
    "RRW": _rod_and_wheel,
    "WR": gear,
    "WP": rack,
    "RPR": collar,
    "PRP": two_guides,
    "RPP": yoke,
}
