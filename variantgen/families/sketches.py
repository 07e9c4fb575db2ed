"""Curves over a turn of the crank that are to be sketched in an empty grid: which quantities have one."""

from __future__ import annotations

from collections.abc import Sequence

from msgspec.structs import replace

from variantgen.errors import InputError, Problem
from variantgen.families.family import Family, Form
from variantgen.families.quantities import parse_quantity
from variantgen.families.quantities.kind import MAX
from variantgen.families.rate_graphs import with_graph


def check_sketch(form: Form, names: Sequence[str], key: str) -> None:
    """Raise InputError for a quantity that has no curve over a turn: of what has extremes there is one."""
    problems: list[Problem] = []
    for number, name in enumerate(names, start=1):
        place = f"{key}[{number}]"
        try:
            parse_quantity(MAX + name, form.sample, place)
        except InputError as error:
            remedy = error.problems[0].remedy
            problems.append(Problem("has no curve over a turn of the crank", key=place, value=name, remedy=remedy))
    if problems:
        raise InputError(problems)


def with_curves(family: Family, sketch: Sequence[str], graph: bool) -> Family:
    """The family with curves to be sketched and, if wished, a rate that a ``graph`` tells. Raises InputError."""
    return with_sketch(with_graph(family) if graph else family, sketch)


def with_sketch(family: Family, names: Sequence[str]) -> Family:
    """The family with curves to be sketched; as it is without any. Raises InputError as :func:`check_sketch` does."""
    if not names:
        return family
    for form in family.forms.values():
        check_sketch(form, names, "sketch")
    forms = {
        name: replace(form, figure=replace(form.figure, sketch=tuple(names))) for name, form in family.forms.items()
    }
    return replace(family, forms=forms)
