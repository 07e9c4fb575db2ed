"""Checks of vectors on two axes, of one unknown of two, of limit positions: with numbers worked out by hand."""

from __future__ import annotations

from math import acos, atan, cos, degrees, hypot, radians, sin, sqrt, tan

import pytest

from tests.methods.given_data import worked_book
from tests.methods.test_further_checks import parts
from variantgen.algebra.name import Name
from variantgen.methods.checks.about_axis import about_axis
from variantgen.methods.checks.elimination import elimination
from variantgen.methods.checks.growth_of_speed import growth_of_speed
from variantgen.methods.checks.limit_triangle import limit_triangle
from variantgen.methods.checks.other_base_point import other_base_point
from variantgen.methods.steps.step import NumberOf, VectorOf
from variantgen.outputs.single.explanation import explain
from variantgen.single import one_variant


def test_a_point_of_a_body_in_translation_by_the_distance_from_the_axis() -> None:
    # 20 sqrt(3^2 + 2^4) = 100
    data = {"O1A": 20, "omega_O1A": 2, "epsilon_O1A": 3}
    book = worked_book("parallelogram_with_disc", "fixed_point", "v_M a_M", **data)
    sentence, left, right = parts(about_axis(book, book.steps))
    assert sentence.key == "check.about_axis"
    assert (left, right) == pytest.approx((100, 100))


@pytest.mark.parametrize(("phi", "epsilon"), [(40, 3), (40, -3), (130, 3), (130, -3)])
def test_a_flat_follower_by_the_whole_acceleration_of_the_centre(phi: float, epsilon: float) -> None:
    """The follower has the projection of ``OC sqrt(epsilon^2 + omega^4)`` at ``arctan(epsilon / omega^2)`` from CO."""
    book = worked_book("cam_disc", "flat", "v_D a_D", OC=20, phi=phi, omega_cam=2, epsilon_cam=epsilon)
    sentence, left, right = parts(about_axis(book, book.steps))
    assert sentence.key == "check.about_axis_projected"
    turned = degrees(atan(3 / 4))
    both = [abs(100 * cos(radians(phi + side * turned))) for side in (1, -1)]
    assert any(left == pytest.approx(size) for size in both)
    assert right == pytest.approx(left)


def test_a_link_without_angular_acceleration_has_no_such_check() -> None:
    book = worked_book("cam_disc", "flat", "v_D a_D", OC=20, phi=40, omega_cam=2, epsilon_cam=0)
    assert about_axis(book, book.steps) == []


@pytest.mark.parametrize("epsilon", [-3, 3])
@pytest.mark.parametrize(("v", "a"), [(10, 20), (10, -20)])
def test_the_rate_of_the_speed(epsilon: float, v: float, a: float) -> None:
    """``(r'^2 + r^2 omega^2)' / 2 = r' r'' + r r' omega^2 + r^2 omega epsilon`` in polar coordinates."""
    data = {"OM": 30, "omega_OB": 2, "epsilon_OB": epsilon, "v_rel_M": v, "a_rel_M": a, "way": 1}
    book = worked_book("sliding_block_on_rotating_rod", "central", "v_M a_M", **data)
    _, left, right = parts(growth_of_speed(book, book.steps))
    assert left == pytest.approx((v * a + 30 * v * 4 + 900 * 2 * epsilon) / hypot(v, 60))
    assert right == pytest.approx(left)


def test_the_rate_of_the_speed_on_a_chord_beside_the_axis() -> None:
    """Axes of the disc: v = (omega d + u, omega s) with s' = -u or u; both parts differentiated by hand."""
    data = {"OE": 20, "EM": 30, "omega_disc": 2, "epsilon_disc": 3, "v_rel_M": 10, "a_rel_M": 5}
    book = worked_book("point_on_rotating_disc", "chord", "v_M a_M", **data)
    _, left, right = parts(growth_of_speed(book, book.steps))
    rates = [
        ((40 + side * 10) * (60 + side * 5) + 60 * (90 + other * 20)) / hypot(40 + side * 10, 60)
        for side in (1, -1)
        for other in (1, -1)
    ]
    assert any(left == pytest.approx(rate) for rate in rates)
    assert right == pytest.approx(left)


def test_where_a_vector_is_oblique_another_check_is_taken() -> None:
    book = worked_book("point_on_rotating_disc", "groove", "v_M a_M", OC=20, CM=30, alpha=70)
    assert growth_of_speed(book, book.steps) == []


