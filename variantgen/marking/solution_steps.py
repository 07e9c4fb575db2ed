"""The step of a worked solution in which an answer is found: what a student should read who has it wrong."""

from __future__ import annotations

from collections.abc import Sequence

from variantgen.algebra.expression import Value
from variantgen.algebra.values import in_order
from variantgen.errors import InputError
from variantgen.exam.exam import Exam, ExamProblem
from variantgen.exam.sheets import Answer
from variantgen.families.quantities import motion_order
from variantgen.methods.compose import solution
from variantgen.methods.linkage.problem import task_of
from variantgen.methods.solution_options import SolutionOptions
from variantgen.methods.steps.not_applicable import NOT_APPLICABLE
from variantgen.methods.steps.step import Derived, LinearSystem, Solution
from variantgen.variants.variant import Variant, solve_variants
from variantgen.wording.solution.document import Section
from variantgen.wording.solution.explain import written


def sections_of(
    exam: Exam, task: ExamProblem, variant: Variant, answers: Sequence[Answer], wrong: Sequence[int]
) -> dict[int, Section]:
    """The steps that lead to some answers, by the number of the step from 1 on; {} where no method leads to them.

    ``wrong`` are the places of these answers among all of the problem. The language is that of the sheets; sentences
    that only explain are left out.
    """
    asked = [answer.quantity for answer in answers]
    own = task_of(variant, solve_variants([variant], motion_order(asked)), 0, asked)
    try:
        found = solution(own, SolutionOptions(task.methods).methods)
    except NOT_APPLICABLE:
        return {}
    except InputError:  # a method of the exam file does not apply to this variant
        return {}
    places = {place for answer in wrong if (place := _step_of(found, found.answers[answer][1])) is not None}
    text = written(own, found, exam.spoken, short=True)
    return {place + 1: text.sections[place] for place in sorted(places)}


def _step_of(found: Solution, answer: Value) -> int | None:
    """The place of the last step that works an answer out, or a value that it is another name of."""
    for value in reversed(in_order([answer])):  # what it is made of comes before it
        for place in reversed(range(len(found.steps))):
            for item in found.steps[place].items:
                if isinstance(item, Derived) and item.value is value:
                    return place
                if isinstance(item, LinearSystem) and any(unknown is value for unknown in item.unknowns):
                    return place
    return None
