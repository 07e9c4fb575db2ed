"""Worked cases of a family (``cases.toml``): given data, exact and printed results, source, errata."""

from __future__ import annotations

from collections.abc import Mapping
from decimal import Decimal
from typing import Any

from msgspec import Struct

from variantgen.errors import InputError, Problem, nearest
from variantgen.families.family import Family, Form
from variantgen.families.parameters.amounts import amount
from variantgen.families.quantities import parse_quantity
from variantgen.families.reading.files import CASES
from variantgen.mechanism.motion import Motion
from variantgen.mechanism.solving.solve import solve
from variantgen.tables import Table, read_toml

# Rounding of the arithmetic on well-conditioned cases, relative to the largest expected value of the same kind.
AGREES = 1e-9


class Case(Struct, frozen=True):
    """One worked case. ``given`` is in SI; ``exact`` and ``printed`` are in the printed units of the family.

    ``magnitudes``: the source states no signs, so absolute values are compared. ``erratum`` says what is wrong in
    the source where ``printed`` differs from ``exact``.
    """

    id: str
    source: str
    form: Form
    given: Mapping[str, float]
    exact: Mapping[str, float]
    printed: Mapping[str, float]
    magnitudes: bool = False
    note: str = ""
    erratum: str = ""

    def motion(self) -> Motion:
        """The solved case."""
        return solve(self.form.scene(self.form.values(self.given)), 2, self.form.plan)

    def computed(self, length_unit: str) -> dict[str, float]:
        """What the solver finds for the expected quantities, in printed units."""
        motion = self.motion()
        found = {}
        for name in self.exact:
            quantity = parse_quantity(name, self.form.sample)
            value = quantity.unit(length_unit).from_si(float(quantity.value(motion)[0]))
            found[name] = abs(value) if self.magnitudes else value
        return found

    def deviations(self, length_unit: str) -> dict[str, float]:
        """Differences from the exact values, relative to the largest exact value of the same kind and letter."""
        computed = self.computed(length_unit)
        scale = max((abs(value) for value in self.exact.values()), default=1.0) or 1.0
        return {name: abs(computed[name] - value) / scale for name, value in self.exact.items()}


def load_cases(family: Family) -> list[Case]:
    """The worked cases of a family, none if it has no file of them. Raises InputError."""
    path = family.folder / CASES if family.folder else None
    if path is None or not path.is_file():
        return []
    problems: list[Problem] = []
    top = Table(read_toml(path), "", problems)
    cases = [_case(table, family) for table in top.tables("case")]
    top.finish()
    if problems:
        raise InputError(problem.located(str(path)) for problem in problems)
    return [case for case in cases if case]


def _case(table: Table, family: Family) -> Case | None:
    before = len(table.problems)
    name = table.need("id", str, "")
    source = table.need("source", str, "")
    form_name = table.take("form", str, next(iter(family.forms)))
    if form_name not in family.forms:
        table.problem("unknown form", "form", form_name, nearest(form_name, family.forms))
        return None
    form = family.forms[form_name]
    given = _given(table.table("set"), form)
    exact, printed = (_numbers(table.table(key), form, family.length_unit) for key in ("exact", "printed"))
    if not exact and not printed:
        table.problem("missing, expected at least one known result", "exact")
    case = Case(
        name, source, form, given, exact, printed,
        table.take("magnitudes", bool, False), table.take("note", str, ""), table.take("erratum", str, ""),
    )  # fmt: skip
    table.finish()
    return case if len(table.problems) == before else None


def _given(table: Table, form: Form) -> dict[str, float]:
    found: dict[str, float] = {}
    for name, parameter in form.parameters.items():
        value: Any = table.need(name, (int, Decimal, str), 0, "a number, an expression or a word")
        if parameter.unit is None:
            if value not in parameter.words:
                table.problem("unknown word", name, value, nearest(str(value), parameter.words))
                continue
            found[name] = float(parameter.printed[parameter.words.index(str(value))])
        else:
            with table.collecting(name):
                found[name] = amount(value, parameter.unit) * parameter.unit.to_si(Decimal(1))
    table.finish()
    return found


def _numbers(table: Table, form: Form, length_unit: str) -> dict[str, float]:
    found = {}
    for name in table.data:
        with table.collecting(name):
            unit = parse_quantity(name, form.sample, name).unit(length_unit)
            value: Any = table.take(name, (int, Decimal, str), 0, "a number or an expression")
            found[name] = amount(value, unit)
    return found
