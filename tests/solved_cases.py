"""Worked cases of the catalogue as variants, so that their solutions can be written out."""

from __future__ import annotations

from decimal import Decimal

from variantgen.families.asking import read_ask
from variantgen.families.family import Family
from variantgen.families.quantities import Quantity, parse_quantity
from variantgen.families.reading.cases import Case, load_cases
from variantgen.families.reading.folders import family_names
from variantgen.families.reading.load import load_family
from variantgen.methods.linkage.problem import Task, task_of
from variantgen.variants.variant import Variant


def every_case() -> list[tuple[Family, Case]]:
    found = []
    for name in family_names():
        family = load_family(name)
        found += [(family, case) for case in load_cases(family)]
    return found


def case_of(family_name: str, case_id: str) -> tuple[Family, Case]:
    family = load_family(family_name)
    return family, next(case for case in load_cases(family) if case.id == case_id)


def variant_of(family: Family, case: Case) -> Variant:
    printed = {}
    for name, parameter in case.form.parameters.items():
        if parameter.unit is None:
            printed[name] = parameter.printed[[float(p) for p in parameter.printed].index(case.given[name])]
        else:
            printed[name] = Decimal(repr(round(parameter.unit.from_si(case.given[name]), 13)))
    return Variant(family, case.form, printed)


def quantities(case: Case, names: tuple[str, ...] | None = None) -> list[Quantity]:
    if names is None:
        return read_ask(case.form, None)
    return [parse_quantity(name, case.form.sample) for name in names]


def task(family: Family, case: Case, names: tuple[str, ...] | None = None) -> Task:
    return task_of(variant_of(family, case), case.motion(), 0, quantities(case, names))
