"""Answers that were handed in, matched with the students, problems and quantities of the key."""

from __future__ import annotations

from collections.abc import Sequence
from fractions import Fraction

from variantgen.errors import InputError
from variantgen.families.quantities import split_name
from variantgen.marking.answer_tables import HandedIn, NotMatched
from variantgen.marking.key import Key
from variantgen.marking.typed_number import read_number

_NOTHING = frozenset("-–—−/")  # what stands for nothing when it stands alone
SIGNS = {"+": 1.0, "-": -1.0, "−": -1.0, "–": -1.0}  # alone they are an answer where a sense is asked

Typed = dict[tuple[int, int, str], HandedIn]
Correction = tuple[Fraction, str]  # points, and where they are given


def matched(key: Key, answers: Sequence[HandedIn], left: list[NotMatched]) -> Typed:
    """The answers by student, problem and quantity; what cannot be matched, or contradicts an earlier one, is told."""
    found: Typed = {}
    students: dict[tuple[str, ...], int | None] = {}
    for item in answers:
        if is_blank(item.text) and item.text.strip() not in SIGNS:
            continue
        who = item.who or ("", item.where)  # rows that name nobody are told one by one
        if who not in students:
            students[who] = _student(key, item, left)
        place = students[who]
        if place is None:
            continue
        name, why = key.quantity(place, item.problem, item.quantity)
        if not name:
            left.append(NotMatched(item.where, f"{item.problem}.{item.quantity}: {item.text}", why))
            continue
        if is_blank(item.text) and split_name(name).component != "sense":
            continue  # a dash alone: it leaves room for the answer of another file
        known = found.get((place, item.problem, name))
        if known is None:
            found[place, item.problem, name] = item
        elif item.text != known.text:
            why = f"the same student has another answer in {known.where}, which stands"
            text = f"{item.problem}.{name}: {known.text}, then {item.text}"
            left.append(NotMatched(item.where, text, why, "strike out one of them and mark again"))
    return found


def corrections(key: Key, typed: Sequence[HandedIn], left: list[NotMatched]) -> dict[tuple[int, int], Correction]:
    """Points given or taken by hand and where, by student and problem; what is no number or is told twice is told.

    Students that cannot be matched have been told with their answers, or are here.
    """
    found: dict[tuple[int, int], Correction] = {}
    seen: dict[tuple[int, int], str] = {}
    for item in typed:
        place = _student(key, item, left)
        number = read_number(item.text)
        if place is None:
            continue
        what = f"{item.problem}: {item.text}"[:80]
        if number is None or number.unit is not None or item.problem not in key.places[place]:
            left.append(NotMatched(item.where, what, "is no number of points"))
        elif (place, item.problem) in seen:
            if seen[place, item.problem] != item.text:
                left.append(NotMatched(item.where, what, "another correction of the same problem was there before"))
        else:
            seen[place, item.problem] = item.text
            found[place, item.problem] = Fraction(repr(number.values[0])), item.where
    return found


def _student(key: Key, item: HandedIn, left: list[NotMatched]) -> int | None:
    """The place of the student of a row; None where there is none, which is told once."""
    words = ", ".join(item.who) or "nothing"
    if not item.who:
        left.append(NotMatched(item.where, item.text, "the row names no student"))
        return None
    try:
        return key.student(item.who)
    except InputError as error:
        problem = error.problems[0]
        left.append(NotMatched(item.where, words, problem.message, problem.remedy, names_student=True))
        return None


def is_blank(text: str) -> bool:
    """Whether a text stands for no answer."""
    return not text.strip() or text.strip() in _NOTHING
