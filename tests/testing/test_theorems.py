"""Each theorem sees the mistake that it is for; motions of others are read as they are written."""

from __future__ import annotations

import sys
from typing import Any

import numpy as np
import pytest
from hypothesis import Phase, given, settings
from msgspec.structs import replace

from variantgen import testing
from variantgen.errors import InputError, ToolMissingError
from variantgen.mechanism.motion import Motion
from variantgen.mechanism.scene import Scene
from variantgen.mechanism.solving.solve import solve
from variantgen.testing import motion_of
from variantgen.testing.linkages import four_bar, sleeve_on_crank, slider_crank, wheel
from variantgen.variants.variant import Variant

FOUR = solve(four_bar(0.2, 0.5, 0.4, 0.6, 1.0, 2.0, 1.0))


def with_velocity(motion: Motion, point: str, change: complex) -> Motion:
    return replace(motion, v={**motion.v, point: motion.v[point] + change})


def test_projections_see_a_velocity_along_the_rod_and_not_across() -> None:
    rod = FOUR.z["M"] - FOUR.z["A"]
    along, across = (with_velocity(FOUR, "M", k * rod[0]) for k in (0.1, 0.1j))
    fastest = max(abs(v[0]) for v in along.v.values())
    assert testing.equal_projections(along)[0] == pytest.approx(0.1 * abs(rod[0]) / fastest)
    assert testing.equal_projections(across)[0] < 1e-12
    assert testing.power_balance_of_constraints(across)[0] > 0.01


def test_the_centre_sees_a_wrong_angular_velocity() -> None:
    assert testing.centre_consistent(FOUR)[0] < 1e-12
    wrong = replace(FOUR, omega={**FOUR.omega, "AB": 1.01 * FOUR.omega["AB"]})
    assert testing.centre_consistent(wrong)[0] > 1e-4
    assert testing.equal_projections(wrong)[0] < 1e-12


def test_rolling_sees_slip() -> None:
    right = solve(wheel(0.3, 2.0, 1.0))
    assert testing.rolling_contact_at_rest(right)[0] < 1e-12
    slipping = replace(right, omega={"wheel": 0.9 * right.omega["wheel"]})
    # The contact slips with a tenth of v, the top has twice v.
    assert testing.rolling_contact_at_rest(slipping)[0] == pytest.approx(0.1 / 2)


def test_coriolis_sees_half_of_it() -> None:
    right = solve(sleeve_on_crank(0.5, 0.2, 0.7, 0.3, 1.0, 3.0, 1.0))
    assert testing.coriolis_direction(right)[0] < 1e-12
    wrong = replace(right, epsilon={**right.epsilon, "BD": right.epsilon["BD"] + 1.0})
    # The transport acceleration of C changes by one rad/s^2 times its distance from B, across the rod.
    largest = max(abs(a[0]) for a in right.a.values())
    assert testing.coriolis_direction(wrong)[0] == pytest.approx(abs(right.z["C"] - right.z["B"])[0] / largest)


def test_power_sees_a_slider_off_its_guide_and_a_driver_that_is_not_followed() -> None:
    right = solve(slider_crank(0.2, 0.6, 0.05, 1.0, 2.0, 1.0))
    assert testing.power_balance_of_constraints(right)[0] < 1e-8
    assert testing.power_balance_of_constraints(with_velocity(right, "B", 0.1j))[0] > 0.01
    faster = testing.scaling(right, right, time=0.5)
    assert faster[0] > 0.1
    doubled = solve(slider_crank(0.2, 0.6, 0.05, 1.0, 4.0, 1.0))
    of_another_driver = replace(doubled, scene=right.scene)
    assert testing.equal_projections(of_another_driver)[0] < 1e-12
    assert testing.power_balance_of_constraints(of_another_driver)[0] > 0.1


