"""An instructor's own families: by option, by environment, beside the exam file."""

from __future__ import annotations

import json
from pathlib import Path

import pytest

from variantgen.cli import main
from variantgen.families.reading.folders import VARIABLE, family_folders
from variantgen.resources import folder_hash
from variantgen.skeletons import new_family

EXAM = 'title = "T"\nlanguage = "en"\n[[problem]]\nfamily = "own_crank"\n'


def test_by_option_and_environment(
    tmp_path: Path, capsys: pytest.CaptureFixture[str], monkeypatch: pytest.MonkeyPatch
) -> None:
    new_family("own_crank", tmp_path)
    assert main(["solve", "own_crank", "--json"]) == 2
    assert "unknown family" in capsys.readouterr().err
    for option in (["--families", str(tmp_path)], []):
        if not option:
            monkeypatch.setenv(VARIABLE, str(tmp_path))
        assert main(["list", *option]) == 0
        assert "own_crank" in capsys.readouterr().out
        assert main(["solve", "own_crank", "--json", *option]) == 0
        assert json.loads(capsys.readouterr().out)["family"] == "own_crank"
        assert main(["check", "own_crank", "--seeds", "5", *option]) == 0
        capsys.readouterr()


def test_beside_the_exam_file(tmp_path: Path, capsys: pytest.CaptureFixture[str]) -> None:
    folder = new_family("own_crank", tmp_path / "course")
    exam = tmp_path / "course" / "exam.toml"
    exam.write_text(EXAM, "utf-8")
    assert main(["build", str(exam), "--variants", "2", "--out", str(tmp_path / "out")]) == 0
    manifest = json.loads((tmp_path / "out" / "manifest.json").read_text("utf-8"))
    assert manifest["made_with"]["family:own_crank"] == folder_hash(folder)
    capsys.readouterr()


def test_the_nearest_folder_wins(tmp_path: Path) -> None:
    for name in ("chosen", "listed", "course"):
        (tmp_path / name).mkdir()
    found = family_folders([tmp_path / "chosen"], tmp_path / "course" / "exam.toml")
    assert found == ((tmp_path / "chosen").resolve(), (tmp_path / "course").resolve())


@pytest.mark.parametrize("option", [["--families", "nowhere"], []])
def test_a_folder_that_does_not_exist(
    option: list[str], capsys: pytest.CaptureFixture[str], monkeypatch: pytest.MonkeyPatch
) -> None:
    if not option:
        monkeypatch.setenv(VARIABLE, "nowhere")
    assert main(["list", *option]) == 2
    message = capsys.readouterr().err
    assert "is no folder" in message
    assert "nowhere" in message


@pytest.mark.parametrize(
    ("arguments", "said"),
    [
        (["family", "Four-Bar"], "small letter followed by"),
        (["family", "four_bar"], "the catalogue has a family of this name"),
        (["family", ""], "small letter"),
        (["exam", "../quiz"], "small letter"),
    ],
)
def test_wrong_names_of_new_things(
    arguments: list[str], said: str, tmp_path: Path, capsys: pytest.CaptureFixture[str]
) -> None:
    assert main(["new", *arguments, "--out", str(tmp_path)]) == 2
    assert said in capsys.readouterr().err
    assert list(tmp_path.iterdir()) == []


def test_nothing_is_overwritten(tmp_path: Path, capsys: pytest.CaptureFixture[str]) -> None:
    for arguments in (["family", "own_crank"], ["exam", "quiz"]):
        assert main(["new", *arguments, "--out", str(tmp_path)]) == 0
        assert main(["new", *arguments, "--out", str(tmp_path)]) == 2
        assert "exists already" in capsys.readouterr().err
    assert sorted(path.name for path in tmp_path.iterdir()) == ["own_crank", "quiz.toml"]
    assert main(["build", str(tmp_path / "quiz.toml"), "--variants", "2", "--out", str(tmp_path / "out")]) == 0
