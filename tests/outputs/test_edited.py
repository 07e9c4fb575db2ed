"""What somebody has typed into an output is never lost: not to ``--force``, and not to an interruption of it."""

from __future__ import annotations

import json
import os
import shutil
from pathlib import Path

import pytest

from tests.outputs.formats.workbooks import Grading
from variantgen.cli import main
from variantgen.outputs.files import edited
from variantgen.outputs.files.folder import whole_folder
from variantgen.outputs.formats import known_files

EXAM = """
title = "Quiz"
language = "en"
formats = ["xlsx", "html"]
[solutions]
depth = "none"
[[problem]]
family = "rolling_wheel"
ask = ["omega_wheel"]
"""
STUDENTS = 4


def build(folder: Path, *options: str) -> int:
    (folder / "exam.toml").write_text(EXAM, "utf-8")
    arguments = ["build", str(folder / "exam.toml"), "--variants", str(STUDENTS), "--out", str(folder / "out")]
    return main([*arguments, *options])


def mark(path: Path, first: float) -> list[float]:
    """Type a number for every student, as an instructor does, and save the workbook; the numbers typed."""
    grading = Grading(path)
    ((column,),) = (problem.typed for problem in grading.problems())
    numbers = [first + k for k in range(STUDENTS)]
    for row, number in zip(grading.rows, numbers, strict=True):
        grading.sheet.cell(row, column).value = number
    grading.book.save(path)
    return numbers


def marked(path: Path) -> list[float]:
    """What was typed, read back."""
    grading = Grading(path)
    ((column,),) = (problem.typed for problem in grading.problems())
    return [grading.sheet.cell(row, column).value for row in grading.rows]


@pytest.fixture(scope="module")
def made(tmp_path_factory: pytest.TempPathFactory) -> Path:
    folder = tmp_path_factory.mktemp("made")
    assert build(folder) == 0
    return folder


@pytest.fixture
def folder(made: Path, tmp_path: Path) -> Path:
    shutil.copytree(made, tmp_path / "work")
    return tmp_path / "work"


def test_force_keeps_a_workbook_that_was_filled_in(folder: Path, capsys: pytest.CaptureFixture[str]) -> None:
    out = folder / "out"
    fresh, manifest = (out / "grading.xlsx").read_bytes(), (out / "manifest.json").read_bytes()
    typed = mark(out / "grading.xlsx", 10.5)
    assert build(folder, "--force") == 0
    output = capsys.readouterr().err
    assert str(out.resolve() / "edited" / "1") in output
    assert "grading.xlsx" in output
    assert marked(out / "edited" / "1" / "grading.xlsx") == typed
    assert (out / "edited" / "1" / "manifest.json").read_bytes() == manifest
    assert sorted(path.name for path in (out / "edited" / "1").iterdir()) == ["grading.xlsx", "manifest.json"]
    assert (out / "grading.xlsx").read_bytes() == fresh
    assert sorted(path.name for path in folder.iterdir()) == ["exam.toml", "out"]


def test_what_was_kept_before_is_kept_again_and_nothing_collides(folder: Path) -> None:
    out, typed = folder / "out", []
    for number in range(3):
        typed.append(mark(out / "grading.xlsx", 100.0 * number))
        assert build(folder, "--force") == 0
    assert [marked(out / "edited" / str(k) / "grading.xlsx") for k in (1, 2, 3)] == typed
    assert build(folder, "--force") == 0, "nothing was edited since"
    assert sorted(path.name for path in (out / "edited").iterdir()) == ["1", "2", "3"]


def test_an_output_that_nobody_touched_leaves_nothing_behind(folder: Path, capsys: pytest.CaptureFixture[str]) -> None:
    assert build(folder, "--force") == 0
    assert not (folder / "out" / "edited").exists()
    assert "kept" not in capsys.readouterr().err


@pytest.mark.parametrize("manifest", ["", "{", '{"files": 5}', None])
def test_without_a_record_everything_is_kept(manifest: str | None, folder: Path) -> None:
    out = folder / "out"
    names = {path.name: path.read_bytes() for path in out.iterdir() if path.is_file() and path.name != "manifest.json"}
    if manifest is None:
        (out / "manifest.json").unlink()
    else:
        (out / "manifest.json").write_text(manifest)
        names["manifest.json"] = manifest.encode()
    assert build(folder, "--force") == 0
    assert names.items() <= {p.name: p.read_bytes() for p in (out / "edited" / "1").iterdir() if p.is_file()}.items()
    assert (out / "edited" / "1" / "html" / "sheets.html").is_file()


def test_files_that_were_added_among_ours_are_kept(folder: Path) -> None:
    # ``key.pdf`` is a name that a build may make, but this one did not.
    (folder / "out" / "key.pdf").write_bytes(b"scanned")
    (folder / "out" / "html" / "key.html").write_bytes(b"my remarks")
    assert build(folder, "--force") == 0
    assert (folder / "out" / "edited" / "1" / "key.pdf").read_bytes() == b"scanned"
    assert (folder / "out" / "edited" / "1" / "html" / "key.html").read_bytes() == b"my remarks"


def test_what_cannot_be_read_is_kept(folder: Path) -> None:
    (folder / "out" / "key.xlsx").unlink()
    os.mkfifo(folder / "out" / "key.xlsx")  # reading it would wait for ever
    (folder / "out" / "key.csv").unlink()
    (folder / "out" / "key.csv").symlink_to("nowhere")
    assert build(folder, "--force") == 0
    kept = folder / "out" / "edited" / "1"
    assert kept.joinpath("key.xlsx").is_fifo()
    assert kept.joinpath("key.csv").is_symlink()


