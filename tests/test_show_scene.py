"""``show`` of a scene of one's own: the data of its file as given, a figure, answers, a page with the solution."""

from __future__ import annotations

import math
import re
from pathlib import Path

import pytest

import variantgen
from variantgen.check.family import check_family
from variantgen.cli import main
from variantgen.families.parameters.parameter import Parameter
from variantgen.families.reading.load import load_family
from variantgen.figure.drawing import Arc
from variantgen.single import one_variant

KINDS = Path(__file__).parent / "textbook_kinds"


def _shown(capsys, *arguments: str) -> str:
    assert main(["show", *arguments]) == 0
    return re.sub(r"\s+", " ", capsys.readouterr().out)


@pytest.mark.parametrize(
    ("scene", "given"),
    [
        (
            "crank_shaper",
            "OA = 120 mm, CD = 600 mm, DE = 200 mm, ∠(OA, x) = 20°, x_C = 0 mm, y_C = 0 mm, x_O = 0 mm, y_O = 300 mm,"
            " y_E = 620 mm, ω_OA = 4 rad/s.",
        ),
        (
            "frame_on_cart",
            "CD = 2 m, CM = 1.2 m, ∠(CD, x) = 50°, ∠(CM, x) = 50°, x_C = 0 m, y_C = 0 m, x_E = 1 m, y_E = 0 m,"
            " v_C = 2 m/s, a_C = 1 m/s², ω_rod/cart = 1.5 rad/s, α_rod/cart = 0.5 rad/s², v_rel M = 0.4 m/s,"
            " a_rel M = 0.2 m/s².",
        ),
        ("planetary_compound", "AM = 25 mm, r_planet = 25 mm, ∠(AM, x) = 60°, x_O = 0 mm, y_O = 0 mm, x_A = 65 mm,"),
        ("whitworth", "OA = 16 cm, CD = 12 cm, DE = 40 cm,"),
        ("pin_two_slots", "AC = 60 cm, BD = 60 cm, ∠(AP, x) = 55°, ∠(BP, x) = 120°,"),
        (
            "straight_cam_slot",
            "OS = 10 cm, ST = 40 cm, ∠(OS, x) = 15°, ∠(ST, x) = 70°, x_O = 0 cm, y_O = 0 cm, x_B = 14 cm,",
        ),
    ],
)
def test_the_numbers_of_the_file_are_given(scene, given, capsys):
    out = _shown(capsys, str(KINDS / f"{scene}.toml"))
    assert f"Given: {given}" in out
    assert "The figure shows the mechanism to scale" in out


def test_rates_of_second_order_are_given_for_accelerations_alone(capsys):
    for asked in (["--ask", "v_M"], ["--ask", "x_M"], ["--ask", "v_M", "--ask", "x_M"]):
        out = _shown(capsys, str(KINDS / "frame_on_cart.toml"), *asked)
        assert "v_C = 2 m/s" in out
        assert "a_C" not in out


def test_parameters_stand_with_the_numbers(tmp_path, capsys):
    text = (KINDS / "crank_shaper.toml").read_text(encoding="utf-8")
    text = text.replace("[points]", '[parameters]\nphi = { unit = "deg", values = [25] }\n\n[points]')
    path = tmp_path / "shaper.toml"
    path.write_text(text.replace("angle = 20", 'angle = "phi"'), encoding="utf-8")
    out = _shown(capsys, str(path), "--lang", "ru")
    assert "Дано: φ = 25°, OA = 120 мм" in out
    assert "∠(OA, x) = φ," in out
    assert "На рисунке показан" in out


@pytest.mark.parametrize("ending", ["png", "svg", "pdf"])
def test_a_page_with_the_solution(ending, tmp_path):
    goal = tmp_path / f"page.{ending}"
    assert main(["show", str(KINDS / "crank_shaper.toml"), "--explain", "--out", str(goal)]) == 0
    assert goal.stat().st_size > 1000


def test_a_number_is_no_parameter():
    form = load_family(str(KINDS / "crank_shaper.toml")).forms[""]
    assert not [p for p in form.parameters.values() if isinstance(p, Parameter)]


# What the shapes of bodies are by their points and joints; each file says nothing of it.
DRAWN = {
    "watt_six_bar": {"plates": ("CBD",), "discs": [], "lines": ()},
    "chebyshev_linkage": {"plates": (), "discs": [], "lines": (("A", "M"),)},
    "planetary_compound": {"plates": (), "discs": [("A", "planet"), ("O", "sun")], "lines": ()},
    "two_wheels_rod": {"plates": (), "discs": [("O", "w1"), ("Q", "w2")], "lines": ()},
    "moving_frame_disc": {"plates": ("disc",), "discs": [], "lines": ()},
}


