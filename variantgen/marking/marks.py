"""The marks of a class: a verdict for every answer of every student, its cause, and the points by a policy."""

from __future__ import annotations

import math
import re
from collections import defaultdict
from collections.abc import Mapping, Sequence
from enum import Enum
from fractions import Fraction

from msgspec import Struct, field
from msgspec.structs import replace

from variantgen.exam.roster import Student
from variantgen.exam.sections.marking_policy import MarkingPolicy
from variantgen.exam.sheets import Answer
from variantgen.families.quantities import Quantity
from variantgen.finished.restore import Finished
from variantgen.marking.answer_tables import NotMatched, ReadAnswers
from variantgen.marking.diagnosis.causes import OTHER, Cause, Comparisons, cause_of
from variantgen.marking.diagnosis.follow_through import FollowThrough
from variantgen.marking.diagnosis.neighbours import Neighbours
from variantgen.marking.diagnosis.plausible_mistakes import OfProblem, mistakes_of
from variantgen.marking.key import Key, is_right
from variantgen.marking.matching import SIGNS, Correction, Typed, corrections, is_blank, matched
from variantgen.marking.typed_number import read_number
from variantgen.marking.worth import sums, worth_of

_COPIED = 3  # answers of a problem that are those of a neighbour's sheet, from which on nothing follows from them
_DATE = re.compile(r"\d{4}-\d\d-\d\d( |$)")


class Verdict(Enum):
    """What an answer is found to be."""

    RIGHT = "right"
    FOLLOW_THROUGH = "follow_through"
    WRONG = "wrong"
    BLANK = "blank"
    UNREADABLE = "unreadable"


class MarkedAnswer(Struct, frozen=True):
    """One answer: what was written, what it is in the unit of the key, the verdict, the cause, the points of it.

    It is ``waiting`` while a person has to look at the scan that it is on.
    """

    place: int
    problem: int
    form: str
    answer: Answer
    text: str
    value: float | None
    verdict: Verdict
    cause: Cause | None = None
    points: Fraction = Fraction(0)
    of: Fraction = Fraction(0)
    waiting: bool = False


class StudentTotal(Struct, frozen=True):
    """The sum of a student: points of each problem by number, of all, the most, the grade, answers handed in.

    While answers are ``open``, which a person still has to look at, it is not final. ``by_hand`` are points given or
    taken by hand, by problem; they are among the others.
    """

    student: Student
    code: str
    problems: Mapping[int, Fraction]
    points: Fraction
    of: Fraction
    grade: str
    handed_in: int
    open: int = 0
    by_hand: Mapping[int, Fraction] = field(default_factory=dict)


class Marked(Struct, frozen=True):
    """The marks of a class in the order of the manifest, the sums, and what could not be matched."""

    marks: tuple[MarkedAnswer, ...]
    totals: tuple[StudentTotal, ...]
    not_matched: tuple[NotMatched, ...]


def mark(finished: Finished, read: ReadAnswers, policy: MarkingPolicy) -> Marked:
    """Mark the answers of a class. Raises InputError where the exam cannot be restored."""
    key = Key(finished.record, policy.tolerance)
    left = list(read.not_matched)
    typed = matched(key, read.answers, left)
    marks = _judged(key, typed)
    for item in marks:
        if item.verdict is Verdict.UNREADABLE:
            found = typed[item.place, item.problem, item.answer.quantity.name]
            what = f"{item.problem}.{item.answer.quantity.name}: {item.text}"[:80]
            left.append(NotMatched(found.where, what, *_unreadable(item)))
    marks = _following(finished, _with_causes(finished, key, marks))
    worth = worth_of(finished, key, policy)
    marks = [_with_points(item, policy, worth[item.place, item.problem]) for item in marks]
    totals = _totals(key, marks, policy, corrections(key, read.corrections, left), left)
    return Marked(tuple(marks), tuple(totals), tuple(left))


def _unreadable(item: MarkedAnswer) -> tuple[str, str]:
    """Why an answer is no number, and what to do."""
    if item.waiting:
        return "waits for review", ""
    if item.text.startswith("="):
        return "is a formula that was never computed", "open the file in the spreadsheet and save it"
    if _DATE.match(item.text):
        return "is a date: the spreadsheet took a number for one", "type it with the decimal mark of the spreadsheet"
    return "is no number that can be read", ""


