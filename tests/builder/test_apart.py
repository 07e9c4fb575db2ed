"""What students of one group get is far apart, seen in the manifest."""

from __future__ import annotations

import json
from itertools import combinations
from pathlib import Path
from typing import Any

import pytest

from tests.builder.small_exams import exam
from variantgen.builder import build
from variantgen.cli import main
from variantgen.exam.roster import Student

# A length is free on a grid of 0.1 m, about 4 m, a time on one of 0.05 s, about 1 s: many pairs are close together.
TEXT = """
title = "T"
language = "en"
tolerance = { floor = 0.03, ceiling = 0.05, mistakes = false }
[solutions]
depth = "none"
[[problem]]
family = "falling_rod"
ask = ["v_A"]
set = { omega = 2 }
range = { AB = [3.5, 5], t = [0.4, 1.2] }
"""


def near(one: dict[str, Any], other: dict[str, Any]) -> bool:
    """Whether no parameter differs by more than three percent."""
    for name in ("AB", "t"):
        a, b = float(one[name]["value"]), float(other[name]["value"])
        if abs(a - b) > 0.03 * min(a, b):
            return False
    return one["sense"] == other["sense"]


def near_pairs(out: Path) -> list[tuple[str, str]]:
    """Pairs of groups of students whose data are nearly the same."""
    students = json.loads((out / "manifest.json").read_text("utf-8"))["students"]
    return [
        (a["group"], b["group"])
        for a, b in combinations(students, 2)
        if near(a["problems"][0]["parameters"], b["problems"][0]["parameters"])
    ]


def test_near_data_are_kept_apart_within_a_group(tmp_path: Path) -> None:
    students = [Student(f"{group}{i}", "", group) for group in "ABCDE" for i in range(12)]
    made = build(exam(tmp_path, TEXT), students, tmp_path / "out")
    pairs = near_pairs(tmp_path / "out")
    assert [pair for pair in pairs if pair[0] == pair[1]] == []
    assert pairs, "between groups they may be near: there are not so many variants"
    assert made.alike == {}


def test_where_there_is_no_room_it_is_said(tmp_path: Path, capsys: pytest.CaptureFixture[str]) -> None:
    path = tmp_path / "exam.toml"
    path.write_text(TEXT.replace("[0.4, 1.2]", "[1.0, 1.0]"), "utf-8")
    assert main(["build", str(path), "--variants", "26", "--out", str(tmp_path / "out")]) == 0
    said = capsys.readouterr().err
    assert "problem[1]: falling_rod" in said
    assert "nearly" in said
    assert near_pairs(tmp_path / "out")


def test_too_small_a_space_is_told_with_its_size(tmp_path: Path, capsys: pytest.CaptureFixture[str]) -> None:
    path = tmp_path / "exam.toml"
    path.write_text(TEXT, "utf-8")
    assert main(["build", str(path), "--variants", "3000", "--out", str(tmp_path / "out")]) == 2
    said = capsys.readouterr().err
    assert "3000 sheets need as many, at most " in said
    room = int(said.split("at most ")[1].split()[0])
    assert 40 < room <= 16 * 17 * 2, said
    assert not (tmp_path / "out").exists()
