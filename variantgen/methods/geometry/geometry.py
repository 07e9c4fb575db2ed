"""The position of the mechanism as the solution needs it: lengths, directions and coordinates, worked out on demand.

What the statement gives is taken from there, with sums and differences of given lengths and angles. The rest comes from
the triangles of the mechanism (laws of cosines and sines), or from coordinates where the way between two points is
longer. Every number follows from the given ones by the formulas shown. Only what a later step asks for is worked out,
and once.
"""

from __future__ import annotations

from collections.abc import Iterable, Sequence

from variantgen.algebra.expression import Constant, Expression, Total, Value
from variantgen.algebra.name import Name
from variantgen.algebra.normal_form import Signed, summed
from variantgen.families.parameters.expressions import FamilyExpression
from variantgen.methods.geometry import trigonometry
from variantgen.methods.geometry.angle_sums import angle_sum
from variantgen.methods.geometry.angles import AngleForm, Atom, between, degrees, normal_angle, short
from variantgen.methods.geometry.legs import Leg, collected
from variantgen.methods.geometry.located_point import ORIGIN, LocatedPoint, Pair, derivation
from variantgen.methods.geometry.position_lines import PositionLines
from variantgen.methods.geometry.printed_angles import Way, placed_by_angles
from variantgen.methods.geometry.radii import UnnamedRadii
from variantgen.methods.geometry.shortest_path import ShortestPaths
from variantgen.methods.linkage.problem import CLOSE, Task
from variantgen.methods.steps.step import Body, Derived, Segment

__all__ = ["Geometry", "between", "degrees", "normal_angle"]

_SAME = 1e-7  # degrees within which two directions are one
_X, _Y = AngleForm(), AngleForm((), 90.0)
_INLINE = 2  # legs in oblique directions of which a triangle is made; of more, coordinates are taken


