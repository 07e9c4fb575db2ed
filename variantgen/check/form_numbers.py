"""The numbers that stand in the file of a form itself, and the form with others in their place."""

from __future__ import annotations

import itertools
from collections.abc import Callable, Mapping
from typing import Any, NamedTuple

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

_LENGTHS = {*LENGTHS, "inch"}
SI = {
    "length": "m", "velocity": "m/s", "acceleration": "m/s^2", "angle": "rad", "angular velocity": "rad/s",
    "angular acceleration": "rad/s^2", "time": "s",
}  # fmt: skip


class _Number(NamedTuple):
    """A number where it stands in the file ("points.A.polar.distance"), its turn there and size."""

    part: Expression
    nth: int
    place: str
    value: float  # SI
    measures: str  # "" nothing


class FileNumber(Struct, frozen=True):
    """A number of a file, in all places that have it: its value there (SI), and what it measures ("" nothing).

    ``places`` count the numbers of the file from its beginning, ``names`` are as the file names
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
    found: dict[tuple[float, str, int], list[_Number]] = {}

    def note(number: _Number) -> Expression:
        if not leave(number.value, number.measures, number.place):
            size = float(f"{abs(number.value):.12g}")
            key = (size, number.measures, 0 if number.value else number.nth)
            found.setdefault(key, []).append(number)
        return number.part

    _changed(form, left_out, note)
    return [
        FileNumber(
            tuple(number.value for number in own),
            measures,
            tuple(number.nth for number in own),
            tuple(number.place for number in own),
        )
        for (_, measures, _), own in found.items()
    ]


def with_numbers(form: Form, left_out: frozenset[str], other: Mapping[int, Callable[[float, str], Expression]]) -> Form:
    """The form with something else in the place of some numbers, made of their value and what they measure."""

    def change(number: _Number) -> Expression:
        own = other.get(number.nth)
        return own(number.value, number.measures) if own else number.part

    return _changed(form, left_out, change)


def _changed(form: Form, left_out: frozenset[str], change: Callable[[_Number], Expression]) -> Form:
    """The form with its numbers changed one by one, but those of the derived quantities that are ``left_out``."""
    count = itertools.count()

    def of_part(part: Expression, place: str) -> Expression | None:
        size = _size_of(part)
        return change(_Number(part, next(count), place, *size)) if size else None

    return _with_parts(form, left_out, of_part)


def _size_of(part: Expression) -> tuple[float, str] | None:
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


def _with_parts(form: Form, left_out: frozenset[str], change: Callable[[Expression, str], Expression | None]) -> Form:
    """The form with those parts of its expressions replaced for which ``change`` has something else, by their place."""

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
