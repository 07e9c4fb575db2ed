"""``verify``: a finished exam is as it was built, or what is wrong is named."""

from __future__ import annotations

import json
import shutil
from collections.abc import Callable
from pathlib import Path
from typing import Any

import numpy as np
import pytest

from variantgen.cli import main
from variantgen.exam.manifest import read_manifest
from variantgen.finished.restore import restore
from variantgen.finished.verify import independent
from variantgen.single import asked_quantities, one_variant

EXAM = """
title = "Quiz"
language = "en"
[solutions]
depth = "none"
[[problem]]
family = "rolling_wheel"
[[problem]]
families = ["slider_crank", "sleeve_on_crank"]
points = 5
"""
Manifest = dict[str, Any]


@pytest.fixture(scope="module")
def made(tmp_path_factory: pytest.TempPathFactory) -> Path:
    folder = tmp_path_factory.mktemp("made")
    (folder / "exam.toml").write_text(EXAM, "utf-8")
    assert main(["build", str(folder / "exam.toml"), "--variants", "6", "--out", str(folder / "out")]) == 0
    return folder / "out"


@pytest.fixture
def out(made: Path, tmp_path: Path) -> Path:
    shutil.copytree(made, tmp_path / "out")
    return tmp_path / "out"


def change(out: Path, edit: Callable[[Manifest], None]) -> None:
    path = out / "manifest.json"
    manifest = json.loads(path.read_text("utf-8"))
    edit(manifest)
    path.write_text(json.dumps(manifest, ensure_ascii=False), "utf-8")


def said(out: Path, capsys: pytest.CaptureFixture[str], code: int) -> str:
    capsys.readouterr()
    assert main(["verify", str(out)]) == code
    return capsys.readouterr().err


def test_a_finished_exam_is_right(out: Path, capsys: pytest.CaptureFixture[str]) -> None:
    answers = sum(
        len(p["answers"]) for s in json.loads((out / "manifest.json").read_text())["students"] for p in s["problems"]
    )
    assert f"{answers} answers of 6 students computed again: all right" in said(out, capsys, 0)


def test_the_document(out: Path, capsys: pytest.CaptureFixture[str]) -> None:
    capsys.readouterr()
    assert main(["verify", str(out), "--json"]) == 0
    document = json.loads(capsys.readouterr().out)
    assert document["students"] == 6
    assert document["faults"] == document["differences"] == []
    assert document["largest"] < 1e-7, "eight digits are recorded"


def answer(manifest: Manifest) -> Manifest:
    return manifest["students"][2]["problems"][0]["answers"][0]


def copy_of(manifest: Manifest, key: str) -> None:
    """Give the second student the code or the id of the first."""
    manifest["students"][1][key] = manifest["students"][0][key]


@pytest.mark.parametrize(
    ("edit", "words"),
    [
        (lambda m: copy_of(m, "code"), "2 students have the code"),
        (lambda m: copy_of(m, "id"), "2 students have the id 1"),
        (lambda m: m["students"].pop(), ""),
        (lambda m: m["students"].reverse(), ""),
        (lambda m: m["students"][4]["problems"].pop(), ""),
        (lambda m: m["students"][4]["problems"][0].update(attempt=77), ""),
        (lambda m: m.update(students=[]), ""),
    ],
)
def test_students_that_were_edited_are_found(
    edit: Callable[[Manifest], None], words: str, out: Path, capsys: pytest.CaptureFixture[str]
) -> None:
    change(out, edit)
    message = said(out, capsys, 1)
    assert "manifest.json: the students have been changed since the build" in message
    assert words in message


def test_a_manifest_without_the_hash_of_its_students(out: Path, capsys: pytest.CaptureFixture[str]) -> None:
    # Earlier versions have not recorded it; the key that was built with it tells the same students.
    change(out, lambda manifest: manifest.pop("students_hash"))
    assert "all right" in said(out, capsys, 0)
    change(out, lambda manifest: manifest["students"].pop())
    message = said(out, capsys, 1)
    assert "manifest.json: the students have been changed since the build; key.csv has others from 6 on" in message


def test_the_layout_of_the_manifest_is_no_change(out: Path, capsys: pytest.CaptureFixture[str]) -> None:
    path = out / "manifest.json"
    path.write_text(json.dumps(json.loads(path.read_text("utf-8")), indent=3), "utf-8")
    assert "all right" in said(out, capsys, 0)


@pytest.mark.parametrize("factor", [1.00001, -1.0, 10.0])
def test_a_wrong_answer_is_found(factor: float, out: Path, capsys: pytest.CaptureFixture[str]) -> None:
    change(out, lambda manifest: answer(manifest).update(value=answer(manifest)["value"] * factor))
    message = said(out, capsys, 1)
    assert "student 3, problem 1" in message
    assert "by the independent path" in message
    assert "faults: 2" in message, "the answer, and that the students were edited"


