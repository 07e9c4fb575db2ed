"""Values of a whole turn of the crank beside closed formulas."""

import time
from collections.abc import Mapping
from pathlib import Path
from tempfile import TemporaryDirectory

import mpmath
import numpy as np
import pytest

from variantgen.errors import InputError
from variantgen.families.asking import read_ask
from variantgen.families.reading.load import read_family
from variantgen.outputs.single.explanation import explain
from variantgen.single import one_variant
from variantgen.variants.only_variant import only_variant
from variantgen.variants.variant import Variant, solve_variants

SLIDER = """
length_unit = "m"
ask = ["v_B"]
joints = [{{ pivot = {{ point = "O" }} }}, {{ guide = {{ point = "B" }} }}]
drivers = [{{ rotation = {{ body = "OA", omega = {omega} }} }}]
[points]
O = {{ coordinates = {{ x = 0, y = 0 }} }}
{points}
[bodies]
OA = ["O", "A"]
AB = ["A", "B"]
"""
CRANK_FIRST = """
A = { polar = { origin = "O", distance = 0.3, angle = 40 } }
E = { coordinates = { x = 0, y = 0.1 } }
B = { line_circle = { through = "E", centre = "A", distance = 1.0 } }
"""
ROCKER = """
length_unit = "cm"
ask = ["omega_BC"]
joints = [{ pivot = { point = "O" } }, { pivot = { point = "C" } }]
drivers = [{ rotation = { body = "OA", omega = 5 } }]
[points]
O = { coordinates = { x = 0, y = 0 } }
C = { coordinates = { x = 70, y = 0 } }
A = { polar = { origin = "O", distance = 30, angle = 50 } }
B = { circle_circle = { first = "A", first_distance = 85, second = "C", second_distance = 66, side = "left" } }
[bodies]
OA = ["O", "A"]
AB = ["A", "B"]
BC = ["B", "C"]
"""
LEVER = """
length_unit = "cm"
ask = ["omega_CB"]
joints = [
    { pivot = { point = "O" } }, { pivot = { point = "C" } },
    { slot = { point = "A", body = "CB", along = ["C", "B"] } },
]
drivers = [{ rotation = { body = "OA", omega = 5 } }]
[points]
O = { coordinates = { x = 0, y = 0 } }
C = { coordinates = { x = 0, y = -50 } }
A = { polar = { origin = "O", distance = 20, angle = 75 } }
B = { polar = { origin = "C", distance = 90, towards = "A" } }
[bodies]
OA = ["O", "A"]
CB = ["C", "B"]
"""


def variant_of(text: str) -> Variant:
    """The variant of a scene without parameters."""
    with TemporaryDirectory() as folder:
        path = Path(folder, "scene.toml")
        path.write_text(text, "utf-8")
        family = read_family(path)
    return only_variant(family, family.forms[""], "scene.toml")


def values(text: str, *names: str) -> Mapping[str, float]:
    """The values of quantities of a scene in SI."""
    variant = variant_of(text)
    asked = read_ask(variant.form, names)
    motion = solve_variants([variant], 2)
    return {quantity.name: float(quantity.value(motion)[0]) for quantity in asked}


def slider_place(angle: mpmath.mpf) -> mpmath.mpf:
    """The place of the slider on a guide 0.1 m above the pivot: crank 0.3 m, rod 1 m."""
    r, rod, e = mpmath.mpf("0.3"), mpmath.mpf(1), mpmath.mpf("0.1")
    return r * mpmath.cos(angle) + mpmath.sqrt(rod**2 - (r * mpmath.sin(angle) - e) ** 2)


@pytest.mark.parametrize("omega", [2.0, -2.0])
def test_largest_velocity_of_an_offset_slider(omega: float) -> None:
    found = values(SLIDER.format(omega=omega, points=CRANK_FIRST), "max_v_B", "phi_max_v_B", "min_x_B", "phi_min_x_B")
    with mpmath.workdps(30):
        roots = [mpmath.findroot(lambda a: mpmath.diff(slider_place, a, 2), near) for near in (1.3, -1.3)]
        speeds = [abs(2 * mpmath.diff(slider_place, root)) for root in roots]
        best = roots[speeds.index(max(speeds))]
        turned = mpmath.sign(omega) * (best - mpmath.radians(40))
        low = mpmath.pi + mpmath.asin(mpmath.mpf("0.1") / mpmath.mpf("0.7"))  # rod over the crank, 0.1 m up
        to_low = mpmath.sign(omega) * (low - mpmath.radians(40))
        assert found["max_v_B"] == pytest.approx(float(max(speeds)), rel=1e-12)
        assert found["phi_max_v_B"] == pytest.approx(float(turned % (2 * mpmath.pi)), abs=1e-9)
        assert found["min_x_B"] == pytest.approx(float(mpmath.sqrt(mpmath.mpf("0.48"))), rel=1e-12)
        assert found["phi_min_x_B"] == pytest.approx(float(to_low % (2 * mpmath.pi)), abs=1e-9)


