"""A build that is killed at any moment, or that runs out of room, leaves a complete folder or none."""

from __future__ import annotations

import json
import os
import random
import resource
import signal
import subprocess
import sys
import time
from collections.abc import Sequence
from pathlib import Path

import pytest

from tests.tools import NIGHTLY
from variantgen.outputs.formats import FORMATS

KILLS = 20 if NIGHTLY else 6
# A file fails to be written in the way of its format, so those builds have all of them. Who is killed does nothing any
# more, whatever he was writing: there one of pages, one of many files and one that is packed are enough.
EVERY, FEW = tuple(FORMATS), ("pdf", "html", "moodle")


def command(folder: Path, formats: Sequence[str], *options: str) -> list[str]:
    text = f'title = "Quiz"\nlanguage = "ru"\nfair = false\nformats = {json.dumps(list(formats))}\n'
    (folder / "exam.toml").write_text(text + '[[problem]]\nfamily = "spool"\n', "utf-8")
    return [sys.executable, "-m", "variantgen", "build", "exam.toml", "--variants", "3", "--out", "out", *options]


def content(folder: Path) -> dict[str, bytes]:
    return {p.relative_to(folder).as_posix(): p.read_bytes() for p in folder.rglob("*") if p.is_file()}


Build = tuple[dict[str, bytes], float]


def undisturbed(folder: Path, formats: Sequence[str]) -> Build:
    """The files of a build that nobody disturbs, and its seconds."""
    start = time.monotonic()
    subprocess.run(command(folder, formats), cwd=folder, check=True, capture_output=True)
    return content(folder / "out"), time.monotonic() - start


@pytest.fixture(scope="module")
def whole(tmp_path_factory: pytest.TempPathFactory) -> Build:
    return undisturbed(tmp_path_factory.mktemp("whole"), EVERY)


@pytest.fixture(scope="module")
def small(tmp_path_factory: pytest.TempPathFactory) -> Build:
    return undisturbed(tmp_path_factory.mktemp("small"), FEW)


@pytest.mark.parametrize("number", range(KILLS))
def test_killed_at_a_random_moment(number: int, small: Build, tmp_path: Path) -> None:
    files, seconds = small
    process = subprocess.Popen(command(tmp_path, FEW), cwd=tmp_path, stderr=subprocess.DEVNULL)
    time.sleep(random.Random(number).random() * seconds)
    process.send_signal(signal.SIGKILL)
    process.wait(30)
    if (tmp_path / "out").exists():
        assert content(tmp_path / "out") == files
    again = subprocess.run(command(tmp_path, FEW, "--force"), cwd=tmp_path, capture_output=True, text=True, check=False)
    assert again.returncode == 0, again.stderr
    assert content(tmp_path / "out") == files
    assert sorted(path.name for path in tmp_path.iterdir()) == ["exam.toml", "out"]


@pytest.mark.parametrize("limit", [0, 2_000, 9_000, 40_000, 90_000])
def test_no_room_for_a_file(limit: int, whole: Build, tmp_path: Path) -> None:
    """The system refuses files above a size, as a full disk does at some moment."""
    assert limit < max(map(len, whole[0].values()))

    def little_room() -> None:
        signal.signal(signal.SIGXFSZ, signal.SIG_IGN)
        resource.setrlimit(resource.RLIMIT_FSIZE, (limit, limit))

    arguments = command(tmp_path, EVERY)
    run = subprocess.run(
        arguments, cwd=tmp_path, capture_output=True, text=True, check=False, preexec_fn=little_room, timeout=60
    )
    assert "Traceback" not in run.stderr, run.stderr
    assert run.returncode == 2, run.stderr
    assert "writing failed" in run.stderr
    left = sorted(path.name for path in tmp_path.iterdir())
    assert left in (["exam.toml"], [".out.unfinished", "exam.toml"])
    assert (".out.unfinished" in left) == ("--resume" in run.stderr)
    # With more room it goes on from what there is.
    subprocess.run([*arguments, "--resume"], cwd=tmp_path, check=True, capture_output=True, timeout=60)
    assert content(tmp_path / "out") == whole[0]
    assert sorted(path.name for path in tmp_path.iterdir()) == ["exam.toml", "out"]


def test_a_folder_that_may_not_be_written(tmp_path: Path) -> None:
    closed = tmp_path / "closed"
    closed.mkdir(mode=0o555)
    parent = closed if os.geteuid() else Path("/proc")  # the superuser may write nearly anywhere
    run = subprocess.run(
        [*command(tmp_path, FEW), "--out", str(parent / "out")],
        check=False,
        cwd=tmp_path,
        capture_output=True,
        text=True,
    )
    assert run.returncode == 2
    assert "Traceback" not in run.stderr
    assert str(parent) in run.stderr
    assert "cannot be" in run.stderr
