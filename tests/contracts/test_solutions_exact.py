"""One body over every form of the catalogue: the steps lead to the motion of the solver and to every answer."""

from __future__ import annotations

import math

import pytest

from variantgen.algebra.expression import Value
from variantgen.families.asking import read_ask
from variantgen.families.family import Family, Form
from variantgen.families.quantities import Quantity, parse_quantity
from variantgen.families.reading.folders import family_names
from variantgen.families.reading.load import load_family
from variantgen.families.restrict import restrict
from variantgen.mechanism.motion import Motion
from variantgen.methods.agreement import deviation
from variantgen.methods.linkage.problem import AGREES, task_of
from variantgen.methods.natural_answers import work_out
from variantgen.methods.solution.book import Book
from variantgen.methods.steps.method_style import MethodStyle
from variantgen.variants.draw import draw
from variantgen.variants.variant import Variant, solve_variants

SEEDS = 6
STYLES = (MethodStyle(), MethodStyle("velocity_pole"), MethodStyle("projections", "acceleration_centre"))


def forms() -> list[tuple[Family, Form]]:
    found = []
    for name in family_names():
        family = load_family(name)
        found += [(restrict(family, None, None, (f.name,) if f.name else ()), f) for f in family.forms.values()]
    return found


FORMS = forms()
NAMES = [f"{family.name}-{form.name}" for family, form in FORMS]


def drawn(family: Family, seed: int) -> tuple[Variant, Motion]:
    variant = draw(family, None, [(str(seed), "solutions", 0)])[0]
    return variant, solve_variants([variant], 2)


def faults(variant: Variant, motion: Motion, asked: list[Quantity], style: MethodStyle) -> list[str]:
    """What disagrees with the solver: the motion of any point or body found on the way, or an answer."""
    book = Book(task_of(variant, motion, 0, asked), style=style)
    answers = work_out(book)
    found = [] if deviation(book) < AGREES else [f"steps off by {deviation(book):.1e}"]
    return found + [q.name for q in asked if not is_right(book, q, answers[q.name], motion)]


def is_right(book: Book, quantity: Quantity, answer: Value, motion: Motion) -> bool:
    unit = quantity.unit(book.task.variant.family.length_unit)
    wanted = float(unit.from_si(float(quantity.value(motion)[0])))
    if quantity.is_angle:
        if quantity.component == "angle" and abs(float(quantity.whole.value(motion)[0])) < 1e-9:
            return answer.exact == 0.0  # a vector that is zero has no direction: the answer is 0 degrees
        return abs(math.remainder(answer.exact - wanted, 360.0)) < 1e-7
    if math.isinf(wanted):
        return math.isinf(answer.exact)
    book.order = quantity.order
    scale = book.task.size if quantity.is_centre else book.size_of(answer.measure) or 1.0
    near = 1.0 + abs(wanted) / scale if quantity.is_centre else 1.0  # far centres are as ill conditioned as far
    return abs(answer.exact - wanted) < AGREES * scale * near**2


@pytest.mark.parametrize(("family", "form"), FORMS, ids=NAMES)
def test_what_a_form_asks_is_found_in_every_style(family: Family, form: Form) -> None:
    asked = read_ask(form, None)
    for seed in range(SEEDS):
        variant, motion = drawn(family, seed)
        for style in STYLES:
            assert faults(variant, motion, asked, style) == [], (seed, style)


@pytest.mark.parametrize(("family", "form"), FORMS, ids=NAMES)
def test_every_single_quantity_is_found(family: Family, form: Form) -> None:
    variant, motion = drawn(family, SEEDS)
    for name in form.askable:
        quantity = parse_quantity(name, form.sample)
        assert faults(variant, motion, [quantity], STYLES[0]) == [], name