def test_stroke_times_and_mean_velocity_of_an_offset_slider() -> None:
    found = values(SLIDER.format(omega=2, points=CRANK_FIRST), "stroke_B", "time_ratio_B", "mean_v_B")
    far, near = 1.3, 0.7
    stroke = np.sqrt(far**2 - 0.01) - np.sqrt(near**2 - 0.01)
    theta = np.arcsin(0.1 / near) - np.arcsin(0.1 / far)
    assert found["stroke_B"] == pytest.approx(stroke, rel=1e-12)
    assert found["time_ratio_B"] == pytest.approx((np.pi + theta) / (np.pi - theta), rel=1e-12)
    assert found["mean_v_B"] == pytest.approx(2 * stroke / (2 * np.pi / 2), rel=1e-12)


def test_the_solution_works_out_limit_positions_and_says_what_is_searched_for() -> None:
    variant = variant_of(SLIDER.format(omega=2, points=CRANK_FIRST))
    asked = ["stroke_B", "mean_v_B", "max_v_B"]
    english, russian = (" ".join(str(explain(variant, language, ask=asked)).split()) for language in ("en", "ru"))
    # 1.3^2 - 0.1^2 = 1.68, 0.7^2 - 0.1^2 = 0.48; twice the stroke in the time pi of a turn
    for line in ("OB_1 = AB + OA = 1 + 0.3 = 1.3 m", "OB_2 = AB − OA = 1 − 0.3 = 0.7 m", "= 0.6033 m", "= 0.3841 m/s"):
        assert line in english
        assert line.replace(".", ",").replace(" m/s", " м/с").replace(" m", " м") in russian
    assert "solved for a series of positions" in english
    assert "для ряда положений" in russian


def test_limit_positions_of_a_rocker() -> None:
    found = values(ROCKER, "swing_BC", "time_ratio_BC", "max_angle_A.B.C", "mean_omega_BC", "stroke_B")
    corner = [np.arccos((70**2 + 66**2 - d**2) / (2 * 70 * 66)) for d in (115, 55)]
    at_pivot = [np.arccos((70**2 + d**2 - 66**2) / (2 * 70 * d)) for d in (115, 55)]
    theta = at_pivot[1] - at_pivot[0]
    assert found["swing_BC"] == pytest.approx(corner[0] - corner[1], rel=1e-12)
    assert found["time_ratio_BC"] == pytest.approx((np.pi + theta) / (np.pi - theta), rel=1e-12)
    assert found["max_angle_A.B.C"] == pytest.approx(np.arccos((85**2 + 66**2 - 100**2) / (2 * 85 * 66)), rel=1e-12)
    assert found["mean_omega_BC"] == pytest.approx(2 * (corner[0] - corner[1]) / (2 * np.pi / 5), rel=1e-10)
    said = " ".join(str(explain(variant_of(ROCKER), "en", ask=["mean_v_B", "stroke_B"])).split())
    mean = 2 * 66 * (corner[0] - corner[1]) / (2 * np.pi / 5)  # its way is the arc, there and back
    assert f"/ 180° = 66 · {np.degrees(corner[0] - corner[1]):.2f}° · 5 / 180°" in said
    assert f"v_B mean = {mean:.4g} cm/s" in said
    chord = 2 * 0.66 * np.sin((corner[0] - corner[1]) / 2)
    assert found["stroke_B"] == pytest.approx(chord, rel=1e-12)  # its path is an arc


def test_the_pin_of_a_rocker_and_the_rocker_have_one_ratio_of_times() -> None:
    found = values(ROCKER, "time_ratio_B", "time_ratio_BC")
    far, near = 85 + 30, 85 - 30
    corners = [np.arccos((70**2 + end**2 - 66**2) / (2 * 70 * end)) for end in (far, near)]
    theta = corners[1] - corners[0]
    assert [*found.values()] == pytest.approx([(np.pi + abs(theta)) / (np.pi - abs(theta))] * 2, rel=1e-11)
    said = str(explain(variant_of(ROCKER), "en", ask=["time_ratio_B"]))
    assert "180° + θ" in said


def test_an_extreme_at_a_kink_and_quantities_that_do_not_change() -> None:
    found = values(SLIDER.format(omega=2, points=CRANK_FIRST), "max_angle_O.A.B", "max_y_B")
    assert found["max_angle_O.A.B"] == pytest.approx(np.pi, abs=1e-9)  # stretched
    assert found["max_y_B"] == np.inf  # the slider keeps its height


def driven_rate(angle: mpmath.mpf) -> mpmath.mpf:
    """The angular velocity of the driven crank of a double crank, that of the driving one being 1 rad/s."""
    a, b, c, d = map(mpmath.mpf, (50, 60, 55, 20))

    def direction(at: mpmath.mpf) -> mpmath.mpf:
        pin = a * mpmath.expj(at)
        line = d - pin
        corner = mpmath.acos((b**2 + abs(line) ** 2 - c**2) / (2 * b * abs(line)))
        return mpmath.arg(pin + b * mpmath.expj(mpmath.arg(line) + corner) - d)

    return mpmath.diff(direction, angle)


