"""The main job: exam file and roster to a folder with sheets, key, solutions and manifest."""

from __future__ import annotations

import gc
import multiprocessing
import multiprocessing.connection
import os
import shutil
import threading
from collections.abc import Callable, Iterable, Iterator, Sequence
from concurrent.futures import ProcessPoolExecutor
from contextlib import contextmanager
from dataclasses import dataclass
from pathlib import Path

from variantgen.errors import InputError
from variantgen.exam.assembly import assemble
from variantgen.exam.blueprint import Exam
from variantgen.exam.content import Content
from variantgen.exam.roster import Student
from variantgen.exam.sheets import Sheet
from variantgen.outputs.folder import check_free, file_hashes, whole_folder
from variantgen.outputs.formats import STUDENTS_PER_PART, Part, Piece, Whole, formats, known_files, read_exam
from variantgen.outputs.records import key_csv, manifest
from variantgen.outputs.typesetter import Typesetter, typesetter
from variantgen.variants.attempts import VerificationError

Progress = Callable[[str, int, int], None]


@dataclass(frozen=True)
class Built:
    """What a build made: the folder, how many students, and who had to draw again to be distinct.

    ``unexplained`` names the families of which some problems have an answer, but no worked solution; ``notes`` are
    messages of the formats.
    """

    folder: Path
    students: int
    redrawn: tuple[str, ...]
    unexplained: tuple[str, ...] = ()
    notes: tuple[str, ...] = ()


@dataclass(frozen=True)
class _Made:
    """The pieces of a part by format, and the families of problems in it that have no worked solution."""

    pieces: tuple[tuple[str, Piece], ...]
    unexplained: tuple[str, ...] = ()


@dataclass(frozen=True)
class _Job:
    """What is made of a few students in one go: their content in every format, or one overview of one format."""

    number: int
    exam: Exam
    seed: str
    sheets: tuple[Sheet, ...]
    first: bool
    summary: tuple[str, int] | None = None

    def make(self, folder: Path, engine: Typesetter) -> _Made:
        """Make the pieces."""
        content = Content(self.exam, self.sheets)
        pieces: list[tuple[str, Piece]] = []
        with _without_collector():
            for name, make in self._makers():
                own = folder / f"{self.number:07}-{name}"
                own.mkdir()
                pieces += [(name, piece) for piece in make(Part(content, self.seed, self.first, own, engine))]
        return _Made(tuple(pieces), () if self.summary else content.unexplained)

    def _makers(self) -> Iterator[tuple[str, Callable[[Part], Iterable[Piece]]]]:
        known = formats()
        if self.summary:
            name, place = self.summary
            yield name, known[name].SUMMARIES[place][1]
        else:
            yield from ((name, known[name].make) for name in self.exam.formats)


@contextmanager
def _without_collector() -> Iterator[None]:
    """Nothing is searched for cycles of references inside the block: in the many small objects of a part the search
    would take a tenth of the time, and what it could free until the end of the part is little.
    """
    was_enabled = gc.isenabled()
    gc.disable()
    try:
        yield
    finally:
        if was_enabled:
            gc.enable()


