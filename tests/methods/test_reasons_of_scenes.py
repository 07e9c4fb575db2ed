"""What solutions of scenes with a block on a link say beside their formulas."""

from __future__ import annotations

from pathlib import Path

import pytest

from tests.scene_files import scene_file
from variantgen.cli import main

# OA and DB are parallel: AB is in translation. v_A = (-100, -100), v_C = (-100, -300) across CE, v_rel C = (0, -200).
ON_A_COUPLER = """
length_unit = "cm"
ask = ["v_C", "v_rel_C"]
points.O.coordinates = { x = 0, y = 0 }
points.A.coordinates = { x = -25, y = 25 }
points.B.coordinates = { x = -25, y = 95 }
points.D.coordinates = { x = -60, y = 130 }
points.C.coordinates = { x = -25, y = 60 }
points.E.coordinates = { x = 5, y = 50 }
bodies = { OA = ["O", "A"], AB = ["A", "B"], DB = ["D", "B"], EC = ["E", "C"] }
joints = [
    { pivot = { point = "O" } }, { pivot = { point = "D" } }, { pivot = { point = "E" } },
    { slot = { point = "C", body = "AB", along = ["A", "B"] } },
]
drivers = [{ rotation = { body = "OA", omega = 4 } }]
"""
# v_A = (-60, 40); F of the link CD goes down at 40, so v_F/A = (-60, -80) and v_rel F = (-120, 0).
ON_A_LEVEL_LINK = """
length_unit = "cm"
ask = ["v_rel_F", "omega_AF"]
points.O.coordinates = { x = 0, y = 0 }
points.A.coordinates = { x = 20, y = 30 }
points.C.coordinates = { x = 100, y = 0 }
points.D.coordinates = { x = 40, y = 0 }
points.F.coordinates = { x = 60, y = 0 }
bodies = { OA = ["O", "A"], AF = ["A", "F"], CD = ["C", "D"] }
joints = [
    { pivot = { point = "O" } }, { pivot = { point = "C" } },
    { slot = { point = "F", body = "CD", along = ["C", "D"] } },
]
drivers = [{ rotation = { body = "OA", omega = 2 } }, { rotation = { body = "CD", omega = 1 } }]
"""
# The pin of a level link in an upright guide: v_B = 2 * 30 up, nothing along the link.
PIN_ON_A_LEVEL_LINK = """
length_unit = "cm"
ask = ["v_B", "v_rel_B", "a_B"]
points.O.coordinates = { x = 0, y = 0 }
points.A.coordinates = { x = 50, y = 0 }
points.B.coordinates = { x = 30, y = 0 }
bodies = { OA = ["O", "A"] }
joints = [
    { pivot = { point = "O" } }, { guide = { point = "B", angle = 90 } },
    { slot = { point = "B", body = "OA", along = ["O", "A"] } },
]
drivers = [{ rotation = { body = "OA", omega = 2 } }]
"""
# CA and AD are at right angles: a perpendicular from C to AD would end at A.
RIGHT_ANGLE_AT_THE_PIN = """
length_unit = "cm"
ask = ["v_rel_D", "omega_CE"]
bodies = { OA = ["O", "D", "A"], AB = ["A", "C", "B"], CE = ["C", "E"] }
joints = [
    { pivot = { point = "O" } }, { guide = { point = "B" } },
    { slot = { point = "D", body = "CE", along = ["C", "E"] } },
]
drivers = [{ rotation = { body = "OA", omega = 1.5 } }]
[parameters]
OA = { unit = "cm", values = [25] }
AB = { unit = "cm", values = [65] }
phi = { unit = "deg", values = [60] }
[points]
O = { coordinates = { x = 0, y = 0 } }
A = { polar = { origin = "O", distance = "OA", angle = "180*deg + phi" } }
B = { polar = { origin = "A", distance = "AB", towards = "O", angle = "-90*deg" } }
C = { fraction = { start = "A", end = "B" } }
D = { fraction = { start = "O", end = "A" } }
E = { fraction = { start = "C", end = "D", part = "1.6" } }
"""
# AB goes through the collar P: omega_AB = -4/3, v_B = (-60, -40); omega_BC = 4/3, v_C = -60 + 40 * 4/3.
ROD_BEYOND_A_COLLAR = """
length_unit = "cm"
ask = ["v_C", "omega_BC"]
bodies = { OA = ["O", "A"], AB = ["A", "B"], BC = ["B", "C"] }
joints = [
    { pivot = { point = "O" } }, { pivot = { point = "P" } }, { guide = { point = "C" } },
    { slot = { point = "P", body = "AB", along = ["A", "B"] } },
]
drivers = [{ rotation = { body = "OA", omega = 2 } }]
points.O.coordinates = { x = 0, y = 0 }
points.A.coordinates = { x = 20, y = 30 }
points.P.coordinates = { x = 50, y = 30 }
points.B.coordinates = { x = 80, y = 30 }
points.C.coordinates = { x = 110, y = -10 }
"""


