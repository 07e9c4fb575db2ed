"""The data that a scene of one's own states as numbers, with the names that a reader gives them.

Places of points have coordinates; lengths and angles are those of the lines between two points; rates have the letter
of the point or body that they drive.
"""

from __future__ import annotations

import cmath
import math
from collections.abc import Iterator, Mapping, Sequence
from types import MappingProxyType
from typing import Any

from msgspec import Struct
from msgspec.structs import replace

from variantgen.families.family import ComponentTemplate, Form
from variantgen.families.parameters.expressions import FamilyExpression
from variantgen.mechanism.component import field_specs

_RATES = ("v", "a", "omega", "epsilon")
# The lines of a construction: the field of its other end, and that of the length.
_LINES = {
    "polar": (("origin", "distance"),),
    "circle_circle": (("first", "first_distance"), ("second", "second_distance")),
    "line_circle": (("centre", "distance"),),
    "on_body": (("origin", "along"),),
    "fraction": (("start", "part"),),
    "tangent": (("centre", "radius"),),
}
# The rays of a construction: the field of the point from which each starts, and that of its angle.
_RAYS = {"polar": (("origin", "angle"),), "line_line": (("first", "first_angle"), ("second", "second_angle"))}
# Lines that may be guides: where one lies along an axis, a coordinate of the point tells it.
_GUIDES = {"line_circle": (("through", "angle"),), "line_line": _RAYS["line_line"]}
_LEVEL = 1e-9  # rad
_SAME = 1e-9  # relative difference of radii that are one


class LiteralDatum(Struct, frozen=True):
    """A number of a scene: its ``kind``, the ``name`` it is known by, what it measures.

    Kinds: ``place`` of a point, ``x`` or ``y`` of one in a guide, ``length`` and ``angle`` of the line of two
    ``points``, ``corner`` of three, all of which are measured on the solved position; ``guide`` of a point, an angle
    in the scene, and ``direction`` of its velocity or acceleration; ``radius`` of a body and ``rate`` with their SI
    value.
    ``second`` says whether only accelerations depend on it, ``unless`` names a point that tells it, if it is seen.
    A rate that follows from parameters, as one by a law of time, has its ``source`` in place of a number; the
    ``source`` of a length or an angle is the parameter that it is.
    """

    kind: str
    name: str
    measures: str
    si: float = 0.0
    second: bool = False
    points: tuple[str, ...] = ()
    unless: str = ""
    source: FamilyExpression | None = None


def literal_data(form: Form, at: Mapping[str, complex] = MappingProxyType({})) -> Iterator[LiteralDatum]:
    """The numbers of a form in the order of its file: places, conditions, joints, rates.

    Wheels have their radii by the places ``at`` (m) of their points.
    """
    for name, template in form.points.items():
        yield from _of_point(name, template, form)
    for template in form.conditions:
        yield from _of_condition(template, form)
    for body, radii in literal_radii(form, at).items():
        for radius in radii:
            yield LiteralDatum("radius", body, "length", radius)
    yield from _of_fixed_circles(form)
    yield from _guides(form)
    for template in form.drivers:
        yield from _rates(template, form)
        yield from _directions(template, form)


def literal_radii(form: Form, at: Mapping[str, complex] = MappingProxyType({})) -> Mapping[str, Sequence[float]]:
    """The radii (m) of each body in joints and ropes, in the order of the file, each once.

    A wheel that rolls on a line has its radius by the places ``at`` of centre and contact, if the figure does not name
    it.
    """
    found: dict[str, list[float]] = {}
    named = {disc.body for disc in form.figure.discs if disc.name}
    for template in form.joints:
        for part in (template, *template.fields.get("path", ())):
            body, radius = part.fields.get("body"), _literal(part, "radius")
            if (
                _kind(part) == "rolling"
                and body not in named
                and {part.fields["centre"], part.fields["contact"]} <= at.keys()
            ):
                radius = float(f"{abs(at[part.fields['centre']] - at[part.fields['contact']]):.12g}")
            own = found.setdefault(body, []) if body and radius else []
            if radius and not any(abs(radius - other) <= _SAME * radius for other in own):
                own.append(radius)
    return found


def _of_fixed_circles(form: Form) -> Iterator[LiteralDatum]:
    """The radii of pulleys that are no bodies, by the points at which they stand."""
    for template in form.joints:
        for part in template.fields.get("path", ()):
            if part.fields.get("body") is None and (radius := _literal(part, "radius")):
                yield LiteralDatum("radius", part.fields["point"], "length", radius)


