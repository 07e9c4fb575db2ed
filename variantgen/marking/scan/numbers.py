"""What number the columns of an answer say, and what other numbers they may say."""

from __future__ import annotations

from collections.abc import Iterator, Sequence
from itertools import chain, islice, product

from msgspec import Struct

from variantgen.exam import answer_page as page
from variantgen.marking.scan.columns import Column

_MOST = 64  # other readings that are tried


class Reading(Struct, frozen=True):
    """An answer as it was read: ``text`` like ``-12.5``, '' for a blank one, None where it is no number.

    ``doubts`` say why a person should look, each reason once; ``doubtful`` columns have them. Only a reading that
    ``may_confirm`` itself is taken where the key agrees. ``others`` are readings that would come about if a doubtful
    or weak column were read in another way. ``seen`` are bubbles of doubtful columns: the number of the column, the
    value, the darkness as a share of that of the usual mark.
    """

    text: str | None
    doubts: tuple[str, ...] = ()
    may_confirm: bool = True
    others: tuple[str, ...] = ()
    doubtful: int = 0
    seen: tuple[tuple[int, int, float], ...] = ()


def reading(own: Sequence[Column]) -> Reading:
    """The number of an answer."""
    text = number([column.value for column in own])
    doubts = tuple(dict.fromkeys(column.doubt for column in own if column.doubt))
    if text is None:
        doubts = (*doubts, "gap")
    others = tuple(dict.fromkeys(other for other in _others(own) if other != text))
    open_ = text is None or any(column.open for column in own)
    seen = tuple((k, *bubble) for k, column in enumerate(own) if column.doubt for bubble in column.dark)
    return Reading(text, doubts, not open_, others, sum(bool(column.doubt) for column in own), seen)


def number(values: Sequence[int | None]) -> str | None:
    """The number that columns say: digits side by side, the decimal mark at one of them; None for anything else."""
    digits = values[1 : page.DIGITS + 1]
    filled = [k for k, digit in enumerate(digits) if digit is not None]
    point = values[page.POINT]
    if not filled:
        return None if point is not None or values[page.MINUS] is not None else ""
    first, last = filled[0], filled[-1]
    if len(filled) != last - first + 1:
        return None
    if point is not None and not first <= point <= last + 1:
        return None
    whole = "".join(str(digit) for k, digit in enumerate(digits) if digit is not None and (point is None or k < point))
    fraction = "" if point is None else "".join(str(digit) for digit in digits[point:] if digit is not None)
    sign = "-" if values[page.MINUS] is not None else ""
    return f"{sign}{whole or '0'}{'.' if fraction else ''}{fraction}"


def _others(own: Sequence[Column]) -> Iterator[str]:
    """Numbers with one or two columns read in another way."""
    usual = [column.value for column in own]
    ways = [[(k, other) for other in column.others if other != column.value] for k, column in enumerate(own)]
    single = ((way,) for one in ways for way in one)
    double = (pair for i, one in enumerate(ways) for other in ways[i + 1 :] for pair in product(one, other))
    for changes in islice(chain(single, double), _MOST):
        values = list(usual)
        for k, value in changes:
            values[k] = value
        if text := number(values):
            yield text
