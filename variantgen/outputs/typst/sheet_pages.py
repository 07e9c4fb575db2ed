"""How the problems of a sheet stand on its pages: figure sizes, widths of the text, tables of answers, page breaks.

A sheet has as few pages as there are within the limits of :data:`SIZES`, and each page the largest size with which its
problems fit. What the engine has to measure (:mod:`variantgen.outputs.typst.heights`) is measured once for many sheets.
All lengths are in millimetres.
"""

from __future__ import annotations

from collections.abc import Mapping, Sequence
from math import ceil, floor
from typing import Any

from msgspec import Struct

from variantgen.outputs.typst.heights import EM, Heights
from variantgen.outputs.typst.set_formulas import set_width
from variantgen.outputs.typst.typesetter import Typesetter

# What the templates draw with, too.
MEASURES = {
    "top": 15.0,
    "bottom": 16.0,
    "width": 174.0,
    "height": 297.0 - 15.0 - 16.0,
    "gutter": 6.0,  # between text and figure
    "heading": 6.0,  # height of the headings of answers, of the cells below, and of the room above a row of them
    "cell": 7.0,
    "above": 2.0,
    "code": 13.0,  # kept clear on pages without a head, where sheets have a code in the corner
}
_FIGURE_WIDTH = 80.0  # at most, in steps, so that texts are laid out for a few widths only
_WIDTH_STEP = 10.0
_NARROWEST_CELL, _WIDEST_CELL = 21.5, 34.0
_SPARE = 0.5  # of a line of data: its width is not measured to the hair
_WIDEST_GAP = 9.0  # between problems

# What stands for a head: most are as high as one with short names.
_HEAD = ("group", "name", "number", "sheet-code", "blank")
_LONGEST_SHORT = 39


class Size(Struct, frozen=True):
    """Millimetres of a figure unit, and the least room between problems."""

    unit: float
    gap: float


# Where there is room; where it saves a page; where a sheet would else have a page more than others of its class.
SIZES = (Size(0.8, 4.5), Size(0.68, 4.5), Size(0.62, 3.5))


class AnswerRows(Struct, frozen=True):
    """Rows of cells for the answers: how many stand in a row, how wide they are, how high all rows."""

    columns: int
    cell: float
    height: float


class Arrangement(Struct, frozen=True):
    """How a problem stands on the page: the text has the room that the figure leaves.

    The table is below both or, ``beside``, in the column of the text.
    """

    unit: float
    figure: float
    width: float
    beside: bool
    table: AnswerRows
    height: float


def with_pages(data: Mapping[str, Any], engine: Typesetter) -> dict[str, Any]:
    """The data of sheets (``documents/sheet_data.py``) with the pages of every sheet, for ``sheets.typ``."""
    heights, code = Heights(engine, data), any(student["qr"] for student in data["students"])
    tops = [_tops(student, code) for student in data["students"]]
    heights.measure(top for both in tops for top in both)
    heights.measure(
        {"formula": markup}
        for student in data["students"]
        for problem in student["problems"]
        for equation in problem["given"]
        for markup in _formulas(equation)
        if set_width(markup) is None
    )
    filling = [
        Filling(student, [MEASURES["height"] - heights.of(top) for top in both], heights, data["reorder"])
        for student, both in zip(data["students"], tops, strict=True)
    ]
    for size in SIZES:
        # All at once: the engine takes as long for one as for ten.
        waiting = [sheet for sheet in filling if sheet.may_gain]
        heights.measure(request for sheet in waiting for request in sheet.requests(size))
        for sheet in waiting:
            sheet.take(size)
    students = [{**student, "pages": sheet.pages()} for student, sheet in zip(data["students"], filling, strict=True)]
    return {**data, "measures": MEASURES, "code": code, "students": students}


