"""What is asked of a whole turn of the crank: limit positions by triangles, all else position by position.

A rod between the crank pin and a slider or the pin of a rocker lies along the crank in the limit positions, for there
its end is at rest: the pins are ``AB + OA`` and ``AB - OA`` from the pivot. A lever in which the crank pin slides has
its limit positions where it touches the circle of the pin.
"""

from __future__ import annotations

from itertools import permutations

from msgspec import Struct

from variantgen.algebra.expression import Applied, Constant, Expression, Pi, Ratio, SquareRoot, Value
from variantgen.algebra.name import Name
from variantgen.families.quantities import Quantity
from variantgen.families.quantities.kind import MEAN
from variantgen.mechanism.linkage import Linkage
from variantgen.mechanism.turn.crank import crank_of
from variantgen.methods.by_groups.turn_positions import by_positions, turn_measure, turn_name
from variantgen.methods.linkage.problem import CLOSE
from variantgen.methods.solution.book import Book
from variantgen.methods.steps.step import Body, Derived, Fact, Point, Segment

_TO_AND_FRO = ("stroke", "swing", "time_ratio")


def turn_answer(book: Book, quantity: Quantity) -> Value:
    """The value of a quantity of a turn, with a step that leads to it, or says that there is no formula for it."""
    name = turn_name(quantity)
    if name in book.values:
        return book.values[name]
    with book.step(_heading(quantity), value=name):
        if quantity.kind in _TO_AND_FRO:
            found = _by_limits(book, quantity.kind, quantity.target)
        elif quantity.kind.startswith(MEAN):
            found = _mean(book, quantity)
        else:
            found = None
        return book.derive(name, turn_measure(quantity), found) if found is not None else by_positions(book, quantity)


def _heading(quantity: Quantity) -> str:
    """The heading that says what is found; the symbol of an extreme does."""
    if quantity.kind in _TO_AND_FRO:
        return f"turn.heading_{quantity.kind}"
    return "turn.heading_mean" if quantity.kind.startswith(MEAN) else "turn.heading"


class _Limits(Struct, frozen=True):
    """Crank OA, rod AB; the pin B of a slider (``centre`` is '') or of a rocker about a fixed centre."""

    pivot: str
    pin: str
    end: str
    centre: str = ""


def _by_limits(book: Book, kind: str, target: str) -> Expression | None:
    """A stroke, a swing or a ratio of times by the triangles of the limit positions; None where there is no rod."""
    arm = _arm(book, target) if target in book.task.scene.points else None
    if arm is not None:
        return _chord(book, target, *arm) if kind == "stroke" else _by_limits(book, kind, arm[0])
    lever = _lever(book, target)
    if lever is not None:
        return _of_lever(book, kind, *lever)
    found = _limits(book, target)
    if found is None:
        return None
    geometry = book.geometry
    crank, rod = geometry.length(found.pivot, found.pin), geometry.length(found.pin, found.end)
    if rod.exact <= crank.exact:
        return None
    if kind == "time_ratio" and not found.centre and _offset(book, found) is None:
        book.say("turn.half_turns", False)
        return Constant(1.0)
    places: dict[str, Fact] = {
        "point": Point(found.end),
        "crank": Segment(found.pivot, found.pin),
        "rod": Segment(found.pin, found.end),
    }
    names = [Name("limit", found.pivot + found.end, number) for number in "12"]
    if names[0] not in book.values:
        book.show("limit_positions:" + "-".join(filter(None, (found.pivot, found.pin, found.end, found.centre))))
        book.say("turn.in_line", False, **places)
        for name, length in zip(names, (rod + crank, rod - crank), strict=True):
            book.derive(name, "length", length)
    ends = book.values[names[0]], book.values[names[1]]
    return (_of_rocker if found.centre else _of_slider)(book, kind, found, ends)


