"""Blocks of a solution as data: rows that formulas share, sums that may be broken, tables."""

from __future__ import annotations

from collections.abc import Sequence
from typing import Any

from variantgen.outputs.documents.solution_blocks import blocks_data
from variantgen.outputs.typst.formula_lines import Row
from variantgen.outputs.typst.writing import TYPST
from variantgen.wording.formula import Index, Measured, Number, Product, Sum, Symbol, UnitText
from variantgen.wording.solution.document import (
    Block,
    FormulaLine,
    FormulaLines,
    Paragraph,
    Program,
    VectorTable,
    VectorTableRow,
)

X, Y = Symbol("x", (Index("A"),)), Symbol("y", (Index("A"),))
SHORT = FormulaLine((("", X), ("=", Number("5"))))
WIDE = Product(tuple(Symbol("omega", (Index("ABCDEF"),)) for _ in range(7)))


def typst_blocks(blocks: Sequence[Block]) -> list[dict[str, Any]]:
    return blocks_data(blocks, TYPST)


def items(row: Row) -> list[tuple[str, str]]:
    """Signs and markup of a row, in all of its lines; marks that end a formula have no markup."""
    return [(sign, str(piece or "")) for line in row.lines for _, sign, piece in line.items]


def signs(row: Row) -> list[str]:
    return [sign for sign, markup in items(row) if markup]


def test_short_formulas_share_a_row_and_a_long_one_has_its_own() -> None:
    long = FormulaLine((("", X), ("=", WIDE), ("=", WIDE)))
    (data,) = typst_blocks([FormulaLines((SHORT, SHORT, long, SHORT))])
    assert [signs(row).count("") for row in data["rows"]] == [2, 1, 1], "formulas"
    assert items(data["rows"][0])[:3] == [("", "x_(A)"), ("=", '"5"'), (";", "")]


def test_a_long_sum_may_be_broken_before_each_term() -> None:
    half = Product((Number("2"), WIDE))
    (data,) = typst_blocks([FormulaLines((FormulaLine((("", X), ("=", Sum(((-1, half), (1, Y), (-1, half)))))),))])
    (row,) = data["rows"]
    pieces = [item for item in items(row) if item[1]]
    assert [sign for sign, _ in pieces] == ["", "=", "+", "\N{MINUS SIGN}"]
    assert pieces[1][1].startswith("-"), "the sign of the first term stays with it"
    assert not pieces[3][1].startswith("-")


def test_a_short_sum_stays_whole() -> None:
    (data,) = typst_blocks([FormulaLines((FormulaLine((("", X), ("=", Sum(((1, Y), (-1, Number("3"))))))),))])
    assert signs(data["rows"][0]) == ["", "="]


def test_only_a_paragraph_before_something_else_leads_to_it() -> None:
    text = Paragraph(("Then ", X, "."))
    data = typst_blocks([text, FormulaLines((SHORT,)), text, text])
    assert [block["leads"] for block in data] == [True, False, False, False]
    assert data[0]["text"] == ["Then ", ["x_(A)"], "."]
    assert typst_blocks([]) == []


def test_a_vector_equation_leads_to_the_table_of_its_vectors() -> None:
    text, equation, table = (
        Paragraph(("Then ", X, ".")),
        FormulaLines((SHORT,)),
        VectorTable(("a", "b", "c"), "unknown", ()),
    )
    for between in ([], [text]):
        data = typst_blocks([text, equation, *between, table, equation])
        assert [block["leads"] for block in data] == [True, True, *(True for _ in between), False, False]
    assert [block["leads"] for block in typst_blocks([equation, text, text, table])] == [False, False, True, False]


def test_tables_and_programs() -> None:
    speed = Measured(Number("3"), UnitText((("cm/s", 1),)))
    table = VectorTable(
        ("a", "b", "c"), "unknown", (VectorTableRow(X, ("along",), None), VectorTableRow(Y, ("up",), speed))
    )
    first, second = typst_blocks([table, Program("\nprint(1)\n")])
    assert first["heads"] == ["a", "b", "c"]
    assert first["rows"][0][2] == ["unknown"], "words are text, not markup"
    assert first["rows"][1][2] == [['"3" thin "cm/s"']]
    assert second["code"] == "print(1)"
