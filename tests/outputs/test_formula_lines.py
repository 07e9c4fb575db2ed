"""Rows of formulas in lines. Digits are half an em wide; a column has 25.96 em (87 mm of 9.5 pt)."""

from __future__ import annotations

import json

import pytest
import typst

from variantgen.exam.solution_paper import HEIGHT
from variantgen.outputs.typst.formula_lines import COLUMN, Line, Row, in_lines
from variantgen.outputs.typst.markup import Piece, piece
from variantgen.outputs.typst.row_source import row_source
from variantgen.outputs.typst.source import TypstSource, array
from variantgen.outputs.typst.typesetter import typesetter
from variantgen.wording.formula import Dotted, Fraction, Number, Root, Symbol


def digits(count: int) -> Piece:
    return piece(Number("8" * count))


def shape(row: Row) -> list[tuple[float, int]]:
    """Indent and number of pieces of each line."""
    return [(line.indent, sum(bool(markup) for _, _, markup in line.items)) for line in row.lines]


def test_the_column_is_as_wide_as_that_of_the_template() -> None:
    """Two columns and 6 mm between them on 180 mm, in em of 9.5 pt, as the engine has them."""
    asked = '#import "solution.typ": column, em, text-height\n#metadata((column / em, text-height.mm())) <found>'
    with typesetter() as engine:
        (engine.root / "asked.typ").write_text(asked, "utf-8")
        found = json.loads(typst.query(engine.root / "asked.typ", "<found>", field="value", one=True, root=engine.root))
    assert found == pytest.approx([COLUMN, HEIGHT], rel=1e-9)
    assert pytest.approx(87 / (9.5 * 25.4 / 72)) == COLUMN


def test_what_has_room_is_on_one_line() -> None:
    found = in_lines([[("", digits(10)), ("=", digits(10))], [("", digits(10))]], ".")
    assert not found.wide
    assert shape(found) == [(1.4, 3)]
    (line,) = found.lines
    assert line.scale == 1
    # 5 em, = with its space, 5 em, the mark; the next formula is 1.6 em farther on.
    assert [(gap, sign) for gap, sign, _ in line.items] == [(0, ""), (0.25, "="), (0, ";"), (1.6, ""), (0, ".")]


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
    # 26 em in 25.96 em, with a mark: 0.99 of its size. 40 em would have to be 0.65.
    (line,) = (tight := in_lines([[("", digits(52))]], ".")).lines
    assert not tight.wide
    assert abs(line.scale - (25.96 - 0.05) / 26.278) < 0.005
    broad = in_lines([[("", digits(80))]], ".")
    assert broad.wide
    assert broad.lines[0].scale == 1


def test_a_side_that_has_no_room_at_its_indent_begins_further_left_in_full_size() -> None:
    # With its sign and the mark 1.03 + 23 + 0.28 em: at 25.96 - 0.05 - 24.31 = 1.6 em, not at 3.8.
    _, line = in_lines([[("", digits(20)), ("=", digits(46))]], ".").lines
    assert line.scale == 1
    assert line.indent == pytest.approx(1.6, abs=0.01)


def test_lines_with_fractions_have_the_room_of_their_ink() -> None:
    flat = in_lines([[("", piece(Symbol("x")))]], ".").lines[0]
    tall = in_lines([[("", piece(Fraction(Number("1"), Number("2"))))]], ".").lines[0]
    assert (flat.bottom, flat.top) == (0, 0)
    # The digits stand 0.677 em above and 0.686 em below the line; they are 0.67 em high.
    assert abs(tall.bottom + 0.69) < 0.03
    assert abs(tall.top - 1.34) < 0.03


def test_documents_with_tags_have_the_markup_of_pieces_and_others_their_letters() -> None:
    (line,) = in_lines([[("", piece(Symbol("x"))), ("=", digits(2))]], ".").lines
    # What follows is a quarter of an em away, on both sides of the sign: a space that the font has.
    assert line.fragments(letters=False) == (("x",), 0.25, "=", 0.25, (str(digits(2)),), ".")
    assert line.fragments(letters=True) == ("\N{MATHEMATICAL ITALIC SMALL X}\u2005=\u200588.",)


def test_the_height_of_a_row_is_known_where_all_of_it_is_set() -> None:
    row = in_lines([[("", digits(20)), ("=", digits(20))], [("", digits(10))]], ".")
    # Two lines of capitals, 0.683 em high, with 0.64 em between them.
    assert row.known_height(letters=True) == pytest.approx(2 * 0.683 + 0.64, abs=1e-9)
    assert row.known_height(letters=False) is None
    unknown = in_lines([[("", piece(Dotted(Symbol("x"), 1)))]], ".")
    assert unknown.known_height(letters=True) is None


def test_known_heights_are_those_that_the_engine_measures() -> None:
    half = piece(Fraction(Number("1"), Number("2")))
    over = Line(1.4)  # half an em beyond the column: more than widths are rounded by, and still one line
    over.add(0.0, "", digits(25), 12.5)
    over.add(0.25, "=", digits(22), 12.03)
    rows = [
        in_lines([[("", digits(5)), ("=", digits(5))]], "."),
        in_lines([[("", digits(20)), ("=", half)], [("", digits(20)), ("=", half)]], "."),
        in_lines([[("", digits(52))]], "."),
        in_lines([[("", piece(Root(Fraction(Number("1"), Number("2")))))]], "."),
        Row(False, [over]),
    ]
    assert [len(row.lines) for row in rows] == [1, 2, 1, 1, 1]
    source = TypstSource(letters=True, spoken=False)
    told = source.value(array([row_source(source, row) for row in rows]))
    with typesetter() as engine:
        (engine.root / "rows.txt").write_text(told, "utf-8")
        (engine.root / "heights-of-rows.typ").write_text(
            '#import "solution.typ": column, contents, em\n#import "base.typ": document-style\n'
            '#show: document-style.with("en")\n#set text(size: em)\n'
            '#context [#metadata(contents("rows.txt").map(row => '
            "measure(block(width: column, row)).height / em))<found>]\n",
            "utf-8",
        )
        measured = json.loads(
            typst.query(
                engine.root / "heights-of-rows.typ", "<found>", field="value", one=True, root=engine.root,
                ignore_system_fonts=True,
            )
        )  # fmt: skip
    for row, high in zip(rows, measured, strict=True):
        assert row.known_height(letters=True) == pytest.approx(high, abs=2e-3)
