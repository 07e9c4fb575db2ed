"""The printed numbers of a solution: four significant digits, of angles hundredths of a degree."""

from __future__ import annotations

from collections.abc import Collection, Iterable, Sequence

from variantgen.algebra.decimals import PRINTED_DIGITS
from variantgen.algebra.expression import Value
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
    Term,
    TermTable,
)


def choose_printed_digits(items: Iterable[Item], answers: Sequence[Value]) -> None:
    """Give every value its printed number, of four significant digits.

    A sum of angles is that of the printed ones, ``56.85 + 13.60 = 70.45`` where the angle itself is 70.456, if every
    line that it leads to still comes out; not an answer, which is printed as in the key.
    """
    values = in_order([*items_values(items), *answers])
    for value in values:
        value.round_to(PRINTED_DIGITS)
    led_to: dict[Value, list[Value]] = {}
    for value in values:
        for part in made_of(value):
            led_to.setdefault(part, []).append(value)
    named = {value.name for value in answers}
    for value in values:
        if value.is_sum_of_angles and not value.comes_out and value.name not in named:
            _close(value, led_to.get(value, ()))


def _close(value: Value, led_to: Collection[Value]) -> None:
    """Print a sum of angles as that of the printed ones, unless a line that came out would not any more."""
    before, came_out = value.shown, [line for line in led_to if line.comes_out and not line.is_sum_of_angles]
    value.round_to(PRINTED_DIGITS, exact=False)
    if not all(line.comes_out for line in came_out):
        value.shown = before


def follow_printed_digits(items: Iterable[Item], answers: Sequence[Value], digits: int) -> None:
    """Give every value its number with so many digits from the printed ones before it, as on a plan one measures."""
    for value in in_order([*items_values(items), *answers]):
        value.round_to(digits, exact=False)


def items_values(items: Iterable[Item]) -> list[Value]:
    """The values that items show."""
    return [value for item in items for value in shown_values(item)]


def shown_values(item: Item) -> tuple[Value, ...]:
    """The values that an item shows; found once, because every pass over a solution asks it."""
    known = vars(item)
    if "shown" not in known:
        known["shown"] = tuple(_shown_values(item))
    found: tuple[Value, ...] = known["shown"]
    return found


def _shown_values(item: Item) -> Iterable[Value]:
    match item:
        case Sentence():
            return facts_values(item)
        case Derived(value):
            return (value,)
        case TermTable(terms):
            return (value for term in terms for value in _term_values(term))
        case Projection(words, left, right):
            angles = [share.angle for share in (*left, *right) if share.angle is not None]
            return (*(value for sentence in words for value in facts_values(sentence)), *angles)
        case Balance(left_value, right_value):
            return (left_value, right_value)
        case Ascending(values):
            return values
        case LinearSystem(unknowns, rows, right_side):
            return (*unknowns, *(value for row in rows for value in row), *right_side)
        case EquationLine(first, second):
            return (*parts(first), *parts(second))
        case ProgramListing(_, results):
            return results
    return ()


def _term_values(term: Term) -> list[Value]:
    return [term.angle, *([term.size] if term.size is not None else []), *facts_values(term.way)]


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
        elif type(fact) is tuple:
            waiting += fact
    return found
