"""Whether a position or a radius that might be asked is one of the data: then the statement tells it already."""

from __future__ import annotations

from collections.abc import Mapping

from variantgen.families.family import ComponentTemplate, Form
from variantgen.families.parameters.expressions import FamilyExpression
from variantgen.families.quantities import Quantity
from variantgen.mechanism.constructions.coordinates import Coordinates
from variantgen.mechanism.constructions.polar import Polar
from variantgen.mechanism.linkage import Linkage


def given_position(form: Form, quantity: Quantity) -> str:
    """Why a coordinate, angle, distance or radius of curvature needs no solution; '' where it has to be found."""
    points = quantity.points(form.points)
    if quantity.is_centre:
        return _pivot(form, quantity)
    if quantity.group == "path":
        return _circle(form, quantity.target)
    if quantity.kind == "distance":
        body = next((name for name, members in form.bodies.items() if {*points} <= {*members}), "")
        if body:
            return f"both points belong to {body}, so their distance is a length of the data"
    resting = Linkage(form.sample).resting
    if {*points} <= resting:
        return f"{' and '.join(points)} {'rests' if len(points) == 1 else 'rest'}"
    if any(_gives(form, name, form.points[name], quantity, points) for name in points):
        return "the data tell it: ask for a position that has to be found"
    return ""


def _pivot(form: Form, quantity: Quantity) -> str:
    """Why the velocity centre of a body has coordinates of the data: it turns about a fixed point."""
    pivot = Linkage(form.sample).pivot(quantity.target) if quantity.kind == "P" and quantity.is_coordinate else None
    return f"{quantity.target} turns about {pivot}, which rests: that is its velocity centre" if pivot else ""


def _circle(form: Form, point: str) -> str:
    """Why the radius of the path of a point is a length of the data: it turns about a fixed point."""
    linkage = Linkage(form.sample)
    pivots = ((body, linkage.pivot(body)) for body in linkage.owners(point))
    found = next(((body, pivot) for body, pivot in pivots if pivot not in (None, point)), None)
    return f"{point} turns with {found[0]} about {found[1]}: the radius is their distance" if found else ""


def _gives(form: Form, name: str, template: ComponentTemplate, quantity: Quantity, points: tuple[str, ...]) -> bool:
    """Whether the construction of a point states the quantity by a datum."""
    fields = template.fields
    if template.component is Coordinates:
        return quantity.is_coordinate and _is_datum(form, fields[quantity.kind])
    if template.component is not Polar:
        return False
    origin, towards = fields["origin"], fields.get("towards")
    if quantity.kind == "distance":
        return origin in points and _is_datum(form, fields["distance"])
    if quantity.kind != "angle" or not _is_datum(form, _angle(fields)):
        return False
    if not quantity.component:
        return towards is None and {origin, name} == {*points}
    first, corner, last = points
    return corner == origin and {name, towards} == {first, last}


def _angle(fields: Mapping[str, object]) -> object:
    return fields.get("angle", 0.0)


def _is_datum(form: Form, item: object) -> bool:
    """Whether a number of a construction is written as it stands, or is made of printed data by sums alone."""
    if not isinstance(item, FamilyExpression):
        return True
    return all(name in form.parameters and form.parameters[name].given for name in item.names)
