"""Directions in words, what the catalogue does not show (rigid sleeves and sliders), and the text in a PDF."""

from __future__ import annotations

import cmath
import io
import math
import pickle
from pathlib import Path
from types import MappingProxyType

import pikepdf
import pytest
from msgspec.structs import replace

from benchmarks.sheets import drawn_sheets
from variantgen.cli import main
from variantgen.exam.content import Content
from variantgen.exam.exam_file import read_exam
from variantgen.exam.roster import numbered
from variantgen.exam.samples import exam_path
from variantgen.figure.alt_text.directions import compass, is_parallel, line, side
from variantgen.figure.build import statement_figure
from variantgen.outputs.documents.sheet_data import sheets_data
from variantgen.outputs.single.picture import picture
from variantgen.outputs.typst.sheet_pages import with_pages
from variantgen.outputs.typst.typesetter import typesetter
from variantgen.outputs.typst.writing import TYPST
from variantgen.single import asked_quantities, one_variant
from variantgen.variants.variant import solve_variants
from variantgen.wording.language import load_language


@pytest.mark.parametrize(
    ("degrees", "key"),
    [(0, "e"), (0.9, "e"), (-0.9, "e"), (2, "ene"), (-2, "ese"), (45, "ne"), (88, "nne"), (90, "n"), (92, "nnw"),
     (135, "nw"), (178, "wnw"), (180, "w"), (-178, "wsw"), (-135, "sw"), (-92, "ssw"), (-90, "s"), (-88, "sse"),
     (-45, "se"), (22, "ene"), (23, "ne"), (67, "ne"), (68, "nne")],
)  # fmt: skip
def test_sixteen_directions(degrees: float, key: str) -> None:
    assert compass(3.0 * cmath.rect(1.0, math.radians(degrees))) == key


@pytest.mark.parametrize(
    ("degrees", "key"), [(0, "e"), (22, "e"), (23, "ne"), (90, "n"), (120, "nw"), (180, "w"), (-90, "s"), (-50, "se")]
)
def test_eight_sides(degrees: float, key: str) -> None:
    assert side(cmath.rect(2.0, math.radians(degrees))) == key


@pytest.mark.parametrize(
    ("degrees", "key"),
    [(0, "level"), (180, "level"), (90, "upright"), (30, "rising"), (210, "rising"), (-5, "falling")],
)
def test_four_ways_of_a_line(degrees: float, key: str) -> None:
    assert line(cmath.rect(1.0, math.radians(degrees))) == key


def test_parallel_either_way() -> None:
    assert is_parallel(2 + 1j, -4 - 2j)
    assert not is_parallel(2 + 1j, 2 - 1j)


# A rod fixed to a slider, and a crank whose pin carries a sleeve that is fixed to a second rod.
SCENE = """
length_unit = "cm"
[points]
O = { coordinates = { x = 0, y = 0 } }
A = { polar = { origin = "O", distance = 20, angle = 60 } }
B = { on_body = { origin = "O", towards = "A", along = 8 } }
D = { on_body = { origin = "B", towards = "A", along = 0, across = 25 } }
E = { coordinates = { x = 50, y = 10 } }
F = { coordinates = { x = 50, y = 30 } }
[bodies]
OA = ["O", "A"]
BD = ["B", "D"]
EF = ["E", "F"]
[[joints]]
pivot = { point = "O" }
[[joints]]
slot = { point = "B", body = "OA", along = ["O", "A"], sleeve = "BD" }
[[joints]]
guide = { point = "E", angle = 90 }
[[joints]]
translation = { body = "EF" }
[[drivers]]
rotation = { body = "OA", omega = 2 }
[[drivers]]
relative_travel = { point = "B", body = "OA", along = ["O", "A"], v = -5 }
[[drivers]]
travel = { point = "E", v = 3, angle = 90 }
"""


