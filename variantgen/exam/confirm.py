"""Confirmation of what goes on paper: every method that applies to a variant must give what the solver gives."""

from __future__ import annotations

from collections.abc import Sequence

from variantgen.families.quantities import Quantity
from variantgen.mechanism.motion import Motion
from variantgen.methods.by_groups.solve_groups import velocities
from variantgen.methods.groups.group import Group
from variantgen.methods.hand.evaluation import AGREES, deviations
from variantgen.methods.linkage.problem import task_of
from variantgen.methods.solution.book import Book
from variantgen.methods.steps.not_applicable import NOT_APPLICABLE
from variantgen.variants.attempts import VerificationError
from variantgen.variants.variant import Variant


def confirm(
    variants: Sequence[Variant],
    asked: Sequence[Sequence[Quantity]],
    solved: Sequence[tuple[Motion, int]],
    keys: Sequence[tuple[object, ...]],
) -> None:
    """Evaluate all methods of all variants; ``keys`` say how each was drawn (seed, student, problem).

    Raises VerificationError for the first variant on which a method deviates by more than 1e-9 of the largest velocity
    or acceleration, naming the method and the key.
    """
    batches: dict[int, list[int]] = {}
    for i, (motion, _) in enumerate(solved):
        batches.setdefault(id(motion), []).append(i)
    for members in batches.values():
        motion, place = solved[members[0]]
        every = tuple(dict.fromkeys(quantity for i in members for quantity in asked[i]))
        found = deviations(motion, _groups(variants[members[0]], motion, place, every))
        for name, worst in found.items():
            for i in members:
                if not worst[solved[i][1]] <= AGREES:
                    raise _disagreement(variants[i], name, float(worst[solved[i][1]]), keys[i])


def _groups(variant: Variant, motion: Motion, place: int, asked: tuple[Quantity, ...]) -> list[Group]:
    """The groups of a solution. They follow from names alone, so the form remembers them."""
    known = variant.form.remembered
    if ("groups", asked) not in known:
        try:
            known["groups", asked] = velocities(Book(task_of(variant, motion, place, asked)))
        except NOT_APPLICABLE:  # what needs no groups is confirmed all the same
            known["groups", asked] = []
    found: list[Group] = known["groups", asked]
    return found


def _disagreement(variant: Variant, method: str, deviation: float, key: tuple[object, ...]) -> VerificationError:
    data = ", ".join(f"{name}={value}" for name, value in variant.printed.items())
    return VerificationError(
        f"{variant.family.name}: the method {method} deviates from the solver by {deviation:.1e}"
        f" (seed, student, problem: {', '.join(map(str, key))})" + (f" for {data}" if data else "")
    )
