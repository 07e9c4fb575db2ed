"""Tables with the answers of a class, as they come: CSV or XLSX, long, wide, or the form for marking of a build.

=====  ======================================================================================================
long   columns for the student, the problem, the quantity, the answer: one row for each answer
wide   a column for the student, and one for each answer, headed ``1.v_B``: one row for each student
form   ``grading.xlsx`` of the build, filled in
=====  ======================================================================================================

What a table says is kept as text, with the place where it stands; what cannot be matched is told and never guessed.
"""

from __future__ import annotations

import re
from collections import Counter
from collections.abc import Collection, Mapping, Sequence
from pathlib import Path

from msgspec import Struct

from variantgen.errors import InputError, Problem
from variantgen.exam.roster.columns import cell_of
from variantgen.exam.roster.table_files import read_worksheets
from variantgen.exam.roster.worksheet import Worksheet
from variantgen.limits import ANSWER_COLUMNS, TITLE_ROWS
from variantgen.marking.attempts import NO_TEXTS, AttemptReport, lacks_texts, report_of
from variantgen.marking.form_words import FormWords
from variantgen.marking.heads import asked_by, check_heads, in_unit, kind_of, known_unit, renamed, unit_of, unused

_PROBLEM = re.compile(r"[0-9]{1,3}")
_STUDENT = ("code", "id", "name", "student", "surname", "first")


class HandedIn(Struct, frozen=True):
    """An answer as it was handed in: ``who`` has what the row says of the student, ``where`` names the row.

    ``quantity`` is the name that the table has, or the place of the answer in a form. ``sheet`` is the code of the
    sheet that the question is from, where the table says it. ``waiting`` is an answer on a scan until somebody has
    looked at it.
    """

    where: str
    who: tuple[str, ...]
    problem: int
    quantity: str | int
    text: str
    sheet: str = ""
    waiting: bool = False


class NotMatched(Struct, frozen=True):
    """What could not be read or matched: where it stands, what it says, why, and what to do.

    ``names_student``: what it says may name a student.
    """

    where: str
    text: str
    why: str
    remedy: str = ""
    names_student: bool = False


class ReadAnswers(Struct, frozen=True):
    """What the files hold: answers in their order, and rows and columns that say nothing that is understood.

    ``corrections`` are points that somebody gave or took by hand in a form, each with the problem it is about.
    """

    answers: tuple[HandedIn, ...]
    not_matched: tuple[NotMatched, ...]
    corrections: tuple[HandedIn, ...] = ()


def read_answers(
    paths: Sequence[Path],
    form: FormWords,
    columns: Mapping[str, str] | None = None,
    names: Mapping[Path, str] | None = None,
) -> ReadAnswers:
    """All answers of some files; ``columns`` say what heads stand for that are other words.

    ``names`` are words for the files where their own and those of worksheets may name students.

    Raises InputError for a file that is no table, one without answers, and for a head that no table has.
    """
    answers: list[HandedIn] = []
    left: list[NotMatched] = []
    corrections: list[HandedIn] = []
    sheets: list[tuple[Path, Worksheet]] = []
    for path in paths:
        try:
            sheets += [(path, sheet) for sheet in read_worksheets(path, ANSWER_COLUMNS, formulas=True)]
        except InputError as error:
            raise error.located(str(path)) from None
    named = renamed([sheet for _, sheet in sheets], columns) if columns else [sheet for _, sheet in sheets]
    for path in dict.fromkeys(paths):
        own = [sheet for (other, _), sheet in zip(sheets, named, strict=True) if other == path]
        try:
            found = _Tables(path.name if names is None else names[path], own, form, names is not None)
            found.read()
        except InputError as error:
            raise error.located(str(path)) from None
        answers += found.answers
        left += found.left
        corrections += found.corrections
    return ReadAnswers(tuple(answers), tuple(left), tuple(corrections))


