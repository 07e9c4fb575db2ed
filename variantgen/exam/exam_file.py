"""The exam file: title, language, problems with families and restrictions, page options."""

from __future__ import annotations

import hashlib
from collections.abc import Callable, Mapping, Sequence
from pathlib import Path
from types import MappingProxyType
from typing import Any, cast

from msgspec import Struct, field
from msgspec.structs import replace

from variantgen.errors import InputError, Problem
from variantgen.exam import printable
from variantgen.exam.answer_page import read_answers_options
from variantgen.exam.sections.asked import check_forms, read_asked
from variantgen.exam.sections.marking_policy import MarkingPolicy, read_policy
from variantgen.exam.sections.named_families import read_names
from variantgen.exam.sections.notices import Notices, read_notices
from variantgen.exam.sections.solutions import Solutions, read_solutions
from variantgen.exam.sections.tolerance import Tolerance, read_tolerance, with_floor
from variantgen.exam.student_order import NAME, SORTS
from variantgen.exam.work.wanted_work import WIDTH, Span, read_fair, read_work
from variantgen.families.asking import Ask, check_ask, read_ask
from variantgen.families.family import Family
from variantgen.families.length_units import read_length_unit
from variantgen.families.method_names import check_methods
from variantgen.families.reading.folders import family_folders
from variantgen.families.reading.load import load_family
from variantgen.families.restrict import restrict
from variantgen.families.sketches import with_curves
from variantgen.limits import LISTED, PROBLEMS
from variantgen.methods.solution_options import Depth, SolutionOptions
from variantgen.resources import languages
from variantgen.tables import Table, parse_toml, read_text
from variantgen.wording.language import Language, load_language
from variantgen.wording.notation import USUAL, Notation, read_notation

SCHEMA = 1


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


def read_exam(
    path: Path,
    folders: tuple[Path, ...] | None = None,
    chosen: Callable[[Sequence[str]], tuple[str, ...]] = tuple,
    readers: Mapping[str, Callable[[Table], Any]] = MappingProxyType({}),
) -> Exam:
    """Read and check an exam file. Raises InputError with every problem found.

    ``folders`` hold the instructor's own families (None: the environment variable and the folder of the file say).
    """
    folders = family_folders(beside=path) if folders is None else folders
    return parse_exam(read_text(path), path, folders, chosen, readers)


def parse_exam(
    text: str,
    path: Path,
    folders: tuple[Path, ...],
    chosen: Callable[[Sequence[str]], tuple[str, ...]] = tuple,
    readers: Mapping[str, Callable[[Table], Any]] = MappingProxyType({}),
) -> Exam:
    """The exam of the text of a file. Raises InputError with every problem found, which names the path.

    Outputs are not known here: ``chosen`` checks the names of formats, ``readers`` read the table of each of them.
    Everything else is checked before families are composed, which takes long.
    """
    exam = _exam(text, path, folders, chosen, readers, composed=False)
    if all(task.families for task in exam.tasks):
        return exam
    return _exam(text, path, folders, chosen, readers, composed=True)


def _exam(
    text: str,
    path: Path,
    folders: tuple[Path, ...],
    chosen: Callable[[Sequence[str]], tuple[str, ...]],
    readers: Mapping[str, Callable[[Table], Any]],
    composed: bool,
) -> Exam:
    """See :func:`parse_exam`; not ``composed``: a problem has no families if these are still to be composed."""
    problems: list[Problem] = []
    top = Table(parse_toml(text, path), "", problems)
    _check_schema(top)
    language = top.need("language", str, "en", " or ".join(f'"{name}"' for name in languages()))
    with top.collecting("language"):
        load_language(language)
    seed = top.take("seed", (int, str), 0, "a whole number or a word")
    page = top.table("page")
    formats: tuple[str, ...] = ("pdf",)
    with top.collecting("formats"):
        formats = chosen(top.strings("formats", formats))
    tolerance = read_tolerance(top)
    tasks = _tasks(top, folders, tolerance, read_length_unit(top), composed)
    exam = Exam(
        title=_printed(top, "title", top.need("title", str, "")),
        course=_printed(top, "course", top.take("course", str, "")),
        language=language,
        seed=str(seed),
        tolerance=tolerance,
        duplex=page.take("duplex", bool, True),
        qr=page.take("qr", bool, True),
        reorder=page.take("reorder", bool, False),
        path=path,
        hash=hashlib.sha256(text.encode()).hexdigest()[:16],
        text=text,
        solutions=read_solutions(top.table("solutions"), language),
        notation=read_notation(top.table("notation")),
        formats=formats,
        sort=top.choice("sort", SORTS),
        options=_options(top, formats, readers),
        notices=read_notices(top, language),
        tasks=tasks,
        fair=read_fair(top),
        scan=read_answers_options(top.table("answers")),
        marking=read_policy(top.table("marking"), {task.number: _asked(task) for task in tasks}),
    )
    page.finish()
    top.finish()
    if problems:
        raise InputError(problem.located(str(path)) for problem in problems)
    return exam


