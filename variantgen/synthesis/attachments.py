"""Where the dyads hang on the links that are there: hinges at ends, in the middle, beyond; lines to slide on."""

from __future__ import annotations

from variantgen.synthesis.draft import Attachment, Draft, Facts, LayoutError, Link

_BEYOND = (0.4, 0.5, 0.6)  # how far an extension goes on, in lengths of the link
_SLOT = 34  # half a groove across a slider, cm


def hinge_on(draft: Draft, number: int, other: int) -> Attachment:
    """A hinge on a moving link for a dyad whose other end is on the link ``other``."""
    link = draft.links[number]
    if not link.end:
        return _on_block(draft, link, other)
    if link.free:
        point = link.free.pop(0)
        facts = {"point": point, "noun": link.noun, "link": link.body}
        return Attachment(point, "end", facts, link.start if point == link.end else link.end)
    if link.extra:
        raise LayoutError("a fourth joint")
    link.extra = True
    return _middle(draft, link) if draft.rng.random() < 0.6 else _beyond(draft, link)


def _middle(draft: Draft, link: Link) -> Attachment:
    """The midpoint of a bar."""
    point = draft.letter()
    draft.points[point] = "fraction", {"start": link.start, "end": link.end}
    draft.z[point] = 0.5 * (draft.z[link.start] + draft.z[link.end])
    draft.bodies[link.body].append(point)
    facts = {"point": point, "noun": link.noun, "link": link.body}
    return Attachment(point, "middle", facts, link.start)


def _beyond(draft: Draft, link: Link) -> Attachment:
    """A point on the extension of a bar, at a printed distance from its end."""
    point = draft.letter()
    distance = draft.length(link.end, point, draft.rng.choice(_BEYOND) * draft.distance(link.start, link.end))
    angle = draft.direction(link.start, link.end)
    draft.polar(point, link.end, distance, angle, {"towards": link.start, "angle": "180*deg"})
    members = draft.bodies[link.body]
    members[:] = [link.start, point, *(p for p in members if p != link.start)]
    draft.bars[draft.bars.index((link.start, link.end))] = (link.start, point)
    facts = {"point": point, "noun": link.noun, "link": link.body, "end": link.end}
    return Attachment(point, "beyond", facts, link.start)


def _on_block(draft: Draft, link: Link, other: int) -> Attachment:
    """The pin of a block, or where that would make rigid triangles, the end of an arm that is fixed to the block."""
    if link.noun == "yoke" and (foot := draft.bodies[link.body][0]) not in draft.hints["hidden"]:
        return Attachment(link.start, "end", {"point": link.start, "noun": "yoke", "link": foot + link.start}, foot)
    if not link.arm_only and not _is_pinned(draft, other, link.start):
        return Attachment(link.start, "slider", {"point": link.start, "block": link.noun})
    if link.extra:
        raise LayoutError("a second arm")
    link.extra = True
    if link.noun == "pin":
        _as_slider(draft, link.start)
    point = draft.letter()
    distance = draft.length(link.start, point, draft.rng.choice((24, 28, 32, 36)), 0.2)
    body = link.start + point
    draft.bodies[body] = [link.start, point]
    draft.bars.append((link.start, point))
    link.body = body
    facts = {"point": point, "link": body, "slider": link.start, "block": link.noun}
    if link.guide is not None:
        along = link.guide + draft.rng.choice((0, 180))
        draft.polar(point, link.start, distance, along, {"angle": f"{along}*deg"})
        draft.joint("translation", body=body)
        key = "arm_across_slot" if link.noun == "block" else "arm_along"  # the block of a yoke, and a slider
        return Attachment(point, key, facts, link.start)
    turn = draft.rng.choice((90, -90))
    start, end = link.line
    angle = draft.direction(start, end) + turn
    draft.polar(point, link.start, distance, angle, {"towards": end, "angle": f"{turn}*deg"})
    slot = next(fields for kind, fields in draft.joints if kind == "slot" and fields["point"] == link.start)
    slot["sleeve"] = body
    if start in draft.hints.get("hidden", ()):
        return Attachment(point, "arm_across_slot", facts, link.start)
    return Attachment(point, "arm_across", facts | {"bar": start + end}, link.start)


def _is_pinned(draft: Draft, number: int, point: str) -> bool:
    """Whether a moving link is on a pin, by one of its ends or as a block; the frame (no link of the draft) is not."""
    link = draft.links.get(number)
    return link is not None and point in (link.start, link.end)


def _as_slider(draft: Draft, point: str) -> None:
    """A pin in two guides becomes a slider and a sleeve (or a block in a slot) on one pin: both can carry arms, which
    turn against each other.
    """
    place, facts = next((i, f) for i, (k, f) in enumerate(draft.sentences) if f.get("slider") == point)
    riding = "block" if facts["noun"] == "groove" else "collar"
    draft.sentences[place] = (f"slider_and_{riding}", facts)
    draft.sentences = [(key, _on_slider(said, point)) for key, said in draft.sentences]
    for link in draft.links.values():
        if link.start == point and link.noun == "pin":
            link.noun = riding if link.guide is None else "slider"
    draft.relative = [(k, f | ({"block": riding} if f["point"] == point else {})) for k, f in draft.relative]


def _on_slider(facts: Facts, point: str) -> Facts:
    """The facts of a sentence in which what was told to hang on a pin hangs on the slider that is on it."""
    own = (at for at in ("at", "at_to") if facts.get(f"{at}_point") == point and facts.get(f"{at}_block") == "pin")
    return facts | {f"{at}_block": "slider" for at in own}


def line_on(draft: Draft, number: int) -> Link:
    """The bar of a moving link on which something slides; a slider in a fixed guide gets a groove across it."""
    link = draft.links[number]
    if link.end:
        return link
    if link.guide is None or link.extra:
        raise LayoutError("nothing slides on a turning block")
    link.extra = True
    across = link.guide + 90
    ends = [f"{letter}{link.start}" for letter in ("K", "L")]
    for end, angle in zip(ends, (across, across + 180), strict=True):
        draft.place(end, link.start, _SLOT, angle)
        draft.hint("hidden", end)
    body = f"slider{link.start}"
    draft.bodies[body] = [link.start, *ends]
    draft.bars.append((ends[1], ends[0]))
    draft.joint("translation", body=body)
    draft.hint("grooves", ends)
    draft.symbols[body] = ""
    draft.nouns[body] = "slider"
    draft.hint("plain", body)
    link.body = body
    return Link(ends[1], ends[0], "groove", [], body, True)