def test_comparisons_see_one_wrong_sign() -> None:
    assert testing.time_reversal(FOUR, FOUR)[0] > 0.5
    back = {name: -x for name, x in FOUR.v.items()}
    turned = {name: -x for name, x in FOUR.omega.items()}
    reversed_motion = replace(FOUR, v=back, omega=turned)
    assert testing.time_reversal(FOUR, reversed_motion)[0] < 1e-15
    assert testing.time_reversal(FOUR, replace(reversed_motion, omega=FOUR.omega))[0] > 0.1
    assert testing.mirror(FOUR, FOUR)[0] > 0.1
    assert testing.mirror(FOUR, solve(testing.mirrored(FOUR.scene)))[0] < 1e-12
    # In a mirror along the y axis, by hand.
    seen = [{name: -np.conj(x) for name, x in table.items()} for table in (FOUR.z, FOUR.v, FOUR.a)]
    rates = [{name: -x for name, x in table.items()} for table in (FOUR.omega, FOUR.epsilon)]
    image = replace(FOUR, z=seen[0], v=seen[1], a=seen[2], omega=rates[0], epsilon=rates[1])
    assert testing.mirror(FOUR, image, np.pi / 2)[0] < 1e-12


def test_a_motion_that_is_solved_once_only_differs_infinitely() -> None:
    unsolved = replace(FOUR, outcome=np.array([1], np.int8))
    assert testing.scaling(FOUR, unsolved)[0] == np.inf
    assert testing.scaling(unsolved, unsolved)[0] == 0
    with pytest.raises(ValueError, match="z is known of"):
        testing.scaling(FOUR, solve(wheel(0.3, 1.0)))


def test_vectors_may_be_complex_numbers_or_pairs() -> None:
    places = np.array([[0.0, 0.0], [3.0, 4.0]])
    one = motion_of({"AB": ("A", "B")}, {"A": 0, "B": 3 + 4j}, {"A": 5, "B": 1 + 3j})
    pairs = motion_of({"AB": ("A", "B")}, {"A": places[0], "B": places[1]}, {"A": (5, 0), "B": (1, 3)})
    many = motion_of({"AB": ("A", "B")}, {"A": 0, "B": np.full((4, 2), (3, 4))}, {"A": 5, "B": np.full(4, 1 + 3j)})
    assert [motion.size for motion in (one, pairs, many)] == [1, 1, 4]
    for motion in (one, pairs, many):
        assert np.all(motion.z["B"] == 3 + 4j)
        assert testing.equal_projections(motion).max() < 1e-15


def test_what_is_missing_is_said() -> None:
    with pytest.raises(InputError, match="the point B of a body is missing"):
        motion_of({"AB": ("A", "B")}, {"A": 0}, {"A": 1, "B": 1})
    with pytest.raises(InputError, match=r"did you mean AB\?"):
        motion_of({"AB": ("A", "B")}, {"A": 0, "B": 1}, {"A": 1, "B": 1}, omega={"AC": 1})
    motion = motion_of({"AB": ("A", "B")}, {"A": 0, "B": 1}, {"A": 1, "B": 1})
    with pytest.raises(ValueError, match="the angular velocity of AB is needed"):
        testing.centre_consistent(motion)


@pytest.mark.parametrize(
    ("changes", "says"),
    [
        ({"pivots": ("X",)}, r"pivots: this point is missing in z, v \(got X\)"),
        ({"pivots": ("K",)}, r"pivots: this point is missing in v \(got K\)"),
        ({"slots": {"X": ("rod", "A", "B")}}, r"slots: this point is missing in z, v \(got X\)"),
        ({"slots": {"C": ("ZZ", "A", "B")}}, r"slots\.C: is no body \(got ZZ\)"),
        ({"slots": {"C": ("rod", "A", "C")}}, r"slots\.C: is no point of rod \(got C\)"),
        ({"slots": {"C": ("rod", "A")}}, r"slots\.C: expected a body and two of its points"),
        ({"rolling": {"w": ("C", "K")}}, r"rolling: is no body \(got w\)"),
        ({"rolling": {"wheel": ("A", "K")}}, r"rolling\.wheel: is no point of wheel \(got A\)"),
        ({"rolling": {"wheel": ("C", "Z")}}, r"rolling\.wheel: has no place in z \(got Z\)"),
        ({"rolling": {"wheel": "C"}}, r"rolling\.wheel: expected its centre and its point of contact"),
        ({"bodies": {"rod": ("A", "B"), "wheel": ()}}, r"bodies\.wheel: expected the names of its points"),
        ({"v": {"A": 1, "B": 1, "C": 1, "D": 1}}, r"v: has no place in z \(got D\)"),
    ],
)
def test_names_that_do_not_fit_together_are_told(changes: dict[str, Any], says: str) -> None:
    right: dict[str, Any] = {
        "bodies": {"rod": ("A", "B"), "wheel": ("C",)},
        "z": {"A": 0, "B": 2, "C": 1, "K": 1 - 1j},
        "v": {"A": 1, "B": 1, "C": 1},
        "omega": {"rod": 0, "wheel": -1},
        "slots": {"C": ("rod", "A", "B")},
        "rolling": {"wheel": ("C", "K")},
    }
    motion = motion_of(**right)
    assert testing.rolling_contact_at_rest(motion)[0] == testing.coriolis_direction(motion)[0] == 0
    assert testing.power_balance_of_constraints(motion)[0] < 1e-8
    with pytest.raises(InputError, match=says):
        motion_of(**{**right, **changes})


