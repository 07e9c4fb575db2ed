"""Whether the sheet of a neighbour is found by wrong numbers taken from it, and by no others."""

from __future__ import annotations

from collections import Counter
from collections.abc import Iterator, Sequence

import numpy as np

from benchmarks.planted_answers import written
from variantgen.exam.sheets import Answer
from variantgen.marking.diagnosis.neighbours import Neighbours
from variantgen.marking.key import is_right

_MANY = 4  # wrong numbers, of which one is altered
_ALTERED = 1.37


def neighboured(answers: Sequence[Sequence[Answer]], counts: Counter[str]) -> None:
    """Count how often the sheet of the next student, solved in place of the own one, is found."""
    near = Neighbours(dict(enumerate(answers)))
    for place, own in enumerate(answers):
        other = (place + 1) % len(answers)
        numbers = [answer for answer in own if answer.quantity.component != "sense"]
        wrong = _wrong(numbers, [theirs.value for theirs in next(_chosen([answers[other]], numbers))])
        if len({round(abs(value), 9) for _, value in wrong}) < 2:
            continue
        if any(
            all(abs(theirs.value - value) <= theirs.tolerance for theirs, (_, value) in zip(sheet, wrong, strict=True))
            for k, sheet in enumerate(_chosen(answers, [answer for answer, _ in wrong]))
            if k not in (place, other)
        ):
            counts["neighbour alike"] += 1  # the numbers are those of a third student too: nobody can tell
            continue
        counts["neighbour"] += 1
        counts["neighbour, named"] += near.of(place, wrong) == (
            other,
            frozenset(answer.quantity.name for answer, _ in wrong),
        )


def altered(answers: Sequence[Sequence[Answer]], counts: Counter[str]) -> None:
    """Count how often the sheet of the next student is found with one of its numbers altered, and by random numbers."""
    near = Neighbours(dict(enumerate(answers)))
    random = np.random.Generator(np.random.Philox(2))
    for place, own in enumerate(answers):
        other = (place + 1) % len(answers)
        numbers = [answer for answer in own if answer.quantity.component != "sense"]
        wrong = _wrong(numbers, [theirs.value for theirs in next(_chosen([answers[other]], numbers))])
        if len({round(abs(value), 9) for _, value in wrong}) == len(wrong) >= _MANY:
            changed = random.integers(len(wrong))
            wrong[changed] = wrong[changed][0], written(_ALTERED * wrong[changed][1])
            found = near.of(place, wrong)
            counts["altered"] += 1
            counts["altered, named"] += found is not None and found[0] == other
        chance = _wrong(numbers, [answer.value * 10.0 ** random.uniform(-1.0, 1.0) for answer in numbers])
        counts["innocent"] += 1
        counts["innocent, suspected"] += near.of(place, chance) is not None


def _wrong(answers: Sequence[Answer], values: Sequence[float]) -> list[tuple[Answer, float]]:
    """The answers with these numbers, as written, that are not right."""
    return [
        (answer, written(value))
        for answer, value in zip(answers, values, strict=True)
        if value and not is_right(answer, written(value))
    ]


def _chosen(answers: Sequence[Sequence[Answer]], asked: Sequence[Answer]) -> Iterator[list[Answer]]:
    """The answers of all students to what is asked in some of one sheet."""
    names = [answer.quantity for answer in asked]
    for sheet in answers:
        own = {answer.quantity: answer for answer in sheet}
        yield [own[name] for name in names]
