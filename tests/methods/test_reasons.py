"""What a solution says beside its formulas: why a component is there, what is zero, where a vector points."""

from __future__ import annotations

import pytest

from tests.methods.forms import tasks
from tests.methods.given_data import sentences, steps
from variantgen.algebra.expression import Value
from variantgen.algebra.name import Name
from variantgen.algebra.values import parts
from variantgen.families.quantities import parse_quantity
from variantgen.families.reading.load import load_family
from variantgen.methods.compose import solution
from variantgen.methods.graphical.vector_chain import chain_of
from variantgen.methods.linkage.problem import task_of
from variantgen.methods.steps.step import Derived, Point, Projection, Sentence, Word
from variantgen.variants.draw import draw
from variantgen.variants.printed_data import shown_points
from variantgen.variants.variant import solve_variants
from variantgen.wording.language import load_language
from variantgen.wording.solution.phrases import load_phrases
from variantgen.wording.solution.quantity_symbols import Symbols


def said(family: str, form: str, ask: str, **data: float) -> list[str]:
    """Keys of the sentences of a solution."""
    return [sentence.key for sentence in sentences(family, form, ask, **data)]


def headings(family: str, form: str, ask: str) -> list[str]:
    """Keys of the headings of a solution."""
    return [step.heading.key for step in steps(family, form, ask)]


def views(family: str, form: str, ask: str) -> set[str]:
    """Kinds of figures of which a solution speaks."""
    return {view for step in steps(family, form, ask) for view in step.views}


def derived(family: str, form: str, ask: str) -> list[Value]:
    """Values that a solution works out."""
    return [item.value for step in steps(family, form, ask) for item in step.items if isinstance(item, Derived)]


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
    assert "contact.uniform" in said("roller_on_drum", "outside", "a_O", epsilon_1=0)
    assert "contact.uniform" not in said("planetary_train", "two_planets", "epsilon_gear3")


def test_the_condition_of_a_thread_is_differentiated_once() -> None:
    found = said("movable_pulley", "two_loads", "a_C epsilon_pulley")
    assert found.count("rope.same_a") == found.count("rope.again_a") == 1


def test_a_sleeve_at_rest_and_the_transport_velocity() -> None:
    found = said("oscillating_cylinder", "", "v_rel_C")
    assert {"relative.rest_v", "relative.carried_v"} <= set(found)
    assert not {"relative.rest_v", "relative.carried_v"} & set(said("arc_yoke", "", "v_rel_A"))


@pytest.mark.parametrize(("sense", "word"), [(1, "left_up"), (-1, "right_down")])
def test_a_known_vector_across_a_radius_is_told_with_its_side(sense: int, word: str) -> None:
    # OA makes 15 degrees with the x axis: what is across it leads to 105 degrees or to -75 degrees.
    found = sentences("four_bar", "crank", "a_B", epsilon_OA=4 * sense)
    assert [s.facts["side"] for s in found if s.key == "points.about_pivot_a"] == [Word(word)]
    assert {"axes.by_one", "axes.by_all", "axes.by_strongest", "axes.by_total"} & {s.key for s in found}


def test_a_sum_that_decides_a_sense_is_worked_out_before_it_is_used() -> None:
    items = [item for step in steps("four_bar", "crank", "a_B", epsilon_OA=4) for item in step.items]
    at = next(i for i, item in enumerate(items) if isinstance(item, Sentence) and item.key == "axes.sum")
    total, projection, result = items[at + 1 : at + 4]
    assert isinstance(total, Derived) and isinstance(projection, Projection) and isinstance(result, Derived)
    assert [word.key for word in projection.words] == ["axes.by_total"]
    assert total.value.exact > 0
    assert result.value.expression is not None
    assert total.value in parts(result.value.expression)


def test_bodies_are_called_as_the_statement_calls_them() -> None:
    russian = load_language("ru")
    for form_name, noun in (("axle", "колесо"), ("spool", "катушка")):
        form = load_family("pulley_and_wheel").forms[form_name]
        called = Symbols(form, russian, load_phrases("ru"), {}).body("wheel", "")
        assert str(called[0]).strip("\N{NO-BREAK SPACE}") == noun