class Filling:
    """The pages of one sheet, filled with one size after the other while that may save a page.

    ``rooms`` are the heights left for problems on the first page and on further ones.
    """

    def __init__(self, student: Mapping[str, Any], rooms: Sequence[float], heights: Heights, reorder: bool) -> None:
        self._problems: Sequence[Mapping[str, Any]] = student["problems"]
        self._signs, self._rooms, self._heights, self._reorder = student["notes"], rooms, heights, reorder
        self._data = [[_equation_width(found, heights) for found in problem["given"]] for problem in self._problems]
        least = [_figure_height(problem, SIZES[-1].unit) for problem in self._problems]
        self._fewest = _fewest(least, rooms)
        self._tried: list[list[Arrangement]] = []
        self._places: list[list[int]] = []
        self._chosen = 0  # how many sizes the pages were filled with

    @property
    def may_gain(self) -> bool:
        """Whether a smaller size may save a page."""
        return not self._places or len(self._places) > self._fewest

    def requests(self, size: Size) -> list[dict[str, Any]]:
        """What has to be measured before a size is taken."""
        return [_said(problem, _widths(problem, size.unit)[1]) for problem in self._problems]

    def take(self, size: Size) -> None:
        """Fill pages with this size, and keep them if they are fewer."""
        plans = [
            _arranged(problem, widths, size.unit, self._heights)
            for problem, widths in zip(self._problems, self._data, strict=True)
        ]
        self._tried.append(plans)
        found = _filled([plan.height + size.gap for plan in plans], self._rooms, self._reorder)
        if not self._places or len(found) < len(self._places):
            self._places, self._chosen = found, len(self._tried)

    def pages(self) -> list[dict[str, Any]]:
        """The problems of each page by their places, with their arrangements."""
        return [self._page(own, self._rooms[min(number, 1)]) for number, own in enumerate(self._places)]

    def _page(self, own: Sequence[int], room: float) -> dict[str, Any]:
        """A page with the largest size that leaves room for all its problems."""
        for size, plans in zip(SIZES, self._tried[: self._chosen], strict=False):
            arranged = [plans[i] for i in own]
            left = room - sum(plan.height + size.gap for plan in arranged)
            if left >= 0:
                break
        gap = min(max(left / max(len(own), 1) + size.gap, size.gap), _WIDEST_GAP)
        return {
            "signs": [note for note in self._signs if any(note in self._problems[i]["signs"] for i in own)],
            "gap": floor(100 * gap) / 100,  # never more than there is
            "problems": [{"place": i, **_data(plan)} for i, plan in zip(own, arranged, strict=True)],
        }


def _formulas(equation: Mapping[str, Any]) -> list[Any]:
    return [equation[name] for name in ("symbol", "unit") if equation[name]]


def _said(problem: Mapping[str, Any], width: float) -> dict[str, Any]:
    """A statement with an empty line of data: the lines are counted, because they are others on each sheet."""
    said = {name: problem[name] for name in ("number", "points", "text", "asked", "letters")}
    return {"said": {**said, "given": []}, "width": width, "room": MEASURES["height"]}


def _tops(student: Mapping[str, Any], code: bool) -> tuple[dict[str, Any], dict[str, Any]]:
    """What stands above the problems of the first page and of further ones: no less than there will be."""
    found = {name: student[name] for name in _HEAD if name in student}
    head = {name: "N" if _is_short(name, text) else text for name, text in found.items()}
    first = {"head": head, "signs": student["notes"], "width": MEASURES["width"]}
    return first, {**first, "head": None, "width": MEASURES["width"] - (MEASURES["code"] if code else 0)}


def _is_short(name: str, text: Any) -> bool:
    return name != "blank" and 1 <= len(text) <= _LONGEST_SHORT


def _widths(problem: Mapping[str, Any], unit: float) -> tuple[float, float]:
    """Of the figure's column and of the text beside it."""
    figure = min(_FIGURE_WIDTH, _WIDTH_STEP * ceil(problem["figure"]["w"] * unit / _WIDTH_STEP))
    return figure, MEASURES["width"] - MEASURES["gutter"] - figure


