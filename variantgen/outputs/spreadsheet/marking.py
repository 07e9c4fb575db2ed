"""The formulas of the form for marking. Rows and columns count from zero; names of functions are those of the format.

The cells of a student look their answers up by the code of the sheet, so rows may be sorted. What a formula says of the
row it stands in goes with the row.
"""

from __future__ import annotations

from msgspec import Struct
from xlsxwriter.utility import xl_col_to_name, xl_rowcol_to_cell

NOT_A_NUMBER = "?"
_DECIMALS = 9  # to which a sum of decimal numbers is rounded, so that it is what it would be in decimals


class Rows(Struct, frozen=True):
    """The rows of students on another worksheet, its title as it stands in formulas."""

    title: str
    first: int
    last: int

    def place(self, code: str) -> str:
        """The place of a student among the rows; ``code`` is the cell with the code."""
        return f"MATCH({code},{self._column(0)},0)"

    def look_up(self, column: int, place: str) -> str:
        """A number of a student; ``place`` is the cell with the place."""
        return f"INDEX({self._column(column)},{place})"

    def cell(self, row: int, column: int) -> str:
        """A cell of the worksheet that is the same for all rows."""
        return f"{self.title}!{fixed(row, column)}"

    def _column(self, column: int) -> str:
        name = xl_col_to_name(column, col_abs=True)
        return f"{self.title}!{name}${self.first + 1}:{name}${self.last + 1}"


def own(row: int, column: int) -> str:
    """A cell of the row that a formula stands in."""
    return str(xl_rowcol_to_cell(row, column, col_abs=True))


def fixed(row: int, column: int) -> str:
    """A cell that is the same for all rows."""
    return str(xl_rowcol_to_cell(row, column, row_abs=True, col_abs=True))


def first_of(row: int, column: int) -> str:
    """The first cell of an area, for a condition that is meant for each of its cells."""
    return str(xl_rowcol_to_cell(row, column))


def span(row: int, first: int, last: int, absolute: bool = False) -> str:
    """Cells beside each other, of the same row or (``absolute``) of one row for all."""
    cell = fixed if absolute else own
    return f"{cell(row, first)}:{cell(row, last)}"


def shown(cell: str) -> str:
    """What a cell says; a blank one stays blank."""
    return f'IF({cell}="","",{cell})'


DECIMAL_MARK = "MID(1/2,2,1)"  # of the spreadsheet


def number(typed: str, decimal_mark: str) -> str:
    """The number of a cell of text, with either decimal mark; ``decimal_mark`` is the cell with that in use.

    Answers are typed as text: where the mark is a comma, a spreadsheet makes a date of 2.95 in any other cell.
    """
    return f'VALUE(SUBSTITUTE(SUBSTITUTE({typed},",",{decimal_mark}),".",{decimal_mark}))'


def mark(typed: str, value: str, right: str, points: str) -> str:
    """The points of an answer: nothing while nothing is typed, a question mark where its ``value`` is no number."""
    return f'IF({typed}="","",IF(ISNUMBER({value}),IF({right},{points},0),"{NOT_A_NUMBER}"))'


def within(number: str, low: str, high: str) -> str:
    """Whether a number is between the bounds, these included."""
    return f"AND({number}>={low},{number}<={high})"


def same_direction(number: str, value: str, high: str) -> str:
    """Whether an angle in degrees is as near to ``value`` as ``high`` is, but for full turns."""
    turned = f"ROUND(MOD({number}-{value}+180,360)-180,{_DECIMALS})"
    return f"IFERROR(ABS({turned})<=ROUND({high}-{value},{_DECIMALS}),FALSE)"


def share(points: str, every: str, asked: str) -> str:
    """The points of an answer of a student who is asked ``asked`` of ``every`` (ranges of points): with the others
    they make the points of the problem.
    """
    return f"{points}*SUM({every})/SUM({asked})"


def rounded_sum(cells: str) -> str:
    """A sum of points: ten even if it is six times 1.6666."""
    return f"ROUND(SUM({cells}),{_DECIMALS})"


def total(cells: str) -> str:
    """A sum of points, or nothing while there is nothing to add."""
    return f'IF(COUNT({cells})=0,"",{rounded_sum(cells)})'


def part(points: str, most: str) -> str:
    """What part points are of the most."""
    return f'IF(OR({points}="",{most}=0),"",{points}/{most})'
