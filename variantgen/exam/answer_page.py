"""The page for answers that is read from a scan: where everything stands on it.

An answer has a block: boxes to write the number in, and below them the bubbles to fill in: one for the minus, one in
each gap between the digits for the decimal mark, ten for each digit. The place of the mark is free, so the page does
not tell how large an answer is. What draws the page and what reads it both take the places from here. All lengths are
in millimetres, from the upper left corner of A4, y down.
"""

from __future__ import annotations

from collections.abc import Sequence
from typing import TypeVar

from msgspec import Struct

from variantgen.errors import InputError, Problem
from variantgen.tables import Table

T = TypeVar("T")

WIDTH, HEIGHT = 210.0, 297.0
DIGITS = 5  # the answers of the catalogue need at most four of them for their tolerances
LARGEST = 10.0**DIGITS - 0.5  # what is less has room in the boxes

# Black squares, from the upper left one clockwise: their centres and the length of a side.
CORNERS = ((12.0, 12.0), (198.0, 12.0), (198.0, 285.0), (12.0, 285.0))
CORNER_SIDE = 5.0
# The QR code: its upper left corner, and its width.
CODE, CODE_WIDTH = (159.0, 10.0), 14.0

# Blocks stand in rows; the first begins at START.
COLUMNS, ROWS = 6, 4
PER_PAGE = COLUMNS * ROWS
START = (12.0, 53.0)
BLOCK_WIDTH, BLOCK_HEIGHT = 31.0, 57.0
# Inside a block: the height of the heading, the boxes, the bubbles.
HEADING = 6.0
BOX_TOP, BOX_HEIGHT = 6.4, 6.6
PITCH = 4.7  # between columns; the first is that of the minus
_LEFT = 3.75  # the middle of the first column
MARK_ROW, FIRST_ROW, ROW = 15.6, 20.4, 3.75
# A bubble is a line of this length across, thickened by the radius: 3.6 wide, 2.9 high.
LENGTH, RADIUS = 0.7, 1.45


class Bubble(Struct, frozen=True):
    """A bubble of a block: ``column`` is that of the reading, ``value`` what it stands for in it.

    Columns are 0 for the minus (value 0), 1 to DIGITS for digits, DIGITS + 1 for the decimal mark, whose value is the
    number of digit columns before it.
    """

    column: int
    value: int
    x: float
    y: float


READ_COLUMNS = DIGITS + 2
MINUS, POINT = 0, DIGITS + 1


def column_x(column: int) -> float:
    """The middle of the column of the minus (0) or of a digit, from the left of the block."""
    return _LEFT + PITCH * column


def _bubbles() -> tuple[Bubble, ...]:
    digits = [
        Bubble(k, value, column_x(k), FIRST_ROW + ROW * value) for k in range(1, DIGITS + 1) for value in range(10)
    ]
    marks = [Bubble(POINT, k, column_x(k) + PITCH / 2, MARK_ROW) for k in range(1, DIGITS)]
    return (Bubble(MINUS, 0, column_x(0), MARK_ROW), *digits, *marks)


BUBBLES = _bubbles()


def block_corner(place: int) -> tuple[float, float]:
    """The upper left corner of a block by its place on the page."""
    row, column = divmod(place, COLUMNS)
    return START[0] + BLOCK_WIDTH * column, START[1] + BLOCK_HEIGHT * row


def in_pages(answers: Sequence[T]) -> list[Sequence[T]]:
    """The answers of a sheet in their order, page by page."""
    return [answers[first : first + PER_PAGE] for first in range(0, len(answers), PER_PAGE)]


def columns_of(text: str) -> list[int | None]:
    """What is filled in for a number like ``-12.5``: the value of each column, None where it stays blank.

    Raises ValueError for a text that is no such number or has no room.
    """
    digits = text.removeprefix("-")
    whole, _, fraction = digits.partition(".")
    if not (whole + fraction).isdecimal() or len(whole + fraction) > DIGITS:
        raise ValueError(f"{text} has no room")
    filled: list[int | None] = [int(digit) for digit in whole + fraction]
    filled += [None] * (DIGITS - len(filled))
    return [0 if text.startswith("-") else None, *filled, len(whole) if fraction and whole else None]


def read_answers_options(table: Table) -> bool:
    """Whether the table ``[answers]`` of an exam file wants pages that are scanned; mistakes are noted in it."""
    wanted = table.take("scan", bool, False)
    table.finish()
    return wanted


def check_room(number: int, name: str, value: float) -> None:
    """Raise InputError where the answer to a problem has no room in the boxes."""
    if abs(value) >= LARGEST:
        remedy = 'choose a larger unit (units = "m") or narrower ranges, or leave out  scan = true  under [answers]'
        message = f"{name} has more than {DIGITS} digits, which the page for answers has no room for"
        raise InputError(Problem(message, key=f"problem[{number}]", value=f"{value:.0f}", remedy=remedy))
