"""What a notebook shows: whole, self-contained, with the numbers of the object; nothing has to be installed for it."""

from __future__ import annotations

import re
import subprocess
import sys
from pathlib import Path
from xml.etree import ElementTree as ET

import html5lib
import numpy as np
import pytest
from msgspec.structs import replace

import variantgen
from variantgen.outputs.single.chart import Abscissa, ChartCurve, chart
from variantgen.wording.language import load_language

FOUND = variantgen.batch("sleeve_on_crank", 7, seed=3)
SVG = "{http://www.w3.org/2000/svg}"


def parsed(markup: str) -> ET.Element:
    """A fragment, read strictly."""
    parser = html5lib.HTMLParser(strict=True, namespaceHTMLElements=False)
    found = parser.parseFragment(markup)
    errors = [error for error in parser.errors if error[1] != "expected-doctype-but-got-start-tag"]
    assert errors == []
    return found


def words(element: ET.Element) -> str:
    return " ".join(" ".join(element.itertext()).split())


def cells(element: ET.Element) -> list[list[str]]:
    return [[words(cell) for cell in row if cell.tag in ("th", "td")] for row in element.iter("tr")]


DISPLAYS = {
    "variant": FOUND[0]._repr_html_,
    "solution": lambda: variantgen.explain(FOUND[0])._repr_html_(),
    "solution in Russian": lambda: variantgen.explain(FOUND[0], language="ru", ask=["v_B"])._repr_html_(),
    "batch": FOUND._repr_html_,
    "motion": FOUND[0].motion()._repr_html_,
    "motion of many": FOUND.motion._repr_html_,
}


@pytest.mark.parametrize("name", DISPLAYS)
def test_displays_are_sound_and_need_nothing_from_elsewhere(name: str) -> None:
    markup = DISPLAYS[name]()
    assert markup.startswith('<div class="variantgen">')
    assert markup.endswith("</div>")
    whole = parsed(markup)
    ids = [element.get("id") for element in whole.iter() if element.get("id")]
    assert len(ids) == len(set(ids))
    assert not list(whole.iter("script"))
    assert not re.search(r"(?:src|href)=\"(?!#)", markup)
    # The style is that of the display alone.
    style = "".join("".join(element.itertext()) for element in whole.iter("style"))
    assert all(
        part.strip().startswith(".variantgen") for rule in re.findall(r"([^{}]+)\{", style) for part in rule.split(",")
    )


def test_a_variant_is_shown_as_its_problem_with_a_figure() -> None:
    whole = parsed(FOUND[0]._repr_html_())
    text = words(whole)
    assert "Rod through a collar" in text
    assert "Given:" in text
    assert "Determine:" in text
    assert f"OA = {FOUND[0].printed['OA']} cm" in text
    assert len([element for element in whole.iter() if str(element.tag).endswith("svg")]) == 1


def test_a_family_without_a_statement_in_the_language_is_shown_without_it(tmp_path: Path) -> None:
    form = replace(FOUND.form)  # a form remembers its texts
    alone = replace(FOUND[0], form=form, family=replace(FOUND.family, folder=tmp_path, forms={form.name: form}))
    whole = parsed(alone._repr_html_())
    assert "Given:" not in words(whole)
    assert [element for element in whole.iter() if str(element.tag).endswith("svg")]
    explained = variantgen.explain(alone, ask=["v_B"])
    assert str(explained).strip() in "".join(parsed(explained._repr_html_()).itertext())


def test_a_variant_that_does_not_assemble_says_so() -> None:
    broken = replace(FOUND[0], printed={**FOUND[0].printed, "AB": FOUND[0].printed["h"] / 1000})
    assert "does not assemble" in words(parsed(broken._repr_html_()))
    assert "does not assemble" in words(parsed(broken.motion()._repr_html_()))


def test_a_solution_has_its_steps_and_figures() -> None:
    explained = variantgen.explain(FOUND[0], language="ru", ask=["v_B"])
    whole = parsed(explained._repr_html_())
    heads = [words(head) for head in whole.iter("h4")]
    assert len(heads) >= len(explained.text.sections) > 0
    figures = [element for element in whole.iter() if str(element.tag).endswith("svg")]
    assert len(figures) == len(list(whole.iter("figure"))) > 1
    assert "Ответ" in words(whole)


def test_pictures_and_plans_are_svg() -> None:
    for view in ("statement", "velocity_plan", "acceleration_plan", "velocities"):
        assert ET.fromstring(variantgen.picture(FOUND[0], view)._repr_svg_()).tag == f"{SVG}svg"


def test_tables_have_the_numbers() -> None:
    rows = cells(parsed(FOUND._repr_html_()))
    assert len(rows) == 6
    assert rows[0][1] == "OA, cm"
    assert [row[1] for row in rows[1:]] == [f"{value:g}" for value in FOUND.parameters["OA"][:5]]
    assert rows[3][rows[0].index("v_B, cm/s")] == f"{FOUND.answers['v_B'][2]:.5g}"
    assert "5 of 7 variants" in words(parsed(FOUND._repr_html_()))
    motion = FOUND[2].motion()
    listed = {row[0]: row[1:] for row in cells(parsed(motion._repr_html_()))}
    place, velocity = motion.z["D"][0], motion.v["D"][0]
    assert listed["D"][:4] == [f"{x:.5g}" for x in (place.real, place.imag, velocity.real, velocity.imag)]
    assert listed["BD"] == [f"{motion.omega['BD'][0]:.5g}", f"{motion.epsilon['BD'][0]:.5g}"]
    assert not re.search(r"e-1[0-9]", words(parsed(FOUND.motion._repr_html_())))
    assert "the first of 7, 7 of them solved" in words(parsed(FOUND.motion._repr_html_()))