def test_without_hypothesis_theorems_work_and_strategies_say_what_to_install(monkeypatch: pytest.MonkeyPatch) -> None:
    monkeypatch.setitem(sys.modules, "hypothesis", None)
    assert testing.equal_projections(FOUR)[0] < 1e-12
    for strategy in (testing.mechanisms, testing.scenes, lambda: testing.variants("four_bar")):
        with pytest.raises(ToolMissingError, match=r'hypothesis; install it .* pip install "\.\[testing\]"'):
            strategy()


@given(testing.variants("four_bar", form="rocker", set={"side": "left"}, range={"phi": [60, 90]}))
def test_variants_are_those_that_are_wanted(variant: Variant) -> None:
    assert (variant.family.name, variant.form.name, variant.word("side")) == ("four_bar", "rocker", "left")
    assert 60 <= variant.printed["phi"] <= 90
    assert variant.motion().solved[0]


def test_variants_are_of_all_forms_that_have_what_is_wanted() -> None:
    seen: dict[str, set[str]] = {"any": set(), "narrowed": set()}

    @given(testing.variants("four_bar"), testing.variants("four_bar", range={"phi": [60, 90]}))
    def collected(variant: Variant, narrowed: Variant) -> None:
        seen["any"].add(variant.form.name)
        seen["narrowed"].add(narrowed.form.name)

    collected()
    assert seen["any"] >= {"crank", "rocker", "directions"}
    assert {"crank", "rocker"} <= seen["narrowed"]
    assert "directions" not in seen["narrowed"], "it has no angle phi"


def test_an_example_is_told_in_one_line() -> None:
    @settings(phases=[Phase.generate])
    @given(testing.variants("slotted_rocker"))
    def wrong(variant: Variant) -> None:
        assert variant.si("OA") < 0.01

    with pytest.raises(AssertionError) as found:
        wrong()
    assert any("variant=<Variant of slotted_rocker" in note for note in found.value.__notes__)


def test_a_mistake_in_what_is_wanted_is_told_at_once() -> None:
    with pytest.raises(InputError, match="did you mean four_bar"):
        testing.variants("four_bra")
    for name in ("n", "seed"):
        with pytest.raises(InputError, match=rf"{name}: is chosen by Hypothesis.* \(got 1\)"):
            testing.variants("four_bar", **{name: 1})


def test_random_chains_have_all_kinds_of_dyads() -> None:
    seen: set[str] = set()

    @given(testing.scenes())
    def collected(scene: Scene) -> None:
        seen.update(type(joint).__name__ for joint in scene.joints)
        assert solve(scene).solved.all()
        assert len(scene.bodies) >= 2

    collected()
    assert seen >= {"Pivot", "Guide", "Slot"}


def test_parameters_are_in_si_and_rescaled() -> None:
    import variantgen

    variant = variantgen.batch("four_bar", 1, set={"OA": 30, "omega_OA": 2, "phi": 60, "side": "right"})[0]
    p, q = testing.parameters(variant), testing.parameters(variant, length=10, time=-1)
    assert (p["OA"], p["omega_OA"], p["side"]) == pytest.approx((0.3, 2, -1))
    assert p["phi"] == pytest.approx(np.pi / 3)
    assert (q["OA"], q["omega_OA"], q["epsilon_OA"]) == pytest.approx((3, -2, p["epsilon_OA"]))