def _guides(form: Form) -> Iterator[LiteralDatum]:
    """Guides that lie along no axis."""
    for template in form.joints:
        if _kind(template) == "guide" and isinstance(source := template.fields.get("angle"), FamilyExpression):
            angle, point = _literal(template, "angle"), template.fields["point"]
            if angle is None:
                yield LiteralDatum("guide", point, "angle", points=(point,), source=source)
            elif abs(math.sin(2 * angle)) > _LEVEL:
                yield LiteralDatum("guide", point, "angle", angle, points=(point,))


def on_lines_through(form: Form) -> dict[str, list[str]]:
    """The points that are placed on lines through other points, each with those others."""
    found: dict[str, list[str]] = {}
    for name, template in form.points.items():
        found[name] = [template.fields[start] for start, _ in _GUIDES.get(_kind(template), ())]
    for template in form.conditions:
        if _kind(template) == "line":
            found.setdefault(template.fields["point"], []).append(template.fields["through"])
    return found


def _directions(template: ComponentTemplate, form: Form) -> Iterator[LiteralDatum]:
    """Directions of given vectors: of both, or of the velocity along a line that no guide tells."""
    point, kind = str(template.fields.get("point")), _kind(template)
    fields: tuple[tuple[str, str], ...]
    if kind == "vector_motion":
        fields = (("v", "angle"), ("a", "a_angle"))
    elif kind == "travel" and not _is_led(form, point):
        fields = (("v", "angle"),)
    else:
        return
    for rate, field in fields:
        size, angle = _literal(template, rate), _literal(template, field)
        if angle is not None and abs(math.sin(2 * angle)) > _LEVEL and size != 0 and rate in template.fields:
            ahead = angle if size is None or size > 0 else cmath.phase(-cmath.rect(1.0, angle))
            name = str(getattr(template.fields[rate], "text", "")).lstrip("- ")
            name = name if name in form.parameters else rate_name(template, rate)
            yield LiteralDatum("direction", name, "angle", ahead, rate == "a", (point,))


def _is_led(form: Form, point: str) -> bool:
    """Whether a joint leads a point, or another driver gives a second component of its motion."""
    driven = [template for template in form.drivers if template.fields.get("point") == point]
    return point in _guided(form) or len(driven) > 1


def _guided(form: Form) -> set[str]:
    """The points in guides and slots at rest."""
    joints = (template for template in form.joints if _kind(template) in ("guide", "arc_slot"))
    return {template.fields["point"] for template in joints if template.fields.get("body") is None}


def _rates(template: ComponentTemplate, form: Form) -> Iterator[LiteralDatum]:
    """Rates of a driver, but those that are a parameter, which has its own name."""
    for field in _RATES:
        source = template.fields.get(field)
        if not isinstance(source, FamilyExpression) or source.text.lstrip("- ") in form.parameters:
            continue
        second, rate = field in ("a", "epsilon"), _literal(template, field)
        if source.names:
            if any(source.names & {f"{law}_dot", f"{law}_ddot"} for law in form.laws):
                continue  # the law itself stands on the sheet
            datum = LiteralDatum("rate", rate_name(template, field), _measure(template, field), 0.0, second)
            yield replace(datum, source=source)
        elif rate or (rate is not None and not second):
            yield LiteralDatum("rate", rate_name(template, field), _measure(template, field), rate, second)


def rate_name(template: ComponentTemplate, field: str) -> str:
    """The name of a rate that a driver gives as a number: ``omega_OA``, ``v_rel_M``, ``v_PQ`` of a cylinder."""
    fields = template.fields
    match _kind(template):
        case "rotation":
            other = fields.get("relative_to")
            return f"{field}_{fields['body']}" + (f"/{other}" if other else "")
        case "relative_travel" | "circling":
            along = ".t" if field == "a" and _kind(template) == "circling" else ""  # the normal one follows from v
            return f"{field}_rel_{fields['point']}{along}"
        case "extension":
            return f"{field}_{fields['start']}{fields['end']}"
    return f"{field}_{next(value for value in fields.values() if isinstance(value, str))}"


