"""How numbers look in cells: formats that hide digits and keep the value, and widths of columns."""

from __future__ import annotations

import math
from collections.abc import Iterable, Mapping, Sequence

from variantgen.exam.sheets import Answer
from variantgen.wording.language import ANSWER_DIGITS

_MOST_DECIMALS = 9
NARROWEST, WIDEST = 6.0, 50.0  # of columns, in letters
_ROOM = 2.5
_MARK = '"*"'
_MOST_POINTS = 1000  # as in a policy; a date, which a spreadsheet with a decimal comma makes of 1.5, is more


def decimals(values: Iterable[float]) -> int:
    """Decimals with which nine in ten of the values show as many digits as a printed answer."""
    sizes = sorted(abs(value) for value in values if value)
    if not sizes:
        return 0
    exponent = math.floor(math.log10(sizes[len(sizes) // 10]))
    return min(max(ANSWER_DIGITS - 1 - exponent, 0), _MOST_DECIMALS)


def number_format(answer: Answer, places: int, marked: bool = False) -> str:
    """The format of an answer or a bound with so many decimals; a sense has its sign. An asterisk may be added."""
    if answer.quantity.component == "sense":
        form = "+0;-0;0"
    else:
        form = "0." + "0" * places if places else "0"
    return ";".join(part + _MARK for part in form.split(";")) if marked else form


def number_check(words: Mapping[str, str]) -> dict[str, object]:
    """What a cell for points takes: a number. ``words`` tell whoever types something else."""
    return {
        "validate": "decimal",
        "criteria": "between",
        "minimum": -_MOST_POINTS,
        "maximum": _MOST_POINTS,
        "error_title": words["not_a_number"],
        "error_message": words["number_expected"],
    }


def width(texts: Iterable[str], widest: float = WIDEST) -> float:
    """The width of a column that holds these texts, in letters."""
    return min(max(max((len(text) for text in texts), default=0) + _ROOM, NARROWEST), widest)


def number_width(values: Sequence[float], places: int) -> float:
    """The width of a column of numbers with so many decimals."""
    return width(f"{value:.{places}f}*" for value in (max(values, default=0.0), min(values, default=0.0)))
