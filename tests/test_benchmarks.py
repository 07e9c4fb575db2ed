"""The benchmarks on the smallest sizes: all is measured, tables are complete, sums and ratios agree; no times."""

from __future__ import annotations

import importlib
import io
import json
import subprocess
import sys
import types
from pathlib import Path
from typing import Any

import numpy as np
import pikepdf
import pytest

from benchmarks import (
    batches,
    caches,
    exams,
    hooks,
    measure,
    processes,
    rivals,
    scale,
    solver,
    stages,
    startup,
    yardstick,
)
from benchmarks.__main__ import PARTS
from benchmarks.processes import Ran
from variantgen.families.reading.load import load_family
from variantgen.resources import templates_dir
from variantgen.variants.variant import parameter_arrays

Rows = list[dict[str, Any]]


@pytest.fixture(scope="module")
def measured(tmp_path_factory: pytest.TempPathFactory) -> Path:
    """A folder with everything measured once."""
    out = tmp_path_factory.mktemp("benchmarks") / "measured"
    command = [sys.executable, "-m", "benchmarks", "--quick", "--students", "2", "--out", str(out)]
    run = subprocess.run(command, capture_output=True, text=True, check=False, env=processes.environment())
    assert run.returncode == 0, run.stderr[-3000:]
    return out


def tables(folder: Path, part: str) -> list[Rows]:
    found = json.loads((folder / f"{part}.json").read_text("utf-8"))
    assert found["machine"]["typst"] != "none"
    return [table["rows"] for table in found["tables"]]


def test_document_holds_every_table(measured: Path) -> None:
    text = (measured / "measured.md").read_text("utf-8")
    for part in PARTS:
        for table in json.loads((measured / f"{part}.json").read_text("utf-8"))["tables"]:
            assert f"### {table['title']}\n" in text
            assert table["rows"]
            assert "| " + " | ".join(table["rows"][0]) + " |" in text


def test_starting(measured: Path) -> None:
    (rows,) = tables(measured, "startup")
    assert [row["command"] for row in rows] == list(startup.commands(measured))
    took = {row["command"]: row["CPU, least, s"] for row in rows}
    assert 0 < took[startup.PYTHON] < took["--help"] < took["build sample_en --variants 1"]


def test_what_starting_takes_above_python() -> None:
    def ran(wall: float, cpu: float) -> Ran:
        return Ran(wall, cpu, 30.0, None, 0.0)

    made = startup.table({startup.PYTHON: [ran(3, 2), ran(5, 1), ran(9, 3)], "--help": [ran(4, 6), ran(8, 9)]})
    assert made.rows == [(startup.PYTHON, 3, 5, 1, 2, 0), ("--help", 4, 6, 6, 7.5, 5)]


def test_scale(measured: Path) -> None:
    times, memories, mark, (compared,) = tables(measured, "scale")
    assert compared["students"] == 2
    assert [row["made"] for row in times] == ["sheets and key", "with full solutions"]
    for time, memory in zip(times, memories, strict=True):
        assert time["students"] == memory["students"] == 2
        # The engine is a part of the build, and more than nothing; a build takes less than a minute.
        assert 0 < time["engine alone, ms"] < time["CPU per student, ms"] < 30_000
        assert memory["peak of one process, MB"] > 30
        assert 0.01 < memory["output, MB"] < memory["written, MB"]
    assert all(row["here"] > 0 for row in mark)


def test_another_machine_is_compared_by_the_yardstick() -> None:
    there = yardstick.THERE
    slow = yardstick.Mark(*(2 * number for number in vars(there).values()))
    # R/exams took 836 ms of time and 754 ms of CPU for a student; here everything takes twice as long.
    (row,) = yardstick.comparison(slow, [(100, 0.05)]).rows
    assert row == pytest.approx((100, 50, 1672, 33.44, 1508, 30.16))


def test_caches_and_settings(measured: Path) -> None:
    rows, settings = tables(measured, "caches")
    assert rows
    assert all(row["ready"] <= row["asked"] and row["saved, % of the command"] >= 0 for row in rows)
    assert [row["setting"] for row in settings] == [next(iter(caches.SETTINGS)), *caches.TRIED["list"][1]]


def test_caches_kept_for_others_are_there() -> None:
    for name in caches.IDENTITY:
        module, _, path = name.partition(":")
        found: Any = importlib.import_module(f"variantgen.{module}")
        for part in path.split("."):
            found = vars(found)[part]
        assert type(found).__name__ in {"cached_property", "_lru_cache_wrapper"}


