"""All back ends draw the same: places recovered from each output are those of the drawing."""

from __future__ import annotations

import re
import sys
import xml.etree.ElementTree as ET
from collections.abc import Callable
from pathlib import Path

import numpy as np
import pypdfium2
import pytest
from matplotlib.patches import Rectangle
from msgspec.structs import replace

from variantgen.errors import InputError, ToolMissingError
from variantgen.figure.drawing import MEDIUM, THIN, Arc, Drawing, Label, Layer
from variantgen.figure.drawing import Path as Polyline
from variantgen.figure.letters.lettering import letters_of, typeset
from variantgen.figure.placement.label_requests import label_size
from variantgen.outputs.figures import MILLIMETRES, back_ends, mpl, png, write_figure
from variantgen.outputs.figures.svg import svg
from variantgen.outputs.figures.tikz import tikz
from variantgen.outputs.single.picture import Picture, picture
from variantgen.outputs.typst.typesetter import typesetter
from variantgen.outputs.typst.writing import figure_data
from variantgen.single import one_variant
from variantgen.wording.formula import Index, Symbol

FAMILIES = ["sleeve_on_crank", "planetary_train", "movable_pulley", "guided_plate", "hydraulic_hoist", "ladder"]
NUMBER = r"-?\d*\.?\d+"


@pytest.fixture(params=FAMILIES)
def drawn(request: pytest.FixtureRequest) -> Picture:
    return picture(one_variant(request.param, seed="4"), language="ru")


def corners(drawing: Drawing) -> list[complex]:
    return [point for line in drawing.lines if isinstance(line, Polyline) for point in line.points]


def near(wanted: list[complex], found: list[complex], tolerance: float) -> None:
    every = np.array(found)
    for place in wanted:
        assert np.min(np.abs(every - place)) <= tolerance, place


def svg_places(drawing: Drawing, text: str) -> tuple[list[complex], list[complex]]:
    """Points of the curves and origins of the letters of an SVG, y up."""
    root = ET.fromstring(text)
    space = "{http://www.w3.org/2000/svg}"
    lines, letters = root.findall(f"{space}g")
    points = []
    for path in lines.findall(f"{space}path"):
        numbers = [float(n) for n in re.findall(NUMBER, path.attrib["d"])]
        points += [complex(x, drawing.height - y) for x, y in zip(numbers[0::2], numbers[1::2], strict=True)]
    origins = []
    for path in letters.findall(f"{space}path"):
        x, y = (float(n) for n in re.findall(NUMBER, path.attrib["transform"])[:2])
        origins.append(complex(x, drawing.height - y))
    return points, origins


def test_svg_has_every_line_and_letter_in_its_place(drawn: Picture) -> None:
    drawing = drawn.drawing
    points, origins = svg_places(drawing, drawn.svg)
    near(corners(drawing), points, 0.01)
    near([arc.at(t) for arc in drawing.lines if isinstance(arc, Arc) for t in (0, 1)], points, 0.01)
    wanted = [at for label in drawing.labels for _, at in letters_of(label)]
    assert len(origins) == len(wanted)
    near(wanted, origins, 0.01)


def test_figures_of_one_page_do_not_clash() -> None:
    figures = [picture(one_variant("four_bar", seed=seed)).drawing for seed in ("1", "2", "3")]
    texts = [svg(Drawing(f.width, f.height, f.lines, f.labels, tell=lambda: "words"), "Title") for f in figures]
    names = [name for text in texts for name in re.findall(r'id="([^"]*)"', text)]
    assert len(names) == len(set(names)) == 6
    again = figures[0]
    assert texts[0] == svg(Drawing(again.width, again.height, again.lines, again.labels, tell=lambda: "words"), "Title")


def test_words_of_an_svg_are_text() -> None:
    drawing = picture(one_variant("four_bar")).drawing
    text = svg(Drawing(drawing.width, drawing.height, drawing.lines, drawing.labels, tell=lambda: '<script> & "words"'))
    description = ET.fromstring(text).find("{http://www.w3.org/2000/svg}desc")
    assert description is not None
    assert description.text == '<script> & "words"'


def engine_places(node: ET.Element, shift: complex, flipped: bool) -> list[complex]:
    """Origins of the glyphs of an SVG of the engine, whose groups are nested."""
    transform = node.attrib.get("transform", "")
    numbers = [float(number) for number in re.findall(NUMBER, transform)]
    if transform:
        assert transform.startswith(("matrix(1 0 0 ", "translate("))
        shift += complex(numbers[-2], (-1 if flipped else 1) * numbers[-1])
        flipped ^= transform.startswith("matrix") and numbers[3] < 0
    found = [shift + float(node.attrib["x"])] if node.tag.endswith("use") else []
    for child in node:
        found += engine_places(child, shift, flipped)
    return found