@pytest.mark.parametrize("family", ["guided_plate", "three_rod_plate"])
def test_figures_and_solutions_take_the_same_pole(family: str) -> None:
    loaded = load_family(family)
    form = loaded.forms[""]
    variant = draw(loaded, None, [("pole", 1)])[0]
    asked = [parse_quantity(name, form.sample) for name in form.ask]
    task = task_of(variant, solve_variants([variant], 2), 0, asked)
    turns = chain_of(form, task.now, asked, shown_points(variant, asked)).turns
    plate = next(body for body in form.bodies if len(form.bodies[body]) == 3)
    poles = {turn.pole for turn in turns if turn.body == plate}
    items = [item for step in solution(task).steps for item in step.items if isinstance(item, Sentence)]
    assert {Point(pole) for pole in poles} == {item.facts["pole"] for item in items if item.key == "coupled.choose"}


def test_a_magnitude_is_found_where_its_components_are() -> None:
    for family, form, ask in (
        ("disc_in_cylinder", "inside", "a_O a_M"),
        ("arc_yoke", "", "a_rel_A"),
        ("parallelogram_with_disc", "fixed_point", "a_M"),
    ):
        assert not [heading for heading in headings(family, form, ask) if heading.startswith("answers.magnitude")]


def test_translation_is_shown_in_figures() -> None:
    assert views("parallelogram_with_disc", "fixed_point", "v_M a_M") == {"body_velocities", "body_accelerations"}


def test_a_relative_velocity_that_nothing_needs_is_not_found() -> None:
    # The follower translates and its plate is flat: neither Coriolis nor normal relative acceleration.
    names = {value.name for value in derived("cam_disc", "flat", "a_D") if value.name is not None}
    assert not [name for name in names if name.part == "rel"]


def test_why_a_component_of_an_acceleration_vanishes() -> None:
    assert "points.about_pivot_n" in said("slider_crank", "central", "a_B", epsilon_OA=0)
    assert "points.about_pivot_a" in said("slider_crank", "central", "a_B", epsilon_OA=4)
    # The rocker is in a dead position where A moves along it: OA across CA, cos phi = -OA/OC.
    dead = {"OA": 30, "OC": 60, "phi": 120}
    found = sentences("slotted_rocker", "swinging", "a_rel_A epsilon_CB", **dead)
    assert [s.facts["vector"] for s in found if s.key == "rates.no_normal"] == [Name("a", "A", part="tr n")]
    assert "relative.no_coriolis_omega" in [s.key for s in found]
    assert "relative.no_coriolis_omega" not in said("slotted_rocker", "swinging", "a_rel_A epsilon_CB", OA=30, OC=60)


def test_why_a_rotation_about_a_pole_has_no_tangential_part() -> None:
    # A falling rod turns uniformly; so does a roller with the angular acceleration 0, of which the tangent tells too.
    found = sentences("falling_rod", "", "a_A a_B")
    told = [s.facts["vector"] for s in found if s.key == "rates.no_tangential"]
    assert told == [Name("a", end, "C", "tau") for end in "AB"]
    told = said("roller_on_drum", "outside", "a_O a_M", epsilon_2=0)
    assert told.count("contact.uniform_centre") == told.count("rates.no_tangential") == 1
    told = said("roller_on_drum", "outside", "a_O a_M", epsilon_2=4)
    assert not {"contact.uniform_centre", "rates.no_tangential"} & set(told)


@pytest.mark.parametrize(
    ("family", "form", "key"),
    [("disc_on_arc_with_rod", "outside", "rolling.contact"), ("wheel_with_rod", "", "rolling.contact_at")],
)
def test_the_contact_of_a_wheel_has_a_letter_where_a_later_line_speaks_of_it(family: str, form: str, key: str) -> None:
    form = form or next(iter(load_family(family).forms))
    (task,) = tasks(family, form, 1)
    items = [item for step in solution(task).steps for item in step.items if isinstance(item, Sentence)]
    (contact,) = [item.facts["contact"] for item in items if item.key == "rolling.omega"]
    assert isinstance(contact, Sentence)
    assert contact.key == key
