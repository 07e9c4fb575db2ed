"""Empty grids on sheets and the curves of solutions, beside closed formulas."""

from __future__ import annotations

from decimal import Decimal
from math import pi, radians, sin, sqrt
from pathlib import Path

import numpy as np
import pytest
from msgspec.structs import replace

from benchmarks.sheets import drawn_sheets
from variantgen.errors import InputError
from variantgen.exam.content import Content
from variantgen.exam.roster import numbered
from variantgen.exam.solution_figures import CURVE
from variantgen.families.rate_graphs import grid_of, with_graph
from variantgen.families.reading.load import load_family
from variantgen.families.restrict import restrict
from variantgen.families.sketches import with_sketch
from variantgen.figure.drawing import BOLD, Layer
from variantgen.figure.drawing import Path as DrawnPath
from variantgen.figure.graph import grid, rate_graph, turn_curve
from variantgen.outputs.documents.sheet_data import sheet_notes
from variantgen.outputs.formats import read_exam
from variantgen.single import one_variant
from variantgen.variants.draw import FamilySampler
from variantgen.wording.answer_notes import answer_notes
from variantgen.wording.formula import to_plain
from variantgen.wording.graph_words import read_off
from variantgen.wording.language import load_language

DATA = {"OA": 20, "AB": 60, "phi": 60, "omega_OA": 3}


def speed(angle: float) -> float:
    """The speed of the slider of a central mechanism (cm/s) by the angle of its crank with the guide."""
    root = sqrt(60**2 - (20 * sin(angle)) ** 2)
    return abs(20 * 3 * (sin(angle) + 20 * sin(2 * angle) / (2 * root)))


def test_the_curve_is_that_of_the_closed_formula() -> None:
    variant = one_variant("slider_crank", form="central", fixed=DATA)
    curve = turn_curve(variant, "v_B", load_language("en"))
    sense = np.sign(curve.values[1] - curve.values[0])  # from 60 degrees towards 90 it gets faster
    way = [radians(60) + sense * 2 * pi * k / 180 for k in range(181)]
    assert curve.values == pytest.approx([speed(angle) for angle in way], rel=1e-9)


def test_the_grid_is_round_and_the_curve_lies_in_it() -> None:
    variant, language = one_variant("slider_crank", form="central", fixed=DATA), load_language("ru")
    curve = turn_curve(variant, "v_B", language)
    empty, drawn = (grid(curve, language, wanted) for wanted in (False, True))
    texts = [to_plain(label.formula) for label in empty.labels]
    assert [t for t in texts if "°" in t] == ["0°", "60°", "120°", "180°", "240°", "300°", "360°"]
    assert [t for t in texts if t.isdigit()] == ["0", "20", "40", "60", "80"]  # its largest value is 63.3 cm/s
    (way,) = (line for line in drawn.lines if isinstance(line, DrawnPath) and line.weight == BOLD)
    assert len(drawn.lines) == len(empty.lines) + 1
    heights = [place.imag for place in way.points]
    lines = sorted({line.points[0].imag for line in empty.lines if line.points[0].imag == line.points[1].imag})  # type: ignore[union-attr]
    part = (max(heights) - lines[0]) / (lines[-1] - lines[0])
    assert part == pytest.approx(max(speed(radians(60 + 2 * k)) for k in range(180)) / 80, abs=2e-3)
    assert min(heights) >= lines[0] - 1e-9


EXAM = """title = "Quiz"
language = "en"
[[problem]]
family = "slider_crank"
form = "central"
ask = ["v_B"]
sketch = ["v_B", "omega_AB"]
"""


def test_the_sheet_has_empty_grids_and_the_solution_their_curves(tmp_path: Path) -> None:
    path = tmp_path / "exam.toml"
    path.write_text(EXAM, "utf-8")
    exam = read_exam(path)
    content = Content(exam, drawn_sheets(exam, numbered(1)))
    ((posed,),), ((solved,),) = content.posed, content.solved
    assert posed.figure.height > 2 * 46 + solved.rows[0][0].drawing.height  # two grids below the mechanism
    assert "Below it an empty grid for v_B" in posed.figure.alt
    assert "".join(part for part in posed.statement.text if isinstance(part, str)).count("Sketch in the grids") == 1
    names = [figure.name for row in solved.rows for figure in row]
    assert names[-2:] == [f"{CURVE}:v_B", f"{CURVE}:omega_AB"]


def test_a_coordinate_to_be_sketched_is_not_the_one_that_rests() -> None:
    """A sheet on which the mechanism lies upright would have the line x_B = 0 for a curve."""
    family = load_family("slider_crank")
    family = with_sketch(replace(family, forms={"central": family.forms["central"]}), ["x_B"])
    variants = FamilySampler(family, None).after([("flat", number) for number in range(12)], [0] * 12)
    for variant in variants:
        curve = turn_curve(variant, "x_B", load_language("en"))
        # The slider moves to and fro by twice the crank.
        assert np.ptp(curve.values) == pytest.approx(2 * float(variant.printed["OA"]), rel=1e-3)


