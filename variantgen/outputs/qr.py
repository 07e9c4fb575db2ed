"""The QR code of a sheet, which says of which exam and of which student it is; the same on every kind of paper.

The text is ``VARIANTGEN:1:EXAM:CODE``: 1 is the version of this form, EXAM the short name of the build (in capitals),
CODE the code of the sheet. A page for answers has its number behind: ``VARIANTGEN:1:EXAM:CODE:A1``. Capitals, digits,
colons and dashes need the fewest modules: 25 in a row.
"""

from __future__ import annotations

import re
from collections.abc import Iterator, Sequence

from variantgen.errors import InputError, Problem
from variantgen.exam.exam import Exam
from variantgen.exam.sheets import Sheet
from variantgen.tables import shown

VERSION = 1

# Any of the eight masks can be read. To find the one that looks least like a pattern takes eight times as long.
_MASK = 3

# Letters of a text; 64 capitals take 33 modules in a row, those of our sheets 25.
_LONGEST = 64

_BAR = re.compile(rb"\x01+")

Rows = Sequence[bytes]  # a byte for every module, 1 if it is dark


def qr_text(exam: Exam, sheet: Sheet) -> str:
    """What the code of a sheet says."""
    return f"VARIANTGEN:{VERSION}:{exam.build_id.upper()}:{sheet.code}"


def answer_qr_text(exam: Exam, sheet: Sheet, page: int) -> str:
    """What the code of a page for answers says; the first page is 1."""
    return f"{qr_text(exam, sheet)}:A{page}"


def qr_rows(text: str) -> Rows:
    """The modules of a code from the top, without the white around them; error level M.

    Raises InputError for a text that is longer than what a reader finds on 10 mm of paper.
    """
    import segno

    if len(text) > _LONGEST:
        remedy = "was the manifest changed? or write  qr = false  under [page]"
        raise InputError(
            Problem(f"the text of a QR code has more than {_LONGEST} characters", value=shown(text), remedy=remedy)
        )
    made = segno.make(text, error="m", mask=_MASK, micro=False, boost_error=False)
    return tuple(map(bytes, made.matrix))


def qr_bars(rows: Rows) -> Iterator[tuple[int, int, int]]:
    """The dark modules that are side by side: the place of the first from the left and from the top, how many."""
    for y, row in enumerate(rows):
        yield from ((bar.start(), y, bar.end() - bar.start()) for bar in _BAR.finditer(row))


def qr_svg(rows: Rows) -> str:
    """A code as SVG without the white around it, a module being one unit.

    One shape: on a screen there would be hairlines between shapes that touch. Thick lines have half as many corners
    as rectangles.
    """
    size = len(rows)
    bars = "".join([f"M{x} {y}.5h{count}" for x, y, count in qr_bars(rows)])
    head = f'<svg xmlns="http://www.w3.org/2000/svg" viewBox="0 0 {size} {size}">'
    return f'{head}<path stroke="#000" d="{bars}"/></svg>'
