"""Sleeves on rods, blocks in slotted arms and grooves, edges that slide on discs and points."""

from __future__ import annotations

from collections.abc import Sequence

from variantgen.figure.alt_text.alt_text import AltText
from variantgen.figure.alt_text.directions import is_parallel
from variantgen.mechanism.joints.slot import Slot


def tell(alt_text: AltText, items: Sequence[Slot]) -> list[str]:
    """A clause for each slot."""
    return [_clause(alt_text, joint) for joint in items]


def _clause(alt_text: AltText, joint: Slot) -> str:
    figure = alt_text.board.form.figure
    name = alt_text.name(joint.point)
    start, end = (alt_text.at(point) for point in joint.along)
    line = alt_text.inclined(end - start)
    if joint.point in figure.bare:
        if alt_text.board.is_disc(joint.point):
            disc = alt_text.disc(joint.point, alt_text.owners(joint.point)[0])
            side = _side_of_face(alt_text, joint)
            return alt_text.say("slot_face", disc=disc, body=alt_text.body(joint.body), line=line, side=side)
        shown = len(alt_text.shown(joint.along)) == 2
        edge = "".join(map(alt_text.name, joint.along)) if shown else alt_text.body(joint.body)
        return alt_text.say("slot_edge", point=name, edge=edge)
    if any(_is_groove(alt_text, groove, start, end) for groove in figure.grooves):
        points = alt_text.listed([alt_text.name(point) for point in alt_text.shown(joint.along)])
        through = alt_text.say("slot_through", points=points) if points else ""
        body, hinged = alt_text.part(joint.body), alt_text.hinge(joint.point)
        return alt_text.say("slot_groove", point=name, hinged=hinged, body=body, line=line, through=through)
    words = {"point": name, "body": alt_text.body(joint.body), "where": _between(alt_text, joint)}
    if joint.body in figure.slotted:
        return alt_text.say("slot_arm", hinged=alt_text.hinge(joint.point), **words)
    if joint.sleeve is not None:
        alt_text.hinged.add(joint.point)
        return alt_text.say("slot_rigid", sleeve=alt_text.part(joint.sleeve), **words)
    if not alt_text.owners(joint.point) and joint.point not in alt_text.fixed:
        return alt_text.say("slot_free", **words)
    return alt_text.say("slot", hinged=alt_text.hinge(joint.point), **words)


def _between(alt_text: AltText, joint: Slot) -> str:
    """Between which named points of the bar the sleeve is; nothing where it is not between two."""
    if len(alt_text.shown(joint.along)) < 2:
        return ""
    start, end = (alt_text.at(point) for point in joint.along)
    part = ((alt_text.at(joint.point) - start) / (end - start)).real
    names = {"first": alt_text.name(joint.along[0]), "second": alt_text.name(joint.along[1])}
    return alt_text.say("slot_between", **names) if 0 < part < 1 else ""


def _side_of_face(alt_text: AltText, joint: Slot) -> str:
    """On which side of a disc the face is drawn that it touches: a line of the body parallel to that of the slot."""
    centre = alt_text.at(joint.point)
    way = alt_text.at(joint.along[1]) - alt_text.at(joint.along[0])
    way /= abs(way)
    for first, second in alt_text.segments[joint.body]:
        if is_parallel(alt_text.at(second) - alt_text.at(first), way):
            step = alt_text.at(first) - centre
            return alt_text.side(step - (step * way.conjugate()).real * way)
    return ""


def _is_groove(alt_text: AltText, groove: Sequence[str], start: complex, end: complex) -> bool:
    """Whether a groove lies along the line of a slot."""
    first, last = alt_text.at(groove[0]), alt_text.at(groove[-1])
    # Of the two ends of the slot's line one may be an end of the groove itself.
    return is_parallel(last - first, end - start) and is_parallel(last - first, (start + end) / 2 - first)
