"""The analytical method: hand calculations, agreement with the solver wherever it applies."""

from __future__ import annotations

import math

import pytest

from tests.methods.forms import FORMS, IDS, answers, exact, tasks
from tests.solved_cases import case_of, task
from variantgen.algebra.name import Name
from variantgen.methods.agreement import AGREES, deviation
from variantgen.methods.coordinates import analytical
from variantgen.methods.solution.book import Book
from variantgen.methods.steps.step import Derived

SEEDS = 3
# Mechanisms whose coordinates follow from the given motion without a system of equations.
EXPLICIT = {
    ("cam_disc", "flat"),
    ("crank_and_disc", "absolute"),
    ("crank_and_disc", "relative"),
    ("disc_in_cylinder", "inside"),
    ("disc_in_cylinder", "outside"),
    ("falling_rod", ""),
    ("gear_pair_with_crank", "outside"),
    ("gear_pair_with_crank", "ring"),
    ("movable_pulley", "load_and_axle"),
    ("planetary_pair", "inside"),
    ("planetary_pair", "outside"),
    ("planetary_train", "ring"),
    ("planetary_train", "two_planets"),
    ("planetary_train", "two_suns"),
    ("plate_acceleration_centre", "rectangle"),
    ("plate_acceleration_centre", "square"),
    ("point_on_rotating_disc", "chord"),
    ("point_on_rotating_disc", "groove"),
    ("pulley_and_wheel", "axle"),
    ("roller_on_drum", "inside"),
    ("roller_on_drum", "outside"),
    ("rolling_wheel", ""),
    ("scotch_yoke", "oblique"),
    ("scotch_yoke", "straight"),
    ("sliding_block_on_rotating_rod", "central"),
    ("sliding_block_on_rotating_rod", "offset"),
    ("triangle_plate", "equilateral"),
    ("triangle_plate", "scalene"),
    ("wedge_and_rod", "vertical"),
    ("wheel_between_racks", "driven_by_axle"),
}


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
def test_agreement_with_the_solver(name: str, form: str) -> None:
    for item in tasks(name, form, SEEDS):
        assert analytical.applies(item) == ((name, form) in EXPLICIT)
        book = Book(item)
        if (name, form) not in EXPLICIT:
            with pytest.raises(LookupError):
                analytical.solve(book)
            continue
        analytical.solve(book)
        assert deviation(book) < AGREES
        found = answers(book)
        for quantity in item.asked:
            assert found[quantity.name] == pytest.approx(exact(item, quantity), rel=1e-9, abs=1e-9), quantity.name
