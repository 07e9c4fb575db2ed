"""A bare number means the printed unit everywhere; what could be meant otherwise is refused or asked about."""

from __future__ import annotations

import json
import math
import re
import shutil
from pathlib import Path

import pytest

from tests.scene_files import scene_file
from variantgen.cli import main
from variantgen.errors import InputError
from variantgen.exam.exam_file import read_exam
from variantgen.families.reading.cases import load_cases
from variantgen.families.reading.load import load_family, read_family
from variantgen.resources import catalog_dir

EXAM = 'schema = 1\nlanguage = "en"\ntitle = "T"\nseed = 1\n[[problem]]\n'
# A crank of 20 cm; the point lies at 20 (cos, sin) of the angle.
CRANK = """
length_unit = "cm"
[parameters]
phi = { unit = "deg", values = [30] }
alpha = { unit = "deg", values = [50] }
side = { choices = { left = 1, right = -1 } }
%s
[points]
O = { coordinates = { x = 0, y = 0 } }
A = { polar = { origin = "O", distance = 20, angle = %s } }
[bodies]
OA = ["O", "A"]
[[joints]]
pivot = { point = "O" }
[[drivers]]
rotation = { body = "OA", omega = 2 }
"""
RATES = """
turn = { unit = "rad/s", values = [2] }
gain = { unit = "rad/s^2", values = [3] }
time = { unit = "s", values = [1] }
"""


def exam(folder: Path, problem: str) -> Path:
    path = folder / "exam.toml"
    path.write_text(EXAM + problem, "utf-8")
    return path


def refused(folder: Path, problem: str) -> str:
    with pytest.raises(InputError) as caught:
        read_exam(exam(folder, problem))
    return str(caught.value)


def crank(folder: Path, angle: str, more: str = "") -> Path:
    return scene_file(folder, CRANK % (more, angle))


def test_a_fixed_value_outside_the_range_is_refused_with_the_unit(tmp_path: Path) -> None:
    """The wheel of the catalogue has a radius of 0.2 to 0.9 m, so 50 is no wheel of 50 m."""
    message = refused(tmp_path, 'family = "rolling_wheel"\nset = { R = 50 }\n')
    assert "problem[1].set.R: outside the range of the family, 0.2 to 0.9 m (got 50 m)" in message
    assert 'a bare number is in m: did you mean "50 cm"?' in message


@pytest.mark.parametrize("said", ['"50 cm"', "0.5", '"0.5"', '"500 mm"', '"0.5 m"'])
def test_a_fixed_value_in_any_unit_is_the_same(said: str, tmp_path: Path) -> None:
    read = read_exam(exam(tmp_path, f'family = "rolling_wheel"\nset = {{ R = {said} }}\n'))
    assert read.tasks[0].families[0].forms[""].parameters["R"].si.tolist() == [0.5]


def test_a_fixed_value_in_the_range_need_not_lie_on_the_grid(tmp_path: Path) -> None:
    read = read_exam(exam(tmp_path, 'family = "rolling_wheel"\nset = { R = 0.333, a_O = 0 }\n'))
    assert read.tasks[0].families[0].forms[""].parameters["R"].si.tolist() == [0.333]


def test_a_range_means_the_same_unit(tmp_path: Path) -> None:
    read = read_exam(exam(tmp_path, 'family = "rolling_wheel"\nrange = { R = [0.3, "40 cm"] }\n'))
    assert read.tasks[0].families[0].forms[""].parameters["R"].si.tolist() == [0.3, 0.35, 0.4]
    assert "no value of the family's grid" in refused(tmp_path, 'family = "rolling_wheel"\nrange = { R = [30, 40] }\n')


