"""Content as source text: nothing from outside is code; what stands apart from its line stands where it stood in it."""

from __future__ import annotations

import json
import re
import xml.etree.ElementTree as ET

import pytest
import typst

from tests.outputs.test_hostile_text import LITERAL, STRANGE
from tests.outputs.test_set_formulas import NUMBER, SVG, glyphs
from tests.outputs.test_set_pieces import PIECES
from variantgen.outputs.typst.formula_lines import in_lines
from variantgen.outputs.typst.markup import markup, piece
from variantgen.outputs.typst.row_source import placed_lines, row_source
from variantgen.outputs.typst.source import TypstSource, array, string
from variantgen.outputs.typst.typesetter import typesetter
from variantgen.wording.formula import Fraction, Number, Root, Symbol

HOSTILE = [
    *LITERAL,
    *STRANGE,
    '";panic();"',
    "\\",
    '\\"',
    '\\"]});panic()//',
    "\\u{41}",
    "a\nb",
    "",
    "#[*x*]",
    "//",
    "/* */",
]
ROWS = [
    *([[("", piece(formula)), ("=", piece(formula))]] for formula in PIECES),
    [[("", piece(Number("8" * 20))), ("=", piece(Fraction(Number("1"), Number("2"))))]] * 2,  # two lines
    [[("", piece(Root(Number("8" * 52))))]],  # smaller
]
PAGES = """#import "solution.typ": contents, em, standing
#let (rows, placed, bodies) = contents("rows.txt")
#set page(width: 180mm, height: 200pt, margin: 0pt)
#set text(size: em)
#for (row, items) in rows.zip(placed) {
  page(place(top + left, row))
  let at(length) = (length * em).mm()
  page(standing(items.map(((how, number, right, down)) => (how, number, at(right), at(down), 0)), bodies, ()))
}
"""


def test_strings_are_the_text_itself() -> None:
    with typesetter() as engine:
        (engine.root / "strings.txt").write_text(array(map(string, HOSTILE)), "utf-8")
        asked = engine.root / "asked.typ"
        asked.write_text('#import "solution.typ": contents\n#metadata(contents("strings.txt"))<found>', "utf-8")
        found = json.loads(typst.query(asked, "<found>", field="value", one=True, root=engine.root))
    assert found == HOSTILE


def test_what_comes_again_is_made_once() -> None:
    source = TypstSource(letters=True, spoken=False)
    speed = markup(Symbol("v"))
    shown = [source.formula(speed), source.formula(speed), source.steady(["at ", [speed]])]
    assert shown[0] == shown[1]
    assert shown[2] == f'{{"at ";{shown[0]}}}'
    assert source.value("none").count("letters(") == 1


def test_equations_have_their_words_only_where_they_are_read_out() -> None:
    speed = markup(Symbol("v"))
    spoken, silent = TypstSource(letters=False, spoken=True), TypstSource(letters=False, spoken=False)
    for source in (spoken, silent):
        source.formula(speed)
    assert f'alt:"{speed.plain}"' in spoken.value("none")
    assert "alt:" not in silent.value("none")


@pytest.fixture(scope="module")
def pages() -> list[ET.Element]:
    rows = [in_lines(row, ".") for row in ROWS]
    source = TypstSource(letters=True, spoken=False)
    bodies: list[str] = []
    placed = []
    for row in rows:
        items = []
        for how, code, right, down in placed_lines(source, row):
            items.append(f'("{how}",{len(bodies)},{right},{down})')
            bodies.append(code)
        placed.append(array(items))
    whole = f"(rows:{array(row_source(source, row) for row in rows)},placed:{array(placed)},bodies:{array(bodies)})"
    with typesetter() as engine:
        (engine.root / "rows.txt").write_text(source.value(whole), "utf-8")
        (engine.root / "pages.typ").write_text(PAGES, "utf-8")
        made = typst.compile(engine.root / "pages.typ", root=engine.root, format="svg", ignore_system_fonts=True)
    assert isinstance(made, list)
    return [ET.fromstring(page) for page in made]


def beginnings(node: ET.Element, shift: complex = 0j) -> list[complex]:
    """Where the bars and signs of a page begin."""
    numbers = [float(number) for number in re.findall(NUMBER, node.attrib.get("transform", ""))]
    if numbers:
        right, down, *_ = [*numbers[4 * (len(numbers) == 6) :], 0.0]
        shift += complex(right, down)
    if node.tag == f"{SVG}symbol":
        return []
    path = node.attrib.get("d", "") if node.tag == f"{SVG}path" and node.get("fill") != "#ffffff" else ""
    here, at, moved = [], shift, False
    for step, places in re.findall(r"([MmLlHhVvCcZ])([^MmLlHhVvCcZ]*)", path):
        numbers = [float(number) for number in re.findall(NUMBER, places)]
        assert step in "MmhvlcZ"
        if step == "Z":
            continue
        if moved and step not in "Mm":
            here.append(at)
        moved = step in "Mm"
        to = complex(0, numbers[0]) if step == "v" else complex(numbers[-2] if step != "h" else numbers[0], 0)
        if step in "Mmlc":
            to += 1j * numbers[-1]
        at = shift + to if step == "M" else at + to
    return [*here, *(place for child in node for place in beginnings(child, shift))]


@pytest.mark.parametrize("number", range(len(ROWS)))
def test_what_stands_apart_stands_where_it_stood_in_its_line(pages: list[ET.Element], number: int) -> None:
    inline, apart = pages[2 * number], pages[2 * number + 1]
    for found in (beginnings, lambda page: [at for _, at in glyphs(page)]):
        one, other = found(inline), found(apart)
        assert len(one) == len(other)
        for at in one:
            near = min(other, key=lambda place: abs(place - at))
            assert abs(near - at) < 0.05, "points"
            other.remove(near)


def test_rows_with_bars_and_signs_are_among_them(pages: list[ET.Element]) -> None:
    assert sum(len(beginnings(page)) for page in pages[1::2]) > 2 * len(PIECES)
