"""Drawn variants of every form as tasks, for what its exam asks or for all that may be asked."""

from __future__ import annotations

from functools import cache

from variantgen.errors import InputError
from variantgen.families.asking import read_ask
from variantgen.families.family import Form
from variantgen.families.quantities import Quantity
from variantgen.families.reading.folders import family_names
from variantgen.families.reading.load import load_family
from variantgen.families.restrict import restrict
from variantgen.mechanism.motion import Motion
from variantgen.methods.by_groups.answers import answer
from variantgen.methods.by_groups.solve_groups import at_order
from variantgen.methods.linkage.problem import Task, task_of
from variantgen.methods.solution.book import Book
from variantgen.variants.draw import FamilySampler
from variantgen.variants.variant import Variant, solve_variants

FORMS = [(name, form) for name in family_names() for form in load_family(name).forms]
IDS = ["-".join(item) for item in FORMS]


@cache
def variants(name: str, form: str, count: int) -> tuple[list[Variant], Motion]:
    family = restrict(load_family(name), None, None, (form,) if form else ())
    drawn = FamilySampler(family, None).after([("whole", i) for i in range(count)], [0] * count)
    return drawn, solve_variants(drawn, 2)


def tasks(name: str, form: str, count: int, everything: bool = False) -> list[Task]:
    drawn, motion = variants(name, form, count)
    return [task_of(v, motion, i, askable(v.form) if everything else read_ask(v.form)) for i, v in enumerate(drawn)]


def askable(form: Form) -> list[Quantity]:
    """All quantities that are not given."""
    found: list[Quantity] = []
    for name in form.askable:
        try:
            found += read_ask(form, [name])
        except InputError:  # given by the statement
            continue
    return found


def exact(task: Task, quantity: Quantity) -> float:
    """The solver's value of a quantity, in its printed unit."""
    motion = solve_variants([task.variant], 2)
    return float(quantity.unit(task.variant.family.length_unit).from_si(float(quantity.value(motion)[0])))


def answers(book: Book) -> dict[str, float]:
    """The answers that a solved book leads to."""
    found = {}
    for quantity in book.task.asked:
        found[quantity.name] = answer(at_order(book, quantity.order), quantity).exact
    return found