def test_the_height_of_the_triangle_of_a_limit_position() -> None:
    # OB_1 = 60 + 20 = 80, BC = 50, OC = 70: the height over OC is twice the area, by Heron, over 70.
    data = {"OA": 20, "AB": 60, "BC": 50, "OC": 70, "phi": 60, "omega_OA": 2}
    book = worked_book("limit_positions", "rocker", "v_B omega_BC swing_BC time_ratio_BC", **data)
    sentence, left, right = parts(limit_triangle(book))
    assert sentence.key == "check.limit_triangle_1"
    half = (80 + 50 + 70) / 2
    height = 2 * sqrt(half * (half - 80) * (half - 50) * (half - 70)) / 70
    assert (left, right) == pytest.approx((height, height))
    assert height == pytest.approx(80 * sin(acos((80**2 + 70**2 - 50**2) / (2 * 80 * 70))))


def test_one_angle_alone_is_no_check() -> None:
    data = {"OA": 20, "AB": 60, "BC": 50, "OC": 70, "phi": 60, "omega_OA": 2}
    assert limit_triangle(worked_book("limit_positions", "rocker", "swing_BC", **data)) == []


def test_equal_projections_by_the_other_base_point() -> None:
    """``x = OA cos phi + sqrt(AB^2 - OA^2 sin^2 phi)`` differentiated: ``omega OA (sin phi + cos phi tan psi)``."""
    data = {"OA": 20, "AB": 60, "phi": 130, "omega_OA": 3}
    book = worked_book("slider_crank_with_graph", "sketch", "v_B", **data)
    sentence, left, right = parts(elimination(book, book.steps))
    assert sentence.key == "check.elimination_about"
    across, along = 20 * sin(radians(130)), 20 * cos(radians(130))
    psi = atan(across / sqrt(60**2 - across**2))
    assert left == pytest.approx(3 * (across + along * tan(psi)))
    assert right == pytest.approx(left)


def test_one_unknown_acceleration_of_two() -> None:
    # The crank across the guide: B is as fast as C; a_B = epsilon OC + omega^2 OC^2 / sqrt(CB^2 - OC^2).
    data = {"R": 20, "r": 10, "OC": 18, "phi": 90, "omega_cam": 2, "epsilon_cam": 5}
    book = worked_book("cam_disc", "roller", "v_D a_D", **data)
    sentence, left, right = parts(elimination(book, book.steps))
    assert sentence.facts["vector"] == VectorOf(Name("a", "B"))
    leg = sqrt(30**2 - 18**2)
    both = [abs(5 * 18 + side * 4 * 18**2 / leg) for side in (1, -1)]
    assert any(left == pytest.approx(size) for size in both)
    assert right == pytest.approx(left)


def test_the_acceleration_of_a_contact_that_no_line_has_is_worked_out() -> None:
    # omega_1 = 2 * 30 / 10 = 6: 6^2 * 10 - 2^2 * 30 = 240 away from O
    data = {"r_1": 10, "r_2": 20, "alpha": 60, "omega_OA": 2, "epsilon_OA": 3}
    book = worked_book("planetary_pair", "outside", "omega_gear1 v_B a_B", **data)
    sentence, left, right = parts(other_base_point(book, book.steps))
    size = sentence.facts["size"]
    assert isinstance(size, NumberOf) and size.worked_out
    assert size.value.exact == pytest.approx(240)
    assert left == pytest.approx(right)


def test_that_of_a_wheel_on_a_straight_rail_is_the_normal_one_that_has_a_line() -> None:
    book = worked_book("rolling_wheel", "", "v_M a_M", R=0.5, v_O=2, a_O=3, alpha=35)
    sentence, _, _ = parts(other_base_point(book, book.steps))
    size = sentence.facts["size"]
    assert isinstance(size, NumberOf) and not size.worked_out
    assert size.value.exact == pytest.approx(2**2 / 0.5)


@pytest.mark.parametrize(("angle", "across"), [(60, "117 · sin 60°"), (90, "(117 · 24.04 / 17) · cos 45°")])
def test_the_arm_of_an_equilateral_triangle_is_the_radius(angle: int, across: str) -> None:
    """``alpha MP = a_A MP / r`` with ``a_A = 3 (22 + 17) = 117``: MP = r at 60 degrees, r times the root of 2 at 90."""
    data = {"r_1": 22, "r_2": 17, "alpha": angle, "omega_OA": 3, "epsilon_OA": 3}
    text = str(explain(one_variant("planetary_train", data, form="ring"), language="en"))
    check = " ".join(text.split("Check.")[1].split())
    assert across in check, check