def explained(folder: Path, text: str, lang: str, capsys: pytest.CaptureFixture[str]) -> str:
    """The solution of a scene as it is printed."""
    assert main(["show", str(scene_file(folder, text)), "--explain", "--lang", lang]) == 0
    return capsys.readouterr().out


@pytest.mark.parametrize(
    ("lang", "reason"), [("en", "ω_AB = 0, so v_C′/A = 0."), ("ru", "ω_AB = 0, поэтому v_CA = 0.")]
)
def test_why_a_carrier_in_translation_adds_nothing(
    lang: str, reason: str, tmp_path: Path, capsys: pytest.CaptureFixture[str]
) -> None:
    text = explained(tmp_path, ON_A_COUPLER, lang, capsys)
    assert reason in text
    assert "316,2" in text.replace(".", ",") and "200" in text  # sqrt(100^2 + 300^2)


def test_a_check_begins_with_the_quantity_that_it_finds_again(
    tmp_path: Path, capsys: pytest.CaptureFixture[str]
) -> None:
    """On an axis along the link the other side is v_rel F alone: no line with a number and nothing else."""
    text = explained(tmp_path, ON_A_LEVEL_LINK, "en", capsys).replace("\N{NO-BREAK SPACE}", " ")
    check = text.partition("Check.")[2].splitlines()
    assert "v_rel F = 72.11 · sin 56.31° + 100 · 3/5 = 120" in check[2]
    assert not [line for line in check if line.strip() == "120"]


def test_a_vector_that_is_zero_points_nowhere(tmp_path: Path, capsys: pytest.CaptureFixture[str]) -> None:
    text = explained(tmp_path, PIN_ON_A_LEVEL_LINK, "en", capsys)
    velocities = text.partition("2. Acceleration")[0].replace("\n", " ").replace("\N{NO-BREAK SPACE}", " ")
    assert "along the line OA. Let ξ" in velocities
    assert "v_rel B = 0 cm/s" in velocities


def test_no_perpendicular_ends_at_a_pin(tmp_path: Path, capsys: pytest.CaptureFixture[str]) -> None:
    text = explained(tmp_path, RIGHT_ANGLE_AT_THE_PIN, "ru", capsys)
    assert "Треугольник ACD прямоугольный" in text
    assert "перпендикуляр CH" not in text


@pytest.mark.parametrize(
    ("lang", "reason"), [("en", "is the angle of v⃗_B with the x axis"), ("ru", "угол v⃗_B с осью x; первое слагаемое")]
)
def test_it_is_said_what_the_angle_of_a_velocity_is(
    lang: str, reason: str, tmp_path: Path, capsys: pytest.CaptureFixture[str]
) -> None:
    text = explained(tmp_path, ROD_BEYOND_A_COLLAR, lang, capsys)
    assert reason in text.replace("\n", " ").replace("\N{NO-BREAK SPACE}", " ")
    assert "6,667" in text.replace(".", ",")
