"""Files of other people say nothing to the terminal but text: no escape sequence of theirs reaches it."""

from __future__ import annotations

import json
from pathlib import Path

import pytest

from variantgen.cli import main

CLEAR = "\x1b[2J\x1b]0;gone\x07"
SPELLED = r"\u001b[2J\u001b]0;gone\u0007"
EXAM = 'title = "T"\nlanguage = "en"\n{more}\n[[problem]]\nfamily = "{family}"\nask = ["v_O"]\n'


def quoted(text: str) -> str:
    return json.dumps(text)[1:-1]


def written(capsys: pytest.CaptureFixture[str]) -> str:
    found = capsys.readouterr()
    assert "\x1b" not in found.out + found.err
    assert "\x07" not in found.out + found.err
    return found.out + found.err


@pytest.mark.parametrize(
    ("family", "more"),
    [(CLEAR, ""), ("spool", f'"{quoted(CLEAR)}" = 1'), ("spool", f'formats = ["{quoted(CLEAR)}"]')],
)
def test_exam_file(family: str, more: str, tmp_path: Path, capsys: pytest.CaptureFixture[str]) -> None:
    path = tmp_path / "exam.toml"
    path.write_text(EXAM.format(family=quoted(family), more=more), "utf-8")
    assert main(["build", str(path), "--variants", "1", "--out", str(tmp_path / "out")]) == 2
    assert SPELLED in written(capsys)


def test_manifest(tmp_path: Path, capsys: pytest.CaptureFixture[str]) -> None:
    path = tmp_path / "exam.toml"
    path.write_text(EXAM.format(family="spool", more='formats = ["html"]'), "utf-8")
    assert main(["build", str(path), "--variants", "1", "--out", str(tmp_path / "out"), "--no-solutions"]) == 0
    capsys.readouterr()
    manifest = tmp_path / "out" / "manifest.json"
    changed = json.loads(manifest.read_text("utf-8"))
    changed["files"][f"html/{CLEAR}.html"] = "0" * 64
    changed["made_with"]["engine"] = CLEAR
    manifest.write_text(json.dumps(changed), "utf-8")
    for command in (["verify"], ["verify", "--json"], ["remake", "--student", "1"], ["remake", "--student", CLEAR]):
        assert main([command[0], str(tmp_path / "out"), *command[1:]]) in {1, 2}
        assert "gone" in written(capsys)


def test_name_of_a_file(tmp_path: Path, capsys: pytest.CaptureFixture[str]) -> None:
    assert main(["solve", str(tmp_path / f"{CLEAR}.toml")]) == 2
    assert SPELLED in written(capsys)