def test_without_accelerations_there_are_no_columns_of_them() -> None:
    heads = [row for row in cells(parsed(FOUND[0].motion(order=1)._repr_html_())) if row[0] in ("point", "body")]
    assert heads == [["point", "x, m", "y, m", "v.x, m/s", "v.y, m/s"], ["body", "ω, rad/s"]]


def curve_points(path: ET.Element) -> list[tuple[str, float, float]]:
    steps = re.findall(r"([ML])([-\d.]+) ([-\d.]+)", path.get("d", ""))
    return [(letter, float(x), float(y)) for letter, x, y in steps]


def test_curves_are_those_of_the_turn() -> None:
    turn = variantgen.turn(variantgen.batch("slider_crank", 1, seed=2)[0], samples=91)
    picture = ET.fromstring(turn._repr_svg_())
    paths = [path for path in picture.iter(f"{SVG}path") if path.get("stroke") == "#0b57a4"]
    titles = [text.text for text in picture.iter(f"{SVG}text")]
    assert {"v_B, cm/s", "omega_AB, rad/s", "phi, °"} <= set(titles)
    speeds = 100 * np.abs(turn.motion.v["B"])
    points = curve_points(paths[0])
    assert len(points) == 91
    assert [letter for letter, _, _ in points] == ["M"] + ["L"] * 90
    # Heights are linear in the speeds: as the highest and lowest of them say, within a tenth of a pixel.
    heights = np.array([y for _, _, y in points])
    top, bottom = np.argmax(speeds), np.argmin(speeds)
    slope = (heights[top] - heights[bottom]) / (speeds[top] - speeds[bottom])
    assert slope < 0
    assert heights == pytest.approx(heights[bottom] + slope * (speeds - speeds[bottom]), abs=0.21)


def test_a_curve_is_interrupted_where_it_has_no_value() -> None:
    values = np.array([0.0, 1.0, np.nan, 3.0, 2.0])
    curves = [ChartCurve("v & w", values), ChartCurve("none", np.full(5, np.nan))]
    picture = ET.fromstring(chart(Abscissa(np.arange(5.0), "way, <m>", 1), curves, load_language("en")))
    first, second = [path for path in picture.iter(f"{SVG}path") if path.get("stroke") == "#0b57a4"]
    points = curve_points(first)
    assert [letter for letter, _, _ in points] == ["M", "L", "M", "L"]
    assert [x for _, x, _ in points] == pytest.approx([70 + 554 * k / 4 for k in (0, 1, 3, 4)], abs=0.06)
    assert curve_points(second) == []
    dashed = next(path for path in picture.iter(f"{SVG}path") if path.get("stroke-dasharray"))
    assert dashed.get("d", "").startswith("M208.5 ")


def test_values_without_bounds_at_a_dead_point_leave_the_rest_to_be_seen() -> None:
    turn = variantgen.turn(variantgen.batch("four_bar", 1, seed=3, form="rocker")[0])
    assert {end.value for end in turn.ends} == {"dead_point"}
    picture = ET.fromstring(turn._repr_svg_())
    heights = [
        y for _, _, y in curve_points(next(p for p in picture.iter(f"{SVG}path") if p.get("stroke") == "#0b57a4"))
    ]
    inside = sorted(heights)[len(heights) // 10 : -len(heights) // 10]
    # The panel is 96 pixels high: four fifths of the curve fill a good part of it.
    assert max(inside) - min(inside) > 20


def test_nothing_has_to_be_installed() -> None:
    script = (
        "import sys\n"
        "for name in ('matplotlib', 'IPython', 'hypothesis', 'openpyxl', 'pylatex'): sys.modules[name] = None\n"
        "import variantgen\n"
        "found = variantgen.batch('four_bar', 2)\n"
        "shown = [found._repr_html_(), found[0]._repr_html_(), found.motion._repr_html_(),"
        " variantgen.explain(found[0])._repr_html_(), variantgen.picture(found[0])._repr_svg_(),"
        " variantgen.turn(found[0])._repr_svg_()]\n"
        "print(min(map(len, shown)), 'typst' in sys.modules)\n"
    )
    done = subprocess.run([sys.executable, "-c", script], capture_output=True, text=True, check=False)
    assert done.returncode == 0, done.stderr
    assert int(done.stdout.split()[0]) > 1000


def test_a_console_shows_one_line_of_a_solution_and_print_the_text():
    variant = variantgen.draw(variantgen.load_family("four_bar"), ["v_B"], [("1", "2")])[0]
    found = variantgen.explain(variant, ask=["v_B"])
    line = repr(found)
    assert line.startswith("<Explanation of four_bar") and "v_B" in line and "\n" not in line
    assert str(found).count("\n") > 5 and "cm/s" in str(found)
