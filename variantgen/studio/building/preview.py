"""Pages of the sheet, or of the solutions, of one student: as a build typesets them, without building."""

from __future__ import annotations

import hashlib
import threading
from collections import OrderedDict
from collections.abc import Sequence
from contextlib import ExitStack
from typing import TYPE_CHECKING

from msgspec.structs import replace

from variantgen.errors import InputError, Problem
from variantgen.studio.workspace import USUAL_CLASS, Workspace

if TYPE_CHECKING:
    from variantgen.builder.preview import DrawnClass
    from variantgen.exam.exam import Exam
    from variantgen.exam.roster import Student
    from variantgen.exam.sheets import Sheet
    from variantgen.finished.restore import Finished
    from variantgen.outputs.single.problem_page import Format
    from variantgen.outputs.typst.typesetter import Typesetter

KINDS = ("sheet", "solution")
_KEPT = 12  # sheets whose pages are in memory


def class_of(workspace: Workspace) -> Sequence[Student]:
    """The students of the roster, or some numbered ones where there is none. Raises InputError for a wrong roster."""
    from variantgen.exam.roster import numbered, read_class

    path = workspace.roster()
    return read_class(path).students if path else numbered(USUAL_CLASS)


class Previews:
    """Pages of single students as SVG; one engine sets them all, for one thread at a time."""

    def __init__(self) -> None:
        self._kept: OrderedDict[str, list[bytes]] = OrderedDict()
        self._lock = threading.Lock()
        self._open = ExitStack()
        self._engine: Typesetter | None = None
        self._drawn: tuple[str, DrawnClass] | None = None  # the last class, for its other students

    def pages(self, exam: Exam, students: Sequence[Student], place: int, kind: str) -> tuple[str, int]:
        """The name and the number of the pages of a student, by the place in the class. Raises InputError."""
        drawn_for = _drawn_for(exam, students)
        name = hashlib.sha256(f"{drawn_for}\n{place}\n{kind}".encode()).hexdigest()[:20]
        with self._lock:
            if name not in self._kept:
                self._keep(name, self._made(exam, students, place, kind, "svg", drawn_for))
            self._kept.move_to_end(name)
            return name, len(self._kept[name])

    def finished_pages(self, finished: Finished, place: int, kind: str) -> tuple[str, int]:
        """The name and the number of the pages of a sheet that was built. Raises InputError."""
        from variantgen.outputs.single.one_sheet import sheet_pages
        from variantgen.outputs.typst.typesetter import typesetter

        record = finished.record
        name = hashlib.sha256(f"{record.exam_id}\n{record.path}\n{place}\n{kind}".encode()).hexdigest()[:20]
        with self._lock:
            if name not in self._kept:
                if self._engine is None:
                    self._engine = self._open.enter_context(typesetter())
                exam = _with_solutions(finished.exam) if kind == "solution" else finished.exam
                sheet = finished.sheets([place])[0]
                self._keep(name, sheet_pages(exam, sheet, self._engine, "svg", kind == "solution"))
            return name, len(self._kept[name])

    def sheet(self, exam: Exam, students: Sequence[Student], place: int) -> Sheet:
        """What is on the sheet of a student, by the place in the class. Raises InputError."""
        with self._lock:
            return self._sheet(exam, students, place, _drawn_for(exam, students))

    def page(self, name: str, number: int) -> bytes:
        """A page that was made. Raises InputError for one that was not, or is forgotten."""
        pages = self._kept.get(name, [])
        if not 1 <= number <= len(pages):
            raise InputError(Problem("there is no such page", value=f"{name} {number}", remedy="load the page again"))
        return pages[number - 1]

    def _made(
        self, exam: Exam, students: Sequence[Student], place: int, kind: str, form: Format, drawn_for: str
    ) -> list[bytes]:
        from variantgen.outputs.single.one_sheet import sheet_pages
        from variantgen.outputs.typst.typesetter import typesetter

        if self._engine is None:
            self._engine = self._open.enter_context(typesetter())
        if kind == "solution":
            exam = _with_solutions(exam)
        return sheet_pages(exam, self._sheet(exam, students, place, drawn_for), self._engine, form, kind == "solution")

    def _sheet(self, exam: Exam, students: Sequence[Student], place: int, drawn_for: str) -> Sheet:
        from variantgen.builder.preview import DrawnClass

        if self._drawn is None or self._drawn[0] != drawn_for:
            self._drawn = None
            self._drawn = drawn_for, DrawnClass(exam, students)
        return self._drawn[1].sheet(place)

    def _keep(self, name: str, pages: list[bytes]) -> None:
        self._kept[name] = pages
        while len(self._kept) > _KEPT:
            self._kept.popitem(last=False)

    def close(self) -> None:
        """Remove what the engine has on disk."""
        self._open.close()


def _with_solutions(exam: Exam) -> Exam:
    """An exam that has solutions, be it for the look of them alone."""
    return exam if exam.solutions.wanted else replace(exam, solutions=replace(exam.solutions, depth="full"))


def _drawn_for(exam: Exam, students: Sequence[Student]) -> str:
    """All that the variants of a class depend on."""
    from variantgen.exam.manifest import made_with

    listed = repr([(student.id, student.name, student.group) for student in students])
    return f"{exam.text}\n{exam.seed}\n{listed}\n{sorted(made_with(exam).items())}"
