"""The numbers that a scene states literally, as parameters: what its answers depend on where no data are printed."""

from __future__ import annotations

import math
from collections.abc import Mapping
from decimal import Decimal
from typing import Any

from msgspec.structs import replace

from variantgen.families.family import ComponentTemplate, Form
from variantgen.families.parameters.expressions import FamilyExpression, parse
from variantgen.families.parameters.parameter import Parameter
from variantgen.families.parameters.units import UNITS

_SI = {
    "length": "m", "velocity": "m/s", "acceleration": "m/s^2", "angle": "rad", "angular velocity": "rad/s",
    "angular acceleration": "rad/s^2",
}  # fmt: skip
_SQUARE = 1e-9  # rad: level, upright and zero are no measured angles


def with_literal_parameters(form: Form) -> Form:
    """The form with its literal numbers as parameters of one value each (``literal_1``, ...), beside its own ones.

    Left out are zeros, numbers without a unit (ratios, sides), and angles that are multiples of 90 degrees: they are no
    data that anyone measures or rounds.
    """
    found: dict[str, Parameter] = {}

    def read(item: Any) -> Any:
        if isinstance(item, tuple):
            return tuple(read(part) if isinstance(part, ComponentTemplate) else part for part in item)
        if isinstance(item, ComponentTemplate):
            return ComponentTemplate(item.component, {name: read(value) for name, value in item.fields.items()})
        if not isinstance(item, FamilyExpression) or not _is_datum(item):
            return item
        name = f"literal_{len(found) + 1}"
        printed = Decimal(repr(float(item.value({}))))
        found[name] = Parameter(name, UNITS[_SI[item.measures]], (printed,), symbol=name)
        return parse(name)

    def all_of(table: Mapping[str, ComponentTemplate]) -> dict[str, ComponentTemplate]:
        return {name: read(template) for name, template in table.items()}

    parts = {name: read(getattr(form, name)) for name in ("conditions", "joints", "drivers")}
    points = all_of(form.points)
    return replace(form, points=points, parameters={**form.parameters, **found}, **parts)


def _is_datum(item: FamilyExpression) -> bool:
    if item.measures not in _SI:
        return False
    value = float(item.value({}))
    return abs(math.sin(2 * value)) > _SQUARE if item.measures == "angle" else value != 0
