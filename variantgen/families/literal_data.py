"""The data that a scene of one's own states as numbers, with the names that a reader gives them.

Places of points have coordinates; lengths and angles are those of the lines between two points; rates have the letter
of the point or body that they drive.
"""

from __future__ import annotations

import math
from collections.abc import Iterator, Mapping, Sequence
from dataclasses import dataclass, replace
from functools import lru_cache
from typing import Any

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
}
# The rays of a construction: the field of the point from which each starts, and that of its angle.
_RAYS = {"polar": (("origin", "angle"),), "line_line": (("first", "first_angle"), ("second", "second_angle"))}
# Lines that may be guides: where one lies along an axis, a coordinate of the point tells it.
_GUIDES = {"line_circle": (("through", "angle"),), "line_line": _RAYS["line_line"]}
_LEVEL = 1e-9  # rad


@dataclass(frozen=True)
class LiteralDatum:
    """A number of a scene: its ``kind``, the ``name`` it is known by, what it measures.

    Kinds: ``place`` of a point, ``x`` or ``y`` of one in a guide, ``length`` and ``angle`` of the line of two
    ``points``, ``corner`` of three, all of which are measured on the solved position; ``radius`` of a body and ``rate``
    with their SI value.
    ``second`` says whether only accelerations depend on it, ``unless`` names a point that tells it, if it is seen.
    A rate that follows from parameters, as one by a law of time, has its ``source`` in place of a number.
    """

    kind: str
    name: str
    measures: str
    si: float = 0.0
    second: bool = False
    points: tuple[str, ...] = ()
    unless: str = ""
    source: FamilyExpression | None = None


def literal_data(form: Form) -> Iterator[LiteralDatum]:
    """The numbers of a form in the order of its file: places, conditions, joints, rates."""
    for name, template in form.points.items():
        yield from _of_point(name, template, form)
    for template in form.conditions:
        yield from _of_condition(template)
    for body, radii in literal_radii(form).items():
        for radius in radii:
            yield LiteralDatum("radius", body, "length", radius)
    for template in form.drivers:
        yield from _rates(template, form)


@lru_cache(maxsize=1000)
def literal_radii(form: Form) -> Mapping[str, Sequence[float]]:
    """The radii (m) of each body in joints and ropes, in the order of the file, each once."""
    found: dict[str, list[float]] = {}
    for template in form.joints:
        for part in (template, *template.fields.get("path", ())):
            body, radius = part.fields.get("body"), _literal(part, "radius")
            if body and radius and radius not in (own := found.setdefault(body, [])):
                own.append(radius)
    return found


def _rates(template: ComponentTemplate, form: Form) -> Iterator[LiteralDatum]:
    """Rates of a driver, but those that are a parameter, which has its own name."""
    for field in _RATES:
        source = template.fields.get(field)
        if not isinstance(source, FamilyExpression) or source.text.lstrip("- ") in form.parameters:
            continue
        second, rate = field in ("a", "epsilon"), _literal(template, field)
        if source.names:
            if any(source.names & {f"{law}_dot", f"{law}_ddot"} for law in form.laws):
                continue  # the law itself is told
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
        known = [axis for axis in ("x", "y") if _literal(template, axis) is not None]
        if known and template.names & form.laws.keys():  # the law tells the other one
            yield from (LiteralDatum(axis, name, "length", points=(name,)) for axis in known)
        elif known:
            yield LiteralDatum("place", name, "length", points=(name,))
    for other, length in _LINES.get(kind, ()):
        yield from _length(template, other, name, length)
    if kind == "on_body" and _literal(template, "across"):
        yield from _length(template, "towards", name, "along")
    for start, angle_field in _GUIDES.get(kind, ()):
        if (angle := _literal(template, angle_field)) is not None:
            for axis, across in (("y", math.sin(angle)), ("x", math.cos(angle))):
                if abs(across) < _LEVEL:
                    yield LiteralDatum(axis, name, "length", points=(name,), unless=template.fields[start])
    for start, angle_field in _RAYS.get(kind, ()):
        if _literal(template, angle_field) is not None and "towards" not in template.fields:
            ends = (template.fields[start], name)
            yield LiteralDatum("angle", "".join(ends), "angle", points=ends)


def _of_condition(template: ComponentTemplate) -> Iterator[LiteralDatum]:
    """The length of a link, the corner of two links that meet, the direction of a line through two points."""
    fields = template.fields
    match _kind(template):
        case "distance":
            yield from _length(template, "start", fields["end"], "length")
        case "angle" if _literal(template, "size") is not None:
            first, second = fields["first"], fields["second"]
            shared = [name for name in first if name in second]
            if len(shared) == 1:
                ends = [name for name in (*first, *second) if name != shared[0]]
                corner = ends[0], shared[0], ends[1]
                yield LiteralDatum("corner", "".join(corner), "angle", points=corner)
        case "line" if (angle := _literal(template, "angle")) is not None and not fields.get("towards"):
            through, point = fields["through"], fields["point"]
            level = [a for a, across in (("y", math.sin(angle)), ("x", math.cos(angle))) if abs(across) < _LEVEL]
            for axis in level:
                yield LiteralDatum(axis, point, "length", points=(point,), unless=through)
            if not level:
                yield LiteralDatum("angle", through + point, "angle", points=(through, point))


def _length(template: ComponentTemplate, start: str, end: str, field: str) -> Iterator[LiteralDatum]:
    if _literal(template, field) is not None:
        ends = (template.fields[start], end)
        yield LiteralDatum("length", "".join(ends), "length", points=ends)


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
