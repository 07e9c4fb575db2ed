"""The shortest natural route: ratios of first quantities, sums of two vectors, half sums, natural axes, remarks.

Numbers are worked out here from the data of the variants.
"""

from __future__ import annotations

from math import cos, radians, sqrt

import pytest

from variantgen import explain
from variantgen.single import answers, one_variant


def solved(family: str, form: str, seed: str, methods: tuple[str, ...] = ()) -> tuple[str, dict[str, float]]:
    """The text of a solution on one line, and its answers."""
    variant = one_variant(family, form=form, seed=seed)
    text = str(explain(variant, language="en", methods=list(methods)))
    return " ".join(text.replace("\xa0", " ").split()), {a.quantity.name: a.value for a in answers(variant)}


def test_a_velocity_by_the_centre_is_a_ratio_of_first_quantities() -> None:
    text, _ = solved("slider_crank", "offset", "107")
    assert "v_B = v_A · BP / AP = 117 · " in text
    assert "ω_AB · BP" not in text


def test_the_projections_give_omega_by_the_components_across() -> None:
    text, _ = solved("slider_crank", "offset", "107", ("projections",))
    assert "Across AB the two velocities differ by ω_AB·AB" in text
    assert "AP" not in text


def test_a_further_point_is_found_by_two_velocities_and_not_by_a_remote_centre() -> None:
    text, found = solved("movable_pulley", "load_and_axle", "135")
    across, along = 0.8 * cos(radians(30)), 1.2 + 0.8 / 2  # v_MC = 1.6 * 0.5, and v_C = 1.2 m/s
    assert found["v_M"] == pytest.approx(sqrt(across**2 + along**2), rel=1e-7)
    assert "v⃗_M = v⃗_C + v⃗_M/C" in text
    assert "CP" not in text
    assert "CP" in solved("movable_pulley", "load_and_axle", "135", ("velocity_centre",))[0]


def test_tangential_parts_that_cancel_are_said_to_cancel() -> None:
    text, found = solved("disc_in_cylinder", "inside", "138")
    assert found["a_P"] == pytest.approx(80**2 / 48 + 4**2 * 20, rel=1e-7)
    assert "The vectors (a⃗_O)_t and (a⃗_P/O)_t cancel. a_P = (a_O)_n + (a_P/O)_n" in text
    assert "(a_M/O)_n = (a_P/O)_n" in text
    assert "a_M x" not in text


def test_a_midpoint_has_half_the_sum() -> None:
    text, found = solved("ladder", "driven_at_wall", "139")
    assert found["a_C"] == pytest.approx(sqrt(1 + 27) / 2, rel=1e-7)
    assert "C is the midpoint of AB: a⃗_C = (a⃗_A + a⃗_B)/2. a⃗_A ⟂ a⃗_B, so" in text
    assert "v_C = ω_AB · CP = v_B" in text  # CP = AB / 2 = BP
    assert "(a_C/A)_t" not in text


def test_an_identity_is_used_as_one() -> None:
    assert "(a_A/O)_t = α · R = a_O = 2 m/s²" in solved("rolling_wheel", "", "135")[0]


def test_collinear_vectors_are_subtracted_before_they_are_projected() -> None:
    assert "v_C/B = (220 − 121) · cos" in solved("sleeve_on_crank", "", "146")[0]


def test_a_normal_component_that_vanishes_is_named_once() -> None:
    text, _ = solved("sleeve_on_crank", "", "146")
    assert text.count("ω_AB = 0, so (a_B/A)_n = 0.") == 1


def test_a_distance_that_nothing_is_computed_from_is_left_out() -> None:
    text, _ = solved("falling_rod", "", "12")
    assert "s = g · t^2 / 2" not in text
    assert "v_C = g · t" in text