def test_a_value_of_another_form_is_refused_with_that_form(tmp_path: Path) -> None:
    family = tmp_path / "four_bar" / "family.toml"
    shutil.copytree(catalog_dir() / "four_bar", family.parent)
    text = family.read_text("utf-8")
    old = '[forms.crank.parameters]\nOC = { unit = "cm", from = 40, to = 100, step = 5 }'
    assert text.count(old) == 1
    family.write_text(text.replace(old, old.replace("to = 100", "to = 140")), "utf-8")
    message = refused(tmp_path, 'family = "four_bar"\nform = ["crank", "rocker"]\nset = { OC = 120 }\n')
    assert "outside the range of the family, 40 to 100 cm (got 120 cm)" in message
    assert 'choose form = "crank"' in message
    # The form "directions" has no OC at all.
    message = refused(tmp_path, 'family = "four_bar"\nset = { OC = 30 }\n')
    assert "outside the range of the family, 40 to 100 cm (got 30 cm)" in message
    assert "take a value in it" in message


def test_single_variants_may_lie_outside_the_range(capsys: pytest.CaptureFixture[str]) -> None:
    """A wheel of 2 m at 4 m/s turns with 2 rad/s."""
    arguments = ["R=2", "v_O=4", "a_O=0", "alpha=45", "place=front_above"]
    asked = ["solve", "rolling_wheel", "--json", "--ask", "omega_wheel.abs"]
    assert main([*asked, *(part for text in arguments for part in ("--set", text))]) == 0
    answer = json.loads(capsys.readouterr().out)["answers"][0]
    assert answer["value"] == pytest.approx(2)


@pytest.mark.parametrize(
    ("angle", "number"),
    [
        ('"phi + 180 - alpha"', "180"),
        ('"180 - phi"', "180"),
        ('"phi + 90 * side"', "-90"),
        ('"max(phi, 45)"', "45"),
        ('"atan2(3, 4) + 90"', "90"),
        ('"180 - 40"', "140"),
        ('"side * 90"', "-90"),
        ('"turned"', "150"),
        ('"asin(sin(60))"', "60"),
    ],
)
def test_a_plain_number_beside_an_angle_is_asked_about(angle: str, number: str, tmp_path: Path) -> None:
    with pytest.raises(InputError) as caught:
        read_family(crank(tmp_path, angle, '[derived]\nhalf = "300 / 2"\nturned = "half"\n'))
    message = str(caught.value)
    assert f"scene.toml: points.A.polar.angle: the plain number {number} stands where an angle is meant" in message
    assert f"did you mean {number} * deg?" in message


def test_a_plain_number_compared_with_an_angle_is_asked_about(tmp_path: Path) -> None:
    for require in ("phi < 60", "2 * phi - alpha > 45", "turn * time < 300"):
        with pytest.raises(InputError, match="stands where an angle is meant"):
            read_family(crank(tmp_path, '"phi"', RATES + f'[screens]\nrequire = ["{require}"]\n'))


@pytest.mark.parametrize(
    "require",
    [
        "phi < 60 * deg",
        "phi > 0",
        "phi / alpha < 1.5",
        "phi * 180 / pi < 60",
        "gain / turn**2 < 3",
        "cos(phi) + 1 > 1.2",
    ],
)
def test_ratios_are_compared_with_plain_numbers(require: str, tmp_path: Path) -> None:
    form = read_family(crank(tmp_path, '"phi"', RATES + f'[screens]\nrequire = ["{require}"]\n')).forms[""]
    assert [comparison.text for comparison in form.screens.require] == [require]


@pytest.mark.parametrize(
    ("angle", "degrees"),
    [
        ("140", 140),
        ('"140"', 140),
        ('"140 deg"', 140),
        ('"phi + 180*deg - alpha"', 160),
        ('"phi + pi"', 210),
        ('"phi - pi / 2"', -60),
        ('"phi + side * pi / 2"', 120),
        ('"2 * phi"', 60),
        ('"phi / deg * 2 * deg"', 60),
        ('"2 * pi / 3"', 120),
        ('"sin(phi) * 60 * deg"', 30),
        ('"acos(1 / 2) + phi"', 90),
        ('"pi * phi / (phi + alpha)"', 67.5),
    ],
)
def test_angles_that_say_what_they_mean_are_read(angle: str, degrees: float, tmp_path: Path) -> None:
    form = read_family(crank(tmp_path, angle)).forms[""]
    values = {name: float(parameter.si[0]) for name, parameter in form.parameters.items()}
    point = form.points["A"].build(values)
    assert point.angle == pytest.approx(math.radians(degrees))
    assert point.distance == 0.2


