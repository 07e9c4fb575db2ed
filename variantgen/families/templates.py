"""Reading of constructions, conditions, joints and drivers: ``{ kind = { field = value, ... } }``."""

from __future__ import annotations

import re
from collections.abc import Callable
from decimal import Decimal
from typing import Any

from msgspec import Struct

from variantgen.errors import InputError, Problem, nearest
from variantgen.families.family import ComponentTemplate
from variantgen.families.parameters.expressions import FamilyExpression, number
from variantgen.families.parameters.units import UNITS, Unit, checked, is_number, parse_value
from variantgen.mechanism.component import FieldSpec, discover, field_specs
from variantgen.mechanism.constructions.near import Near
from variantgen.tables import Table, shown

_WORD = re.compile(r"[A-Za-z_]\w*")
_NOTHING = -12  # power of ten below which a number is what rounding left of a zero: 20 * cos(90 deg) = 1.2e-15
_TINY = re.compile(r"[+-]?\d(?:\.\d*)?[eE]-(?:1[3-9]|[2-9]\d)\s*([A-Za-z][A-Za-z0-9/^-]*)?")  # the same as a text


class TemplateReader:
    """Reads components; the classes of a package say which fields there are and what they expect.

    ``expression`` reads an expression of a given dimension, ``length`` is the unit of bare lengths.
    """

    def __init__(self, expression: Callable[[str, str], FamilyExpression], length: Unit) -> None:
        self._expression = expression
        self._length = length

    def read(self, table: Table, package: str) -> ComponentTemplate | None:
        """A component of a package from a table with one kind; None (and a problem noted) if it is wrong."""
        kinds = discover(package)
        if len(table.data) != 1:
            table.problem("expected one kind with its fields", "", ", ".join(table.data), f"known: {', '.join(kinds)}")
            return None
        kind = next(iter(table.data))
        if kind not in kinds:
            table.problem("unknown kind", "", kind, nearest(kind, kinds))
            return None
        return self._fields(table.table(kind), kinds[kind])

    def points(self, table: Table) -> dict[str, ComponentTemplate]:
        """The points; one that is given by the name of another one, ``E = "A"``, lies in its place."""
        others: dict[str, str] = {}

        def read(name: str, value: Any) -> ComponentTemplate | None:
            if isinstance(value, str):
                others[name] = value
                return None
            return self.read(Table(value, table.key(name), table.problems), "variantgen.mechanism.constructions")

        found = table.each(read)
        for name, other in others.items():
            if other in others or other not in table.data:
                table.problem("unknown point, or one without a place of its own", name, other, nearest(other, found))
            elif other in found and found[other].component is Near:
                table.problem("is placed by conditions, so no other point can lie in its place", name, other)
            elif other in found:
                found[name] = found[other]
        return {name: found[name] for name in table.data if name in found}

    def _fields(self, table: Table, component: type[Struct]) -> ComponentTemplate:
        specs = field_specs(component)
        table.expect(*(spec.name for spec in specs))
        fields: dict[str, Any] = {}
        for spec in specs:
            if spec.name not in table.data:
                if spec.required:
                    table.problem(f"missing, expected {spec.expects}", spec.name)
            elif spec.part:
                part: type = spec.part
                named = field_specs(part)[0].name  # "K" is short for { point = "K" }
                items = table.data[spec.name]
                if isinstance(items, list):
                    items = [{named: item} if isinstance(item, str) else item for item in items]
                    table.data = {**table.data, spec.name: items}
                fields[spec.name] = tuple(self._fields(item, part) for item in table.tables(spec.name))
            else:
                with table.collecting(spec.name):
                    fields[spec.name] = self._field(spec, table.data[spec.name])
        for first, second in getattr(component, "either", ()):
            if first in table.data and second in table.data:
                table.problem(f"{first} and {second} both give the direction", second, table.data[second], "keep one")
        table.finish()
        return ComponentTemplate(component, fields)

    def _field(self, spec: FieldSpec, value: Any) -> Any:
        wrong = InputError(Problem(f"expected {spec.expects}", value=shown(value)))
        if spec.flag:
            if not isinstance(value, bool):
                raise wrong
            return value
        if spec.ref:
            names = value if spec.many else [value]
            if (
                not isinstance(names, list)
                or any(not isinstance(n, str) for n in names)
                or (spec.many and len(names) != 2)
            ):
                raise wrong
            return tuple(names) if spec.many else value
        if isinstance(value, bool) or not isinstance(value, int | Decimal | str):
            raise wrong
        if isinstance(value, str) and value in spec.words:
            return number(spec.words[value])
        if spec.words and isinstance(value, str) and _WORD.fullmatch(value):
            try:
                return self._expression(value, spec.dimension)  # a choice may carry such a name
            except InputError:
                raise wrong from None
        return self.quantity(spec.dimension, value)

    def quantity(self, dimension: str, value: int | Decimal | str) -> FamilyExpression:
        """A number in the printed unit of its dimension, a number with a unit, or an expression. Raises InputError."""
        default = self._printed_unit(dimension)
        if not isinstance(value, str):
            return number(default.to_si(checked(_cleaned(Decimal(value)), "")), default.measures)
        if tiny := _TINY.fullmatch(value.strip()):
            value = f"0 {tiny[1] or default.name}"
        if is_number(value):
            return number(default.to_si(parse_value(value, default, "")), default.measures)
        return self._expression(value, dimension)

    def _printed_unit(self, dimension: str) -> Unit:
        """The unit of a bare number in a file: the family's length unit, degrees, seconds."""
        length = self._length.name
        names = {
            "length": length,
            "velocity": f"{length}/s",
            "acceleration": f"{length}/s^2",
            "angle": "deg",
            "time": "s",
            "angular velocity": "rad/s",
            "angular acceleration": "rad/s^2",
        }
        return UNITS[names.get(dimension, "1")]


def _cleaned(value: Decimal) -> Decimal:
    """A number, or the zero that it is but for rounding."""
    return Decimal(0) if value.is_finite() and value and value.adjusted() < _NOTHING else value
