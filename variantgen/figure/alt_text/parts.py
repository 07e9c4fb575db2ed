"""The parts of a mechanism in words: bars, slotted arms, plates, discs, walls; and the hinges between them."""

from __future__ import annotations

from collections.abc import Sequence
from itertools import pairwise

from variantgen.figure.alt_text.alt_text import AltText
from variantgen.figure.alt_text.directions import is_parallel
from variantgen.figure.alt_text.drawn import Segment

_ON_RIM = 1e-6  # of the radius: how far off a rim a point of it may be by rounding


def parts(alt_text: AltText) -> list[str]:
    """Everything that the figure shows of the bodies, a phrase each."""
    found = [*_bars(alt_text), *_plates(alt_text), *_discs(alt_text)]
    figure = alt_text.board.form.figure
    for names in (*figure.thin, *figure.axial):
        if len(alt_text.shown(names)) == len(names):
            found.append(alt_text.say("thin_line", points="".join(map(alt_text.name, names))))
    for names in figure.walls:
        for first, second in pairwise(names):
            found.append(alt_text.say("wall", line=alt_text.line(alt_text.at(second) - alt_text.at(first))))
    return found


def hinges(alt_text: AltText) -> list[str]:
    """The hinges between bodies that no joint has mentioned."""
    found = []
    for point in alt_text.board.shown:
        owners = alt_text.owners(point)
        if len(owners) < 2 or point in alt_text.hinged:
            continue
        key = "shared_axis" if point in alt_text.fixed else "hinge"
        names = alt_text.parts(owners)
        found.append(alt_text.say(key, point=alt_text.name(point), bodies=names))
    return found


def _bars(alt_text: AltText) -> list[str]:
    form = alt_text.board.form
    straight: list[str] = []
    slotted: list[str] = []
    others: list[str] = []
    for body in form.bodies:
        drawn = alt_text.segments[body]
        ended = [pair for pair in drawn if alt_text.is_shown(pair[0]) and alt_text.is_shown(pair[1])]
        if len(ended) > 1:
            pieces = alt_text.listed(["".join(map(alt_text.name, pair)) for pair in ended])
            others.append(alt_text.say("bent_bar", body=alt_text.body(body), pieces=pieces))
        elif ended and alt_text.is_spelled(body):
            (slotted if body in form.figure.slotted else straight).append(_with_points(alt_text, body))
        else:
            others += [text for pair in drawn if (text := _bar_through(alt_text, body, pair))]
    groups = ((straight, "bar", "bars"), (slotted, "slotted_arm", "slotted_arms"))
    return [
        alt_text.say(one if len(own) == 1 else many, bars=", ".join(own)) for own, one, many in groups if own
    ] + others


def _with_points(alt_text: AltText, body: str) -> str:
    """The name of a bar with the points on it: ``AB (D on it)``."""
    points = [alt_text.name(point) for point in alt_text.between[body]]
    name = alt_text.body(body)
    return alt_text.say("points_on_bar", bar=name, points=alt_text.listed(points)) if points else name


def _bar_through(alt_text: AltText, body: str, pair: Segment) -> str:
    """A bar whose ends the figure does not name, by its named points and its direction."""
    start, end = (alt_text.at(point) for point in pair)
    points = [
        alt_text.name(point)
        for point in alt_text.shown(alt_text.board.form.bodies[body])
        if point in pair or is_parallel(alt_text.at(point) - start, end - start)
    ]
    return (
        alt_text.say("bar_through", points=alt_text.listed(points), line=alt_text.line(end - start)) if points else ""
    )


def _plates(alt_text: AltText) -> list[str]:
    form = alt_text.board.form
    keys = {3: "triangular_plate", 4: "quadrangular_plate"}
    return [
        alt_text.say(keys.get(len(form.bodies[body]), "plate"), points="".join(map(alt_text.name, form.bodies[body])))
        for body in form.figure.plates
    ]


def _discs(alt_text: AltText) -> list[str]:
    """Discs that are bodies; a fixed circle is described by the joint that needs it."""
    found = []
    bodies = dict.fromkeys(circle.mark.body for circle in alt_text.circles if circle.mark.body)
    for body in bodies:
        circles = alt_text.circles_of(body)
        centre = circles[0].mark.centre
        on_rim, inside = _members(alt_text, body)
        notes = [alt_text.say("on_rim", points=alt_text.listed(on_rim))] if on_rim else []
        notes += [alt_text.say("inside", points=alt_text.listed(inside))] if inside else []
        words = {"number": alt_text.number(centre, body), "centre": alt_text.name(centre)}
        text = (
            _attached(alt_text, body, centre) if alt_text.is_spelled(body) else alt_text.say("numbered_disc", **words)
        )
        if len(circles) > 1:
            notes.insert(0, alt_text.say("stepped"))
        found.append(f"{text} ({'; '.join(notes)})" if notes else text)
    return found


def _attached(alt_text: AltText, body: str, centre: str) -> str:
    """A disc that is fixed to a bar."""
    name = alt_text.body(body)
    if alt_text.is_shown(centre):
        return alt_text.say("disc_on_bar", centre=alt_text.name(centre), body=name)
    first = alt_text.shown(alt_text.board.form.bodies[body])[0]
    place = alt_text.place(alt_text.at(centre) - alt_text.at(first), alt_text.name(first))
    return alt_text.say("nameless_disc_on_bar", place=place, body=name)


def _members(alt_text: AltText, body: str) -> tuple[list[str], list[str]]:
    """Named points of a disc: on its (largest) rim, and inside it; its centre and the ends of its bars left out."""
    circles = alt_text.circles_of(body)
    centre, rim = circles[0].mark.centre, max(circle.radius for circle in circles)
    bars: Sequence[str] = [point for pair in alt_text.segments[body] for point in pair]
    on_rim, inside = [], []
    for point in alt_text.shown(alt_text.board.form.bodies[body]):
        if point == centre or any(point in pair for pair in bars) or point in alt_text.between[body]:
            continue
        distance = abs(alt_text.at(point) - alt_text.at(centre))
        if abs(distance - rim) < _ON_RIM * rim:
            on_rim.append(alt_text.name(point))
        elif distance < rim:
            inside.append(alt_text.name(point))
    return on_rim, inside