def build(
    exam: Exam | Path,
    students: Sequence[Student],
    out: Path,
    seed: str | None = None,
    jobs: int = 1,
    force: bool = False,
    progress: Progress = lambda stage, done, total: None,
) -> Built:
    """Build an exam (a file, or one that has been read) into the folder ``out``, which is complete or not there.

    Writes ``key.csv``, ``manifest.json`` and what the formats of the exam make (see
    :mod:`variantgen.outputs.formats`). The same input gives the same bytes, whatever ``jobs`` is. Raises InputError for
    wrong input, ToolMissingError where a format needs something that is not installed.
    """
    exam = read_exam(exam) if isinstance(exam, Path) else exam
    known = known_files()
    check_free(out, force, known)
    for name in exam.formats:
        formats()[name].check(exam, students)
    seed = exam.seed if seed is None else seed
    progress("drawing variants", 0, len(students))
    try:
        assembly = assemble(exam, students, seed)
    except InputError as error:
        raise error.located(str(exam.path)) from None
    with whole_folder(out, force, known) as folder, typesetter() as engine:
        parts_folder = folder / ".parts"
        parts_folder.mkdir()
        pieces: dict[str, dict[str, list[Path]]] = {name: {} for name in exam.formats}
        done = 0
        unexplained: set[str] = set()
        with _naming(seed), _makers(jobs, engine) as run:
            for job, made in run(_jobs(exam, seed, assembly.sheets), parts_folder):
                for name, piece in made.pieces:
                    pieces[name].setdefault(piece.target, []).append(piece.path)
                unexplained.update(made.unexplained)
                done += 0 if job.summary else len(job.sheets)
                progress("typesetting", done, len(students))
        notes: list[str] = []
        for name, own in pieces.items():
            formats()[name].finish(Whole(exam, assembly.sheets, seed, folder, engine, own, notes))
        shutil.rmtree(parts_folder)
        _write(folder / "key.csv", "\ufeff" + key_csv(assembly.sheets))
        _write(folder / "manifest.json", manifest(exam, assembly.sheets, seed, assembly.redrawn, file_hashes(folder)))
    return Built(out, len(students), assembly.redrawn, tuple(sorted(unexplained)), tuple(notes))


@contextmanager
def _naming(seed: str) -> Iterator[None]:
    """Name the seed where a solution disagrees with the solver."""
    try:
        yield
    except VerificationError as error:
        raise VerificationError(f"{error} (seed {seed})") from error


def _jobs(exam: Exam, seed: str, sheets: Sequence[Sheet]) -> list[_Job]:
    """All jobs in the order in which their pieces are joined."""
    jobs: list[_Job] = []

    def add(size: int, summary: tuple[str, int] | None) -> None:
        for i in range(0, len(sheets), size):
            jobs.append(_Job(len(jobs), exam, seed, tuple(sheets[i : i + size]), i == 0, summary))

    add(STUDENTS_PER_PART, None)
    for name in exam.formats:
        for place, (size, _) in enumerate(formats()[name].SUMMARIES):
            add(size, (name, place))
    return jobs


Runner = Callable[[Sequence[_Job], Path], Iterator[tuple[_Job, _Made]]]


@contextmanager
def _makers(processes: int, engine: Typesetter) -> Iterator[Runner]:
    """A way to do jobs, in this process or in several; results come in the order of the jobs."""
    if processes <= 1:
        yield lambda jobs, folder: ((job, job.make(folder, engine)) for job in jobs)
        return
    others = set(multiprocessing.active_children())
    with ProcessPoolExecutor(processes, initializer=_leave_with_parent) as pool:

        def run(jobs: Sequence[_Job], folder: Path) -> Iterator[tuple[_Job, _Made]]:
            made = pool.map(_make, jobs, [folder] * len(jobs), [engine] * len(jobs))
            return zip(jobs, made, strict=True)

        try:
            yield run
        except BaseException:
            # The folder is going to be removed: nobody may still be writing to it.
            for worker in set(multiprocessing.active_children()) - others:
                worker.kill()
            pool.shutdown(cancel_futures=True)
            raise


def _leave_with_parent() -> None:
    """Let a worker end when the program is killed, so that nothing is left running."""
    parent = multiprocessing.parent_process()
    if parent is not None:
        threading.Thread(
            target=lambda: (multiprocessing.connection.wait([parent.sentinel]), os._exit(1)), daemon=True
        ).start()


def _make(job: _Job, folder: Path, engine: Typesetter) -> _Made:
    return job.make(folder, engine)


def _write(path: Path, text: str) -> None:
    with path.open("w", encoding="utf-8", newline="") as file:
        file.write(text)
        file.flush()
        os.fsync(file.fileno())
