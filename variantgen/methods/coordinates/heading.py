"""Directions that change with a coordinate, as angles and as components of vectors."""

from __future__ import annotations

from msgspec import Struct

from variantgen.algebra.expression import Constant, Value, cos, sin
from variantgen.algebra.normal_form import Maybe, added, product
from variantgen.methods.geometry.geometry import normal_angle


class Heading(Struct, frozen=True, eq=False):
    """A direction: an angle that changes, if any, and a constant (degrees)."""

    variable: Maybe
    constant: float

    def ray(self, length: Maybe) -> tuple[Maybe, Maybe]:
        """Components of a vector of that length in this direction; quarter turns are taken out."""
        quarter = round(self.constant / 90.0)
        rest = self.constant - 90.0 * quarter
        angle = self.variable
        if abs(rest) > 1e-9:
            quarter, number = 0, normal_angle(self.constant)
            sign = 1 if number > 0 or angle is None else -1
            angle = added((1, angle), (sign, fixed_number("angle", sign * number)))
        x: Maybe = Constant(1.0) if angle is None else cos(angle)
        y: Maybe = None if angle is None else sin(angle)
        for _ in range(quarter % 4):
            x, y = product(Constant(-1.0), y), x
        return product(x, length), product(y, length)


def fixed_number(measure: str, exact: float) -> Value:
    """A constant of the drawing without a name, printed as a number."""
    return Value(None, measure, exact, Constant(exact))
