"""Gears and racks at the end of a mechanism, driven by a link about a fixed axis or by a slider."""

from __future__ import annotations

from variantgen.families.family import TOOTHED_RACK
from variantgen.synthesis.directions import between
from variantgen.synthesis.draft import PINION, Draft, LayoutError, Link, Wheel
from variantgen.synthesis.dyad_parts import FIXED, new_pivot
from variantgen.synthesis.structures import FRAME, AssurGroup

SENTENCES = ("gear_in_mesh", "gear_on_pin", "gear_on_extension", "gear_on_rack", "rack_on_gear", "rim_point")
_RADII = (14, 16, 18, 20, 22, 24, 26)  # cm
_ROOM = 0.62  # of a link, from its axis, that a gear on it may take
_APART = (0.6, 1.7)  # of the radii, one over the other; but they differ by a fifth at least
_SPREAD = 4  # of the radius of a gear that is printed alone, cm
_OFF = 60  # degrees between a rocker that carries a gear on its pin and the rod there, which keeps off the fixed gear
_ON_PIN, _OF_LINK = 0.6, (0.32, 0.6)  # how often a gear is on the pin of a rocker; its radius over that
_WITH_RIM = 0.7  # how often a point of the rim is asked for
_PAST = (24, 28, 32)  # from the pitch point to the ends of a rack, cm


def gear(draft: Draft, links: tuple[int, int], dyad: AssurGroup, _: dict[int, str]) -> None:
    """WR: a gear driven by the gear on a link or by the rack on a slider, or one that rolls on a fixed gear."""
    if dyad.on == FRAME:
        _on_moving_axle(draft, draft.links[dyad.to])
    elif draft.links[dyad.on].noun == "slider":
        _driven_by_rack(draft, draft.links[dyad.on])
    else:
        _gear_in_mesh(draft, draft.links[dyad.on])


def _axis_of(draft: Draft, link: Link) -> str:
    """The fixed axis of a link. Raises LayoutError where it has none."""
    axis = next((name for name in draft.bodies.get(link.body, ()) if name in draft.pivots), None)
    if axis is None:
        raise LayoutError("the link does not turn about a fixed axis")
    return axis


def _pinion(draft: Draft, centre: str, radius: str) -> None:
    """The body of the gear that ends the mechanism."""
    draft.bodies[PINION] = [centre]
    draft.symbols[PINION] = "1"
    draft.hint("discs", {"centre": centre, "radius": radius, "name": radius, "body": PINION})


def _gear_on(draft: Draft, link: Link, axis: str, radius: str) -> None:
    """A gear that is fixed to a link. Raises LayoutError where it reaches too far along the link."""
    nearest = min(draft.distance(axis, name) for name in draft.bodies[link.body] if name != axis)
    if draft.value(radius) > _ROOM * nearest:
        raise LayoutError("the gear covers its link")
    draft.hint("discs", {"centre": axis, "radius": radius, "name": radius})


def _two_radii(draft: Draft) -> tuple[str, str]:
    """The names R and r of two printed radii, the first gear's and the second one's, in any order of size."""
    first, second = draft.rng.choice(_RADII), draft.rng.choice(_RADII)
    ratio = first / second
    if not _APART[0] <= ratio <= _APART[1] or 0.8 < ratio < 1.25:
        raise LayoutError("gears that do not go together")
    draft.radius("R", max(first, second))
    draft.radius("r", min(first, second))
    return ("R", "r") if first > second else ("r", "R")


def _gear_in_mesh(draft: Draft, link: Link) -> None:
    """The gear on a link about a fixed axis drives another one."""
    axis = _axis_of(draft, link)
    on_link, own = _two_radii(draft)
    _gear_on(draft, link, axis, on_link)
    angle, pivot = draft.rng.choice((0, 90, 180, 270)), draft.pivot()
    draft.place(pivot, axis, draft.value(on_link) + draft.value(own), angle)
    way = {"angle": f"{angle}*deg"} if angle else {}
    draft.points[pivot] = "polar", {"origin": axis, "distance": "R + r", **way}
    new_pivot(draft, pivot)
    draft.wheel(axis, on_link)
    draft.wheel(pivot, own)
    fields = {"body": PINION, "centre": pivot, "radius": own, "other_centre": axis, "other": link.body}
    draft.joint("gears", **fields)
    _pinion(draft, pivot, own)
    facts = {"bar": link.body, "noun": link.noun, "on_link": on_link, "own": own, "axle": pivot}
    draft.sentences.append(("gear_in_mesh", facts))
    draft.asked.append([f"omega_{PINION}", f"omega_{link.body}"])


