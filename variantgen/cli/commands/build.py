"""``variantgen build``: the main job."""

from __future__ import annotations

import argparse
import sys
import time
from collections.abc import Iterator
from contextlib import ExitStack, contextmanager
from dataclasses import replace
from pathlib import Path
from typing import TYPE_CHECKING, Any

from variantgen.cli.options import add_families, at_least_one, format_names
from variantgen.errors import InputError, Problem

if TYPE_CHECKING:
    from variantgen.builder import Built

_SHORT = 1.0  # seconds
HELP = "build an exam"
DESCRIPTION = (
    "Build an exam in a new folder: key.csv, manifest.json and the outputs that are wished, usually sheets.pdf,\n"
    "key.pdf and solutions.pdf."
)


def add_arguments(parser: argparse.ArgumentParser) -> None:
    """Options of the command."""
    parser.add_argument("exam", metavar="EXAM.toml", type=Path, help="exam file, or the name of a sample exam")
    students = parser.add_mutually_exclusive_group(required=True)
    students.add_argument(
        "--roster", type=Path, metavar="FILE", help="class list: CSV or XLSX with the columns id, name, group"
    )
    students.add_argument("--variants", type=int, metavar="N", help="no class list: N numbered variants")
    parser.add_argument("--out", type=Path, required=True, metavar="DIR", help="folder to be made")
    parser.add_argument("--seed", help="seed of the draw (default: the one in the exam file, or 0)")
    parser.add_argument("--no-solutions", action="store_true", help="leave the worked solutions out")
    known = ", ".join(format_names())
    parser.add_argument(
        "--format",
        action="append",
        metavar="NAME",
        help=f"output, or several by commas: {known} (default: formats of EXAM, or pdf)",
    )
    workers = parser.add_mutually_exclusive_group()
    workers.add_argument("--jobs", type=int, default=1, metavar="N", help="processes (default: 1)")
    workers.add_argument(
        "--scheduler", metavar="ADDRESS", help="use the workers of a Dask scheduler, e.g. tcp://10.0.0.1:8786"
    )
    parser.add_argument(
        "--resume", action="store_true", help="go on from the parts that an interrupted build has finished"
    )
    parser.add_argument(
        "--force",
        action="store_true",
        help="replace an earlier output of this program; files that were edited since are kept in its folder edited/",
    )
    add_families(parser)


def run(arguments: argparse.Namespace) -> int:
    """Build the folder."""
    from variantgen.builder import build, scheduled_workers
    from variantgen.exam.roster import numbered, read_roster
    from variantgen.exam.samples import exam_path
    from variantgen.exam.solutions import NONE as NO_SOLUTIONS
    from variantgen.families.folders import family_folders
    from variantgen.outputs.formats import chosen, read_exam

    at_least_one("--jobs", arguments.jobs)
    if arguments.variants is not None and not 1 <= arguments.variants <= 1_000_000:
        raise InputError(Problem("expected 1 to 1000000", key="--variants", value=str(arguments.variants)))
    students = read_roster(arguments.roster) if arguments.roster else numbered(arguments.variants)
    path = exam_path(arguments.exam)
    exam = read_exam(path, family_folders(arguments.families, beside=path))
    if arguments.no_solutions:
        exam = replace(exam, solutions=replace(exam.solutions, depth=NO_SOLUTIONS))
    if arguments.format:
        exam = replace(exam, formats=chosen([w for text in arguments.format for w in text.split(",")], "--format"))
    start = time.perf_counter()
    with ExitStack() as stack:
        stack.enter_context(_what_is_kept(arguments.out))
        executor = stack.enter_context(scheduled_workers(arguments.scheduler)) if arguments.scheduler else None
        made = build(
            exam,
            students,
            arguments.out,
            arguments.seed,
            arguments.jobs,
            arguments.force,
            stack.enter_context(_Progress()).show,
            executor,
            arguments.resume,
        )
    _report(made, time.perf_counter() - start)
    return 0


@contextmanager
def _what_is_kept(out: Path) -> Iterator[None]:
    """Say, if the block ends with an error, that there are parts to go on from."""
    from variantgen.builder import unfinished_folder

    try:
        yield
    except BaseException:
        folder = unfinished_folder(out)
        if (folder / "plan.json").exists():
            print(f"what is done is kept in {folder}: the same command with --resume goes on", file=sys.stderr)
        raise


def _report(made: Built, seconds: float) -> None:
    """What an instructor should know of a build."""
    if made.redrawn:
        print(f"drawn again to keep variants distinct: {', '.join(made.redrawn)}", file=sys.stderr)
    if made.unexplained:
        print(f"answers only, no worked solution: {', '.join(made.unexplained)}", file=sys.stderr)
    for note in made.notes:
        print(note, file=sys.stderr)
    for where, count in made.alike.items():
        print(
            f"{where}: {count} sheets have nearly the data of another in their group (too little room)", file=sys.stderr
        )
    print(f"{made.students} sheets in {made.folder} ({seconds:.1f} s)", file=sys.stderr)


class _Progress:
    """Progress on stderr for long work: a bar on a terminal, elsewhere a line every five seconds."""

    def __init__(self) -> None:
        self._stage = ""
        self._bar: Any = None
        self._start = time.perf_counter()

    def __enter__(self) -> _Progress:
        return self

    def __exit__(self, *_: object) -> None:
        self._end()

    def show(self, stage: str, done: int, total: int) -> None:
        """Show how far a stage is."""
        over = stage != self._stage and done == total
        if over or time.perf_counter() - self._start < _SHORT:
            return  # short work needs no bar, nor the time to load its library
        if stage != self._stage:
            self._end()
            self._stage, self._bar = stage, _bar(stage, done, total)
        self._bar.update(done - self._bar.n)

    def _end(self) -> None:
        if self._bar is not None:
            self._bar.close()


def _bar(stage: str, done: int, total: int) -> Any:
    from tqdm import tqdm

    live = sys.stderr.isatty()
    return tqdm(
        total=total,
        initial=done,
        desc=stage,
        unit=" students",
        file=sys.stderr if live else _Lines(),
        mininterval=0.2 if live else 5.0,
        bar_format="{desc}: {n_fmt} of {total_fmt} |{bar}| {rate_fmt}, {remaining} left"
        if live
        else "{desc}: {n_fmt} of {total_fmt}, {rate_fmt}, {remaining} left",
        leave=False,
    )


class _Lines:
    """Standard error as a file of whole lines: no line is written over another."""

    def write(self, text: str) -> None:
        """Write a state of the bar as a line."""
        if line := text.strip("\r\n "):
            sys.stderr.write(f"{line}\n")

    def flush(self) -> None:
        """Nothing is kept back."""
        sys.stderr.flush()
