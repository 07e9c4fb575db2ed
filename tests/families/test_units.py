"""Units of the books: in data, in drivers, and wanted for an answer."""

from __future__ import annotations

import json
import math
from decimal import Decimal
from pathlib import Path

import pytest

from tests.scene_files import scene_file
from variantgen import answers, draw, load_family
from variantgen.cli import main
from variantgen.families.parameters.units import UNITS, parse_value, unit

SCENE = """
length_unit = "ft"
ask = [{ask}]
[points]
O = {{ coordinates = {{ x = 0, y = 0 }} }}
A = {{ coordinates = {{ x = "6 in", y = 0 }} }}
[bodies]
crank = ["O", "A"]
[[joints]]
pivot = {{ point = "O" }}
[[drivers]]
rotation = {{ body = "crank", omega = "{omega}", epsilon = "2 rev/s^2" }}
"""


@pytest.mark.parametrize(
    ("text", "default", "value"),
    [
        ("2 rev/s", "rad/s", 4 * math.pi),
        ("90 deg/s", "rad/s", math.pi / 2),
        ("60 rev/min", "rad/s", 2 * math.pi),
        ("30 rpm/s", "rad/s^2", math.pi),
        ("180 deg/s²", "rad/s^2", math.pi),
        ("0.25 rev", "deg", 90),
        ("30°", "deg", 30),
        ("60 mph", "ft/s", 88),
        ("1 mi", "ft", 5280),
        ("300 ft/min", "ft/s", 5),
        ("32.2 ft/s**2", "in/s^2", 386.4),
        ("1.5 min", "s", 90),
        ("2 yd", "in", 72),
    ],
)
def test_numbers_of_the_books(text: str, default: str, value: float) -> None:
    assert float(parse_value(text, UNITS[default], "")) == pytest.approx(value, rel=1e-12)


def test_other_spellings_are_one_unit() -> None:
    assert unit("ft/s²") is unit("ft/s^2") is UNITS["ft/s^2"]
    assert unit("rev/min").name == "rpm"
    assert UNITS["rev"].to_si(Decimal(1)) == pytest.approx(math.tau)


def solved(tmp_path: Path, capsys: pytest.CaptureFixture[str], ask: str, *more: str, omega: str = "100 rpm") -> str:
    path = tmp_path / "crank.toml"
    path.write_text(SCENE.format(ask=ask, omega=omega), encoding="utf-8")
    code = main(["solve", str(path), *more])
    shown = capsys.readouterr()
    return shown.out if code == 0 else shown.err


def test_an_answer_is_in_the_unit_that_is_wanted(tmp_path: Path, capsys: pytest.CaptureFixture[str]) -> None:
    asked = '"v_A in in/s", "a_A in m/s²", "omega_crank in rpm", "epsilon_crank"'
    document = json.loads(solved(tmp_path, capsys, asked, "--json"))
    found = {answer["quantity"]: (answer["value"], answer["unit"]) for answer in document["answers"]}
    rate, gain = 100 * math.pi / 30, 4 * math.pi
    assert found["v_A"] == (pytest.approx(6 * rate), "in/s")
    assert found["a_A"] == (pytest.approx(0.1524 * math.hypot(rate**2, gain)), "m/s^2")
    assert found["omega_crank"] == (pytest.approx(100), "rpm")
    assert found["epsilon_crank"] == (pytest.approx(gain), "rad/s^2")


def test_an_angle_is_answered_in_radians_or_turns(tmp_path: Path, capsys: pytest.CaptureFixture[str]) -> None:
    """The angle between the acceleration of the crank pin and the crank has the tangent epsilon / omega^2."""
    mu = math.atan2(4 * math.pi, (100 * math.pi / 30) ** 2)
    for name, size in (("rad", 1.0), ("rev", math.tau)):
        document = json.loads(solved(tmp_path, capsys, f'"mu_crank in {name}"', "--json"))
        assert [(a["value"], a["unit"]) for a in document["answers"]] == [(pytest.approx(mu / size), name)]
    shown = solved(tmp_path, capsys, '"mu_crank in rad"', "--explain").replace("\N{NO-BREAK SPACE}", " ")
    assert f"Answer: μ_crank = {math.degrees(mu):.3f}° = {mu:.4f} rad" in shown


def test_the_tolerance_of_an_angle_is_in_its_unit() -> None:
    """Without a tolerance of one's own an angle may be off by the same angle, whatever unit it is asked in."""
    variant = draw(load_family("plate_acceleration_centre"), None, [(1,)])[0]
    found = [answers(variant, [f"mu_ABDE in {name}"])[0] for name in ("deg", "rad")]
    assert math.radians(found[0].tolerance) == pytest.approx(found[1].tolerance, rel=0.01)


def test_a_solution_leads_to_its_own_unit_and_to_the_wanted_one(
    tmp_path: Path, capsys: pytest.CaptureFixture[str]
) -> None:
    shown = solved(tmp_path, capsys, '"v_A in km/h"', "--explain", omega="8 rad/s")
    assert "v_A = 4 ft/s = 4.389 km/h" in shown.replace("\N{NO-BREAK SPACE}", " ")


def test_the_command_line_asks_in_units(tmp_path: Path, capsys: pytest.CaptureFixture[str]) -> None:
    shown = solved(tmp_path, capsys, '"v_A"', "--ask", "v_A in mph", omega="44 rad/s")
    assert shown.splitlines()[-1] == "v_A = 15 mi/h"


