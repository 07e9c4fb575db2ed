"""A printed check fails where a number on which it leans is wrong by one per cent: all forms."""

from __future__ import annotations

import math

import pytest

from tests.methods.forms import FORMS, IDS, tasks
from tests.methods.given_data import worked_book
from variantgen.algebra.expression import Constant, Expression, Value
from variantgen.algebra.substitution import substituted
from variantgen.algebra.values import in_order
from variantgen.methods.checks.velocity_check import base_point_of_velocities
from variantgen.methods.compose import solution
from variantgen.methods.solution.book import Book
from variantgen.methods.steps.step import Balance, Derived, Solution
from variantgen.outputs.single.explanation import explain
from variantgen.single import one_variant

WRONG = 1.01
PRINTED = 2e-3  # of the side: what four printed digits allow the sides to differ by


def recomputed(side: Value, wrong: Value) -> float:
    """A side of a check where one number is wrong, and with it all that is worked out from it."""
    table: dict[Value, Expression] = {wrong: Constant(WRONG * wrong.exact, wrong.measure)}
    for value in in_order([side]):
        if value is not wrong and value.expression is not None:
            whole = substituted(value.expression, table) or Constant(0.0)
            table[value] = Constant(whole.number(True), value.measure)
    return table[side].number(True)


def leaned_on(found: Solution, sides: tuple[Value, Value]) -> list[Value]:
    """What has a line in the solution and is not an angle, of what the sides are worked out from.

    The angles of a limit position, each by its law of cosines, are all that the law of sines compares.
    """
    lines = {item.value for step in found.steps for item in step.items if isinstance(item, Derived)}
    return [value for value in in_order(sides) if value in lines and (_is_of_limits(value) or _is_number(value))]


def _is_number(value: Value) -> bool:
    return value.measure not in ("angle", "number")


def _is_of_limits(value: Value) -> bool:
    return value.name is not None and value.name.kind == "limit_corner"


@pytest.mark.parametrize(("name", "form"), FORMS, ids=IDS)
def test_a_check_fails_where_a_number_is_wrong(name: str, form: str) -> None:
    """The last numbers of which the check speaks, and some number before them, are seen to be wrong."""
    for task in tasks(name, form, 2):
        found = solution(task)
        for item in (item for item in found.check if isinstance(item, Balance)):
            sides = (item.left, item.right)
            numbers = leaned_on(found, sides)
            scale = max(abs(side.size or side.exact) for side in sides)
            assert sides[0].exact == pytest.approx(sides[1].exact, abs=1e-6 * task.largest_acceleration + 1e-6 * scale)
            gaps = [abs(recomputed(sides[0], v) - recomputed(sides[1], v)) / scale for v in numbers]
            assert max(gaps, default=1.0) > PRINTED, f"{name} {form}: {numbers}"


def centred() -> Book:
    """A slider-crank with OA = 30, AB = 50, the crank across the guide's normal: sin psi = 0.3 with phi = 30 deg."""
    return worked_book("slider_crank", "central", "v_B omega_AB", OA=30, AB=50, phi=30, omega_OA=2)


def test_the_equation_with_the_other_base_point_by_hand() -> None:
    """Across AB, with ``sin psi = 0.3``: ``v_B sin psi = omega AB - v_A cos(phi + psi)``."""
    book = centred()
    (_, balance) = base_point_of_velocities(book, book.steps)
    assert isinstance(balance, Balance)
    psi = math.asin(0.3)
    omega = 60 * math.cos(math.radians(30)) / (50 * math.cos(psi))
    own = (60 * 0.5 + omega * 50 * 0.3) * 0.3
    assert balance.left.exact == pytest.approx(own)
    assert own == pytest.approx(omega * 50 - 60 * math.cos(math.radians(30) + psi))
    assert balance.right.exact == pytest.approx(own)


def test_it_sees_a_wrong_distance_to_the_centre() -> None:
    book = centred()
    (_, balance) = base_point_of_velocities(book, book.steps)
    assert isinstance(balance, Balance)
    arms = [v for v in in_order([balance.left]) if v.name and v.name.kind == "length" and v.name.part == "centre"]
    assert arms
    for arm in arms:
        gap = recomputed(balance.left, arm) - recomputed(balance.right, arm)
        assert abs(gap) > PRINTED * balance.left.exact


def test_a_check_in_which_large_numbers_nearly_cancel_gives_way() -> None:
    """1.593 * 68 - 81.95 cos 1.07 is 26.39 with the printed numbers, and 26.42 with all digits."""
    text = str(explain(one_variant("guided_plate", seed="3"), language="en")).replace("\xa0", " ")
    check = text.partition("Check.")[2]
    assert "26.42" not in check
    assert "81.95" in check
