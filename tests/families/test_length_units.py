"""Units as an option: data on a round grid of the unit, answers in it, the mechanism the same but for its size."""

from __future__ import annotations

from decimal import Decimal
from math import cos, hypot, radians, sin
from pathlib import Path

import pytest

from variantgen.cli import main
from variantgen.errors import InputError
from variantgen.families.length_units import round_ratio
from variantgen.families.parameters.units import UNITS, parse_value
from variantgen.families.reading.load import load_family
from variantgen.families.restrict import restrict
from variantgen.outputs.formats import read_exam
from variantgen.single import answers, one_variant, solution_document

EXAM = 'title = "Quiz"\nlanguage = "en"\n{}\n[[problem]]\nfamily = "four_bar"\nset = {{ OA = 11 }}\n'


@pytest.mark.parametrize(
    ("text", "unit", "value"),
    [
        ("1 in", "cm", 2.54),
        ("1 ft", "in", 12),
        ("1 ft", "m", 0.3048),
        ("36 km/h", "m/s", 10),
        ("30 ft/s", "in/s", 360),
        ("32.174 ft/s^2", "m/s^2", 9.80663520),
        ("1 cm", "in", 0.393700787402),
    ],
)
def test_units_by_hand(text: str, unit: str, value: float) -> None:
    assert float(parse_value(text, UNITS[unit], "")) == pytest.approx(value, rel=1e-11)


@pytest.mark.parametrize(
    ("old", "new", "ratio"),
    [
        ("cm", "mm", "10"),
        ("cm", "m", "0.01"),
        ("cm", "in", "0.5"),
        ("cm", "ft", "0.05"),
        ("m", "ft", "5"),
        ("m", "in", "50"),
    ],
)
def test_the_round_number_nearest_to_the_ratio(old: str, new: str, ratio: str) -> None:
    assert round_ratio(UNITS[old], UNITS[new]) == Decimal(ratio)


@pytest.mark.parametrize(("units", "factor"), [("mm", 10), ("m", 0.01), ("cm", 1)])
def test_metric_units_leave_the_mechanism_as_it_is(units: str, factor: float) -> None:
    usual, other = (one_variant("four_bar", seed="4", form="crank", units=name) for name in ("", units))
    lengths = ("OA", "AB", "BC", "OC")
    assert [float(other.printed[n]) for n in lengths] == pytest.approx(
        [factor * float(usual.printed[n]) for n in lengths]
    )
    assert all(other.si(name) == pytest.approx(usual.si(name), rel=1e-12) for name in usual.printed)
    for one, two in zip(answers(usual), answers(other), strict=True):
        size = factor if one.quantity.is_vector else 1
        assert two.value == pytest.approx(size * one.value, rel=1e-9)
        assert two.tolerance == pytest.approx(size * one.tolerance, rel=1e-9)
        assert two.unit.name == one.unit.name.replace("cm", units)


@pytest.mark.parametrize(("units", "metre", "step"), [("in", 0.0254, "0.5"), ("ft", 0.3048, "0.05")])
def test_a_rolling_wheel_in_inches_and_feet(units: str, metre: float, step: str) -> None:
    variant = one_variant("rolling_wheel", seed="4", units=units)
    data = {name: float(value) for name, value in variant.printed.items()}
    assert variant.printed["R"] % Decimal(step) == 0
    found = {a.quantity.name: (a.value, a.unit.name) for a in answers(variant)}
    # The contact is the velocity centre; M lies at alpha from the top: its horizontal velocity is v (1 + cos alpha).
    speed, angle = data["v_O"], radians(data["alpha"])
    assert found["omega_wheel"][1] == "rad/s"
    assert abs(found["omega_wheel"][0]) == pytest.approx(speed / data["R"], rel=1e-7)
    assert found["v_M"] == (pytest.approx(hypot(speed * (1 + cos(angle)), speed * sin(angle)), rel=1e-7), f"{units}/s")
    told = solution_document(variant)["parameters"]["R"]
    assert told == {"value": data["R"], "unit": units, "si": pytest.approx(data["R"] * metre, rel=1e-12)}


@pytest.mark.parametrize(
    ("units", "printed"), [("in", "386"), ("ft", "32.2"), ("mm", "9800"), ("m", "9.8")]
)  # 9.8 m/s^2 / 0.0254 m = 385.8, / 0.3048 m = 32.15
def test_constants_are_converted_to_three_digits(units: str, printed: str) -> None:
    variant = one_variant("falling_rod", seed="4", units=units)
    assert str(variant.printed["g"]) == printed


