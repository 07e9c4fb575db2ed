"""What all benchmarks share: clocks, the machine in words, tables and the files that they are written to."""

from __future__ import annotations

import json
import os
import platform
import time
from collections import Counter
from collections.abc import Callable, Iterator, Mapping, Sequence
from contextlib import contextmanager
from dataclasses import dataclass, field
from importlib.metadata import PackageNotFoundError, version
from pathlib import Path
from typing import Any

from variantgen.version import VERSION

PACKAGES = ("numpy", "scipy", "typst", "jinja2", "pikepdf", "segno", "numba", "pylinkage")

Cell = str | int | float | None


class Clock(Counter[str]):
    """CPU milliseconds of this process by stage."""

    @contextmanager
    def measuring(self, stage: str) -> Iterator[None]:
        """Add what happens inside the block to a stage."""
        start = time.process_time()
        yield
        self[stage] += 1e3 * (time.process_time() - start)  # type: ignore[assignment]


def fastest(ways: Mapping[str, Callable[[], object]], rounds: int, least: float = 0.005) -> dict[str, float]:
    """CPU seconds of one call of each way: the least of interleaved rounds, each of calls that fill ``least`` seconds.

    Every way is called once beforehand, so that what is prepared at the first call is not counted.
    """
    counts = {}
    for name, call in ways.items():
        call()
        counts[name] = max(1, round(least / max(_seconds(call, 1), 1e-7)))
    best = dict.fromkeys(ways, float("inf"))
    for _ in range(rounds):
        for name, call in ways.items():
            best[name] = min(best[name], _seconds(call, counts[name]) / counts[name])
    return best


def _seconds(call: Callable[[], object], count: int) -> float:
    start = time.process_time()
    for _ in range(count):
        call()
    return time.process_time() - start


@dataclass
class Table:
    """Numbers with a title, a line for each row, and a note on what they mean."""

    title: str
    head: Sequence[str]
    note: str = ""
    rows: list[Sequence[Cell]] = field(default_factory=list)

    def add(self, *cells: Cell) -> None:
        """Add a row."""
        assert len(cells) == len(self.head), (self.title, cells)
        self.rows.append(cells)

    def markdown(self) -> str:
        """The table in Markdown with its title and note, numbers with three digits."""
        lines = [f"### {self.title}", *(["", self.note] if self.note else []), "", _line(self.head)]
        lines.append("|" + "---|" * len(self.head))
        return "\n".join([*lines, *(_line([_shown(cell) for cell in row]) for row in self.rows)]) + "\n"

    def record(self) -> dict[str, Any]:
        """The table with all digits, for JSON."""
        rows = [dict(zip(self.head, row, strict=True)) for row in self.rows]
        return {"title": self.title, "note": self.note, "rows": rows}


def _line(cells: Sequence[str]) -> str:
    return f"| {' | '.join(cells)} |"


def _shown(cell: Cell) -> str:
    if cell is None:
        return "-"
    if isinstance(cell, float):
        return f"{cell:.0f}" if abs(cell) >= 100 else f"{cell:.3g}"
    return str(cell)


def machine() -> dict[str, str]:
    """The machine and the versions of everything that is measured."""
    known = {
        "processor": f"{_processor()} ({os.cpu_count()})",
        "system": f"{platform.system()} {platform.machine()}",
        "load before": f"{os.getloadavg()[0]:.2f}",
        "Python": platform.python_version(),
        "variantgen": VERSION,
    }
    for name in PACKAGES:
        try:
            known[name] = version(name)
        except PackageNotFoundError:
            known[name] = "none"
    return known


def _processor() -> str:
    info = Path("/proc/cpuinfo")
    lines = info.read_text("utf-8").splitlines() if info.exists() else []
    return next((line.split(":", 1)[1].strip() for line in lines if line.startswith("model name")), platform.machine())


def machine_line() -> str:
    """Python and machine for the notes of documents."""
    return f"Python {platform.python_version()}, {platform.machine()}"


def write_beside(script: str, lines: Sequence[str]) -> None:
    """Write a document of one script to the file of its name."""
    Path(script).with_suffix(".md").write_text("\n".join(lines) + "\n", "utf-8")


@dataclass(frozen=True)
class Report:
    """The tables of one part of the benchmarks and the machine on which they were measured."""

    part: str
    title: str
    command: str
    tables: Sequence[Table]
    machine: Mapping[str, str]

    def write(self, folder: Path) -> None:
        """Write the part as JSON."""
        folder.mkdir(parents=True, exist_ok=True)
        content = {
            "part": self.part,
            "title": self.title,
            "command": self.command,
            "machine": dict(self.machine),
            "tables": [table.record() for table in self.tables],
        }
        (folder / f"{self.part}.json").write_text(json.dumps(content, indent=1) + "\n", "utf-8")


def document(folder: Path, parts: Sequence[str]) -> str:
    """All parts that have been measured in a folder as one Markdown text."""
    texts = ["# Scale and speed, measured\n"]
    for part in parts:
        path = folder / f"{part}.json"
        if path.exists():
            texts.append(_section(json.loads(path.read_text("utf-8"))))
    return "\n".join(texts)


def _section(known: Mapping[str, Any]) -> str:
    where = ", ".join(f"{name} {value}" for name, value in known["machine"].items())
    tables = []
    for table in known["tables"]:
        rows: list[Sequence[Cell]] = [tuple(row.values()) for row in table["rows"]]
        tables.append(Table(table["title"], list(table["rows"][0]) if rows else [], table["note"], rows).markdown())
    return "\n".join([f"## {known['title']}\n", f"`{known['command']}`; {where}.\n", *tables])
