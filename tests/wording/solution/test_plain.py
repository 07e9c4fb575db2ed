"""Solutions as plain text: at most 100 columns, formulas broken before a sign, tables aligned."""

from __future__ import annotations

from variantgen.wording.formula import Fraction, Index, Measured, Number, Product, Symbol, UnitText, Vector
from variantgen.wording.language import load_language
from variantgen.wording.solution.document import (
    Block,
    FormulaLine,
    FormulaLines,
    Paragraph,
    Program,
    Section,
    SolutionText,
    VectorTable,
    VectorTableRow,
    append_block,
)
from variantgen.wording.solution.plain import plain_solution

V_A, V_B = Symbol("v", (Index("A"),)), Symbol("v", (Index("B"),))
SPEED = Measured(Number("12.5"), UnitText((("cm/s", 1),)))
LONG = Product(tuple(Symbol("omega", (Index("ABCDEFGH"),)) for _ in range(5)))


def solution(*blocks: object) -> list[str]:
    section = Section(("Velocity of ", V_B), blocks)  # type: ignore[arg-type]
    text = SolutionText(("1) velocity of ", V_B, "."), (section,), (V_B, "."), (Paragraph(("Equal.",)),))
    return plain_solution(text, load_language("en")).replace("\N{NO-BREAK SPACE}", " ").splitlines()


def test_order_and_headings() -> None:
    lines = solution(Paragraph(("The link turns.",)))
    assert lines == [
        "Plan: 1) velocity of v_B.",
        "",
        "1. Velocity of v_B",
        "The link turns.",
        "",
        "Answer: v_B.",
        "",
        "Check.",
        "Equal.",
    ]


def test_fractions_in_one_line() -> None:
    lines = solution(FormulaLines((FormulaLine((("", V_B), ("=", Fraction(V_A, Number("2"))), ("=", SPEED))),)))
    assert "    v_B = v_A / 2 = 12.5 cm/s" in lines


def test_a_long_formula_is_broken_before_a_sign() -> None:
    lines = solution(FormulaLines((FormulaLine((("", V_B), ("=", LONG), ("=", LONG), ("=", SPEED))),)))
    rows = [line for line in lines if "ABCDEFGH" in line]
    assert len(rows) == 2
    assert rows[0].startswith("    v_B = ω")
    assert rows[1].startswith("        = ω")
    assert rows[1].endswith("= 12.5 cm/s")


def test_text_is_wrapped_at_blanks() -> None:
    lines = solution(Paragraph(("word " * 60, V_B, ".")))
    assert max(map(len, lines)) <= 100
    assert " ".join(lines).count("word") == 60


def test_tables_are_aligned() -> None:
    rows = (VectorTableRow(Vector(V_B), ("along ", Symbol("AB")), None), VectorTableRow(Vector(V_A), ("given",), SPEED))
    lines = solution(VectorTable(("vector", "direction", "magnitude"), "unknown", rows))
    start = lines.index("    vector  direction  magnitude")
    # The arrow above v is a mark that takes no column.
    bare = [line.replace("\N{COMBINING RIGHT ARROW ABOVE}", "") for line in lines[start + 1 : start + 3]]
    assert bare == ["    v_B     along AB   unknown", "    v_A     given      12.5 cm/s"]


def test_programs_keep_their_lines() -> None:
    lines = solution(Program("import math\nfor i in range(2):\n    print(i)\n"))
    assert lines[3:6] == ["    import math", "    for i in range(2):", "        print(i)"]


def test_a_sentence_that_announces_no_formula_ends_with_a_full_stop() -> None:
    blocks: list[Block] = []
    append_block(blocks, Paragraph(("The radius of the gear:",)))
    append_block(blocks, Paragraph(("The gear turns:",)))
    append_block(blocks, FormulaLines((FormulaLine((("", V_B),)),)))
    assert blocks[0] == Paragraph(("The radius of the gear.", " ", "The gear turns:"))
