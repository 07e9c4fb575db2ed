"""Accelerations by the acceleration centre, against example 33 of the guide and hand numbers."""

from __future__ import annotations

from math import atan2, degrees, sqrt

import pytest
from msgspec.structs import replace

from tests.methods.test_velocity_centre import keys
from tests.solved_cases import case_of, task
from variantgen.methods.agreement import deviation
from variantgen.methods.natural_answers import work_out
from variantgen.methods.solution.book import Book, resultant
from variantgen.methods.steps.method_style import MethodStyle


def solved(family: str, case: str, names: tuple[str, ...], **changed: float) -> tuple[Book, dict[str, float]]:
    found, worked = case_of(family, case)
    worked = replace(worked, given={**worked.given, **changed})
    book = Book(task(found, worked, names), style=MethodStyle("velocity_centre", "acceleration_centre"))
    answers = {name: value.exact for name, value in work_out(book).items()}
    assert deviation(book) < 1e-12
    return book, answers


def test_example_33() -> None:
    book, answers = solved("plate_acceleration_centre", "M33", ("mu_ABDE", "Q_ABDE.A", "a_D", "a_E", "Q_ABDE.E"))
    assert answers["mu_ABDE"] == pytest.approx(45, rel=1e-14)
    assert answers["Q_ABDE.A"] == pytest.approx(1, rel=1e-14)
    assert answers["a_D"] == pytest.approx(sqrt(2), rel=1e-14)
    assert book.centres["Q", "ABDE"].at == "E"
    assert answers["Q_ABDE.E"] == 0.0
    assert book.acceleration["E"] == ()
    # Along the diagonal of the square: from D, above B on the right, down to B; DQ leads to the left, mu is 45 degrees.
    assert degrees(atan2(resultant(book.acceleration["D"]).imag, resultant(book.acceleration["D"]).real)) in (
        pytest.approx(-135),
        pytest.approx(135),
    )


def test_the_other_vertices_by_hand() -> None:
    book, answers = solved("plate_acceleration_centre", "hand-1", ("mu_ABDE", "a_B", "a_D", "a_E"))
    assert answers["mu_ABDE"] == pytest.approx(degrees(atan2(3, 4)), rel=1e-14)
    assert book.centres["Q", "ABDE"].rays["A"].arm.exact == pytest.approx(2, rel=1e-14)
    # a = a_A + (i epsilon - omega^2) (z - z_A) with a_A = -10 i, omega = -2, epsilon = -3.
    for point, place in {"B": 2, "D": 2 + 1j, "E": 1j}.items():
        assert resultant(book.acceleration[point]) == pytest.approx(-10j + (-3j - 4) * place, rel=1e-13)


def test_without_angular_acceleration_the_accelerations_point_to_the_centre() -> None:
    book, answers = solved("plate_acceleration_centre", "hand-1", ("mu_ABDE", "Q_ABDE.A", "a_B"), epsilon=0.0)
    assert answers["mu_ABDE"] == 0.0
    assert answers["Q_ABDE.A"] == pytest.approx(10 / 4, rel=1e-14)
    assert resultant(book.acceleration["B"]) == pytest.approx(-8 - 10j, rel=1e-13)
    assert "acceleration_centre.ahead" in keys(book)


def test_without_angular_velocity_they_are_across_the_rays() -> None:
    book, answers = solved("plate_acceleration_centre", "hand-1", ("mu_ABDE", "Q_ABDE.A", "a_B"), omega=0.0)
    assert answers["mu_ABDE"] == 90.0
    assert answers["Q_ABDE.A"] == pytest.approx(10 / 3, rel=1e-14)
    assert resultant(book.acceleration["B"]) == pytest.approx(-16j, rel=1e-13)


def test_without_rotation_there_is_no_centre() -> None:
    book, answers = solved("plate_acceleration_centre", "hand-1", ("Q_ABDE.A", "a_B"), omega=0.0, epsilon=0.0)
    assert answers["Q_ABDE.A"] == float("inf")
    assert resultant(book.acceleration["B"]) == pytest.approx(-10j, rel=1e-14)


def test_a_pole_without_acceleration_is_the_centre() -> None:
    _, answers = solved("plate_acceleration_centre", "hand-1", ("Q_ABDE.A", "Q_ABDE.B", "a_B"), a_A=0.0)
    assert answers["Q_ABDE.A"] == 0.0
    assert answers["Q_ABDE.B"] == pytest.approx(2, rel=1e-14)
    assert answers["a_B"] == pytest.approx(2 * 5, rel=1e-14)  # sqrt(9 + 16) = 5


def test_a_wheel_with_a_uniformly_moving_centre() -> None:
    # The centre moves uniformly in a straight line, so it is the acceleration centre: a_M = omega^2 R = 8.
    _, answers = solved("rolling_wheel", "M24", ("a_M", "Q_wheel.O"))
    assert answers["Q_wheel.O"] == 0.0
    assert answers["a_M"] == pytest.approx(16 * 0.5, rel=1e-14)