@pytest.mark.parametrize(
    ("ask", "message"),
    [
        ("v_A in rpm", "rpm measures no velocity"),
        ("v_A in furlong", "unknown unit"),
        ("omega_crank in rad", "rad measures no angular velocity"),
        ("angle_OA in rev", "directions are answered in deg"),
        ("v_A.angle in rad", "directions are answered in deg"),
        ("mu_crank in rad/s", "rad/s measures no angle"),
        ("velocities in ft/s", "a unit goes with one quantity"),
    ],
)
def test_a_unit_that_does_not_fit(ask: str, message: str, tmp_path: Path, capsys: pytest.CaptureFixture[str]) -> None:
    shown = solved(tmp_path, capsys, '"v_A"', "--ask", ask)
    assert message in shown
    assert ask.partition(" in ")[0] in shown


def test_the_text_tells_the_unit_that_is_wanted(capsys: pytest.CaptureFixture[str]) -> None:
    assert (
        main(["show", "four_bar", "--seed", "2", "--form", "crank", "--ask", "v_B in ft/s", "--ask", "omega_AB"]) == 0
    )
    assert "Determine: v_B (ft/s), ω_AB." in capsys.readouterr().out


def test_one_quantity_is_asked_in_one_unit(tmp_path: Path, capsys: pytest.CaptureFixture[str]) -> None:
    assert "asked twice" in solved(tmp_path, capsys, '"v_A"', "--ask", "v_A", "--ask", "v_A in mph")


def test_units_and_fractions_in_grids_and_expressions(tmp_path: Path, capsys: pytest.CaptureFixture[str]) -> None:
    text = """
length_unit = "in"
ask = ["v_A"]
[parameters]
R = { unit = "in", values = ["1/2 ft"] }
t = { unit = "s", from = "1/4 min", to = "20 s", step = 5 }
[points]
O = { coordinates = { x = 0, y = 0 } }
A = { coordinates = { x = "R", y = "5/2 in" } }
B = { coordinates = { x = "2 * in + 1 * ft", y = 0 } }
[bodies]
crank = ["O", "A", "B"]
[[joints]]
pivot = { point = "O" }
[[drivers]]
rotation = { body = "crank", omega = "1 / t + (R / R)^2 / (1 * t)" }
"""
    path = tmp_path / "grid.toml"
    path.write_text(text, encoding="utf-8")
    assert main(["solve", str(path), "--set", "t=20", "--json"]) == 0
    document = json.loads(capsys.readouterr().out)
    assert document["parameters"]["R"]["value"] == 6
    assert document["points"]["A"]["position"] == pytest.approx([0.1524, 0.0635])
    assert document["points"]["B"]["position"] == pytest.approx([0.3556, 0])
    assert document["answers"][0]["value"] == pytest.approx(6.5 * 0.1)


@pytest.mark.parametrize(
    ("omega", "given", "worked_out"),
    [
        ("-100 rpm", "ω_crank = 100 rpm", "ω_crank = π · 100 / 30 = 10.47 rad/s"),
        ("2.5 rev/s", "ω_crank = 150 rpm", "ω_crank = π · 150 / 30 = 15.71 rad/s"),
        ("4", "ω_crank = 4 rad/s", "v_A = ω_crank · AO = 4 · 0.5 = 2 ft/s"),
    ],
)
def test_a_rate_in_turns_is_given_in_rpm_and_brought_to_radians(tmp_path, capsys, omega, given, worked_out):
    path = scene_file(tmp_path, SCENE.format(ask='"v_A"', omega=omega))
    assert main(["show", str(path), "--explain"]) == 0
    shown = capsys.readouterr().out.replace("\N{NO-BREAK SPACE}", " ")
    assert given in shown
    assert worked_out in shown


@pytest.mark.parametrize(
    ("velocity", "length", "given", "line", "ask"),
    [
        # 60 km/h are 60/3.6 = 16.67 m/s; P lies 4 m from A and 3 m from B, so that v_B = 16.67 * 3/4 = 12.5 m/s.
        ("60 km/h", "m", "v_A = 60 km/h", "v_A = 60 / 3.6 = 16.67 m/s", "v_B = 12.5 m/s"),
        # A mile has 160934.4 cm: 2682 cm/s, and 2012 cm/s.
        ("60 mi/h", "cm", "v_A = 60 mi/h", "v_A = 60 · 160934.4 / 3600 = 2682 cm/s", "v_B = 2012 cm/s"),
        ("50 ft/min", "ft", "v_A = 50 ft/min", "v_A = 50 / 60 = 0.8333 ft/s", "v_B = 0.625 ft/s"),
        ("5 m/s", "m", "v_A = 5 m/s", "", "v_B = 3.75 m/s"),
    ],
)
def test_velocities_are_given_as_they_are_stated_and_converted_in_a_line(
    velocity: str, length: str, given: str, line: str, ask: str, tmp_path: Path, capsys: pytest.CaptureFixture[str]
) -> None:
    scene = tmp_path / "ladder.toml"
    scene.write_text(
        f"""schema = 1
title = {{ en = "Ladder" }}
length_unit = "{length}"
ask = ["v_B"]
[points]
A = {{ coordinates = {{ x = 0, y = "3 m" }} }}
B = {{ coordinates = {{ x = "4 m", y = 0 }} }}
[bodies]
AB = ["A", "B"]
[[joints]]
guide = {{ point = "A", angle = "90 deg" }}
[[joints]]
guide = {{ point = "B", angle = 0 }}
[[drivers]]
travel = {{ point = "A", v = "{velocity}", angle = "-90 deg" }}
""",
        "utf-8",
    )
    assert main(["show", str(scene), "--lang", "en", "--explain"]) == 0
    said = capsys.readouterr().out.replace("\N{NO-BREAK SPACE}", " ")
    assert given in said
    assert line in said
    assert f"Answer: {ask}." in said