@pytest.mark.parametrize("scene", DRAWN)
def test_how_bodies_are_drawn(scene):
    hints = load_family(str(KINDS / f"{scene}.toml")).forms[""].figure
    found = sorted((disc.centre, disc.body) for disc in hints.discs)
    assert {"plates": hints.plates, "discs": found, "lines": hints.lines} == DRAWN[scene]


def test_a_slot_in_a_plate_is_a_groove():
    assert load_family(str(KINDS / "moving_frame_disc.toml")).forms[""].figure.grooves == (("A", "B"),)


def test_what_the_file_says_of_a_body_stands(tmp_path):
    path = tmp_path / "own.toml"
    text = (KINDS / "watt_six_bar.toml").read_text(encoding="utf-8")
    path.write_text(text + '\n[figure]\nlines = [["C", "D"], ["D", "B"]]\n', encoding="utf-8")
    hints = load_family(str(path)).forms[""].figure
    assert hints.plates == ()
    assert hints.lines == (("C", "D"), ("D", "B"))


def test_a_scene_with_parameters_needs_no_title(tmp_path, capsys):
    text = (KINDS / "oblique_guides.toml").read_text(encoding="utf-8")
    parameter = 'v_A = { unit = "in/s", from = 5, to = 15, step = 1 }'
    text = text.replace("[points]", f"[parameters]\n{parameter}\n\n[points]").replace("v = 10", 'v = "v_A"')
    path = tmp_path / "guides.toml"
    path.write_text(text, encoding="utf-8")
    assert main(["check", str(path), "--seeds", "20"]) == 0
    assert "guides: ok" in capsys.readouterr().out


def test_a_law_of_time_is_told_as_it_is_written(tmp_path, capsys):
    path = tmp_path / "scene.toml"
    path.write_text(
        """
length_unit = "dm"
ask = ["a_M.x"]
[parameters]
t = { unit = "s", values = [2] }
[laws]
time = "t"
s = "3 * t^2"
phi = "t^3"
[points]
O = { coordinates = { x = 0, y = 0 } }
Q = { coordinates = { x = 20, y = 0 } }
M = { coordinates = { x = "s", y = 0 } }
[bodies]
disc = ["O", "Q"]
[[joints]]
pivot = { point = "O" }
[[joints]]
slot = { point = "M", body = "disc", along = ["O", "Q"] }
[[drivers]]
rotation = { body = "disc", omega = "phi_dot", epsilon = "phi_ddot" }
[[drivers]]
relative_travel = { point = "M", body = "disc", along = ["O", "Q"], v = "s_dot", a = "s_ddot" }
""",
        encoding="utf-8",
    )
    assert main(["show", str(path)]) == 0
    given = " ".join(capsys.readouterr().out.replace("\N{NO-BREAK SPACE}", " ").partition("Determine")[0].split())
    assert "t = 2 s" in given
    for datum in ("x_M = s = 3 t^2 dm", "φ = t^3 rad"):
        assert datum in given, given
    for rate in ("ω_disc", "α_disc", "v_rel", "a_rel"):  # to be found from the laws
        assert rate not in given, given


def test_the_angle_of_two_links_is_told(capsys):
    out = _shown(capsys, str(KINDS.parent / "books" / "meshchersky_18_20.toml"))
    assert "Given: AB = 60 cm, OA = 12 cm, ∠OAC = 90°," in out


def test_a_time_that_is_a_fraction_is_told_as_one(capsys):
    out = _shown(capsys, str(KINDS.parent / "books" / "meshchersky_23_14.toml"), "--explain")
    assert "Given: t = 5/3 s," in out
    assert "1.666666666667" not in out


DIFFERENTIAL_DRUM = """\
length_unit = "cm"
ask = ["v_W", "omega_pulley"]
points.O = { coordinates = { x = 0, y = 0 } }
points.W = { coordinates = { x = 3, y = -100 } }
bodies.drum = ["O"]
bodies.pulley = ["W"]
joints = [{ pivot = { point = "O" } }, { guide = { point = "W", angle = 90 } }, { rope = { path = [
    { point = "O", radius = 12, side = "right", body = "drum" },
    { point = "W", radius = 15, side = "right", body = "pulley" },
] } }, { rope = { path = [
    { point = "O", radius = 18, side = "left", body = "drum" },
    { point = "W", radius = 15, side = "left", body = "pulley" },
] } }]
drivers = [{ rotation = { body = "drum", omega = 2 } }]
"""


def test_two_radii_of_a_body_are_given_and_have_the_same_names_in_the_solution(tmp_path, capsys):
    (tmp_path / "drum.toml").write_text(DIFFERENTIAL_DRUM, "utf-8")
    out = _shown(capsys, str(tmp_path / "drum.toml"), "--explain", "--lang", "en")
    assert "Given: r_drum = 12 cm, r_2 drum = 18 cm, r_pulley = 15 cm," in out
    assert "v_K = ω_drum · r_drum = 2 · 12 = 24 cm/s" in out
    assert "v_N = ω_drum · r_2 drum = 2 · 18 = 36 cm/s" in out
    assert "v_W = 6 cm/s" in out  # one cord gives 24, the other takes 36: (36 - 24) / 2


