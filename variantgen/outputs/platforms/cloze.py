"""The cloze notation of Moodle: numbers to be entered inside a text, like ``{1:NUMERICAL:=12.5:0.1}``.

What Moodle makes of ``12,5`` depends on the language of its interface: 12.5 where the comma is the decimal mark
(Russian), 125 where commas separate thousands (English). The minus sign U+2212 is not read at all. A decimal point and
a hyphen are read everywhere, and every question asks for a point.
"""

from __future__ import annotations

from decimal import Decimal

from variantgen.exam.sheets import Answer
from variantgen.outputs.platforms.numbers import number
from variantgen.outputs.platforms.point_shares import shares

_BRACES = str.maketrans({"{": "&#123;", "}": "&#125;"})


def inert(html: str) -> str:
    """HTML in which nothing can be taken for a part of the question, whatever the text says."""
    return html.translate(_BRACES)


def part(answer: Answer, weight: Decimal) -> str:
    """An answer to be entered. One that may be written in two ways, a turn apart, has two right values."""
    tolerance = number(answer.tolerance)
    values = (number((low + high) / 2) for low, high in answer.exact_intervals)
    return f"{{{weight}:NUMERICAL:{'~'.join(f'={value}:{tolerance}' for value in values)}}}"


def weights(points: int | None, parts: int) -> tuple[Decimal, ...]:
    """WholeExam shares of the points of a question, all 1 where there are fewer points than parts."""
    return shares(points if points and points >= parts else None, parts, steps=1)
