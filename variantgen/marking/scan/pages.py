"""One page of a scan: which page of whom it is, and the answers on it."""

from __future__ import annotations

import re
from collections.abc import Callable

import numpy as np
from msgspec import Struct
from msgspec.structs import replace

from variantgen.marking.scan.columns import columns
from variantgen.marking.scan.darkness import Darkness, darkness
from variantgen.marking.scan.numbers import Reading, reading
from variantgen.marking.scan.pictures import ScanImage
from variantgen.marking.scan.registration import Placed, codes, placed

_CODE = re.compile(r"VARIANTGEN:(\d+):([0-9A-Z]{1,16}):([0-9A-Z-]{3,40})(?::A(\d{1,3}))?")
_FAINTEST = 5.0  # grey levels by which outlines must be darker than paper to be seen
_UNCLEAR = 0.3  # of the usual contrast of outlines: a block with less is not seen well


class PageCode(Struct, frozen=True):
    """What the code of a page says: the form of the code, the short name of the build, the code of the sheet.

    ``number`` is that of the page for answers, 0 for a page of problems.
    """

    version: int
    exam_id: str
    sheet: str
    number: int


class ReadPage(Struct, frozen=True):
    """A page as it was read; where it was not, ``why``. ``placed`` tells where its blocks are in the picture."""

    where: str
    code: PageCode | None = None
    why: str = ""
    answers: tuple[Reading, ...] = ()
    placed: Placed | None = None


def read_page(picture: ScanImage, blocks: Callable[[PageCode], int]) -> ReadPage:
    """Read a page; ``blocks`` says how many answers the page of a code has, 0 where it is not to be read."""
    grey = picture.grey
    if grey is None:
        return ReadPage(picture.where, why=picture.why)
    found = [(code, own) for code in codes(grey) if (own := page_code(code.text)) is not None]
    if not found:
        return ReadPage(picture.where, why="no code of a sheet is seen")
    answers = [item for item in found if item[1].number]
    if len({own for _, own in answers}) > 1:
        return ReadPage(picture.where, why="several pages for answers are seen")
    code, own = (answers or found)[0]
    count = blocks(own)
    if not count:
        return ReadPage(picture.where, own)
    where = placed(grey, code)
    if where is None:
        return ReadPage(picture.where, own, "not all four black squares in the corners are seen")
    measured = darkness(grey, where, count)
    if float(np.median(measured.outlines)) < _FAINTEST:
        return ReadPage(picture.where, own, "the bubbles are not where they should be: is the page bent or covered?")
    return ReadPage(picture.where, own, answers=_readings(measured), placed=where)


def page_code(text: str) -> PageCode | None:
    """What the text of a code says; None for a code of something else."""
    found = _CODE.fullmatch(text)
    return PageCode(int(found[1]), found[2], found[3], int(found[4] or 0)) if found else None


def _readings(measured: Darkness) -> tuple[Reading, ...]:
    """The answers of a page; a block whose outlines are hardly seen is nothing to rely on."""
    clear = measured.outlines >= _UNCLEAR * np.median(measured.outlines)
    found = [reading(own) for own in columns(measured)]
    return tuple(
        own if is_clear else replace(own, doubts=(*own.doubts, "unclear"), may_confirm=False)
        for own, is_clear in zip(found, clear, strict=True)
    )
