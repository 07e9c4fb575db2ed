"""Narrowing of a family: fixed parameters, smaller ranges, chosen forms."""

from __future__ import annotations

from collections.abc import Mapping, Sequence
from decimal import Decimal
from functools import lru_cache
from typing import Any

import numpy as np
from msgspec import Struct
from msgspec.structs import replace

from variantgen.errors import InputError, Problem, nearest
from variantgen.families.family import Family, Form
from variantgen.families.found_instant import with_found_instant
from variantgen.families.length_units import check_length_unit, in_unit
from variantgen.families.nice import hand_friendly, no_nice_forms
from variantgen.families.parameters.parameter import Parameter
from variantgen.families.parameters.reading import choose_words
from variantgen.families.parameters.units import UNITS, checked, parse_value
from variantgen.families.rate_graphs import read_from_graph


def restrict(
    family: Family,
    fixed: Mapping[str, Any] | None = None,
    ranges: Mapping[str, Any] | None = None,
    forms: Sequence[str] = (),
    nice: bool = False,
    beyond: bool = False,
    units: str = "",
) -> Family:
    """The family with parameters fixed (numbers, "30 cm", or words of a choice), ranges [low, high], forms chosen.

    ``units`` is another unit of length for the data and answers (:mod:`variantgen.families.length_units`). A bare
    number is in the unit that the sheet prints. Fixed values need not lie on the grid, but in its range, unless
    they may lie ``beyond`` it. ``nice``: only hand-friendly variants, of the forms that have any. The same narrowing
    gives the same family again, so that problems which are alike share what is known of their forms. Raises InputError
    naming the key, the value and what is possible.
    """
    fixed, ranges = by_parameter(fixed, "set"), by_parameter(ranges, "range")
    key = repr((sorted(fixed.items()), sorted(ranges.items()), tuple(forms), nice, beyond, units))
    return _restricted(_Narrowing(id(family), key, family, fixed, ranges, tuple(forms), nice, beyond, units))


def by_parameter(given: Mapping[str, Any] | None, key: str) -> dict[str, Any]:
    """What is said of parameters, by their names; numbers, arrays and ranges of Python as numbers and lists.

    A range of steps of one is its lowest and highest value. Raises InputError for what is no table of names.
    """
    given = {} if given is None else given
    if not isinstance(given, Mapping) or any(not isinstance(name, str) for name in given):
        remedy = 'such as {"OA": 30}' if key == "set" else 'such as {"OA": [20, 40]}'
        raise InputError(Problem("expected names of parameters with values", key=key, value=repr(given), remedy=remedy))
    return {name: _plain(value) for name, value in given.items()}


def _plain(value: Any) -> Any:
    """Numbers of numpy as those of Python, arrays, tuples and ranges as lists."""
    if isinstance(value, np.ndarray) and not value.ndim:
        return _plain(value[()])
    if isinstance(value, range) and len(value) > 1 and value.step == 1:
        return [value[0], value[-1]]
    if isinstance(value, np.ndarray | tuple | list | range):
        return [_plain(item) for item in value]
    if isinstance(value, np.floating):
        return float(str(value))  # the decimals that are shown, also of single precision
    return value.item() if isinstance(value, np.generic) else value


class _Narrowing(Struct, frozen=True):
    """How a family is to be narrowed; two narrowings are equal if they say the same of the same family."""

    number: int
    key: str
    family: Family
    fixed: Mapping[str, Any]
    ranges: Mapping[str, Any]
    forms: tuple[str, ...]
    nice: bool
    beyond: bool
    units: str

    def __eq__(self, other: object) -> bool:
        return isinstance(other, _Narrowing) and (self.number, self.key) == (other.number, other.key)

    def __hash__(self) -> int:
        return hash((self.number, self.key))


