"""Sheets as a platform has drawn them: whoever was asked a question from another sheet is marked by that variant."""

from __future__ import annotations

from collections.abc import Sequence

from msgspec.structs import replace

from variantgen.errors import InputError
from variantgen.exam.manifest import RecordedProblem
from variantgen.finished.restore import Finished
from variantgen.marking.answer_tables import HandedIn, NotMatched, ReadAnswers
from variantgen.marking.key import Key


def as_drawn(finished: Finished, read: ReadAnswers) -> tuple[Finished, ReadAnswers]:
    """The exam with the variants that students were asked, and the answers without those that belong to none."""
    drawn = [item for item in read.answers if item.sheet]
    if not drawn:
        return finished, read
    key = Key(finished.record)
    sheets = {sheet.code: place for place, sheet in enumerate(finished.record.sheets)}
    chosen: dict[tuple[int, int], str] = {}
    kept: list[HandedIn] = []
    left = list(read.not_matched)
    known: dict[tuple[str, ...], tuple[str, ...]] = {}
    for said in read.answers:
        item = said
        if item.sheet and item.who not in known:
            known[item.who] = key.without_unknown_name(item.who)
            if known[item.who] != item.who:
                why = "the class list has no such name: marked by the id alone"
                left.append(NotMatched(item.where, ", ".join(item.who), why, names_student=True))
        if item.sheet:
            item = replace(item, who=known[item.who])
        why = _choose(key, sheets, chosen, item) if item.sheet else ""
        if why:
            left.append(NotMatched(item.where, f"{item.problem}.{item.quantity}: {item.text}"[:80], why))
        else:
            kept.append(item)
    found = list(finished.record.sheets)
    for (place, number), code in chosen.items():
        other = _problem(finished.record.sheets[sheets[code]].problems, number)
        if other is not None:
            own = [problem for problem in found[place].problems if problem.number != number]
            found[place] = replace(found[place], problems=tuple(sorted([*own, other], key=lambda one: one.number)))
    record = replace(finished.record, sheets=tuple(found))
    return replace(finished, record=record), ReadAnswers(tuple(kept), tuple(left), read.corrections)


def _choose(key: Key, sheets: dict[str, int], chosen: dict[tuple[int, int], str], item: HandedIn) -> str:
    """Note which variant a student was asked; returns why it cannot be, or ''."""
    if item.sheet not in sheets:
        return f"the question is from the sheet {item.sheet}, which this exam does not have"
    try:
        place = key.student(item.who)
    except InputError:
        return ""  # that is told where answers are matched
    known = chosen.setdefault((place, item.problem), item.sheet)
    return "" if known == item.sheet else f"the same student was asked this problem from the sheet {known} before"


def _problem(problems: Sequence[RecordedProblem], number: int) -> RecordedProblem | None:
    return next((problem for problem in problems if problem.number == number), None)
