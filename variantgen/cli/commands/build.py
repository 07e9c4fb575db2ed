"""``variantgen build``: the main job."""

from __future__ import annotations

import argparse
import sys
import time
from dataclasses import replace
from pathlib import Path

from variantgen.cli.options import add_families, at_least_one, format_names
from variantgen.errors import InputError, Problem

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
    parser.add_argument("--jobs", type=int, default=1, metavar="N", help="processes (default: 1)")
    parser.add_argument("--force", action="store_true", help="replace an earlier output of this program whole")
    add_families(parser)


def run(arguments: argparse.Namespace) -> int:
    """Build the folder."""
    from variantgen.builder import build
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
    made = build(exam, students, arguments.out, arguments.seed, arguments.jobs, arguments.force, _Progress().show)
    seconds = time.perf_counter() - start
    if made.redrawn:
        print(f"drawn again to keep variants distinct: {', '.join(made.redrawn)}", file=sys.stderr)
    if made.unexplained:
        print(f"answers only, no worked solution: {', '.join(made.unexplained)}", file=sys.stderr)
    for note in made.notes:
        print(note, file=sys.stderr)
    print(f"{made.students} sheets in {made.folder} ({seconds:.1f} s)", file=sys.stderr)
    return 0


class _Progress:
    """Progress on stderr for long work: a living line on a terminal, elsewhere a line every five seconds."""

    def __init__(self) -> None:
        self._start = time.perf_counter()
        self._last = self._start
        self._live = sys.stderr.isatty()

    def show(self, stage: str, done: int, total: int) -> None:
        """Show how far a stage is, at most five times a second."""
        now = time.perf_counter()
        if now - self._last < (0.2 if self._live else 5.0) and not (
            self._live and done == total and now - self._start > 1
        ):
            return
        self._last = now
        rate = done / (now - self._start)
        rest = f", {(total - done) / rate:.0f} s left" if rate and done < total else ""
        start, end = ("\r", "\n" if done == total else "") if self._live else ("", "\n")
        print(f"{start}{stage}: {done} of {total}{rest}   ", end=end, file=sys.stderr, flush=True)
