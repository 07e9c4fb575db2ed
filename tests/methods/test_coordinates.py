"""The coordinate method: the systems of a worked case by hand, agreement with the solver for all that may be asked."""

from __future__ import annotations

import importlib
import math
import re

import pytest

from tests.methods.forms import FORMS, IDS, answers, exact, tasks
from tests.solved_cases import case_of, task
from variantgen.algebra.expression import Value
from variantgen.algebra.name import Name
from variantgen.mechanism.component import discover
from variantgen.methods.agreement import deviation
from variantgen.methods.compose import solution
from variantgen.methods.coordinates import coordinates
from variantgen.methods.linkage.problem import AGREES
from variantgen.methods.solution.book import Book
from variantgen.methods.steps.step import Derived, LinearSystem
from variantgen.wording.language import load_language
from variantgen.wording.solution.explain import written
from variantgen.wording.solution.plain import plain_solution

SEEDS = 2
JOINTS, DRIVERS = (discover(f"variantgen.mechanism.{folder}") for folder in ("joints", "drivers"))


class TestProblem28:
    """Kirsanov, problem 28: B by the lengths AB and CB, D on the crank by the length DB."""

    book = Book(task(*case_of("four_bar_with_sleeve", "K28")))
    coordinates.solve(book)

    def values(self) -> dict[Name, Value]:
        items = [item for step in self.book.steps for item in step.items]
        return {i.value.name: i.value for i in items if isinstance(i, Derived) and i.value.name is not None}

    def test_system_of_the_hinge(self) -> None:
        systems = [i for step in self.book.steps for i in step.items if isinstance(i, LinearSystem)]
        rows = [[v.exact for v in (*row, b)] for row, b in zip(systems[0].rows, systems[0].right, strict=True)]
        # v_A = 120 cm/s across OA, so its components are -84.853 and 84.853.
        wanted = -110.58205 * -84.852814 + 9.6235 * 84.852814
        assert rows[0] == pytest.approx([-110.58205, 9.6235, wanted], rel=1e-5)
        # C is at the left of O here, 62 cm away: x_B - x_C is -20.298, y_B is 37.908.
        assert rows[1] == pytest.approx([-20.29777, 37.90779, 0], abs=1e-5)

    def test_velocities(self) -> None:
        found = self.values()
        x, y = (found[Name(axis, "B", dots=1)].exact for axis in "xy")
        assert math.hypot(x, y) == pytest.approx(109.74133, rel=1e-7)
        assert x / y == pytest.approx(-37.90779 / -20.29777, rel=1e-6)  # across CB
        assert found[Name("slide", "D", dots=1)].exact == pytest.approx(-58.557863, rel=1e-7)  # from D to O

    def test_accelerations(self) -> None:
        found = self.values()
        assert found[Name("slide", "D", dots=2)].exact == pytest.approx(-465.93779, rel=1e-7)
        assert math.hypot(*(found[Name(axis, "D", dots=2)].exact for axis in "xy")) == pytest.approx(
            734.92718, rel=1e-7
        )

    def test_numbers_of_the_source(self) -> None:
        found = answers(self.book)
        wanted = {"omega_DB": 0.54685059, "epsilon_DB": -3.5662973, "a_B": 380.06719}
        assert {n: found[n] for n in wanted if n in found} == pytest.approx(
            {n: wanted[n] for n in wanted if n in found}
        )
        assert found["v_rel_D"] == pytest.approx(58.557863)


def test_zero_terms_are_left_out() -> None:
    """Where nothing moves sideways there is no line for it: the slider of a crank has one coordinate."""
    (item,) = tasks("slider_crank", "central", 1)
    book = Book(item)
    coordinates.solve(book)
    names = [i.value.name for step in book.steps for i in step.items if isinstance(i, Derived)]
    assert not [
        name
        for name in names
        if name is not None and name.of == "B" and name.kind in ("x", "y") and _across(item, name)
    ]


def test_a_coordinate_that_follows_from_no_data_is_written_once() -> None:
    """The guide of the ram is where the drawing has room: y_G = -14.25 cm, not -14.249999999999998 = -14.25 cm."""
    language = load_language("en")
    for item in tasks("quick_return_shaper", "", 8):
        lines = plain_solution(written(item, solution(item, ["coordinates"]), language, False), language).splitlines()
        (free, known) = sorted((line.strip() for line in lines if re.match(r" *[xy]_G = ", line)), key=len)
        assert re.fullmatch(r"[xy]_G = \N{MINUS SIGN}?\d+(\.\d{1,4})?\N{NO-BREAK SPACE}cm", free)
        assert "OC" in known


def _across(item: object, name: Name) -> bool:
    """Whether a coordinate is the one across the velocity of its point."""
    v = item.now.v[name.of]  # type: ignore[attr-defined]
    return abs(v.real if name.kind == "x" else v.imag) < 1e-12


@pytest.mark.parametrize(("name", "form"), FORMS, ids=IDS)
@pytest.mark.parametrize("everything", [False, True], ids=["asked", "all"])
def test_agreement_with_the_solver(name: str, form: str, everything: bool) -> None:
    for item in tasks(name, form, 1 if everything else SEEDS, everything):
        assert coordinates.applies(item)
        book = Book(item)
        coordinates.solve(book)
        assert deviation(book) < AGREES
        found = answers(book)
        for quantity in item.asked:
            wanted = exact(item, quantity)
            if quantity.component == "angle":
                turn = (found[quantity.name] - wanted + 180.0) % 360.0 - 180.0
                assert turn == pytest.approx(0, abs=1e-7) or _is_zero(item, quantity.kind, quantity.target)
            else:
                assert found[quantity.name] == pytest.approx(wanted, rel=1e-9, abs=1e-8), quantity.name


def _is_zero(item: object, kind: str, point: str) -> bool:
    """Whether a vector has no direction: that of the contact of a wheel."""
    table = item.now.v if kind == "v" else item.now.a  # type: ignore[attr-defined]
    return abs(table[point]) < 1e-9 * max(abs(v) for v in table.values())


@pytest.mark.parametrize("stem", [*JOINTS, *DRIVERS])
def test_every_joint_and_driver_has_equations_of_the_same_stem(stem: str) -> None:
    module = importlib.import_module(f"variantgen.methods.coordinates.equations.{stem}")
    assert module.__doc__
    silent = {"pivot", "translation"}  # what they say, the model knows before any equation
    assert stem in silent or hasattr(module, "state") or hasattr(module, "prepare")
