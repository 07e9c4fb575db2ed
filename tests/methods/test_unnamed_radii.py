"""Two radii of one body that the figure gives no name have a symbol each."""

from __future__ import annotations

import pytest

from tests.scene_files import scene_file
from variantgen.cli import main

# A spool on an axle that moves level: one thread is pulled below at 10 cm, the other, at 15 cm below, is tied.
SPOOL = """
length_unit = "cm"
ask = ["v_O", "omega_spool"]
[points]
O = { coordinates = { x = 0, y = 30 } }
M = { coordinates = { x = 0, y = 0 } }
T = { coordinates = { x = 150, y = 20 } }
S = { coordinates = { x = -150, y = 15 } }
[bodies]
spool = ["O", "M"]
[[joints]]
guide = { point = "O", angle = 0 }
[[joints]]
guide = { point = "T", angle = 0 }
[[joints]]
rope.path = [{ point = "O", radius = 10, side = "right", body = "spool" }, { point = "T" }]
[[joints]]
rope.path = [{ point = "S", fixed = true }, { point = "O", radius = 15, side = "right", body = "spool" }]
[[drivers]]
travel = { point = "T", v = 40, angle = 0 }
"""


def explained(text: str, folder, capsys: pytest.CaptureFixture[str]) -> str:
    path = scene_file(folder, text)
    assert main(["solve", str(path), "--explain"]) == 0
    return capsys.readouterr().out.replace("\N{NO-BREAK SPACE}", " ")


def test_threads_on_two_radii(tmp_path, capsys):
    """omega = 40 / (15 - 10), v_O = 15 omega."""
    output = explained(SPOOL, tmp_path, capsys)
    assert " = r_2 spool − r_spool = 15 − 10 = 5 cm" in output
    assert "r_2 spool = 8 \N{MIDDLE DOT} 15 = 120 cm/s" in output


def test_threads_of_one_radius_have_one_symbol(tmp_path, capsys):
    """One thread above, one below, both at 10 cm: omega = 40 / 20."""
    text = SPOOL.replace("y = 15", "y = 40").replace('radius = 15, side = "right"', 'radius = 10, side = "left"')
    output = explained(text, tmp_path, capsys)
    assert "r_2" not in output
    assert "r_spool = " in output


# A drum that turns and one at rest have the axle O in common, and radii of 10 cm by chance.
TWO_ON_ONE_AXLE = """
length_unit = "cm"
ask = ["v_B"]
[parameters]
r_1 = { unit = "cm", values = [10] }
r_2 = { unit = "cm", values = [10] }
omega_2 = { unit = "rad/s", values = [3] }
[points]
O = { coordinates = { x = 0, y = 0 } }
M = { coordinates = { x = 0, y = "r_1" } }
N = { coordinates = { x = 0, y = "-r_2" } }
B = { coordinates = { x = "r_2", y = "-80*cm" } }
[bodies]
low = ["O", "M"]
high = ["O", "N"]
[[joints]]
pivot = { point = "O" }
[[joints]]
guide = { point = "B", angle = 90 }
[[joints]]
rope.path = [{ point = "O", radius = "r_2", side = "left", body = "high" }, { point = "B" }]
[[drivers]]
rotation = { body = "high", omega = "omega_2" }
[[drivers]]
rotation = { body = "low", omega = "2 * omega_2" }
[figure]
discs = [{ centre = "O", radius = "r_1", body = "low" }, { centre = "O", radius = "r_2", body = "high" }]
"""


def test_radii_equal_by_chance_are_told_apart_by_their_bodies(tmp_path, capsys):
    """v_B = omega_2 r_2 = 3 * 10, not omega_2 r_1."""
    output = explained(TWO_ON_ONE_AXLE, tmp_path, capsys)
    assert "r_2 = 3 \N{MIDDLE DOT} 10 = 30 cm/s" in output
    assert "\N{MIDDLE DOT} r_1" not in output


WHEEL = """
length_unit = "cm"
ask = ["v_M", "a_M"]
[points]
K = { coordinates = { x = 0, y = 0 } }
O = { coordinates = { x = 0, y = 20 } }
M = { coordinates = { x = 20, y = 20 } }
[bodies]
W = ["O", "K", "M"]
[[joints]]
rolling = { body = "W", centre = "O", contact = "K" }
[[drivers]]
travel = { point = "O", v = 40, a = 30 }
"""


def test_a_contact_has_one_letter(tmp_path, capsys):
    """The figure shows no K unless it is asked about: the contact is the velocity centre P from the first step on."""
    output = explained(WHEEL, tmp_path, capsys)
    assert "the contact P is" in output
    assert "base points O and P" in output
    assert "contact K" not in output
