"""Messages that lead an author to what helps: one test for each."""

from __future__ import annotations

from pathlib import Path

import pytest

from tests.scene_texts import CRANK
from variantgen.cli import main
from variantgen.resources import catalog_dir

PLANET = """
length_unit = "cm"
[points]
O = { coordinates = { x = 0, y = 0 } }
A = { polar = { origin = "O", distance = 30, angle = 20 } }
M = { polar = { origin = "A", distance = 10, angle = 60 } }
[bodies]
OA = ["O", "A"]
wheel = ["A", "M"]
[[joints]]
pivot = { point = "O" }
[[joints]]
rolling_on_circle = { body = "wheel", centre = "A", radius = 10, around = "O" }
[[drivers]]
rotation = { body = "OA", omega = 2 }
"""
BELTS = """
length_unit = "cm"
ask = ["v_O", "omega_pinion"]
[points]
K = { coordinates = { x = 0, y = 0 } }
O = { coordinates = { x = 0, y = 10 } }
N = { coordinates = { x = 0, y = 20 } }
A = { coordinates = { x = 40, y = 0 } }
B = { coordinates = { x = 40, y = 20 } }
E = { coordinates = { x = -40, y = 0 } }
F = { coordinates = { x = -40, y = 20 } }
[bodies]
pinion = ["O", "K", "N"]
low = ["A", "E"]
up = ["B", "F"]
[[joints]]
guide = { point = "A", angle = 0 }
[[joints]]
translation = { body = "low" }
[[joints]]
guide = { point = "B", angle = 0 }
[[joints]]
translation = { body = "up" }
[[joints]]
rolling = { body = "pinion", centre = "O", contact = "K", on = "low", on_point = "A" }
[[joints]]
rolling = { body = "pinion", centre = "O", contact = "N", on = "up", on_point = "B" }
[[drivers]]
travel = { point = "A", v = 10, angle = 0 }
[[drivers]]
travel = { point = "B", v = 20, angle = 0 }
"""
ROPE = """
length_unit = "cm"
[points]
K = { coordinates = { x = 0, y = 50 } }
L = { coordinates = { x = -10, y = 0 } }
T = { coordinates = { x = 10, y = 0 } }
[[joints]]
guide = { point = "L", angle = 90 }
[[joints]]
guide = { point = "T", angle = 90 }
[[joints]]
rope.path = [{ point = "L" }, { point = "K", radius = 10, side = "up", fixed = true }, { point = "T" }]
[[drivers]]
travel = { point = "L", v = 7, angle = 90 }
"""
WHEEL = """
length_unit = "cm"
[points]
O = { coordinates = { x = 0, y = 10 } }
M = { polar = { origin = "O", distance = 10, angle = 30 } }
[bodies]
wheel = ["O", "M"]
[[joints]]
guide = { point = "O", angle = 0 }
[[drivers]]
travel = { point = "O", v = 10, angle = 0 }
"""


@pytest.fixture
def output(tmp_path: Path, capsys: pytest.CaptureFixture[str]):
    def solve(text: str, code: int, *words: str) -> str:
        path = tmp_path / f"scene{len(list(tmp_path.iterdir()))}.toml"
        path.write_text(text, encoding="utf-8")
        assert main(["solve", str(path), *words]) == code
        found = capsys.readouterr()
        return found.err if code else found.out

    return solve


def test_a_crank_that_leads_a_wheel_on_a_circle(output):
    message = output(PLANET, 2)
    assert 'write gears = { body = "wheel", centre = "A", other_centre = "O", ... } in its place' in message
    assert "or leave out the driver of the crank" in message
    meshed = PLANET.replace("rolling_on_circle", "gears").replace("around", "other_centre")
    # The carrier turns at 2, the planet at 2 (1 + R / r) = 2 * 30 / 10.
    assert "omega_wheel = 6 rad/s" in output(meshed, 0)


def test_two_belts_at_one_wheel(output):
    assert "write axle_held = true in one of the joints rolling of pinion" in output(BELTS, 2)
    held = BELTS.replace('on_point = "B" }', 'on_point = "B", axle_held = true }')
    # The centre goes at the mean speed, the wheel turns clockwise at the difference over its diameter.
    assert output(held, 0).split() == ["v_O", "=", "15", "cm/s", "omega_pinion", "=", "-0.5", "rad/s"]


def test_sides_of_a_rope_are_told_in_words(output):
    message = output(ROPE, 2)
    assert 'rope.path[2].side: expected "left" or "right" (of the circle, looking along the rope' in message
    assert "as where it goes up, over a pulley to the right, and down again" in message
    left = ROPE.replace('"up"', '"left"')
    assert "v_T = 7 cm/s" in output(left, 0)  # so it does here
    # Nothing is accelerated, also where the solution says so.
    assert output(left, 0, "--explain").rstrip().endswith("a_T = 0\N{NO-BREAK SPACE}cm/s².")


@pytest.mark.parametrize("small", ["1e-15", "-2.4e-16", '"1e-15 cm"'])
def test_what_rounding_left_of_a_zero_is_zero(output, small):
    assert "omega_OA = 2 rad/s" in output(CRANK.replace("y = 0", f"y = {small}"), 0)


