"""A build that is interrupted leaves a complete folder or none, and the next run cleans up."""

from __future__ import annotations

import contextlib
import os
import signal
import subprocess
import sys
import time
from collections.abc import Iterator
from pathlib import Path

import pytest

MANY = 300  # students: of twelve parts some are to come when the first is there
FILES = ["key.csv", "key.pdf", "manifest.json", "sheets.pdf"]
# Without solutions and bands of work, which have nothing to do with folders and take most of the time.
EXAM = """
title = "Quiz"
language = "en"
fair = false
[solutions]
depth = "none"
[[problem]]
family = "spool"
"""


def start(folder: Path, variants: int, *options: str) -> subprocess.Popen[str]:
    (folder / "exam.toml").write_text(EXAM, encoding="utf-8")
    command = [sys.executable, "-m", "variantgen", "build", "exam.toml", "--variants", str(variants), "--out", "out"]
    return subprocess.Popen(
        [*command, *options],
        cwd=folder,
        stderr=subprocess.PIPE,
        text=True,
        start_new_session=True,
        env={**os.environ, "TMPDIR": str(folder / "tmp")},
    )


def finish(process: subprocess.Popen[str]) -> str:
    message = process.communicate(timeout=30)[1]
    assert "Traceback" not in message, message
    return message


def partial(folder: Path) -> list[Path]:
    return list(folder.glob(".out.partial-*"))


def kept(folder: Path) -> list[Path]:
    return list(folder.glob(".out.unfinished"))


def moments(folder: Path, process: subprocess.Popen[str], moment: str) -> None:
    """Wait until the build has come to the moment, or has ended."""
    if moment.endswith("s"):
        time.sleep(float(moment[:-1]))
        return
    pattern = {
        "folder": ".out.unfinished",
        "part": ".out.unfinished/made/*.pdf",
        "joined": ".out.partial-*/sheets.pdf",
        "key": ".out.partial-*/key.csv",
    }
    end = time.monotonic() + 20
    while process.poll() is None and time.monotonic() < end and not seen(folder, pattern[moment]):
        time.sleep(0.002)


def seen(folder: Path, pattern: str) -> bool:
    try:
        return any(folder.glob(pattern))
    except FileNotFoundError:  # a folder has gone while it was being looked through
        return False


def complete_or_absent(folder: Path) -> bool:
    out = folder / "out"
    if not out.exists():
        return False
    assert sorted(path.name for path in out.iterdir()) == FILES
    assert all(path.stat().st_size > 0 for path in out.iterdir())
    return True


@pytest.fixture
def folder(tmp_path: Path) -> Iterator[Path]:
    (tmp_path / "tmp").mkdir()
    yield tmp_path


@pytest.mark.parametrize("moment", ["0.3s", "folder", "part", "joined", "key"])
@pytest.mark.parametrize("number", [signal.SIGINT, signal.SIGTERM], ids=lambda number: number.name)
def test_interrupt_leaves_nothing_half_done(number: signal.Signals, moment: str, folder: Path) -> None:
    process = start(folder, 120 if moment in {"joined", "key"} else MANY)
    moments(folder, process, moment)
    process.send_signal(number)
    message = process.communicate(timeout=30)[1]
    done = complete_or_absent(folder)
    assert partial(folder) == []
    assert list((folder / "tmp").iterdir()) == []
    assert process.returncode != 0 or done
    if moment != "0.3s":  # before that the interpreter itself may still be starting
        assert "Traceback" not in message
        if not done:
            assert process.returncode in {128 + number, -number}
            assert bool(kept(folder)) == ("--resume" in message)
            if number is signal.SIGINT:
                assert "interrupted, no output was written" in message
        if moment in {"part", "joined", "key"}:
            assert done != bool(kept(folder)), "what is done is kept until the output is there"


@pytest.mark.parametrize("number", [signal.SIGINT, signal.SIGTERM], ids=lambda number: number.name)
def test_interrupt_with_several_processes(number: signal.Signals, folder: Path) -> None:
    process = start(folder, MANY, "--jobs", "2")
    moments(folder, process, "part")
    process.send_signal(number)
    finish(process)
    complete_or_absent(folder)
    assert partial(folder) == []


@pytest.mark.parametrize("number", [signal.SIGINT, signal.SIGTERM], ids=lambda number: number.name)
def test_interrupt_with_force_keeps_the_old_folder(number: signal.Signals, folder: Path) -> None:
    (folder / "out").mkdir()
    (folder / "out" / "mine.txt").write_text("keep")
    process = start(folder, MANY, "--force")
    moments(folder, process, "part")
    process.send_signal(number)
    finish(process)
    assert [path.name for path in (folder / "out").iterdir()] == ["mine.txt"]
    assert partial(folder) == []


@pytest.mark.parametrize("moment", ["folder", "part", "joined", "key"])
def test_the_run_after_a_kill_cleans_up(moment: str, folder: Path) -> None:
    process = start(folder, 120 if moment in {"joined", "key"} else MANY)
    moments(folder, process, moment)
    process.kill()
    process.communicate(timeout=30)
    if not complete_or_absent(folder):
        assert len(partial(folder)) == (1 if moment in {"joined", "key"} else 0)
        assert len(kept(folder)) == 1
    again = start(folder, 2, "--force")
    finish(again)
    assert again.returncode == 0
    assert complete_or_absent(folder)
    assert partial(folder) == []
    assert kept(folder) == []


def test_a_kill_with_several_processes_leaves_no_worker(folder: Path) -> None:
    process = start(folder, MANY, "--jobs", "2")
    moments(folder, process, "part")
    process.kill()
    try:
        process.communicate(timeout=5)  # ends when no process holds the pipe any more
    finally:
        with contextlib.suppress(ProcessLookupError):
            os.killpg(process.pid, signal.SIGKILL)
        process.communicate()
