"""Reading workbooks back, typing into them, sorting their rows, computing them: by openpyxl and formulas."""

from __future__ import annotations

import re
from collections.abc import Iterator, Mapping
from dataclasses import dataclass
from pathlib import Path
from typing import Any

import formulas
import openpyxl
from openpyxl.cell.cell import Cell
from openpyxl.formula.translate import Translator
from openpyxl.utils import get_column_letter

HEADS, FIRST = 6, 7  # rows of grading.xlsx, counted from one


@dataclass(frozen=True)
class Marked:
    """The columns of a problem on the first sheet of grading.xlsx, by what stands above and in them."""

    typed: tuple[int, ...]
    points: tuple[int, ...]
    correction: int


class Grading:
    """grading.xlsx as a person sees it: only heads, tints and locks tell what is where."""

    def __init__(self, path: Path) -> None:
        self.path = path
        self.book = openpyxl.load_workbook(path)
        self.sheet, self.corrections, self.answers = self.book.worksheets
        self.last = self.sheet.max_row

    @property
    def rows(self) -> range:
        """The rows of students."""
        return range(FIRST, self.last + 1)

    def code(self, row: int) -> str:
        """The code of a student."""
        return str(self.sheet.cell(row, 1).value)

    def problems(self) -> list[Marked]:
        """The columns of each problem."""
        found: list[Marked] = []
        typed: list[int] = []
        points: list[int] = []
        for column in range(7, self.sheet.max_column + 1):
            head = str(self.sheet.cell(HEADS, column).value)
            if head == "±":
                found.append(Marked(tuple(typed), tuple(points), column))
                typed, points = [], []
            elif head.endswith(("\npoints", "\nбаллы")):
                points.append(column)
            elif any(not self.sheet.cell(row, column).protection.locked for row in self.rows):
                typed.append(column)
        return found

    def correct(self, code: str, problem: int, points: float) -> None:
        """Give a student points in a problem by hand."""
        heads = [cell.value for cell in self.corrections[2]]
        (row,) = (row[0].row for row in self.corrections.iter_rows(min_row=3) if row[0].value == code)
        self.corrections.cell(row, heads.index(f"± {problem}") + 1).value = points

    def points_of_answers(self) -> list[Cell]:
        """The cells for the points of answers, in the order of problems and answers."""
        return [cell for cell in self.answers[3] if not cell.protection.locked]

    def sums(self) -> range:
        """The columns with the sums of the problems."""
        return range(7, 7 + len(self.problems()))

    def computed(self, name: str = "computed") -> Computed:
        """The workbook as it stands now, computed."""
        path = self.path.with_name(f"{name}.xlsx")
        self.book.save(path)
        solution = formulas.ExcelModel().loads(str(path)).finish().calculate()
        cells: dict[str, Any] = {}
        pattern = re.compile(rf"'\[{name}\.xlsx\]{re.escape(self.sheet.title.upper())}'!([A-Z]+[0-9]+)")
        for key, found in solution.items():
            match = pattern.fullmatch(str(key))
            if match:
                cells[match[1]] = found.value[0, 0]
        return Computed(cells)

    def permute(self, order: Mapping[int, int]) -> None:
        """Sort rows as a spreadsheet does: row ``order[i]`` goes to row ``i``, its formulas speak of their new row."""
        sheet = self.sheet
        old = {(row, column): sheet.cell(row, column).value for row in self.rows for column in self.columns()}
        for row, source in order.items():
            for column in self.columns():
                value = old[source, column]
                if isinstance(value, str) and value.startswith("="):
                    letter = get_column_letter(column)
                    value = Translator(value, f"{letter}{source}").translate_formula(f"{letter}{row}")
                sheet.cell(row, column).value = value

    def columns(self) -> range:
        """All columns."""
        return range(1, self.sheet.max_column + 1)


@dataclass(frozen=True)
class Computed:
    """The values of the cells of the form."""

    cells: Mapping[str, Any]

    def __call__(self, row: int, column: int) -> Any:
        return self.cells[f"{get_column_letter(column)}{row}"]

    def row(self, row: int, columns: Iterator[int] | range | tuple[int, ...]) -> list[Any]:
        """Cells of a row."""
        return [self(row, column) for column in columns]
