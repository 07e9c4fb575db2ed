"""Triangles of the position and of the velocity centre: named, solved by right triangles first, by hand."""

from __future__ import annotations

import math

import pytest

from variantgen.algebra.expression import Value
from variantgen.algebra.name import Name
from variantgen.methods.geometry.angles import corner_name
from variantgen.methods.geometry.trigonometry import by_height
from variantgen.outputs.single.explanation import explain
from variantgen.single import one_variant


def text_of(family: str, form: str, **data: float) -> str:
    found = str(explain(one_variant(family, data, seed="174", form=form), language="en"))
    return found.replace("\N{NO-BREAK SPACE}", " ")


def four_bar(phi: int) -> str:
    return text_of("four_bar", "crank", OA=20, AB=40, BC=32, OC=40, phi=phi)


def test_a_right_angle_between_crank_and_base_gives_the_centre_without_the_law_of_sines() -> None:
    # By hand: CA^2 = 2000, cos ACB = (2000 + 32^2 - 40^2)/(2 * 44.72 * 32) = 0.4975, ACB = 60.16, OCB = 33.60 degrees.
    text = four_bar(90)
    assert "Triangle OCP has a right angle at O" in text
    assert "∠OCB = ∠ACB − ∠OCA = 60.16° − 26.57° ≈ 33.60°" in text  # 33.5986; the printed ones give 33.59
    assert "AP = OA + OC tan ∠OCB = 20 + 40 · tan 33.60° = 46.57 cm" in text
    assert "BP = OC / cos ∠OCB − BC = 40 / cos 33.60° − 32 = 16.02 cm" in text
    assert "∠OAB = arcsin(BP sin ∠P / AB)" in text and "= 19.49°" in text
    assert "∠ABC = ∠OAB + ∠P = 19.49° + 56.40° = 75.89°" in text
    assert "law of sines" not in text
    assert text.count("law of cosines") == 1


def test_one_law_of_cosines_and_one_of_sines_in_general() -> None:
    # By hand: AH = 20 sin 75 = 19.32, CH = 40 - 20 cos 75 = 34.82, CA = 39.82; ACB = 66.76, OCA = 29.02 degrees.
    text = four_bar(75)
    ca = math.hypot(20 * math.sin(math.radians(75)), 40 - 20 * math.cos(math.radians(75)))
    acb = math.degrees(math.acos((32**2 + ca**2 - 40**2) / (2 * 32 * ca)))
    assert "Drop the perpendicular AH to OC:" in text
    assert "AH = OA sin φ = 20 · sin 75° = 19.32 cm" in text
    assert "CH = OC − OA cos φ = 40 − 20 · cos 75° = 34.82 cm" in text
    assert f"CA = √(CH^2 + AH^2) = √(34.82^2 + 19.32^2) = {ca:.2f} cm" in text
    assert f"= {acb:.2f}°" in text
    assert text.count("arccos") == 2  # in symbols and in numbers
    assert text.count("law of sines") == 1
    cab = math.degrees(math.asin(32 * math.sin(math.radians(acb)) / 40))
    oab = 180 - 75 - math.degrees(math.atan2(19.319, 34.824)) - cab
    assert f"= {oab:.2f}°" in text and "∠CAB" not in text
    assert f"sin(75° + {oab:.2f}°)" in text  # the check has the angle of AB with OC, exterior in the triangle of P


@pytest.mark.parametrize(
    ("sides", "key", "line"),
    [
        ((38, 38), "Triangle ABC is isosceles", "∠ACB = arccos(CA / (2 · BC))"),
        ((40, 32), "law of cosines", "∠ACB = arccos((BC^2 + CA^2 − AB^2) / (2 · BC · CA))"),
    ],
)
def test_equal_sides_are_noticed(sides: tuple[int, int], key: str, line: str) -> None:
    text = text_of("four_bar", "crank", OA=20, AB=sides[0], BC=sides[1], OC=40, phi=75 if sides[0] == sides[1] else 90)
    assert key in text
    assert line in text


@pytest.mark.parametrize(
    ("base", "own", "opposite", "known"),
    [
        (5.0, 4.0, 3.0, 53.13010235415598),  # 3:4:5, 36.87 degrees at the other end
        (4.0, 5.0, 3.0, 90.0),
        (3.0, 4.0, 5.0, 53.13010235415598),
        (7.0, 5.0, 10.0, math.degrees(math.acos(124 / 140))),  # obtuse: 7^2 + 5^2 < 10^2
    ],
)
def test_the_second_angle_by_the_height(base: float, own: float, opposite: float, known: float) -> None:
    sides = (Value(Name("length", "A", str(i)), "length", side) for i, side in enumerate((base, own, opposite)))
    found = by_height(*sides, Value(Name("angle", "B", "A C"), "angle", known))
    expected = math.degrees(math.acos((base**2 + own**2 - opposite**2) / (2 * base * own)))
    assert found.number(True) == pytest.approx(expected, abs=1e-9)


def test_corners_are_spelt_by_the_letters() -> None:
    assert corner_name("B", "C", "A").about == "A C"
    assert corner_name("C", "B", "O").about == "O B"


def test_a_given_angle_of_the_triangle_of_the_centre_is_used_as_it_is() -> None:
    # A ladder of 2.4 m at 30 degrees: AP = 2.4 cos 30 = 2.078, BP = 2.4 sin 30 = 1.2 m.
    text = text_of("ladder", "driven_at_wall", AB=2.4, phi=30)
    assert "AP = AB cos φ = 2.4 · cos 30° = 2.078 m" in text
    assert "BP = AB sin φ = 2.4 · sin 30° = 1.2 m" in text
    assert "∠BAP" not in text


