"""Every kind of formula in every markup, and that those who read the markups take them."""

from __future__ import annotations

from collections.abc import Callable, Iterator
from pathlib import Path
from typing import NamedTuple, get_args

import html5lib
import pypdfium2
import pytest
from matplotlib import rc_context
from matplotlib.mathtext import MathTextParser

from tests.wording.formulas import CM_PER_S, LINES, PHI, A, B, C, cos, deg, minus, num, plus, sym, times
from variantgen.figure.letters.lettering import typeset
from variantgen.outputs.single.motion_plot import STYLE
from variantgen.outputs.typst.markup import markup
from variantgen.outputs.typst.typesetter import Typesetter, typesetter
from variantgen.wording.formula import (
    Absolute,
    Cross,
    Dotted,
    Equation,
    Formula,
    FormulaList,
    Fraction,
    Function,
    Graph,
    Measured,
    Parenthesised,
    PointCoordinates,
    Power,
    Product,
    Quotient,
    Relation,
    Root,
    Sum,
    Surd,
    SymbolProperty,
    UnitText,
    Vector,
    to_plain,
    to_typst,
)
from variantgen.wording.html import to_html
from variantgen.wording.latex import to_latex
from variantgen.wording.mathtext import to_mathtext

PLUS, MINUS = 'med class("binary", +) med', 'med class("binary", -) med'
DOT, CROSS = 'thin class("normal", dot.op) thin', 'thin class("normal", times) thin'
ARROW = "limits(stretch(arrow.r, size: #2em))"


class Row(NamedTuple):
    """A formula in plain text, Typst, LaTeX, mathtext and HTML."""

    formula: Formula
    plain: str
    typst: str
    latex: str
    mathtext: str
    html: str