def test_joining_keeps_tags_and_bookmarks(measured: Path) -> None:
    (rows,) = tables(measured, "joining")
    kept = {(row["document"], row["way"]): row for row in rows}
    own, pages = (kept["sheets with tags", way] for way in ("join_pdfs", "pikepdf, pages"))
    assert own["elements"] > 100 > pages["elements"] == 0
    assert own["bookmarks"] == pages["bookmarks"] == 1
    assert own["same bytes again"] == "yes"


def test_stages(measured: Path) -> None:
    ((*rows, every, bare),) = tables(measured, "stages")
    (case,) = [name for name in every if name != "stage"]
    named = {row["stage"]: row[case] for row in rows}
    elsewhere = {"Typst: {}", "figures: text in words", "equally hard variants: samples"}  # samples are kept
    assert {hook.stage for hook in stages.HOOKS} - elsewhere <= set(named)
    assert {"Typst: sheets.typ", "Typst: key.typ", "Typst: solutions.typ", stages.START, hooks.IMPORTS} <= set(named)
    assert all(value > 0 for stage, value in named.items() if stage not in {stages.END, stages.REST})
    assert named[stages.END] > -20
    assert every["stage"] == stages.ALL
    assert bare["stage"] == stages.BARE
    assert bare[case] > 0
    assert named[stages.REST] < 0.2 * every[case]
    assert 0.5 < every[case] / bare[case] < 2  # the clocks cost little, and nothing is counted twice


def test_solver_and_others_agree(measured: Path) -> None:
    catalogue, *compared = tables(measured, "solver")
    assert [row["form"] for row in catalogue] == ["crank", "rocker"]
    assert all(row["1"] > 0 and row["2"] > 0 for row in catalogue)
    assert len(compared) == len(rivals.MECHANISMS)
    for rows in compared:
        found = {row.pop("way"): row for row in rows}
        assert set(found) == {solver.OWN, solver.PREPARED, *rivals.WAYS}
        for way in ("closed form, plain numpy", "scipy root, linear systems"):
            assert 0 <= found[way]["largest difference from variantgen"] < 1e-10
        for way in ("closed form, numba", "pylinkage, an object each"):
            assert found[way]["1"] is None or 0 <= found[way]["largest difference from variantgen"] < 1e-10


def test_batches_are_compared_with_the_closed_form(measured: Path) -> None:
    found = tables(measured, "batches")
    assert len(found) == len(rivals.MECHANISMS)
    for rows in found:
        assert [row["variants"] for row in rows] == [1, 2]
        for row in rows:
            own, bare = row["batch, drawn, screened, with answers"], row["closed form, plain numpy"]
            assert row["batch / closed form"] == pytest.approx(own / bare)
            assert 0 <= row["largest difference"] < 1e-10
    assert len(batches.drawn(rivals.MECHANISMS[0], 3)) == 3


def test_missing_package_is_said(monkeypatch: pytest.MonkeyPatch) -> None:
    for name in ("numba", "pylinkage"):
        monkeypatch.setitem(sys.modules, name, None)
    rivals._compiled.cache_clear()
    table = solver.comparison(rivals.MECHANISMS[1], (1,), 1)
    assert "closed form, numba left out" in table.note
    assert 'pip install ".[bench]"' in table.note
    assert [row[0] for row in table.rows if row[1] is None] == ["closed form, numba", "pylinkage, an object each"]


def test_difference_is_seen() -> None:
    mechanism = rivals.MECHANISMS[0]
    family = load_family(mechanism.family)
    form = family.forms[mechanism.form]
    values = parameter_arrays(solver.drawn(family, form, 3))
    motion = solver.solved(form, values)()
    right = rivals.numpy_way(mechanism, mechanism.inputs(values))()
    assert solver.difference(right, motion) < 1e-10
    for row in range(6):
        wrong = right.copy()
        wrong[row, 1] += 0.01
        assert solver.difference(wrong, motion) > 1e-4
    assert {np.shape(column) for column in solver.repeated(values, 7).values()} == {(7,)}


def test_growth_is_told_from_sizes() -> None:
    def case(students: int, cpu: float, exam: str = "E") -> scale.Case:
        runs = [Ran(cpu + 1, cpu, 90.0, None, 3.0), Ran(cpu, cpu + 1, 100.0, None, 3.0)]
        two = [Ran(cpu / 2, cpu, 80.0, 70.0, 3.0)]
        return scale.Case(exam, False, students, runs, two, [cpu / 4, cpu / 2], 0.5)

    every = [case(10, 1.0), case(100, 4.0), case(1000, 49.0), case(10, 2.0, "F")]
    head, rows = scale.time_table(every).head, scale.time_table(every).rows
    shown = [dict(zip(head, row, strict=True)) for row in rows]
    assert [row["CPU / engine"] for row in shown] == pytest.approx([4] * 4)
    assert [row["per student / that of 100"] for row in shown] == [2.5, 1.0, pytest.approx(1.225), None]
    assert [row["each further student, ms"] for row in shown] == [None, pytest.approx(1e3 / 30), 50.0, None]
    assert [row["throughput of two"] for row in shown] == [2.0] * 4
    memory = scale.memory_table(every)
    assert memory.rows[0][3:6] == (100.0, 80.0, 70.0)


