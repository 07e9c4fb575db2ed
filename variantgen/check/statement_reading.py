"""A statement read back as a student reads it: names, what is said of them, numbers with their units."""

from __future__ import annotations

import re
from bisect import bisect_right
from collections.abc import Mapping, Sequence
from decimal import Decimal

from msgspec import Struct

from variantgen.check.vocabulary import vocabulary
from variantgen.families.family import Form
from variantgen.families.parameters.units import UNITS, Unit
from variantgen.wording.formula import Equation, Formula, Measured, Symbol, letters, to_plain
from variantgen.wording.language import Language
from variantgen.wording.statement import Statement

_SENTENCE, _CLAUSE = re.compile(r"[.;:]\s"), re.compile(r"[.;:,]\s")
_NUMBER = "(?P<number>[-\N{MINUS SIGN}]?\\d+(?:[.,]\\d+)?)"
_NAME = r"(?P<name>(?<![A-Za-z])[A-Za-z]\w*)"
_JOINING = re.compile(r"\W*(?:\w{1,3}\W+)?")  # what stands between two names of one noun: "the rods AB and BC"


class TextPosition(Struct, frozen=True, order=True):
    """A place in a text: the character, and which sentence and clause (as far as a comma) it lies in."""

    at: int
    sentence: int = 0
    clause: int = 0


class Mention(Struct, frozen=True):
    """A name in the text: its place, and the noun before it ("" where there is none)."""

    name: str
    place: TextPosition
    noun: str = ""


class Sense(Struct, frozen=True):
    """A word for a sense in the text: its key (``faster``), the word itself, its place."""

    key: str
    word: str
    place: TextPosition


class PrintedNumber(Struct, frozen=True):
    """A number with its unit: value in SI, what it measures, and as it is written."""

    value: float
    measures: str
    written: str


class StatementReading(Struct, frozen=True):
    """What a statement says in one language.

    ``mentions`` have the names of the family. ``data`` are the numbers by what is printed before them, in the list of
    data and in sentences like "OA = 32 cm"; ``numbers`` all that stand in the text with a unit.
    """

    language: str
    mentions: tuple[Mention, ...]
    senses: tuple[Sense, ...]
    data: Mapping[str, tuple[PrintedNumber, ...]]
    numbers: tuple[PrintedNumber, ...]

    @property
    def names(self) -> list[str]:
        """The names in the order of the text, each as often as it stands there."""
        return [mention.name for mention in self.mentions]


def read_sheet(problem_text: Statement, form: Form, language: Language) -> StatementReading:
    """Read a statement back: names as the family has them, numbers in SI."""
    words, known = vocabulary(language.name), _names(form, language)
    text, symbols = "", []
    for part in problem_text.text:
        written = part if isinstance(part, str) else _written(part)
        if isinstance(part, Symbol):
            symbols.append((len(text), len(text) + len(written), known.get(part, written)))
        text += written
    ends = [[match.end() for match in border.finditer(text)] for border in (_SENTENCE, _CLAUSE)]

    def place(at: int) -> TextPosition:
        return TextPosition(at, *(bisect_right(borders, at) for borders in ends))

    mentions: list[Mention] = []
    before = 0
    for start, end, name in symbols:
        between = text[before:start]
        last = max(
            ((match.start(), key) for key, noun in words.nouns.items() for match in noun.finditer(between)),
            default=(0, ""),
        )
        noun = last[1] or (mentions[-1].noun if mentions and _JOINING.fullmatch(between) else "")
        mentions.append(Mention(name, place(start), noun))
        before = end
    senses = tuple(
        Sense(key, match[0], place(match.start()))
        for key, pattern in words.senses.items()
        for match in pattern.finditer(text)
    )
    units = {to_plain(language.unit(unit)): unit for unit in UNITS.values() if unit.name != "1"}
    measured = rf"{_NUMBER}[ \N{{NO-BREAK SPACE}}]?(?P<unit>{'|'.join(map(re.escape, sorted(units, key=len)[::-1]))})"
    starts = {start for start, _, _ in symbols}  # the gear 1 is no number
    numbers = [
        datum
        for match in _find(measured + r"(?!\w)", text)
        for datum in _printed_number(match["number"], match["unit"], units)
        if match.start() not in starts and datum.measures != "time"  # the letter of the second is a word, too
    ]
    data = _listed_data(problem_text.given, form, known, units)
    for match in _find(rf"{_NAME}\W{{0,2}}(?:{words.equals})\s*{measured}(?!\w)", text):
        name = match["name"]
        data[name] = (*data.get(name, ()), *_printed_number(match["number"], match["unit"], units))
    return StatementReading(language.name, tuple(mentions), senses, data, tuple(numbers))


def _listed_data(
    given: Sequence[Equation], form: Form, known: Mapping[Symbol, str], units: Mapping[str, Unit]
) -> dict[str, tuple[PrintedNumber, ...]]:
    """The numbers of the list of data by what is printed before them."""
    data: dict[str, tuple[PrintedNumber, ...]] = {}
    for equation in given:
        if isinstance(equation.right, Measured) and isinstance(equation.left, Symbol):
            written = to_plain(equation.left)
            # Languages write other letters for the same; a length is known by its two points.
            name = written if two_points(written, form) else known.get(equation.left, written)
            found = _printed_number(equation.right.number.text, to_plain(equation.right.unit), units)
            data[name] = (*data.get(name, ()), *found)
    return data


def two_points(name: str, form: Form) -> tuple[str, str] | None:
    """The points of a length named by two of them (OA, O1A); None for other names."""
    ends = [letter + number for letter, number in letters(name)]
    if len(ends) == 2 and "".join(ends) == name and all(end in form.points for end in ends):
        return ends[0], ends[1]
    return None


def _names(form: Form, language: Language) -> dict[Symbol, str]:
    """Names of the family by the symbols that stand for them."""
    named = [(name, name) for name in (*form.points, *form.bodies)]
    named += [(parameter.symbol, name) for name, parameter in form.parameters.items()]
    return {language.symbol(written, form.symbols): name for written, name in named}


def _written(part: Formula) -> str:
    """A formula in the text; an equation has the number and unit of a line of data."""
    if isinstance(part, Equation):
        return f"{_written(part.left)} = {_written(part.right)}"
    return to_plain(part)


def _find(pattern: str, text: str) -> list[re.Match[str]]:
    return list(re.finditer(pattern, text))


def _printed_number(number: str, unit: str, units: Mapping[str, Unit]) -> tuple[PrintedNumber, ...]:
    if unit not in units:
        return ()
    value = Decimal(number.replace("\N{MINUS SIGN}", "-").replace(",", "."))
    return (PrintedNumber(units[unit].to_si(value), units[unit].measures, f"{number} {unit}"),)