def test_a_fraction_among_values(output):
    text = CRANK.replace("distance = 20", 'distance = "R"').replace('length_unit = "cm"', "")
    table = '[parameters]\nR = { unit = "cm", values = ["5/3"] }\n'
    assert "R = 1.66667 cm" in output(table + text, 0)
    message = output(table.replace("5/3", "five") + text, 2)
    assert "parameters.R.values: expected a list of numbers (got ['five'])" in message
    assert 'write each as a number, or as "2 cm" or "5/3"' in message
    assert "unknown name" not in message  # R is known, only wrong


def test_a_quantity_that_one_form_is_given(capsys):
    for words in (["solve", "slider_crank", "--ask", "v_B"], ["solve", "slider_crank", "--ask", "v_B", "--seed", "3"]):
        assert main(words) == 2
        message = capsys.readouterr().err
        assert "is given, so it cannot be asked in the form driven_by_slider (got v_B)" in message
        assert 'choose  form = "central" or "offset"' in message


@pytest.mark.parametrize(
    ("asked", "remedy"),
    [
        ("alpha_OA", "write epsilon_OA: angular velocities are omega, angular accelerations epsilon"),
        ("w_OA", "write omega_OA: angular velocities are omega, angular accelerations epsilon"),
        (
            "theta_OA",
            "the direction of OA is angle_OA, a corner of three points angle_O.A.B",
        ),
        ("s_A", "a coordinate is x_B or y_B, the distance of two points distance_A.B; points: A, O"),
        ("omega_A", "A is no body; its rotation is that of omega_OA"),
        ("v_A at t = 3", "state a law of time in [laws], and the time as a parameter"),
    ],
)
def test_quantities_in_other_letters(output, asked, remedy):
    assert remedy in output(f'ask = ["{asked}"]\n{CRANK}', 2)


def test_nothing_to_widen(tmp_path, capsys):
    """An exam with a scene in which nothing varies and that no screen lets pass."""
    folder = tmp_path / "fixed"
    folder.mkdir()
    low = CRANK.replace("distance = 20", 'distance = "side * 20 * cm"')
    parameters = "[parameters]\nside = { choices = { right = 1 } }\n[screens]\nspacing = 3\n"
    (folder / "family.toml").write_text(
        'title = { en = "T" }\nask = ["v_A"]\n' + low.replace("[points]", parameters + "[points]"), encoding="utf-8"
    )
    (folder / "statement.en.j2").write_text("The crank {{ OA }} turns.", encoding="utf-8")
    exam = tmp_path / "exam.toml"
    exam.write_text('title = "T"\nlanguage = "en"\nseed = 1\n[[problem]]\nfamily = "fixed"\n', encoding="utf-8")
    assert main(["build", str(exam), "--variants", "1", "--out", str(tmp_path / "out")]) == 2
    message = capsys.readouterr().err
    assert "widen the range of one of" not in message
    assert "all its numbers are fixed, so no other draw can pass" in message


def test_marks_carry_names_of_parameters(output):
    marked = WHEEL + '[figure]\nangles = [{ name = "30", at = "O", from = "+x", to = "M" }]\n'
    message = output(marked, 2)
    assert "figure.angles[1].name: a mark carries the name of a parameter (got 30)" in message
    assert 'phi = { unit = "deg", values = [30] }' in message


def test_a_wheel_that_nothing_turns(output):
    drawn = WHEEL + '[figure]\ndiscs = [{ centre = "O", radius = 10, body = "wheel" }]\n'
    message = output(drawn, 2)  # the radius of a disc may be a number, like every other length
    assert "(got omega of wheel)" in message
    assert "nothing turns wheel; a wheel rolls (rolling), meshes (gears)" in message


def test_what_stands_below_the_wrong_heading(output):
    message = output(
        CRANK.replace("[bodies]\n", '[bodies]\nask = ["v_A"]\njoints = [{ pivot = { point = "O" } }]\n'), 2
    )
    assert "bodies.joints: stands below the heading [bodies]" in message
    assert "write [[joints]] as a heading of its own" in message
    assert "bodies.ask" in message


def test_a_point_that_a_travel_alone_moves(output):
    free = CRANK.partition("[bodies]")[0] + '[[drivers]]\ntravel = { point = "A", v = 3 }\n'
    assert "A may go anywhere; a travel alone leads no point along a line, a guide or a slot does" in output(free, 2)


def test_a_graph_of_what_is_no_rate_with_its_acceleration(tmp_path, capsys):
    source = (catalog_dir() / "slider_crank_with_graph" / "family.toml").read_text("utf-8")
    path = tmp_path / "graph.toml"
    path.write_text(source.replace('["omega_OA", "epsilon_OA"]', '["omega_OA", "phi"]'), "utf-8")
    assert main(["check", str(path)]) == 2
    assert "expected the parameters of a rate and of its acceleration (got omega_OA, phi)" in capsys.readouterr().err
