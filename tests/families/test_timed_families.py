"""A family that moves by a law of time and asks for values of the interval: what check says of it, and its sheets."""

from __future__ import annotations

from pathlib import Path

import numpy as np
import pytest

import variantgen
from variantgen.check.family import check_family
from variantgen.cli import main
from variantgen.families.asking import read_ask
from variantgen.variants.printed_data import given_names, max_distinct_problems

FAMILY = """
schema = 1
title = { en = "Crank that starts from rest", ru = "Кривошип, начинающий движение из покоя" }
source = "own problem"
length_unit = "cm"
ask = [ASKED]

[parameters]
OA = { unit = "cm", from = 14, to = 40, step = 2 }
AB = { unit = "cm", from = 60, to = 120, step = 5 }
epsilon = { unit = "rad/s^2", from = 0.6, to = 1.4, step = 0.1 }
t = { unit = "s", from = 1, to = 2, step = 0.1 }

[laws]
time = "t"
phi = "epsilon * t^2 / 2"
interval = [0, 4]

[points]
O = { coordinates = { x = 0, y = 0 } }
A = { polar = { origin = "O", distance = "OA", angle = "phi" } }
B = { line_circle = { through = "O", centre = "A", distance = "AB", angle = 0, branch = "ahead" } }

[bodies]
OA = ["O", "A"]
AB = ["A", "B"]

[[joints]]
pivot = { point = "O" }
[[joints]]
guide = { point = "B" }
[[drivers]]
rotation = { body = "OA", omega = "phi_dot" }

[screens]
aspect = 6
require = ["AB > 1.5 * OA", "AB < 5 * OA"]
"""
ENGLISH = """The crank {{ OA }} of the mechanism {{ OAB }} starts from rest, in the line of the slider {{ B }}, with the
constant angular acceleration {{ epsilon }}. The connecting rod {{ AB }} is pinned to the crank and to the slider. The
figure shows the mechanism {{ t }} after the start; the motion is looked at for 4 s from the start.
"""
RUSSIAN = """Кривошип {{ OA }} механизма {{ OAB }} начинает вращаться из состояния покоя, в котором он лежит на прямой
движения ползуна {{ B }}, с постоянным угловым ускорением {{ epsilon }}. Шатун {{ AB }} соединён шарнирами
с кривошипом и ползуном. На рисунке показан механизм через {{ t }} после начала движения; движение длится 4 с.
"""
# The slider rests first after half a turn.
CASES = """
[[case]]
id = "half-turn"
source = "hand calculation: epsilon t^2 / 2 = pi at the first rest, 8 rad at the end"
magnitudes = true
set = { OA = 20, AB = 80, epsilon = 1, t = 1 }
exact = { t_zero_v_B = "sqrt(2 * pi)", turned_OA = "8 / deg" }
"""


def _family(tmp_path: Path, *asked: str) -> str:
    folder = tmp_path / "from_rest"
    folder.mkdir()
    text = FAMILY.replace("ASKED", ", ".join(f'"{name}"' for name in asked))
    for name, content in [
        ("family.toml", text),
        ("statement.en.j2", ENGLISH),
        ("statement.ru.j2", RUSSIAN),
        ("cases.toml", CASES),
    ]:
        (folder / name).write_text(content, encoding="utf-8")
    return str(folder)


def test_check_accepts_it(tmp_path):
    report = check_family(_family(tmp_path, "v_B", "max_t_v_B", "t_zero_v_B", "mean_t_v_B"), 12)
    assert (list(report.failures), report.remarks, report.cases) == ([], [], ["half-turn"])
    assert report.forms[0].variants == 12


def test_an_acceleration_in_a_law_is_given_where_velocities_alone_are_asked(tmp_path):
    """The angle of the crank depends on it: without it the problem could not be solved."""
    family = variantgen.load_family(_family(tmp_path, "v_B"))
    variant = variantgen.draw(family, ["v_B"], [("1",)])[0]
    asked = read_ask(variant.form, ["v_B"])
    assert given_names(variant, asked) == ["OA", "AB", "t", "epsilon"]
    assert max_distinct_problems(variant.form, asked) == 14 * 13 * 11 * 9


@pytest.mark.parametrize("asked", ["t_zero_v_B", "way_B"])
def test_what_no_calculation_by_hand_leads_to_need_not_be_short(asked, tmp_path):
    """sqrt(2 pi / epsilon) is no short decimal for any of the values of epsilon; there are variants nevertheless."""
    found = variantgen.batch(_family(tmp_path, asked), 6, seed=1, ask=[asked], nice=True)
    table = found.table()
    rest = np.sqrt(2 * np.pi / table["epsilon"])
    turned = 8 * table["epsilon"]  # rad, in 4 s
    place = table["OA"] * np.cos(turned) + np.sqrt(table["AB"] ** 2 - (table["OA"] * np.sin(turned)) ** 2)
    strokes = np.floor(turned / np.pi)
    begun = table["AB"] + np.where(strokes % 2 == 0, 1, -1) * table["OA"]
    way = 2 * strokes * table["OA"] + np.abs(place - begun)
    assert found.answers[asked] == pytest.approx({"t_zero_v_B": rest, "way_B": way}[asked])


@pytest.mark.parametrize(("language", "said"), [("en", "integrated numerically"), ("ru", "численное интегрирование")])
def test_a_family_tells_what_a_law_without_a_formula_leads_to(
    language: str, said: str, tmp_path: Path, capsys: pytest.CaptureFixture[str]
) -> None:
    """``epsilon = -3.3 (1 + sin^2 phi)`` from 5 rad/s to 60 degrees: 25 - 6.6 (phi + (phi - sin phi cos phi) / 2)."""
    law = 'phi = { epsilon = "-brake * (1 + sin(phi)^2)", start = { phi = 0, omega = "5 rad/s" } }'
    text = FAMILY.replace("ASKED", '"v_B"').replace('time = "t"\nphi = "epsilon * t^2 / 2"\ninterval = [0, 4]', law)
    brake = 'brake = { unit = "rad/s^2", values = [3.3] }\nphi = { unit = "deg", values = [60] }\n'
    kept = [line for line in text.splitlines() if not line.startswith(("t = {", "epsilon = {"))]
    folder = tmp_path / "braked"
    folder.mkdir()
    (folder / "family.toml").write_text("\n".join(kept).replace("\n\n[laws]", f"\n{brake}\n[laws]"), "utf-8")
    for name in ("en", "ru"):
        (folder / f"statement.{name}.j2").write_text("{{ OA }} {{ AB }} {{ brake }} {{ phi }}\n", "utf-8")
    assert main(["solve", "braked", "--families", str(tmp_path), "--explain", "--lang", language]) == 0
    phi = np.pi / 3
    omega = np.sqrt(25 - 6.6 * (phi + (phi - np.sin(phi) * np.cos(phi)) / 2))
    found = " ".join(capsys.readouterr().out.replace(",", ".").split())
    assert said in found and f"= {omega:.3f}" in found
