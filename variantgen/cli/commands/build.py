"""``variantgen build``: the main job."""

from __future__ import annotations

import argparse
import time
from collections.abc import Iterator, Sequence
from contextlib import ExitStack, contextmanager
from pathlib import Path
from typing import TYPE_CHECKING

from msgspec.structs import replace

from variantgen.cli.late import late
from variantgen.cli.messages import counted, some_of, tell
from variantgen.cli.options import add_families, at_least_one, format_names, some_text
from variantgen.cli.progress import Progress
from variantgen.errors import InputError, Problem

if TYPE_CHECKING:
    from variantgen.builder import Built
    from variantgen.exam.roster import Student

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
        "--roster",
        type=Path,
        metavar="FILE",
        help="class list: CSV or XLSX with the columns name and, if there are any, id and group",
    )
    students.add_argument("--variants", type=int, metavar="N", help="no class list: N numbered variants")
    parser.add_argument(
        "--id-column",
        default="",
        metavar="NAME",
        help="the column with the ids, by its header (default: found by itself)",
    )
    parser.add_argument("--out", type=Path, required=True, metavar="DIR", help="folder to be made")
    parser.add_argument("--seed", type=some_text, help="seed of the draw (default: the one in the exam file, or 0)")
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
        "--only-new",
        action="store_true",
        help="only for students who are not in DIR yet, into a folder of their own: DIR-new, DIR-new-2, ...",
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
    """Build the folder. Raises InputError for options, files or names that cannot be used."""
    from variantgen.builder import build, scheduled_workers
    from variantgen.exam.samples import exam_path
    from variantgen.exam.sections.named_families import composing
    from variantgen.exam.sections.solutions import NONE as NO_SOLUTIONS
    from variantgen.families.reading.folders import family_folders
    from variantgen.outputs.formats import chosen, read_exam

    at_least_one("--jobs", arguments.jobs)
    if arguments.variants is not None and not 1 <= arguments.variants <= 1_000_000:
        raise InputError(Problem("expected 1 to 1000000", key="--variants", value=str(arguments.variants)))
    students = _students(arguments)
    path = exam_path(arguments.exam)
    folders = family_folders(arguments.families, beside=path)
    composing.set(tell)
    exam = read_exam(path, folders)
    if arguments.no_solutions:
        exam = replace(exam, solutions=replace(exam.solutions, depth=NO_SOLUTIONS))
    if arguments.format:
        exam = replace(exam, formats=chosen([w for text in arguments.format for w in text.split(",")], "--format"))
    if arguments.seed is not None:
        exam = replace(exam, seed=arguments.seed)
    out, students, standing = late(arguments, exam, students, folders)
    if arguments.only_new and not students:
        tell("nobody is new: nothing was made")
        return 0
    start = time.perf_counter()
    with ExitStack() as stack:
        stack.enter_context(_what_is_kept(out))
        executor = stack.enter_context(scheduled_workers(arguments.scheduler)) if arguments.scheduler else None
        made = build(
            exam,
            students,
            out,
            jobs=arguments.jobs,
            force=arguments.force,
            progress=stack.enter_context(Progress()).show,
            executor=executor,
            resume=arguments.resume,
            standing=standing,
        )
    _report(made, time.perf_counter() - start)
    return 0


def _students(arguments: argparse.Namespace) -> Sequence[Student]:
    """The class; reports how the list was read."""
    from variantgen.exam.roster import numbered, read_class

    if not arguments.roster:
        if arguments.id_column:
            raise InputError(
                Problem("there is no roster", key="--id-column", remedy="leave it out, or give --roster FILE")
            )
        return numbered(arguments.variants)
    found = read_class(arguments.roster, arguments.id_column)
    for note in found.notes:
        tell(f"{arguments.roster.name}: {note}")
    return found.students


@contextmanager
def _what_is_kept(out: Path) -> Iterator[None]:
    """Say, if the block ends with an error, that there are parts to go on from."""
    from variantgen.builder import unfinished_folder

    try:
        yield
    except BaseException:
        folder = unfinished_folder(out)
        if (folder / "plan.json").exists():
            tell(f"what is done is kept in {folder}: the same command with --resume goes on")
        raise


def _report(made: Built, seconds: float) -> None:
    """What an instructor should know of a build."""
    from variantgen.exam.student_order import natural

    if made.redrawn:
        redrawn = some_of(natural(made.redrawn), listed=f"listed as redrawn in {made.folder / 'manifest.json'}")
        tell(f"drawn again to keep variants distinct: {redrawn}")
    if made.cut:
        tell(f"drawn again for tolerance.ceiling: {counted(made.cut, 'problem')}")
    if made.unexplained:
        tell(f"answers only, no worked solution: {', '.join(made.unexplained)}")
    for note in made.notes:
        tell(note)
    for where, count in made.alike.items():
        have = "sheet has" if count == 1 else "sheets have"
        tell(f"{where}: {count} {have} nearly the data of another in their group (too little room)")
    tell(f"{counted(made.students, 'sheet')} in {made.folder} ({seconds:.1f} s)")
