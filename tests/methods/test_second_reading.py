"""A second reading of solutions: nothing is worked out twice or for nothing, drivers are no steps of their own."""

from __future__ import annotations

import pytest

from variantgen.algebra.name import Name
from variantgen.families.asking import read_ask
from variantgen.families.quantities import parse_quantity
from variantgen.families.reading.folders import family_names
from variantgen.families.reading.load import load_family
from variantgen.families.restrict import restrict
from variantgen.methods.compose import solution
from variantgen.methods.linkage.problem import task_of
from variantgen.methods.steps.step import Derived, Sentence, Solution, TermTable, VectorLine
from variantgen.methods.steps.whole_vectors import written_sides
from variantgen.variants.draw import draw
from variantgen.variants.variant import solve_variants


def solution_of(family_name: str, form_name: str, ask: str = "") -> Solution:
    """The solution of one drawn variant, of what the form asks or of ``ask``."""
    family = load_family(family_name)
    own = restrict(family, None, None, (form_name,) if form_name else ())
    variants = draw(own, None, [("second reading", 1)])
    form = variants[0].form
    asked = [parse_quantity(name, form.sample) for name in ask.split()] or read_ask(form)
    return solution(task_of(variants[0], solve_variants(variants, 2), 0, asked))


@pytest.mark.parametrize("family_name", family_names())
def test_no_quantity_is_worked_out_twice(family_name: str) -> None:
    for form_name in load_family(family_name).forms:
        found = [i.value for s in solution_of(family_name, form_name).steps for i in s.items if isinstance(i, Derived)]
        names = [(value.name, value.exact) for value in found]
        assert len(set(names)) == len(names), form_name


def lines(family: str, form: str) -> set[Name | None]:
    """The names of what a solution works out."""
    found = solution_of(family, form)
    return {item.value.name for step in found.steps for item in step.items if isinstance(item, Derived)}


def test_a_vector_that_nothing_needs_is_not_worked_out() -> None:
    assert Name("a", "F", "C", "tau") not in lines("three_rod_plate", "")
    assert Name("a", "B", "C", "tau") in lines("three_rod_plate", ""), "a_B is the sum of a_C and a_BC"
    assert Name("a", "B", part="n") not in lines("planetary_train", "two_planets")
    assert Name("a", "B", part="tau") in lines("planetary_train", "two_planets"), "epsilon_2 follows from it"


@pytest.mark.parametrize("form", ["boom", "with_rod"])
def test_a_coriolis_acceleration_across_the_axis_is_not_worked_out(form: str) -> None:
    assert Name("a", "B", part="cor") not in lines("hydraulic_hoist", form)
    said = [
        item.key
        for step in solution_of("hydraulic_hoist", form).steps
        for item in step.items
        if isinstance(item, Sentence)
    ]
    assert said.count("relative.coriolis_not_needed") == 1


def test_the_driving_link_is_no_step_of_its_own() -> None:
    keys = [step.heading.key for step in solution_of("slider_crank", "central", "v_B a_B").steps]
    assert keys == ["position.heading", "velocity_centre.link", "pole.dyad_a"]
    asked = [step.heading.key for step in solution_of("slider_crank", "central", "v_A v_B omega_AB").steps]
    assert asked == ["position.heading", "points.turning_v", "velocity_centre.link"]


def test_a_direction_is_said_once() -> None:
    found = solution_of("slider_crank", "central", "v_B a_B").steps
    (table,) = (item for step in found for item in step.items if isinstance(item, TermTable))
    # Those of a^n_A and a^tau_A are said where they are worked out, the sense of a_B with its reason, and that of
    # a^tau_BA, which nothing finds, not at all.
    assert [term.name for term in table.terms] == [Name("a", "B"), Name("a", "B", "A", "n"), Name("a", "B", "A", "tau")]
    assert [term.way.key for term in table.terms] == ["ways.guide", "ways.towards", "ways.across"]


@pytest.mark.parametrize("family_name", family_names())
def test_no_side_of_a_vector_is_told_before_it_is_found(family_name: str) -> None:
    for form_name in load_family(family_name).forms:
        for step in solution_of(family_name, form_name).steps:
            terms = [term for item in step.items if isinstance(item, TermTable) for term in item.terms]
            told = {term.name for term in terms if term.size is None and "side" in term.way.facts}
            assumed = {term.name for term in terms if term.way.key == "ways.assumed"}
            assert told == assumed, form_name
            assert not assumed or step.heading.key.startswith("coupled."), form_name


def test_a_side_is_assumed_where_a_system_of_equations_is_to_find_it() -> None:
    steps = solution_of("three_rod_plate", "").steps
    ways = {t.name: t.way.key for s in steps for i in s.items if isinstance(i, TermTable) for t in i.terms}
    assert ways[Name("a", "C", part="tau")] == ways[Name("a", "B", "C", "tau")] == "ways.assumed"
    assert ways[Name("a", "B", "A", "tau")] == "ways.across", "the axis is perpendicular to it"


def test_components_of_one_equation_are_a_vector_in_the_next() -> None:
    found = solution_of("guided_plate", "")
    equations = [written_sides(i) for s in found.steps for i in s.items if isinstance(i, VectorLine)]
    names = [[[term.name for term in side] for side in equation] for equation in equations]
    assert [[Name("v", "B")], [Name("v", "A"), Name("v", "B", "A")]] in names
    assert not any(term.is_laid for equation in equations for side in equation for term in side)


def test_a_reason_is_given_once() -> None:
    found = solution_of("movable_pulley", "load_and_axle")
    said = [item.key for step in found.steps for item in step.items if isinstance(item, Sentence)]
    assert said.count("rope.inextensible") == said.count("rope.same_a") == 1
    assert said.count("rope.same_v") == said.count("rope.same_a") + said.count("rope.again_a") == 3
