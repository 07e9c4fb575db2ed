"""Sleeves on rods, blocks in slotted arms and grooves, edges that slide on discs and points."""

from __future__ import annotations

from collections.abc import Sequence

from variantgen.figure.telling.directions import is_parallel
from variantgen.figure.telling.teller import Teller
from variantgen.mechanism.joints.slot import Slot


def tell(teller: Teller, items: Sequence[Slot]) -> list[str]:
    """A clause for each slot."""
    return [_clause(teller, joint) for joint in items]


def _clause(teller: Teller, joint: Slot) -> str:
    figure = teller.board.form.figure
    name = teller.name(joint.point)
    start, end = (teller.at(point) for point in joint.along)
    line = teller.inclined(end - start)
    if joint.point in figure.bare:
        if teller.board.is_disc(joint.point):
            disc = teller.disc(joint.point, teller.owners(joint.point)[0])
            words = {"body": teller.body(joint.body), "line": line, "side": _side_of_face(teller, joint)}
            return teller.say("slot_face", disc=disc, **words)
        shown = len(teller.shown(joint.along)) == 2
        edge = "".join(map(teller.name, joint.along)) if shown else teller.body(joint.body)
        return teller.say("slot_edge", point=name, edge=edge)
    body = teller.part(joint.body, "_of")
    if any(_is_groove(teller, groove, start, end) for groove in figure.grooves):
        points = teller.listed([teller.name(point) for point in teller.shown(joint.along)])
        through = teller.say("slot_through", points=points) if points else ""
        words = {"hinged": teller.hinge(joint.point), "through": through}
        return teller.say("slot_groove", point=name, body=body, line=line, **words)
    words = {"point": name, "body": teller.body(joint.body), "where": _between(teller, joint)}
    if joint.body in figure.slotted:
        return teller.say("slot_arm", hinged=teller.hinge(joint.point), **words)
    if joint.sleeve is not None:
        teller.hinged.add(joint.point)
        sleeve = teller.part(joint.sleeve, "_with")
        return teller.say("slot_rigid", sleeve=sleeve, **words)
    if not teller.owners(joint.point) and joint.point not in teller.fixed:
        return teller.say("slot_free", **words)
    return teller.say("slot", hinged=teller.hinge(joint.point, "_she"), **words)


def _between(teller: Teller, joint: Slot) -> str:
    """Between which named points of the bar the sleeve is; nothing where it is not between two."""
    if len(teller.shown(joint.along)) < 2:
        return ""
    start, end = (teller.at(point) for point in joint.along)
    part = ((teller.at(joint.point) - start) / (end - start)).real
    names = {"first": teller.name(joint.along[0]), "second": teller.name(joint.along[1])}
    return teller.say("slot_between", **names) if 0 < part < 1 else ""


def _side_of_face(teller: Teller, joint: Slot) -> str:
    """On which side of a disc the face is drawn that it touches: a line of the body parallel to that of the slot."""
    centre = teller.at(joint.point)
    way = teller.at(joint.along[1]) - teller.at(joint.along[0])
    way /= abs(way)
    for first, second in teller.segments[joint.body]:
        if is_parallel(teller.at(second) - teller.at(first), way):
            step = teller.at(first) - centre
            return teller.side(step - (step * way.conjugate()).real * way)
    return ""


def _is_groove(teller: Teller, groove: Sequence[str], start: complex, end: complex) -> bool:
    """Whether a groove lies along the line of a slot."""
    first, last = teller.at(groove[0]), teller.at(groove[-1])
    # Of the two ends of the slot's line one may be an end of the groove itself.
    return is_parallel(last - first, end - start) and is_parallel(last - first, (start + end) / 2 - first)
