"""Variants of the catalogue with data chosen by hand, in the pose of the family (not mirrored, not turned)."""

from __future__ import annotations

from decimal import Decimal

from variantgen.algebra.expression import Value
from variantgen.families.quantities import parse_quantity
from variantgen.families.reading.load import load_family
from variantgen.methods.linkage.problem import task_of
from variantgen.methods.natural_answers import work_out
from variantgen.methods.solution.book import Book
from variantgen.methods.steps.step import Projection, Sentence, Step, TermTable
from variantgen.variants.variant import Variant, solve_variants


def results(family_name: str, form_name: str, ask: str, **data: float) -> dict[str, float]:
    """Values of the quantities named in ``ask``, found by the steps of the solution.

    ``data`` are parameters in their printed units, for choices the number behind the word; others take the first value
    of their grid.
    """
    return {name: value.exact for name, value in _worked(family_name, form_name, ask, **data)[1].items()}


def sentences(family_name: str, form_name: str, ask: str, **data: float) -> list[Sentence]:
    """The sentences of the steps that find the quantities, also those in tables of vectors and in other sentences."""
    found: list[Sentence] = []
    waiting: list[object] = [
        item for step in _worked(family_name, form_name, ask, **data)[0].steps for item in step.items
    ]
    while waiting:
        match waiting.pop(0):
            case Projection(words):
                waiting = [*words, *waiting]
            case TermTable(terms):
                waiting = [*(term.way for term in terms), *waiting]
            case Sentence() as sentence:
                found.append(sentence)
                waiting = [*sentence.facts.values(), *waiting]
    return found


def steps(family_name: str, form_name: str, ask: str, **data: float) -> list[Step]:
    """The steps that find the quantities."""
    return list(_worked(family_name, form_name, ask, **data)[0].steps)


def worked_book(family_name: str, form_name: str, ask: str, **data: float) -> Book:
    """The book in which the quantities were found."""
    return _worked(family_name, form_name, ask, **data)[0]


def worked_geometry(family_name: str, form_name: str, ask: str, **data: float) -> list[Sentence]:
    """The sentences about the position, also those of which the solution needs no line."""
    items = _worked(family_name, form_name, ask, **data)[0].geometry.items
    return [item for item in items if isinstance(item, Sentence)]


def _worked(family_name: str, form_name: str, ask: str, **data: float) -> tuple[Book, dict[str, Value]]:
    """The book of a solution with its steps, and the values that are asked."""
    family = load_family(family_name)
    form = family.forms[form_name]
    assert set(data) <= set(form.parameters)
    printed = {name: parameter.printed[0] for name, parameter in form.parameters.items()}
    printed |= {name: Decimal(repr(value)) for name, value in data.items()}
    variant = Variant(family, form, printed)
    quantities = [parse_quantity(name, form.sample) for name in ask.split()]
    book = Book(task_of(variant, solve_variants([variant], 2), 0, quantities))
    return book, dict(work_out(book))
