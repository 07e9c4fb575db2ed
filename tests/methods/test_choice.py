"""Which methods apply to which forms, and what is said of one that does not."""

from __future__ import annotations

import pytest

from tests.methods.applying import APPLYING
from tests.methods.forms import FORMS, IDS, tasks, variants
from variantgen.errors import InputError
from variantgen.families.asking import read_ask
from variantgen.families.method_names import METHODS
from variantgen.methods.choice import Choice, applicable, choose
from variantgen.methods.linkage.problem import task_of
from variantgen.methods.steps.method_style import MethodStyle


@pytest.mark.parametrize(("name", "form"), FORMS, ids=IDS)
def test_what_applies(name: str, form: str) -> None:
    (task,) = tasks(name, form, 1)
    expected = {method for method, forms in APPLYING.items() if (name, form) in forms}
    assert applicable(task) == sorted(expected)
    assert set(METHODS) == set(APPLYING)


@pytest.mark.parametrize("asked", ["mu_OA", "P_OA.O", "Q_OA.O"])
@pytest.mark.parametrize(
    ("name", "form"), [("quick_return_shaper", ""), ("slotted_rocker", "swinging"), ("slotted_rocker", "rotating")]
)
def test_where_only_the_pole_would_be_drawn_there_is_no_graphical_method(name: str, form: str, asked: str) -> None:
    """A crank whose rates are given: no point that moves is needed for the answer."""
    ((variant, *_), motion) = variants(name, form, 1)
    task = task_of(variant, motion, 0, read_ask(variant.form, [asked]))
    assert applicable(task) == ["analytical", "coordinates", "relative_motion"]


def first(name: str, form: str = "") -> object:
    (task,) = tasks(name, form or next(f for n, f in FORMS if n == name), 1)
    return task


def test_wishes_decide() -> None:
    task = first("four_bar")
    assert choose(task) == Choice(MethodStyle())
    assert choose(task, ["projections"]).style.velocities == "projections"
    assert choose(task, ["velocity_pole", "acceleration_pole"]).style == MethodStyle(
        "velocity_pole", "acceleration_pole", strict=True
    )
    assert choose(task, ["graphical"]).whole == "graphical"
    assert choose(first("plate_acceleration_centre")).style.accelerations == "acceleration_centre"
    assert choose(first("falling_rod")).style.velocities == "velocity_pole"


def test_a_method_that_does_not_apply_is_named_with_those_that_do() -> None:
    with pytest.raises(InputError) as caught:
        choose(first("rolling_wheel"), ["projections", "three_rates"])
    assert [problem.value for problem in caught.value.problems] == ["projections", "three_rates"]
    assert "velocity_centre" in caught.value.problems[0].remedy
