"""What a number in a file means: a bare one is in the printed unit, whatever names its unit keeps it."""

from __future__ import annotations

from decimal import Decimal

from variantgen.errors import InputError, Problem
from variantgen.families.parameters.dimensions import dimension_name
from variantgen.families.parameters.expressions import parse
from variantgen.families.parameters.plain_angles import Unknown, kind_of
from variantgen.families.parameters.units import Unit, checked, is_number, parse_value

_PURE, _LENGTH = (0, 0), (1, 0)


def amount(value: int | Decimal | str, unit: Unit) -> float:
    """A number, ``"30 cm"`` or arithmetic without names, in the given unit.

    ``"40 * sqrt(2)"`` is bare, so it is in the unit; ``"50 * cm + 20 * cm"`` and ``"30 * deg"`` say theirs and are
    converted. Raises InputError for another dimension and for what could be meant in two ways (``"pi / 3"`` degrees).
    """
    if not isinstance(value, str):
        return float(checked(Decimal(value), ""))
    if is_number(value):
        return float(parse_value(value, unit, ""))
    expression = parse(value)
    if expression.names:
        raise InputError(Problem("expected numbers only", value=value))
    number, dimension = float(expression.value({})), expression.dimension({}) or _PURE
    if dimension == _LENGTH and unit.measures == "length":
        return unit.from_si(number)
    if dimension != _PURE:
        raise InputError(
            Problem(
                f"is {dimension_name(dimension)}, expected a number of {unit.name}",
                value=value,
                remedy=f"leave the units out, a bare number is in {unit.name}",
            )
        )
    kind = kind_of(expression, {})
    if unit.measures == "angle" and kind is Unknown.ANGLE:
        return unit.from_si(number)
    if unit.name == "deg" and isinstance(kind, frozenset) and expression.uses("pi"):
        remedy = f'write "{value} / deg" or the degrees'
        raise InputError(Problem("is in radians, degrees are due", value=value, remedy=remedy))
    return number
