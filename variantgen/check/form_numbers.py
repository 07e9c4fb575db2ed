"""The numbers that stand in the file of a form itself, and the form with others in their place."""

from __future__ import annotations

from collections.abc import Callable, Mapping
from typing import Any

from msgspec import Struct
from msgspec.structs import replace

from variantgen.algebra.expression import (
    Applied,
    Constant,
    Expression,
    Magnitude,
    Raised,
    Ratio,
    SquareRoot,
    Times,
    Total,
    Variable,
)
from variantgen.algebra.values import walk
from variantgen.families.family import ComponentTemplate, Form
from variantgen.families.parameters.expressions import FamilyExpression
from variantgen.families.parameters.units import LENGTHS

# What stands in the place of a part of an expression at a place of the file ("points.A.polar.distance"), or None.
Change = Callable[[Expression, str], Expression | None]
_LENGTHS = {*LENGTHS, "inch"}
SI = {
    "length": "m", "velocity": "m/s", "acceleration": "m/s^2", "angle": "rad", "angular velocity": "rad/s",
    "angular acceleration": "rad/s^2", "time": "s",
}  # fmt: skip


class FileNumber(Struct, frozen=True):
    """A number of a file, in all places that have it: its value there (SI), and what it measures ("" nothing).

    ``places`` count the numbers of the file in the order of :func:`changed_numbers`, ``names`` are as the file names
    them. The values differ in sign at most.
    """

    values: tuple[float, ...]
    measures: str
    places: tuple[int, ...]
    names: tuple[str, ...]

    @property
    def value(self) -> float:
        """The value in the first of the places."""
        return self.values[0]

    @property
    def apart(self) -> list[FileNumber]:
        """The same number place by place."""
        every = zip(self.values, self.places, self.names, strict=True)
        return [FileNumber((value,), self.measures, (place,), (name,)) for value, place, name in every]


def file_numbers(form: Form, left_out: frozenset[str], leave: Callable[[float, str, str], bool]) -> list[FileNumber]:
    """The numbers that stand in a file, those of one size and measure together, but what is to ``leave``.

    That is asked with the value, what it measures and the place; zeros have nothing to do with each other.
    """
    found: dict[tuple[float, str, int], list[tuple[int, float, str]]] = {}
    count = 0

    def note(part: Expression, place: str) -> Expression | None:
        nonlocal count
        size = number_of(part)
        if size is None:
            return None
        if not leave(*size, place):
            value, measures = size
            key = (float(f"{abs(value):.12g}"), measures, 0 if value else count)
            found.setdefault(key, []).append((count, value, place))
        count += 1
        return part

    changed_numbers(form, note, left_out)
    numbers = []
    for (_, measures, _), own in found.items():
        places, values, names = zip(*own, strict=True)
        numbers.append(FileNumber(values, measures, places, names))
    return numbers


def with_numbers(form: Form, left_out: frozenset[str], other: Mapping[int, Callable[[float, str], Expression]]) -> Form:
    """The form with something else in the place of some numbers, made of their value and what they measure."""
    count = 0

    def change(part: Expression, place: str) -> Expression | None:
        nonlocal count
        size = number_of(part)
        if size is None:
            return None
        count += 1
        return other[count - 1](*size) if count - 1 in other else part

    return changed_numbers(form, change, left_out)


def number_of(part: Expression) -> tuple[float, str] | None:
    """The value (SI) of a part of an expression that is one number of the file, and what it measures; else None.

    A number without a unit measures "".
    """
    match part:
        case Constant(value, measures):
            return value, measures if measures in SI else ""
        case Times((factor, Variable(name))) if name == "deg" or name in _LENGTHS:
            if not any(isinstance(own, Variable) for own in walk(factor)):
                return float(FamilyExpression("", part).value({})), "angle" if name == "deg" else "length"
    return None


def changed_numbers(form: Form, change: Change, left_out: frozenset[str] = frozenset()) -> Form:
    """The form with parts of its expressions changed, but those of the derived quantities that are ``left_out``."""

    def read(item: Any, place: str) -> Any:
        if isinstance(item, tuple):
            return tuple(read(part, f"{place}.{i + 1}") for i, part in enumerate(item))
        if isinstance(item, ComponentTemplate):
            kind = item.component.__module__.rpartition(".")[2]
            fields = {field: read(value, f"{place}.{kind}.{field}") for field, value in item.fields.items()}
            return ComponentTemplate(item.component, fields)
        if not isinstance(item, FamilyExpression):
            return item
        where = f'{place} = "{item.text}"' if item.names else place
        return FamilyExpression(item.text, _rewritten(item.tree, lambda part: change(part, where)))

    tables: dict[str, Any] = {
        table: {
            name: item if table == "derived" and name in left_out else read(item, f"{table}.{name}")
            for name, item in getattr(form, table).items()
        }
        for table in ("derived", "points")
    }
    lists = {name: read(getattr(form, name), name) for name in ("conditions", "joints", "drivers")}
    return replace(form, **tables, **lists)


def _rewritten(item: Expression, change: Callable[[Expression], Expression | None]) -> Expression:
    """An expression with those parts replaced for which ``change`` has something else."""
    other = change(item)
    if other is not None:
        return other
    parts = [_rewritten(part, change) for part in item.operands()]
    match item:
        case Total(terms):
            return Total(tuple((sign, part) for (sign, _), part in zip(terms, parts, strict=True)))
        case Times():
            return Times(tuple(parts))
        case Raised(_, exponent):
            return Raised(parts[0], exponent)
        case Applied(function):
            return Applied(function, *parts)
        case Ratio() | SquareRoot() | Magnitude():
            return type(item)(*parts)
    return item
