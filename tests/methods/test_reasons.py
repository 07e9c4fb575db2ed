"""What a solution says beside its formulas: why a component is there, what is zero, where a vector points."""

from __future__ import annotations

import pytest

from tests.methods.given_data import sentences
from variantgen.methods.step import Point, Word


def said(family: str, form: str, ask: str, **data: float) -> list[str]:
    """Keys of the sentences of a solution."""
    return [sentence.key for sentence in sentences(family, form, ask, **data)]


@pytest.mark.parametrize("form", ["inside", "outside", "by_centre"])
def test_the_centre_of_a_disc_on_a_circle_moves_on_a_circle(form: str) -> None:
    found = [s.facts for s in sentences("disc_in_cylinder", form, "a_O") if s.key == "common.circle"]
    assert found == [{"point": Point("O"), "centre": Point("C")}]


def test_a_relative_path_that_is_a_circle() -> None:
    assert "relative.circle" in said("arc_yoke", "", "a_rel_A")
    assert "relative.circle" not in said("arc_yoke", "", "v_rel_A")


def test_rotations_about_parallel_axes_add_up() -> None:
    found = said("crank_and_disc", "relative", "epsilon_disc1")
    assert found.index("turning.sum_omega") < found.index("turning.sum_epsilon")


def test_a_gear_that_turns_uniformly_has_no_tangential_acceleration() -> None:
    assert "contact.uniform" in said("gear_pair_with_crank", "outside", "epsilon_gear2")
    assert "contact.uniform" not in said("planetary_train", "two_planets", "epsilon_gear3")


def test_a_sleeve_at_rest_and_the_transport_velocity() -> None:
    found = said("oscillating_cylinder", "", "v_rel_C")
    assert {"relative.rest_v", "relative.carried_v"} <= set(found)
    assert not {"relative.rest_v", "relative.carried_v"} & set(said("arc_yoke", "", "v_rel_A"))


@pytest.mark.parametrize(("sense", "word"), [(1, "counter_clockwise"), (-1, "clockwise")])
def test_a_known_vector_across_a_radius_is_told_with_its_sense(sense: int, word: str) -> None:
    ways = sentences("four_bar", "crank", "a_B", epsilon_OA=4 * sense)
    about = [s.facts for s in ways if s.key == "ways.about" and s.facts["centre"] == Point("O")]
    assert about
    assert about[0]["sense"] == Word(word)
    assert "ways.assumed" in {s.key for s in ways}