def _arm(book: Book, point: str) -> tuple[str, str] | None:
    """The body that swings about a fixed centre with a point, and that centre."""
    linkage = Linkage(book.task.scene)
    crank = crank_of(book.task.scene)
    for body in linkage.owners(point):
        centre = linkage.pivot(body)
        if centre is not None and crank is not None and body != crank.body:
            return body, centre
    return None


def _chord(book: Book, point: str, body: str, centre: str) -> Expression | None:
    """The chord of the arc between the limit positions, ``2 CP sin(psi / 2)``."""
    whole = _way(book, Quantity("swing", body))
    if whole is None:
        return None
    book.say("turn.chord", False, point=Point(point), centre=Point(centre), angle=whole)
    return Constant(2.0) * book.geometry.length(centre, point) * Applied("sin", Ratio(whole, Constant(2.0)))


def _way(book: Book, way: Quantity) -> Value | None:
    """The value of a stroke or a swing, derived where it is not yet; None where it has no formula."""
    if turn_name(way) in book.values:
        return book.values[turn_name(way)]
    expression = _by_limits(book, way.kind, way.target)
    return None if expression is None else book.derive(turn_name(way), turn_measure(way), expression)


def _limits(book: Book, target: str) -> _Limits | None:
    """The rod that drives a point or a body, one end of which is the pin of the crank."""
    task = book.task
    scene, linkage = task.scene, Linkage(task.scene)
    crank = crank_of(scene)
    assert crank is not None, "there is a turn"
    guided = linkage.guides(task.at)
    for rod, members in scene.bodies.items():
        pins = [name for name in members if name in scene.bodies[crank.body] and name != crank.pivot]
        if rod == crank.body or len(pins) != 1 or linkage.pivot(rod) is not None:
            continue
        if target in members and target in guided and target not in pins:
            return _Limits(crank.pivot, pins[0], target)
        centre = linkage.pivot(target) if target in scene.bodies else None
        shared = [name for name in members if centre and name in scene.bodies[target] and name not in pins]
        if centre is not None and centre != crank.pivot and len(shared) == 1:
            return _Limits(crank.pivot, pins[0], shared[0], centre)
    return None


def _of_slider(book: Book, kind: str, found: _Limits, ends: tuple[Value, Value]) -> Expression | None:
    far, near = ends
    offset = _offset(book, found)
    if offset is None:
        return far - near
    if offset.exact >= near.exact:
        return None
    if not book.has_said("turn.offset"):
        book.say("turn.offset", False, pivot=Point(found.pivot), point=Point(found.end), distance=offset)
    if kind == "stroke":
        return SquareRoot(far**2 - offset**2) - SquareRoot(near**2 - offset**2)
    book.say("turn.inclinations", False, far=far, near=near)
    angles = [
        book.derive(Name("inclination", letter), "angle", Applied("arcsin", Ratio(offset, end)))
        for letter, end in (("beta", far), ("gamma", near))
    ]
    return _ratio_of_times(book, angles[1] - angles[0])


def _offset(book: Book, found: _Limits) -> Value | None:
    """The distance of the pivot from the guide of a slider, a datum where it is one; None where it is on it."""
    task = book.task
    now = task.now
    ray = Linkage(task.scene).guides(task.at)[found.end]
    size = abs(((now.z[found.pivot] - now.z[found.end]) * ray.conjugate()).imag)
    if size <= CLOSE * task.size:
        return None
    # A link may be as long as the distance is.
    links = {first + last for members in task.scene.bodies.values() for first, last in permutations(members, 2)}
    lengths = [value for name, value in task.given.items() if value.measure == "length" and name not in links]
    named = [value for value in lengths if abs(value.exact - size) <= CLOSE * size]
    name = Name("offset", found.pivot)
    return named[0] if named else book.values.setdefault(name, Value(name, "length", size))


