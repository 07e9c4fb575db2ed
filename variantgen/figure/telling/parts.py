"""The parts of a mechanism in words: bars, slotted arms, plates, discs, walls; and the hinges between them."""

from __future__ import annotations

from collections.abc import Sequence
from itertools import pairwise

from variantgen.figure.telling.directions import is_parallel
from variantgen.figure.telling.shown import Segment
from variantgen.figure.telling.teller import Teller

_ON_RIM = 1e-6  # of the radius: how far off a rim a point of it may be by rounding


def parts(teller: Teller) -> list[str]:
    """Everything that the figure shows of the bodies, a phrase each."""
    found = [*_bars(teller), *_plates(teller), *_discs(teller)]
    figure = teller.board.form.figure
    for names in figure.thin:
        if len(teller.shown(names)) == len(names):
            found.append(teller.say("thin_line", points="".join(map(teller.name, names))))
    for names in figure.walls:
        for first, second in pairwise(names):
            found.append(teller.say("wall", line=teller.line(teller.at(second) - teller.at(first))))
    return found


def hinges(teller: Teller) -> list[str]:
    """The hinges between bodies that no joint has told of."""
    found = []
    for point in teller.board.shown:
        owners = teller.owners(point)
        if len(owners) < 2 or point in teller.hinged:
            continue
        key = "shared_axis" if point in teller.fixed else "hinge"
        names = teller.listed([teller.part(body) for body in owners])
        found.append(teller.say(key, point=teller.name(point), bodies=names))
    return found


def _bars(teller: Teller) -> list[str]:
    form = teller.board.form
    straight: list[str] = []
    slotted: list[str] = []
    others: list[str] = []
    for body in form.bodies:
        drawn = teller.segments[body]
        ended = [pair for pair in drawn if teller.is_shown(pair[0]) and teller.is_shown(pair[1])]
        if len(ended) > 1:
            pieces = teller.listed(["".join(map(teller.name, pair)) for pair in ended])
            others.append(teller.say("bent_bar", body=teller.body(body), pieces=pieces))
        elif ended and teller.is_spelled(body):
            (slotted if body in form.figure.slotted else straight).append(_with_points(teller, body))
        else:
            others += [text for pair in drawn if (text := _bar_through(teller, body, pair))]
    groups = ((straight, "bar", "bars"), (slotted, "slotted_arm", "slotted_arms"))
    return [
        teller.say(one if len(own) == 1 else many, bars=", ".join(own)) for own, one, many in groups if own
    ] + others


def _with_points(teller: Teller, body: str) -> str:
    """The name of a bar with the points on it: ``AB (D on it)``."""
    points = [teller.name(point) for point in teller.between[body]]
    name = teller.body(body)
    return teller.say("points_on_bar", bar=name, points=teller.listed(points)) if points else name


def _bar_through(teller: Teller, body: str, pair: Segment) -> str:
    """A bar whose ends the figure does not name, by its named points and its direction."""
    start, end = (teller.at(point) for point in pair)
    points = [
        teller.name(point)
        for point in teller.shown(teller.board.form.bodies[body])
        if point in pair or is_parallel(teller.at(point) - start, end - start)
    ]
    return teller.say("bar_through", points=teller.listed(points), line=teller.line(end - start)) if points else ""


def _plates(teller: Teller) -> list[str]:
    form = teller.board.form
    keys = {3: "triangular_plate", 4: "quadrangular_plate"}
    return [
        teller.say(keys.get(len(form.bodies[body]), "plate"), points="".join(map(teller.name, form.bodies[body])))
        for body in form.figure.plates
    ]


def _discs(teller: Teller) -> list[str]:
    """Discs that are bodies; a fixed circle is told by the joint that needs it."""
    found = []
    bodies = dict.fromkeys(circle.mark.body for circle in teller.circles if circle.mark.body)
    for body in bodies:
        circles = teller.circles_of(body)
        centre = circles[0].mark.centre
        on_rim, inside = _members(teller, body)
        notes = [teller.say("on_rim", points=teller.listed(on_rim))] if on_rim else []
        notes += [teller.say("inside", points=teller.listed(inside))] if inside else []
        words = {"number": teller.number(centre, body), "centre": teller.name(centre)}
        text = _attached(teller, body, centre) if teller.is_spelled(body) else teller.say("numbered_disc", **words)
        if len(circles) > 1:
            notes.insert(0, teller.say("stepped"))
        found.append(f"{text} ({'; '.join(notes)})" if notes else text)
    return found


def _attached(teller: Teller, body: str, centre: str) -> str:
    """A disc that is fixed to a bar."""
    name = teller.body(body)
    if teller.is_shown(centre):
        return teller.say("disc_on_bar", centre=teller.name(centre), body=name)
    first = teller.shown(teller.board.form.bodies[body])[0]
    place = teller.place(teller.at(centre) - teller.at(first), teller.name(first))
    return teller.say("nameless_disc_on_bar", place=place, body=name)


def _members(teller: Teller, body: str) -> tuple[list[str], list[str]]:
    """Named points of a disc: on its (largest) rim, and inside it; its centre and the ends of its bars left out."""
    circles = teller.circles_of(body)
    centre, rim = circles[0].mark.centre, max(circle.radius for circle in circles)
    bars: Sequence[str] = [point for pair in teller.segments[body] for point in pair]
    on_rim, inside = [], []
    for point in teller.shown(teller.board.form.bodies[body]):
        if point == centre or any(point in pair for pair in bars) or point in teller.between[body]:
            continue
        reach = abs(teller.at(point) - teller.at(centre))
        if abs(reach - rim) < _ON_RIM * rim:
            on_rim.append(teller.name(point))
        elif reach < rim:
            inside.append(teller.name(point))
    return on_rim, inside