def test_an_answer_to_something_else_is_found(out: Path, capsys: pytest.CaptureFixture[str]) -> None:
    change(out, lambda manifest: answer(manifest).update(quantity="a_O"))
    assert "the key does not answer what the exam asks" in said(out, capsys, 1)
    change(out, lambda manifest: manifest["students"][2]["problems"][0].update(answers=[]))
    assert "student 3, problem 1: the key does not answer" in said(out, capsys, 1)


def test_another_variant_is_found(out: Path, capsys: pytest.CaptureFixture[str]) -> None:
    def swap(manifest: Manifest) -> None:
        one, two = (manifest["students"][i]["problems"][0] for i in (0, 1))
        one["answers"], two["answers"] = two["answers"], one["answers"]

    change(out, swap)
    message = said(out, capsys, 1)
    assert "student 1, problem 1" in message
    assert "student 2, problem 1" in message


def test_a_value_that_no_variant_has(out: Path, capsys: pytest.CaptureFixture[str]) -> None:
    def spoil(manifest: Manifest) -> None:
        parameters = manifest["students"][0]["problems"][0]["parameters"]
        parameters[next(iter(parameters))]["value"] = "12345"

    change(out, spoil)
    message = said(out, capsys, 2)
    assert "student 1, problem 1" in message
    assert "no such value of the parameter" in message
    assert "12345" in message


def test_files_that_are_not_as_built(out: Path, capsys: pytest.CaptureFixture[str]) -> None:
    (out / "sheets.pdf").unlink()
    with (out / "key.csv").open("a") as file:
        file.write("x")
    (out / "notes.txt").write_text("mine")
    message = said(out, capsys, 1)
    assert "sheets.pdf: the file is missing" in message
    assert "key.csv: the file has been changed" in message
    assert "notes.txt: the file does not belong" in message


def test_what_differs_is_said(out: Path, capsys: pytest.CaptureFixture[str]) -> None:
    change(out, lambda manifest: manifest["made_with"].update({"program": "0.0.1", "family:rolling_wheel": "0" * 16}))
    message = said(out, capsys, 0)
    assert "the version of variantgen: 0.0.1 when the exam was made" in message
    assert "the folder of the family rolling_wheel: 0000000000000000" in message


@pytest.mark.parametrize(
    ("edit", "words"),
    [
        (lambda m: m.update(schema=1), ["schema", "another version"]),
        (lambda m: m.update(schema="2"), ["schema", "expected"]),
        (lambda m: m["exam"].update(text=m["exam"]["text"] + " "), ["exam.text", "hash"]),
        (lambda m: m["students"][0].update(id=5), ["students[1].id", "expected a string"]),
        (lambda m: m.pop("seed"), ["seed", "missing"]),
        (lambda m: m["students"][0]["problems"][0].update(family="spool"), ["no such problem", "spool"]),
        (lambda m: m["students"][0]["problems"][0]["pose"].update(quarter_turns=7), ["quarter_turns", "0 to 3"]),
        (lambda m: m["students"][0]["problems"][0].update(attempt=-3), ["problems[1].attempt", "1 or more"]),
        (lambda m: answer(m).update(tolerance=float("nan")), ["NaN is no finite number"]),
    ],
)
def test_a_manifest_that_cannot_be(
    edit: Callable[[Manifest], None], words: list[str], out: Path, capsys: pytest.CaptureFixture[str]
) -> None:
    change(out, edit)
    message = said(out, capsys, 2)
    assert "manifest.json" in message
    assert all(word in message for word in words), message


def test_a_folder_without_a_manifest(tmp_path: Path, capsys: pytest.CaptureFixture[str]) -> None:
    assert "there is no manifest" in said(tmp_path, capsys, 2)
    (tmp_path / "manifest.json").write_text("{")
    assert "not valid JSON" in said(tmp_path, capsys, 2)


def test_variants_come_back_as_they_were(made: Path) -> None:
    finished = restore(read_manifest(made), ())
    recorded = json.loads((made / "manifest.json").read_text("utf-8"))["students"]
    for sheet, student in zip(finished.sheets(range(6)), recorded, strict=True):
        for item, problem in zip(sheet.items, student["problems"], strict=True):
            assert [a.value for a in item.answers] == [a["value"] for a in problem["answers"]]
            assert [a.tolerance for a in item.answers] == [a["tolerance"] for a in problem["answers"]]


def test_the_independent_path_by_hand() -> None:
    # A wheel that rolls with the velocity v and the acceleration a of its centre: top point 2 v, omega = v / r; the
    # acceleration of the top point is (2 a, v^2 / r).
    variant = one_variant("rolling_wheel", {}, seed="5")
    asked = asked_quantities(variant)
    _, values, _ = independent([variant], asked)
    found = dict(zip([q.name for q in asked], values[:, 0], strict=True))
    radius, v = (float(variant.printed[name]) for name in ("R", "v_O"))
    rates = [name for name in found if name.startswith("omega")]
    assert rates
    assert np.abs(found[rates[0]]) == pytest.approx(abs(v) / radius, rel=1e-9)
