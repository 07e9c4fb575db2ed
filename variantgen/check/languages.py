"""Whether the statements of a variant in different languages say the same."""

from __future__ import annotations

from collections import Counter
from collections.abc import Iterator, Mapping, Sequence
from difflib import SequenceMatcher
from itertools import combinations
from typing import NamedTuple

from variantgen.check.statement_reading import PrintedNumber, StatementReading
from variantgen.families.family import Form

_LONGEST = 150  # names in a text whose order is compared; the longest of the catalogue has 20


class Difference(NamedTuple):
    """What a statement says otherwise than that in another language; ``sure``: whether it is a mistake."""

    language: str
    kind: str
    message: str
    sure: bool = True


def differing(sheets: Sequence[StatementReading], given: Sequence[str], form: Form) -> Iterator[Difference]:
    """What the first language says otherwise than the others.

    ``given`` are the names of the printed data: what is said of them in one language is said in the others.
    """
    first = sheets[0]
    for other in sheets[1:]:
        for one, two in ((first, other), (other, first)):
            for name in given:
                if name in one.names and name not in two.names:
                    message = f"the text says nothing of {name}, that in {one.language} does"
                    yield Difference(two.language, f"unsaid {name}", message)
            others = Counter(map(_size, two.numbers))
            for datum in one.numbers:
                others[_size(datum)] -= 1
                if others[_size(datum)] < 0:
                    message = f"the text says {datum.written}, that in {two.language} does not"
                    yield Difference(one.language, f"number {_size(datum)}", message)
        for name in sorted(first.data.keys() & other.data.keys()):
            if {_size(datum) for datum in first.data[name]} != {_size(datum) for datum in other.data[name]}:
                message = f"{name} is {_written(other, name)} here, and {_written(first, name)} in {first.language}"
                yield Difference(other.language, f"datum {name}", message)
        yield from _exchanged(first, other, form)


def _size(datum: PrintedNumber) -> str:
    return f"{datum.value:.9g} {datum.measures}"


def _written(sheet: StatementReading, name: str) -> str:
    return " and ".join(dict.fromkeys(datum.written for datum in sheet.data[name]))


def _exchanged(first: StatementReading, other: StatementReading, form: Form) -> Iterator[Difference]:
    """Two names of which the second text says what the first says of the other one.

    What tells are the nouns before them (the rod BC, the rocker CD). Where these do not tell them apart, it is the
    order of all names, if it becomes more alike when the two are exchanged; of points alone that is no proof.
    """
    if max(len(first.mentions), len(other.mentions)) > _LONGEST:
        return
    both = [name for name in dict.fromkeys(first.names) if name in other.names]
    alike = {name: _kind(name, form) for name in both}
    called, recalled = _nouns(first), _nouns(other)
    for one, two in combinations(sorted(both), 2):
        if alike[one] != alike[two]:
            continue
        straight = [called[a] & recalled[a] for a in (one, two)]
        crossed = [called[a] & recalled[b] for a, b in ((one, two), (two, one))]
        proved = all(crossed) and not any(straight)
        untold = called[one] == called[two] and recalled[one] == recalled[two]
        if proved or (untold and _in_wrong_order(first, other, one, two)) or {one, two} == _crossed_once(first, other):
            message = f"{one} and {two} stand exchanged, compared with the text in {first.language}"
            yield Difference(other.language, message, message, proved or alike[one] != "point")


def _crossed_once(first: StatementReading, other: StatementReading) -> set[str]:
    """The names that stand in each other's place, if all others are in theirs and nouns do not tell why."""
    pairs = list(zip(first.mentions, other.mentions, strict=False))
    apart = [(one, two) for one, two in pairs if one.name != two.name]
    if len(first.mentions) != len(other.mentions) or len(apart) != 2:
        return set()
    (one, here), (two, there) = apart
    if (one.name, two.name) != (there.name, here.name):
        return set()
    distinguished = one.noun != two.noun and (one.noun, two.noun) == (there.noun, here.noun)
    return set() if distinguished else {one.name, two.name}


def _in_wrong_order(first: StatementReading, other: StatementReading, one: str, two: str) -> bool:
    """Whether the texts name the same in the same order once two names are exchanged in the second."""
    turned = {one: two, two: one}
    exchanged = [turned.get(name, name) for name in other.names]
    now, then = (SequenceMatcher(None, first.names, names, False).ratio() for names in (other.names, exchanged))
    return then > now and [n for n in first.names if n in turned] == [n for n in exchanged if n in turned]


def _kind(name: str, form: Form) -> str:
    """Names that could be taken for each other: parameters of one measure, points, bodies and lines."""
    parameter = form.parameters.get(name)
    if parameter is not None and parameter.unit is not None and parameter.unit.measures != "length":
        return parameter.unit.measures
    return "point" if name in form.points else "length"


def _nouns(sheet: StatementReading) -> Mapping[str, set[str]]:
    """The nouns that stand before each name."""
    found: dict[str, set[str]] = {name: set() for name in sheet.names}
    for mention in sheet.mentions:
        if mention.noun:
            found[mention.name].add(mention.noun)
    return found
