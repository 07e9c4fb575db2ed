"""The numbers on the sheet of a variant, as those that are told in words and as what changes with the file."""

from __future__ import annotations

import re
from collections.abc import Mapping, Sequence
from fractions import Fraction

from variantgen.check.statement_reading import read_sheet
from variantgen.families.quantities import Quantity
from variantgen.variants.variant import Variant
from variantgen.wording.formula import Measured, Symbol, to_plain
from variantgen.wording.language import Language
from variantgen.wording.statement import Statement, statement

_DECIMAL = re.compile(r"\d+[.,]\d+")
_SEEN = 1e-3  # relative rates below it are rounding of the sheet


def numbers_in_words(variant: Variant, asked: Sequence[Quantity], language: Language) -> list[tuple[float, str]]:
    """The numbers that stand in the text of a sheet: absolute values in SI and what they measure."""
    said = statement(variant, asked, language)
    sheet = read_sheet(said, variant.form, language)
    return [(abs(number.value), number.measures) for number in sheet.numbers] + _plain_decimals(said)


def _plain_decimals(said: Statement) -> list[tuple[float, str]]:
    """Decimals in the text, as those of ratios."""
    texts = [part for part in said.text if isinstance(part, str)]
    return [(float(number.replace(",", ".")), "") for text in texts for number in _DECIMAL.findall(text)]


def printed_numbers(variant: Variant, asked: Sequence[Quantity], language: Language) -> dict[str, float]:
    """The numbers of a sheet by what stands before them, or by their order in the text.

    Letters in the text are zeros with their names: what is said in words, as that a guide passes through O, is seen to
    be no longer true.
    """
    said = statement(variant, asked, language)
    found = [(to_plain(e.left), e.right.number) for e in said.given if isinstance(e.right, Measured)]
    found += [("", part.number) for part in said.text if isinstance(part, Measured)]
    said_of = {f"of {to_plain(part)} {i}": 0.0 for i, part in enumerate(said.text) if isinstance(part, Symbol)}
    return said_of | {f"{name} {i}": float(Fraction(_plain(number.text))) for i, (name, number) in enumerate(found)}


def _plain(number: str) -> str:
    return number.replace(",", ".").replace("\N{MINUS SIGN}", "-")


def sheet_rates(
    ahead: Mapping[str, float], behind: Mapping[str, float], here: Mapping[str, float], step: float
) -> dict[str, float] | None:
    """How fast the numbers of a sheet change, of their size, from ``step`` behind to as much ahead.

    What rounding alone may do is nothing. None where the sheet tells another datum: the change is seen.
    """
    if not ahead.keys() == behind.keys() == here.keys():
        return None
    largest = max(map(abs, here.values()), default=0.0) or 1.0
    found = {name: (ahead[name] - behind[name]) / (2 * step * (abs(size) or largest)) for name, size in here.items()}
    return {name: rate for name, rate in found.items() if abs(rate) > _SEEN}
