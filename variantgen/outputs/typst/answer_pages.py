"""Pages for answers that are read from a scan, as data for ``answer_page.typ``.

Where everything stands says :mod:`variantgen.exam.answer_page`.
"""

from __future__ import annotations

from collections.abc import Iterable, Mapping, Sequence
from typing import Any

from variantgen.exam import answer_page as page
from variantgen.exam.content import Content
from variantgen.outputs.qr import answer_qr_text, qr_rows, qr_svg

EXAMPLE = "-12.5"
_EXAMPLE_PLACE, _EXAMPLE_SIZE = (179.2, 20.5), 0.54
_MINUS = "\N{MINUS SIGN}"
_GREY, _LIGHT = "#6a6a6a", "#a6a6a6"
_LINE = 0.2
_MIDDLE = page.BOX_TOP + page.BOX_HEIGHT / 2


def with_answer_pages(data: Mapping[str, Any], content: Content) -> dict[str, Any]:
    """The data of sheets (``documents/sheet_data.py``) with the pages for answers of every sheet.

    Raises InputError where an answer has no room in the boxes.
    """
    students = []
    for student, sheet in zip(data["students"], content.sheets, strict=True):
        for item in sheet.items:
            for answer in item.answers:
                page.check_room(item.task.number, answer.quantity.name, answer.value)
        headings = [(p["number"], heading) for p in student["problems"] for heading in p["headings"]]
        pages = page.in_pages(headings)
        found = [
            {
                "code": qr_svg(qr_rows(answer_qr_text(content.exam, sheet, number))),
                "of": f"{number}/{len(pages)}" if len(pages) > 1 else "",
                "blocks": [
                    {"number": name, "heading": heading, "at": page.block_corner(place)}
                    for place, (name, heading) in enumerate(own)
                ],
            }
            for number, own in enumerate(pages, start=1)
        ]
        students.append({**student, "answer-pages": found})
    return {**data, "students": students, "answer-page": _shared(content.exam.spoken.decimal_mark)}


def _shared(mark: str) -> dict[str, Any]:
    """What all pages have in common."""
    filled = page.columns_of(EXAMPLE)
    own = [bubble for bubble in page.BUBBLES if filled[bubble.column] == bubble.value]
    return {
        "corners": [(x - page.CORNER_SIDE / 2, y - page.CORNER_SIDE / 2) for x, y in page.CORNERS],
        "side": page.CORNER_SIDE,
        "code": page.CODE,
        "code-width": page.CODE_WIDTH,
        "block": (page.BLOCK_WIDTH, page.BLOCK_HEIGHT, page.HEADING),
        "image": _svg(),
        "digits": [(page.column_x(1), page.FIRST_ROW + page.ROW * value, str(value)) for value in range(10)],
        "columns": (page.DIGITS, page.PITCH),
        "marks": [(bubble.x, bubble.y, mark) for bubble in page.BUBBLES if bubble.column == page.POINT],
        "example": EXAMPLE.replace("-", _MINUS).replace(".", mark),
        "example-image": _svg(own),
        "example-at": (*_EXAMPLE_PLACE, _EXAMPLE_SIZE),
        "example-written": _written(filled, mark),
    }


def _svg(filled: Sequence[page.Bubble] = ()) -> str:
    """Frame, boxes and bubbles of an answer; one unit is a millimetre.

    The outline of a bubble is a thick line with a white one on it: that takes a tenth of the bytes of a curve.
    """
    width, height = page.BLOCK_WIDTH, page.BLOCK_HEIGHT
    side = page.PITCH - 0.5
    boxes = "".join(
        f"M{page.column_x(k) - side / 2:.3f} {page.BOX_TOP}h{side:.3f}v{page.BOX_HEIGHT}h{-side:.3f}z"
        for k in range(page.DIGITS + 1)
    )
    thick = 2 * page.RADIUS
    return (
        f'<svg xmlns="http://www.w3.org/2000/svg" viewBox="0 0 {width:g} {height:g}" fill="none">'
        f'<rect x="0.5" y="0.4" width="{width - 1:g}" height="{height - 1.2:g}" rx="1.2"'
        f' stroke="{_LIGHT}" stroke-width="{_LINE}"/>'
        f'<path stroke="{_GREY}" stroke-width="{_LINE}" stroke-linejoin="round" d="{boxes}"/>'
        '<g stroke-linecap="round">'
        f'<path stroke="{_GREY}" stroke-width="{thick:g}" d="{_lines(page.BUBBLES)}"/>'
        f'<path stroke="#fff" stroke-width="{thick - 2 * _LINE:g}" d="{_lines(page.BUBBLES)}"/>'
        f'<path stroke="{_LIGHT}" stroke-width="{_LINE}" d="{_minus(page.MARK_ROW, 1.7)}"/>'
        + (f'<path stroke="#000" stroke-width="{thick:g}" d="{_lines(filled)}"/>' if filled else "")
        + (f'<path stroke="#000" stroke-width="{2 * _LINE}" d="{_minus(_MIDDLE, 2.6)}"/>' if filled else "")
        + "</g></svg>"
    )


def _lines(bubbles: Iterable[page.Bubble]) -> str:
    return "".join(f"M{bubble.x - page.LENGTH / 2:.3f} {bubble.y:.3f}h{page.LENGTH}" for bubble in bubbles)


def _minus(y: float, length: float) -> str:
    """The sign itself, in the column of the minus: a letter of the font does not stand in the middle."""
    return f"M{page.column_x(page.MINUS) - length / 2:.3f} {y:.3f}h{length}"


def _written(filled: Sequence[int | None], mark: str) -> list[tuple[float, float, str]]:
    """What is written into the boxes of the example, and where."""
    digits = enumerate(filled[1 : page.DIGITS + 1], start=1)
    found = [(page.column_x(k), _MIDDLE, str(value)) for k, value in digits if value is not None]
    after = filled[page.POINT]
    if after is not None:
        found.append((page.column_x(after) + page.PITCH / 2, page.BOX_TOP + page.BOX_HEIGHT - 1.3, mark))
    return found
