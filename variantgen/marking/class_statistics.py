"""What the marks of a class tell: how hard problems and answers were, what they tell apart, which mistakes were made.

The share of a problem is the mean of points over what could be had; its discrimination the correlation of a student's
points in it with those in all other problems. Whether forms of a problem were equally hard is asked by a permutation
test of the sum of squares between their means: how many random exchanges of students between forms give as much.
"""

from __future__ import annotations

from collections import Counter, defaultdict
from collections.abc import Sequence
from dataclasses import dataclass

import numpy as np
from numpy.typing import NDArray

from variantgen.marking.causes import OTHER, Cause
from variantgen.marking.marks import Marked, MarkedAnswer, Verdict

_EXCHANGES = 9999
_FEWEST = 5  # students of a form with whom a comparison makes sense


@dataclass(frozen=True)
class AnswerFacts:
    """An answer of a problem: how many students were asked for it, how many verdicts of each kind, its share."""

    quantity: str
    asked: int
    verdicts: dict[str, int]
    share: float


@dataclass(frozen=True)
class ProblemFacts:
    """A problem, or one form of it (then ``form`` is its name): students, share, discrimination (None: no number).

    ``causes`` are the commonest causes of wrong answers with how often they were met.
    """

    number: int
    form: str
    students: int
    share: float
    discrimination: float | None
    answers: tuple[AnswerFacts, ...]
    causes: tuple[tuple[Cause, int], ...]


@dataclass(frozen=True)
class ClassFacts:
    """All problems, their forms, and by problem the probability that forms of equal difficulty differ as much."""

    students: int
    handed_in: int
    problems: tuple[ProblemFacts, ...]
    forms: tuple[ProblemFacts, ...]
    equal_forms: dict[int, float]
    shares: tuple[float, ...]  # of each student who handed in, in all points


def class_facts(marked: Marked) -> ClassFacts:
    """The facts of those who handed in anything."""
    present = {total.code for total in marked.totals if total.handed_in}
    codes = [total.code for total in marked.totals]
    marks = [item for item in marked.marks if codes[item.place] in present]
    totals = [total for total in marked.totals if total.handed_in]
    by_problem: dict[int, list[MarkedAnswer]] = defaultdict(list)
    by_form: dict[tuple[int, str], list[MarkedAnswer]] = defaultdict(list)
    for item in marks:
        by_problem[item.problem].append(item)
        by_form[item.problem, item.form].append(item)
    several = {number for number, _ in by_form if sum(other == number for other, _ in by_form) > 1}
    shares = [float(total.points / total.of) for total in totals if total.of]
    return ClassFacts(
        len(marked.totals),
        len(totals),
        tuple(_problem(number, "", own, marks) for number, own in sorted(by_problem.items())),
        tuple(
            _problem(number, form, own, marks) for (number, form), own in sorted(by_form.items()) if number in several
        ),
        {number: p for number in sorted(several) if (p := _equal(by_problem[number])) is not None},
        tuple(shares),
    )


def _problem(number: int, form: str, own: Sequence[MarkedAnswer], marks: Sequence[MarkedAnswer]) -> ProblemFacts:
    here = _points(own)
    rest = _points([item for item in marks if item.problem != number])
    pairs = np.array([(points, rest[place]) for place, points in here.items() if place in rest], dtype=float)
    by_answer: dict[str, list[MarkedAnswer]] = defaultdict(list)
    for item in own:
        by_answer[item.answer.quantity.name].append(item)
    wrong = (item.cause for item in own if item.verdict is Verdict.WRONG and item.cause not in (None, OTHER))
    # Mistakes are told apart; of others the kind is enough, not whose sheet or which answer.
    causes = Counter(cause if cause is None or cause.name == "mistake" else Cause(cause.name) for cause in wrong)
    return ProblemFacts(
        number,
        form,
        len(here),
        _share(own),
        _correlation(pairs),
        tuple(
            AnswerFacts(name, len(items), dict(Counter(item.verdict.value for item in items)), _share(items))
            for name, items in by_answer.items()
        ),
        tuple((cause, count) for cause, count in causes.most_common(5) if cause is not None),
    )


def _points(marks: Sequence[MarkedAnswer]) -> dict[int, float]:
    """Points by the place of the student."""
    found: dict[int, float] = defaultdict(float)
    for item in marks:
        found[item.place] += float(item.points)
    return found


def _share(marks: Sequence[MarkedAnswer]) -> float:
    most = sum(item.of for item in marks)
    return float(sum(item.points for item in marks) / most) if most else 0.0


def _correlation(pairs: NDArray[np.float64]) -> float | None:
    """The correlation of two columns, shape (N, 2); None for fewer than three rows, and where one is constant."""
    if len(pairs) < 3 or np.any(np.ptp(pairs, axis=0) == 0):
        return None
    first, second = (column - column.mean() for column in pairs.T)
    return float(first @ second / np.sqrt((first @ first) * (second @ second)))


def _equal(marks: Sequence[MarkedAnswer]) -> float | None:
    """The permutation test over the forms of a problem; None where fewer than two forms have enough students."""
    form_of = {item.place: item.form for item in marks}
    points = _points(marks)
    sizes = Counter(form_of.values())
    places = [place for place in points if sizes[form_of[place]] >= _FEWEST]
    names = sorted({form_of[place] for place in places})
    if len(names) < 2:
        return None
    value = np.array([points[place] for place in places])
    group = np.array([names.index(form_of[place]) for place in places])
    random = np.random.Generator(np.random.Philox(0))
    found = _between(value, group, len(names))
    exceeded = sum(_between(random.permutation(value), group, len(names)) >= found - 1e-12 for _ in range(_EXCHANGES))
    return (exceeded + 1) / (_EXCHANGES + 1)


def _between(value: NDArray[np.float64], group: NDArray[np.intp], count: int) -> float:
    """The sum of squares between the means of groups; both arrays have the shape (N,)."""
    sizes = np.bincount(group, minlength=count)
    means = np.bincount(group, weights=value, minlength=count) / sizes
    return float(np.sum(sizes * (means - value.mean()) ** 2))