def _of_rocker(book: Book, kind: str, found: _Limits, ends: tuple[Value, Value]) -> Expression | None:
    """By the law of cosines in the triangles of the pivots and the pin, in both limit positions."""
    geometry = book.geometry
    base, arm = geometry.length(found.pivot, found.centre), geometry.length(found.centre, found.end)
    at = found.centre if kind == "swing" else found.pivot
    corners = []
    for number, end in enumerate(ends, start=1):
        own, other = (arm, end) if kind == "swing" else (end, arm)
        cosine = Ratio(base**2 + own**2 - other**2, Constant(2.0) * base * own)
        if not abs(cosine.number(True)) <= 1:
            return None
        first = found.pivot if kind == "swing" else found.centre
        name = Name("limit_corner", f"{first} {found.end}", str(number), body=at)  # the end that moves has the number
        corners.append(book.derive(name, "angle", Applied("arccos", cosine)))
    larger, smaller = sorted(corners, key=lambda corner: -corner.exact)
    return larger - smaller if kind == "swing" else _ratio_of_times(book, larger - smaller)


def _lever(book: Book, target: str) -> tuple[str, str, str] | None:
    """Pivot and pin of the crank and the centre of a lever along which the pin slides on a line through the centre."""
    task = book.task
    linkage = Linkage(task.scene)
    crank = crank_of(task.scene)
    assert crank is not None, "there is a turn"
    centre = linkage.pivot(target) if target in task.scene.bodies else None
    for path in linkage.slides:
        if centre is None or path.body != target or path.line is None:
            continue
        through = path.line[0] if path.line[0] != centre else path.line[1]
        on_crank = path.point in task.scene.bodies[crank.body]
        ray, arm = task.now.z[through] - task.now.z[centre], task.now.z[path.point] - task.now.z[centre]
        if on_crank and centre in path.line and abs((arm * ray.conjugate()).imag) <= CLOSE * abs(ray) * task.size:
            return crank.pivot, path.point, centre
    return None


def _of_lever(book: Book, kind: str, pivot: str, pin: str, centre: str) -> Expression | None:
    geometry = book.geometry
    crank, base = geometry.length(pivot, pin), geometry.length(pivot, centre)
    if base.exact <= crank.exact:
        return None
    if not book.has_said("turn.tangent"):
        book.say("turn.tangent", False, crank=Segment(pivot, pin), lever=Segment(centre, pin), point=Point(pin))
    half = Applied("arcsin", Ratio(crank, base))
    if kind == "swing":
        return Constant(2.0) * half
    return _ratio_of_times(book, Constant(2.0) * half)


def _ratio_of_times(book: Book, angle: Expression) -> Expression:
    """``(180 + theta) / (180 - theta)`` with theta the angle between the crank's directions, less a straight one."""
    theta = Value(Name("turn_between", ""), "angle", angle.number(True), angle)
    book.say("turn.times", False, angle=theta)
    book.items.append(Derived(theta))
    half = Constant(180.0, "angle")
    return Ratio(half + theta, half - theta)


def _mean(book: Book, quantity: Quantity) -> Expression | None:
    """Twice the way in the time of a turn: ``s omega / pi``, ``psi omega / 180``, ``CP psi omega / 180`` on an arc."""
    crank = crank_of(book.task.scene)
    assert crank is not None, "there is a turn"
    is_point, target = quantity.kind == "mean_v", quantity.target
    arm = _arm(book, target) if is_point else None
    swinging = arm[0] if arm else "" if is_point else target
    whole = _way(book, Quantity("swing", swinging) if swinging else Quantity("stroke", target))
    if whole is None:
        return None
    rate = book.omega[crank.body].size
    if arm is None:
        book.say("turn.there_and_back", False, body=Body(crank.body), way=whole)
        return Ratio(whole * rate, Constant(180.0, "angle") if swinging else Pi())
    radius = book.geometry.length(arm[1], target)
    book.say(
        "turn.arc_there_and_back",
        False,
        body=Body(crank.body),
        radius=radius,
        angle=whole,
        point=Point(target),
        centre=Point(arm[1]),
    )
    return Ratio(radius * whole * rate, Constant(180.0, "angle"))
