"""Solutions of problems with laws of time: what is a derivative is called one, signs are kept, turns are radians."""

from __future__ import annotations

import unicodedata
from pathlib import Path

import pytest

from tests.scene_files import scene_file
from variantgen.cli import main

ROLLING = """
length_unit = "cm"
ask = ["v_O", "a_O", "omega_w"]
[parameters]
t = { unit = "s", values = [2] }
R = { unit = "cm", values = [30] }
[laws]
time = "t"
s = "40 + t^3/4 - 10*t"
[points]
P = { coordinates = { x = "s", y = 0 } }
O = { coordinates = { x = "s", y = "R" } }
[bodies]
w = ["O", "P"]
[[joints]]
rolling = { body = "w", centre = "O", contact = "P" }
[[drivers]]
travel = { point = "O", v = "s_dot", a = "s_ddot" }
"""

CRANK = """
length_unit = "cm"
ask = ["v_A", "a_A"]
[parameters]
OA = { unit = "cm", values = [20] }
t = { unit = "s", values = [1] }
[laws]
time = "t"
phi = "3*t - t^2/4"
[points]
O = { coordinates = { x = 0, y = 0 } }
A = { polar = { origin = "O", distance = "OA", angle = "phi" } }
B = { line_circle = { through = "O", centre = "A", distance = 60, angle = 0, branch = "ahead" } }
[bodies]
OA = ["O", "A"]
AB = ["A", "B"]
[[joints]]
pivot = { point = "O" }
[[joints]]
guide = { point = "B" }
[[drivers]]
rotation = { body = "OA", omega = "phi_dot", epsilon = "phi_ddot" }
"""


def _shown(text: str, tmp_path: Path, capsys: pytest.CaptureFixture[str], lang: str = "en") -> str:
    path = scene_file(tmp_path, text)
    assert main(["show", str(path), "--explain", "--lang", lang]) == 0, capsys.readouterr().err
    out = capsys.readouterr().out.replace("\N{NO-BREAK SPACE}", " ")
    return " ".join(unicodedata.normalize("NFC", out).split())


def test_a_law_is_differentiated_with_its_signs(tmp_path, capsys):
    """At t = 2 the derivative of 40 + t^3/4 - 10 t is 3 - 10 = -7, the second 3/2 * 2 = 3."""
    out = _shown(ROLLING, tmp_path, capsys)
    assert "ṡ = 3 t^2 / 4 − 10 = 3 · 2^2 / 4 − 10 = −7 cm/s v_O = |ṡ| = |−7| = 7 cm/s" in out
    assert "a_O = s̈ = 3 t / 2 = 3 · 2 / 2 = 3 cm/s² ṡ and s̈ have opposite signs: the motion slows down." in out
    assert "ω_w = v_O / R = 7 / 30 =" in out  # the radius is the datum R, and no sentence says what a radius is


def test_a_law_of_turning_is_in_radians_first(tmp_path, capsys):
    """At t = 1 the angle is 3 - 1/4 = 2.75 rad, 157.56 degrees; its derivatives are 3 - t/2 = 2.5 and -1/2."""
    text = CRANK.replace('["v_A", "a_A"]', '["v_B", "a_B"]')
    out = _shown(text, tmp_path, capsys, "ru")
    assert "φ = 3 t − t^2 / 4 = 3 · 1 − 1^2 / 4 = 2,75 рад φ = 180° · 2,75 / π = 157,56°" in out
    assert "ω_OA = φ̇ = 3 − t / 2 = 3 − 1 / 2 = 2,5 рад/с" in out
    assert "φ̈ = −0,5 рад/с² ε_OA = |φ̈| = |−0,5| = 0,5 рад/с² Знаки φ̇ и φ̈ противоположны" in out


def test_the_angle_before_the_start_is_negative(tmp_path, capsys):
    """At t = 1 the angle 2 t + t^3 - 4 is -1 rad: the triangle ABO has no right angle."""
    text = CRANK.replace('"3*t - t^2/4"', '"2*t + t^3 - 4"').replace('["v_A", "a_A"]', '["v_B"]')
    out = _shown(text, tmp_path, capsys)
    assert "= −1 rad φ = 180° · (−1) / π = −57.30°" in out
    assert "By the law of sines in triangle ABO" in out


@pytest.mark.parametrize(
    ("letter", "said"), [("n", "ω_OA = π · n / 30 = π · 90 / 30 ="), ("omega", "ω = π · 90 / 30 =")]
)
def test_turns_per_minute_are_converted_in_a_step(letter, said, tmp_path, capsys):
    head, _, _ = CRANK.partition("[laws]")
    text = head + f'{letter} = {{ unit = "rpm", values = [90] }}\n' + CRANK[CRANK.index("[points]") :]
    text = text.replace('"phi"', "40").replace('"phi_dot", epsilon = "phi_ddot"', f'"{letter}"')
    out = _shown(text, tmp_path, capsys)
    assert said in out  # 3 pi = 9.425 rad/s, of 20 cm: 188.5 cm/s
    assert "v_A = ω · OA" in out or "v_A = ω_OA · OA" in out
    assert "= 188.5 cm/s" in out