def test_a_double_crank() -> None:
    text = ROCKER
    for old, new in (("x = 70", "x = 20"), ("= 30, angle", "= 50, angle"), ("= 85", "= 60"), ("= 66", "= 55")):
        text = text.replace(old, new)
    found = values(text, "max_omega_BC", "min_omega_BC", "swing_BC")
    with mpmath.workdps(30):
        way = [driven_rate(mpmath.radians(5 * k)) for k in range(72)]
        for name, extreme in (("max_omega_BC", max(way)), ("min_omega_BC", min(way))):
            near = mpmath.radians(5 * way.index(extreme))
            root = mpmath.findroot(lambda at: mpmath.diff(driven_rate, at), near)
            assert found[name] == pytest.approx(5 * float(driven_rate(root)), rel=1e-10)
    assert found["swing_BC"] == np.inf  # it goes round


def test_a_lever_on_a_crank() -> None:
    found = values(LEVER, "swing_CB", "time_ratio_CB", "max_omega_CB", "phi_max_omega_CB")
    half = np.arcsin(20 / 50)
    assert found["swing_CB"] == pytest.approx(2 * half, rel=1e-12)
    assert found["time_ratio_CB"] == pytest.approx((np.pi + 2 * half) / (np.pi - 2 * half), rel=1e-12)
    said = " ".join(str(explain(variant_of(LEVER), "ru", ask=["mean_v_B"])).split())
    assert f"v_B ср = {2 * 90 * 2 * half / (2 * np.pi / 5):.4g} см/с".replace(".", ",") in said
    # fastest where the pin is nearest to the axis of the lever: omega r / (d - r)
    assert found["max_omega_CB"] == pytest.approx(5 * 20 / (50 - 20), rel=1e-12)
    assert found["phi_max_omega_CB"] == pytest.approx(np.radians(270 - 75), abs=1e-9)


def test_positions_that_do_not_follow_the_crank_are_found_by_continuation() -> None:
    """The slider is placed first, and the crank pin from it: the same mechanism, described the other way."""
    names = ("max_v_B", "phi_max_v_B", "stroke_B", "mean_v_B")
    place = float(slider_place(mpmath.radians(40)))
    backwards = f"""
B = {{ coordinates = {{ x = {place!r}, y = 0.1 }} }}
A = {{ circle_circle = {{ first = "O", first_distance = 0.3, second = "B", second_distance = 1.0, side = "left" }} }}
"""
    right = values(SLIDER.format(omega=2, points=CRANK_FIRST), *names)
    found = values(SLIDER.format(omega=2, points=backwards), *names)
    assert found == pytest.approx(right, rel=1e-9)


def test_a_crank_that_cannot_make_the_turn_has_no_extremes() -> None:
    short = ROCKER.replace("first_distance = 85", "first_distance = 55")  # 30 + 70 > 55 + 66 does not hold for 30
    longer = short.replace("distance = 30, angle = 50", "distance = 60, angle = 50")
    assert values(longer, "max_omega_BC", "swing_BC") == {"max_omega_BC": np.inf, "swing_BC": np.inf}


@pytest.mark.parametrize(
    ("text", "name", "said"),
    [
        (SLIDER.format(omega="2, epsilon = 1", points=CRANK_FIRST), "max_a_B", "constant angular velocity"),
        (SLIDER.format(omega=2, points=CRANK_FIRST), "max_a_B.t", "write max_"),
        (SLIDER.format(omega=2, points=CRANK_FIRST), "stroke_A", "A of the crank OA goes round"),
        (SLIDER.format(omega=2, points=CRANK_FIRST), "phi_max_v_A", "so v_A is the same all along"),
        (SLIDER.replace("rotation = {{ body = \"OA\", omega = {omega} }}", "travel = {{ point = \"B\", v = 1 }}")
         .format(points=CRANK_FIRST), "stroke_B", "rotates a body"),
    ],
)  # fmt: skip
def test_what_has_no_turn_says_so(text: str, name: str, said: str) -> None:
    with pytest.raises(InputError, match=said):
        values(text, name)


def test_a_turn_is_cheap() -> None:
    """Less than 5 ms for each variant of a batch, all four values together."""
    variant = variant_of(SLIDER.format(omega=2, points=CRANK_FIRST))
    asked = read_ask(variant.form, ["max_v_B", "phi_max_v_B", "stroke_B", "mean_v_B"])
    motion = solve_variants([variant] * 100, 2)
    start = time.process_time()
    for quantity in asked:
        quantity.value(motion)
    assert time.process_time() - start < 100 * 0.005


def test_the_distance_of_the_guide_is_not_named_after_a_link_as_long() -> None:
    variant = one_variant("limit_positions", form="slider", fixed={"OA": 24, "e": 24, "AB": 78})
    text = " ".join(str(explain(variant, "en")).split())
    # 78 + 24 and 78 - 24
    assert "passes O at the distance e." in text
    assert "s_B = √(OB_1^2 − e^2) − √(OB_2^2 − e^2) = √(102^2 − 24^2) − √(54^2 − 24^2) = 50.76 cm" in text
