"""Problems of books, written as scenes in cm and mm: the printed answers, and a worked solution that leads to them."""

from __future__ import annotations

import pytest

from tests.scene_files import scene_file, solved_items
from variantgen.cli import main

CRANK_AND_SLIDER = """
length_unit = "{unit}"
[points]
O = {{ coordinates = {{ x = 0, y = 0 }} }}
A = {{ polar = {{ origin = "O", distance = {OA}, angle = {phi} }} }}
K = {{ coordinates = {{ x = 0, y = {h} }} }}
B = {{ line_circle = {{ through = "K", centre = "A", distance = {AB}, angle = 0 }} }}
[bodies]
OA = ["O", "A"]
AB = ["A", "B"]
[[joints]]
pivot = {{ point = "O" }}
[[joints]]
guide = {{ point = "B", angle = 0 }}
[[drivers]]
rotation = {{ body = "OA", omega = {omega} }}
"""
FOUR_BAR = """
length_unit = "{unit}"
[points]
A = {{ coordinates = {{ x = 0, y = 0 }} }}
D = {{ coordinates = {{ x = {AD}, y = 0 }} }}
B = {{ polar = {{ origin = "A", distance = {AB}, angle = 60 }} }}
C = {{ polar = {{ origin = "D", distance = {CD}, angle = 120 }} }}
[bodies]
AB = ["A", "B"]
BC = ["B", "C"]
CD = ["C", "D"]
[[joints]]
pivot = {{ point = "A" }}
[[joints]]
pivot = {{ point = "D" }}
[[drivers]]
rotation = {{ body = "AB", omega = 3 }}
"""
DISK = """
length_unit = "{unit}"
[points]
P = {{ coordinates = {{ x = 0, y = 0 }} }}
C = {{ coordinates = {{ x = 0, y = {r} }} }}
B = {{ polar = {{ origin = "C", distance = {r}, angle = 150 }} }}
[bodies]
disk = ["C", "P", "B"]
[[joints]]
rolling = {{ body = "disk", centre = "C", contact = "P" }}
[[drivers]]
rotation = {{ body = "disk", omega = -2, epsilon = -4 }}
"""
METRES = {"mm": 0.001, "cm": 0.01, "m": 1.0}
# Text, lengths in m, other data, answers as printed (SI) with the last digit that is printed.
BOOKS = {
    "Schaum 14-18, 14-19": (
        FOUR_BAR, {"AB": 0.3, "AD": 0.7, "CD": 0.4}, {},
        {"omega_BC.abs": (2.25, 0.01), "omega_CD.abs": (1.69, 0.01), "epsilon_CD.abs": (10.475, 0.05)},
    ),
    "Meshchersky 18.13, crank level": (
        CRANK_AND_SLIDER, {"OA": 0.1, "AB": 0.4, "h": -0.15}, {"phi": 0, "omega": 2},
        {"omega_AB.abs": (0.53936, 1e-5), "epsilon_AB.abs": (0.11768, 1e-5),
         "v_B": (0.080904, 1e-6), "a_B": (0.52552, 1e-5)},
    ),
    "Meshchersky 18.13, crank upright": (
        CRANK_AND_SLIDER, {"OA": 0.1, "AB": 0.4, "h": -0.15}, {"phi": 90, "omega": 2},
        {"omega_AB.abs": (0, 1e-9), "epsilon_AB.abs": (1.28103, 1e-5), "v_B": (0.2, 1e-9), "a_B": (0.32026, 1e-5)},
    ),
    "Meshchersky 18.9, 0 degrees": (
        CRANK_AND_SLIDER, {"OA": 0.4, "AB": 2, "h": 0}, {"phi": 0, "omega": 15},
        {"a_B": (108, 0.5), "Q_AB.B": (12, 0.005)},
    ),
    "Meshchersky 18.9, 180 degrees": (
        CRANK_AND_SLIDER, {"OA": 0.4, "AB": 2, "h": 0}, {"phi": 180, "omega": 15},
        {"a_B": (72, 0.5), "Q_AB.B": (8, 0.005)},
    ),
    "Hibbeler 16-109": (
        DISK, {"r": 0.4}, {},
        {"v_B.x": (1.2, 0.005), "v_B.y": (0.69, 0.005), "a_B.x": (3.79, 0.005), "a_B.y": (0.59, 0.005)},
    ),
}  # fmt: skip


@pytest.mark.parametrize("unit", METRES)
@pytest.mark.parametrize("book", BOOKS)
def test_the_printed_answers_and_a_solution(book, unit, tmp_path, capsys):
    text, lengths, others, expected = BOOKS[book]
    data = {name: f"{value / METRES[unit]:.9g}" for name, value in lengths.items()}
    path = scene_file(tmp_path, text.format(unit=unit, **data, **others))
    asked = [word for name in expected for word in ("--ask", name)]
    for name, item in solved_items(path, capsys, *expected).items():
        number, digit = expected[name]
        in_metres = METRES.get(item["unit"].partition("/")[0], 1.0)
        assert item["value"] * in_metres == pytest.approx(number, abs=digit)
        assert item["tolerance"] <= 0.1 * abs(item["value"])
    assert main(["solve", str(path), "--explain", *asked]) == 0
    assert "Answer" in capsys.readouterr().out