def _judged(key: Key, typed: Typed) -> list[MarkedAnswer]:
    """A verdict for every answer of the class; causes come later."""
    marks = []
    for place, problems in key.places.items():
        for number, problem in problems.items():
            for answer in key.answers(place, number):
                item = typed.get((place, number, answer.quantity.name))
                verdict = verdict_of(answer, item.text if item else "")
                waiting = item is not None and item.waiting
                marks.append(MarkedAnswer(place, number, problem.problem_type, answer, *verdict, waiting=waiting))
    return marks


def verdict_of(answer: Answer, text: str) -> tuple[str, float | None, Verdict, Cause | None]:
    """The text, its value in the unit of the key, the verdict, and the cause as far as the text alone tells it."""
    if answer.quantity.component == "sense" and text.strip() in SIGNS:
        value = SIGNS[text.strip()]
        return text, value, *((Verdict.RIGHT, None) if is_right(answer, value) else (Verdict.WRONG, Cause("sign")))
    if is_blank(text):
        return text, None, Verdict.BLANK, None
    number = read_number(text)
    if number is None:
        return text, None, Verdict.UNREADABLE, None
    values = number.in_unit(answer.unit)
    if values is None:
        other = Cause("dimension", number.unit.name if number.unit else "")
        return text, number.values[0], Verdict.WRONG, other
    right = next((value for value in values if is_right(answer, value)), None)
    if right is not None:
        return text, right, Verdict.RIGHT, None
    # Of several readings of a comma the one of the size of the answer is meant.
    nearest = min(values, key=lambda value: abs(math.log(abs(value / answer.value))) if value and answer.value else 0.0)
    return text, nearest, Verdict.WRONG, OTHER


def _with_causes(finished: Finished, key: Key, marks: Sequence[MarkedAnswer]) -> list[MarkedAnswer]:
    """The marks with the causes of what is wrong."""
    wrong: dict[tuple[int, int], list[MarkedAnswer]] = defaultdict(list)
    for item in marks:
        if item.verdict is Verdict.WRONG and item.cause == OTHER:
            wrong[item.place, item.problem].append(item)
    if not wrong:
        return list(marks)
    mistakes = mistakes_of(finished, wrong)
    classes = _classes(key)
    known: dict[tuple[int, str], Neighbours] = {}
    found: dict[tuple[int, int, str], Cause] = {}
    sheets = {place: _on_sheet(key, place) for place, _ in wrong}
    for (place, number), own in wrong.items():
        group = number, own[0].form
        if group not in known:
            known[group] = Neighbours({other: key.answers(other, number) for other in classes[group]})
        near = known[group].of(place, [(item.answer, item.value) for item in own if item.value is not None])
        for item in own:
            cause = _cause(item, sheets[place], mistakes[place, number])
            if near is not None and item.answer.quantity.name in near[1] and cause.name in ("other", "rounding"):
                cause = Cause("neighbour", key.record.sheets[near[0]].code)
            found[place, number, item.answer.quantity.name] = cause
    keys = ((item.place, item.problem, item.answer.quantity.name) for item in marks)
    return [replace(item, cause=found.get(own, item.cause)) for own, item in zip(keys, marks, strict=True)]


def _on_sheet(key: Key, place: int) -> dict[str, Answer]:
    """The answers of a student's sheet by ``problem.quantity``."""
    numbers = key.places[place]
    return {f"{number}.{own.quantity.name}": own for number in numbers for own in key.answers(place, number)}


def _cause(item: MarkedAnswer, sheet: Mapping[str, Answer], results: OfProblem) -> Cause:
    """The likeliest cause of one wrong answer."""
    assert item.value is not None, "a wrong answer has a value"
    name = item.answer.quantity.name
    siblings = dict(sheet)
    del siblings[f"{item.problem}.{name}"]
    mistakes, parts = results
    return cause_of(item.value, item.answer, Comparisons(siblings, parts[name], mistakes[name]))


