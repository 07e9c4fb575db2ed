"""Bounds of magnitudes: with numbers worked out by hand, and not where a number breaks them or they could not fail."""

from __future__ import annotations

import math

import pytest

from tests.methods.damaged import damage_formulas
from tests.methods.forms import tasks
from tests.methods.given_data import worked_book
from variantgen.algebra.expression import Constant
from variantgen.methods import compose
from variantgen.methods.checks import check
from variantgen.methods.checks.magnitudes import magnitudes
from variantgen.methods.solution.book import Book
from variantgen.methods.steps.step import Ascending, Item, Sentence
from variantgen.variants.attempts import VerificationError
from variantgen.wording.formula import Relation, Symbol
from variantgen.wording.formula.tree import SIGNS
from variantgen.wording.formula.typst import to_typst
from variantgen.wording.latex import sign_to_latex


def bound(book: Book) -> tuple[str, list[float]]:
    """The key of the sentence and the numbers; nothing where no bound is said."""
    match magnitudes(book, book.steps):
        case [Sentence(key), Ascending(values)]:
            return key, [value.exact for value in values]
    return "", []


def racks() -> Book:
    """A wheel between bars at 30 and 50 cm/s to the same side, with M level with O: v_O = 40, omega R = 10."""
    data = {"R": 20, "alpha": 90, "place": 1, "v_1": 30, "v_2": 50, "a_1": 40, "a_2": 40, "way_1": 1, "way_2": 1}
    return worked_book("wheel_between_racks", "two_moving", "v_M a_M", **data)


def test_a_point_between_two_others() -> None:
    # omega t = 1 rad, a_C = 9.8, omega^2 AC = 4 along the rod: at the lower end both add up along it.
    book = worked_book("falling_rod", "", "v_A v_B a_A a_B", AB=2, omega=2, t=0.5, sense=1)
    larger = math.hypot(9.8 * math.sin(1) + 4, 9.8 * math.cos(1))
    assert bound(book) == ("check.between", pytest.approx([9.8, larger]))


def test_two_points_that_were_found_apart() -> None:
    # BD = 1, omega = 2, epsilon = 3: BD sqrt(9 + 16) = 5.
    data = {"AB": 0.8, "AD": 0.6, "BD": 1, "omega": 2, "epsilon": 3, "a_A": 2, "alpha": 60}
    key, (low, about, high) = bound(worked_book("triangle_plate", "scalene", "a_B a_D", **data))
    assert key == "check.apart"
    assert about == pytest.approx(5)
    assert low < 5 < high


def test_two_corners_of_an_equilateral_triangle() -> None:
    # BD = AB = 2, omega = 1, epsilon = 2: BD sqrt(4 + 1); a_D and a_B were both found from A.
    data = {"AB": 2, "omega": 1, "epsilon": 2, "a_A": 3}
    key, (low, about, high) = bound(worked_book("triangle_plate", "equilateral", "a_B a_D", **data))
    assert key == "check.apart"
    assert about == pytest.approx(2 * math.sqrt(5))
    assert low < about < high


def test_a_point_of_a_rim_between_its_extremes() -> None:
    assert bound(racks()) == ("check.slowest_and_fastest", pytest.approx([30, math.hypot(40, 10), 50]))


def test_a_number_that_breaks_the_bound_is_not_said_to_keep_it(monkeypatch: pytest.MonkeyPatch) -> None:
    assert damage_formulas(monkeypatch, "v M", lambda right: Constant(2.0) * right) == []
    assert bound(racks()) == ("", [])


def test_a_base_point_does_not_bound_what_was_found_from_it() -> None:
    data = {"OA": 20, "r": 10, "alpha": 90, "omega_OA": 2, "epsilon_OA": 4}
    assert bound(worked_book("crank_and_disc", "relative", "v_M a_M", **data)) == ("", [])


def test_numbers_that_do_not_rise_are_refused(monkeypatch: pytest.MonkeyPatch) -> None:
    (task,) = tasks("falling_rod", "", 1)
    right = check.magnitudes

    def wrong(*arguments: object) -> list[Item]:
        sentence, last = right(*arguments)  # type: ignore[arg-type]
        assert isinstance(last, Ascending)
        return [sentence, Ascending(last.values[::-1])]

    monkeypatch.setattr(check, "other_axes", lambda *_: [])  # a bound comes last
    compose.solution(task)
    monkeypatch.setattr(check, "magnitudes", wrong)
    with pytest.raises(VerificationError, match="the order of magnitudes in the step check"):
        compose.solution(task)


def test_every_output_has_the_sign_of_a_bound() -> None:
    assert sign_to_latex("<") == "<"
    assert "<" in SIGNS
    assert to_typst(Relation((Symbol("a"), Symbol("b")), ("<",))).split() == ["a", "lt", "b"]
