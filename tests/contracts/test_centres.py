"""Centres of every body of every form are where the solver has them; the methods that need them are used."""

from __future__ import annotations

from functools import cache
from math import isinf

import pytest

from variantgen.families.quantities import parse_quantity, quantity_names
from variantgen.families.reading.folders import family_names
from variantgen.families.reading.load import load_family
from variantgen.families.restrict import restrict
from variantgen.mechanism.motion import Motion
from variantgen.methods.agreement import deviation
from variantgen.methods.linkage.problem import AGREES, Task, task_of
from variantgen.methods.natural_answers import work_out
from variantgen.methods.solution.book import Book
from variantgen.methods.steps.method_style import MethodStyle
from variantgen.variants.draw import FamilySampler
from variantgen.variants.variant import Variant, solve_variants

SEEDS = 3
FORMS = [(name, form) for name in family_names() for form in load_family(name).forms]
IDS = ["-".join(item) for item in FORMS]

# Families in which a method has something to do, so that the comparison is not an empty one.
USED = {
    "velocity_centre": {"four_bar", "ladder", "rolling_wheel", "slider_crank", "triangle_plate", "planetary_pair"},
    "projections": {"four_bar", "ladder", "slider_crank", "slider_crank_with_second_rod", "two_loop_mechanism"},
    "acceleration_centre": {"plate_acceleration_centre", "triangle_plate", "rolling_wheel", "two_loop_mechanism"},
}

STYLES = {
    "velocity_centre": MethodStyle("velocity_centre"),
    "projections": MethodStyle("projections"),
    "acceleration_centre": MethodStyle("velocity_pole", "acceleration_centre"),
}


@cache
def drawn(name: str, form: str) -> tuple[list[Variant], Motion]:
    family = restrict(load_family(name), None, None, (form,) if form else ())
    variants = FamilySampler(family, None).after([("methods", i) for i in range(SEEDS)], [0] * SEEDS)
    return variants, solve_variants(variants, 2)


def task(name: str, form: str, index: int, names: tuple[str, ...]) -> Task:
    variants, motion = drawn(name, form)
    sample = variants[index].form.sample
    return task_of(variants[index], motion, index, [parse_quantity(text, sample) for text in names])


@pytest.mark.parametrize(("method", "name"), [(m, n) for m, names in USED.items() for n in sorted(names)])
def test_a_method_does_what_its_style_promises(method: str, name: str) -> None:
    style = STYLES[method]
    for form in load_family(name).forms:
        moving = [
            text for text in quantity_names(drawn(name, form)[0][0].form.sample) if "." not in text and text[0] != "m"
        ]
        steps: set[str] = set()
        for index in range(SEEDS):
            book = Book(task(name, form, index, tuple(moving)), style=style)
            work_out(book)
            assert deviation(book) < AGREES, (form, index)
            steps |= {step.heading.key.partition(".")[0] for step in book.steps}
        assert method in steps, form


@pytest.mark.parametrize(("name", "form"), FORMS, ids=IDS)
def test_distances_from_centres(name: str, form: str) -> None:
    variants, motion = drawn(name, form)
    sample = variants[0].form.sample
    length = variants[0].family.length_unit
    texts = [t for t in quantity_names(sample) if t.partition("_")[0] in ("P", "Q", "mu")]
    assert texts
    for index in range(SEEDS):
        size = task(name, form, index, ()).size
        for text in texts[index::SEEDS]:
            found = work_out(Book(task(name, form, index, (text,))))[text].exact
            quantity = parse_quantity(text, sample)
            wanted = quantity.unit(length).from_si(float(quantity.value(motion)[index]))
            if isinf(wanted):
                assert isinf(found), text
            else:
                assert found == pytest.approx(wanted, rel=1e-9, abs=1e-9 * (90.0 if quantity.kind == "mu" else size)), (
                    text
                )
