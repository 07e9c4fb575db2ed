"""Two radii of one body that the figure gives no name have a symbol each."""

from __future__ import annotations

import pytest

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
    path = folder / "scene.toml"
    path.write_text(text, encoding="utf-8")
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
