"""What the marks of a class tell: how hard problems and answers were, what they tell apart, which mistakes were made.

The share of a problem is the mean of points over what could be had; its discrimination the correlation of a student's
points in it with those in all other problems. Whether forms of a problem, or the figure and its mirror image, were
equally hard is asked by a permutation test of the sum of squares between their means: how many random exchanges of
students between them give as much. For an answer, right or not, of two forms it is Fisher's exact test, which needs no
random numbers.
"""

from __future__ import annotations

from collections import Counter, defaultdict
from collections.abc import Collection, Iterator, Mapping, Sequence
from itertools import combinations
from math import exp, fsum, lgamma

import numpy as np
from msgspec import Struct
from numpy.typing import NDArray

from variantgen.marking.diagnosis.causes import OTHER, Cause
from variantgen.marking.marks import Marked, MarkedAnswer, Verdict

_EXCHANGES = 9999
_EXCHANGED = 1_000_000  # students in all exchanges
_FEWEST = 5  # students of a form with whom a comparison makes sense, or with one and the same mistake
_ADVISED = 10  # students of a problem of whom advice makes sense
_HARDLY = 0.05  # share of points
_UNLIKELY = 0.01
_ALIKE = 1e-7  # relative difference of probabilities that are the same but for rounding


class AnswerFacts(Struct, frozen=True):
    """An answer of a problem: how many students were asked for it, how many verdicts of each kind, its share."""

    quantity: str
    asked: int
    verdicts: dict[str, int]
    share: float


class ProblemFacts(Struct, frozen=True):
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


class Uneven(Struct, frozen=True):
    """An answer that was right more often in one form than in another: how often in each, and Fisher's probability."""

    number: int
    quantity: str
    forms: tuple[str, str]
    right: tuple[tuple[int, int], tuple[int, int]]  # of each form: right, others
    probability: float


class Advice(Struct, frozen=True):
    """What should be looked at: ``strike`` or ``teach``; of a problem ('' for the quantity) or an answer, and why."""

    kind: str
    number: int
    quantity: str
    cause: Cause | None = None


class ClassFacts(Struct, frozen=True):
    """All problems, their forms, and by problem the probability that forms of equal difficulty differ as much."""

    students: int
    handed_in: int
    problems: tuple[ProblemFacts, ...]
    forms: tuple[ProblemFacts, ...]
    equal_forms: dict[int, float]
    mirrored: dict[int, float]  # by problem: as the forms, for the figure and its mirror image
    uneven: tuple[Uneven, ...]
    advice: tuple[Advice, ...]
    shares: tuple[float, ...]  # of each student who handed in, in all points


def class_facts(marked: Marked, mirrored: Collection[tuple[int, int]] = ()) -> ClassFacts:
    """The facts of those who handed in anything; ``mirrored`` are the places and problems with a mirrored figure."""
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
    points = {number: _points(own) for number, own in by_problem.items()}
    problems = tuple(_problem(number, "", own, points) for number, own in sorted(by_problem.items()))
    forms = {(item.place, item.problem): item.form for item in marks}
    sides = {key: "mirrored" if key in mirrored else "" for key in forms}
    return ClassFacts(
        len(marked.totals),
        len(totals),
        problems,
        tuple(
            _problem(number, form, own, points) for (number, form), own in sorted(by_form.items()) if number in several
        ),
        _equal_ones(by_problem, forms),
        _equal_ones(by_problem, sides),
        tuple(_uneven(by_form, sorted(several))),
        tuple(_advice(problems, marks)),
        tuple(shares),
    )


def _problem(
    number: int, form: str, own: Sequence[MarkedAnswer], points: Mapping[int, Mapping[int, float]]
) -> ProblemFacts:
    """The facts of a problem or of a form; ``points`` are those of all problems by number and place of the student."""
    here = {item.place for item in own}
    others = [by_place for other, by_place in points.items() if other != number]
    pairs = np.array(
        [
            (points[number][place], sum(by_place.get(place, 0.0) for by_place in others))
            for place in here
            if any(place in by_place for by_place in others)
        ],
        dtype=float,
    )
    by_answer: dict[str, list[MarkedAnswer]] = defaultdict(list)
    for item in own:
        by_answer[item.answer.quantity.name].append(item)
    wrong = (item.cause for item in own if item.verdict is Verdict.WRONG and item.cause not in (None, OTHER))
    causes = Counter(_kind(cause) for cause in wrong if cause is not None)
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
        tuple(causes.most_common(5)),
    )


def _points(marks: Sequence[MarkedAnswer]) -> dict[int, float]:
    """Points by the place of the student."""
    found: dict[int, float] = defaultdict(float)
    for item in marks:
        found[item.place] += float(item.points)
    return found


def _share(marks: Sequence[MarkedAnswer]) -> float:
    most = fsum(float(item.of) for item in marks)
    return fsum(float(item.points) for item in marks if item.points) / most if most else 0.0


