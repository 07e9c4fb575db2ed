"""The printed numbers of a solution: as few digits as lead a reader with a calculator to the answers of the key."""

from __future__ import annotations

from collections.abc import Iterable, Sequence

from variantgen.algebra.expression import Value, rounded
from variantgen.algebra.name import Name
from variantgen.algebra.values import in_order, parts
from variantgen.methods.steps.step import (
    ChainGraph,
    Derived,
    EquationLine,
    Fact,
    Item,
    LinearSystem,
    NumberOf,
    ProgramListing,
    Projection,
    Sentence,
    TermTable,
    VectorLine,
)

FEWEST, MOST = 5, 9  # significant digits of intermediate results
DIGITS = range(FEWEST, MOST + 1)
ANSWER_DIGITS = 4  # significant digits of an answer


def choose_printed_digits(items: Iterable[Item], answers: Sequence[Value], tried: Sequence[int] = DIGITS) -> int:
    """Give every value its printed number; returns the digits of intermediate results.

    All numbers are computed from printed ones. As many digits are taken as it needs for the answers to come out as in
    the key, which is computed in full precision, but at most the last of the numbers of digits that are ``tried``.
    """
    values = in_order([*items_values(items), *answers])
    for digits in tried:
        for value in values:
            value.round_to(digits)
        if all(_agrees(answer) for answer in answers):
            return digits
    return tried[-1]


def _agrees(answer: Value) -> bool:
    return rounded(answer.shown, ANSWER_DIGITS) == rounded(answer.exact, ANSWER_DIGITS)


def items_values(items: Iterable[Item]) -> list[Value]:
    """The values that items show."""
    found: list[Value] = []
    for item in items:
        match item:
            case Sentence():
                found += facts_values(item)
            case Derived(value):
                found.append(value)
            case VectorLine():
                pass
            case TermTable(terms):
                for term in terms:
                    found += [term.angle, *([term.size] if term.size is not None else []), *facts_values(term.way)]
            case Projection(axis, left, right):
                found += facts_values(axis)
                found += [share.angle for share in (*left, *right) if share.angle is not None]
            case LinearSystem(unknowns, rows, right_side):
                found += [*unknowns, *(value for row in rows for value in row), *right_side]
            case EquationLine(first, second):
                found += [*parts(first), *parts(second)]
            case ProgramListing(_, results):
                found += results
            case ChainGraph(_, legs):
                found += [leg.angle for leg in legs]
    return found


def facts_values(sentence: Sentence) -> list[Value]:
    """Values among the facts of a sentence."""
    found: list[Value] = []
    waiting: list[Fact] = list(sentence.facts.values())
    while waiting:
        fact = waiting.pop()
        if isinstance(fact, Value):
            found.append(fact)
        elif isinstance(fact, NumberOf):
            found.append(fact.value)
        elif isinstance(fact, Sentence):
            waiting += fact.facts.values()
        elif isinstance(fact, tuple) and not isinstance(fact, Name):
            waiting += fact
    return found
