"""The sheet of a form for marking that has the right answers and their bounds, in the order of the class list."""

from __future__ import annotations

from collections.abc import Mapping, Sequence

from variantgen.exam.sheets import Sheet
from variantgen.outputs.spreadsheet.identity import FROZEN, finish, write_heads, write_identity
from variantgen.outputs.spreadsheet.numbers import decimals, number_check, number_format, number_width
from variantgen.outputs.spreadsheet.problem_columns import PER_ANSWER, ProblemColumns, point_format
from variantgen.outputs.spreadsheet.workbook_writer import ABSENT, CELL, HEAD, INPUT, Page, Style
from variantgen.wording.language import Language

_TITLES, _QUANTITIES, POINTS, _HEADS = range(4)  # the points of answers may be changed
FIRST = _HEADS + 1  # the row of the first student


def write_answers(page: Page, blocks: Sequence[ProblemColumns], sheets: Sequence[Sheet], language: Language) -> None:
    """Write the sheet."""
    words = language.words("spreadsheet")
    for block in blocks:
        page.merged(_TITLES, block.answers, block.answers_end - 1, block.title(language), HEAD)
    for column, (_, heading) in _columns(blocks):
        page.merged(_QUANTITIES, column, column + PER_ANSWER - 1, heading, HEAD)
    _write_points(page, blocks, words)
    write_heads(page, _HEADS, sheets, language)
    for column, _ in _columns(blocks):
        for k, name in enumerate(("value", "low", "high")):
            page.text(_HEADS, column + k, words[name], HEAD)
    places = {block.place: _decimals(page, block, sheets) for block in blocks}
    for row, sheet in enumerate(sheets, start=FIRST):
        write_identity(page, row, sheet)
        for block in blocks:
            _write_numbers(page, row, block, sheet, places[block.place])
    last = blocks[-1].answers_end
    finish(page, _HEADS, FIRST + len(sheets) - 1, last)
    page.printed((0, _HEADS), (FIRST + len(sheets) - 1, last - 1))


def _write_points(page: Page, blocks: Sequence[ProblemColumns], words: Mapping[str, str]) -> None:
    """The points of each answer above its value."""
    page.text(POINTS, FROZEN - 1, words["points"], {"align": "right", "bold": True})
    look: Style = {**INPUT, "num_format": point_format(blocks)}
    for block in blocks:
        for number, points in enumerate(block.shares()):
            column = block.value(number)
            page.number(POINTS, column, points, look)
            page.sheet.data_validation(POINTS, column, POINTS, column, number_check(words))


def _columns(blocks: Sequence[ProblemColumns]) -> list[tuple[int, tuple[str, str]]]:
    """The first column of each answer, and its names."""
    return [(block.value(k), names) for block in blocks for k, names in enumerate(block.names)]


def _decimals(page: Page, block: ProblemColumns, sheets: Sequence[Sheet]) -> list[int]:
    """The decimals of each answer of a problem; their columns are made wide enough."""
    found = []
    for number in range(block.most):
        answers = [own[number] for own in map(block.own, sheets) if number < len(own)]
        found.append(decimals(answer.value for answer in answers))
        ends = [end for answer in answers for end in answer.accepted_intervals[0]]
        page.widths(block.value(number), [number_width(ends, found[-1])] * PER_ANSWER)
    return found


def _write_numbers(page: Page, row: int, block: ProblemColumns, sheet: Sheet, places: Sequence[int]) -> None:
    """The answers of a student in one problem; what only others are asked stays grey."""
    own = block.own(sheet)
    for number in range(block.most):
        column = block.value(number)
        if number >= len(own):
            for k in range(PER_ANSWER):
                page.text(row, column + k, "", ABSENT)
            continue
        answer = own[number]
        look = {**CELL, "num_format": number_format(answer, places[number])}
        page.number(row, column, answer.value, {**look, "bold": True})
        for k, end in enumerate(answer.accepted_intervals[0], start=1):
            page.number(row, column + k, end, look)