def _correlation(pairs: NDArray[np.float64]) -> float | None:
    """The correlation of two columns, shape (N, 2); None for fewer than three rows, and where one is constant."""
    if len(pairs) < 3 or np.any(np.ptp(pairs, axis=0) == 0):
        return None
    first, second = (column - column.mean() for column in pairs.T)
    return float(first @ second / np.sqrt((first @ first) * (second @ second)))


def _uneven(by_form: Mapping[tuple[int, str], Sequence[MarkedAnswer]], numbers: Sequence[int]) -> Iterator[Uneven]:
    """The answers that two forms of a problem ask for, where they differ more than chance makes one in a hundred."""
    for number in numbers:
        forms = sorted(form for other, form in by_form if other == number)
        tables = {form: _right_and_others(by_form[number, form]) for form in forms}
        pairs = [
            (first, second, name)
            for first, second in combinations(forms, 2)
            for name in tables[first].keys() & tables[second].keys()
        ]
        for first, second, name in sorted(pairs):
            counts = tables[first][name], tables[second][name]
            probability = _exact_test(counts)
            if probability * len(pairs) < _UNLIKELY:  # of so many questions one is answered wrongly by chance
                yield Uneven(number, name, (first, second), counts, probability)


def _exact_test(counts: tuple[tuple[int, int], tuple[int, int]]) -> float:
    """Fisher's exact test: how probable it is that chance parts right ones as unevenly, or more, with these sums."""
    (right, others), (second_right, second_others) = counts
    size, all_right = right + others, right + second_right
    whole = size + second_right + second_others
    fewest = max(0, size + all_right - whole)
    ways = {
        k: exp(_log_ways(all_right, k) + _log_ways(whole - all_right, size - k) - _log_ways(whole, size))
        for k in range(fewest, min(size, all_right) + 1)
    }
    return fsum(share for share in ways.values() if share <= ways[right] * (1.0 + _ALIKE))


def _log_ways(whole: int, part: int) -> float:
    """The logarithm of the number of ways to choose a part."""
    return lgamma(whole + 1) - lgamma(part + 1) - lgamma(whole - part + 1)


def _right_and_others(marks: Sequence[MarkedAnswer]) -> dict[str, tuple[int, int]]:
    """How often each answer was right, and how often not."""
    found: dict[str, list[int]] = defaultdict(lambda: [0, 0])
    for item in marks:
        found[item.answer.quantity.name][item.verdict not in (Verdict.RIGHT, Verdict.FOLLOW_THROUGH)] += 1
    return {name: (right, others) for name, (right, others) in found.items()}


def _advice(problems: Sequence[ProblemFacts], marks: Sequence[MarkedAnswer]) -> Iterator[Advice]:
    """What to strike (hardly anybody has it, or the weaker have it rather), and what to teach again."""
    answers: dict[tuple[int, str], list[MarkedAnswer]] = defaultdict(list)
    for item in marks:
        answers[item.problem, item.answer.quantity.name].append(item)
    for problem in problems:
        if problem.students < _ADVISED:
            continue
        if problem.discrimination is not None and problem.discrimination < 0:
            yield Advice("strike", problem.number, "")
        for answer in problem.answers:
            own = answers[problem.number, answer.quantity]
            wrong = [m.cause for m in own if m.verdict is Verdict.WRONG and m.cause is not None]
            if answer.asked >= _ADVISED and not answer.verdicts.get("right") and answer.share < _HARDLY:
                yield Advice("strike", problem.number, answer.quantity)
            causes = Counter(_kind(cause) for cause in wrong if cause != OTHER)
            cause, count = causes.most_common(1)[0] if causes else (None, 0)
            if count >= _FEWEST and 5 * count >= answer.asked:
                yield Advice("teach", problem.number, answer.quantity, cause)


def _kind(cause: Cause) -> Cause:
    """Mistakes are told apart; of others the kind is enough, not whose sheet or which answer."""
    return cause if cause.name == "mistake" else Cause(cause.name)


def _equal_ones(
    by_problem: Mapping[int, Sequence[MarkedAnswer]], kinds: Mapping[tuple[int, int], str]
) -> dict[int, float]:
    """By problem the probability that its kinds, equally hard, differ as much."""
    found = ((number, _equal(own, kinds)) for number, own in sorted(by_problem.items()))
    return {number: probability for number, probability in found if probability is not None}


def _equal(marks: Sequence[MarkedAnswer], kinds: Mapping[tuple[int, int], str]) -> float | None:
    """The permutation test over the kinds of a problem; None where fewer than two have enough students."""
    form_of = {item.place: kinds[item.place, item.problem] for item in marks}
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
    exchanges = max(min(_EXCHANGES, _EXCHANGED // len(value)), _EXCHANGES // 10)  # many students tell enough by fewer
    exceeded = sum(_between(random.permutation(value), group, len(names)) >= found - 1e-12 for _ in range(exchanges))
    return (exceeded + 1) / (exchanges + 1)


def _between(value: NDArray[np.float64], group: NDArray[np.intp], count: int) -> float:
    """The sum of squares between the means of groups; both arrays have the shape (N,)."""
    sizes = np.bincount(group, minlength=count)
    means = np.bincount(group, weights=value, minlength=count) / sizes
    return float(np.sum(sizes * (means - value.mean()) ** 2))
