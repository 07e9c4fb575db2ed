"""The cloze notation of Moodle: numbers to be entered inside a text, like ``{1:NUMERICAL:=12.5:0.1}``.

What Moodle makes of ``12,5`` depends on the language of its interface: 12.5 where the comma is the decimal mark
(Russian), 125 where commas separate thousands (English). The minus sign U+2212 is not read at all. A decimal point and
a hyphen are read everywhere, and every question asks for a point.
"""

from __future__ import annotations

from decimal import Decimal

from variantgen.exam.sheets import Answer
from variantgen.outputs.platforms.numbers import plain

_BRACES = str.maketrans({"{": "&#123;", "}": "&#125;"})


def inert(html: str) -> str:
    """HTML in which nothing can be taken for a part of the question, whatever the text says."""
    return html.translate(_BRACES)


def part(answer: Answer, weight: int) -> str:
    """An answer to be entered. One that may be written in two ways, a turn apart, has two right values."""
    value, tolerance = Decimal(repr(answer.value)), plain(Decimal(repr(answer.tolerance)))
    first = answer.accepted_intervals[0][0]
    values = (value + round(low - first) for low, _ in answer.accepted_intervals)
    return f"{{{weight}:NUMERICAL:{'~'.join(f'={plain(one)}:{tolerance}' for one in values)}}}"


def weights(points: int | None, parts: int) -> list[int]:
    """Whole numbers whose sum, the mark of the question, is the number of points, as even as can be.

    All are 1 where nothing is said of points, or where there are fewer points than parts.
    """
    if points is None or points < parts:
        return [1] * parts
    each, more = divmod(points, parts)
    return [each + (number < more) for number in range(parts)]