class Geometry(PositionLines):
    """Lengths, directions and coordinates of one variant; ``items`` are the lines that derive them, in order."""

    def __init__(self, task: Task) -> None:
        super().__init__(task)
        self._lengths: dict[frozenset[str], Value] = {}
        self._directions: dict[tuple[str, str], Value] = {}
        self.unnamed_radii = UnnamedRadii(task.stated_radii)
        self._shown: dict[AngleForm, Value] = {}  # directions by given angles that have a line
        self._coordinates: dict[str, Pair] = {}
        plan, ways = task.form.plan, placed_by_angles(task.form)
        order = (*plan.placing, *(ways or plan.together), *plan.later)
        self.read({name: self._placed(name, ways.get(name)) for name in order})
        self._ways = ShortestPaths(self, self.places)

    def _placed(self, point: str, way: Way | None) -> LocatedPoint:
        """The point as its construction tells it, whose stem the module has; or by another way."""
        template = self.task.form.points[point]
        stem, fields = way or (template.component.__module__.rpartition(".")[2], template.fields)
        return derivation(stem)(self, point, fields)

    # What is known.

    def has_direction(self, start: str, end: str) -> bool:
        """Whether a direction is given or worked out."""
        if (start, end) in self._directions or (end, start) in self._directions:
            return True
        rays = [atom for atom, _ in self.form(start, end).parts if isinstance(atom, tuple)]
        return all(set(ray) != {start, end} and self.has_direction(*ray) for ray in rays)

    def has_length(self, start: str, end: str) -> bool:
        """Whether a length is given or worked out."""
        return frozenset((start, end)) in self._lengths or self.stated(start, end) is not None

    def has_coordinates(self, *points: str) -> bool:
        """Whether coordinates are worked out."""
        return all(point in self._coordinates for point in points)

    # Lengths.

    def length(self, start: str, end: str) -> Value:
        """The distance of two points."""
        key = frozenset((start, end))
        if key not in self._lengths:
            self._lengths[key] = self._entered(Name("length", start, end), "length", self._length(start, end))
        return self._lengths[key]

    def _length(self, start: str, end: str) -> Expression:
        stated = self._radius(start, end) or self.stated(start, end)
        if stated is None:
            low, high = self.ordered(start, end)
            stated = self.places[high].share(low)
        return self._worked_length(start, end) if stated is None else stated

    def _radius(self, start: str, end: str) -> Value | None:
        """The distance of a point of a disc from its centre, if that is the radius in the figure."""
        exact = abs(self.vector(start, end))
        for disc in self.task.form.figure.discs:
            on_disc = disc.centre in (start, end) and {start, end} <= set(self.task.form.bodies.get(disc.body, ()))
            if on_disc and abs(self.read_length(disc.radius).number(True) - exact) < CLOSE * exact:
                return self.radius(disc.centre, exact, disc.body)
        return None

    def _worked_length(self, start: str, end: str) -> Expression:
        """A length that is not given: of its construction, or of a triangle."""
        low, high = self.ordered(start, end)
        place = self.places[high]
        own = place.length(low) if low in place.neighbours() else None
        return own if own is not None else trigonometry.length_of(self, self._triangle(low, high), (low, high))

    def defined(self, start: str, end: str, expression: Expression) -> Value:
        """A distance that is made of others, as that of two points of contact on a diameter."""
        key = frozenset((start, end))
        if key not in self._lengths:
            self._lengths[key] = self._entered(Name("length", start, end), "length", expression)
        return self._lengths[key]

    def radius(self, centre: str, exact: float, body: str) -> Value:
        """The radius of a body's circle about a point, by its disc in the figure."""
        key = frozenset((centre, f"{exact:.9g}", f"radius of {body}"))
        if key not in self._lengths:
            found = (self.read_length(disc.radius) for disc in self.task.form.figure.discs_of(body, centre))
            near = (item for item in found if abs(item.number(True) - exact) < CLOSE * exact)
            self._lengths[key] = self._radius_by(next(near, None), body, exact)
        return self._lengths[key]

    def _radius_by(self, drawn: Expression | None, body: str, exact: float) -> Value:
        """A radius by that of a disc in the figure, if there is one."""
        if isinstance(drawn, Value):
            return self._taken(drawn)
        if drawn is None or isinstance(drawn, Constant):  # a number needs no line
            return self.unnamed_radii.of(body, exact if drawn is None else drawn.number(True))
        name = self.unnamed_radii.named(body, exact)
        self.say("radius", radius=name, body=Body(body))
        return self._entered(name, "length", drawn)

    # Directions.

    def direction(self, start: str, end: str) -> Value:
        """The angle of the ray from one point to another with the x axis (degrees, counter-clockwise, above -180)."""
        if (start, end) not in self._directions:
            self._directions[start, end] = self._direction(start, end)
        return self._directions[start, end]

    def _direction(self, start: str, end: str) -> Value:
        name = Name("direction", start, end)
        if (end, start) in self._directions:
            return self.turned(self._directions[end, start], 180.0, name)
        form = self.form(start, end)
        if form.parts == (((start, end), 1.0),) and form.constant % 360.0 == 0:
            if self.is_drawn(start, end):
                return self._drawn(name)
            return self._entered(name, "angle", self._worked_direction(start, end))
        if len(form.parts) == 1 and form.constant % 180.0 == 0 and isinstance(ray := form.parts[0][0], tuple):
            return self.turned(self.direction(*ray), form.constant, name)
        return self._given_direction(name, form)

    def _drawn(self, name: Name) -> Value:
        """A direction that only the drawing shows."""
        number = self.bearing(name.of, name.about)
        value = Value(name, "angle", number, Constant(number, "angle"))
        self.say("drawn", segment=Segment(name.of, name.about))
        self.items.append(Derived(value, symbolic=False, numeric=False))
        return value

    def _given_direction(self, name: Name, form: AngleForm) -> Value:
        """A direction by given angles, or by a direction that was shown before and fewer angles."""
        reference = self.places[self.ordered(name.of, name.about)[1]].reference()
        if len(form.parts) > _INLINE and reference is not None:
            self.direction(*reference)
        for known, value in self._shown.items():
            if known.is_along(form):
                return self.turned(value, form.constant - known.constant, name)
        best = min(self._shown, key=lambda known: len(form.minus(known).parts), default=form)
        rest = form.minus(best)
        if best is not form and len(rest.parts) + 1 < len(form.parts):
            expression = self.angle(rest, ((1, self._shown[best]),))
        else:
            expression = self.angle(form)
        value = self._entered(name, "angle", expression)
        if form.parts:
            self._shown[form] = value
        return value

    def _worked_direction(self, low: str, high: str) -> Expression:
        place = self.places[high]
        own = place.direction(low) if low in place.neighbours() and not self.has_coordinates(low, high) else None
        return own if own is not None else trigonometry.direction_of(self, self._triangle(low, high), (low, high))

    def stated_angle(self, stated: object, way: complex) -> Value:
        """The direction of a line that the family gives by an angle, to the side of ``way`` (paper)."""
        if isinstance(stated, FamilyExpression):
            form = self.on_bases(self.angles.on_paper(self.angles.read(stated)))
            form = form if between(self.number(form), degrees(way)) < 90.0 else form.turned(180.0)
            if form.parts and between(self.number(form), degrees(way)) < _SAME:
                expression = self.angle(form)
                return Value(None, "angle", expression.number(True), expression)
        return Value(None, "angle", degrees(way))

    @staticmethod
    def turned(angle: Value, by: float, name: Name | None = None) -> Value:
        """A direction turned by so many degrees, between -180 and 180."""
        if by % 360.0 == 0:
            return angle
        exact = normal_angle(angle.exact + by)
        shift = short(exact - angle.exact)
        sign = 1 if shift >= 0 else -1
        depends = angle.expression is not None or (angle.name is not None and angle.name.kind == "parameter")
        expression = Total(((1, angle), (sign, Constant(abs(shift), "angle")))) if depends else None
        return Value(name, "angle", exact, expression)

    def angle(self, form: AngleForm, extra: Sequence[Signed] = ()) -> Expression:
        """A sum of angles as an expression between -180 and 180 degrees."""
        return trigonometry.angle_of(self, form, extra)

    def atom(self, atom: Atom) -> Value:
        """A given angle or the direction of a ray."""
        if isinstance(atom, Value):
            return atom
        return self._taken(self.angles.value(atom)) if isinstance(atom, str) else self.direction(*atom)

    def taken_apart(self, form: AngleForm) -> AngleForm:
        """A sum of angles with directions taken apart into given angles, corners of triangles and numbers."""
        found = AngleForm((), form.constant)
        for atom, count in form.parts:
            found = found.plus(angle_sum(self.atom(atom)), count)
        return found

    def trigonometric(self, function: str, form: AngleForm) -> tuple[int, Expression | None]:
        """A cosine or sine: its sign and its expression, None for one; sign 0 for zero."""
        return trigonometry.reduced(self, function, form)

    def projected(self, function: str, legs: Iterable[Leg], axis: AngleForm) -> list[Signed]:
        """Projections of legs on an axis (``cos``) or across it to the left (``sin``)."""
        return trigonometry.projected(self, function, legs, axis)

    # Ways.

    def way(self, start: str, end: str, before: str = "") -> list[Leg]:
        """The way between two points, legs along one line added; over points placed ``before`` another one."""
        return collected(self._ways.legs(start, end, before), self.nothing)

    def _triangle(self, start: str, end: str) -> list[Leg]:
        """The way between two points, or the differences of their coordinates where it is no triangle."""
        legs = self.way(start, end)
        oblique = sum(1 for leg in legs if leg.form.parts)
        known = self.has_coordinates(start, end)
        if len(legs) > _INLINE and oblique >= _INLINE and not known:
            legs = trigonometry.right_triangle(self, legs, (start, end)) or legs
        if (len(legs) > _INLINE and (oblique >= _INLINE or known)) or (len(legs) == _INLINE and known):
            right, up = self.differences(self.coordinates(end), self.coordinates(start))
            legs = collected((Leg(right, _X), Leg(up, _Y)), self.nothing)
        return legs

    def legs_to(self, point: str, other: str) -> tuple[Leg, ...]:
        """The way from a neighbour, or the origin, to a point."""
        if other == ORIGIN and (not self.is_given(point) or self.has_coordinates(point)):
            x, y = self.coordinates(point)
            return (Leg(x, _X), Leg(y, _Y))
        return self.places[point].legs(other)

    # Coordinates.

    def coordinates(self, point: str) -> Pair:
        """The coordinates of a point on paper."""
        if point not in self._coordinates:
            self.enter(point, self.places[point].coordinates() or self._from_neighbour(point))
        return self._coordinates[point]

    def enter(self, point: str, pair: Pair) -> None:
        """Note coordinates that were found together with others."""
        self._coordinates[point] = pair

    def _from_neighbour(self, point: str) -> Pair:
        """``x = x_A + AB cos phi``, ``y = y_A + AB sin phi``."""
        place = self.places[point]
        others = place.neighbours()
        known = (name for name in others if name == ORIGIN or self.has_direction(name, point))
        other = next(known, others[0])
        start = () if other == ORIGIN else self.coordinates(other)
        legs = place.legs(other)
        x, y = (
            summed([*((1, v) for v in start[i : i + 1] if v.exact != 0), *self.projected(function, legs, _X)])
            for i, function in enumerate(("cos", "sin"))
        )
        pair = self.located(Name("x", point), x), self.located(Name("y", point), y)
        self.show(pair)
        return pair

    @staticmethod
    def differences(second: Pair, first: Pair) -> tuple[Expression, Expression]:
        """Differences of coordinates; zeros are left out."""
        x, y = (
            summed((sign, value) for sign, value in ((1, b), (-1, a)) if value.exact != 0)
            for b, a in zip(second, first, strict=True)
        )
        return x, y
