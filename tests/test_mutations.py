"""Damaged input of every kind is refused with a message or gives sound sheets: never a traceback, never a wrong key."""

from __future__ import annotations

import io
import json
import shutil
import tempfile
from collections.abc import Callable
from contextlib import redirect_stderr, redirect_stdout
from functools import cache
from pathlib import Path

import openpyxl
import pytest
from hypothesis import given
from hypothesis import strategies as st

from variantgen.cli import main
from variantgen.resources import catalog_dir

EXAM = """
title = "Quiz"
language = "en"
seed = 7
fair = false
tolerance = { floor = 0.02, ceiling = 0.03, mistakes = true }
formats = ["pdf"]
[solutions]
depth = "none"
[page]
duplex = true
[notation]
components = "normal"
[[problem]]
families = ["own"]
range = { v_B = [20, 60] }
points = 3
nice = false
"""
ROSTER = "id;name;group\n17;Иванов Иван;М-21\n4;Öztürk Ann;М-22\n"


@st.composite
def damages(draw: st.DrawFn) -> Callable[[bytes], bytes]:
    """One to three damages: bits flipped, ends cut off, slices removed, doubled, replaced, lines exchanged."""
    steps = draw(
        st.lists(
            st.tuples(st.sampled_from("ftrdxsn"), st.floats(0, 1), st.floats(0, 1), st.binary(min_size=1, max_size=6)),
            min_size=1,
            max_size=3,
        )
    )

    def damaged(content: bytes) -> bytes:
        for kind, start, length, other in steps:
            content = step(content, kind, int(start * len(content)), 1 + int(length**3 * 40), other)
        return content

    return damaged


def step(content: bytes, kind: str, at: int, length: int, other: bytes) -> bytes:
    match kind:
        case "f" if at < len(content):
            return content[:at] + bytes([content[at] ^ (1 << (length % 8))]) + content[at + 1 :]
        case "t":
            return content[:at]
        case "r":
            return content[:at] + content[at + length :]
        case "d":
            return content[: at + length] + content[at:]
        case "x":
            return content[:at] + other + content[at + length :]
        case "n":
            number = str(int.from_bytes(other, "big", signed=True)).encode()
            return content[:at] + number + content[at + length :]
        case _:
            lines = content.splitlines(keepends=True)
            if len(lines) < 2:
                return content
            i, j = at % len(lines), length % len(lines)
            lines[i], lines[j] = lines[j], lines[i]
            return b"".join(lines)


def output(*arguments: str) -> tuple[int, str]:
    """Exit code and messages of a command."""
    out = io.StringIO()
    with redirect_stderr(out), redirect_stdout(out):
        code = main(list(arguments))
    return code, out.getvalue()


def workplace(folder: Path) -> Path:
    """An exam with a family of its own and a roster."""
    own = folder / "own"
    shutil.copytree(catalog_dir() / "spool", own)
    (folder / "exam.toml").write_text(EXAM, "utf-8")
    (folder / "class.csv").write_text(ROSTER, "utf-8")
    return folder


def check(name: str, damage: Callable[[bytes], bytes]) -> int:
    """Build with a damaged file; returns the exit code."""
    with tempfile.TemporaryDirectory() as temporary:
        folder = workplace(Path(temporary))
        target = folder / name
        target.write_bytes(damage(target.read_bytes()))
        out = folder / "out"
        code, said = output(
            "build", str(folder / "exam.toml"), "--roster", str(folder / "class.csv"), "--out", str(out)
        )
        assert code in {0, 1, 2}, said
        assert out.exists() == (code == 0), said
        assert sorted(path.name for path in folder.iterdir() if path.name != "out") == ["class.csv", "exam.toml", "own"]
        if code == 0:
            again, told_again = output("verify", str(out), "--families", str(folder))
            assert again == 0, told_again
        else:
            assert said.strip(), "a message is expected"
        return code


@given(damages())
def test_exam_file(damage: Callable[[bytes], bytes]) -> None:
    check("exam.toml", damage)


@given(damages())
def test_roster(damage: Callable[[bytes], bytes]) -> None:
    check("class.csv", damage)


@pytest.mark.parametrize("name", ["family.toml", "statement.en.j2"])
@given(damage=damages())
def test_family(name: str, damage: Callable[[bytes], bytes]) -> None:
    check(f"own/{name}", damage)


@given(damages())
def test_roster_in_a_workbook(damage: Callable[[bytes], bytes]) -> None:
    check("class.csv", lambda _: damage(workbook()))


@cache
def workbook() -> bytes:
    book = openpyxl.Workbook()
    for line in ROSTER.splitlines():
        book.active.append(line.split(";"))
    out = io.BytesIO()
    book.save(out)
    return out.getvalue()


@pytest.fixture(scope="module")
def finished(tmp_path_factory: pytest.TempPathFactory) -> Path:
    folder = workplace(tmp_path_factory.mktemp("finished"))
    roster, out = str(folder / "class.csv"), str(folder / "out")
    assert output("build", str(folder / "exam.toml"), "--roster", roster, "--out", out)[0] == 0
    return folder


@given(damage=damages())
def test_manifest(damage: Callable[[bytes], bytes], finished: Path) -> None:
    manifest = finished / "out" / "manifest.json"
    sound = manifest.read_bytes()
    try:
        manifest.write_bytes(damage(sound))
        code, said = output("verify", str(finished / "out"), "--families", str(finished))
        assert code in {0, 1, 2}, said
        assert said.strip()
        if code == 0:  # what was damaged is nothing that a sheet or the key says
            assert sheets(manifest.read_bytes()) == sheets(sound)
    finally:
        manifest.write_bytes(sound)


def sheets(manifest: bytes) -> list[object]:
    """Who got which variant with which answers."""
    return [
        [
            [
                p["problem"],
                p["family"],
                p["form"],
                p["parameters"],
                p["pose"],
                [(a["quantity"], a["unit"]) for a in p["answers"]],
            ]
            for p in student["problems"]
        ]
        for student in json.loads(manifest)["students"]
    ]


def answers(problem: dict[str, list[dict[str, object]]]) -> list[tuple[object, object]]:
    return [(answer["quantity"], answer["unit"]) for answer in problem["answers"]]


def test_undamaged_input_builds() -> None:
    assert check("exam.toml", lambda content: content) == 0
