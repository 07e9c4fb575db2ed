"""A point that the conditions of the scene place together with others: their equations and the solution."""

from __future__ import annotations

from collections.abc import Mapping
from typing import Any, ClassVar

from variantgen.mechanism.conditions.distance import Distance
from variantgen.methods.angles import AngleForm
from variantgen.methods.expression import Expression, cos, sin
from variantgen.methods.name import Name
from variantgen.methods.placed import ORIGIN, Pair, Placed
from variantgen.methods.step import Point, Statement
from variantgen.methods.sums import Leg, squared, summed


class Construction(Placed):
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
        z = geometry.task.now.z
        found = {
            name: (geometry.solution(Name("x", name), z[name].real), geometry.solution(Name("y", name), z[name].imag))
            for name in together
        }
        equations = [self._equation(item, known | found) for item in geometry.task.form.conditions]
        geometry.say("together", points=tuple(Point(name) for name in together))
        geometry.items += equations
        geometry.say("chosen", False)
        for name, pair in found.items():
            geometry.show(pair)
            geometry.enter(name, pair)
        return found[self.point]

    def _equation(self, condition: Any, at: Mapping[str, Pair]) -> Statement:
        """A distance as the equation of a circle, a line as proportional differences of coordinates."""
        geometry, fields = self.geometry, condition.fields
        if condition.component is Distance:
            squares = squared(geometry.differences(at[fields["end"]], at[fields["start"]]))
            return Statement(squares, geometry.read_length(fields["length"]) ** 2)
        start = at[fields["through"]]
        right, up = geometry.differences(at[fields["point"]], start)
        if fields.get("towards") is not None:
            run, rise = geometry.differences(at[fields["towards"]], start)
            return Statement(right * rise, up * run)
        line = geometry.angles.on_paper(geometry.angles.read(fields.get("angle")))
        return Statement(*_on_line(right, up, geometry.angle(line), geometry.number(line)))


def _on_line(right: Expression, up: Expression, angle: Expression, number: float) -> tuple[Expression, Expression]:
    """``dx sin theta = dy cos theta``; along an axis one difference is zero."""
    nothing = summed(())
    if number % 180.0 == 0:
        return up, nothing
    return (right, nothing) if number % 90.0 == 0 else (right * sin(angle), up * cos(angle))


def _others(conditions: Any, together: list[str]) -> list[str]:
    """Points placed before that the conditions name."""
    names = [field for item in conditions for field in item.fields.values() if isinstance(field, str)]
    return [name for name in dict.fromkeys(names) if name not in together]