@lru_cache(maxsize=64)
def _restricted(narrowing: _Narrowing) -> Family:
    """The narrowed family. A narrowing that is kept keeps its family, so that the number of that stays its own."""
    family, fixed, ranges, forms = narrowing.family, narrowing.fixed, narrowing.ranges, narrowing.forms
    if narrowing.units:
        family = in_unit(family, check_length_unit(narrowing.units, "units"))
    if wrong := _wrong_names(family, narrowing):
        raise InputError(wrong)
    chosen = {name: form for name, form in family.forms.items() if not forms or name in forms}
    if narrowing.nice:
        chosen = _hand_friendly(family, chosen)
    problems: list[Problem] = []
    narrowed: dict[str, Form] = {}
    outside: dict[str, list[Problem]] = {}
    for form_name, form in chosen.items():
        parameters = {}
        for name, parameter in form.parameters.items():
            try:
                parameters[name] = _narrow(parameter, fixed, ranges)
            except InputError as error:
                problems += error.problems
                continue
            if name in fixed and parameter.unit is not None and not narrowing.beyond:
                grids = (family.forms[form_name].parameters[name], parameter)
                outside.setdefault(form_name, []).extend(_outside(parameters[name], fixed[name], grids))
        narrowed[form_name] = _with_parameters(form, parameters, bool(problems))
    fitting = [name for name, form in narrowed.items() if not outside.get(name) and set(fixed) <= set(form.parameters)]
    for found in outside.values():
        advice = {"remedy": "choose form = " + " or ".join(f'"{name}"' for name in fitting)} if fitting else {}
        problems += [replace(problem, **advice) for problem in found]
    if problems:
        raise InputError(dict.fromkeys(problems))
    return replace(family, forms=_with_rows(narrowed))


def _wrong_names(family: Family, narrowing: _Narrowing) -> list[Problem]:
    """What is wrong with the names of forms and parameters of a narrowing."""
    fixed, ranges, forms = narrowing.fixed, narrowing.ranges, narrowing.forms
    problems = [
        Problem("unknown form", key="form", value=str(name), remedy=nearest(str(name), family.forms))
        for name in forms
        if name not in family.forms
    ]
    chosen = [form for name, form in family.forms.items() if not forms or name in forms]
    known = {name for form in chosen for name in form.parameters}
    problems += [
        Problem("unknown parameter", key=f"{key}.{name}", value=name, remedy=nearest(name, known))
        for key, table in (("set", fixed), ("range", ranges))
        for name in table
        if name not in known
    ]
    instants = {name for form in chosen for name, parameter in form.parameters.items() if parameter.found}
    remedy = "change instant in [laws]"
    problems += [
        Problem("the instant is found and cannot be set", "", f"set.{name}", name, remedy)
        for name in sorted((fixed.keys() | ranges.keys()) & instants)
    ]
    problems += [
        Problem("is both fixed and given a range", key=f"set.{name}", value=str(value), remedy="remove one")
        for name, value in fixed.items()
        if name in ranges
    ]
    return problems


def _with_parameters(form: Form, parameters: Mapping[str, Parameter], is_faulty: bool) -> Form:
    """The form with narrowed parameters; what follows from them is found, unless some of the family are wrong."""
    narrowed = replace(form, parameters=parameters)
    if form.found_instant and not is_faulty:
        narrowed = with_found_instant(narrowed)
    if form.figure.graph and len(parameters) == len(form.parameters):
        narrowed = read_from_graph(narrowed, form.figure.graph)
    return narrowed


def _hand_friendly(family: Family, forms: Mapping[str, Form]) -> dict[str, Form]:
    """Those of the forms that have hand-friendly variants, drawing only these. Raises InputError if none has."""
    found = {name: hand_friendly(forms[name]) for name in family.nice_forms if name in forms}
    if not found:
        raise InputError(no_nice_forms(replace(family, forms=forms)))
    return found


def _with_rows(forms: Mapping[str, Form]) -> dict[str, Form]:
    """The forms with only the rows that lie on their grids, without forms that have none left. Raises InputError."""
    found, problems = {}, []
    for name, form in forms.items():
        ties = form.ties.within(form.parameters) if form.ties else None
        if ties is None or ties.rows:
            found[name] = replace(form, ties=ties)
        else:
            remedy = f"leave nice out, or leave one of {', '.join(ties.names)} free"
            problems.append(Problem("no hand-friendly variant has these values", key="nice", value=name, remedy=remedy))
    if not found:
        raise InputError(problems)
    return found


