"""A point that the conditions of the scene place together with others: their equations and the solution."""

from __future__ import annotations

from collections.abc import Mapping
from typing import Any, ClassVar

from variantgen.algebra.expression import Constant, Expression, Value, cos, sin
from variantgen.algebra.name import Name
from variantgen.algebra.normal_form import product, squared, summed
from variantgen.mechanism.conditions.angle import LinkAngle
from variantgen.mechanism.conditions.distance import Distance
from variantgen.mechanism.conditions.line import PointOnLine
from variantgen.methods.geometry.angles import AngleForm
from variantgen.methods.geometry.constructed_point import ConstructedPoint
from variantgen.methods.geometry.legs import Leg
from variantgen.methods.geometry.located_point import ORIGIN, Pair
from variantgen.methods.steps.step import Derived, EquationLine, Point


class Derivation(ConstructedPoint, frozen=True):
    """A point of a group of links that has no solution in closed form."""

    in_system: ClassVar[bool] = True

    def neighbours(self) -> tuple[str, ...]:
        """The origin: by its coordinates."""
        return (ORIGIN,)

    def legs(self, other: str) -> tuple[Leg, ...]:
        """The coordinates, along the axes of the paper."""
        x, y = self.geometry.coordinates(self.point)
        return (Leg(x, AngleForm()), Leg(y, AngleForm((), 90.0)))

    def coordinates(self) -> Pair:
        """The coordinates of all points placed together, with the equations that they satisfy."""
        geometry = self.geometry
        together = [name for name, item in geometry.task.form.points.items() if item.component is type(self.item)]
        known = {name: geometry.coordinates(name) for name in _others(geometry.task.form.conditions, together)}
        geometry.say("together", points=tuple(Point(name) for name in together))
        led = self._led(known)
        z = geometry.task.now.z
        found = {
            name: (
                led.get(Name("x", name)) or geometry.solution(Name("x", name), z[name].real),
                led.get(Name("y", name)) or geometry.solution(Name("y", name), z[name].imag),
            )
            for name in together
        }
        free = (item for item in geometry.task.form.conditions if self._axis(item, known) is None)
        geometry.items += [self._equation(item, known | found) for item in free]
        geometry.say("chosen", False)
        for name, pair in found.items():
            sought = (value for value in pair if value not in led.values())
            geometry.items += [Derived(value, symbolic=False, numeric=False) for value in sought]
            geometry.enter(name, pair)
        return found[self.point]

    def _led(self, known: Mapping[str, Pair]) -> dict[Name, Value]:
        """Coordinates that lines along an axis of the paper through known points give at once, with their lines."""
        found = {}
        for condition in self.geometry.task.form.conditions:
            axis = self._axis(condition, known)
            if axis is None:
                continue
            fixed = known[condition.fields["through"]][axis]
            name = Name("xy"[axis], condition.fields["point"])
            value = found[name] = self.geometry.located(name, fixed)
            self.geometry.items.append(Derived(value, symbolic=bool(value.exact), numeric=bool(value.exact)))
        return found

    def _axis(self, condition: Any, known: Mapping[str, Pair]) -> int | None:
        """Which coordinate (0 x, 1 y) a line along an axis keeps constant; None for other conditions."""
        fields = condition.fields
        if (
            condition.component is not PointOnLine
            or fields.get("towards") is not None
            or fields["through"] not in known
        ):
            return None
        angle = self.geometry.number(self.geometry.angles.on_paper(self.geometry.angles.read(fields.get("angle"))))
        return None if angle % 90.0 else (1 if angle % 180.0 == 0 else 0)

    def _equation(self, condition: Any, at: Mapping[str, Pair]) -> EquationLine:
        """A distance as the equation of a circle, a line as proportional differences of coordinates."""
        geometry, fields = self.geometry, condition.fields
        if condition.component is LinkAngle:
            return self._angle(condition, at)
        if condition.component is Distance:
            squares = squared(_gap(at[fields["end"]], at[fields["start"]]))
            return EquationLine(squares, geometry.read_length(fields["length"]) ** 2)
        start = at[fields["through"]]
        right, up = _gap(at[fields["point"]], start)
        if fields.get("towards") is not None:
            run, rise = _gap(at[fields["towards"]], start)
            return EquationLine(right * rise, up * run)
        line = geometry.angles.on_paper(geometry.angles.read(fields.get("angle")))
        angle = geometry.angle(line)
        return EquationLine(right * sin(angle), up * cos(angle))

    def _angle(self, condition: Any, at: Mapping[str, Pair]) -> EquationLine:
        """Perpendicular links by their scalar product, parallel ones by their vector product, others by both."""
        geometry, fields = self.geometry, condition.fields
        (x, y), (u, v) = (_gap(at[end], at[start]) for start, end in (fields["first"], fields["second"]))
        along = ((1, product(x, u)), (1, product(y, v)))  # lengths times the cosine, times the sine of the angle
        across = ((1, product(x, v)), (-1, product(y, u)))
        form = geometry.angles.relative(geometry.angles.read(fields["size"]))
        size = geometry.number(form) % 180.0
        if size == 90.0:
            return EquationLine(summed(along), summed(()))
        if size == 0.0:
            return EquationLine(summed(across), summed(()))
        angle = geometry.angle(form)
        return EquationLine(summed(across) * cos(angle), summed(along) * sin(angle))


def _gap(second: Pair, first: Pair) -> tuple[Expression, Expression]:
    """Differences of coordinates; what is still unknown is written even where it turns out to be zero."""
    x, y = (
        summed((sign, v) for sign, v in ((1, b), (-1, a)) if v.exact != 0 or isinstance(v.expression, Constant))
        for b, a in zip(second, first, strict=True)
    )
    return x, y


def _others(conditions: Any, together: list[str]) -> list[str]:
    """Points placed before that the conditions name."""
    fields = [field for item in conditions for field in item.fields.values()]
    names = [
        name for field in fields for name in (field if isinstance(field, tuple) else (field,)) if isinstance(name, str)
    ]
    return [name for name in dict.fromkeys(names) if name not in together]