ROWS = [
    Row(
        Sum(((-1, A), (1, B), (-1, num("2")))),
        "−a + b − 2",
        f'-a {PLUS} b {MINUS} "2"',
        "-a + b - 2",
        "${-}a+b-2$",
        "−<i>a</i> +\xa0<i>b</i> −\xa02",
    ),
    Row(
        times(sym("omega", "OA"), sym("OA")),
        "ω_OA · OA",
        f"omega_(O A) {DOT} O A",
        r"\omega_{O A} \cdot O A",
        r"$\omega_{OA}\cdot{}OA$",
        "<i>ω</i><sub><i>O</i><i>A</i></sub>\xa0·\xa0<i>O</i><i>A</i>",
    ),
    Row(
        times(num("2"), sym("omega"), cos(PHI)),
        "2\xa0ω\xa0cos\xa0φ",
        '"2" thin omega thin op("cos") phi',
        r"2\,\omega \mathop{\text{cos}}\nolimits \varphi",
        r"$2\,\omega\,\mathrm{cos}\,\varphi$",
        "2\u202f<i>ω</i>\u202fcos\u202f<i>φ</i>",
    ),
    Row(
        times(num("3"), num("-20,3")),
        "3 · (−20,3)",
        f'"3" {DOT} ("−20,3")',
        r"3 \cdot \mathopen{}\left(-20{,}3\right)",
        r"$3\cdot{}{\left({−}20{,}3\right)}$",
        "3\xa0·\xa0(−20,3)",
    ),
    Row(
        Fraction(plus(A, B), times(num("2"), C)),
        "(a + b) / (2\xa0c)",
        f'frac(a {PLUS} b, "2" thin c)',
        r"\frac{a + b}{2\,c}",
        r"$\frac{a+b}{2\,c}$",
        "(<i>a</i> +\xa0<i>b</i>)\xa0/\xa0(2\u202f<i>c</i>)",
    ),
    Row(
        Power(sym("omega", "OA"), 2),
        "ω_OA^2",
        "omega_(O A)^2",
        r"\omega_{O A}^{2}",
        r"$\omega_{OA}^{2}$",
        "<i>ω</i><sub><i>O</i><i>A</i></sub><sup>2</sup>",
    ),
    Row(
        Power(sym("a", "B", "n"), -2),
        "(a^n_B)^(−2)",
        "(a_(B)^(n))^(-2)",
        r"\mathopen{}\left(a_{B}^{n}\right)^{-2}",
        r"${\left(a_{B}^{n}\right)}^{-2}$",
        "(<i>a</i><sup><i>n</i></sup><sub><i>B</i></sub>)<sup>−2</sup>",
    ),
    Row(
        Power(Function("sin", PHI), 2),
        "sin^2\xa0φ",
        'op("sin")^2 phi',
        r"\mathop{\text{sin}}\nolimits^{2} \varphi",
        r"$\mathrm{sin}^{2}\,\varphi$",
        "sin<sup>2</sup>\u202f<i>φ</i>",
    ),
    Row(
        Root(plus(Power(A, 2), B)),
        "√(a^2 + b)",
        f"sqrt(a^2 {PLUS} b)",
        r"\sqrt{a^{2} + b}",
        r"$\sqrt{a^{2}+b}$",
        "√(<i>a</i><sup>2</sup> +\xa0<i>b</i>)",
    ),
    Row(Root(num("3")), "√3", 'sqrt("3")', r"\sqrt{3}", r"$\sqrt{3}$", "√3"),
    Row(
        cos(deg("40.5")),
        "cos\xa040.5°",
        'op("cos") "40.5°"',
        r"\mathop{\text{cos}}\nolimits 40.5^{\circ}",
        r"$\mathrm{cos}\,40.5\mathrm{°}$",
        "cos\u202f40.5°",
    ),
    Row(
        Function("arctg", Fraction(A, B)),
        "arctg(a / b)",
        'op("arctg") (frac(a, b))',
        r"\mathop{\text{arctg}}\nolimits \mathopen{}\left(\frac{a}{b}\right)",
        r"$\mathrm{arctg}{\left(\frac{a}{b}\right)}$",
        "arctg(<i>a</i>\xa0/\xa0<i>b</i>)",
    ),
    Row(
        Function("atan2", FormulaList((num("0,5"), num("-1")))),
        "atan2(0,5; −1)",
        r'op("atan2") ("0,5"\; "−1")',
        r"\mathop{\text{atan2}}\nolimits \mathopen{}\left(0{,}5; -1\right)",
        r"$\mathrm{atan2}{\left(0{,}5;{−}1\right)}$",
        "atan2(0,5;\xa0−1)",
    ),
    Row(Parenthesised(A), "(a)", "(a)", r"\mathopen{}\left(a\right)", r"${\left(a\right)}$", "(<i>a</i>)"),
    Row(
        Absolute(minus(A, B)),
        "|a − b|",
        f"abs(a {MINUS} b)",
        r"\mathopen{}\left|a - b\right|",
        r"${\left|a-b\right|}$",
        "|<i>a</i> −\xa0<i>b</i>|",
    ),
    Row(
        Vector(sym("a", "B", "tau")),
        "a\u20d7^τ_B",
        "arrow(a)_(B)^(tau)",
        r"\vec{a}_{B}^{\tau}",
        r"$\vec{a}_{B}^{\tau}$",
        "<i>a\u20d7</i><sup><i>τ</i></sup><sub><i>B</i></sub>",
    ),
    Row(
        Vector(sym("O1A")),
        "O\u20d71A\u20d7",
        "arrow(O_(1) A)",
        r"\overrightarrow{O_{1} A}",
        r"$\overrightarrow{O_{1}A}$",
        "<i>O\u20d7</i><sub>1</sub><i>A\u20d7</i>",
    ),
    Row(
        Dotted(sym("x", "B"), 1),
        "x\u0307_B",
        "dot(x)_(B)",
        r"\dot{x}_{B}",
        r"$\dot{x}_{B}$",
        "<i>x\u0307</i><sub><i>B</i></sub>",
    ),
    Row(Dotted(PHI, 2), "φ\u0308", "dot.double(phi)", r"\ddot{\varphi}", r"$\ddot{\varphi}$", "<i>φ\u0308</i>"),
    Row(
        Power(Dotted(PHI, 1), 2),
        "φ\u0307^2",
        "dot(phi)^2",
        r"\dot{\varphi}^{2}",
        r"$\dot{\varphi}^{2}$",
        "<i>φ\u0307</i><sup>2</sup>",
    ),
    Row(
        Cross(Vector(sym("omega")), Vector(sym("r"))),
        "ω\u20d7 × r\u20d7",
        f"arrow(omega) {CROSS} arrow(r)",
        r"\vec{\omega} \times \vec{r}",
        r"$\vec{\omega}\times{}\vec{r}$",
        "<i>ω\u20d7</i>\xa0×\xa0<i>r\u20d7</i>",
    ),
    Row(
        PointCoordinates(sym("A"), num("3"), num("-4,5")),
        "A(3; −4,5)",
        r'A ("3"\; "−4,5")',
        r"A\mathopen{}\left(3; -4{,}5\right)",
        r"$A{\left(3;{−}4{,}5\right)}$",
        "<i>A</i>(3;\xa0−4,5)",
    ),
    Row(
        Relation((A, B, sym("AB"), Measured(num("1"), CM_PER_S)), ("=", "→", "≈")),
        "a = b → AB ≈ 1\xa0cm/s",
        'a = b arrow.r A B approx "1" thin "cm/s"',
        r"a = b \to A B \approx 1\,\text{cm/s}",
        r"$a=b\to{}AB\approx{}1\,\mathrm{cm/s}$",
        "<i>a</i> =\xa0<i>b</i> →\xa0<i>A</i><i>B</i> ≈\xa01\xa0cm/s",
    ),
    Row(
        Relation((A, B, C), ("∥", "⟂")),
        "a ∥ b ⟂ c",
        "a parallel b perp c",
        r"a \parallel b \perp c",
        r"$a\parallel{}b\perp{}c$",
        "<i>a</i> ∥\xa0<i>b</i> ⟂\xa0<i>c</i>",
    ),
    Row(Surd(4, 9, 3), "4√3/9", 'frac("4" sqrt("3"), "9")', r"\frac{4\sqrt{3}}{9}", r"$\frac{4\sqrt{3}}{9}$", "4√3/9"),
    Row(Surd(-1, 2, 5), "−√5/2", '-frac(sqrt("5"), "2")', r"-\frac{\sqrt{5}}{2}", r"${-}\frac{\sqrt{5}}{2}$", "−√5/2"),
    Row(Surd(4, 3, 1), "4/3", 'frac("4", "3")', r"\frac{4}{3}", r"$\frac{4}{3}$", "4/3"),
    Row(Surd(-1, 1, 2), "−√2", '-sqrt("2")', r"-\sqrt{2}", r"${-}\sqrt{2}$", "−√2"),
    Row(Surd(-7, 1, 1), "−7", '-"7"', "-7", "${-}7$", "−7"),
    Row(
        Graph(sym("O"), ((num("1"), sym("A")), (num("2"), sym("B")))),
        "O —1→ A —2→ B",
        f'O {ARROW}^("1") A {ARROW}^("2") B',
        r"O \xrightarrow{1} A \xrightarrow{2} B",
        r"$O\;\overset{1}{\longrightarrow}\;A\;\overset{2}{\longrightarrow}\;B$",
        "<i>O</i>\xa0—<sup>1</sup>→\xa0<i>A</i>\xa0—<sup>2</sup>→\xa0<i>B</i>",
    ),
    Row(FormulaList((A, B)), "a, b", r"a\, b", "a, b", r"$a,\,b$", "<i>a</i>, <i>b</i>"),
    Row(Equation(A, num("2,5")), "a = 2,5", 'a = "2,5"', "a = 2{,}5", "$a=2{,}5$", "<i>a</i>\xa0=\xa02,5"),
    Row(Quotient(A, B), "a/b", r"a\/b", "a/b", "$a/b$", "<i>a</i><i>/</i><i>b</i>"),
    Row(SymbolProperty("modulus", A), "|a|", "abs(a)", r"\left|a\right|", "$|a|$", "|<i>a</i>|"),
    Row(
        UnitText((("cm", 1), ("s", -2))),
        "cm s⁻²",
        '"cm" "s"^("−2")',
        r"\text{cm}\text{s}^{-2}",
        r"$\mathrm{cm}\,\mathrm{s}^{-2}$",
        "cm s<sup>−2</sup>",
    ),
]  # fmt: skip
FORMULAS = [row.formula for row in ROWS] + list(LINES)

