"""A form for marking by hand: what a student wrote is typed in, formulas give the points."""

from __future__ import annotations

from collections.abc import Sequence
from pathlib import Path

from variantgen.exam.exam import Exam
from variantgen.exam.sheets import Answer, Sheet
from variantgen.outputs.spreadsheet import answer_page, correction_page, marking
from variantgen.outputs.spreadsheet.headings import Headings
from variantgen.outputs.spreadsheet.identity import FROZEN, WHO, finish, write_heads, write_identity
from variantgen.outputs.spreadsheet.numbers import width
from variantgen.outputs.spreadsheet.problem_columns import PER_ANSWER, ProblemColumns, blocks, point_format
from variantgen.outputs.spreadsheet.workbook_writer import (
    ABSENT,
    CELL,
    HEAD,
    INPUT,
    NOTE,
    TEXT,
    TITLE,
    Page,
    Style,
    Workbook,
    open_workbook,
    quoted,
)

# The rows of the form above those of the students.
_TITLE, _HELP, _SIGNS, _POINTS, _GROUPS, _HEADS, _FIRST = range(7)
_TOTAL, _PERCENT, _SUMS = WHO, WHO + 1, WHO + 2
_TYPED, _MARK, _CORRECTION, _SUM = 12.0, 8.5, 6.0, 8.0  # widths of columns, in letters
_WIDEST_ASKED = 70.0
_LANDSCAPE = 98.0  # letters that a page has room for
_TYPED_TEXT: Style = {**INPUT, "num_format": "@", "align": "right"}
_COLOURS = (
    ("AND(ISNUMBER({0}),{0}>0)", {"font_color": "#1B7A3D"}),
    ("AND(ISNUMBER({0}),{0}=0)", {"font_color": "#B3261E"}),
    ('{0}="' + marking.NOT_A_NUMBER + '"', {"bg_color": "#FFD9A0"}),
)


def write_grading(exam: Exam, sheets: Sequence[Sheet], path: Path, folder: Path, protect: bool) -> None:
    """Write ``grading.xlsx``; ``folder`` is where parts of a large one are kept meanwhile."""
    language = exam.spoken
    words, headings = language.words("spreadsheet"), Headings(language)
    found = blocks(exam, sheets, headings, _SUMS + len(exam.tasks), WHO)
    with open_workbook(path, f"{words['grading']}: {exam.title}", len(sheets), folder) as book:
        form, corrections, answers = (book.page(words[name]) for name in ("grading", "corrections", "answers"))
        _Form(book, form, found, sheets, headings).write()
        correction_page.write_corrections(corrections, found, sheets, language)
        answer_page.write_answers(answers, found, sheets, language)
        if protect:
            for page in (form, corrections, answers):
                page.sheet.protect("", {"autofilter": True, "format_columns": True, "format_rows": True})


