"""Twelve problems solved as a teacher solves them, some by several methods: the steps of ``models.toml`` in order.

What stands there was written down by hand: the theorem or triangle of a step, its base point, its axes, its figure with
the vectors drawn in it, the special case noticed, the numbers, the check. A solution may say more than that.
"""

from __future__ import annotations

import math
import tomllib
from collections.abc import Iterable, Iterator
from decimal import Decimal
from pathlib import Path
from typing import Any

import pytest

from variantgen.algebra.name import Name
from variantgen.families.asking import read_ask
from variantgen.families.reading.load import load_family
from variantgen.methods.compose import solution
from variantgen.methods.linkage.problem import task_of
from variantgen.methods.steps.point_vectors import PointEquation
from variantgen.methods.steps.step import (
    Balance,
    Body,
    Derived,
    Fact,
    Item,
    Point,
    Projection,
    Sentence,
    Solution,
    Step,
    VectorLine,
    VectorOf,
)
from variantgen.variants.variant import Variant, solve_variants
from variantgen.wording.language import load_language
from variantgen.wording.solution.explain import written

MODELS: list[dict[str, Any]] = tomllib.loads(Path(__file__).with_name("models.toml").read_text(encoding="utf-8"))[
    "model"
]
IDS = ["-".join(filter(None, (*model["problem"], *model.get("method", ())))) for model in MODELS]
SIDES = ("right", "up", "left", "down")


def called(name: Name | None) -> str:
    """A name as the table has it: ``v_BA``, ``a_B^tau``, ``AP``, ``∠OCB``, ``omega_AB``."""
    if name is None:
        return ""
    if name.kind == "length":
        return name.of + name.about
    if name.kind == "angle":
        first, _, last = name.about.partition(" ")
        return f"∠{first}{name.of}{last}"
    return f"{name.kind}_{name.of}{name.about}" + (f"^{name.part}" if name.part else "")


def solved(model: dict[str, Any]) -> tuple[Solution, list[tuple[str, ...]]]:
    """The solution, and the kinds of figures of its steps."""
    name, form, _ = model["problem"]
    family = load_family(name)
    printed = {key: Decimal(value) for key, value in model["data"].items()}
    sense, turns = model["pose"]
    variant = Variant(family, family.forms[form], printed, sense=sense, turns=turns)
    asked = read_ask(variant.form, None)
    task = task_of(variant, solve_variants([variant], 2), 0, asked)
    found = solution(task, model.get("method", ()))
    return found, [section.views for section in written(task, found, load_language("en")).sections]


def is_near(found: float, expected: float) -> bool:
    """Whether a number is that of the table: four significant digits."""
    return abs(found - expected) <= 0.501 * 10.0 ** (math.floor(math.log10(abs(expected))) - 3)


def holds(found: Iterable[tuple[str, float]], expected: dict[str, float]) -> None:
    """All expected numbers are found, in their order."""
    left = list(found)
    for symbol, number in expected.items():
        places = [i for i, (name, _) in enumerate(left) if name == symbol]
        assert places, f"{symbol} is not found in its place"
        assert is_near(left[places[0]][1], number), (symbol, left[places[0]][1], number)
        left = left[places[0] + 1 :]


def numbers(items: Iterable[Item]) -> Iterator[tuple[str, float]]:
    for item in items:
        if isinstance(item, Derived):
            yield called(item.value.name), item.value.exact


def fact_text(fact: Fact) -> str:
    assert isinstance(fact, Body | Point)
    return fact.name


def axis_text(item: Projection) -> str:
    """The axis of a projection: along which line or to which side, and what it leaves out."""
    words = item.words[0]
    facts = words.facts
    if "start" in facts:
        start, end = (fact_text(facts[name]) for name in ("start", "end"))
        ways = f"{start} to {end}"
    elif words.key == "axes.across":
        vector = facts["vector"]
        assert isinstance(vector, VectorOf)
        return f"across {called(vector.name)}"
    else:
        ways = words.key.removeprefix("axes.")
        assert ways in SIDES
    vector = facts.get("vector")
    return f"{ways}, without {called(vector.name)}" if isinstance(vector, VectorOf) else ways


def equation_text(item: VectorLine) -> str:
    left, right = (" + ".join(called(term.name) for term in side) for side in (item.left, item.right))
    return f"{left} = {right}"


def check_step(expected: dict[str, Any], step: Step, views: tuple[str, ...], drawn: list[PointEquation]) -> None:
    facts = {**step.heading.facts}
    assert {name: fact_text(facts[name]) for name in expected["of"]} == expected["of"]
    said = [item.key for item in step.items if isinstance(item, Sentence)]
    places = [said.index(key) for key in expected.get("by", ()) if key in said]
    assert [said[i] for i in sorted(places)] == expected.get("by", []), said
    holds(numbers(step.items), expected.get("finds", {}))
    axes = [axis_text(item) for item in step.items if isinstance(item, Projection)]
    if "axes" in expected:
        assert axes == expected["axes"]
    equations = [equation_text(item) for item in step.items if isinstance(item, VectorLine)]
    if "equation" in expected:
        assert equations == [expected["equation"]]
        (figure,) = drawn
        terms = [called(arrow.name) for arrow in figure.terms]
        assert terms == expected["equation"].replace(" = ", " + ").split(" + ")
        lettered = [item for item in step.items if isinstance(item, Projection) and item.letter]
        assert len(figure.axes) == len(axes) >= len(lettered)
        assert ["".join(rod) for rod in figure.rods] == expected.get("rods", [])
    if "base" in expected:
        poles = {
            fact_text(item.facts["pole"]) for item in step.items if isinstance(item, Sentence) and "pole" in item.facts
        }
        poles |= {fact_text(facts[name]) for name in ("pole", "centre") if name in facts}
        assert poles == {expected["base"]}
    for figure_kind in expected.get("figure", ()):
        assert any(view == figure_kind or view.startswith(f"{figure_kind}:") for view in views), views


@pytest.mark.parametrize("model", MODELS, ids=IDS)
def test_a_problem_is_solved_as_a_teacher_does(model: dict[str, Any]) -> None:
    found, views = solved(model)
    position = [step for step in found.steps if step.heading.key == "position.heading"]
    holds((pair for step in position for pair in numbers(step.items)), model.get("position", {}))
    steps = [(number, step) for number, step in enumerate(found.steps) if step.heading.key != "position.heading"]
    assert [step.heading.key for _, step in steps] == [expected["step"] for expected in model["steps"]]
    for expected, (number, step) in zip(model["steps"], steps, strict=True):
        drawn = [equation for order in found.vectors for equation in order.equations if equation.step == number]
        check_step(expected, step, views[number], drawn)
    if "check" in model:
        assert [item.key for item in found.check if isinstance(item, Sentence)] == [f"check.{model['check']['by']}"]
        (balance,) = [item for item in found.check if isinstance(item, Balance)]
        for side, number in zip((balance.left, balance.right), model["check"]["sides"], strict=True):
            assert is_near(side.exact, number)