def _asked(task: ExamProblem) -> frozenset[str] | None:
    """The names of all that a problem may ask; None as long as it has no families."""
    if not task.families:
        return None
    forms = (form for family in task.families for form in family.forms.values())
    return frozenset(quantity.name for form in forms for quantity in read_ask(form, task.ask))


def _options(top: Table, formats: Sequence[str], readers: Mapping[str, Callable[[Table], Any]]) -> dict[str, Any]:
    """The options of the wanted formats and of those that have a table."""
    top.expect(*readers)
    return {name: read(top.table(name)) for name, read in readers.items() if name in formats or name in top.data}


def _check_schema(top: Table) -> None:
    version = top.take("schema", int, SCHEMA)
    if version != SCHEMA:
        top.problem(f"expected schema {SCHEMA}", "schema", version, "the file is for another version of the program")


def _printed(top: Table, key: str, text: str) -> str:
    """A text that stands on paper; what keeps it from that is noted."""
    top.problems += printable.problems(text, f"the {key}", key)
    return text


def _tasks(
    top: Table, folders: tuple[Path, ...], usual: Tolerance, units: str, composed: bool
) -> tuple[ExamProblem, ...]:
    """The problems that can be read; what is wrong with the others is noted."""
    within = top.bounded("problem", PROBLEMS)
    tables = top.tables("problem")
    if within and not tables:
        top.problem(
            "an exam needs at least one problem", "problem", remedy='add a table [[problem]] with family = "..."'
        )
    found = (_task(table, number, folders, usual, units, composed) for number, table in enumerate(tables, start=1))
    return tuple(task for task in found if task)


def _task(
    table: Table, number: int, folders: tuple[Path, ...], usual: Tolerance, units: str, composed: bool
) -> ExamProblem | None:
    before = len(table.problems)
    for key in ("families", "form", "ask", "method"):
        table.bounded(key, LISTED)
    if len(table.problems) > before:
        return None
    names = read_names(table, folders, composed)
    forms = (table.take("form", str, ""),) if isinstance(table.data.get("form"), str) else table.strings("form")
    fixed = table.take("set", dict, {}, "a table of parameters")
    ranges = table.take("range", dict, {}, "a table of parameters with [lowest, highest]")
    ask = read_asked(table)
    nice = table.take("nice", bool, False)
    tolerance = read_tolerance(table, usual) if "tolerance" in table.data else None
    table.expect("tolerance")
    points = table.take("points", int, 0)
    if not 0 <= points <= 1000:
        table.problem("expected a number of points from 0 to 1000", "points", points)
    single = isinstance(table.data.get("method"), str)
    methods = (table.take("method", str, ""),) if single else table.strings("method")
    with table.collecting("method"):
        methods = check_methods(methods)
    units = read_length_unit(table) or units
    work = read_work(table)
    sketch, graph = table.strings("sketch"), table.take("graph", bool, False)
    table.finish()
    families = []
    for name in names:
        with table.collecting(""):
            family = restrict(load_family(name, folders), fixed, ranges, forms, nice, units=units)
            check_ask(family, ask, load_family(name, folders))
            families.append(with_curves(family, sketch, graph))
    if names:
        check_forms(table, ask, families)
    if len(table.problems) > before:
        return None
    return ExamProblem(
        number, tuple(families), ask, points or None, methods, nice, tolerance, work, "compose" in table.data
    )