class _Form:
    """The sheet that is filled in."""

    def __init__(
        self, book: Workbook, page: Page, found: Sequence[ProblemColumns], sheets: Sequence[Sheet], headings: Headings
    ) -> None:
        self.book, self.page, self.blocks, self.sheets, self.headings = book, page, found, sheets, headings
        self.language = headings.language
        self.words = self.language.words("spreadsheet")
        self.place = found[-1].correction + 1  # a hidden column: the place of the student among the answers
        self._decimal_mark = marking.fixed(_HELP, self.place)
        self.last = _FIRST + len(sheets) - 1
        self.answers = self._rows("answers", answer_page.FIRST)
        self.corrections = self._rows("corrections", correction_page.FIRST)
        self.points: Style = {**CELL, "align": "right", "num_format": point_format(found)}
        self.bold: Style = {**self.points, "bold": True}

    def _rows(self, title: str, first: int) -> marking.Rows:
        """The rows of students on another worksheet."""
        return marking.Rows(quoted(self.words[title]), first, first + len(self.sheets) - 1)

    def write(self) -> None:
        """Write the sheet."""
        self.page.text(_TITLE, 0, self.book.title, TITLE)
        self.page.text(_HELP, 0, self.words["help"], NOTE)
        self.page.formula(_HELP, self.place, marking.DECIMAL_MARK, "")
        self.page.text(_SIGNS, 0, self.words["help_signs"], NOTE)
        self._point_row()
        for block in self.blocks:
            self.page.merged(_GROUPS, block.first, block.correction, block.title(self.language), HEAD)
        names = sum(self._head_row()[:FROZEN])
        for number, sheet in enumerate(self.sheets):
            self._student(_FIRST + number, sheet, number + 1)
        self._colours()
        self._checks()
        finish(self.page, _HEADS, self.last, self.place)
        self._paper(names)

    def _paper(self, names: float) -> None:
        """Widths of columns, and a page of paper for each problem, with the names (their columns are so wide)."""
        self.page.widths(_TOTAL, [_SUM, _SUM, *[_SUM] * len(self.blocks)])
        self.page.sheet.set_column(self.place, self.place, _SUM, None, {"hidden": True})
        most = 0.0
        for block in self.blocks:
            widths = [_TYPED] * block.most + [_MARK] * block.most + [_CORRECTION]
            if not block.uniform:
                widths = [width((self._asked(block, sheet) for sheet in self.sheets), _WIDEST_ASKED), *widths]
            self.page.widths(block.first, widths)
            most = max(most, sum(widths))
        percent = min(100, int(100 * _LANDSCAPE / (most + names)))
        self.page.printed((_POINTS, _HEADS), (self.last, self.place - 1), percent)
        self.page.sheet.repeat_columns(0, FROZEN - 1)
        self.page.sheet.set_v_pagebreaks([block.first for block in self.blocks])

    def _asked(self, block: ProblemColumns, sheet: Sheet) -> str:
        """What a student is asked in a problem."""
        item = sheet.items[block.place]
        return "; ".join(self.headings.symbol(item, answer) for answer in item.answers)

    def _point_row(self) -> None:
        """The points of problems and answers, those of answers from the worksheet where they may be changed."""
        page = self.page
        page.text(_POINTS, FROZEN - 1, self.words["points"], {"align": "right", "bold": True})
        sums = marking.span(_POINTS, _SUMS, _SUMS + len(self.blocks) - 1)
        page.formula(_POINTS, _TOTAL, marking.rounded_sum(sums), sum(block.worth for block in self.blocks), self.bold)
        for number, block in enumerate(self.blocks):
            shares = marking.span(_POINTS, block.points, block.correction - 1)
            page.formula(_POINTS, _SUMS + number, marking.rounded_sum(shares), block.worth, self.bold)
        for block in self.blocks:
            for number, points in enumerate(block.shares()):
                cell = self.answers.cell(answer_page.POINTS, block.value(number))
                page.formula(_POINTS, block.points + number, cell, points, self.points)

    def _head_row(self) -> list[float]:
        """Write the heads of all columns; returns the widths of the first ones."""
        page, points = self.page, self.words["points"]
        page.sheet.set_row(_HEADS, 32)
        widths = write_heads(page, _HEADS, self.sheets, self.language)
        numbers = (f"{block.task.number}." for block in self.blocks)
        for column, head in enumerate((self.words["total"], self.words["percent"], *numbers), start=_TOTAL):
            page.text(_HEADS, column, head, HEAD)
        for block in self.blocks:
            if not block.uniform:
                page.text(_HEADS, block.first, self.words["asked"], HEAD)
            for number, (symbol, heading) in enumerate(block.names):
                page.text(_HEADS, block.typed + number, heading, HEAD)
                page.text(_HEADS, block.points + number, f"{symbol}\n{points}", HEAD)
            page.text(_HEADS, block.correction, self.words["adjustment"], HEAD)
        return widths

    def _student(self, row: int, sheet: Sheet, place: int) -> None:
        """The row of a student; ``place`` is that among the answers, from 1 on."""
        page = self.page
        write_identity(page, row, sheet)
        sums = marking.span(row, _SUMS, _SUMS + len(self.blocks) - 1)
        page.formula(row, _TOTAL, marking.total(sums), "", self.bold)
        percent = marking.part(marking.own(row, _TOTAL), marking.fixed(_POINTS, _TOTAL))
        page.formula(row, _PERCENT, percent, "", {**CELL, "num_format": "0%"})
        for number, block in enumerate(self.blocks):
            own = marking.span(row, block.points, block.correction)
            page.formula(row, _SUMS + number, marking.total(own), "", self.points)
        for block in self.blocks:
            if not block.uniform:
                page.text(row, block.first, self._asked(block, sheet), TEXT)
            self._answers_of(row, block, block.own(sheet))
        page.formula(row, self.place, self.answers.place(marking.own(row, 0)), place)

    def _answers_of(self, row: int, block: ProblemColumns, own: Sequence[Answer]) -> None:
        """The cells of a student in one problem; what only others are asked stays grey."""
        for number in range(block.most):
            self.page.text(row, block.typed + number, "", _TYPED_TEXT if number < len(own) else ABSENT)
        for number in range(block.most):
            if number < len(own):
                self.page.formula(row, block.points + number, self._mark(row, block, number, own), "", self.points)
            else:
                self.page.text(row, block.points + number, "", ABSENT)
        place = self.corrections.place(marking.own(row, 0))
        given = self.corrections.look_up(correction_page.column(block), place)
        self.page.formula(row, block.correction, marking.shown(given), "", self.points)

    def _mark(self, row: int, block: ProblemColumns, number: int, own: Sequence[Answer]) -> str:
        """The formula for the points of an answer."""
        typed, place = marking.own(row, block.typed + number), marking.own(row, self.place)
        column = block.value(number)
        value, low, high = (self.answers.look_up(column + k, place) for k in range(PER_ANSWER))
        found = marking.number(typed, self._decimal_mark)
        if own[number].quantity.is_direction:
            right = marking.same_direction(found, value, high)
        else:
            right = marking.within(found, low, high)
        points = marking.fixed(_POINTS, block.points + number)
        if len(own) < block.most:
            every = marking.span(_POINTS, block.points, block.correction - 1, absolute=True)
            asked = marking.span(_POINTS, block.points, block.points + len(own) - 1, absolute=True)
            points = marking.share(points, every, asked)
        return marking.mark(typed, found, right, points)

    def _colours(self) -> None:
        """Colours of points: right, wrong, not a number."""
        for block in self.blocks:
            area = _FIRST, block.points, self.last, block.correction - 1
            for condition, look in _COLOURS:
                criteria = "=" + condition.format(marking.first_of(*area[:2]))
                rule = {"type": "formula", "criteria": criteria, "format": self.book.style(look)}
                self.page.sheet.conditional_format(*area, rule)

    def _checks(self) -> None:
        """An answer that is no number is asked about; that the cells are text is meant."""
        areas = (
            f"{marking.first_of(_FIRST, block.typed)}:{marking.first_of(self.last, block.points - 1)}"
            for block in self.blocks
        )
        self.page.sheet.ignore_errors({"number_stored_as_text": " ".join(areas)})
        for block in self.blocks:
            number = marking.number(marking.first_of(_FIRST, block.typed), self._decimal_mark)
            typed = {
                "validate": "custom",
                "value": f"=ISNUMBER({number})",
                "error_type": "warning",  # units and fractions may stay: `mark` reads them
                "error_title": self.words["not_a_number"],
                "error_message": self.words["number_expected"],
            }
            self.page.sheet.data_validation(_FIRST, block.typed, self.last, block.points - 1, typed)
