"""Which methods apply to which forms, and what is said of one that does not."""

from __future__ import annotations

import pytest

from tests.methods.forms import FORMS, IDS, tasks
from variantgen.errors import InputError
from variantgen.families.method_names import METHODS
from variantgen.methods.choice import Choice, applicable, choose
from variantgen.methods.steps.style import Style

# Points that slide on moving bodies.
SLIDING = {
    "arc_yoke", "cam_disc", "four_bar_with_sleeve", "hydraulic_hoist", "oscillating_cylinder",
    "parallelogram_with_disc", "point_on_rotating_disc", "quick_return_shaper", "scotch_yoke", "sleeve_on_crank",
    "sliding_block_on_rotating_rod", "slotted_rocker", "wedge_and_rod",
}  # fmt: skip
# Rods with one known point and another of known direction.
RODS = {
    "disc_on_arc_with_rod", "four_bar", "four_bar_with_sleeve", "hydraulic_hoist", "ladder", "quick_return_shaper",
    "rod_in_circular_guide", "sleeve_on_crank", "slider_crank", "slider_crank_with_second_rod", "triangle_plate",
    "two_loop_mechanism", "wheel_with_rod",
}  # fmt: skip


@pytest.mark.parametrize(("name", "form"), FORMS, ids=IDS)
def test_what_applies(name: str, form: str) -> None:
    (task,) = tasks(name, form, 1)
    found = applicable(task)
    assert set(found) <= set(METHODS)
    assert found == sorted(found)
    assert "coordinates" in found
    if "relative_motion" in found:
        assert name in SLIDING
    if "projections" in found:
        assert name in RODS
    if "three_rates" in found:
        assert name in {"four_bar", "four_bar_with_sleeve"}
    if name in {"three_rod_plate", "guided_plate"}:
        assert "graphical" not in found
    if name != "parallelogram_with_disc":  # rotation and translation alone
        assert {"velocity_centre", "velocity_pole", "relative_motion", "acceleration_pole", "graphical"} & set(found)


def first(name: str, form: str = "") -> object:
    (task,) = tasks(name, form or next(f for n, f in FORMS if n == name), 1)
    return task


def test_wishes_decide() -> None:
    task = first("four_bar")
    assert choose(task) == Choice(Style())
    assert choose(task, ["projections"]).style.velocities == "projections"
    assert choose(task, ["velocity_pole", "acceleration_pole"]).style == Style("pole", "pole")
    assert choose(task, ["graphical"]).whole == "graphical"
    assert choose(first("plate_acceleration_centre")).style.accelerations == "acceleration_centre"
    assert choose(first("falling_rod")).style.velocities == "pole"


def test_a_method_that_does_not_apply_is_named_with_those_that_do() -> None:
    with pytest.raises(InputError) as caught:
        choose(first("rolling_wheel"), ["projections", "three_rates"])
    assert [problem.value for problem in caught.value.problems] == ["projections", "three_rates"]
    assert "velocity_centre" in caught.value.problems[0].remedy
