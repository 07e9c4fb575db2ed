"""A build that was cut short goes on where it was, with the same bytes, and redoes nothing."""

from __future__ import annotations

import json
import random
import signal
import subprocess
import sys
import time
from pathlib import Path

import pytest
from msgspec.structs import replace

from tests.builder.small_exams import TEXT, content, exam, exam_file
from tests.tools import NIGHTLY
from variantgen.builder import build, unfinished_folder
from variantgen.builder.jobs import DrawJob, RenderJob
from variantgen.builder.unfinished import Unfinished
from variantgen.cli import main
from variantgen.errors import InputError
from variantgen.exam.packing import PackingError, pack, unpack
from variantgen.exam.roster import Student, numbered

STUDENTS = 50  # a job of drawing for each problem, four parts, four overviews
JOBS = 8
KILLS = 20 if NIGHTLY else 5


class StoppedError(Exception):
    """Somebody pulled the plug."""


@pytest.fixture(scope="module")
def reference(tmp_path_factory: pytest.TempPathFactory) -> dict[str, bytes]:
    folder = tmp_path_factory.mktemp("reference")
    build(exam(folder), numbered(STUDENTS), folder / "out")
    return content(folder / "out")


def stopped(folder: Path, stage: str, after: int) -> None:
    """A build that ends when a stage has done so many students."""

    def progress(now: str, done: int, total: int) -> None:
        if now == stage and done >= after:
            raise StoppedError

    with pytest.raises(StoppedError):
        build(exam(folder), numbered(STUDENTS), folder / "out", progress=progress)
    assert not (folder / "out").exists()


@pytest.fixture
def jobs(monkeypatch: pytest.MonkeyPatch) -> list[str]:
    """The jobs that are done, by their kinds."""
    done: list[str] = []
    for kind in (DrawJob, RenderJob):

        def noted(self, setting, kind=kind, run=kind.run):  # type: ignore[no-untyped-def]
            done.append(kind.__name__)
            return run(self, setting)

        monkeypatch.setattr(kind, "run", noted)
    return done


@pytest.mark.parametrize(
    ("stage", "after", "drawn", "made"),
    [
        ("drawing variants", 25, 1, JOBS),
        ("drawing variants", 50, 0, JOBS),
        ("typesetting", 0, 0, JOBS),
        ("typesetting", 24, 0, JOBS - 2),
    ],
)
def test_it_goes_on_without_doing_anything_twice(
    stage: str, after: int, drawn: int, made: int, reference: dict[str, bytes], jobs: list[str], tmp_path: Path
) -> None:
    stopped(tmp_path, stage, after)
    jobs.clear()
    found = build(exam(tmp_path), numbered(STUDENTS), tmp_path / "out", resume=True)
    assert content(tmp_path / "out") == reference
    assert (jobs.count("DrawJob"), jobs.count("RenderJob")) == (drawn, made)
    assert found.kept == JOBS - made
    assert not unfinished_folder(tmp_path / "out").exists()


def test_without_resume_it_begins_anew(reference: dict[str, bytes], jobs: list[str], tmp_path: Path) -> None:
    stopped(tmp_path, "typesetting", 24)
    jobs.clear()
    build(exam(tmp_path), numbered(STUDENTS), tmp_path / "out")
    assert (jobs.count("DrawJob"), jobs.count("RenderJob")) == (2, JOBS)
    assert content(tmp_path / "out") == reference


def test_resume_without_anything_to_go_on_from(reference: dict[str, bytes], tmp_path: Path) -> None:
    build(exam(tmp_path), numbered(STUDENTS), tmp_path / "out", resume=True)
    assert content(tmp_path / "out") == reference


@pytest.mark.parametrize("what", ["seed", "roster", "exam"])
def test_parts_of_another_build_are_refused_and_kept(what: str, tmp_path: Path) -> None:
    stopped(tmp_path, "typesetting", 24)
    students = numbered(STUDENTS)
    if what == "roster":
        students[7] = Student("another", "")
    text = TEXT.replace("v_B", "omega_AB") if what == "exam" else TEXT
    before = content(unfinished_folder(tmp_path / "out"))
    with pytest.raises(InputError, match=what):
        build(exam(tmp_path, text), students, tmp_path / "out", "t" if what == "seed" else None, resume=True)
    assert {"made/0000000.json", "made/0000001.json"} < before.keys()
    assert content(unfinished_folder(tmp_path / "out")) == before


def test_damaged_pieces_are_made_again(reference: dict[str, bytes], jobs: list[str], tmp_path: Path) -> None:
    stopped(tmp_path, "typesetting", 24)
    made = unfinished_folder(tmp_path / "out") / "made"
    victim = next(path for path in sorted(made.iterdir()) if path.suffix == ".pdf")
    victim.write_bytes(victim.read_bytes()[:-10])
    jobs.clear()
    build(exam(tmp_path), numbered(STUDENTS), tmp_path / "out", resume=True)
    assert jobs.count("RenderJob") == JOBS - 1
    assert content(tmp_path / "out") == reference