@pytest.mark.parametrize(
    ("scene", "language", "line"),
    [
        ("oblique_guides", "en", "ω_AB = v_A / AP = 10 / 11.88"),
        ("oblique_guides", "ru", "a_B cos 55° = −a_A cos 50° + a^n_BA a_B = (−3 · cos 50° + 14,18) / cos 55°"),
        ("bead_on_ring_moving", "en", "v_M ξ = v_C − v_rel M cos 30° = 1 − 0.6 · cos 30°"),
        ("bead_on_ring_moving", "en", "a_rel M = √((a_rel M)_n^2 + (a_rel M)_t^2)"),
        ("geneva", "en", "∠OCA = arctan(AO sin 20° / (100 − AO cos 20°))"),
        ("incline_blocks_rope", "en", "r_K · θ_AK − x_A cos(θ_AK + 31.70°)"),
        ("frame_on_cart", "ru", "_rod = −ε_rod/cart = −0,5 рад/с²"),
        ("excavator", "en", "_HG = −v_HG = −0.05 m/s"),
    ],
)
def test_the_solution_has_a_given_rate_by_its_letter(scene, language, line, capsys):
    assert line in _shown(capsys, str(KINDS / f"{scene}.toml"), "--explain", "--lang", language)


def test_what_is_given_on_a_circle_is_the_tangential_acceleration(capsys):
    out = _shown(capsys, str(KINDS / "bead_on_ring_moving.toml"))
    assert "v_rel M = 0.6 m/s, (a_rel M)_t = 0.2 m/s²" in out


# What a student of the sheet alone needs: guides, the radius of a wheel, where a pulley stands, how a vector points.
@pytest.mark.parametrize(
    ("scene", "language", "told"),
    [
        ("oblique_guides", "en", "The guide of A makes an angle of 75° with the horizontal. The guide of B makes an"),
        ("oblique_guides", "ru", "Направляющая точки B составляет с горизонталью угол 30°."),
        ("plate_two_directions", "en", "v_A = 20 cm/s, ∠(v_A, x) = 110°."),
        ("two_wheels_rod", "en", "r_w1 = 20 cm, r_w2 = 15 cm,"),
        ("incline_blocks_rope", "ru", "r_K = 0,2 м, x_A = −2 м, y_A = −1 м, x_K = 0 м, y_K = 0 м,"),
        ("free_plate_centre", "ru", "v_A = 20 см/с, a_A = 30 см/с², ∠(v_A, x) = 110°, ∠(a_A, x) = 10°, ω_AB = 2 рад/с"),
    ],
)
def test_the_sheet_tells_what_answers_depend_on(scene, language, told, capsys):
    assert told in _shown(capsys, str(KINDS / f"{scene}.toml"), "--lang", language)


def test_a_guide_by_a_parameter_and_a_length_by_a_formula(tmp_path, capsys):
    text = (KINDS / "oblique_guides.toml").read_text(encoding="utf-8")
    parameters = '[parameters]\nbeta = { unit = "deg", values = [75] }\nL = { unit = "in", values = [20] }\n'
    text = text.replace("[points]", f"{parameters}\n[points]").replace("angle = 75 }\n[[", 'angle = "beta" }\n[[')
    path = tmp_path / "guides.toml"
    path.write_text(text.replace("distance = 20", 'distance = "L"'), encoding="utf-8")
    out = _shown(capsys, str(path))
    assert "The guide of A makes an angle of β with the horizontal." in out
    assert "AB = L, L = 20 in" in out or "L = 20 in, β = 75°, AB = L," in out
    path.write_text(text.replace("distance = 20", 'distance = "2 * L"'), encoding="utf-8")
    assert "AB = 40 in" in _shown(capsys, str(path))


def test_the_figure_marks_the_angle_of_an_inclined_guide():
    variant = one_variant(str(KINDS / "oblique_guides.toml"))
    drawing = variantgen.picture(variant).drawing
    arcs = [math.degrees(abs(line.sweep)) for line in drawing.lines if isinstance(line, Arc)]
    assert sorted(round(arc, 6) for arc in arcs if 0 < arc < 90) == [30, 75]


def test_a_number_of_the_data_that_is_asked_is_a_remark():
    report = check_family(str(KINDS / "bead_on_ring_moving.toml"))
    assert report.remarks == ["ask: v_rel_M is a number of the data; what is asked should have to be found"]
    assert not check_family(str(KINDS / "geneva.toml")).remarks