def _of_point(name: str, template: ComponentTemplate, form: Form) -> Iterator[LiteralDatum]:
    kind = _kind(template)
    if kind == "coordinates":
        axes = ("x", "y")
        own = [axis for axis in axes if getattr(template.fields[axis], "text", "") in {*form.laws, *form.parameters}]
        if len(own) == 1:  # the law or the parameter tells the other one
            yield from (LiteralDatum(axis, name, "length", points=(name,)) for axis in axes if axis not in own)
        elif not own:
            yield LiteralDatum("place", name, "length", points=(name,))
    for other, length in _LINES.get(kind, ()):
        yield from _length(template, other, name, length, form)
    if kind == "on_body" and _literal(template, "across") != 0 and "across" in template.fields:
        yield from _length(template, "towards", name, "along", form)
    for start, angle_field in _GUIDES.get(kind, ()):
        if (angle := _literal_angle(template, angle_field)) is not None:
            yield from _on_line(template.fields[start], name, angle, name in _guided(form))
    for start, angle_field in _RAYS.get(kind, ()):
        if "towards" not in template.fields and isinstance(template.fields.get(angle_field), FamilyExpression):
            yield from _measured("angle", (template.fields[start], name), template.fields[angle_field], form)


def _of_condition(template: ComponentTemplate, form: Form) -> Iterator[LiteralDatum]:
    """The length of a link, the corner of two links that meet, the direction of a line through two points."""
    fields = template.fields
    match _kind(template):
        case "distance":
            yield from _length(template, "start", fields["end"], "length", form)
        case "angle" if _literal(template, "size") is not None:
            first, second = fields["first"], fields["second"]
            shared = [name for name in first if name in second]
            if len(shared) == 1:
                ends = [name for name in (*first, *second) if name != shared[0]]
                corner = ends[0], shared[0], ends[1]
                yield LiteralDatum("corner", "".join(corner), "angle", points=corner)
        case "line" if (angle := _literal_angle(template, "angle")) is not None:
            yield from _on_line(fields["through"], fields["point"], angle)


def _on_line(through: str, point: str, angle: float, is_told: bool = False) -> Iterator[LiteralDatum]:
    """The coordinate of a point on a line along an axis; the direction of another line, unless it ``is_told``."""
    level = [axis for axis, across in (("y", math.sin(angle)), ("x", math.cos(angle))) if abs(across) < _LEVEL]
    for axis in level:
        yield LiteralDatum(axis, point, "length", points=(point,), unless=through)
    if not level and not is_told:
        yield LiteralDatum("angle", through + point, "angle", points=(through, point))


def _length(template: ComponentTemplate, start: str, end: str, field: str, form: Form) -> Iterator[LiteralDatum]:
    source = template.fields.get(field)
    if isinstance(source, FamilyExpression):
        yield from _measured("length", (template.fields[start], end), source, form)


def _measured(kind: str, ends: tuple[str, str], source: FamilyExpression, form: Form) -> Iterator[LiteralDatum]:
    """A length or an angle; one by a parameter says which it is, unless its name or the figure does; a law does it."""
    name = "".join(ends)
    datum = LiteralDatum(kind, name, kind, points=ends)
    if source.text not in form.parameters:
        if source.text not in form.laws:
            yield datum
    elif source.text not in (name, ends[1] + ends[0], *form.laws) and source.text not in _marked(form):
        yield replace(datum, source=source)


def _marked(form: Form) -> set[str]:
    """The parameters that the figure shows."""
    figure = form.figure
    angles, lengths = (mark.name for mark in figure.angles), (mark.name for mark in figure.lengths)
    return {*angles, *lengths, *(mark.name for mark in figure.discs)}


def _literal_angle(template: ComponentTemplate, field: str) -> float | None:
    """The angle of a line, 0 without one; None for a line towards a point, and one by parameters."""
    if template.fields.get("towards") or field not in template.fields:
        return None if template.fields.get("towards") else 0.0
    return _literal(template, field)


def _literal(template: ComponentTemplate, field: str) -> float | None:
    """The SI value of a field that depends on no parameter."""
    source = template.fields.get(field)
    if not isinstance(source, FamilyExpression) or source.names:
        return None
    value = float(source.value({}))
    return value if math.isfinite(value) else None


def _measure(template: ComponentTemplate, field: str) -> str:
    return str(next(spec.dimension for spec in field_specs(template.component) if spec.name == field))


def _kind(template: Any) -> str:
    return str(template.component.__module__.rpartition(".")[2])
