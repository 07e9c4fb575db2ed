"""What answers are worth: the points of their problems, in equal parts."""

from __future__ import annotations

from collections import defaultdict
from collections.abc import Mapping
from fractions import Fraction

from variantgen.errors import InputError, Problem
from variantgen.exam.sections.marking_policy import MarkingPolicy, rounded
from variantgen.finished.restore import Finished
from variantgen.marking.key import Key


def worth_of(finished: Finished, key: Key, policy: MarkingPolicy) -> dict[tuple[int, int], Fraction]:
    """The points of an answer, by student and problem: those of the problem in equal parts of what counts in it.

    Raises InputError for steps of rounding that are larger than the points.
    """
    most = {
        number: max(len(own[number].answers) for own in key.places.values() if number in own) for number in key.asked
    }
    usual = {task.number: task.points for task in finished.exam.tasks}
    found = {}
    for place, problems in key.places.items():
        for number, problem in problems.items():
            counted = [a for a in problem.answers if not policy.is_struck(number, a.quantity)]
            points = Fraction(policy.points.get(number, usual.get(number) or most[number]))
            found[place, number] = points / len(counted) if counted else Fraction(0)
    _check_steps(policy, key, found)
    return found


def _check_steps(policy: MarkingPolicy, key: Key, worth: Mapping[tuple[int, int], Fraction]) -> None:
    """Raise InputError where points are rounded to a step larger than all there are."""
    most: dict[int, dict[int, Fraction]] = defaultdict(dict)
    for (place, number), one in worth.items():
        counted = sum(not policy.is_struck(number, a.quantity) for a in key.places[place][number].answers)
        most[place][number] = one * counted
    single = max((points for own in most.values() for points in own.values()), default=Fraction(0))
    whole = max((sum(own.values(), Fraction(0)) for own in most.values()), default=Fraction(0))
    if problems := [
        Problem(f"the step is larger than the points of {what}", key=f"rounding.{name}", value=str(step))
        for name, step, points, what in (
            ("problem", policy.problem_step, single, "every problem"),
            ("total", policy.total_step, whole, "the exam"),
        )
        if points and step > points
    ]:
        raise InputError(problems)


def sums(
    points: Mapping[int, Fraction], most: Mapping[int, Fraction], policy: MarkingPolicy
) -> tuple[dict[int, Fraction], Fraction]:
    """The points of a student by problem, in the steps of the rules and within what each is worth, and their sum."""
    by_problem = {
        number: max(min(rounded(own, policy.problem_step), most[number]), Fraction(0)) for number, own in points.items()
    }
    total = rounded(sum(by_problem.values(), Fraction(0)), policy.total_step)
    return by_problem, min(total, sum(most.values(), Fraction(0)))
