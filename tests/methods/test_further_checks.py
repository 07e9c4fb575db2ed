"""Checks where no third axis of paper and no other base point is: with numbers worked out by hand."""

from __future__ import annotations

import cmath
from math import cos, hypot, pi, radians, sin

import pytest

from tests.methods.given_data import worked_book
from variantgen.algebra.name import Name
from variantgen.methods.checks.carrier_frame import from_the_arm
from variantgen.methods.checks.other_axes import other_axes
from variantgen.methods.checks.result_check import third_axis
from variantgen.methods.steps.step import Balance, Body, Derived, Item, Sentence, VectorOf


def parts(items: list[Item]) -> tuple[Sentence, float, float]:
    """The sentence and both sides of a check."""
    match items:
        case [Sentence() as sentence, Balance(left, right)]:
            return sentence, left.exact, right.exact
    raise AssertionError(items)


def test_where_both_axes_of_the_paper_were_used_the_third_one_is_along_a_known_vector() -> None:
    # a_A = 4 * 20 along AO, 30 degrees to the guide of a yoke: a_B = 80 cos 30, a_rel = 80 sin 30.
    data = {"OA": 20, "phi": 30, "omega_OA": 2, "epsilon_OA": 0}
    book = worked_book("scotch_yoke", "straight", "v_B v_rel_A a_B a_rel_A", **data)
    sentence, left, right = parts(third_axis(book.steps))
    assert sentence.key == "check.third_axis_along"
    assert sentence.facts["vector"] == VectorOf(Name("a", "A", part="n"))
    assert (left, right) == pytest.approx((80, 80))
    inner = 80 * cos(radians(30)) ** 2 + 80 * sin(radians(30)) ** 2
    assert right == pytest.approx(inner)


@pytest.mark.parametrize("alpha", [35, 60, 110])
def test_a_sum_of_four_vectors_on_the_line_of_a_fifth(alpha: float) -> None:
    """A disc on a crank OA = 20 along the positive x axis that turns at 2 and 4; it turns at 2 + 3 and 4 + 5."""
    data = {"OA": 20, "r": 10, "alpha": alpha, "omega_OA": 2, "epsilon_OA": 4, "omega_r": 3, "epsilon_r": 5}
    book = worked_book("crank_and_disc", "relative", "a_M", **data)
    sentence, left, right = parts(other_axes(book, book.steps))
    assert sentence.key == "check.components"
    assert sentence.facts["along"] == VectorOf(Name("a", "M", "A", "n"))
    turn = radians(alpha)  # from AO to AM: a^n_A = 80 along AO, a^tau_A = 80 across it, a^n_MA = 250 along MA
    both = [250 - 80 * cos(turn) + sense * 80 * sin(turn) for sense in (1, -1)]  # M is on one side or the other
    assert any(right == pytest.approx(projection) for projection in both)
    assert left == pytest.approx(right)


def test_a_sum_of_three_vectors_has_its_magnitude_on_other_axes() -> None:
    """A falling rod of 2 m that has turned by 1 rad: a_C = 9.8 and omega^2 AC = 4 along the rod."""
    book = worked_book("falling_rod", "", "a_A", AB=2, omega=2, t=0.5, sense=1)
    sentence, left, right = parts(other_axes(book, book.steps))
    assert sentence.key == "check.other_axes"
    assert sentence.facts["along"] == VectorOf(Name("a", "C"))
    both = [abs(9.8 + side * 4 * cmath.exp(1j * (pi / 2 - 1))) for side in (1, -1)]
    assert any(left == pytest.approx(magnitude) for magnitude in both)
    assert right == pytest.approx(left)


def test_long_sums_have_lines_of_their_own() -> None:
    """A pulley of 0.5 m between cords with v = 2, 1 and a = 1, 3 m/s^2 upwards: omega = 1, epsilon = 2, a_C = 2.

    Across CM the components cancel, so there is but one line to compare: a_M = 2 cos 30 - 0.5.
    """
    data = {"R": 0.5, "alpha": 30, "v_A": 2, "v_B": 1, "a_A": 1, "a_B": 3}
    words = {"way_A": 1, "way_B": 1, "place": 1}
    book = worked_book("movable_pulley", "two_loads", "a_M", **data, **words)
    match other_axes(book, book.steps):
        case [Sentence("check.other_axes_apart"), Derived(along), Derived(across), Balance(left, right)]:
            # M is 30 degrees to the left of the highest point: omega^2 R = 0.5 to C, epsilon R = 1 to the left.
            own = (2 - 0.5 * cos(pi / 6) - 1 * sin(pi / 6), 1 * cos(pi / 6) - 0.5 * sin(pi / 6))
            assert (along.exact, across.exact) == pytest.approx(own)
            assert left.exact == pytest.approx(2 * cos(pi / 6) - 0.5)
            assert left.exact == pytest.approx(right.exact) == pytest.approx(hypot(along.exact, across.exact))
        case found:
            raise AssertionError(found)


def test_vectors_that_lie_on_the_axes_have_no_other_ones() -> None:
    data = {"OM": 30, "omega_OB": 2, "epsilon_OB": 3, "v_rel_M": 10, "a_rel_M": 20}
    book = worked_book("sliding_block_on_rotating_rod", "central", "v_M a_M", **data)
    assert other_axes(book, book.steps) == []


def test_gears_seen_from_their_arm() -> None:
    # Willis: epsilon_2 = 5 (1 + 20 / 10) = 15; seen from the arm gear 2 has 10 and its smaller rim 8 * 10 = 80.
    data = {"r_1": 20, "r_2": 10, "r_3": 8, "omega_OA": 3, "epsilon_OA": 5}
    book = worked_book("planetary_train", "two_suns", "omega_gear2 omega_gear4 epsilon_gear2 epsilon_gear4", **data)
    sentence, left, right = parts(from_the_arm(book, book.steps))
    assert sentence.key == "check.from_the_arm_a"
    assert sentence.facts["carrier"] == Body("OA")
    assert (left, right) == pytest.approx((80, 80))
    assert right == pytest.approx(22 * (5 - (5 - 10 * 8 / 22)))