def _following(finished: Finished, marks: Sequence[MarkedAnswer]) -> list[MarkedAnswer]:
    """The marks with the verdict of those answers that follow from earlier wrong ones of the same problem.

    None does where three or more are those of one neighbour's sheet: so much does not agree by chance.
    """
    found = list(marks)
    problems: dict[tuple[int, int], list[int]] = defaultdict(list)
    for i, item in enumerate(marks):
        problems[item.place, item.problem].append(i)
    groups: dict[tuple[str, tuple[Quantity, ...]], list[tuple[int, int]]] = defaultdict(list)
    wrong: dict[tuple[int, int], dict[int, float]] = {}
    for student, own in problems.items():
        values = {k: v for k, i in enumerate(own) if (v := marks[i].value) is not None and _is_wrong(marks[i])}
        if len(values) > 1 and sum(_is_copied(marks[i]) for i in own) < _COPIED:
            wrong[student] = values
            groups[marks[own[0]].form, tuple(marks[i].answer.quantity for i in own)].append(student)
    for (_, asked), students in groups.items():
        cases = [
            (finished.variant(*student), [marks[i].answer for i in problems[student]], wrong[student])
            for student in students
        ]
        for student, granted in zip(students, FollowThrough(asked).granted_to(cases), strict=True):
            own = problems[student]
            for k, earlier in granted.items():
                names = ", ".join(asked[other].name for other in earlier)
                cause = marks[own[k]].cause if _is_copied(marks[own[k]]) else Cause("from", names)  # a suspicion stays
                found[own[k]] = replace(found[own[k]], verdict=Verdict.FOLLOW_THROUGH, cause=cause)
    return found


def _is_copied(item: MarkedAnswer) -> bool:
    """Whether an answer is that of a neighbour's sheet."""
    return item.cause is not None and item.cause.name == "neighbour"


def _is_wrong(item: MarkedAnswer) -> bool:
    """Whether an answer is a number in a unit of its own kind that is not right."""
    return item.verdict is Verdict.WRONG and not (item.cause and item.cause.name == "dimension")


def _classes(key: Key) -> dict[tuple[int, str], list[int]]:
    """The places of the students who have a problem of a form, by the number of the problem and the form."""
    found: dict[tuple[int, str], list[int]] = defaultdict(list)
    for place, problems in key.places.items():
        for number, problem in problems.items():
            found[number, problem.problem_type].append(place)
    return found


def _with_points(item: MarkedAnswer, policy: MarkingPolicy, worth: Fraction) -> MarkedAnswer:
    """A mark with its points, and those it could have."""
    of = Fraction(0) if policy.is_struck(item.problem, item.answer.quantity.name) else worth
    share = Fraction(0)
    if item.verdict is Verdict.RIGHT:
        share = Fraction(1)
    elif item.verdict is Verdict.FOLLOW_THROUGH:
        share = Fraction(policy.follow_through)
    elif item.cause is not None:
        share = Fraction(policy.shares.get(item.cause.name, 0))
    return replace(item, points=share * of, of=of)


def _totals(
    key: Key,
    marks: Sequence[MarkedAnswer],
    policy: MarkingPolicy,
    by_hand: Mapping[tuple[int, int], Correction],
    left: list[NotMatched],
) -> list[StudentTotal]:
    """The sums of all students; ``by_hand`` are points given or taken, by student and problem.

    Where a problem has less points than it would have by them, or they are fewer than none, that is told in ``left``.
    """
    own: dict[int, list[MarkedAnswer]] = defaultdict(list)
    for item in marks:
        own[item.place].append(item)
    found = []
    for place, sheet in enumerate(key.record.sheets):
        problems: dict[int, Fraction] = defaultdict(Fraction)
        had: dict[int, Fraction] = defaultdict(Fraction)
        most = Fraction(0)
        for item in own[place]:
            problems[item.problem] += item.points
            had[item.problem] += item.of
            most += Fraction(0) if str(item.problem) in policy.bonus else item.of
        own_hand = {number: by_hand[place, number] for number in problems if (place, number) in by_hand}
        corrected = dict(problems)
        for number, (given, where) in own_hand.items():
            corrected[number] += given
            if not 0 <= corrected[number] <= had[number]:
                why = f"the problem has 0 to {float(had[number]):g} points: it cannot have {float(corrected[number]):g}"
                left.append(NotMatched(where, f"{number}: {float(given):+g}", why))
        by_problem, points = sums(corrected, had, policy)
        handed_in = sum(item.verdict is not Verdict.BLANK for item in own[place])
        waiting = sum(item.waiting for item in own[place])
        grade = policy.grade(points, most)
        hand = {number: given for number, (given, _) in own_hand.items()}
        found.append(StudentTotal(sheet.student, sheet.code, by_problem, points, most, grade, handed_in, waiting, hand))
    return found
