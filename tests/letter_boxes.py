"""Where the letters of PDF pages are, by PDFium, which shares nothing with the engine that wrote them."""

from __future__ import annotations

import ctypes
from collections.abc import Iterator
from dataclasses import dataclass
from pathlib import Path

import numpy as np
import pypdfium2
import pypdfium2.raw as pdfium
from numpy.typing import NDArray

# Letters beside each other, or one and its index, are moved together by the font; others share no more of a box than
# the slant of an italic.
_NEIGHBOURS, _SHARED = 2, 0.15
_LEAST = 0.3  # points
# Italic letters of formulas come as two halves.
_HIGH_SURROGATES, _LOW_SURROGATES = range(0xD800, 0xDC00), range(0xDC00, 0xE000)
_ACCENTS = "\u20d7\u2192\u0302\u0304"


@dataclass(frozen=True)
class Letters:
    """The letters of one page, the boxes of their ink (left, bottom, right, top in points from below), and the straight
    rules of the page, which are those of tables and no part of figures.
    """

    text: str
    boxes: NDArray[np.float64]
    rules: NDArray[np.float64]

    def overlaps(self) -> Iterator[tuple[str, str]]:
        """Letters that lie on each other, each with the text around it."""
        left, bottom, right, top = self.boxes.T
        order = np.argsort(bottom, kind="stable")
        for place, one in enumerate(order):
            others = order[place + 1 :]
            others = others[: np.searchsorted(bottom[others], top[one])]
            wide = np.minimum(right[one], right[others]) - np.maximum(left[one], left[others])
            high = np.minimum(top[one], top[others]) - bottom[others]
            width = np.minimum(right[one] - left[one], right[others] - left[others])
            height = np.minimum(top[one] - bottom[one], top[others] - bottom[others])
            apart = np.abs(others - one) > _NEIGHBOURS
            shared = (
                apart & (wide > np.maximum(_LEAST, _SHARED * width)) & (high > np.maximum(_LEAST, _SHARED * height))
            )
            yield from ((self.around(one), self.around(other)) for other in others[shared])

    def crossed(self) -> list[str]:
        """The letters through which a rule goes: they leave their cell."""
        low, high = self.boxes[:, None, :2] + _LEAST, self.boxes[:, None, 2:] - _LEAST
        inside = (self.rules[:, 2:] > low) & (self.rules[:, :2] < high)
        return [self.around(int(one)) for one in np.nonzero(inside.all(axis=2).any(axis=1))[0]]

    def outside(self, left: float, bottom: float, right: float, top: float) -> list[str]:
        """The letters that reach out of a rectangle, given in points from the lower left corner of the page."""
        low, high = self.boxes[:, :2] < (left, bottom), self.boxes[:, 2:] > (right, top)
        return [self.around(int(one)) for one in np.nonzero((low | high).any(axis=1))[0]]

    def around(self, one: int) -> str:
        """A letter with those before and after it."""
        return f"{self.text[max(0, one - 12) : one]}[{self.text[one]}]{self.text[one + 1 : one + 12]}"


def page_letters(path: Path) -> Iterator[Letters]:
    """The letters of each page that leave ink; accents, which lie above others, are left out."""
    document = pypdfium2.PdfDocument(path)
    try:
        for page in document:
            yield _letters(page.get_textpage(), _rules(page))
    finally:
        document.close()


def _letters(page: pypdfium2.PdfTextPage, rules: NDArray[np.float64]) -> Letters:
    text, boxes = [], []
    edges = [ctypes.c_double() for _ in range(4)]
    for one in range(pdfium.FPDFText_CountChars(page)):
        code = pdfium.FPDFText_GetUnicode(page, one)
        if code in _LOW_SURROGATES:
            continue  # the second half of the letter before
        letter = "*" if code in _HIGH_SURROGATES else chr(code)
        if letter.isspace() or letter in _ACCENTS or pdfium.FPDFText_IsGenerated(page, one):
            continue
        pdfium.FPDFText_GetCharBox(page, one, *edges)
        left, right, bottom, top = (edge.value for edge in edges)
        if right > left and top > bottom:
            text.append(letter)
            boxes.append((left, bottom, right, top))
    return Letters("".join(text), np.array(boxes, dtype=np.float64).reshape(-1, 4), rules)


def _rules(page: pypdfium2.PdfPage) -> NDArray[np.float64]:
    """Level and upright lines of paths that stand on the page itself: figures are images with paths of their own."""
    found = []
    for path in page.get_objects(filter=[pdfium.FPDF_PAGEOBJ_PATH], max_depth=1):
        matrix, last = path.get_matrix(), None
        for number in range(pdfium.FPDFPath_CountSegments(path)):
            segment = pdfium.FPDFPath_GetPathSegment(path, number)
            x, y = ctypes.c_float(), ctypes.c_float()
            pdfium.FPDFPathSegment_GetPoint(segment, x, y)
            here = matrix.on_point(x.value, y.value)
            if last and pdfium.FPDFPathSegment_GetType(segment) == pdfium.FPDF_SEGMENT_LINETO:
                ends = np.array((last, here))
                if np.ptp(ends, axis=0).min() < _LEAST < np.ptp(ends, axis=0).max():
                    found.append((*ends.min(axis=0), *ends.max(axis=0)))
            last = here
    return np.array(found, dtype=np.float64).reshape(-1, 4)