# Where parentheses stand and where not: plain text, whose fractions have no bar, and Typst.
PARENTHESES = [
    (Sum(((1, A), (1, num("-3")))), "a + (−3)", f'a {PLUS} ("−3")'),
    (minus(A, minus(B, C)), "a − (b − c)", f"a {MINUS} (b {MINUS} c)"),
    (plus(minus(A, B), C), "a − b + c", f"a {MINUS} b {PLUS} c"),
    (Sum(((-1, plus(A, B)),)), "−(a + b)", f"-(a {PLUS} b)"),
    (plus(A, Fraction(num("-3"), num("4"))), "a + (−3 / 4)", f'a {PLUS} frac("−3", "4")'),
    (minus(A, Surd(-1, 1, 2)), "a − (−√2)", f'a {MINUS} (-sqrt("2"))'),
    (times(num("-3"), A), "−3\xa0a", '"−3" thin a'),
    (times(A, num("-3"), B), "a · (−3) · b", f'a {DOT} ("−3") {DOT} b'),
    (times(num("-3"), num("-4")), "−3 · (−4)", f'"−3" {DOT} ("−4")'),
    (times(num("2"), plus(A, B)), "2 · (a + b)", f'"2" {DOT} (a {PLUS} b)'),
    (times(num("0.5"), A), "0.5 · a", f'"0.5" {DOT} a'),
    (times(num("2"), sym("AB")), "2 · AB", f'"2" {DOT} A B'),
    (times(num("2"), Power(A, 2)), "2\xa0a^2", '"2" thin a^2'),
    (times(num("3"), num("2"), A), "3 · 2 · a", f'"3" {DOT} "2" {DOT} a'),
    (times(num("120"), cos(PHI)), "120 · cos\xa0φ", f'"120" {DOT} op("cos") phi'),
    (times(cos(PHI), A), "cos\xa0φ · a", f'op("cos") phi {DOT} a'),
    (times(sym("AB"), cos(PHI)), "AB\xa0cos\xa0φ", 'A B thin op("cos") phi'),
    (times(Fraction(A, B), C), "(a / b) · c", f"frac(a, b) {DOT} c"),
    (times(C, Fraction(A, B)), "c · a / b", f"c {DOT} frac(a, b)"),
    (Fraction(Fraction(A, B), C), "(a / b) / c", "frac(frac(a, b), c)"),
    (Fraction(A, Fraction(B, C)), "a / (b / c)", "frac(a, frac(b, c))"),
    (Fraction(times(A, B), cos(PHI)), "a · b / cos\xa0φ", f'frac(a {DOT} b, op("cos") phi)'),
    (Fraction(A, Measured(num("4"), CM_PER_S)), "a / (4\xa0cm/s)", 'frac(a, "4" thin "cm/s")'),
    (Fraction(Measured(num("4"), CM_PER_S), A), "(4\xa0cm/s) / a", 'frac("4" thin "cm/s", a)'),
    (Fraction(num("1"), Surd(2, 1, 3)), "1 / (2√3)", 'frac("1", "2" sqrt("3"))'),
    (Power(num("-3"), 2), "(−3)^2", '("−3")^2'),
    (Power(num("3"), 2), "3^2", '"3"^2'),
    (Power(times(A, B), 2), "(a · b)^2", f"(a {DOT} b)^2"),
    (Power(Fraction(A, B), 2), "(a / b)^2", "(frac(a, b))^2"),
    (Power(Power(A, 2), 12), "(a^2)^12", "(a^2)^(12)"),
    (Power(Root(A), 2), "(√a)^2", "sqrt(a)^2"),
    (Power(cos(PHI), -1), "(cos\xa0φ)^(−1)", '(op("cos") phi)^(-1)'),
    (Power(Parenthesised(A), 2), "(a)^2", "(a)^2"),
    (Power(Absolute(A), 2), "|a|^2", "abs(a)^2"),
    (Power(deg("30"), 2), "(30°)^2", '("30°")^2'),
    (Root(Power(A, 2)), "√(a^2)", "sqrt(a^2)"),
    (cos(num("-1")), "cos(−1)", 'op("cos") ("−1")'),
    (cos(deg("-30")), "cos(−30°)", 'op("cos") ("−30°")'),
    (cos(Parenthesised(plus(A, B))), "cos(a + b)", f'op("cos") (a {PLUS} b)'),
    (cos(times(A, B)), "cos(a · b)", f'op("cos") (a {DOT} b)'),
    (times(A, Power(cos(PHI), -1)), "a · (cos\xa0φ)^(−1)", f'a {DOT} (op("cos") phi)^(-1)'),
    (plus(A, times(Sum(((-1, A), (1, B))), C)), "a + (−a + b) · c", f"a {PLUS} (-a {PLUS} b) {DOT} c"),
    (plus(A, Fraction(Sum(((-1, A), (1, B))), C)), "a + (−a + b) / c", f"a {PLUS} frac(-a {PLUS} b, c)"),
    (Cross(A, Cross(A, B)), "a × (a × b)", f"a {CROSS} (a {CROSS} b)"),
    (Cross(plus(A, B), C), "(a + b) × c", f"(a {PLUS} b) {CROSS} c"),
    (times(num("2"), Cross(A, B)), "2\xa0a × b", f'"2" thin a {CROSS} b'),
    (Cross(times(num("2"), A), B), "2\xa0a × b", f'"2" thin a {CROSS} b'),
    (times(A, Cross(B, C)), "a · (b × c)", f"a {DOT} (b {CROSS} c)"),
    (times(Cross(A, B), C), "(a × b) · c", f"(a {CROSS} b) {DOT} c"),
    (Fraction(FormulaList((A, B)), PointCoordinates(sym("A"), A, B)), "(a, b) / A(a; b)", r"frac(a\, b, A (a\; b))"),
]  # fmt: skip


