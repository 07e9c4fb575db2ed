"""An exam: its problems, for which marks, in which language, on which pages."""

from __future__ import annotations

import hashlib
from collections.abc import Mapping
from pathlib import Path
from typing import Any, cast

from msgspec import Struct, field
from msgspec.structs import replace

from variantgen.exam.sections.marking_policy import MarkingPolicy
from variantgen.exam.sections.notices import Notices
from variantgen.exam.sections.solutions import Solutions
from variantgen.exam.sections.tolerance import Tolerance, with_floor
from variantgen.exam.student_order import NAME
from variantgen.exam.work.wanted_work import WIDTH, Span
from variantgen.families.asking import Ask
from variantgen.families.family import Family
from variantgen.methods.solution_options import Depth, SolutionOptions
from variantgen.wording.language import Language, load_language
from variantgen.wording.notation import USUAL, Notation


class ExamProblem(Struct, frozen=True):
    """One problem of the exam: the families it is drawn from (one per student), asked quantities, points.

    ``methods`` are those of its solutions (none: the natural ones of the family). ``nice``: only hand-friendly
    variants. ``tolerance`` is that of the problem, if it has one of its own, ``work`` bounds its calculations.
    ``composed``: its families are a pool made for it.
    """

    number: int
    families: tuple[Family, ...]
    ask: Ask
    points: int | None
    methods: tuple[str, ...] = ()
    nice: bool = False
    tolerance: Tolerance | None = None
    work: Span | None = None
    composed: bool = False


class Exam(Struct, frozen=True):
    """A checked exam file.

    ``duplex`` starts every student on an odd page, ``qr`` puts a QR code on every page of a sheet, ``reorder`` lets its
    problems stand in another order where that saves a page. ``path`` is the file it was read from, ``text`` its
    content, ``hash`` that of the text. ``formats`` are the outputs to be made, and ``options`` what the file says of
    each of them. ``sort`` is the order of the sheets, ``notices`` are at their heads, ``marking`` says what answers are
    worth, ``scan`` prints pages for answers that are scanned. ``fair`` is the relative width of the band of work, None
    where there is none.
    """

    title: str
    course: str
    language: str
    tasks: tuple[ExamProblem, ...]
    seed: str = "0"
    tolerance: Tolerance = Tolerance()
    duplex: bool = True
    path: Path = Path()
    hash: str = ""
    text: str = ""
    solutions: Solutions = Solutions()
    notation: Notation = USUAL
    formats: tuple[str, ...] = ("pdf",)
    options: Mapping[str, Any] = field(default_factory=dict)
    qr: bool = True
    reorder: bool = False
    sort: str = NAME
    notices: Notices = Notices()
    marking: MarkingPolicy = MarkingPolicy()
    fair: float | None = WIDTH
    scan: bool = False

    @property
    def build_id(self) -> str:
        """A short name of the exam as it is built with its seed, for identifiers of questions and for QR codes."""
        return hashlib.sha256(f"{self.hash}\n{self.seed}".encode()).hexdigest()[:8]

    def tolerance_of(self, task: ExamProblem) -> Tolerance:
        """By what a problem is marked: its own tolerance, or that of the exam."""
        return task.tolerance or self.tolerance

    def solution_options(self, task: ExamProblem) -> SolutionOptions:
        """The options of the solution of a problem."""
        return SolutionOptions(task.methods, cast(Depth, self.solutions.depth), self.solutions.true_scale)

    @property
    def spoken(self) -> Language:
        """The language of sheets and key, in the notation of the exam."""
        return load_language(self.language, self.notation)

    @property
    def explained(self) -> Language:
        """The language of the solutions, in the notation of the exam."""
        return load_language(self.solutions.language, self.notation)


def with_floors(exam: Exam, floors: Mapping[int | None, float]) -> Exam:
    """The exam with other least tolerances, by the number of a problem; None for those without one of their own."""
    usual = with_floor(exam.tolerance, floors.get(None, exam.tolerance.floor))
    tasks = tuple(
        replace(task, tolerance=with_floor(exam.tolerance_of(task), floors[task.number]))
        if task.number in floors
        else task
        for task in exam.tasks
    )
    return replace(exam, tolerance=usual, tasks=tasks)
