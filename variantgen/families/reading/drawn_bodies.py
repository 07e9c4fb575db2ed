"""How the bodies of a scene of one's own are drawn where its file does not say it.

A body of three and more points that lie on no line is a plate; on a line it is a bar from end to end. What rolls,
meshes or winds up a rope is a circle. A slot in a plate or in a disc is a groove.
"""

from __future__ import annotations

from collections.abc import Collection, Iterator, Mapping, Sequence
from typing import NamedTuple

from msgspec.structs import replace

from variantgen.families.family import Form
from variantgen.families.figure_hints import DiscMark, FigureHints
from variantgen.families.parameters.expressions import FamilyExpression, parse
from variantgen.mechanism.arithmetic import cross
from variantgen.mechanism.constructions.tangent import Tangent
from variantgen.mechanism.joints.gears import Gears
from variantgen.mechanism.joints.rolling import Rolling
from variantgen.mechanism.joints.rolling_on_circle import RollingOnCircle
from variantgen.mechanism.joints.rope import Rope
from variantgen.mechanism.linkage import Linkage
from variantgen.mechanism.rows import Placement
from variantgen.mechanism.solving.solve import solve

_ON_A_LINE = 1e-3  # of the length of a body
_SAME = 1e-6  # of a radius

Places = Mapping[str, complex]


def with_drawn_bodies(form: Form) -> Form:
    """The form with hints for the bodies of which its ``[figure]`` says nothing; as it is where it cannot be placed."""
    motion = solve(form.sample, 0, form.plan)
    if not motion.solved[0]:
        return form
    at = {name: complex(z[0]) for name, z in motion.z.items()}
    hints = form.figure
    said = {*hints.plates, *hints.plain, *hints.slotted, *(disc.body for disc in hints.discs)}
    said |= {body for body, own in form.bodies.items() for line in hints.lines if set(line) <= set(own)}
    circles = list(_circles(form, at))
    for body, members in form.bodies.items():
        own = [circle for circle in circles if circle.body == body]
        if body in said:
            continue
        if own:
            hints = _wheel(hints, body, own, _pins(form, body), at, form.parameters)
        elif len(members) > 2:
            hints = _link(hints, body, members, at)
    return replace(form, figure=replace(_with_grooves(form, hints), named=_stations(form, at)))


class _Circle(NamedTuple):
    """A circle of a round body: its radius in metres, and as the file states it where it does."""

    body: str
    centre: str
    radius: float
    stated: object = None

    @property
    def expression(self) -> FamilyExpression:
        """The radius as it is stated, or as a number."""
        return self.stated if isinstance(self.stated, FamilyExpression) else parse(f"{self.radius!r} * m")


def _circles(form: Form, at: Places) -> Iterator[_Circle]:
    """The circles of bodies that are round."""
    for template, joint in zip(form.joints, form.sample.joints, strict=True):
        stated = template.fields.get("radius")
        match joint:
            case Rolling(body=body, centre=centre, contact=contact):
                yield _Circle(body, centre, abs(at[contact] - at[centre]), _stated_distance(form, contact, centre))
            case RollingOnCircle(body=body, centre=centre, radius=radius, around=around, inside=inside, on=on):
                yield _Circle(body, centre, float(radius), stated)
                if on is not None:
                    yield _Circle(on, around, _other_radius(at, centre, around, float(radius), inside))
            case Gears(body=body, centre=centre, radius=radius, other_centre=around, other=other, inside=inside):
                yield _Circle(body, centre, float(radius), stated)
                if other is not None:
                    yield _Circle(other, around, _other_radius(at, centre, around, float(radius), inside))
            case Rope(path=path):
                for bend in path:
                    if bend.body is not None and float(bend.radius) > 0:
                        yield _Circle(bend.body, bend.point, float(bend.radius))


