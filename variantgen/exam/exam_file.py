"""The exam file: title, language, problems with families and restrictions, page options."""

from __future__ import annotations

import hashlib
from collections.abc import Callable, Mapping, Sequence
from pathlib import Path
from types import MappingProxyType
from typing import Any

from variantgen.errors import InputError, Problem
from variantgen.exam import printable
from variantgen.exam.answer_page import read_answers_options
from variantgen.exam.exam import Exam, ExamProblem
from variantgen.exam.sections.asked import check_forms, read_asked
from variantgen.exam.sections.marking_policy import read_policy
from variantgen.exam.sections.named_families import read_names
from variantgen.exam.sections.notices import read_notices
from variantgen.exam.sections.solutions import read_solutions
from variantgen.exam.sections.tolerance import Tolerance, read_tolerance
from variantgen.exam.student_order import SORTS
from variantgen.exam.work.wanted_work import read_fair, read_work
from variantgen.families.asking import check_ask, read_ask
from variantgen.families.length_units import read_length_unit
from variantgen.families.method_names import check_methods
from variantgen.families.reading.folders import family_folders
from variantgen.families.reading.load import load_family
from variantgen.families.restrict import restrict
from variantgen.families.sketches import with_curves
from variantgen.limits import LISTED, PROBLEMS
from variantgen.resources import languages
from variantgen.tables import Table, parse_toml, read_text
from variantgen.wording.language import load_language
from variantgen.wording.notation import read_notation

SCHEMA = 1


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
