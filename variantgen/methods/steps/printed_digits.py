"""The printed numbers of a solution: four significant digits, of angles hundredths of a degree."""

from __future__ import annotations

from collections.abc import Iterable, Sequence

from variantgen.algebra.decimals import PRINTED_DIGITS
from variantgen.algebra.expression import Value
from variantgen.algebra.name import Name
from variantgen.algebra.values import in_order, made_of, parts
from variantgen.methods.steps.step import (
    Ascending,
    Balance,
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
from variantgen.methods.steps.step_geometry import ChainGraph


def choose_printed_digits(items: Iterable[Item], answers: Sequence[Value]) -> None:
    """Give every value its printed number, of four significant digits.

    Where a line does not come out by that, numbers in it that begin with a one have a digit more, ``1037.5 / 36.88``,
    if it then does, and they follow with it from the numbers before; not answers, which are printed as in the key.
    """
    values = in_order([*items_values(items), *answers])
    alike: dict[float, list[Value]] = {}
    for value in values:
        value.round_to(PRINTED_DIGITS)
        if f"{abs(value.exact):e}".startswith("1") and value.measure != "angle":
            alike.setdefault(abs(value.exact), []).append(value)
    for answer in answers:
        alike.pop(abs(answer.exact), None)
    longer: set[float] = set()
    for value in values:
        if not value.comes_out and value.expression is not None:
            sizes = {abs(part.exact) for part in made_of(value)} & alike.keys() - longer
            ones = [item for size in sizes for item in alike[size]]
            for item in ones:
                item.round_to(PRINTED_DIGITS + 1)
            if all(item.comes_out for item in (value, *ones)):
                longer |= sizes
            else:
                for item in ones:
                    item.round_to(PRINTED_DIGITS)


def follow_printed_digits(items: Iterable[Item], answers: Sequence[Value], digits: int) -> None:
    """Give every value its number with so many digits from the printed ones before it, as on a plan one measures."""
    for value in in_order([*items_values(items), *answers]):
        value.round_to(digits, exact=False)


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
            case Projection(words, left, right):
                found += [value for sentence in words for value in facts_values(sentence)]
                found += [share.angle for share in (*left, *right) if share.angle is not None]
            case Balance(left_value, right_value):
                found += [left_value, right_value]
            case Ascending(values):
                found += values
            case LinearSystem(unknowns, rows, right_side):
                found += [*unknowns, *(value for row in rows for value in row), *right_side]
            case EquationLine(first, second):
                found += [*parts(first), *parts(second)]
            case ProgramListing(_, results):
                found += results
            case ChainGraph():
                pass
    return found


def facts_values(sentence: Sentence) -> list[Value]:
    """Values among the facts of a sentence."""
    found: list[Value] = []
    waiting: list[Fact] = list(sentence.facts.values())
    while waiting:
        fact = waiting.pop()
        # Exact types: every pass over a solution comes here, and most facts are none of these.
        if type(fact) is Value:
            found.append(fact)
        elif type(fact) is NumberOf:
            found.append(fact.value)
        elif type(fact) is Sentence:
            waiting += fact.facts.values()
        elif type(fact) is tuple and not isinstance(fact, Name):
            waiting += fact
    return found