def test_sizes_of_classes() -> None:
    found = scale.cases(scale.Options(students=1000, solutions=200))
    sizes = {
        (c.exam, c.solutions): [o.students for o in found if (o.exam, o.solutions) == (c.exam, c.solutions)]
        for c in found
    }
    for exam in exams.EXAMS:
        assert sizes[exam, False] == [10, 100, 1000]
        assert sizes[exam, True] == [10, 100, 200]


def test_yardstick_is_what_it_says() -> None:
    text = yardstick.markup(2)
    assert text.count("place(top + left") == 2 * yardstick.PROBLEMS * 41
    import typst

    for figures in (True, False):
        made = typst.compile(yardstick.markup(2, figures).encode(), ignore_system_fonts=True)
        with pikepdf.open(io.BytesIO(made)) as pdf:
            assert len(pdf.pages) == 4


def test_clocks_count_own_time(monkeypatch: pytest.MonkeyPatch) -> None:
    now = [0.0]
    monkeypatch.setattr(hooks.time, "process_time", lambda: now[0])

    def spend(seconds: float) -> None:
        now[0] += seconds

    made = types.ModuleType("variantgen.made_for_hooks")
    user = types.ModuleType("variantgen.made_for_hooks_too")
    exec(
        "def inner(spend):\n    spend(1)\n"
        "def outer(spend):\n    spend(10)\n    inner(spend)\n    spend(20)\n"
        "class Whole:\n    def run(self, name, spend):\n        outer(spend)\n        spend(100)\n",
        made.__dict__,
    )
    user.outer = made.outer  # type: ignore[attr-defined]
    monkeypatch.setitem(sys.modules, made.__name__, made)
    monkeypatch.setitem(sys.modules, user.__name__, user)
    clock = hooks.StageClock("rest", 0.0)
    place = made.__name__
    hooks.around(
        [
            hooks.Hook("inner", f"{place}:inner"),
            hooks.Hook("outer", f"{place}:outer"),
            hooks.Hook("of {}", f"{place}:Whole.run", whole=True),
        ],
        clock,
    )
    spend(1000)
    user.outer(spend)
    made.Whole().run("it", spend)
    made.inner(spend)
    spend(2000)
    assert clock.finish() == {"rest": 3000, "outer": 30, "inner": 2, "of it": 131}


def test_vanished_function_is_named() -> None:
    clock = hooks.StageClock("rest", 0.0)
    wrong = [hooks.Hook("a", "variantgen.errors:no_such"), hooks.Hook("b", "variantgen.no_such:f")]
    with pytest.raises(hooks.MissingHookError, match=r"variantgen\.errors:no_such, variantgen\.no_such:f"):
        hooks.around([*wrong, hooks.Hook("c", "variantgen.errors:nearest")], clock)


def test_failing_command_is_shown() -> None:
    with pytest.raises(RuntimeError, match="No module named 'no_such'"):
        processes.run([sys.executable, "-c", "import no_such"])


def test_workers_are_seen() -> None:
    script = (
        "import subprocess, sys, time; x = bytearray(30_000_000); "
        "subprocess.run([sys.executable, '-c', 'import time; x = bytearray(150_000_000); time.sleep(0.4)'])"
    )
    ran = processes.run([sys.executable, "-c", script])
    assert ran.worker_mb is not None
    assert 35 < ran.main_mb < 100
    assert 150 < ran.worker_mb < 250
    assert ran.cpu < ran.wall + 0.5


def test_numbers_are_shown_with_three_digits() -> None:
    table = measure.Table("T", ("a", "b", "c", "d", "e"), "Note.")
    table.add("x", 12345.6, 0.012345, None, 7)
    assert table.markdown().splitlines()[-1] == "| x | 12346 | 0.0123 | - | 7 |"
    with pytest.raises(AssertionError):
        table.add("x")


def test_templates_that_are_counted_exist() -> None:
    assert {"sheets.typ", "key.typ", "solutions.typ"} <= {path.name for path in (templates_dir() / "typst").iterdir()}
