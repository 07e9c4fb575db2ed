"""The shortest natural route: ratios of first quantities, sums of two vectors, half sums, natural axes, remarks.

Numbers are worked out here from the data of the variants.
"""

from __future__ import annotations

from math import cos, radians, sin, sqrt

import pytest

from tests.methods.given_data import worked_book
from variantgen import explain
from variantgen.methods.solution.book import resultant
from variantgen.single import answers, one_variant
from variantgen.variants.variant import solve_variants


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
    assert "Perpendicular to AB the components of the two velocities differ by ω_AB·AB" in text
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
    assert "v_C′/B = (220 − 121) · cos" in solved("sleeve_on_crank", "", "146")[0]


def test_one_vector_over_the_other_is_a_tangent() -> None:
    # A wedge of 30 degrees that moves at 60: the rod goes up at 60 sin 30 / cos 30.
    variant = one_variant("wedge_and_rod", {"alpha": 30, "v": 60}, form="vertical", seed="1")
    text = str(explain(variant, language="en")).replace("\xa0", " ")
    assert f"v_A = 60 · tan 30° = 20√3 ≈ {20 * sqrt(3):.2f} cm/s" in text


def test_a_normal_component_that_vanishes_is_named_once() -> None:
    text, _ = solved("sleeve_on_crank", "", "146")
    assert text.count("ω_AB = 0, so (a_B/A)_n = 0.") == 1


def test_a_distance_that_nothing_is_computed_from_is_left_out() -> None:
    text, _ = solved("falling_rod", "", "12")
    assert "s = g · t^2 / 2" not in text
    assert "v_C = g · t" in text


def test_a_roller_cam_is_a_slider_crank() -> None:
    """With ``x_B = OC cos(phi) + sqrt(CB^2 - OC^2 sin(phi)^2)`` along the guide, ``v_B = |dx_B/dphi| omega``."""
    text, found = solved("cam_disc", "roller", "181")  # R = 24, OC = 16, r = 8, phi = 120 deg, omega = 4, epsilon = 2
    arm, rod, phi = 16.0, 32.0, radians(120)
    reach = sqrt(rod**2 - (arm * sin(phi)) ** 2)
    slope = -arm * sin(phi) - arm**2 * sin(phi) * cos(phi) / reach
    assert found["v_D"] == pytest.approx(-4 * slope, rel=1e-7)
    assert "moves like the slider of a slider-crank mechanism with the crank OC and the connecting rod CB" in text
    assert "v⃗_B = v⃗_C + v⃗_B/C" in text
    assert "(a_B/C)_n = v_B/C^2 / CB" in text
    assert "Coriolis" not in text


def test_the_rod_of_a_roller_cam_in_translation() -> None:
    text, found = solved("cam_disc", "roller", "128")  # OC = 15, CB = 31, phi = 90 deg, omega = 3, epsilon = 12
    assert found["v_D"] == pytest.approx(3 * 15, rel=1e-12)
    # dx_B/dphi = -OC, d2x_B/dphi2 = OC^2 / CB cos(psi): the acceleration along the guide.
    along = 12 * 15 - 3**2 * 15**2 / sqrt(31**2 - 15**2)
    assert found["a_D"] == pytest.approx(along, rel=1e-7)
    assert "the rod CB is in translation at this instant, v⃗_B = v⃗_C" in text
    assert "so (a⃗_B/C)_n = 0" in text


def test_a_flat_follower_takes_the_projection_of_the_centre() -> None:
    text, found = solved("cam_disc", "flat", "181")  # OC = 20, phi = 50 deg, omega = 6, epsilon = 2
    assert found["v_D"] == pytest.approx(6 * 20 * sin(radians(50)), rel=1e-7)
    assert "have equal components perpendicular to this face" in text
    assert "v_D = v_C sin φ = " in text
    assert "relative motion" not in text


def test_compound_motion_where_it_is_wished() -> None:
    assert "Coriolis" in solved("cam_disc", "roller", "181", ("relative_motion",))[0]
    assert "relative motion" in solved("cam_disc", "flat", "181", ("relative_motion",))[0]


@pytest.mark.parametrize("seed", ["121", "122", "7"])
def test_a_plate_on_rods_turns_about_the_crossing_of_two_of_them(seed: str) -> None:
    """``omega = v_B / BP`` with P where the lines DC and EF meet, from the places of the statement's figure."""
    text, found = solved("three_rod_plate", "", seed)
    variant = one_variant("three_rod_plate", seed=seed)
    z = {name: complex(place[0]) for name, place in solve_variants([variant], 1).z.items()}
    normals = z["C"] - z["D"], z["F"] - z["E"]
    below = (normals[0].conjugate() * normals[1]).imag
    centre = z["D"] + ((z["E"] - z["D"]).conjugate() * normals[1]).imag / below * normals[0]
    assert found["v_B"] / 100 == pytest.approx(abs(found["omega_BCF"] * (z["B"] - centre)), rel=1e-6)
    assert "P_BCF" in text
    assert "v⃗_A and v⃗_B have equal components along AB" in text
    assert text.count("two linear equations") == 1  # those of the accelerations


def test_three_equations_for_a_plate_with_a_remote_centre(monkeypatch: pytest.MonkeyPatch) -> None:
    monkeypatch.setattr("variantgen.methods.centres.guided_body._FAR", 0.5)  # P of this variant is 1.3 sides from B
    text, _ = solved("three_rod_plate", "", "121")
    assert "P_BCF" not in text
    assert text.count("two linear equations") == 2
    assert "P_BCF" in solved("three_rod_plate", "", "121", ("velocity_centre",))[0]