def _data(plan: Arrangement) -> dict[str, Any]:
    """What the template needs to know of an arrangement."""
    return {
        "unit": plan.unit,
        "figure": plan.figure,
        "width": plan.width,
        "beside": plan.beside,
        "columns": plan.table.columns,
        "cell": round(plan.table.cell, 3),
    }


def _figure_height(problem: Mapping[str, Any], unit: float) -> float:
    width, height = float(problem["figure"]["w"]), float(problem["figure"]["h"])
    return height * min(unit, _FIGURE_WIDTH / width)


def _arranged(problem: Mapping[str, Any], widths: Sequence[float], unit: float, heights: Heights) -> Arrangement:
    """A problem with a figure of this unit; the table stands where it takes less of the page."""
    figure, width = _widths(problem, unit)
    lines = _lines(widths, width, heights.given_width)
    said = heights.of(_said(problem, width)) + (lines - 1) * heights.line
    drawn = _figure_height(problem, unit)
    below, beside = (_table(len(problem["headings"]), room) for room in (MEASURES["width"], width))
    height_below, height_beside = max(said, drawn) + below.height, max(said + beside.height, drawn)
    if height_beside <= height_below:
        return Arrangement(unit, figure, width, True, beside, height_beside)
    return Arrangement(unit, figure, width, False, below, height_below)


def _equation_width(equation: Mapping[str, Any], heights: Heights) -> float:
    """``symbol = value unit``: digits are half as wide as high, points narrower."""
    value: str = equation["value"]
    points: int = sum(value.count(point) for point in ".,")
    return sum(map(heights.width, _formulas(equation)), 0.0) + (0.5 * len(value) - 0.222 * points + 1.79) * EM


def _lines(widths: Sequence[float], width: float, first: float) -> int:
    """How many lines the data take; the first begins with a word."""
    lines, free = 1, width - first - _SPARE
    for own in widths:
        if own > free:
            lines, free = lines + 1, width - _SPARE
        free -= own + 0.333 * EM
    return lines


def _table(count: int, room: float) -> AnswerRows:
    rows = ceil(count / floor(room / _NARROWEST_CELL))
    columns = ceil(count / rows)
    height = rows * (MEASURES["heading"] + MEASURES["cell"]) + MEASURES["above"]
    return AnswerRows(columns, min(_WIDEST_CELL, room / columns), height)


def _fewest(heights: Sequence[float], rooms: Sequence[float]) -> int:
    """As few pages as there are, at least, with problems no less high than their figures."""
    beyond = sum(heights) + len(heights) * SIZES[-1].gap - rooms[0]
    return 1 + max(0, ceil(beyond / rooms[1]))


def _filled(heights: Sequence[float], rooms: Sequence[float], reorder: bool) -> list[list[int]]:
    """The places of problems of such heights, page by page, in their order, or in another where that saves a page."""
    kept = _in_order(heights, rooms)
    other = _packed(heights, rooms) if reorder else kept
    return other if len(other) < len(kept) else kept


def _in_order(heights: Sequence[float], rooms: Sequence[float]) -> list[list[int]]:
    pages: list[list[int]] = [[]]
    free = rooms[0]
    for i, height in enumerate(heights):
        if pages[-1] and height > free:
            pages.append([])
            free = rooms[1]
        pages[-1].append(i)
        free -= height
    return pages


def _packed(heights: Sequence[float], rooms: Sequence[float]) -> list[list[int]]:
    """The highest first, each on the first page that has room; on a page they are in their order."""
    pages: list[list[int]] = [[]]
    free = [rooms[0]]
    for i in sorted(range(len(heights)), key=lambda i: -heights[i]):
        place = next((k for k, room in enumerate(free) if heights[i] <= room), len(pages))
        if place == len(pages):
            pages.append([])
            free.append(rooms[1])
        pages[place].append(i)
        free[place] -= heights[i]
    return [sorted(page) for page in pages if page]