def test_lines_with_numbers_are_stronger_where_others_have_none() -> None:
    """The rate of 4.5 that changes by 4 in 2 s is read on lines of 0.5, of which each fifth has a number."""
    variant = one_variant("slider_crank_with_graph", {"omega_OA": "4.5", "epsilon_OA": "2"}, form="read")
    figure = rate_graph(variant, load_language("en"))
    level = [line for line in figure.lines if isinstance(line, DrawnPath) and line.layer is Layer.GROUND]
    level = [line for line in level if abs((line.points[1] - line.points[0]).imag) < 1e-9]
    weights = [line.weight for line in sorted(level, key=lambda line: line.points[0].imag)]
    assert [k for k, weight in enumerate(weights) if weight == max(weights)] == list(range(0, len(weights), 5))
    assert len({*weights}) == 2


@pytest.mark.parametrize(
    ("family", "name", "said"),
    [
        ("slider_crank", "v_C", "no curve over a turn"),
        ("ladder", "v_B", "rotates a body about a fixed point"),
    ],
)
def test_what_has_no_curve_says_so(family: str, name: str, said: str) -> None:
    with pytest.raises(InputError, match=said):
        with_sketch(load_family(family), [name])


@pytest.mark.parametrize(
    ("rate", "acceleration", "found"),
    [
        ("4.5", "3", ("1", "1.5")),  # 1.5 at 0 s, 4.5 at 1 s, 7.5 at 2 s
        ("5.5", "16", ("0.25", "0.5")),  # it changes by 4 in 0.25 s
        ("120", "25", ("4", "20")),
        ("1", "30", None),  # in 0.1 s it changes by three times itself
    ],
)
def test_the_grid_on_which_a_rate_is_read(rate: str, acceleration: str, found: tuple[str, str] | None) -> None:
    wanted = None if found is None else tuple(map(Decimal, found))
    assert grid_of(Decimal(rate), Decimal(acceleration)) == wanted


def test_a_rate_told_by_its_graph(tmp_path: Path) -> None:
    path = tmp_path / "exam.toml"
    text = EXAM.replace('form = "central"', 'form = "central"\ngraph = true\nset = { omega_OA = 4.5, epsilon_OA = -3 }')
    path.write_text(text.replace('"v_B"]\nsk', '"v_B", "a_B"]\nsk'), "utf-8")
    exam = read_exam(path)
    content = Content(exam, drawn_sheets(exam, numbered(1)))
    ((posed,),), ((solved,),) = content.posed, content.solved
    given = [to_plain(equation) for equation in posed.statement.given]
    assert given[-1].replace("\N{NO-BREAK SPACE}", " ") == "t = 1 s"
    assert not any("ω" in equation or "ε" in equation or "α" in equation for equation in given)
    assert "the graph of ω_OA over time" in posed.figure.alt
    # Both rates have the senses of the figure: it slows down or speeds up between 7.5 and 1.5 rad/s.
    drawn = rate_graph(posed.item.variant, load_language("en"))
    assert {to_plain(label.formula) for label in drawn.labels} >= {"1.5", "3", "4.5", "6", "7.5", "0.5", "2"}
    read = solved.text.sections[0]
    assert "ordinate" in str(read.blocks)


def test_pairs_that_a_grid_shows_are_drawn(tmp_path: Path) -> None:
    path = tmp_path / "exam.toml"
    path.write_text(EXAM.replace('sketch = ["v_B", "omega_AB"]', "graph = true").replace('["v_B"]', '["a_B"]'), "utf-8")
    for (item,) in (sheet.items for sheet in drawn_sheets(read_exam(path), numbered(6))):
        rate, acceleration = (abs(item.variant.printed[name]) for name in ("omega_OA", "epsilon_OA"))
        assert acceleration / 10 <= rate  # of all grids the shortest time is 0.1 s
        assert grid_of(rate, acceleration)


def test_values_of_which_no_grid_shows_a_pair_are_refused() -> None:
    with pytest.raises(InputError, match="can be read from one grid"):
        with_graph(restrict(load_family("slider_crank"), {"omega_OA": 1, "epsilon_OA": 12}, {}, ("central",)))
    with pytest.raises(InputError, match="has not a velocity and an acceleration"):
        with_graph(load_family("falling_rod"))


def test_a_reader_is_told_the_signs_of_what_is_sketched(tmp_path: Path) -> None:
    path = tmp_path / "exam.toml"
    path.write_text(EXAM, "utf-8")
    exam = read_exam(path)
    (sheet,) = drawn_sheets(exam, numbered(1))
    (item,) = sheet.items
    notes = answer_notes(read_off(item.variant.form, item.asked), exam.spoken)
    assert any("plus is counterclockwise" in note for note in notes)  # of omega_AB, which is not asked
    assert sheet_notes(sheet, exam.spoken) == notes