def cases_with(folder: Path, family: str, old: str, new: str) -> Path:
    """A family of the catalogue with something else in its worked cases."""
    copied = folder / family
    shutil.copytree(catalog_dir() / family, copied)
    path = copied / "cases.toml"
    text = path.read_text("utf-8")
    assert text.count(old) == 1
    path.write_text(text.replace(old, new), "utf-8")
    return copied


@pytest.mark.parametrize(
    ("said", "metres"),
    [
        ('"50 * cm + 20 * cm * sqrt(3)"', 0.5 + 0.2 * math.sqrt(3)),
        ('"0.5 * m"', 0.5),
        ('"500 mm"', 0.5),
        ('"sqrt(65)"', math.sqrt(65)),
        ("0.5", 0.5),
    ],
)
def test_a_worked_case_means_the_length_it_says(said: str, metres: float, tmp_path: Path) -> None:
    path = cases_with(tmp_path, "rolling_wheel", "R = 0.5, v_O = 2", f"R = {said}, v_O = 2")
    assert load_cases(load_family(str(path)))[0].given["R"] == pytest.approx(metres, rel=1e-15)


@pytest.mark.parametrize(
    ("said", "degrees"),
    [("45", 45), ('"45"', 45), ('"45 * deg"', 45), ('"atan2(1, 1)"', 45), ('"atan2(1, 1) / deg"', 45), ('"40 + 5"', 45),
     ('"0.25 rad"', 14.3239448782706), ('"(pi / 6) / deg"', 30)],
)  # fmt: skip
def test_a_worked_case_means_the_angle_it_says(said: str, degrees: float, tmp_path: Path) -> None:
    path = cases_with(tmp_path, "rolling_wheel", "a_O = 0, alpha = 45", f"a_O = 0, alpha = {said}")
    assert load_cases(load_family(str(path)))[0].given["alpha"] == pytest.approx(math.radians(degrees), rel=1e-12)


@pytest.mark.parametrize(
    ("old", "new", "said"),
    [
        ("R = 0.5, v_O = 2", 'R = "50 + 20 * cm", v_O = 2', "set.R: adds or compares"),
        ("R = 0.5, v_O = 2", 'R = "50 * cm * cm", v_O = 2', "set.R: is length^2"),
        ("R = 0.5, v_O = 2", 'R = "3 rad", v_O = 2', "set.R: the unit rad measures angle"),
        ("R = 0.5, v_O = 2", 'R = 0.5, v_O = "200 * cm"', "set.v_O: is a length, expected a number of m/s"),
        ("a_O = 0, alpha = 45", 'a_O = 0, alpha = "pi / 4"', "set.alpha: is in radians, degrees are due"),
        ("a_O = 0, alpha = 45", 'a_O = 0, alpha = "180 - atan2(3, 4)"', "set.alpha: the plain number 180 stands"),
        ("v_P = 0", 'v_P = "4 * cm"', "exact.v_P: is a length, expected a number of m/s"),
    ],
)  # fmt: skip
def test_a_worked_case_that_means_nothing_is_refused(old: str, new: str, said: str, tmp_path: Path) -> None:
    path = cases_with(tmp_path, "rolling_wheel", old, new)
    with pytest.raises(InputError) as caught:
        load_cases(load_family(str(path)))
    assert re.search(r"cases\.toml: case\[1\]\." + re.escape(said), str(caught.value)), str(caught.value)