def test_a_pipe_in_the_place_of_the_manifest(folder: Path, capsys: pytest.CaptureFixture[str]) -> None:
    (folder / "out" / "manifest.json").unlink()
    os.mkfifo(folder / "out" / "manifest.json")
    code, output = verified(folder, capsys)
    assert code == 2
    assert "manifest.json: expected a file" in output
    assert build(folder, "--force") == 0
    assert (folder / "out" / "edited" / "1" / "manifest.json").is_fifo()


@pytest.mark.parametrize("moment", ["moved", "half", "removed"])
def test_an_interruption_of_the_change_loses_nothing(
    moment: str, folder: Path, monkeypatch: pytest.MonkeyPatch, capsys: pytest.CaptureFixture[str]
) -> None:
    out = folder / "out"
    typed = mark(out / "grading.xlsx", 7.0)
    (out / "html" / "key.html").write_bytes(b"my remarks")

    class KilledError(BaseException):
        """The process ends here."""

    def killed(*_: object, **__: object) -> None:
        raise KilledError

    real = Path.rename

    def rename(self: Path, target: Path) -> Path:
        if "edited" in Path(target).parts and self.name == "key.html":
            raise KilledError
        return real(self, target)

    with monkeypatch.context() as patch:
        if moment == "moved":
            patch.setattr("variantgen.outputs.files.folder.keep_edited", killed)
        elif moment == "half":
            patch.setattr(Path, "rename", rename)
        else:
            patch.setattr("variantgen.outputs.files.folder.shutil.rmtree", killed)
        with pytest.raises(KilledError):
            build(folder, "--force")
    capsys.readouterr()
    assert build(folder, "--force") == 0
    kept = out / "edited"
    assert [marked(path) for path in kept.rglob("grading.xlsx")] == [typed]
    assert [path.read_bytes() for path in kept.rglob("key.html")] == [b"my remarks"]
    assert sorted(path.name for path in folder.iterdir() if "partial" not in path.name) == ["exam.toml", "out"]


def test_what_comes_while_the_output_is_made(tmp_path: Path) -> None:
    """A folder that appears meanwhile is not replaced."""
    out = tmp_path / "out"
    with pytest.raises(Exception, match="exists"), whole_folder(out, False, known_files, []) as work:
        (work / "key.csv").write_text("ours")
        out.mkdir()
        (out / "key.csv").write_text("theirs")
    assert (out / "key.csv").read_text() == "theirs"
    assert [path.name for path in tmp_path.iterdir()] == ["out"]


def test_only_files_that_are_about_to_be_replaced(folder: Path) -> None:
    out = folder / "out"
    typed = mark(out / "grading.xlsx", 1.0)
    (out / "html" / "key.html").write_bytes(b"my remarks")
    assert "grading.xlsx" in edited.keep_edited(out, out, {"grading.xlsx", "key.csv"})
    assert marked(out / "edited" / "1" / "grading.xlsx") == typed
    assert (out / "html" / "key.html").read_bytes() == b"my remarks"
    assert (out / "key.csv").is_file(), "it was not edited"
    assert edited.keep_edited(out, out, {"key.csv"}) == ""


def verified(folder: Path, capsys: pytest.CaptureFixture[str]) -> tuple[int, str]:
    capsys.readouterr()
    code = main(["verify", str(folder / "out")])
    return code, capsys.readouterr().err


def test_verify_tells_edited_from_damaged(folder: Path, capsys: pytest.CaptureFixture[str]) -> None:
    out = folder / "out"
    mark(out / "grading.xlsx", 3.0)
    code, output = verified(folder, capsys)
    assert code == 0
    assert "edited since the build, which is no fault: grading.xlsx" in output
    assert "all right" in output
    (out / "html" / "sheets.html").write_bytes((out / "html" / "sheets.html").read_bytes()[:-1])
    code, output = verified(folder, capsys)
    assert code == 1
    assert "html/sheets.html: the file has been changed since the build" in output
    assert "edited since the build, which is no fault: grading.xlsx" in output


@pytest.mark.parametrize("damage", [lambda b: b[:-200], lambda b: b"", lambda b: b[:300] + b"\0" * 40 + b[340:]])
def test_a_workbook_that_cannot_be_opened_is_damaged(damage, folder: Path, capsys: pytest.CaptureFixture[str]) -> None:
    path = folder / "out" / "grading.xlsx"
    path.write_bytes(damage(path.read_bytes()))
    code, output = verified(folder, capsys)
    assert code == 1
    assert "grading.xlsx: the file has been changed since the build" in output


def test_kept_files_are_no_fault(folder: Path, capsys: pytest.CaptureFixture[str]) -> None:
    mark(folder / "out" / "grading.xlsx", 3.0)
    assert build(folder, "--force") == 0
    assert verified(folder, capsys)[0] == 0
    capsys.readouterr()
    assert main(["verify", str(folder / "out"), "--json"]) == 0
    assert json.loads(capsys.readouterr().out)["edited"] == []


def test_latex_sources_and_what_is_made_of_them() -> None:
    changed = {"latex/key.tex", "latex/key.pdf", "latex/sheets.pdf", "key.pdf"}
    meant = {name for name in changed if edited.is_meant(Path("nowhere"), name, changed)}
    assert meant == {"latex/key.tex", "latex/key.pdf"}
