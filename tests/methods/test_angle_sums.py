"""Angles between directions are what they are in the figure: given angles, corners, short sums of them."""

from __future__ import annotations

import math

import pytest

from variantgen.algebra.expression import Applied, Constant, Total, Value
from variantgen.algebra.name import Name
from variantgen.methods.geometry.angle_sums import acute, angle_sum, difference, supplement
from variantgen.methods.geometry.angles import AngleForm
from variantgen.methods.geometry.geometry import Geometry
from variantgen.methods.geometry.trigonometry import reduced
from variantgen.outputs.single.explanation import explain
from variantgen.single import one_variant

PHI = Value(Name("parameter", "phi"), "angle", 30.0)
BASE = Value(Name("direction", "O", "A"), "angle", 100.0, Constant(100.0, "angle"))
CORNER = Value(Name("angle", "A", "B O"), "angle", 60.0, Applied("arccos", Constant(0.5)))


def test_what_directions_are_counted_from_cancels() -> None:
    first = Value(None, "angle", 130.0, Total(((1, BASE), (1, PHI))))
    assert difference(None, first, BASE) is PHI
    assert difference(None, BASE, Geometry.turned(first, 180.0)).exact == 150.0


def test_a_corner_stays_and_a_sum_is_taken_apart() -> None:
    direction = Value(Name("direction", "A", "B"), "angle", -70.0, Total(((1, PHI), (-1, BASE))))
    turned = Value(None, "angle", -10.0, Total(((1, direction), (1, CORNER))))
    assert dict(angle_sum(turned).parts) == {PHI: 1.0, BASE: -1.0, CORNER: 1.0}
    assert difference(None, turned, direction) is CORNER


@pytest.mark.parametrize(("by", "function"), [(0.0, "cos"), (90.0, "sin"), (-90.0, "sin"), (180.0, "cos")])
def test_an_acute_angle_is_that_of_the_simplest_function(by: float, function: str) -> None:
    first = Value(None, "angle", 130.0, Total(((1, BASE), (1, PHI))))
    size = 30.0 if by % 180.0 == 0 else 60.0
    assert acute(first, Geometry.turned(BASE, by), size) == (function, PHI)


@pytest.mark.parametrize("name", ["planetary_pair", "disc_in_cylinder", "crank_and_disc", "gear_pair_with_crank"])
def test_no_direction_is_taken_from_the_drawing(name: str) -> None:
    text = str(explain(one_variant(name, seed="23"), language="en"))
    assert "from the figure" not in text
    assert "φ_" not in text


def test_the_supplement_of_a_single_angle_is_that_angle() -> None:
    obtuse = Value(Name("parameter", "alpha"), "angle", 115.0)
    acute_angle = Value(None, "angle", 65.0, Constant(180.0, "angle") - obtuse)
    assert supplement(acute_angle) is obtuse
    assert supplement(obtuse) is None
    assert supplement(Value(None, "angle", 35.0, Constant(180.0, "angle") - obtuse - PHI)) is None


def test_an_obtuse_given_angle_stands_in_its_cosine() -> None:
    data = {"OA": 24, "r": 13, "alpha": 115, "omega_OA": 5}
    text = str(explain(one_variant("crank_and_disc", data, seed="1", form="absolute"), language="en"))
    assert "180° −" not in text
    assert "cos\N{NO-BREAK SPACE}115°" in text


def test_the_third_corner_of_a_triangle_has_its_name() -> None:
    # Triangle OBF with OB = 1.4, OF = 2.0 and 70 degrees at O: BF and the angle at B by hand.
    variant = one_variant("hydraulic_hoist", {"OB": 1.4, "OF": 2.0, "phi": 70}, seed="1", form="boom")
    text = str(explain(variant, language="en"))
    bf = math.sqrt(1.4**2 + 2.0**2 - 2 * 1.4 * 2.0 * math.cos(math.radians(70)))
    at_b = math.degrees(math.acos((1.4**2 + bf**2 - 2.0**2) / (2 * 1.4 * bf)))
    at_f = 180.0 - 70.0 - at_b
    assert f"∠OBF = 180° − ∠OFB − φ = 180° − {at_f:.2f}° − 70° = {at_b:.2f}°" in text
    assert "cos\N{NO-BREAK SPACE}∠OBF" in text


def test_an_inclination_is_worked_out_without_three_quarters_of_a_turn() -> None:
    # AB is at alpha + beta - 180 = 50 degrees to the guide of B: v_A sin 100 = v_B cos 50.
    data = {"O1A": 0.4, "AB": 1.6, "DE": 1.2, "O2E": 0.5, "alpha": 130, "beta": 100, "gamma": 105, "phi": 75}
    text = str(explain(one_variant("two_loop_mechanism", data, seed="1", form="level"), language="ru"))
    text = text.replace("\N{NO-BREAK SPACE}", " ")
    assert "270°" not in text
    assert "ψ = α + β − 180° = 130° + 100° − 180° = 50°" in text
    assert "v_A sin β = v_B cos ψ" in text


def test_a_sum_of_two_corners_is_a_corner_of_the_mechanism() -> None:
    # By hand: ABC = 75.892 degrees, 75.90 by the printed 43.94 and 60.16; OAB = 19.49 degrees.
    data = {"OA": 20, "AB": 40, "BC": 32, "OC": 40, "phi": 90, "omega_OA": 4.5, "epsilon_OA": 3}
    variant = one_variant("four_bar", data, seed="174", form="crank")
    text = str(explain(variant, methods=("velocity_pole", "acceleration_pole"), language="en"))
    text = text.replace("\N{NO-BREAK SPACE}", " ")
    assert "∠ABC = 180° − ∠CAB − ∠ACB = 180° − 43.94° − 60.16° = 75.90°" in text
    assert "∠OAB = 90° − ∠CAB − ∠OCA = 90° − 43.94° − 26.57° = 19.49°" in text
    assert "v_B sin ∠ABC = v_A sin ∠OAB" in text
    assert text.count("    ∠ABC = ") == 1


GIVEN = {name: Value(Name("parameter", name), "angle", size) for name, size in (("beta", 105.0), ("phi", 150.0))}


class _Given:
    """Angles of which all is known: beta = 105 and phi = 150 degrees."""

    def taken_apart(self, form: AngleForm) -> AngleForm:
        return form

    def atom(self, atom: str) -> Value:
        return GIVEN[atom]

    def number(self, form: AngleForm) -> float:
        total = form.constant + sum(count * GIVEN[str(atom)].exact for atom, count in form.parts)
        return (total + 180.0) % 360.0 - 180.0


@pytest.mark.parametrize("function", ["sin", "cos"])
def test_a_sum_of_given_angles_beyond_180_degrees_is_turned_back(function: str) -> None:
    """sin(105 + 150) = -sin(105 + 150 - 180): a length that is a projection has no minus and no negative sine."""
    sign, item = reduced(_Given(), function, AngleForm((("beta", 1.0), ("phi", 1.0))))  # type: ignore[arg-type]
    assert sign == -1
    assert isinstance(item, Applied)
    assert item.function == function
    assert item.argument.number(True) == pytest.approx(75.0)
