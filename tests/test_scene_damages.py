"""Damaged scenes and families: a message with file, key and remedy and exit code 2, or an answer that is confirmed."""

from __future__ import annotations

import copy
import json
import math
import random
import tomllib
from collections.abc import Iterator
from decimal import Decimal
from pathlib import Path
from typing import Any

import pytest

from tests.own_scenes import SCENES
from tests.scene_texts import CRANK
from variantgen.cli import main
from variantgen.families.reading.folders import family_names
from variantgen.resources import catalog_dir

Path_ = tuple[str | int, ...]


def written(value: Any) -> str:
    """A value of a TOML file."""
    if isinstance(value, dict):
        return "{ " + ", ".join(f"{json.dumps(str(key))} = {written(item)}" for key, item in value.items()) + " }"
    if isinstance(value, list):
        return "[" + ", ".join(written(item) for item in value) + "]"
    return str(value) if isinstance(value, Decimal) else json.dumps(value, ensure_ascii=False)


def document(data: dict[str, Any]) -> str:
    return "".join(f"{json.dumps(key)} = {written(value)}\n" for key, value in data.items())


def spots(value: Any, at: Path_ = ()) -> Iterator[Path_]:
    """Ways to everything in a document."""
    if at:
        yield at
    items = value.items() if isinstance(value, dict) else enumerate(value) if isinstance(value, list) else ()
    for name, item in items:
        yield from spots(item, (*at, name))


def found(data: Any, at: Path_) -> Any:
    for name in at:
        data = data[name]
    return data


def number(value: Any) -> bool:
    return isinstance(value, int | Decimal) and not isinstance(value, bool)


def damages(data: dict[str, Any]) -> Iterator[tuple[str, dict[str, Any]]]:
    """Every kind of damage, at each of its places."""
    for at in spots(data):
        value, name = found(data, at), ".".join(map(str, at))

        def damaged(change: Any, delete: bool = False, at: Path_ = at) -> dict[str, Any]:
            other = copy.deepcopy(data)
            parent = found(other, at[:-1])
            if delete:
                del parent[at[-1]]
            else:
                parent[at[-1]] = change
            return other

        yield f"without {name}", damaged(None, delete=True)
        if number(value):
            yield f"zero {name}", damaged(0)
            yield f"opposite {name}", damaged(-value)
            yield f"huge {name}", damaged(10**15)
            yield f"tiny {name}", damaged(Decimal("1e-15"))
            yield f"text for {name}", damaged("many")
        elif isinstance(value, str):
            yield f"number for {name}", damaged(7)
            yield f"nothing for {name}", damaged("")
            yield f"another for {name}", damaged(next(iter(data["points"])))
        elif isinstance(value, list):
            yield f"twice in {name}", damaged([*value, *value[:1]])
            yield f"empty {name}", damaged([])
        elif isinstance(value, dict):
            yield f"list for {name}", damaged([1, 2])
    for first in data["points"]:
        for second in data["points"]:
            if first != second:
                twin = copy.deepcopy(data)
                twin["points"][second] = copy.deepcopy(twin["points"][first])
                yield f"{second} where {first} is", twin


def outcome(path: Path, data: dict[str, Any], capsys: pytest.CaptureFixture[str]) -> tuple[int, str, str]:
    path.write_text(document(data), encoding="utf-8")
    code = main(["solve", str(path), "--json"])
    output = capsys.readouterr()
    return code, output.out, output.err


def assert_sound(code: int, out: str, err: str) -> None:
    assert "Traceback" not in err
    if code == 0:
        answers = json.loads(out)["answers"]
        assert answers
        for item in answers:
            assert item["value"] is None or math.isfinite(item["value"])
            assert item["tolerance"] is None or 0 <= item["tolerance"] < math.inf
        return
    assert code == 2, err
    assert err.startswith("variantgen: ")
    first = err.removeprefix("variantgen: ").splitlines()[0]
    assert ": " in first, err  # where it is, and what


def refused(data, most, name, folder, capsys):
    """How many of so many damages of a file are refused; all others are solved."""
    count = 0
    for i, (what, other) in enumerate(random.Random(name).sample(list(damages(data)), most)):
        code, out, err = outcome(folder / f"damaged{i}.toml", other, capsys)
        try:
            assert_sound(code, out, err)
        except AssertionError as error:
            raise AssertionError(what) from error
        count += code == 2
    return count