@pytest.fixture(scope="module")
def engine() -> Iterator[Typesetter]:
    with typesetter() as found:
        yield found


def set_by_the_engine(engine: Typesetter, formulas: list[Formula], path: Path) -> list[str]:
    """The text on the page of each formula, as a reader of PDF finds it."""
    (engine.root / "formulas.typ").write_text(
        '#import "common.typ": *\n#show: document-style.with("ru")\n#set page(width: 300mm, height: auto)\n'
        "#for markup in json(inputs.data) { formula(markup); pagebreak(weak: true) }\n",
        "utf-8",
    )
    path.write_bytes(engine.compile("formulas.typ", [markup(formula) for formula in formulas])[0])
    document = pypdfium2.PdfDocument(path)
    texts = [page.get_textpage().get_text_bounded() for page in document]
    document.close()
    return texts


def test_every_kind_has_a_row() -> None:
    shown = {type(row.formula) for row in ROWS}
    leaves = {"Symbol", "Number", "Measured"}
    assert {kind.__name__ for kind in get_args(Formula)} == {kind.__name__ for kind in shown} | leaves


@pytest.mark.parametrize("row", ROWS, ids=lambda row: row.plain)
def test_markups(row: Row) -> None:
    formula = row.formula
    found = Row(formula, *(write(formula) for write in (to_plain, to_typst, to_latex, to_mathtext, to_html)))
    assert found == row


