"""Whole builds in fresh processes by size of the class, beside the typesetting engine alone on the very same input."""

from __future__ import annotations

import tempfile
from collections.abc import Sequence
from dataclasses import dataclass, field
from pathlib import Path

from benchmarks import exams, processes, yardstick
from benchmarks.floor import Floor
from benchmarks.measure import Table
from benchmarks.options import Options
from benchmarks.processes import Ran

TITLE = "Whole builds by size of the class"
SHEETS, SOLUTIONS = "sheets and key", "with full solutions"
_SIZES = (10, 100, 1000, 10_000)
_BASE = 100  # the class that others are compared with
_LONG = 1000  # classes larger than this are built in one round only


@dataclass
class Case:
    """One exam for one class: what every round measured."""

    exam: str
    solutions: bool
    students: int
    one: list[Ran] = field(default_factory=list)
    two: list[Ran] = field(default_factory=list)
    floor: list[float] = field(default_factory=list)
    size: float = 0.0
    _engine: Floor | None = None

    @property
    def made(self) -> str:
        """What is built, in words."""
        return SOLUTIONS if self.solutions else SHEETS

    @property
    def cpu(self) -> float:
        """CPU seconds of a build by one process."""
        return processes.least(self.one).cpu

    @property
    def cpu_of_floor(self) -> float:
        """CPU seconds of the engine alone."""
        return min(self.floor)

    def measure(self, last: bool) -> None:
        """Build once with one process and once with two, and let the engine alone do its part in between."""
        with tempfile.TemporaryDirectory(prefix="scale-") as name:
            folder = Path(name)
            exam, out = exams.write(exams.EXAMS[self.exam], folder), folder / "out"

            def build(jobs: int) -> list[str]:
                return exams.build_arguments(exam, self.students, self.solutions, out, jobs)

            self._engine = self._engine or Floor(build(1))
            self.one.append(processes.run([*processes.PROGRAM, *build(1)]))
            self.size = processes.size(out)
            self.floor.append(self._engine.seconds())
            self.two.append(processes.run([*processes.PROGRAM, *build(2)]))
        if last:
            self._engine.close()


def cases(options: Options) -> list[Case]:
    """What is built, small classes first."""
    if options.quick:
        return [Case(next(iter(exams.EXAMS)), solutions, options.students) for solutions in (False, True)]
    found = []
    for solutions, largest in ((False, options.students), (True, min(options.students, options.solutions))):
        sizes = sorted({*(size for size in _SIZES if size < largest), largest})
        found += [Case(exam, solutions, size) for exam in exams.EXAMS for size in sizes]
    return found


def run(options: Options) -> list[Table]:
    """Measure all cases in interleaved rounds."""
    every, marks = cases(options), []
    for turn in range(options.rounds):
        marks.append(yardstick.measure(options.students if options.quick else yardstick.STUDENTS))
        for case in every:
            if turn and case.students > _LONG:
                continue
            last = turn == options.rounds - 1 or case.students > _LONG
            case.measure(last)
            print(f"round {turn + 1}: {case.exam}, {case.made}, {case.students}: {case.one[-1].cpu:.2f} s", flush=True)
    mark = yardstick.least(marks)
    return [time_table(every), memory_table(every), yardstick.table(mark), yardstick.comparison(mark, _compared(every))]


def time_table(every: Sequence[Case]) -> Table:
    """Time by case, per student, over the engine and over the class of a hundred."""
    table = Table(
        "Time",
        (
            "exam", "made", "students", "wall, s", "CPU, s", "CPU per student, ms", "engine alone, ms", "CPU / engine",
            "per student / that of 100", "each further student, ms", "wall of two processes, s", "throughput of two",
        ),
        "`variantgen build` in a fresh process, least of the rounds; the engine alone is Typst on the very same input "
        "(sheets, key and solutions, the same parts and options), CPU without imports. Each process has one thread. "
        "Each further student: CPU beyond the next smaller class.",
    )  # fmt: skip
    for number, case in enumerate(every):
        best, two = processes.least(case.one), processes.least(case.two)
        own = [c for c in every if (c.exam, c.solutions) == (case.exam, case.solutions)]
        base = next((c.cpu / c.students for c in own if c.students == _BASE), None)
        before = every[number - 1] if number and every[number - 1] in own else None
        table.add(
            case.exam,
            case.made,
            case.students,
            best.wall,
            best.cpu,
            1e3 * best.cpu / case.students,
            1e3 * case.cpu_of_floor / case.students,
            best.cpu / case.cpu_of_floor,
            best.cpu / case.students / base if base else None,
            1e3 * (best.cpu - before.cpu) / (case.students - before.students) if before else None,
            two.wall,
            best.wall / two.wall,
        )
    return table


def memory_table(every: Sequence[Case]) -> Table:
    """Memory and bytes by case."""
    table = Table(
        "Memory and bytes",
        (
            "exam", "made", "students", "peak of one process, MB", "peak of the main process of two, MB",
            "peak of the larger worker, MB", "output, MB", "output per student, kB", "written, MB",
        ),
        "Written: all that the build with one process hands to the system, temporary files included.",
    )  # fmt: skip
    for case in every:
        one, two = processes.least(case.one), processes.least(case.two)
        table.add(
            case.exam,
            case.made,
            case.students,
            one.main_mb,
            two.main_mb,
            two.worker_mb,
            case.size,
            1e3 * case.size / case.students,
            one.written_mb,
        )
    return table


def _compared(every: Sequence[Case]) -> list[tuple[int, float]]:
    """CPU seconds per student of the exam that R/exams was measured with, by size of the class."""
    return [(c.students, c.cpu / c.students) for c in every if c.exam == next(iter(exams.EXAMS)) and not c.solutions]