def _on_moving_axle(draft: Draft, arm: Link) -> None:
    """A link about a fixed axis carries the axle of a gear round a fixed one: on the pin of a rocker, or beyond."""
    axis, far = _axis_of(draft, arm), arm.end
    facts = {"bar": arm.body, "noun": arm.noun, "axis": axis}
    if arm.noun == "link" and not arm.extra and f"{axis}{far}" in draft.data and draft.rng.random() < _ON_PIN:
        whole, own, centre, key = draft.data[axis + far], "r", far, "gear_on_pin"
        draft.radius(own, 2 * round(draft.rng.uniform(*_OF_LINK) * whole.value / 2), _SPREAD)
        for bar in draft.bars:
            other = next((name for name in bar if name != far), axis)
            if far in bar and other != axis and between(draft.direction(far, other), draft.direction(far, axis)) < _OFF:
                raise LayoutError("a rod lies across the fixed gear")
        fixed = whole.value - draft.value(own)
        draft.wheels.append(Wheel(axis, fixed, fixed + whole.spread + _SPREAD, (far,)))
        draft.require += [f"r > 0.3 * {axis}{far}", f"r < 0.62 * {axis}{far}"]
    else:
        other, own = _two_radii(draft)
        centre, key = draft.letter(), "gear_on_extension"
        draft.place(centre, axis, draft.value(other) + draft.value(own), draft.direction(far, axis))
        draft.points[centre] = "polar", {"origin": axis, "distance": "R + r", "towards": far, "angle": "180*deg"}
        draft.bodies[arm.body].append(centre)
        draft.bars.append((axis, centre))
        draft.hint("lines", [axis, centre])
        draft.hint("discs", {"centre": axis, "radius": other, "name": other})
        draft.wheel(axis, other)
        facts |= {"on_link": other}
    _pinion(draft, centre, own)
    draft.joint("gears", body=PINION, centre=centre, radius=own, other_centre=axis)
    draft.sentences.append((key, {**facts, "point": centre, "own": own}))
    draft.asked.append([f"omega_{PINION}", f"v_{centre}", f"omega_{arm.body}"])
    _rim_point(draft, axis, centre, own)


def _rim_point(draft: Draft, axis: str, centre: str, radius: str) -> None:
    """A point of the rim of a gear, across the line of centres, where the statement is not long without it."""
    if draft.relative or draft.rng.random() > _WITH_RIM:
        draft.wheel(centre, radius)
        return
    rim, turn = draft.letter(), draft.rng.choice((90, -90))
    draft.polar(rim, centre, radius, draft.direction(centre, axis) + turn, {"towards": axis, "angle": f"{turn}*deg"})
    draft.bodies[PINION].append(rim)
    draft.wheel(centre, radius, rim)
    draft.position.append(("square", {"one": axis + centre, "link": centre + rim}))
    draft.sentences.append(("rim_point", {"rim": rim}))
    draft.asked[-1].insert(0, f"v_{rim}")


def _contact(draft: Draft) -> str:
    """A name for the pitch point of gear and rack, which solutions tell."""
    return "K" if "K" not in draft.points else draft.letter()


def _rack(draft: Draft, slider: str, pitch_point: str, centre: str, radius: str, wheel: str) -> str:
    """The body of a rack from its slider along the guide past the pitch point, in mesh with the gear ``wheel``."""
    end = f"E{slider}"
    way = draft.direction(slider, pitch_point)
    draft.place(end, pitch_point, draft.rng.choice(_PAST), way)
    draft.hint("hidden", end)
    body = f"rack{slider}"
    draft.bodies[body] = [slider, end]
    draft.symbols[body] = ""
    draft.nouns[body] = TOOTHED_RACK
    draft.hint("plain", body)
    draft.bars.append((slider, end))
    draft.bodies[wheel].append(pitch_point)
    draft.hint("hidden", pitch_point)
    draft.joint("translation", body=body)
    fields = {"body": wheel, "centre": centre, "contact": pitch_point, "on": body, "on_point": slider}
    draft.joint("rolling", **fields, axle_held=True)
    draft.wheel(centre, radius, slider, end)
    return body


def _driven_by_rack(draft: Draft, slider: Link) -> None:
    """A rack fixed to a slider in a fixed guide turns a gear about a fixed axis."""
    if slider.guide is None:
        raise LayoutError("the slider is in no fixed guide")
    block = slider.start
    radius = draft.radius("r", draft.rng.choice(_RADII[:5]), _SPREAD)
    along, side = slider.guide + draft.rng.choice((0, 180)), draft.rng.choice((90, -90))
    far = next(name for bar in draft.bars if block in bar for name in bar if name != block)
    if between(draft.direction(block, far), along + side) < 90:
        raise LayoutError("the guide of the rack is on the side of its rod")
    contact = _contact(draft)
    draft.place(contact, block, draft.value(radius) + draft.rng.choice(_PAST), along)
    pivot = draft.pivot()
    draft.polar(pivot, contact, radius, along + side, {"angle": f"{(along + side) % 360}*deg"})
    new_pivot(draft, pivot)
    _pinion(draft, pivot, radius)
    _rack(draft, block, contact, pivot, radius, PINION)
    draft.sentences.append(("gear_on_rack", {"slider": block, "pivot": pivot, "own": radius}))
    draft.asked.append([f"omega_{PINION}", f"v_{block}"])


def rack(draft: Draft, links: tuple[int, int], dyad: AssurGroup, _: dict[int, str]) -> None:
    """WP: the gear on a link about a fixed axis drives a rack whose slider moves in a fixed guide."""
    link = draft.links[dyad.on]
    axis = _axis_of(draft, link)
    radius = draft.radius("r", draft.rng.choice(_RADII[:5]), _SPREAD)
    _gear_on(draft, link, axis, radius)
    guide, side, back = draft.rng.choice((0, 90)), draft.rng.choice((90, -90)), draft.rng.choice((0, 180))
    block = draft.letter()
    contact = _contact(draft)
    draft.polar(contact, axis, radius, guide + side, {"angle": f"{guide + side}*deg"})
    draft.place(block, contact, draft.value(radius) + draft.rng.choice(_PAST), guide + back)
    draft.joint("guide", point=block, **({"angle": guide} if guide else {}))
    body = _rack(draft, block, contact, axis, radius, link.body)
    draft.links[links[0]] = Link(block, noun="slider", guide=guide, body=body)
    facts = {"slider": block, "bar": link.body, "noun": link.noun, "own": radius, "way": FIXED[guide]}
    draft.sentences.append(("rack_on_gear", facts))
    draft.asked.append([f"v_{block}", f"omega_{link.body}"])
