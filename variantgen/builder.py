"""The main job: exam file and roster to a folder with sheets, key, solutions and manifest."""

from __future__ import annotations

import gc
import multiprocessing
import multiprocessing.connection
import os
import shutil
import threading
from collections import Counter
from collections.abc import Callable, Iterator, Sequence
from concurrent.futures import ProcessPoolExecutor
from contextlib import contextmanager
from dataclasses import dataclass
from pathlib import Path

from variantgen.errors import InputError
from variantgen.exam.blueprint import Exam, read_exam
from variantgen.exam.roster import Student
from variantgen.exam.sheets import Sheet, assemble
from variantgen.outputs.documents import Documents, problem_documents, problem_key, student_key
from variantgen.outputs.folder import check_free, whole_folder
from variantgen.outputs.join import join_pdfs
from variantgen.outputs.records import key_csv, manifest
from variantgen.outputs.typesetter import Typesetter, typesetter
from variantgen.variants.attempts import VerificationError

# The engine keeps the layouts of its last ten documents or so, about 4 MB per sheet: parts of 8 sheets hold a process
# below 400 MB at any number of students (50 sheets: 1 GB and more), and cost 3 % more time than parts of 50. The size
# does not depend on the number of processes: the same parts give the same bytes.
SHEETS_PER_PART = 8
KEYS_PER_PART = 40

Progress = Callable[[str, int, int], None]


@dataclass(frozen=True)
class Built:
    """What a build made: the folder, how many students, and who had to draw again to be distinct.

    ``unexplained`` names the families of which some problems have an answer, but no worked solution.
    """

    folder: Path
    students: int
    redrawn: tuple[str, ...]
    unexplained: tuple[str, ...] = ()


@dataclass(frozen=True)
class _Made:
    """The PDFs of a part by their targets, and the families of problems in it that have no worked solution."""

    paths: tuple[tuple[str, Path], ...]
    unexplained: tuple[str, ...]


@dataclass(frozen=True)
class _Part:
    """The documents of a few students that are made in one go."""

    number: int
    documents: Documents
    exam: Exam
    sheets: tuple[Sheet, ...]
    first: bool

    def make(self, folder: Path, engine: Typesetter) -> _Made:
        """Typeset the part."""
        paths: list[tuple[str, Path]] = []
        unexplained: list[str] = []
        with _without_collector():
            for count, document in enumerate(self.documents(self.exam, self.sheets, self.first)):
                path = folder / f"{self.number:07}-{count:03}.pdf"
                path.write_bytes(engine.compile(document.template, document.data, tagged=document.tagged)[0])
                paths.append((document.target, path))
                unexplained += document.unexplained
        return _Made(tuple(paths), tuple(unexplained))


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

    Writes ``sheets.pdf``, ``key.pdf``, ``key.csv``, ``manifest.json`` and, if the exam wants solutions,
    ``solutions.pdf`` (with one file for each student in ``solutions/``, if it wants that). The same input gives the
    same bytes, whatever ``jobs`` is. Raises InputError for wrong input.
    """
    exam = read_exam(exam) if isinstance(exam, Path) else exam
    check_free(out, force)
    seed = exam.seed if seed is None else seed
    progress("drawing variants", 0, len(students))
    try:
        assembly = assemble(exam, students, seed)
    except InputError as error:
        raise error.located(str(exam.path)) from None
    with whole_folder(out, force) as folder:
        parts_folder = folder / ".parts"
        parts_folder.mkdir()
        parts = _parts(exam, assembly.sheets)
        paths: dict[str, list[Path]] = {}
        done = 0
        unexplained: set[str] = set()
        with _naming(seed), _makers(jobs) as run:
            for part, made in run(parts, parts_folder):
                for target, path in made.paths:
                    paths.setdefault(target, []).append(path)
                unexplained.update(made.unexplained)
                done += len(part.sheets) if part.documents is problem_documents else 0
                progress("typesetting", done, len(students))
        for target, made_paths in paths.items():
            language = exam.solutions.language if target == "solutions" else exam.language
            even = exam.duplex and target != "key"
            join_pdfs(made_paths, folder / f"{target}.pdf", exam.title, language, even)
        if exam.solutions.for_students:
            _hand_out(assembly.sheets, paths["solutions"], folder / "solutions")
        for path in parts_folder.iterdir():
            path.unlink()
        parts_folder.rmdir()
        _write(folder / "key.csv", "\ufeff" + key_csv(assembly.sheets))
        _write(folder / "manifest.json", manifest(exam, assembly.sheets, seed, assembly.redrawn))
    return Built(out, len(students), assembly.redrawn, tuple(sorted(unexplained)))


@contextmanager
def _naming(seed: str) -> Iterator[None]:
    """Name the seed where a solution disagrees with the solver."""
    try:
        yield
    except VerificationError as error:
        raise VerificationError(f"{error} (seed {seed})") from error


def _parts(exam: Exam, sheets: Sequence[Sheet]) -> list[_Part]:
    """All parts in the order in which they are joined."""
    parts: list[_Part] = []
    wanted = ((problem_documents, SHEETS_PER_PART), (student_key, KEYS_PER_PART), (problem_key, KEYS_PER_PART))
    for documents, size in wanted:
        for i in range(0, len(sheets), size):
            parts.append(_Part(len(parts), documents, exam, tuple(sheets[i : i + size]), i == 0))
    return parts


def _hand_out(sheets: Sequence[Sheet], parts: Sequence[Path], folder: Path) -> None:
    """One file for each student, named by the code of the sheet; where two have the same, a number follows."""
    folder.mkdir()
    used: Counter[str] = Counter()
    for sheet, part in zip(sheets, parts, strict=True):
        used[sheet.code] += 1
        number = f"-{used[sheet.code]}" if used[sheet.code] > 1 else ""
        shutil.copyfile(part, folder / f"{sheet.code}{number}.pdf")


Runner = Callable[[Sequence[_Part], Path], Iterator[tuple[_Part, _Made]]]


@contextmanager
def _makers(jobs: int) -> Iterator[Runner]:
    """A way to make parts, in this process or in several; results come in the order of the parts."""
    with typesetter() as engine:
        if jobs <= 1:
            yield lambda parts, folder: ((part, part.make(folder, engine)) for part in parts)
            return
        with ProcessPoolExecutor(jobs, initializer=_leave_with_parent) as pool:

            def run(parts: Sequence[_Part], folder: Path) -> Iterator[tuple[_Part, _Made]]:
                made = pool.map(_make, parts, [folder] * len(parts), [engine] * len(parts))
                return zip(parts, made, strict=True)

            try:
                yield run
            except BaseException:
                pool.shutdown(wait=False, cancel_futures=True)
                raise


def _leave_with_parent() -> None:
    """Let a worker end when the program is killed, so that nothing is left running."""
    parent = multiprocessing.parent_process()
    if parent is not None:
        threading.Thread(
            target=lambda: (multiprocessing.connection.wait([parent.sentinel]), os._exit(1)), daemon=True
        ).start()


def _make(part: _Part, folder: Path, engine: Typesetter) -> _Made:
    return part.make(folder, engine)


def _write(path: Path, text: str) -> None:
    with path.open("w", encoding="utf-8", newline="") as file:
        file.write(text)
        file.flush()
        os.fsync(file.fileno())