def _stated_distance(form: Form, first: str, second: str) -> object:
    """The distance of two points as one of them is placed: at it from the other, or along an axis from it."""
    for point, other in ((first, second), (second, first)):
        fields = form.points[point].fields
        if fields.get("origin") == other and "distance" in fields:
            return fields["distance"]
    places = [form.points[point].fields for point in (first, second)]
    for axis, across in (("x", "y"), ("y", "x")):
        if all(axis in fields and across in fields for fields in places):
            (one, two), same = [fields[axis] for fields in places], _are_alike(*(f[across] for f in places))
            length = next((b for a, b in ((one, two), (two, one)) if _is_zero(a)), None)
            if same and isinstance(length, FamilyExpression) and length.text.isidentifier():
                return length
    return None


def _are_alike(first: object, second: object) -> bool:
    return getattr(first, "tree", first) == getattr(second, "tree", second)


def _is_zero(value: object) -> bool:
    return isinstance(value, FamilyExpression) and not value.names and float(value.value({})) == 0


def _other_radius(at: Places, centre: str, around: str, radius: float, inside: bool) -> float:
    """The radius of the circle about ``around`` that touches the one about ``centre``."""
    between = abs(at[centre] - at[around])
    return between + radius if inside else between - radius


def _pins(form: Form, body: str) -> list[str]:
    """The points of a body at which another one is hinged."""
    others = {point for other, members in form.bodies.items() if other != body for point in members}
    return [point for point in form.bodies[body] if point in others]


def _wheel(
    hints: FigureHints,
    body: str,
    circles: Sequence[_Circle],
    pins: Sequence[str],
    at: Places,
    given: Collection[str],
) -> FigureHints:
    """Its circles, each once, and an arm to each pin beyond them."""
    marks: list[DiscMark] = []
    kept: list[float] = []
    for circle in circles:
        if not any(abs(circle.radius - other) <= _SAME * other for other in kept):
            kept.append(circle.radius)
            name = circle.expression.text if circle.expression.text in given else ""
            marks.append(DiscMark(circle.centre, circle.expression, name, body))
    centre, largest = circles[0].centre, max(kept)
    arms = tuple((centre, pin) for pin in pins if abs(at[pin] - at[centre]) > (1 + _SAME) * largest)
    return replace(hints, discs=(*hints.discs, *marks), lines=(*hints.lines, *arms))


def _link(hints: FigureHints, body: str, members: Sequence[str], at: Places) -> FigureHints:
    """A plate, or a bar to its farthest ends."""
    first = at[members[0]]
    far = max(members, key=lambda point: abs(at[point] - first))
    way = (at[far] - first) / abs(at[far] - first)
    along = {point: (at[point] - first) * way.conjugate() for point in members}
    if any(abs(place.imag) > _ON_A_LINE * abs(at[far] - first) for place in along.values()):
        return replace(hints, plates=(*hints.plates, body))
    ends = tuple(sorted(members, key=lambda point: along[point].real)[k] for k in (0, -1))
    if set(ends) == set(members[:2]):
        return hints
    return replace(hints, lines=(*hints.lines, ends))


def _stations(form: Form, at: Places) -> tuple[str, ...]:
    """Points that data speak of, though they are no part of the mechanism.

    The stations at rest of ropes from which a piece leads obliquely, whose direction follows from where they are; the
    points at which a line touches a circle that no joint has.
    """
    scene = form.sample
    used = {name for t in form.joints for name in t.fields.values() if isinstance(name, str)}
    found = [
        name for name, place in scene.points.items() if isinstance(place, Tangent) and place.radius and name not in used
    ]
    placed = Placement(at, scene.frame)
    guides = Linkage(scene).guides(placed)
    for strand in (strand for joint in scene.joints for strand in joint.strands(placed)):
        step, guide = at[strand.end] - at[strand.station], guides.get(strand.end)
        aside = abs(step) if guide is None else abs(abs(cross(step, guide)) - strand.radius)
        if aside > _SAME * abs(step):
            found.append(strand.station)
    return tuple(dict.fromkeys(found))


def _with_grooves(form: Form, hints: FigureHints) -> FigureHints:
    """Slots of plates and discs as grooves, where the file speaks of no groove."""
    wide = {*hints.plates, *(disc.body for disc in hints.discs)}
    found = [path.line for path in Linkage(form.sample).slides if path.line is not None and path.body in wide]
    return hints if hints.grooves else replace(hints, grooves=tuple(dict.fromkeys(found)))
