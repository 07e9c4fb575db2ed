"""A solution has no step and no line of the position that nothing else needs, and names its axes and origin."""

from __future__ import annotations

import pytest

from tests.methods.forms import tasks
from variantgen.algebra.name import Name
from variantgen.families.asking import read_ask
from variantgen.methods.compose import solution
from variantgen.methods.linkage.problem import Task
from variantgen.methods.steps.step import Body, Derived, Point, Sentence, Step


def asking(name: str, form: str, asked: list[str]) -> Task:
    task = tasks(name, form, 1)[0]
    return Task(task.variant, tuple(read_ask(task.form, asked)), task.now)


def headings(steps: tuple[Step, ...]) -> list[str]:
    return [step.heading.key for step in steps]


def derived(steps: tuple[Step, ...]) -> set[Name | None]:
    return {item.value.name for step in steps for item in step.items if isinstance(item, Derived)}


def sentences(steps: tuple[Step, ...]) -> list[str]:
    return [item.key for step in steps for item in step.items if isinstance(item, Sentence)]


def test_the_second_crank_of_a_parallelogram_is_not_asked() -> None:
    steps = solution(asking("parallelogram_with_disc", "moving_point", ["v_M", "a_M"])).steps
    assert "relative.velocity" in headings(steps)
    assert not any(step.heading.facts.get("body") == Body("O2B") for step in steps)
    assert Name("v", "B") not in derived(steps)
    with_it = solution(asking("parallelogram_with_disc", "moving_point", ["v_M", "v_B"])).steps
    assert Name("v", "B") in derived(with_it)


@pytest.mark.parametrize(("asked", "output"), [(["a_rel_A"], False), (["v_B", "a_rel_A"], True)])
def test_velocities_that_no_acceleration_depends_on(asked: list[str], output: bool) -> None:
    # The yoke is in translation: there is no Coriolis acceleration to need the relative velocity.
    steps = solution(asking("scotch_yoke", "straight", asked)).steps
    assert ("relative.velocity" in headings(steps)) == output
    assert sentences(steps).count("relative.compound_translation") == 1


def test_a_direction_that_only_the_drawing_has_is_left_out_where_nothing_is_projected() -> None:
    steps = solution(asking("planetary_train", "two_suns", ["omega_gear2", "v_A"])).steps
    assert "position.drawn" not in sentences(steps)
    assert Name("direction", "O", "A") not in derived(steps)
    assert Name("length", "A", "O") in derived(steps)


def test_axes_and_origin_are_told_once_where_they_are_needed() -> None:
    by_coordinates = solution(asking("guided_plate", "", ["v_C"]), ("coordinates",))
    plate = sentences(by_coordinates.steps)
    assert plate.count("position.axes_and_rays") == 1
    assert plate.count("position.origin_by") == 1  # the guides cross there, no point has a letter
    gears = sentences(solution(asking("planetary_pair", "outside", ["omega_gear1"])).steps)
    assert not any(key.startswith(("position.axes", "position.origin")) for key in gears)


def test_a_step_that_only_writes_known_components_down_again_is_left_out() -> None:
    # The normal acceleration of F about the pole C is found with those of the plate; a_F itself is not asked.
    steps = solution(asking("three_rod_plate", "", ["a_B", "epsilon_BCF"])).steps
    output = [step.heading.facts.get("point") for step in steps if step.heading.key == "points.by_pole_a"]
    assert output == [Point("B")]
