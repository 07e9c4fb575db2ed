"""``marks.xlsx``: the marks for reading: a sheet of sums, one for each group, the causes, the policy.

This module needs XlsxWriter: import it where it is used.
"""

from __future__ import annotations

from collections import Counter, defaultdict
from collections.abc import Sequence
from fractions import Fraction
from pathlib import Path

from variantgen.exam.exam import Exam
from variantgen.exam.sections.marking_policy import MarkingPolicy
from variantgen.marking.marks import Marked, MarkedAnswer, StudentTotal, Verdict
from variantgen.marking.words import cause_in_words
from variantgen.outputs.spreadsheet.numbers import width
from variantgen.outputs.spreadsheet.workbook_writer import CELL, HEAD, NOTE, TEXT, TITLE, Page, Style, open_workbook
from variantgen.wording.language import Language

_TITLE, _NOTE, _HEADS, _FIRST = range(4)
_LOOKS: dict[Verdict, Style] = {
    Verdict.RIGHT: {**CELL, "font_color": "#1B7A3D"},
    Verdict.FOLLOW_THROUGH: {**CELL, "font_color": "#1F5FA8"},
    Verdict.WRONG: {**CELL, "font_color": "#B3261E"},
    Verdict.BLANK: {**CELL, "font_color": "#767676"},
    Verdict.UNREADABLE: {**CELL, "bg_color": "#FFD9A0"},
}
_BOLD: Style = {**CELL, "bold": True}
_PERCENT: Style = {**CELL, "num_format": "0%"}


def write_book(path: Path, exam: Exam, marked: Marked, policy: MarkingPolicy, anonymous: bool) -> None:
    """Write the workbook; ``anonymous`` leaves out ids, names and groups."""
    language = exam.spoken
    words = language.words("marking")
    own: dict[int, list[MarkedAnswer]] = defaultdict(list)
    for item in marked.marks:
        own[item.place].append(item)
    groups: dict[str, list[int]] = defaultdict(list)
    for place, total in enumerate(marked.totals):
        groups["" if anonymous else total.student.group].append(place)
    with open_workbook(path, f"{words['points']}: {exam.title}", len(marked.totals), path.parent) as book:
        every = _Table(book.page(words["sums"]), language, marked, anonymous)
        every.write(range(len(marked.totals)), {})
        for group, places in groups.items():
            title = group or (words["answers"] if len(groups) == 1 else words["no_group"])
            _Table(book.page(title), language, marked, anonymous).write(places, own)
        _write_causes(book.page(words["causes"]), marked, language)
        _write_policy(book.page(words["policy"]), policy, language)