@pytest.mark.parametrize("letters", [False, True], ids=["equations", "letters in a line"])
def test_the_typeset_figure_has_the_same_places(drawn: Picture, letters: bool) -> None:
    drawing = drawn.drawing
    data = figure_data(drawing)
    data["labels"] = data["labels"].data(letters)
    assert bool(data["labels"]["markup"]) != letters
    page = '#import "figure.typ": draw-figure\n#import "common.typ": *\n'
    page += "#set page(width: auto, height: auto, margin: 0pt)\n"
    page += '#show: document-style.with("ru")\n#let figure = json(inputs.data).figure\n'
    page += "#draw-figure(figure, labels-of(figure), 1000pt, 1pt)\n"
    with typesetter() as engine:
        (engine.root / "one.typ").write_text(page)
        made = engine.compile("one.typ", {"figure": data}, "svg")[0].decode()
    found = [complex(z.real, drawing.height - z.imag) for z in engine_places(ET.fromstring(made), 0j, False)]
    wanted = [at for label in drawing.labels for _, at in letters_of(label)]
    assert len(found) == len(wanted)
    near(wanted, found, 0.03)


def test_matplotlib_has_every_line_and_letter_in_its_place(drawn: Picture) -> None:
    drawing = drawn.drawing
    made = drawn.matplotlib()
    (axes,) = made.axes
    assert (axes.get_xlim(), axes.get_ylim()) == ((0, drawing.width), (0, drawing.height))
    assert made.get_size_inches() * 25.4 == pytest.approx([MILLIMETRES * drawing.width, MILLIMETRES * drawing.height])
    patches = [patch for patch in axes.patches if hasattr(patch, "get_path") and type(patch).__name__ == "PathPatch"]
    below = [patch for patch in patches if patch.get_zorder() <= 2 + Layer.LABEL]
    places = [complex(*vertex) for patch in below for vertex in patch.get_path().vertices]
    near(corners(drawing), places, 1e-9)
    glyphs = [patch for patch in patches if patch.get_zorder() > 2 + Layer.LABEL]
    assert len(glyphs) == sum(len(letters_of(label)) for label in drawing.labels)
    for label in drawing.labels:
        ink = np.concatenate([p.get_path().vertices for p in glyphs if p.get_path().codes[-1] == 79])
        low = label.at.imag - 0.5 * label.size[1]
        assert np.min(np.abs(ink[:, 1] - low)) < 0.25


def test_tikz_has_every_line_and_label_in_its_place(drawn: Picture) -> None:
    drawing, source = drawn.drawing, drawn.tikz
    places = [complex(float(x), float(y)) for x, y in re.findall(rf"\(({NUMBER}),({NUMBER})\)", source)]
    near(corners(drawing), places, 0.01)
    near([label.at for label in drawing.labels], places, 0.01)
    assert source.count(r"\node[letters") == len(drawing.labels)
    circles = sum(isinstance(line, Arc) and line.full for line in drawing.lines)
    assert source.count("circle[radius=") == circles
    # Nothing but named pens: the styles are said once.
    assert "line width" not in source.split("]\n", 1)[1]


def test_tikz_compiles(tmp_path: Path, pdflatex: Callable[[str], Path]) -> None:
    variants = [one_variant(name, seed="2") for name in FAMILIES]
    pictures = [tikz(picture(variant, language=lang).drawing) for variant in variants for lang in ("en", "ru")]
    head = r"\documentclass{article}\usepackage[T2A]{fontenc}\usepackage[utf8]{inputenc}\usepackage{amsmath,tikz}"
    source = "\n\n".join((head, r"\begin{document}", *pictures, r"\end{document}"))
    (tmp_path / "all.tex").write_text(source, "utf-8")
    assert pdflatex("all.tex").stat().st_size > 10_000


