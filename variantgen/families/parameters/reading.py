"""Reading of the ``[parameters]`` table: grids of printed values."""

from __future__ import annotations

import keyword
import re
from collections.abc import Sequence
from decimal import Decimal
from typing import Any

from msgspec.structs import replace

from variantgen.errors import InputError, Problem, nearest
from variantgen.families.parameters.dimensions import CONSTANTS
from variantgen.families.parameters.expressions import FUNCTIONS
from variantgen.families.parameters.parameter import Parameter
from variantgen.families.parameters.units import UNITS, Unit, checked, parse_value, unit, usual_name
from variantgen.limits import VALUES
from variantgen.tables import Table

_PLAIN = re.compile(r"[\s\d.eE+-]*")  # a number in quotes needs none
_NAME = re.compile(r"[A-Za-z][A-Za-z0-9_]{0,30}")


def read_parameter(parent: Table, name: str, value: Any) -> Parameter | None:
    """One parameter; None (and a problem noted) if it is wrong.

    ``{ unit, from, to, step }``, ``{ unit, values = [...] }`` or ``{ choices = { word = number, ... } }``.
    """
    before = len(parent.problems)
    with parent.collecting(name):
        check_name(name)
    if len(parent.problems) > before:
        return None
    table = Table(value, parent.key(name), parent.problems)
    symbol = table.take("symbol", str, name)
    constant, silent = table.take("constant", bool, False), table.take("silent", bool, False)
    parameter = _choices(table, name) if "choices" in table.data else _grid(table, name, symbol)
    parameter = replace(parameter, constant=constant, silent=silent)
    table.finish()
    return parameter if len(parent.problems) == before else None


def check_name(name: str) -> None:
    """Raise InputError if a parameter or derived quantity cannot have this name."""
    if not _NAME.fullmatch(name):
        raise InputError(Problem("a name is a letter followed by letters, digits, underscores", value=name))
    if name in CONSTANTS or name in FUNCTIONS or keyword.iskeyword(name):
        raise InputError(
            Problem("is a word of the expression language", value=name, remedy=f"choose another name, {name}_1 say")
        )


def _choices(table: Table, name: str) -> Parameter:
    choices = table.take("choices", dict, {}, "a table like { left = 1, right = -1 }")
    wrong = [
        word
        for word, number in choices.items()
        if isinstance(number, bool) or not isinstance(number, int | Decimal) or not _is_sound(number)
    ]
    if wrong or not choices:
        table.problem("expected a number for each word", "choices", choices)
        choices = {"": 0}
    return Parameter(name, None, tuple(Decimal(n) for n in choices.values()), tuple(choices), name)


def choose_words(parameter: Parameter, words: Sequence[Any], key: str) -> Parameter:
    """A choice parameter with some of its words only. Raises InputError."""
    if not words:
        raise InputError(Problem("expected at least one word", key=key, remedy="of: " + ", ".join(parameter.words)))
    for word in words:
        if word not in parameter.words:
            raise InputError(
                Problem("unknown word", key=key, value=str(word), remedy=nearest(str(word), parameter.words))
            )
    kept = [i for i, word in enumerate(parameter.words) if word in words]
    return replace(
        parameter,
        printed=tuple(parameter.printed[i] for i in kept),
        words=tuple(parameter.words[i] for i in kept),
    )


def _grid(table: Table, name: str, symbol: str) -> Parameter:
    unit_name = table.need("unit", str, "1", "a unit: " + ", ".join(UNITS))
    with table.collecting("unit"):
        unit(unit_name)
    measured = UNITS.get(usual_name(unit_name), UNITS["1"])
    values = _listed(table, measured) if "values" in table.data else _stepped(table, measured)
    return Parameter(name, measured, values, (), symbol)


def _listed(table: Table, measured: Unit) -> tuple[Decimal, ...]:
    """The listed values: numbers, or texts like "2 ft" and "5/3"."""
    values = table.take("values", list, [], "a list of numbers")
    read = [_read(value, measured) for value in values]
    wrong = [v for v in read if isinstance(v, bool) or not isinstance(v, int | Decimal) or not _is_sound(v)]
    if wrong or not values:
        remedy = ""
        if any(isinstance(value, str) for value in wrong):
            remedy = f'write each as a number, or as "2 {measured.name}" or "5/3"; an expression belongs into [derived]'
        table.problem("expected a list of numbers", "values", values, remedy)
        return (Decimal(1),)
    return tuple(dict.fromkeys(Decimal(v) for v in read))


def _read(value: Any, measured: Unit) -> Any:
    """A text with a number and a unit as a number in this unit; anything else as it is."""
    try:
        return parse_value(value, measured, "") if isinstance(value, str) and not _PLAIN.fullmatch(value) else value
    except InputError:
        return value


def _stepped(table: Table, measured: Unit) -> tuple[Decimal, ...]:
    numbers = {}
    for key in ("from", "to", "step"):
        if key not in table.data:
            table.problem("missing, expected a number", key)
        table.data = {**table.data, key: _read(table.data.get(key, 1), measured)}
        value = table.number(key, 1)
        if not _is_sound(value):
            table.problem("expected a number of ordinary size", key, str(value))
            value = Decimal(1)
        numbers[key] = value
    low, high, step = numbers["from"], numbers["to"], numbers["step"]
    if step <= 0 or high < low:
        table.problem(
            "an empty range", "", f"from {low} to {high} step {step}", "from must not exceed to, step is above 0"
        )
        return (low,)
    count = int((high - low) / step) + 1
    if count > VALUES:
        table.problem(f"more than {VALUES} values", "step", str(step), "take a larger step")
        return (low,)
    return tuple(low + i * step for i in range(count))


def _is_sound(value: int | Decimal) -> bool:
    try:
        checked(Decimal(value), "")
    except InputError:
        return False
    return True


def unknown_name(name: str, known: list[str], text: str) -> Problem:
    """The problem of an expression that uses a name that is no parameter."""
    remedy = nearest(name, known) if known else "no names are known: declare it in [parameters] or [derived]"
    return Problem("unknown name in an expression", value=f"{name} in {text}", remedy=remedy)