@pytest.mark.parametrize(
    ("formula", "plain", "typst"), PARENTHESES, ids=lambda item: item if isinstance(item, str) else ""
)
def test_parentheses_and_signs_between_factors(formula: Formula, plain: str, typst: str) -> None:
    assert (to_plain(formula), to_typst(formula)) == (plain, typst)


def test_the_engine_takes_every_kind(engine: Typesetter, tmp_path: Path) -> None:
    formulas = FORMULAS + [formula for formula, _, _ in PARENTHESES]
    assert len(set_by_the_engine(engine, formulas, tmp_path / "all.pdf")) == len(formulas)


@pytest.mark.parametrize("formula", FORMULAS, ids=to_plain)
def test_matplotlib_takes_every_kind(formula: Formula) -> None:
    markup = to_mathtext(formula)
    assert " " not in markup
    with rc_context(STYLE):
        assert MathTextParser("path").parse(markup).width > 0


def test_the_strict_reader_takes_the_html_of_every_kind() -> None:
    body = "".join(f"<p>{to_html(formula)}</p>" for formula in FORMULAS)
    tree = html5lib.HTMLParser(strict=True, namespaceHTMLElements=False).parse(f"<!DOCTYPE html><title>x</title>{body}")
    assert len(tree.findall(".//p")) == len(FORMULAS)


