"""A build from beginning to end."""

from __future__ import annotations

import hashlib
import json
from collections.abc import Callable, Iterator, Mapping, Sequence
from contextlib import ExitStack, contextmanager
from functools import partial
from pathlib import Path
from typing import TYPE_CHECKING

from msgspec import Struct, field
from msgspec.structs import replace

from variantgen.builder.build_spec import BuildSpec, preloaded
from variantgen.builder.draw_stage import draw_all
from variantgen.builder.jobs import RenderJob
from variantgen.builder.stored import StoredSheets
from variantgen.builder.unfinished import Unfinished, unfinished
from variantgen.builder.workers import PoolWorkers, Workers, in_order_by, local_workers, run_and_keep
from variantgen.errors import InputError
from variantgen.exam.allocation import HandedOutSheet, ProblemSampler
from variantgen.exam.exam import Exam
from variantgen.exam.roster import Student
from variantgen.exam.student_order import in_order
from variantgen.exam.work.fairness import shortages, uneven_pools
from variantgen.outputs.files.folder import check_free, terminable, whole_folder, writing
from variantgen.outputs.files.records import RECORDS, write_records
from variantgen.outputs.formats import STUDENTS_PER_PART, WholeExam, format_of, known_files, read_exam
from variantgen.outputs.run import Run
from variantgen.outputs.typst.typesetter import Typesetter, typesetter

if TYPE_CHECKING:
    from concurrent.futures import Executor

Progress = Callable[[str, int, int], None]
# Jobs that a foreign executor is given at a time, unless its workers are known.
AHEAD = 256


class Built(Struct, frozen=True):
    """The result of a build: the folder, the number of students, and who had to draw again to be distinct.

    ``unexplained`` names the families of which some problems have an answer, but no worked solution; ``alike`` says of
    problems how many sheets have nearly the data of another of their group, because there was no room to keep them
    apart; ``notes`` are messages of the formats; ``kept`` counts the parts that an earlier try had finished; ``cut``
    counts the problems that were drawn again for the ceiling that the exam sets to tolerances.
    """

    folder: Path
    students: int
    redrawn: tuple[str, ...]
    unexplained: tuple[str, ...] = ()
    notes: tuple[str, ...] = ()
    alike: Mapping[str, int] = field(default_factory=dict)
    kept: int = 0
    cut: int = 0


def build(
    exam: Exam | Path,
    students: Sequence[Student],
    out: Path,
    seed: str | None = None,
    jobs: int = 1,
    force: bool = False,
    progress: Progress = lambda stage, done, total: None,
    executor: Executor | PoolWorkers | None = None,
    resume: bool = False,
    standing: Sequence[HandedOutSheet] = (),
) -> Built:
    """Build an exam (a file, or one that has been read) into the folder ``out``, which is complete or not there.

    Writes ``key.csv``, ``manifest.json`` and what the formats of the exam make (see
    :mod:`variantgen.outputs.formats`). The work is done by ``jobs`` processes or by an ``executor`` (of processes, of
    threads, that of Dask, of mpi4py, ...), whose workers need this version of the package and nothing else; the bytes
    are the same. Sheets stand by group and name, unless the exam wants the order of ``students``. With ``resume`` it
    goes on from the parts that an interrupted build has finished. The sheets
    are kept apart from those ``standing``, which other students of the same exam have already. Raises InputError for
    wrong input, ToolMissingError where a format needs something that is not installed.
    """
    exam = read_exam(exam) if isinstance(exam, Path) else exam
    exam = exam if seed is None else replace(exam, seed=seed)
    students = in_order(students, exam.sort, exam.spoken.words("language")["alphabet"])
    known = partial(known_files, exam.formats)
    check_free(out, force, known)
    for name in exam.formats:
        format_of(name).check(exam, students)
    with terminable(), typesetter() as engine:
        spec = BuildSpec.of(exam)
        with (
            writing(out),
            unfinished(out, _plan(exam, spec, students, standing), resume, (RECORDS, *exam.formats)) as parts,
        ):
            with preloaded(spec, exam, engine), _workers(executor, jobs) as workers:
                try:
                    draw_all(exam, students, spec, parts, workers, progress, standing)
                except InputError as error:
                    raise error.located(str(exam.path)) from None
                sheets = StoredSheets(exam, students, parts, [sheet.code for sheet in standing])
                kept = _make_all(exam, sheets, spec, parts, workers, progress)
                notes: list[str] = []
                with whole_folder(out, force, known, notes) as folder:
                    run = partial(in_order_by, workers, spec)
                    built = _put_together(exam, sheets, spec, parts, folder, engine, run)
            return replace(built, folder=out, kept=kept, notes=(*built.notes, *notes))