def _narrow(parameter: Parameter, fixed: Mapping[str, Any], ranges: Mapping[str, Any]) -> Parameter:
    name = parameter.name
    if name in fixed:
        if parameter.unit is None:
            return choose_words(parameter, [fixed[name]], f"set.{name}")
        return replace(parameter, printed=(_value(parameter, fixed[name], f"set.{name}"),))
    if name not in ranges:
        return parameter
    key, limits = f"range.{name}", ranges[name]
    if parameter.unit is None:
        return choose_words(parameter, limits if isinstance(limits, list) else [limits], key)
    if not isinstance(limits, list) or len(limits) != 2:
        raise InputError(Problem("expected [lowest, highest]", key=key, value=str(limits), remedy=_possible(parameter)))
    low, high = (_value(parameter, limit, key) for limit in limits)
    kept = tuple(value for value in parameter.printed if low <= value <= high)
    if not kept:
        raise InputError(
            Problem(
                "no value of the family's grid lies in this range",
                key=key,
                value=f"[{limits[0]}, {limits[1]}]",
                remedy="the lowest comes first" if low > high else _possible(parameter),
            )
        )
    return replace(parameter, printed=kept)


def _outside(chosen: Parameter, said: Any, grids: Sequence[Parameter]) -> list[Problem]:
    """The problem of a fixed value outside the range of the family (or of its hand-friendly variants), if it is so."""
    value, unit = chosen.printed[0], chosen.unit
    assert unit is not None
    low, high = (choose(choose(grid.si) for grid in grids) for choose in (min, max))
    if _within(unit.to_si(value), low, high):
        return []
    meant = [
        other.name
        for other in UNITS.values()
        if other.measures == unit.measures
        and other.is_metric == unit.is_metric
        and _within(other.to_si(value), low, high)
    ]
    remedy = "take a value in it, or widen it in a family of your own (show and solve take any value)"
    if meant and not isinstance(said, str):
        remedy = f'a bare number is in {unit.name}: did you mean "{said} {meant[0]}"?'
    lowest, highest = (f"{unit.from_si(float(limit)):.6g}" for limit in (low, high))
    message = f"outside the range of the family, {lowest} to {highest} {unit.name}"
    return [Problem(message, key=f"set.{chosen.name}", value=f"{value} {unit.name}", remedy=remedy)]


def _within(value: float, low: float, high: float) -> bool:
    """Whether a value lies between two others, but for rounding."""
    slack = 1e-9 * max(abs(low), abs(high))
    return low - slack <= value <= high + slack


def _value(parameter: Parameter, value: Any, key: str) -> Decimal:
    assert parameter.unit is not None
    found = _decimal(parameter, value, key)
    if parameter.unit.measures == "length" and min(parameter.printed) > 0 >= found:
        raise InputError(Problem("expected a length above 0", key=key, value=str(value), remedy=_possible(parameter)))
    return found


def _decimal(parameter: Parameter, value: Any, key: str) -> Decimal:
    assert parameter.unit is not None
    if isinstance(value, str):
        return parse_value(value, parameter.unit, key)
    if isinstance(value, bool) or not isinstance(value, int | Decimal | float) or not Decimal(value).is_finite():
        raise InputError(Problem("expected a number", key=key, value=str(value), remedy=_possible(parameter)))
    return checked(Decimal(str(value)) if isinstance(value, float) else Decimal(value), key)


def _possible(parameter: Parameter) -> str:
    assert parameter.unit is not None
    values = ", ".join(str(value) for value in parameter.printed[:4])
    more = f", ... {max(parameter.printed)}" if len(parameter.printed) > 4 else ""
    return f"the family draws {values}{more} {parameter.unit.name}"
