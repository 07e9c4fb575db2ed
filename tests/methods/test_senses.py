"""Vectors of unknown magnitude point to the side to which the solved motion makes them point; none is negative."""

from __future__ import annotations

import cmath
import math

import pytest

from tests.methods.applying import cases
from tests.methods.forms import tasks
from variantgen.methods.compose import solution
from variantgen.methods.linkage.problem import Task
from variantgen.methods.solved_motion import SolvedMotion
from variantgen.methods.steps.step import Derived, Item, Projection, Term, TermTable, VectorLine

METHODS = ("velocity_pole", "projections", "velocity_centre", "acceleration_pole", "acceleration_centre")
CASES, IDS = cases(*METHODS, "relative_motion", "graphical")
SEEDS = 4
_FREE = "ways.unknown"  # the vector that a sum gives: not even its direction is known


def unknowns(item: Item) -> list[Term]:
    """The vectors of unknown magnitude in an equation."""
    match item:
        case VectorLine(left, right):
            terms = [*left, *right]
        case TermTable(found):
            terms = list(found)
        case Projection(_, left, right):
            terms = [share.term for share in (*left, *right)]
        case _:
            terms = []
    return [term for term in terms if term.size is None and term.way.key != _FREE]


def wrong_senses(task: Task, method: str) -> tuple[list[str], int]:
    """Vectors that point to the wrong side, magnitudes that are negative; and how many vectors there were."""
    motion, wrong, count = SolvedMotion(task), [], 0
    for step in solution(task, (method,)).steps:
        sought = set()
        for item in step.items:
            for term in unknowns(item):
                sought.add(term.name)
                count += 1
                way = cmath.rect(1.0, math.radians(term.angle.exact))
                vectors = motion.vectors(term.name)
                if vectors and max((vector / way).real for vector in vectors) < -1e-9 * max(map(abs, vectors)):
                    wrong.append(f"{term.name} points backwards")
            if isinstance(item, Derived) and item.value.name in sought and item.value.exact < 0:
                wrong.append(f"{item.value.name} is negative")
    return wrong, count


@pytest.mark.parametrize(("name", "form", "method"), CASES, ids=IDS)
def test_unknown_vectors_point_to_their_true_side(name: str, form: str, method: str) -> None:
    for task in tasks(name, form, SEEDS):
        assert wrong_senses(task, method)[0] == []


def test_there_are_unknown_vectors() -> None:
    assert wrong_senses(tasks("slider_crank", "offset", 1)[0], "velocity_pole")[1] >= 2