@pytest.mark.parametrize("language", ["en", "ru"])
def test_a_tex_file_is_one_page_of_the_size_of_the_figure(
    tmp_path: Path, pdflatex: Callable[[str], Path], language: str
) -> None:
    shown = picture(one_variant("quick_return_shaper", seed="2"), language=language, ask=["v_rel_A"])
    shown.save(tmp_path / "figure.tex", width_mm=70)
    document = pypdfium2.PdfDocument(pdflatex("figure.tex"))
    (page,) = document
    width, height = page.get_size()
    points = 72 / 25.4
    assert width == pytest.approx(70 * points, abs=0.1)
    assert height == pytest.approx(70 * points * shown.drawing.height / shown.drawing.width, abs=0.1)
    assert np.min(page.render().to_numpy()) < 100  # it is the page with the figure
    document.close()


def test_every_ending_writes_its_format(tmp_path: Path) -> None:
    drawing = replace(picture(one_variant("slider_crank")).drawing, tell=lambda: "A figure.")
    heads = {
        ".svg": b"<?xml",
        ".png": b"\x89PNG",
        ".pdf": b"%PDF",
        ".tikz": b"% A figure.\n\\begin{tikzpicture}",
        ".tex": b"\\RequirePackage",
    }
    assert set(back_ends()) == set(heads)
    for suffix, head in heads.items():
        path = tmp_path / f"figure{suffix}"
        write_figure(drawing, path)
        assert path.read_bytes().startswith(head)
        before = path.read_bytes()
        write_figure(drawing, path)
        assert path.read_bytes() == before
    assert len(list(tmp_path.iterdir())) == len(heads)


DASHED = Drawing(
    100.0,
    40.0,
    (
        Polyline((5 + 5j, 95 + 5j), Layer.MARK, THIN, dash="dashed"),
        Arc(50 + 20j, 12.0, Layer.DISC, MEDIUM, dash="dashdot", fill="shade"),
    ),
    (Label(Symbol("omega", (Index("OA"),)), 80 + 30j, label_size(Symbol("omega", (Index("OA"),)))),),
)


@pytest.mark.parametrize("width", [None, 60.0])
def test_dashes_and_pens_are_the_same_everywhere(width: float | None) -> None:
    """Lengths of dashes, pens and the box of a label in millimetres, taken from each output."""
    unit = MILLIMETRES if width is None else width / DASHED.width
    wanted = [(THIN * unit, [3.0 * unit, 1.8 * unit]), (MEDIUM * unit, [x * unit for x in (4.0, 1.2, 0.6, 1.2)])]
    root = ET.fromstring(svg(DASHED, width_mm=width))
    scale = float(root.attrib["width"].removesuffix("mm")) / float(root.attrib["viewBox"].split()[2])
    lines = root.findall(".//{http://www.w3.org/2000/svg}path[@stroke-dasharray]")
    from_svg = [
        (scale * float(x.attrib["stroke-width"]), [scale * float(n) for n in x.attrib["stroke-dasharray"].split()])
        for x in lines
    ]
    inch = 25.4 / 72
    patches = mpl.figure(DASHED, width).axes[0].patches
    from_mpl = [
        (inch * p.get_linewidth(), [inch * p.get_linewidth() * x for x in p.get_linestyle()[1]])
        for p in patches
        if not isinstance(p.get_linestyle(), str)
    ]
    source = tikz(DASHED, width)
    point = 25.4 / 72.27
    lengths = [
        [point * float(x) for x in re.findall(r"o(?:n|ff) ([\d.]+)pt", found)]
        for found in re.findall(r"dash pattern=([^}]*)}", source)
    ]
    pens = {name: point * float(x) for name, x in re.findall(r"(\w+)/.style={line width=([\d.]+)pt}", source)}
    from_tikz = [(pens["fine"], lengths[0]), (pens["medium"], lengths[1])]
    curves = figure_data(DASHED)["curves"]
    drawn = [(weight, dash) for weight, _, dash, *_ in curves.one_by_one() if weight]
    image = [  # in hundredths
        (0.01 * float(x.attrib["stroke-width"]), [0.01 * float(n) for n in x.attrib["stroke-dasharray"].split()])
        for x in ET.fromstring(curves.image).findall(".//{http://www.w3.org/2000/svg}path[@stroke-dasharray]")
    ]
    from_engine, from_image = (
        [(unit * weight, [unit * x for x in dash]) for weight, dash in found] for found in (drawn, image)
    )
    every = (from_svg, 1e-3), (from_mpl, 1e-6), (from_tikz, 0.02), (from_engine, 1e-9), (from_image, 1e-9)
    for found, near_by in every:
        assert len(found) == 2
        for (pen, dashes), (wanted_pen, wanted_dashes) in zip(found, wanted, strict=True):
            assert pen == pytest.approx(wanted_pen, abs=near_by)
            assert dashes == pytest.approx(wanted_dashes, abs=near_by)


