"""The analytical method: hand calculations, agreement with the solver wherever it applies."""

from __future__ import annotations

import math

import pytest

from tests.methods.applying import APPLYING
from tests.methods.forms import FORMS, IDS, answers, exact, tasks
from tests.solved_cases import case_of, task
from variantgen.algebra.name import Name
from variantgen.methods.agreement import deviation
from variantgen.methods.coordinates import analytical
from variantgen.methods.linkage.problem import AGREES
from variantgen.methods.solution.book import Book
from variantgen.methods.steps.step import Derived

SEEDS = 3


def test_falling_rod_by_hand() -> None:
    """Guide, example 22: x_A = -(AB/2) cos phi, y_A = -g t^2/2 - ..., with |phi| = 60 degrees at t = 2 s."""
    book = Book(task(*case_of("falling_rod", "M22")))
    analytical.solve(book)
    items = [i.value for step in book.steps for i in step.items if isinstance(i, Derived)]
    found = {value.name: value.exact for value in items if value.name is not None}
    fall, edge = 9.8 * 2, math.pi / 6 * 1
    across, along = edge * math.sin(math.pi / 3), edge * math.cos(math.pi / 3)
    assert abs(found[Name("x", "A", dots=1)]) == pytest.approx(across)
    speeds = {abs(found[Name("y", point, dots=1)]) for point in "AB"}
    assert sorted(speeds) == pytest.approx([fall - along, fall + along])
    assert found[Name("v", "A")] == pytest.approx(math.sqrt(fall**2 + edge**2 - fall * edge))
    cosines = [found[Name("cosine", "A", part=axis, body="v")] for axis in "xy"]
    assert math.hypot(*cosines) == pytest.approx(1)
    assert cosines[0] == pytest.approx(found[Name("x", "A", dots=1)] / found[Name("v", "A")])


@pytest.mark.parametrize(("name", "form"), FORMS, ids=IDS)
def test_applies_where_no_system_is_needed(name: str, form: str) -> None:
    for item in tasks(name, form, SEEDS):
        assert analytical.applies(item) == ((name, form) in APPLYING["analytical"])


@pytest.mark.parametrize(("name", "form"), [item for item in FORMS if item not in APPLYING["analytical"]])
def test_elsewhere_nothing_is_found(name: str, form: str) -> None:
    (item,) = tasks(name, form, 1)
    with pytest.raises(LookupError):
        analytical.solve(Book(item))


@pytest.mark.parametrize(("name", "form"), APPLYING["analytical"])
def test_agreement_with_the_solver(name: str, form: str) -> None:
    for item in tasks(name, form, SEEDS):
        book = Book(item)
        analytical.solve(book)
        assert deviation(book) < AGREES
        found = answers(book)
        for quantity in item.asked:
            assert found[quantity.name] == pytest.approx(exact(item, quantity), rel=1e-9, abs=1e-9), quantity.name
