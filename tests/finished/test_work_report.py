"""The report of work counts what stands in the manifest."""

from __future__ import annotations

import hashlib
import json
from pathlib import Path

import pytest

from variantgen.cli import main


def problem(number: int, operations: int, functions: int, negatives: int, side: str = "") -> dict[str, object]:
    work = {"lines": 9, "operations": operations, "functions": functions, "systems": 0}
    work |= {"negatives": negatives, "obtuse": 1, "coriolis": 0}
    parameters = {"side": {"value": side}, "OA": {"value": "20", "unit": "cm"}} if side else {}
    pose = {"mirrored": False, "quarter_turns": 0}
    return {"problem": number, "family": "spool", "form": "", "pose": pose, "attempt": 1, "work": work} | {
        "parameters": parameters
    }


def manifest(folder: Path, *sheets: list[dict[str, object]]) -> Path:
    text = 'title = "Quiz <1>"\nlanguage = "ru"\n[[problem]]\nfamily = "spool"\n[[problem]]\nfamily = "spool"\n'
    students = [
        {"id": f"s{i}", "name": "N", "group": "", "code": "7Q4-K2M", "problems": own} for i, own in enumerate(sheets)
    ]
    exam = {"text": text, "hash": hashlib.sha256(text.encode()).hexdigest()[:16]}
    content = {"schema": 2, "made_with": {}, "exam": exam, "seed": "1", "files": {}, "students": students}
    (folder / "manifest.json").write_text(json.dumps(content), "utf-8")
    return folder


def test_the_table_and_the_page(tmp_path: Path, capsys: pytest.CaptureFixture[str]) -> None:
    folder = manifest(
        tmp_path,
        [problem(1, 16, 4, 0, "left"), problem(2, 30, 10, 3)],
        [problem(1, 20, 5, 2, "right"), problem(2, 30, 12, 3)],
        [problem(1, 17, 3, 1, "left"), problem(2, 31, 9, 4)],
    )
    page = tmp_path / "page.html"
    assert main(["fairness", str(folder), "--out", str(page)]) == 0
    lines = [line.split() for line in capsys.readouterr().out.splitlines()]
    # 20, 25, 20 and 40, 42, 40 calculations: sheets of 60, 67, 60.
    assert lines[1:] == [
        ["1", "spool", "3", "20–25", "1.25", "0–2", "1"],
        ["2", "spool", "3", "40–42", "1.05", "3–4", "1"],
        ["sheet", "3", "60–67", "1.12"],
        [],
        ["how", "often", "each", "configuration", "was", "drawn"],
        ["1", "spool", "side:", "left", "2,", "right", "1"],
    ]
    text = page.read_text("utf-8")
    assert "Quiz &lt;1&gt;" in text
    assert 'aria-label="60: 2; 67: 1"' in text
    assert "1,12" in text
    assert "side: left 2, right 1" in text


def test_an_exam_without_work_is_told(tmp_path: Path, capsys: pytest.CaptureFixture[str]) -> None:
    bare = {name: value for name, value in problem(1, 1, 1, 0).items() if name != "work"}
    assert main(["fairness", str(manifest(tmp_path, [bare]))]) == 2
    assert "no work is recorded" in capsys.readouterr().err