def test_paper_lies_behind_each_label() -> None:
    (label,) = DASHED.labels
    width, height = (side + 0.3 for side in label.size)
    rect = ET.fromstring(svg(DASHED)).find(".//{http://www.w3.org/2000/svg}rect")
    assert rect is not None
    box = [float(rect.attrib[key]) for key in ("x", "y", "width", "height")]
    low = label.at - complex(width, height) / 2
    assert box == pytest.approx([low.real, DASHED.height - low.imag - height, width, height], abs=0.011)
    (*_, (weight, fill, _, path)) = figure_data(DASHED)["curves"].one_by_one()
    assert (weight, fill) == (0, "paper")
    corners = [complex(int(x), int(y)) / 100 for x, y in re.findall(r"(-?\d+) (-?\d+)", path)]
    top = DASHED.height - low.imag - height
    wanted = [complex(x, y) for y in (top, top + height) for x in (low.real, low.real + width)]
    assert sorted(map(abs, corners)) == pytest.approx(sorted(map(abs, wanted)), abs=0.011)
    (paper,) = [p for p in mpl.figure(DASHED).axes[0].patches if isinstance(p, Rectangle)]
    assert (*paper.get_xy(), paper.get_width(), paper.get_height()) == pytest.approx(
        (low.real, low.imag, width, height)
    )


def test_a_figure_keeps_its_size() -> None:
    shown = picture(one_variant("spool", seed="2"))
    wide = ET.fromstring(svg(shown.drawing, width_mm=120)).attrib
    assert wide["width"] == "120mm"
    dots = [
        int.from_bytes(png.render(shown.drawing, 50, ppi=ppi)[16:20], "big") for ppi in (100.0, 300.0)
    ]  # the width stands in the head of a PNG
    assert dots == pytest.approx([50 / 25.4 * 100, 50 / 25.4 * 300], abs=1.5)


def test_pens_on_axes_of_a_page_follow_their_size() -> None:
    from matplotlib.figure import Figure

    page = Figure(figsize=(8, 16))
    small, large = page.add_axes((0, 0.5, 0.25, 0.5)), page.add_axes((0, 0, 1, 0.5))
    shown = picture(one_variant("slider_crank"))
    for axes in (small, large):
        assert shown.matplotlib(axes) is page
    thickest, of_small = (max(patch.get_linewidth() for patch in axes.patches) for axes in (large, small))
    assert thickest == pytest.approx(4 * of_small)
    assert not large.axison


def test_a_wrong_ending_or_folder_is_said(tmp_path: Path) -> None:
    drawing = picture(one_variant("slider_crank")).drawing
    with pytest.raises(InputError, match=r"unknown format.*\.svg"):
        write_figure(drawing, tmp_path / "figure.svgz")
    with pytest.raises(InputError, match="cannot be written"):
        write_figure(drawing, tmp_path / "nowhere" / "figure.svg")


def test_a_variant_shows_itself() -> None:
    shown = picture(one_variant("rolling_wheel", seed="3"), language="ru", ask=["v_A"])
    assert shown._repr_svg_().startswith("<svg")
    assert {"A", "O"} <= {label.formula.base for label in shown.drawing.labels if isinstance(label.formula, Symbol)}
    with pytest.raises(InputError, match="kind of figure"):
        picture(one_variant("rolling_wheel"), "velocity_pln")


def test_letters_have_the_size_that_placement_counted_with() -> None:
    formula = Symbol("v", (Index("отн", True), Index("M")))
    found = typeset(formula)
    assert found.width == pytest.approx(2.696, abs=0.01)  # measured by the engine


def test_all_but_plots_goes_without_matplotlib(tmp_path: Path, monkeypatch: pytest.MonkeyPatch) -> None:
    monkeypatch.setitem(sys.modules, "matplotlib", None)
    shown = picture(one_variant("slider_crank"))
    shown.save(tmp_path / "figure.svg")
    assert "\\begin{tikzpicture}" in shown.tikz
    with pytest.raises(ToolMissingError, match=r'pip install "\.\[plots\]"'):
        shown.matplotlib()


@pytest.mark.parametrize("language", ["en", "ru"])
def test_a_page_of_one_figure_says_its_language(language: str, tmp_path: Path) -> None:
    import pikepdf

    path = tmp_path / "figure.pdf"
    picture(one_variant("four_bar"), language=language).save(path)
    with pikepdf.open(path) as document:
        assert str(document.Root.Lang) == language