class _Table:
    """A sheet with a row for each student."""

    def __init__(self, page: Page, language: Language, marked: Marked, anonymous: bool) -> None:
        self.page, self.marked, self.anonymous = page, marked, anonymous
        self.words, self.key = language.words("marking"), language.words("key")
        self.who = language.words("spreadsheet")

    def write(self, places: Sequence[int], own: dict[int, list[MarkedAnswer]]) -> None:
        """Write the rows of some students, with what they have for each answer where ``own`` has their answers."""
        totals = [self.marked.totals[place] for place in places]
        numbers = sorted({number for total in totals for number in total.problems})
        names = {number: _names(places, own, number) for number in numbers}
        self.page.text(_TITLE, 0, self.page.book.title, TITLE)
        self.page.text(_NOTE, 0, self.words["colours"] if own else "", NOTE)
        heads = [self.key["variant"]]
        if not self.anonymous:
            heads += [self.who["id"], self.who["name"], self.who["group"]]
        first = len(heads)
        for number in numbers:
            heads += [*(f"{number}.{name}" for name in names[number]), f"{number}."]
        heads += [self.words["points"], self.words["most"], "%", self.words["grade"], self.words["open"]]
        for column, head in enumerate(heads):
            self.page.text(_HEADS, column, head, HEAD)
        for row, (place, total) in enumerate(zip(places, totals, strict=True), start=_FIRST):
            self._student(row, first, total, names, own.get(place, []))
        self.page.widths(0, [width([head, *texts]) for head, texts in zip(heads, self._who(totals), strict=False)])
        self.page.widths(first, [width([head]) for head in heads[first:]])
        self.page.sheet.freeze_panes(_FIRST, min(first, 3))
        self.page.sheet.autofilter(_HEADS, 0, max(_HEADS + len(totals), _FIRST), len(heads) - 1)
        self.page.printed((_TITLE, _HEADS), (_HEADS + len(totals), len(heads) - 1))

    def _who(self, totals: Sequence[StudentTotal]) -> list[list[str]]:
        """The columns that say who a row is about."""
        columns = [[total.code for total in totals]]
        if not self.anonymous:
            columns += [[getattr(total.student, name) for total in totals] for name in ("id", "name", "group")]
        return columns

    def _student(
        self, row: int, column: int, total: StudentTotal, names: dict[int, list[str]], own: Sequence[MarkedAnswer]
    ) -> None:
        for place, (text,) in enumerate(self._who([total])):
            self.page.text(row, place, text, {**CELL, "num_format": "@"})
        for number, asked in names.items():
            answers = [item for item in own if item.problem == number]
            for place, name in enumerate(asked):
                found = [a for k, a in enumerate(answers) if name in (a.answer.quantity.name, f"#{k + 1}")]
                if found and found[0].verdict is not Verdict.BLANK:
                    self.page.number(row, column + place, float(found[0].points), _LOOKS[found[0].verdict])
                else:
                    self.page.text(row, column + place, "–" if found else "", _LOOKS[Verdict.BLANK])
            column += len(asked)
            if number in total.problems:
                self.page.number(row, column, float(total.problems[number]), _BOLD)
            column += 1
        self.page.number(row, column, float(total.points), _BOLD)
        self.page.number(row, column + 1, float(total.of))
        if total.of:
            self.page.number(row, column + 2, float(total.points / total.of), _PERCENT)
        self.page.text(row, column + 3, total.grade, TEXT)
        if total.open:
            self.page.number(row, column + 4, total.open, _LOOKS[Verdict.UNREADABLE])


def _names(places: Sequence[int], own: dict[int, list[MarkedAnswer]], number: int) -> list[str]:
    """The answers of a problem: their names, or their places where students are asked for different ones."""
    asked = {tuple(a.answer.quantity.name for a in own.get(place, ()) if a.problem == number) for place in places}
    asked.discard(())
    if len(asked) == 1:
        return list(asked.pop())
    return [f"#{k + 1}" for k in range(max(map(len, asked), default=0))]


def _write_causes(page: Page, marked: Marked, language: Language) -> None:
    """How often each cause was met, by problem, type and answer."""
    words = language.words("marking")
    found: Counter[tuple[int, str, str, str, str]] = Counter()
    for item in marked.marks:
        if item.verdict in (Verdict.WRONG, Verdict.FOLLOW_THROUGH):
            cause = cause_in_words(item.cause, words, language, {})
            asked = item.problem, item.form, item.answer.quantity.name
            found[*asked, words[item.verdict.value], cause] += 1
    heads = [
        language.words("key")["problem"],
        *(words[name] for name in ("form", "asked", "verdict", "cause", "times")),
    ]
    for column, head in enumerate(heads):
        page.text(0, column, head, HEAD)
    rows = sorted(found.items(), key=lambda row: (row[0][0], -row[1], row[0]))
    for place, ((number, *texts), count) in enumerate(rows, start=1):
        page.number(place, 0, number)
        for column, text in enumerate(texts, start=1):
            page.text(place, column, text, TEXT)
        page.number(place, len(heads) - 1, count)
    columns = zip(heads, *([str(number), *texts, str(count)] for (number, *texts), count in rows), strict=True)
    page.widths(0, [width(texts, 70.0) for texts in columns])
    page.sheet.freeze_panes(1, 0)


def _write_policy(page: Page, policy: MarkingPolicy, language: Language) -> None:
    """What answers were worth, by the names that a policy has in its file."""
    page.text(0, 0, language.words("marking")["policy"], TITLE)
    for row, (name, value) in enumerate(policy.entries(), start=1):
        page.text(row, 0, name, TEXT)
        if isinstance(value, str):
            page.text(row, 1, value, TEXT)
        else:
            page.number(row, 1, float(Fraction(value)))
    page.widths(0, [width(name for name, _ in policy.entries()), 30.0])