def test_latex_takes_every_kind(tmp_path: Path, pdflatex: Callable[[str], Path]) -> None:
    formulas = [*FORMULAS, Function("тг_%", plus(num("1 %"), A))]
    head = r"\documentclass{article}\usepackage[T2A]{fontenc}\usepackage[utf8]{inputenc}\usepackage{amsmath}"
    lines = "\n\n".join(f"${to_latex(formula)}$" for formula in formulas)
    (tmp_path / "all.tex").write_text(f"{head}\n\\begin{{document}}\n{lines}\n\\end{{document}}\n", "utf-8")
    assert pdflatex("all.tex").stat().st_size > 10_000


@pytest.mark.parametrize(
    "text", ['"]; #panic("x") "', "\\", '"', "a\\", "$x$", "#x", "/* ", "// ", "</i><b>", "&amp;", ","]
)
def test_words_and_numbers_are_never_markup(engine: Typesetter, tmp_path: Path, text: str) -> None:
    """The engine and a browser show the very letters; the formula around them is whole."""
    unit = UnitText(((text, 1),))
    formula = Fraction(Function(text, A), times(num("7"), Measured(num(text), unit)))
    (shown,) = set_by_the_engine(engine, [formula], tmp_path / "one.pdf")
    letters = shown.replace("\u2212", "-").replace(" ", "")
    assert letters.count(text.replace(" ", "")) == 3
    markup = f"<!DOCTYPE html><title>x</title><p>{to_html(formula)}</p>"
    tree = html5lib.HTMLParser(strict=True, namespaceHTMLElements=False).parse(markup)
    assert "".join(tree.find(".//p").itertext()).count(text) == 3
    assert "7" in letters


def test_figures_refuse_what_stands_in_texts_only() -> None:
    with pytest.raises(TypeError, match="Fraction"):
        typeset(Fraction(A, B))


@pytest.mark.parametrize(
    "wrong",
    [
        lambda: Relation((A, B), ("=", "=")),
        lambda: Relation((A, B), (">",)),
        lambda: Dotted(A, 3),
        lambda: Surd(1, 0, 2),
        lambda: Surd(1, 1, -2),
        lambda: Sum(()),
        lambda: Sum(((2, A),)),
        lambda: Product(()),
    ],
)
def test_what_cannot_be_written_is_refused(wrong: Callable[[], Formula]) -> None:
    with pytest.raises(ValueError, match=r"."):
        wrong()