def test_who_draws_again_is_decided_as_without_interruption(tmp_path: Path) -> None:
    # Few variants: many draw again, and some of them had done so before the interruption.
    text = (
        'title = "T"\nlanguage = "en"\n[solutions]\ndepth = "none"\n[[problem]]\nfamily = "spool"\nask = ["v_O"]\n'
        'set = { thread = "above", a_B = 100, v_B = 40 }\nrange = { r = [18, 26], R = [40, 60] }\n'
    )
    students = numbered(44)
    whole = build(exam(tmp_path, text), students, tmp_path / "whole")
    assert len(whole.redrawn) > 10

    for when in ("mark_drawn", "put_changed"):
        real = getattr(Unfinished, when)
        calls: list[int] = []

        def interrupted(self, *arguments, real=real, calls=calls, when=when):  # type: ignore[no-untyped-def]
            calls.append(1)
            if len(calls) > 1 or when == "put_changed":
                real(self, *arguments)
            if len(calls) == 1:
                raise StoppedError

        out = tmp_path / when
        with pytest.MonkeyPatch.context() as patch:
            patch.setattr(Unfinished, when, interrupted)
            with pytest.raises(StoppedError):
                build(exam(tmp_path, text), students, out)
            again = build(exam(tmp_path, text), students, out, resume=True)
        assert again.redrawn == whole.redrawn
        assert content(out) == content(tmp_path / "whole")


@pytest.mark.parametrize("number", range(KILLS))
def test_killed_at_any_moment_and_resumed(number: int, reference: dict[str, bytes], tmp_path: Path) -> None:
    command = [sys.executable, "-m", "variantgen", "build", str(exam_file(tmp_path)), "--variants", str(STUDENTS)]
    command += ["--out", "out", "--jobs", "2", "--resume"]
    moment = random.Random(number)
    for _ in range(3):
        process = subprocess.Popen(command, cwd=tmp_path, stderr=subprocess.DEVNULL)
        time.sleep(0.5 + 2 * moment.random())
        process.send_signal(moment.choice([signal.SIGKILL, signal.SIGTERM, signal.SIGINT]))
        process.wait(30)
        if (tmp_path / "out").exists():
            break
    else:
        subprocess.run(command, cwd=tmp_path, check=True, capture_output=True)
    assert content(tmp_path / "out") == reference
    assert sorted(path.name for path in tmp_path.iterdir()) == ["exam.toml", "out"]


def test_ctrl_c_says_how_to_go_on(tmp_path: Path) -> None:
    command = [
        sys.executable,
        "-m",
        "variantgen",
        "build",
        str(exam_file(tmp_path)),
        "--variants",
        "2000",
        "--out",
        "out",
    ]
    process = subprocess.Popen(command, cwd=tmp_path, stderr=subprocess.PIPE, text=True)
    folder = unfinished_folder(tmp_path / "out")
    deadline = time.monotonic() + 60
    while not (folder / "made/0000001.json").exists() and time.monotonic() < deadline:
        time.sleep(0.02)
    process.send_signal(signal.SIGINT)
    said = process.communicate(timeout=30)[1]
    assert process.returncode == 130
    assert "Traceback" not in said
    assert "--resume" in said
    assert str(folder) in said


def test_two_builds_of_one_folder(tmp_path: Path, capsys: pytest.CaptureFixture[str]) -> None:
    seen: list[int] = []

    def progress(stage: str, done: int, total: int) -> None:
        if not seen:
            seen.append(main(["build", str(tmp_path / "exam.toml"), "--variants", "2", "--out", str(tmp_path / "out")]))

    build(exam(tmp_path), numbered(2), tmp_path / "out", progress=progress)
    assert seen == [2]
    assert "another build" in capsys.readouterr().err
    assert (tmp_path / "out" / "sheets.pdf").exists()


def test_packed_problems_hold_problems_and_nothing_else(tmp_path: Path) -> None:
    from benchmarks.sheets import drawn_sheets

    found = exam(tmp_path, TEXT.replace("fair = false", "fair = true"))
    items = drawn_sheets(replace(found, seed="1"), numbered(3))[1].items
    content = pack(found, items)
    again = unpack(found, content)
    assert again == items
    assert again[0].work is not None
    assert again[0].variant.form is items[0].variant.form
    assert len(content) < 2000, "families are not packed"
    for bad in (b"", content[:-20], b"cos\nsystem\n(S'true'\ntR.", json.dumps({}).encode()):
        with pytest.raises(PackingError):
            unpack(found, bad)