def test_right_triangles_stay_right() -> None:
    """The sides of the triangles that the family names for calculations by hand keep their ratios."""
    usual, feet = (restrict(load_family("slider_crank"), nice=True, units=name) for name in ("", "ft"))
    for name, form in usual.forms.items():
        one, two = form.ties, feet.forms[name].ties
        assert (one is None) == (two is None)
        for before, after in zip(one.rows, two.rows, strict=True) if one and two else ():
            sizes = [
                Decimal("0.05") if form.parameters[n].unit.dimension[0] else Decimal(1)  # type: ignore[union-attr]
                for n in one.names  # type: ignore[union-attr]
            ]
            assert [value * size for value, size in zip(before, sizes, strict=True)] == list(after)


def test_bare_numbers_of_the_exam_are_in_its_unit(tmp_path: Path) -> None:
    (tmp_path / "exam.toml").write_text(EXAM.format('units = "in"'), "utf-8")
    form = read_exam(tmp_path / "exam.toml").tasks[0].families[0].forms["crank"]
    assert form.parameters["OA"].printed == (11,)
    assert form.parameters["OA"].si[0] == pytest.approx(11 * 0.0254)


@pytest.mark.parametrize(("written", "said"), [('"yard"', "yard"), ("3", "3"), ('""', ""), ('"cm/s"', "cm/s")])
def test_other_words_are_refused(written: str, said: str, tmp_path: Path) -> None:
    (tmp_path / "exam.toml").write_text(EXAM.format(f"units = {written}"), "utf-8")
    with pytest.raises(InputError) as refused:
        read_exam(tmp_path / "exam.toml")
    message = str(refused.value)
    assert message.startswith(f"{tmp_path / 'exam.toml'}: units: expected ")
    assert said in message


def test_units_of_the_command_line(capsys: pytest.CaptureFixture[str], tmp_path: Path) -> None:
    assert main(["show", "four_bar", "--seed", "4", "--units", "ft", "--lang", "ru"]) == 0
    assert "фут/с²" in capsys.readouterr().out
    assert main(["solve", "four_bar", "--units", "yard"]) == 2
    assert "expected a unit of length (got yard)\n    one of m, dm, cm, mm, in, ft" in capsys.readouterr().err
    scene = tmp_path / "rod.toml"
    scene.write_text(
        'length_unit = "cm"\nask = ["v_B"]\n[points]\nA = { coordinates = { x = "0 cm", y = "0 cm" } }\n'
        'B = { coordinates = { x = "30 cm", y = "0 cm" } }\n[bodies]\nAB = ["A", "B"]\n'
        '[[joints]]\npivot = { point = "A" }\n[[drivers]]\nrotation = { body = "AB", omega = 2 }\n',
        "utf-8",
    )
    assert main(["solve", str(scene)]) == 0
    assert main(["solve", str(scene), "--units", "ft"]) == 2
    assert 'write length_unit = "ft"' in capsys.readouterr().err


def test_a_problem_has_its_own_unit(tmp_path: Path) -> None:
    path = tmp_path / "exam.toml"
    path.write_text(
        'title = "T"\nlanguage = "en"\nseed = 1\nunits = "mm"\n'
        '[[problem]]\nfamily = "four_bar"\nunits = "in"\nset = { OA = 10 }\n'
        '[[problem]]\nfamily = "four_bar"\nset = { OA = 300 }\n',
        encoding="utf-8",
    )
    exam = read_exam(path)
    assert [task.families[0].length_unit for task in exam.tasks] == ["in", "mm"]
    parameters = [next(iter(task.families[0].forms.values())).parameters["OA"] for task in exam.tasks]
    assert [parameter.printed for parameter in parameters] == [(10,), (300,)]


def test_a_family_offers_units_of_its_own(tmp_path: Path) -> None:
    text = 'units = ["m", "in"]\nlength_unit = "m"\ntitle = { en = "Crank" }\nask = ["v_A"]\n'
    text += 'drivers = [{ rotation = { body = "OA", omega = "omega_OA" } }]\njoints = [{ pivot = { point = "O" } }]\n'
    text += "points.O = { coordinates = { x = 0, y = 0 } }\n"
    text += 'points.A = { polar = { origin = "O", distance = "OA", angle = 30 } }\nbodies.OA = ["O", "A"]\n'
    text += 'parameters.OA = { unit = "m", values = [0.5] }\nparameters.omega_OA = { unit = "rad/s", values = [2] }\n'
    folder = tmp_path / "crank"
    folder.mkdir()
    (folder / "family.toml").write_text(text, "utf-8")
    for language in ("en", "ru"):
        (folder / f"statement.{language}.j2").write_text("OA", "utf-8")
    (folder / "cases.toml").write_text("", "utf-8")
    family = load_family(folder)
    found = restrict(family, units="in").forms[""].parameters["OA"]
    assert (found.unit, found.printed) == (UNITS["in"], (Decimal(25),))  # 39.4 in are nearest to 50, of 20 and 50
    with pytest.raises(InputError, match="crank offers m, in"):
        restrict(family, units="ft")
    (folder / "family.toml").write_text(text.replace('["m", "in"]', '["cm", "in"]'), "utf-8")
    with pytest.raises(InputError, match='add "m"'):
        load_family(folder)
