"""Problems of printed books: each scene is solved as on the command line and compared with what the book prints.

Beside a scene ``NAME.toml`` (at most 30 lines) lies ``NAME.book.toml``:

- ``source``: book, number, page; ``problem``: what it is about, in our own words;
- ``scene``: the file of another problem with the same scene; ``set``: its parameters;
- ``unexplained``: why there is no worked solution, where there is none;
- ``inexact``: why a printed number is off by more than a hundredth, where one is: measured on a drawing, say;
- ``[answers]``: by asked quantity the number as it is printed, as a text whose digits count, or a table with
  ``printed``, ``within`` (the deviation that the roundings or the drawing of the book explain, in the printed unit),
  ``magnitude`` (no sign is printed), ``correct`` (the publication is wrong, this is right).
"""

from __future__ import annotations

import json
import math
import textwrap
import tomllib
from decimal import Decimal
from pathlib import Path
from typing import Any

import pytest

from variantgen.cli import main

FOLDER = Path(__file__).parent
BOOKS = sorted(FOLDER.glob("*.book.toml"))
# Values of an interval, which no program prints.
_OF_INTERVAL = ("instant_", "way_", "shift_", "average_", "turned_", "duration_", "t_", "mean_t_", "max_t_", "min_t_")
# Positions, and values of a whole turn of the crank or of an interval.
_WITHOUT_PROGRAM = (
    "x_",
    "y_",
    "angle_",
    "distance_",
    "stroke_",
    "swing_",
    "time_ratio_",
    "max_",
    "min_",
    "mean_",
    "phi_",
    *_OF_INTERVAL,
)
_LINES = 30
_KEYS = {"source", "problem", "scene", "set", "unexplained", "inexact", "answers"}
_LARGEST, _INEXACT = 0.01, 0.05  # deviations of printed numbers, relative: of any, and of those said to be inexact


def _step(printed: str) -> float:
    """Half a unit of the last printed digit, and what is left of exact halves."""
    exponent = Decimal(printed).as_tuple().exponent
    assert isinstance(exponent, int)
    return 0.5000001 * 10.0**exponent


def _deviation(value: float, printed: str, magnitude: bool) -> float:
    return abs((abs(value) if magnitude else value) - float(printed))


_EACH = pytest.mark.parametrize("path", BOOKS, ids=[path.name.removesuffix(".book.toml") for path in BOOKS])


def _command(path: Path, book: dict[str, Any]) -> list[str]:
    """The command that solves the scene of a book."""
    scene = FOLDER / book.get("scene", path.name.replace(".book.toml", ".toml"))
    assert len(scene.read_text(encoding="utf-8").splitlines()) <= _LINES
    settings = [part for name, value in book.get("set", {}).items() for part in ("--set", f"{name}={value}")]
    asked = list(book["answers"]) if "scene" in book else []
    return ["solve", str(scene), *settings, *(part for name in asked for part in ("--ask", name))]


@_EACH
def test_the_printed_answers_are_reached(path: Path, capsys: pytest.CaptureFixture[str]) -> None:
    book: dict[str, Any] = tomllib.loads(path.read_text(encoding="utf-8"))
    assert set(book) <= _KEYS
    assert book["source"]
    assert book["problem"]
    code = main([*_command(path, book), "--json"])
    shown = capsys.readouterr()
    assert code == 0, shown.err
    found = {f"{a['quantity']} in {a['unit']}": a["value"] for a in json.loads(shown.out)["answers"]}
    names = {name.partition(" in ")[0]: name for name in found}
    for name, said in book["answers"].items():
        answer = said if isinstance(said, dict) else {"printed": said}
        assert set(answer) <= {"printed", "within", "magnitude", "correct"}
        assert names[name.partition(" in ")[0]] == name or " in " not in name, f"another unit: {list(found)}"
        value, magnitude = found[names[name.partition(" in ")[0]]], answer.get("magnitude", False)
        right = answer.get("correct", answer["printed"])
        within = answer.get("within", _step(right))
        assert math.isfinite(value)
        assert _deviation(value, right, magnitude) <= within, f"{name}: {value}, {right} in the book"
        if "correct" in answer:
            assert _deviation(value, answer["printed"], magnitude) > within, f"{name}: the book is right"


@_EACH
def test_there_is_a_worked_solution(path: Path, capsys: pytest.CaptureFixture[str]) -> None:
    book: dict[str, Any] = tomllib.loads(path.read_text(encoding="utf-8"))
    code = main([*_command(path, book), "--explain"])
    shown = capsys.readouterr()
    assert code == 0, shown.err
    _, answer, last = shown.out.rpartition("\nAnswer: ")
    assert bool(answer) != bool(book.get("unexplained")), shown.err
    if answer:
        assert last.partition("\n\n")[0].count(";") + 1 == len(book["answers"])


@_EACH
def test_the_printed_program_finds_what_the_solver_finds(path: Path, capsys: pytest.CaptureFixture[str]) -> None:
    book: dict[str, Any] = tomllib.loads(path.read_text(encoding="utf-8"))
    command = [part.partition(" in ")[0] for part in _command(path, book)]
    if "--ask" not in command:
        command += [part for name in book["answers"] for part in ("--ask", name.partition(" in ")[0])]
    assert main([*command, "--json"]) == 0
    solved = {a["quantity"]: a["value"] for a in json.loads(capsys.readouterr().out)["answers"]}
    assert main([*command, "--explain", "--method", "coordinates"]) == 0
    _, head, program = capsys.readouterr().out.partition("    import numpy as np\n")
    if not head:
        assert all(name.startswith(_WITHOUT_PROGRAM) for name in solved), "no program"
        return
    lines = textwrap.dedent(head + program.partition("\nAnswer: ")[0])
    exec(compile(lines, path.name, "exec"), {})
    printed = dict(line.split(" = ") for line in capsys.readouterr().out.splitlines())
    for name, value in solved.items():
        if name.startswith(_OF_INTERVAL):
            continue
        assert float(printed[name]) == pytest.approx(value, rel=1e-7, abs=1e-7), name


@_EACH
def test_large_deviations_have_a_reason(path: Path) -> None:
    book: dict[str, Any] = tomllib.loads(path.read_text(encoding="utf-8"))
    answers = [answer for answer in book["answers"].values() if isinstance(answer, dict) and "within" in answer]
    allowed = [answer["within"] / abs(float(answer.get("correct", answer["printed"]))) for answer in answers]
    largest = max(allowed, default=0.0)
    assert (largest > _LARGEST) == bool(book.get("inexact"))
    assert largest <= _INEXACT


def test_every_scene_has_its_book() -> None:
    scenes = {path.name for path in FOLDER.glob("*.toml")} - {path.name for path in BOOKS}
    used = {
        tomllib.loads(path.read_text(encoding="utf-8")).get("scene", path.name.replace(".book", "")) for path in BOOKS
    }
    assert scenes == used
    assert BOOKS