def test_three_equations_for_a_plate_where_the_pole_is_wished() -> None:
    text, _ = solved("three_rod_plate", "", "121", ("velocity_pole",))
    assert "P_BCF" not in text
    assert text.count("two linear equations") == 2


def test_the_other_end_of_a_diameter_has_twice_the_velocity_of_the_centre() -> None:
    text, found = solved("planetary_train", "ring", "154")  # OA = 22, r_3 = 32, omega = 1.5
    assert "N is twice as far from P as A: v_N = 2 v_A = 2 · 33 = 66" in text
    assert found["omega_gear3"] == pytest.approx(2 * 1.5 * 22 / 32, rel=1e-7)


def test_the_ends_of_a_diameter_have_half_their_sum_at_the_centre() -> None:
    text, found = solved("movable_pulley", "load_and_axle", "135")  # v_A = 2, v_E = 1.2, a_A = 1 and a_E = 2
    assert "v_G = 2 v_C − v_D = 2 · 1.2 − 2 = 0.4" in text
    assert "(a_G)_t = 2 a_C + (a_D)_t = 2 · 2 + 1 = 5" in text
    assert (found["v_B"], found["a_B"]) == pytest.approx((0.4, 5.0), rel=1e-12)


def test_a_right_triangle_beyond_another_corner_spares_a_law_of_cosines() -> None:
    text, found = solved("plate_acceleration_centre", "square", "149")  # AB = 1.5, a_A = 4, omega = 2, epsilon = 4
    assert "EQ = AQ + AB" in text
    assert "DQ = √(EQ^2 + AB^2)" in text
    assert "cosines" not in text
    reach = 1.5 + 4 / sqrt(4**2 + 2**4)
    assert found["a_D"] == pytest.approx(sqrt(reach**2 + 1.5**2) * sqrt(4**2 + 2**4), rel=1e-7)


def test_the_contact_as_base_point_checks_an_acceleration() -> None:
    """The component along MO with both base points: R = 0.75, MP = 2 R cos(30 deg), omega = 4, epsilon = 8/3."""
    text, _ = solved("rolling_wheel", "", "135")
    along = 12 - 2 * sin(radians(60))
    chord = 2 * 0.75 * cos(radians(30))
    about_contact = 16 * chord * cos(radians(30)) - 8 / 3 * chord * sin(radians(30)) - 12 * cos(radians(60))
    assert about_contact == pytest.approx(along, rel=1e-12)
    assert text.count(f"= {along:.2f}") == 2


def test_a_check_takes_no_number_that_the_solution_does_not_show() -> None:
    variant = one_variant("rolling_wheel", seed="135")
    text = " ".join(str(explain(variant, language="en", ask=["a_M"])).replace("\xa0", " ").split())
    assert "MP" not in text
    assert "P as base point" not in text
    text, _ = solved("pulley_and_wheel", "axle", "5313")  # epsilon_1 has no line: a_C MP / R_1 stands for epsilon_1 MP
    assert "(60 · 64.10 / 38) · sin" in text


@pytest.mark.parametrize(("form", "seed"), [("offset", "107"), ("driven_by_slider", "5"), ("central", "3")])
def test_the_rod_and_the_ray_have_one_projection_on_the_guide(form: str, seed: str) -> None:
    """``AP = v_A / omega`` printed in centimetres is ``AB cos(psi) / cos(theta)`` with the angles of the places."""
    text, found = solved("slider_crank", form, seed)
    motion = solve_variants([one_variant("slider_crank", form=form, seed=seed)], 1)
    o, a, b = (complex(motion.z[name][0]) for name in "OAB")
    guide = complex(motion.v["B"][0])
    angles = [abs(((end - a) * guide.conjugate()).real) / abs((end - a) * guide) for end in (b, o)]
    arm = abs(b - a) * angles[0] / angles[1]
    assert "AP and AB have the same projection on the path of B" in text
    assert f"= {100 * arm:.4g}" in text  # the program gives 151.64 for a leading one
    assert abs(complex(motion.v["A"][0])) / arm == pytest.approx(abs(found["omega_AB"]), rel=1e-6)


def test_the_given_angle_of_a_guide_is_that_of_all_points_of_a_body_in_translation() -> None:
    # The guide holds another point of the rod than A; gamma lies between rod and face.
    text, _ = solved("wedge_and_rod", "inclined", "3")
    assert "v_A sin γ = v sin δ" in text


@pytest.mark.parametrize(("sense", "way"), [(1, 1), (-1, 1), (1, -1)])
def test_a_bent_rod_is_taken_by_its_corner(sense: int, way: int) -> None:
    """OE = 30 and EM = 40 are square: the vectors of E and those about E lie along the slot and across it."""
    data = {"OE": 30, "EM": 40, "omega_OEB": 2, "epsilon_OEB": 5, "v_rel_M": 35, "a_rel_M": 20}
    book = worked_book("sliding_block_on_rotating_rod", "offset", "v_M a_M", **data, sense=sense, way=way)
    assert not [name for name in book.values if {name.of, name.about} == {"M", "O"}]  # no distance MO
    e, m, slot = 30j, 30j + 40, 1.0  # E above O, the slot to the right
    turn, slide, faster = 2j * sense, 35.0 * way, 20.0
    assert abs(resultant(book.velocity["M"])) == pytest.approx(abs(turn * m + slide * slot))
    whole = (5j - 4) * m + 2 * turn * slide + faster * slot
    assert abs(resultant(book.acceleration["M"])) == pytest.approx(abs(whole))
    assert abs(resultant(book.velocity["E"])) == pytest.approx(abs(turn * e))
