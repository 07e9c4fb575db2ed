"""The ceiling that an exam file sets to tolerances: who would need more on what is asked draws again.

Draws do not depend on it: everyone takes the first of their own draws that keeps within it, so that without a ceiling,
or with a higher one, nobody has other data than those who never met it.
"""

from __future__ import annotations

from collections import Counter
from collections.abc import Callable, Sequence

import numpy as np

from variantgen.errors import InputError, Problem
from variantgen.exam.answer_tolerances import AnswerTolerances
from variantgen.exam.sheets import batches_of, solve_all
from variantgen.families.quantities import Quantity
from variantgen.variants.attempts import MAX_ATTEMPTS
from variantgen.variants.variant import Variant

_HOPELESS = 200  # draws of a problem for each that keeps within the ceiling

Next = Callable[[Sequence[int], Sequence[int]], list[Variant]]  # the next draws of some owners after used attempts


def within(
    ceiling: float,
    answer_tolerances: AnswerTolerances,
    first: Sequence[Variant],
    asked: Callable[[int, Variant], list[Quantity]],
    problem: Sequence[int],
    more: Next,
) -> list[Variant]:
    """For each owner 0 .. N-1 the first of their draws on which what is asked needs no more than the ceiling.

    ``first`` are their first draws, ``problem`` the numbers of their problems. Raises InputError where next to no draw
    of a problem, or none of an owner, keeps within it.
    """
    found, left = list(first), list(range(len(first)))
    tried, good = Counter[int](), Counter[int]()
    while left:
        variants = [found[i] for i in left]
        passed = _keep(ceiling, answer_tolerances, variants, [asked(i, found[i]) for i in left])
        tried.update(problem[i] for i in left)
        good.update(problem[i] for i, keeps in zip(left, passed, strict=True) if keeps)
        left = [i for i, keeps in zip(left, passed, strict=True) if not keeps]
        for i in left:
            if tried[problem[i]] > _HOPELESS * (1 + good[problem[i]]) or found[i].attempt > MAX_ATTEMPTS:
                raise _too_low(ceiling, problem[i], found[i].family.name, tried[problem[i]], good[problem[i]])
        if left:
            for i, variant in zip(left, more(left, [found[i].attempt for i in left]), strict=True):
                found[i] = variant
    return found


def _keep(
    ceiling: float,
    answer_tolerances: AnswerTolerances,
    variants: Sequence[Variant],
    asked: Sequence[Sequence[Quantity]],
) -> list[bool]:
    """Whether all tolerances of each variant are within the ceiling."""
    solved = solve_all(variants, asked)
    kept = [False] * len(variants)
    for (_, questions), members in batches_of(asked, solved).items():
        motion, places = solved[members[0]][0], [solved[i][1] for i in members]
        needed = answer_tolerances.tolerances([variants[i] for i in members], questions, motion, places)
        for i, keeps in zip(members, np.all(needed <= ceiling * (1 + 1e-9), axis=0).tolist(), strict=True):
            kept[i] = keeps
    return kept


def _too_low(ceiling: float, problem: int, family: str, tried: int, good: int) -> InputError:
    share = f"{good or 'none'} of {tried} draws of problem {problem} ({family})"
    return InputError(
        Problem(
            f"{share} can be worked out by hand with tolerances up to {100 * ceiling:g} %",
            key="tolerance.ceiling",
            value=f"{ceiling:g}",
            remedy="raise the ceiling, or leave it out: then an answer has a wider tolerance where rounding needs it",
        )
    )
