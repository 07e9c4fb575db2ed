"""Coordinates of points on paper, derived the way their constructions place them."""

from __future__ import annotations

from collections.abc import Callable
from typing import TYPE_CHECKING, Any

from variantgen.families.expressions import Expression as FamilyExpression
from variantgen.mechanism.constructions.circle_circle import CircleCircle
from variantgen.mechanism.constructions.coordinates import Coordinates
from variantgen.mechanism.constructions.fraction import Fraction
from variantgen.mechanism.constructions.line_circle import LineCircle
from variantgen.mechanism.constructions.polar import Polar
from variantgen.methods.expression import Constant, Expression, SquareRoot, Total, Value, cos, sin
from variantgen.methods.name import Name
from variantgen.methods.step import Derived, Fact, Point, Segment, Sentence, Statement

if TYPE_CHECKING:
    from variantgen.methods.geometry import Geometry

Pair = tuple[Value, Value]


def placed(geometry: Geometry, point: str) -> Pair:
    """The coordinates of a point; the lines that derive them are added to the items of the geometry."""
    template = geometry.task.form.points[point]
    place = _PLACES.get(template.component, _located)
    return place(geometry, point, template.fields)


def _pair(geometry: Geometry, point: str, x: Expression | None = None, y: Expression | None = None) -> Pair:
    """Values for the coordinates of a point; without an expression they are data."""
    z, size = geometry.task.now.z[point], geometry.task.size
    first = Value(Name("x", point), "length", z.real, x, size)
    second = Value(Name("y", point), "length", z.imag, y, size)
    return first, second


def _shown(geometry: Geometry, pair: Pair) -> Pair:
    geometry.items += [Derived(value) for value in pair if value.expression is not None and value.exact != 0]
    return pair


def _coordinates(geometry: Geometry, point: str, fields: Any) -> Pair:
    """Data of the drawing: expressions of given lengths, laid on paper."""
    frame = geometry.task.scene.frame
    right, up = frame.place(1.0), frame.place(1.0j)
    parts = [geometry.task.expressed(fields[key]) for key in ("x", "y")]

    def on_axis(component: Callable[[complex], float]) -> Expression | None:
        for vector, part in zip((right, up), parts, strict=True):
            sign = round(component(complex(vector)))
            if sign and part is not None and not isinstance(part, Constant):
                return part if sign > 0 else -part
        return None

    pair = _pair(geometry, point, on_axis(lambda v: v.real), on_axis(lambda v: v.imag))
    return _shown(geometry, pair)


def _polar(geometry: Geometry, point: str, fields: Any) -> Pair:
    """``x = x_O + r cos phi``, ``y = y_O + r sin phi``."""
    origin = fields["origin"]
    x, y = geometry.coordinates(origin)
    length = geometry.length(origin, point)
    angle = geometry.direction(origin, point) if geometry.is_read_off(origin, point) else None
    if angle is None:
        return _located(geometry, point, fields)
    return _shown(geometry, _pair(geometry, point, _plus(x, length * cos(angle)), _plus(y, length * sin(angle))))


def _plus(start: Value, step: Expression) -> Expression:
    return step if start.exact == 0 else start + step


def _fraction(geometry: Geometry, point: str, fields: Any) -> Pair:
    """A part of the way between two points."""
    first, second = geometry.coordinates(fields["start"]), geometry.coordinates(fields["end"])
    part = fields.get("part")
    share = geometry.task.read(part) if isinstance(part, FamilyExpression) else 0.5
    if share == 0.5:
        sums = [(a + b) / Constant(2.0) for a, b in zip(first, second, strict=True)]
    else:
        sums = [a + Constant(share) * Total(((1, b), (-1, a))) for a, b in zip(first, second, strict=True)]
    return _shown(geometry, _pair(geometry, point, *sums))


def _circle_circle(geometry: Geometry, point: str, fields: Any) -> Pair:
    """Two circles that cross: both equations, and of their two solutions the one of the figure."""
    first, second = fields["first"], fields["second"]
    pair = _pair(geometry, point)
    circles = [_circle(geometry, point, pair, centre) for centre in (first, second)]
    facts: dict[str, Fact] = {
        "point": Point(point),
        "first": Segment(first, point),
        "second": Segment(second, point),
        "x": pair[0],
        "y": pair[1],
    }
    geometry.items.append(Sentence("position.two_circles", facts))
    geometry.items += circles
    geometry.items.append(Sentence("position.chosen", facts, detail=False))
    return _worked(pair)


def _circle(geometry: Geometry, point: str, pair: Pair, centre: str) -> Statement:
    """``(x - x_C)^2 + (y - y_C)^2 = r^2``."""
    about = geometry.coordinates(centre)
    squares = [(value if c.exact == 0 else value - c) ** 2 for value, c in zip(pair, about, strict=True)]
    return Statement(squares[0] + squares[1], geometry.length(centre, point) ** 2)


def _line_circle(geometry: Geometry, point: str, fields: Any) -> Pair:
    """A line along an axis of the paper and a circle: one coordinate is that of the line, the other a root."""
    start, centre = fields["through"], fields["centre"]
    way = geometry.vector(start, point) if geometry.task.now.z[start] != geometry.task.now.z[point] else 0j
    on_line, about = geometry.coordinates(start), geometry.coordinates(centre)
    size = geometry.task.size
    flat = [axis for axis in (0, 1) if abs((way.imag, way.real)[axis]) < 1e-9 * size]
    if way == 0 or not flat:
        return _located(geometry, point, fields)
    axis = flat[0]  # 0: the line is horizontal
    fixed = on_line[1 - axis]
    offset = about[1 - axis] if fixed.exact == 0 else (fixed - about[1 - axis])
    length = geometry.length(centre, point)
    square = length**2 - offset**2 if offset.number(True) != 0 else None
    reach: Expression = SquareRoot(square) if square is not None else length
    z = geometry.task.now.z
    step = z[point] - z[centre]
    ahead = (step.real, step.imag)[axis] >= 0
    whole = (
        Total(((1, about[axis]), (1 if ahead else -1, reach)))
        if about[axis].exact != 0
        else (reach if ahead else -reach)
    )
    pair = _pair(geometry, point, *((whole, None) if axis == 0 else (None, whole)))
    level = pair[1 - axis]
    level.expression = None if fixed.exact == 0 else fixed
    return _shown(geometry, pair)


def _located(geometry: Geometry, point: str, fields: Any) -> Pair:
    """Any other construction: the coordinates are those of the drawing to scale."""
    pair = _pair(geometry, point)
    geometry.items.append(
        Sentence("position.located", {"point": Point(point), "x": pair[0], "y": pair[1]}, detail=False)
    )
    return _worked(pair)


def _worked(pair: Pair) -> Pair:
    """Coordinates found by solving a system: their printed numbers are rounded like all others."""
    for value in pair:
        value.expression = Constant(value.exact)
    return pair


_PLACES: dict[type, Callable[[Geometry, str, Any], Pair]] = {
    Coordinates: _coordinates,
    Polar: _polar,
    Fraction: _fraction,
    CircleCircle: _circle_circle,
    LineCircle: _line_circle,
}