@pytest.mark.parametrize("name", SCENES)
def test_a_damaged_scene_is_refused_or_solved(name, tmp_path, capsys):
    data = tomllib.loads(SCENES[name]().written("cm"), parse_float=Decimal)
    assert refused(data, 40, name, tmp_path, capsys) >= 5


@pytest.mark.parametrize("name", [name for name in family_names() if (catalog_dir() / name).is_dir()][::3])
def test_a_damaged_family_is_refused_or_solved(name, tmp_path, capsys):
    data = tomllib.loads((catalog_dir() / name / "family.toml").read_text(encoding="utf-8"), parse_float=Decimal)
    assert refused(data, 12, name, tmp_path, capsys) >= 1


@pytest.mark.parametrize("name", list(SCENES)[::4])
def test_check_finds_what_solve_and_explain_refuse(name, tmp_path, capsys):
    data = tomllib.loads(SCENES[name]().written("cm"), parse_float=Decimal)
    for i, (what, other) in enumerate(random.Random(name).sample(list(damages(data)), 12)):
        path = tmp_path / f"scene{i}.toml"  # what a path leads to is read once
        path.write_text(document(other), encoding="utf-8")
        codes = [main([words[0], str(path), *words[1:]]) for words in (["solve"], ["solve", "--explain"], ["check"])]
        capsys.readouterr()
        assert (codes[2] == 0) == (codes[0] == codes[1] == 0), (what, codes)


@pytest.mark.parametrize(
    ("text", "output"),
    [
        (CRANK.replace("= 2 ", f"= 0x{'f' * 5000} "), "a number of more than 1000 digits in line 11"),
        (CRANK.replace("= 2 ", f"= {'9' * 5000} "), "a number of more than 1000 digits in line 11"),
        (f"{'.'.join('a' * 3000)} = 1\n{CRANK}", "a key of more than 50 parts in line 1"),
        (CRANK + '[[joints]]\npivot = { point = "O" }\n' * 2500, "joints: expected at most 200 entries (got 2501)"),
        (
            CRANK + "[derived]\n" + "".join(f'a{i} = "a{i - 1} + 1"\n' for i in range(2500, 0, -1)) + 'a0 = "1"\n',
            "derived: expected at most 200 entries (got 2501)",
        ),
        (CRANK + "[[joints]]\nrope.path = []\n", "joints.rope of nothing: a rope needs at least two bends: its ends"),
    ],
)
def test_overgrown_and_empty_parts(text, output, tmp_path, capsys):
    path = tmp_path / "scene.toml"
    path.write_text(text, encoding="utf-8")
    assert main(["solve", str(path)]) == 2
    assert output in capsys.readouterr().err


@pytest.mark.parametrize("count", [180])
def test_many_joints_within_the_bound(count, tmp_path, capsys):
    """A chain of points, each led by its own guide: no depth of recursion stands in the way."""
    points = "".join(f"P{i} = {{ coordinates = {{ x = {i + 1}, y = 5 }} }}\n" for i in range(count))
    guides = "".join(f'[[joints]]\nguide = {{ point = "P{i}", angle = 0 }}\n' for i in range(count))
    drives = "".join(f'[[drivers]]\ntravel = {{ point = "P{i}", v = 1 }}\n' for i in range(count))
    path = tmp_path / "scene.toml"
    text = 'ask = ["omega_OA"]\n' + CRANK.replace("[bodies]", points + "[bodies]").replace(
        "[[drivers]]", guides + "[[drivers]]"
    )
    path.write_text(text + drives, encoding="utf-8")
    assert main(["solve", str(path)]) == 0
    assert "omega_OA = 2 rad/s" in capsys.readouterr().out


def test_a_wheel_without_a_radius(tmp_path, capsys):
    data = tomllib.loads(SCENES["rack and pinion"]().written("cm"), parse_float=Decimal)
    data["points"]["N"] = copy.deepcopy(data["points"]["O"])  # the second contact lies in the centre
    code, out, err = outcome(tmp_path / "scene.toml", data, capsys)
    assert_sound(code, out, err)
    assert "two points that should be apart coincide" in err or "lie in one place" in err