def test_two_equal_sides_of_the_position_make_no_law_of_cosines() -> None:
    # OF = OB = 1.6 m with 50 degrees between: FB = 2 * 1.6 sin 25 = 1.352 m, and 65 degrees at the base.
    text = text_of("hydraulic_hoist", "boom", OF=1.6, OB=1.6, phi=50)
    assert "Triangle BFO is isosceles:" in text
    assert "2 · 1.6 · sin 25° = 1.352 m" in text
    assert "arctan" not in text and "arccos" not in text


def test_a_diagonal_over_three_links_by_a_right_triangle() -> None:
    # O below C: AB goes up by 90 - 30 cos 145 - 24 cos 80 = 110.4 and across by 24 sin 80 - 30 sin 145 = 6.428 cm.
    data = {"OA": 30, "AM": 62, "BM": 80, "BC": 24, "OC": 90, "phi": 145, "psi": 80}
    text = text_of("two_cranks_and_rod", "", **data)
    along = 90 - 30 * math.cos(math.radians(145)) - 24 * math.cos(math.radians(80))
    across = 24 * math.sin(math.radians(80)) - 30 * math.sin(math.radians(145))
    assert "In the right triangle ABH the leg AH is parallel to OC:" in text
    assert f"= {along:.1f} cm" in text and f"= {across:.3f} cm" in text
    assert f"AB = √(AH^2 + BH^2) = √(110.4^2 + 6.428^2) = {math.hypot(along, across):.1f} cm" in text
    assert "axis x" not in text and "x_A" not in text


def test_the_angles_at_the_base_of_an_isosceles_triangle_are_found_once() -> None:
    # Equal cranks with equal angles: AB is parallel to OC, 75 - 2 * 20 cos 140 = 105.64 cm; cos BAM = 105.64/136.
    data = {"OA": 20, "AM": 68, "BM": 68, "BC": 20, "OC": 75, "phi": 140, "psi": 140}
    text = text_of("two_cranks_and_rod", "", **data)
    assert "AB = OC − OA cos φ − BC cos ψ" in text and "= 105.6 cm" in text
    assert "Triangle ABM is isosceles:" in text
    assert "∠BAM = arccos(AB / (2 · AM)) = arccos(105.6 / (2 · 68)) ≈ 39.03°" in text
    assert "∠ABM" not in text


def test_the_height_is_taken_at_the_end_where_one_sine_is_enough() -> None:
    # The angle at A is near to a right one, that at B is not: arcsin at B, and A is a sum.
    text = text_of("four_bar", "crank", OA=26, AB=80, BC=64, OC=60, phi=40)
    square = 26**2 + 60**2 - 2 * 26 * 60 * math.cos(math.radians(40))  # CA by the law of cosines
    abc = math.degrees(math.acos((80**2 + 64**2 - square) / (2 * 80 * 64)))
    assert f"= {abc:.2f}°" in text
    assert "∠ABC = arcsin(AP sin ∠P / AB)" in text
    assert "∠OAB = ∠ABC + ∠P" in text


def test_a_perpendicular_may_fall_beyond_the_vertex() -> None:
    # By hand: 33 + 61 cos 145 = -16.97, so H is beyond C, and OCA = 180 - arctan(34.99 / 16.97).
    text = text_of("slotted_rocker", "rotating", OA=61, OC=33, CB=70, phi=145)
    leg, height = -33 - 61 * math.cos(math.radians(145)), 61 * math.sin(math.radians(145))
    assert "Drop the perpendicular AH to OC, produced beyond C:" in text
    assert f"CH = −OC − OA cos φ = −33 − 61 · cos 145° = {leg:.2f} cm" in text
    assert f"∠OCA = 180° − arctan(AH / CH) = 180° − arctan({height:.2f} / {leg:.2f})" in text
    assert f"= {180 - math.degrees(math.atan2(height, leg)):.2f}°" in text
    assert "horizontal" not in text and "vertical" not in text


@pytest.mark.parametrize(("phi", "said"), [(40, "to OC:"), (120, "to OC, produced beyond O:")])
def test_a_perpendicular_may_fall_beyond_the_other_end_of_the_line(phi: int, said: str) -> None:
    # From C the foot is at 60 - 26 cos phi: 40.1 with 40 degrees, between C and O; 73 with 120, beyond O.
    text = text_of("four_bar", "crank", OA=26, AB=80, BC=64, OC=60, phi=phi)
    assert f"Drop the perpendicular AH {said}" in text


def test_the_angle_of_a_right_triangle_is_named_by_its_foot() -> None:
    # AH = 50 - 20 cos 80 - 30 cos 70 along OC, BH = 30 sin 70 - 20 sin 80 across it.
    data = {"OA": 20, "AM": 60, "BM": 45, "BC": 30, "OC": 50, "phi": 80, "psi": 70}
    text = text_of("two_cranks_and_rod", "", **data)
    along = 50 - 20 * math.cos(math.radians(80)) - 30 * math.cos(math.radians(70))
    across = 30 * math.sin(math.radians(70)) - 20 * math.sin(math.radians(80))
    assert "∠BAH = arctan(BH / AH)" in text
    assert f"= {math.degrees(math.atan(across / along)):.2f}°" in text
    assert "horizontal" not in text


def test_equal_sides_of_the_triangle_of_the_centre_are_found_once() -> None:
    # The wall leans by 70 degrees: 70 + 55 - 90 at A and 90 - 55 at B are both 35, so AP = 2 / cos 35.
    text = text_of("ladder", "oblique", AB=4, phi=55, gamma=70)
    assert "Triangle ABP is isosceles with the base AB" in text
    assert f"BP = AP = {2 / math.cos(math.radians(35)):.3f} m" in text