def alt_of_scene(path: Path, scene: str, language_name: str) -> str:
    path.write_text(scene, encoding="utf-8")
    variant = one_variant(str(path))
    asked = asked_quantities(variant, ("v_D",))
    return statement_figure(variant, solve_variants([variant], 0), 0, asked, load_language(language_name)).alt


def test_rigid_sleeves_and_sliders(tmp_path: Path) -> None:
    text = alt_of_scene(tmp_path / "scene.toml", SCENE, "en")
    assert "collar B, rigidly attached to BD, slides along OA, now between O and A." in text.replace("Collar", "collar")
    assert "slider E, rigidly attached to EF, moves in a fixed vertical guide." in text.replace("Slider", "slider")
    assert "F directly above E" in text
    russian = alt_of_scene(tmp_path / "scene.toml", SCENE, "ru")
    assert "Муфта B, жёстко соединённая с BD, скользит по OA между O и A." in russian
    assert "Ползун E, жёстко соединённый с EF, движется в неподвижной вертикальной направляющей." in russian


def test_a_kind_without_a_module_is_told_by_its_phrase(tmp_path: Path) -> None:
    path = tmp_path / "scene.toml"
    path.write_text(SCENE, encoding="utf-8")
    variant = one_variant(str(path))
    english = load_language("en")
    phrases = {**english.words("figure"), "translation": "{body} does not turn"}
    language = replace(english, tables=MappingProxyType({**english.tables, "figure": phrases}))
    asked = asked_quantities(variant, ("v_D",))
    text = statement_figure(variant, solve_variants([variant], 0), 0, asked, language).alt
    assert "EF does not turn." in text


def figures_of(pdf: pikepdf.Pdf) -> list[str]:
    """The alternative texts of the figures in the structure of a PDF, in reading order."""
    found: list[str] = []

    def walk(node: pikepdf.Object) -> None:
        if isinstance(node, pikepdf.Array):
            for child in node:
                walk(child)
        elif isinstance(node, pikepdf.Dictionary) and "/S" in node:
            if node.S == "/Figure":
                found.append(str(node.Alt))
                assert "/K" in node
                return
            walk(node.get("/K", pikepdf.Array()))

    walk(pdf.Root.StructTreeRoot.K)
    return found


@pytest.mark.parametrize("sample", ["sample_en", "sample_ru"])
def test_sheets_carry_the_text_of_every_figure(sample: str) -> None:
    exam = read_exam(exam_path(Path(sample)))
    data = sheets_data(Content(exam, drawn_sheets(exam, numbered(2))), TYPST)
    with typesetter() as engine:
        made = engine.compile("sheets.typ", with_pages(data, engine))[0]
    wanted = [problem["figure"]["alt"].alt for student in data["students"] for problem in student["problems"]]
    assert all(wanted)
    with pikepdf.open(io.BytesIO(made)) as pdf:
        assert figures_of(pdf) == wanted


def test_a_single_page_carries_the_text_of_its_figure(tmp_path: Path) -> None:
    assert main(["show", "movable_pulley", "--lang", "ru", "--out", str(tmp_path / "page.pdf")]) == 0
    with pikepdf.open(tmp_path / "page.pdf") as pdf:
        [text] = figures_of(pdf)
    assert text.startswith("Состав: ")
    assert text.endswith(".")


def test_figures_are_told_in_words_only_where_these_are_shown() -> None:
    exam = read_exam(exam_path(Path("sample_en")))
    content = Content(exam, drawn_sheets(exam, numbered(1)))
    data = sheets_data(content, TYPST)
    figures = [posed.figure for own in content.posed for posed in own]
    with typesetter() as engine:
        data = with_pages(data, engine)
        engine.compile("sheets.typ", data, tagged=False)
        assert not any("alt" in vars(figure) for figure in figures)
        engine.compile("sheets.typ", data)
    assert all(vars(figure)["alt"] for figure in figures)


def test_a_figure_can_be_told_by_another_process() -> None:
    variant = one_variant("four_bar", seed="1")
    figure = picture(variant).drawing
    assert pickle.loads(pickle.dumps(figure)).alt == figure.alt != ""
