"""Rows of formulas in lines. Digits are half an em wide; a column has 25.96 em (87 mm of 9.5 pt)."""

from __future__ import annotations

from typing import Any

from variantgen.outputs.typst.formula_lines import COLUMN, in_lines
from variantgen.outputs.typst.markup import Piece, piece
from variantgen.wording.formula import Fraction, Number, Symbol


def digits(count: int) -> Piece:
    return piece(Number("8" * count))


def shape(row: dict[str, Any]) -> list[tuple[float, int]]:
    """Indent and number of pieces of each line."""
    return [(indent, sum(bool(markup) for _, _, markup in items)) for indent, _, _, _, items in row["lines"]]


def test_the_column_is_as_wide_as_the_template_says() -> None:
    assert abs(COLUMN - 87 / (9.5 * 25.4 / 72)) < 1e-9


def test_what_has_room_is_on_one_line() -> None:
    found = in_lines([[("", digits(10)), ("=", digits(10))], [("", digits(10))]], ".")
    assert not found["wide"]
    assert shape(found) == [(1.4, 3)]
    ((_, scale, _, _, items),) = found["lines"]
    assert scale == 1
    # 5 em, = with its space, 5 em, the mark; the next formula is 1.6 em farther on.
    assert [(gap, sign) for gap, sign, _ in items] == [(0, ""), (0.25, "="), (0, ";"), (1.6, ""), (0, ".")]


def test_a_row_is_broken_between_formulas_and_a_long_formula_before_its_signs() -> None:
    # 1.4 + 10 + 0.25 + 1.03 + 10 + 0.28 = 22.96 em fits; with 1.6 + 5 more it does not.
    two = in_lines([[("", digits(20)), ("=", digits(20))], [("", digits(10))]], ".")
    assert shape(two) == [(1.4, 2), (1.4, 1)]
    # 15 em each: the second side of the formula has a line of its own, farther in.
    long = in_lines([[("", digits(30)), ("=", digits(30)), ("=", digits(4))]], ".")
    assert shape(long) == [(1.4, 1), (3.8, 2)]
    # On its second line, 3.8 + 16.03 + 0.28 em are taken: 1.6 + 5 more would have room only if it began at 1.4 em.
    after = in_lines([[("", digits(30)), ("=", digits(30))], [("", digits(10))]], ".")
    assert shape(after) == [(1.4, 1), (3.8, 1), (1.4, 1)]


def test_what_is_too_wide_is_smaller_or_takes_the_page() -> None:
    # 26 em in 25.96 - 1.4 em, with a mark: 0.93 of its size. 40 em would have to be 0.61.
    (line,) = (tight := in_lines([[("", digits(52))]], "."))["lines"]
    assert not tight["wide"]
    assert abs(line[1] - (25.96 - 0.05 - 1.4) / 26.278) < 0.005
    broad = in_lines([[("", digits(80))]], ".")
    assert broad["wide"]
    assert broad["lines"][0][1] == 1


def test_lines_with_fractions_have_the_room_of_their_ink() -> None:
    flat = in_lines([[("", piece(Symbol("x")))]], ".")["lines"][0]
    tall = in_lines([[("", piece(Fraction(Number("1"), Number("2"))))]], ".")["lines"][0]
    assert flat[2:4] == [0, 0]
    # The digits stand 0.677 em above and 0.686 em below the line; they are 0.67 em high.
    assert abs(tall[2] + 0.69) < 0.03
    assert abs(tall[3] - 1.34) < 0.03
