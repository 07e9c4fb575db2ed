"""Angles of the position that the sheet prints are data of the solution; without them the position is a system."""

from __future__ import annotations

import re
import shutil
from math import acos, degrees
from pathlib import Path

import pytest

from variantgen.algebra.name import Name
from variantgen.families.asking import read_ask
from variantgen.families.family import Family
from variantgen.families.reading.load import load_family
from variantgen.methods.compose import solution
from variantgen.methods.linkage.problem import Task, task_of
from variantgen.methods.steps.step import Derived, EquationLine, Sentence, Solution
from variantgen.resources import catalog_dir
from variantgen.variants.draw import draw
from variantgen.variants.variant import solve_variants

FAMILIES = ["guided_plate", "three_rod_plate"]
VARIANTS = 5


def tasks(family: Family) -> list[Task]:
    variants = draw(family, None, [("printed angles", i) for i in range(VARIANTS)])
    motion = solve_variants(variants, 2)
    return [task_of(variant, motion, i, read_ask(variant.form)) for i, variant in enumerate(variants)]


def without_angles(folder: Path, family: str) -> Family:
    """A family of the catalogue whose sheet prints no angles of the position."""
    copied = folder / family
    shutil.copytree(catalog_dir() / family, copied)
    path = copied / "family.toml"
    path.write_text(re.sub(r"^found = .*\n", "", path.read_text("utf-8"), flags=re.MULTILINE), "utf-8")
    return load_family(str(copied))


def said(found: Solution) -> list[str]:
    return [item.key for step in found.steps for item in step.items if isinstance(item, Sentence)]


@pytest.mark.parametrize("family", FAMILIES)
def test_nothing_is_solved_for_coordinates(family: str) -> None:
    for task in tasks(load_family(family)):
        found = solution(task)
        names = {i.value.name for s in found.steps for i in s.items if isinstance(i, Derived)} - {None}
        assert not {name for name in names if isinstance(name, Name) and name.kind in ("x", "y", "direction")}
        assert "position.together" not in said(found)
        printed = {(at, frozenset((start, end))) for start, at, end in task.form.figure.found}
        assert not {(n.of, frozenset(n.about.split())) for n in names if n is not None and n.kind == "angle"} & printed


def test_a_plate_on_rods_has_no_step_of_the_position() -> None:
    for task in tasks(load_family("three_rod_plate")):
        assert solution(task).steps[0].heading.key == "coupled.velocity"


def test_a_triangle_of_known_sides_is_all_of_the_position_of_a_plate_in_guides() -> None:
    for task in tasks(load_family("guided_plate")):
        first = solution(task).steps[0]
        assert first.heading.key == "position.heading"
        (line,) = (item.value for item in first.items if isinstance(item, Derived))
        base, side = float(task.variant.printed["CD"]), float(task.variant.printed["BC"])
        assert line.exact == pytest.approx(degrees(acos(base / 2 / side)))


def test_coordinates_go_from_link_to_link() -> None:
    for task in tasks(load_family("three_rod_plate")):
        first = solution(task, ("coordinates",)).steps[0]
        assert not any(isinstance(item, EquationLine) for item in first.items)
        for item in first.items:
            if isinstance(item, Derived) and item.value.name is not None and item.value.name.kind == "x":
                assert item.value.exact == pytest.approx(task.now.z[item.value.name.of].real)


@pytest.mark.parametrize("family", FAMILIES)
def test_without_printed_angles_the_position_is_a_system(family: str, tmp_path: Path) -> None:
    for task in tasks(without_angles(tmp_path, family))[:1]:
        assert "position.together" in said(solution(task))


def test_an_angle_too_few_places_nothing(tmp_path: Path) -> None:
    family = without_angles(tmp_path, "three_rod_plate")
    path = tmp_path / "three_rod_plate" / "family.toml"
    text = path.read_text("utf-8").replace("[figure]\n", '[figure]\nfound = [["O", "A", "B"]]\n')
    path.write_text(text, "utf-8")
    (task, *_) = tasks(load_family(str(path.parent)))
    assert family.forms[""].figure.found == ()
    assert "position.together" in said(solution(task))
