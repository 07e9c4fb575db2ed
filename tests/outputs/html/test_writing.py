"""Fragments of HTML: sound XML, formulas that hold to the signs beside them, nothing lost."""

from __future__ import annotations

import xml.etree.ElementTree as ET

import pytest

from variantgen.exam.content import SolvedProblem, Written, with_figures
from variantgen.exam.solution_figures import SolutionFigure
from variantgen.figure.drawing import Drawing
from variantgen.outputs.documents.formula_rows import breadth
from variantgen.outputs.html.fragments import solution_html, statement_html
from variantgen.outputs.html.writing import HtmlWriting
from variantgen.single import asked_quantities, one_variant
from variantgen.variants.variant import solve_variants
from variantgen.wording.formula import Formula, Fraction, Number, Product, Sum, Symbol, to_plain
from variantgen.wording.language import load_language
from variantgen.wording.mathml import to_mathml
from variantgen.wording.solution.document import FormulaLine, FormulaLines, SolutionText
from variantgen.wording.solution.explain import explain
from variantgen.wording.statement import Statement
from variantgen.wording.text import Text

A, B = Symbol("A"), Symbol("B")
WRITING = HtmlWriting(lambda formula, display: f"<m>{to_plain(formula)}</m>", lambda *_: "<svg/>")


def runs(text: Text) -> list[str]:
    """What holds together, and the text between."""
    tree = ET.fromstring(f"<p>{WRITING.text(text)}</p>")
    assert "".join(tree.itertext()) == "".join(part if isinstance(part, str) else to_plain(part) for part in text)
    assert all(node.tag == "m" or node.get("class") == "steady" for node in tree)
    return ["".join(node.itertext()) for node in tree if node.tag == "span"]


@pytest.mark.parametrize(
    ("text", "held"),
    [
        (("the angle ", A, " of the crank"), []),
        (("the angle ", A, ", given"), ["A,"]),
        (("velocity (", A, ") of ", B, "."), ["(A)", "B."]),
        (("рис.\xa0", A, " и"), ["рис.\xa0A"]),
        ((A, "; ", B), ["A;"]),
        ((A, " = ", B, " (", A, "\N{EM DASH}", B, "), that is"), ["(A—B),"]),
        ((A, B, " together"), ["AB"]),
        (("no formula at all",), []),
        (("<b> & ", A, "<i>"), ["A<i>"]),
        ((), []),
    ],
)
def test_a_formula_holds_to_what_touches_it(text: Text, held: list[str]) -> None:
    assert runs(text) == held


def test_formulas_have_commas_and_an_end() -> None:
    said = Statement(("Text",), (), (A, B))
    tree = ET.fromstring(f"<p>{statement_html(said, load_language('en'), WRITING)}</p>")
    text, asked = tree
    assert text.text == "Text"
    assert "".join(asked.itertext()) == "Determine: A, B."
    assert ["".join(node.itertext()) for node in asked] == ["Determine:", "A,", "B."]


def rows_of(lines: FormulaLines) -> list[ET.Element]:
    """The rows of formulas of a solution whose check is nothing else."""
    language, variant = load_language("en"), one_variant("four_bar")
    text = SolutionText((), (), ("none",), check=(lines,))
    rows = ((SolutionFigure("statement", Drawing(1, 1, (), ()), (), 1),),)
    html = solution_html(SolvedProblem(variant, Statement((), (), ()), text, rows, {}), language, WRITING)
    figures, answer, heading, *found = ET.fromstring(f"<div>{html}</div>")
    assert (figures.get("class"), answer.get("class"), heading.tag) == ("figures d-flex flex-wrap", "answer", "h4")
    assert all(row.get("class") == "formulas" for row in found)
    return found


def test_signs_stand_in_the_pieces_that_they_end() -> None:
    lines = FormulaLines((FormulaLine((("", A), ("=", B))), FormulaLine((("", B), ("\N{ALMOST EQUAL TO}", A)))))
    (row,) = rows_of(lines)
    formulas = [["".join(piece.itertext()) for piece in formula] for formula in row]
    assert formulas == [["A", "=\xa0B;"], ["B", "≈\xa0A."]]
    assert [node.get("class") for node in row] == ["formula"] * 2


@pytest.mark.parametrize("family", ["four_bar", "planetary_train"])
@pytest.mark.parametrize("lang", ["en", "ru"])
def test_a_whole_solution_is_xml_with_all_its_parts(family: str, lang: str) -> None:
    variant, language = one_variant(family), load_language(lang)
    asked = asked_quantities(variant)
    motion = solve_variants([variant], 2)
    written = explain(variant, motion, 0, asked, language)
    (solved,) = with_figures([Written(variant, asked, (motion, 0), written)], language)
    captions: list[str] = []

    def captioned(drawing: Drawing, width: float, caption: str) -> str:
        captions.append(caption)
        return "<svg/>"

    writing = HtmlWriting(to_mathml, captioned)
    tree = ET.fromstring(
        f"<div>{statement_html(solved.statement, language, writing)}{solution_html(solved, language, writing)}</div>"
    )
    assert len(list(tree.iter("h4"))) == len(written.sections) + (1 if written.check else 0)
    shown = [one for row in solved.rows for one in row]
    assert len(list(tree.iter("svg"))) == len(captions) == len(shown)
    assert all(caption.startswith({"en": "Fig.", "ru": "Рис."}[lang]) for caption in captions)
    said = "".join(tree.itertext())
    assert all(part in said for part in solved.statement.text if isinstance(part, str))


def long(letters: int) -> Formula:
    """A product of so many letters."""
    return Product(tuple([Number("12")] * (letters // 2)))


@pytest.mark.parametrize(("letters", "kind"), [(40, "piece"), (60, "piece long"), (90, "piece longer")])
def test_fractions_too_long_for_a_line_are_marked(letters: int, kind: str) -> None:
    for formula in (Fraction(long(letters), A), Fraction(A, long(letters))):
        (((piece,),),) = rows_of(FormulaLines((FormulaLine((("=", formula),)),)))
        assert piece.get("class") == kind


def test_breadth_is_that_of_the_longer_part() -> None:
    assert breadth(Fraction(Sum(((1, A), (-1, B))), Symbol("AB"))) == 3
    assert breadth(Fraction(A, long(20))) == breadth(long(20)) > 20