@contextmanager
def _workers(executor: Executor | PoolWorkers | None, jobs: int) -> Iterator[Workers]:
    """Who does the jobs."""
    with ExitStack() as stack:
        if executor is None:
            yield stack.enter_context(local_workers(jobs))
        else:
            yield executor if isinstance(executor, PoolWorkers) else PoolWorkers(executor, AHEAD)


def _plan(
    exam: Exam, spec: BuildSpec, students: Sequence[Student], standing: Sequence[HandedOutSheet]
) -> dict[str, str]:
    """What must be the same for a build to go on: by the words that tell what is different."""
    roster = hashlib.sha256()
    for student in students:
        roster.update(repr((student.id, student.name, student.group)).encode())
    for sheet in standing:
        roster.update(repr((sheet.student.id, sheet.code)).encode())
    return {
        "version of the program, its templates or families": _hash(sorted(spec.made_with.items())),
        "seed": exam.seed,
        "roster": roster.hexdigest(),
        "exam file or choice of outputs": spec.name,
    }


def _hash(found: object) -> str:
    return hashlib.sha256(json.dumps(found).encode()).hexdigest()


def _make_jobs(exam: Exam, count: int) -> Iterator[tuple[range, tuple[str, int] | None]]:
    """All jobs that make something, in the order in which their pieces are put together: parts, and which overview."""
    parts = -(-count // STUDENTS_PER_PART)
    for part in range(parts):
        yield range(part, part + 1), None
    for name in exam.formats:
        for place, (size, _) in enumerate(format_of(name).SUMMARIES):
            for start in range(0, parts, size):
                yield range(start, min(start + size, parts)), (name, place)


def _make_all(
    exam: Exam, sheets: StoredSheets, spec: BuildSpec, parts: Unfinished, workers: Workers, progress: Progress
) -> int:
    """Make all pieces that are not there; how many jobs were done before."""
    count = len(sheets)
    listed = list(enumerate(_make_jobs(exam, count)))
    missing = [number for number, _ in listed if not parts.kept.has_made(number)]
    last = -(-count // STUDENTS_PER_PART) - 1
    sizes = {i: min(STUDENTS_PER_PART, count - i * STUDENTS_PER_PART) for i in range(last + 1)}  # overviews have none
    done = count - sum(sizes.get(number, 0) for number in missing)
    progress("typesetting", done, count)
    there = workers.share_disk

    def todo() -> Iterator[tuple[int, RenderJob]]:
        for number, (chosen, summary) in (listed[number] for number in missing):
            packed = tuple(sheets.packed(part, where_kept=there) for part in chosen)
            yield number, RenderJob(packed, sheets.beginning(chosen), chosen.start == 0, summary)

    for number, _ in run_and_keep(workers, spec, parts.kept, todo()):
        done += sizes.get(number, 0)
        progress("typesetting", done, count)
    return len(listed) - len(missing)


def _put_together(
    exam: Exam, sheets: StoredSheets, spec: BuildSpec, parts: Unfinished, folder: Path, engine: Typesetter, run: Run
) -> Built:
    """The output folder from all pieces."""
    pieces: dict[str, dict[str, list[Path]]] = {name: {} for name in (RECORDS, *exam.formats)}
    unexplained: set[str] = set()
    for number, _ in enumerate(_make_jobs(exam, len(sheets))):
        made = parts.kept.made(number)
        for name, target, path in made.pieces:
            pieces[name].setdefault(target, []).append(path)
        unexplained.update(made.unexplained)
    notes: list[str] = []
    pages: dict[str, dict[int, int]] = {}
    for name in exam.formats:
        format_of(name).finish(WholeExam(exam, sheets, folder, engine, pieces[name], notes, pages, run))
    redrawn, alike, cut = parts.drawn_marks()
    bands = ProblemSampler(exam).bands()
    recorded = [{"problem": n, "family": family, "form": form, **b.record()} for (n, family, form), b in bands.items()]
    notes += [*shortages(bands), *uneven_pools(bands)]
    if exam.scan and "pdf" not in exam.formats:
        notes.append("[answers] scan = true prints pages for answers in sheets.pdf alone: add pdf to the formats")
    write_records(folder, exam, spec.made_with, redrawn, pages, pieces[RECORDS], recorded)
    return Built(folder, len(sheets), redrawn, tuple(sorted(unexplained)), tuple(notes), alike, cut=cut)