class _Tables:
    """The worksheets of one file."""

    def __init__(self, name: str, sheets: Sequence[Worksheet], form: FormWords, numbered: bool) -> None:
        self.name, self.form = name, form
        self.sheets = [sheet for sheet in sheets if sheet.rows]
        self.titles = {
            id(sheet): str(n) if numbered and sheet.title else sheet.title for n, sheet in enumerate(sheets, 1)
        }
        self.answers: list[HandedIn] = []
        self.left: list[NotMatched] = []
        self.corrections: list[HandedIn] = []
        self.apart = False  # whether points by hand have a worksheet of their own, which the form only shows

    def read(self) -> None:
        """Read every worksheet that has answers."""
        if not self.sheets:
            raise InputError(Problem("the table is empty", remedy="its first row names the columns"))
        heads = [cells for sheet in self.sheets for _, cells in sheet.rows[:TITLE_ROWS]]
        self.apart = any(map(self.form.own_corrections, heads))
        understood = [self._sheet(sheet) for sheet in self.sheets]
        form = any(map(self.form.columns, heads))
        for sheet, read in zip(self.sheets, understood, strict=True):
            if not read and not form:  # beside the form stand the answers of the key
                head = ", ".join(sheet.rows[0][1])[:80]
                where, why = self._where(sheet, sheet.rows[0][0]), "no table of answers: left out"
                self.left.append(NotMatched(where, head, why, names_student=True))
        if not any(understood):
            raise InputError(
                Problem(
                    "no table of answers",
                    value=", ".join(self.sheets[0].rows[0][1])[:80],
                    remedy="expected columns  student, problem, quantity, answer,  or  student, 1.v_B, 1.omega_AB, ...,"
                    "  or a filled grading.xlsx",
                )
            )

    def _sheet(self, sheet: Worksheet) -> bool:
        """Read a worksheet; False where it holds no answers."""
        for place, (_, cells) in enumerate(sheet.rows[:TITLE_ROWS]):
            if columns := self.form.columns(cells):
                self._filled(sheet, place, columns)
                return True
            if corrected := self.form.own_corrections(cells):
                self._corrected(sheet, place, corrected)
                return True
            if report := report_of(cells, kind_of):
                self._attempts(sheet, place, report)
                return True
            if lacks_texts(cells, kind_of):
                message, remedy = NO_TEXTS
                raise InputError(Problem(message, remedy=remedy))
            kinds = [kind_of(cell) for cell in cells]
            heads = {column: found for column, cell in enumerate(cells) if (found := asked_by(cell))}
            if not set(kinds) & set(_STUDENT):
                continue
            if heads or {"problem", "quantity"} <= set(kinds):
                check_heads(cells, kinds)
            if {"problem", "quantity", "answer"} <= set(kinds):
                self._long(sheet, place, kinds)
                return True
            if heads:
                self._wide(sheet, place, kinds, heads)
                return True
        return False

    def _where(self, sheet: Worksheet, number: int) -> str:
        title = self.titles[id(sheet)]
        return f"{self.name}, " + (f"worksheet {title}, " if title else "") + f"row {number}"

    def _filled(self, sheet: Worksheet, head: int, columns: Mapping[int, tuple[int, int]]) -> None:
        asked = Counter(problem for problem, _ in columns.values())
        for number, cells in sheet.rows[head + 1 :]:
            who = tuple(cell for cell in cells[: len(self.form.heads) - 1] if cell)  # code, id, name
            for column, (problem, answer) in columns.items():
                if text := cell_of(cells, column):
                    self.answers.append(HandedIn(self._where(sheet, number), who, problem, answer, text))
                points = column + asked[problem]
                if sheet.computed and (text := cell_of(cells, points)) and (number, points) not in sheet.computed:
                    remedy = "type what is to be added or taken away into the worksheet of corrections"
                    why = "points typed over their formula are not read"
                    self.left.append(NotMatched(self._where(sheet, number), f"{problem}: {text}"[:80], why, remedy))
        self._corrected(sheet, head, self.form.corrections(sheet.rows[head][1]), shown=self.apart)

    def _corrected(self, sheet: Worksheet, head: int, columns: Mapping[int, int], shown: bool = False) -> None:
        """Read points given or taken by hand; ``shown``: formulas only repeat them."""
        for number, cells in sheet.rows[head + 1 :]:
            who = tuple(cell for cell in cells[: len(self.form.heads) - 1] if cell)
            for column, problem in columns.items():
                if (text := cell_of(cells, column)) and not (shown and (number, column) in sheet.computed):
                    self.corrections.append(HandedIn(self._where(sheet, number), who, problem, "", text))

    def _attempts(self, sheet: Worksheet, head: int, report: AttemptReport) -> None:
        for number, cells in sheet.rows[head + 1 :]:
            where, who = self._where(sheet, number), report.student(cells)
            for item in report.attempted(cells):
                question = item.question
                if question is None:
                    if item.text:
                        self.left.append(NotMatched(where, item.text[:80], "the question is not one of this program"))
                    continue
                self.answers.append(HandedIn(where, who, question.problem, item.quantity, item.text, question.code))

    def _long(self, sheet: Worksheet, head: int, kinds: Sequence[str]) -> None:
        places = {kind: kinds.index(kind) for kind in kinds if kind}
        self._tell_unused(sheet, head, places.values())
        for number, cells in sheet.rows[head + 1 :]:
            row = {kind: cells[place] if place < len(cells) else "" for kind, place in places.items()}
            where = self._where(sheet, number)
            problem = row["problem"].removesuffix(".")
            if self._is_too_long(sheet, head, number, cells):
                continue
            if not _PROBLEM.fullmatch(problem):
                self.left.append(NotMatched(where, row["problem"][:80], "the problem is no number", "", True))
                continue
            try:  # review.csv has an apostrophe where a spreadsheet would run the cell
                text = in_unit(row["answer"].removeprefix("'"), known_unit(row.get("unit", "")))
            except InputError as error:
                self.left.append(NotMatched(where, row["unit"][:80], "unknown unit", error.problems[0].remedy))
                continue
            self.answers.append(HandedIn(where, _who(row), int(problem), row["quantity"], text))

    def _tell_unused(self, sheet: Worksheet, head: int, used: Collection[int]) -> None:
        number, cells = sheet.rows[head]
        if others := unused(cells, used):
            what = ", ".join(others)
            self.left.append(NotMatched(self._where(sheet, number), what, "columns that are not used", "", True))

    def _is_too_long(self, sheet: Worksheet, head: int, number: int, cells: Sequence[str]) -> bool:
        """Whether a row has more cells than the head, as where a decimal comma parts them: it is told and not read."""
        if not any(cells[len(sheet.rows[head][1]) :]):
            return False
        remedy = "quote answers with a decimal comma, or part the cells by semicolons"
        what = ", ".join(cells)[:80]
        self.left.append(NotMatched(self._where(sheet, number), what, "has more cells than the head", remedy, True))
        return True

    def _wide(self, sheet: Worksheet, head: int, kinds: Sequence[str], asked: Mapping[int, tuple[int, str]]) -> None:
        places = {kind: kinds.index(kind) for kind in kinds if kind in _STUDENT}
        units = {column: unit_of(sheet.rows[head][1][column]) for column in asked}
        self._tell_unused(sheet, head, {*places.values(), *asked})
        for number, cells in sheet.rows[head + 1 :]:
            if self._is_too_long(sheet, head, number, cells):
                continue
            row = {kind: cells[place] if place < len(cells) else "" for kind, place in places.items()}
            for column, (problem, quantity) in asked.items():
                text = in_unit(cells[column], units[column]) if column < len(cells) else ""
                self.answers.append(HandedIn(self._where(sheet, number), _who(row), problem, quantity, text))


def _who(row: Mapping[str, str]) -> tuple[str, ...]:
    """What a row says of the student: words that each name one, and the parts of a name as one of them."""
    words = [row[kind] for kind in _STUDENT[:4] if row.get(kind)]
    name = " ".join(row[kind] for kind in _STUDENT[4:] if row.get(kind))
    return (*words, name) if name else tuple(words)
