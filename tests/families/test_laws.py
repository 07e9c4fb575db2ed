"""Motion by functions of time: symbolic derivatives, dimensions, messages."""

from __future__ import annotations

import math
from pathlib import Path

import mpmath
import pytest
from hypothesis import given
from hypothesis import strategies as st

from tests.scene_files import scene_file, solved_values
from variantgen.cli import main
from variantgen.errors import InputError
from variantgen.families.parameters.expressions import parse
from variantgen.families.reading.load import read_family
from variantgen.mechanism.solving.solve import solve

SMOOTH = [
    "3 * t**2 - t / 4 + 2",
    "R * cos(k * t) * sin(2 * k * t)",
    "R * t / (1 + t**2)",
    "sqrt(R**2 + (k * t)**4)",
    "tan(k * t) - atan(t**3)",
    "asin(t / 3) * acos(k * t / 9)",
    "-(t - 1)**3 * R",
    "R",
    "R * (1 - exp(-k * t)) + ln(1 + t**2)",
    "exp(-t**2) * sin(3 * t)",
]
BY_MPMATH = {
    "sin": mpmath.sin, "cos": mpmath.cos, "tan": mpmath.tan, "asin": mpmath.asin, "acos": mpmath.acos,
    "atan": mpmath.atan, "sqrt": mpmath.sqrt, "exp": mpmath.exp, "ln": mpmath.log,
}  # fmt: skip


@pytest.mark.parametrize("text", SMOOTH)
@given(t=st.floats(0.1, 1.2), k=st.floats(0.2, 1.2))
def test_first_and_second_derivative(text: str, t: float, k: float) -> None:
    law = parse(text)
    values = {"t": t, "R": 0.7, "k": k}
    with mpmath.workdps(40):

        def function(x: mpmath.mpf) -> mpmath.mpf:
            return eval(text, {}, {**BY_MPMATH, "t": x, "R": mpmath.mpf(0.7), "k": mpmath.mpf(k)})

        expected = [float(mpmath.diff(function, t, n)) for n in (1, 2)]
    first = law.derivative("t")
    assert float(first.value(values)) == pytest.approx(expected[0], rel=1e-9, abs=1e-9)
    assert float(first.derivative("t").value(values)) == pytest.approx(expected[1], rel=1e-8, abs=1e-8)


@pytest.mark.parametrize("text", ["abs(t)", "min(t, 1)", "max(1, t)", "atan2(t, 1)"])
def test_functions_without_a_derivative_are_refused(text: str) -> None:
    with pytest.raises(InputError, match="no derivative here"):
        parse(text).derivative("t")


@pytest.mark.parametrize("text", ["t * (1e11**8)**8", "t**2 * (1e11**8)**4"])
def test_numbers_beyond_measure_are_refused(text: str) -> None:
    with pytest.raises(InputError, match="number this large"):
        parse(text).derivative("t")


def test_a_law_of_a_hundred_equal_factors_stays_short() -> None:
    rate = parse("*".join("t" * 100)).derivative("t")
    assert float(rate.value({"t": 1.0})) == 100.0


def test_constants_under_such_functions_are_fine() -> None:
    assert float(parse("abs(R) * t").derivative("t").value({"R": -2.0, "t": 1.0})) == 2.0


SCENE = """
length_unit = "m"
[parameters]
t = { unit = "s", values = [2] }
k = { unit = "rad/s", values = [0.5] }
b = { unit = "m", values = [0.3] }
[laws]
time = "t"
phi = "k * t**2 / (1 + t / t)"
x_A = "b * cos(k * t)"
[points]
A = { coordinates = { x = "x_A", y = 0 } }
B = { polar = { origin = "A", distance = "b", angle = "phi" } }
[bodies]
AB = ["A", "B"]
[[drivers]]
vector_motion = { point = "A", v = "x_A_dot", a = "x_A_ddot" }
[[drivers]]
rotation = { body = "AB", omega = "phi_dot", epsilon = "phi_ddot" }
"""


def read(folder: Path, content: str) -> object:
    path = scene_file(folder, content)
    return read_family(path)


def test_a_scene_driven_by_laws(tmp_path: Path) -> None:
    scene = SCENE.replace("k * t**2 / (1 + t / t)", "k * t")
    form = read(tmp_path, scene).forms[""]  # type: ignore[attr-defined]
    motion = solve(form.scene(form.values({"t": 2.0, "k": 0.5, "b": 0.3})), 2)
    with mpmath.workdps(30):
        point = lambda t: 0.3 * mpmath.cos(0.5 * t) + 0.3 * mpmath.expj(0.5 * t)  # noqa: E731
        assert motion.z["B"][0] == pytest.approx(complex(point(2)))
        assert motion.v["B"][0] == pytest.approx(complex(mpmath.diff(point, 2)))
        assert motion.a["B"][0] == pytest.approx(complex(mpmath.diff(point, 2, 2)))


@pytest.mark.parametrize(
    ("old", "new", "said"),
    [
        ('time = "t"', 'time = "k"', ["laws.time", "parameter that is a time", "k"]),
        ('time = "t"\n', "", ["laws.time", "missing"]),
        ('phi = "k * t**2 / (1 + t / t)"', 'phi = "abs(k * t)"', ["laws.phi", "no derivative", "smooth"]),
        ('phi = "k * t**2 / (1 + t / t)"', 'phi = "k * t^t"', ["laws.phi", "a power that is no whole number", "t^t"]),
        ('phi = "k * t**2 / (1 + t / t)"', "phi = 3", ["laws.phi", "expression in quotes", "3"]),
        ('phi = "k * t**2 / (1 + t / t)"', 'phi = "k * tt"', ["laws.phi", "unknown name", "tt"]),
        ('x_A = "b', 'b = "b', ["laws.b", "the name is taken"]),
        # k t^2 is no angle but an angle times a time.
        ("b * cos(k * t)", "b * cos(k)", ["adds or compares", "angular velocity"]),
    ],
)
def test_wrong_laws(old: str, new: str, said: list[str], tmp_path: Path) -> None:
    assert old in SCENE
    with pytest.raises(InputError) as caught:
        read(tmp_path, SCENE.replace(old, new))
    assert all(part in str(caught.value) for part in said), str(caught.value)
    assert len(caught.value.problems) == 1


PLAIN = """
length_unit = "cm"
ask = ["v_A.x", "a_A.x", "omega_AB", "epsilon_AB"]
[parameters]
t = { unit = "s", values = ["5/3"] }
[laws]
time = "t"
s = "t^3 + 2 * t"
phi = "sin(pi * t)"
[points]
A = { coordinates = { x = "s", y = 0 } }
B = { polar = { origin = "A", distance = 20, angle = "phi" } }
[bodies]
AB = ["A", "B"]
[[drivers]]
vector_motion = { point = "A", v = "s_dot", a = "s_ddot" }
[[drivers]]
rotation = { body = "AB", omega = "phi_dot", epsilon = "phi_ddot" }
"""


@pytest.mark.parametrize(
    ("law", "factor"),
    [
        ('s = "t^3 + 2 * t"', 1.0),
        ('s = { law = "t^3 + 2 * t", unit = "in" }', 2.54),
        ('s = { law = "t^3 + 2 * t", unit = "ft" }', 30.48),
    ],
)
def test_laws_of_plain_numbers(law: str, factor: float, tmp_path: Path, capsys: pytest.CaptureFixture[str]) -> None:
    path = scene_file(tmp_path, PLAIN.replace('s = "t^3 + 2 * t"', law))
    found = solved_values(path, capsys)
    t = 5 / 3
    assert found["v_A.x"] == pytest.approx(factor * (3 * t**2 + 2), rel=1e-7)
    assert found["a_A.x"] == pytest.approx(factor * 6 * t, rel=1e-7)
    assert found["omega_AB"] == pytest.approx(math.pi * math.cos(math.pi * t), rel=1e-7)
    assert found["epsilon_AB"] == pytest.approx(-(math.pi**2) * math.sin(math.pi * t), rel=1e-7)
    assert main(["solve", str(path), "--explain"]) == 0
    assert "Answer" in capsys.readouterr().out


@pytest.mark.parametrize(
    ("old", "new", "said"),
    [
        ("= 20, angle", '= "3 * s", angle', ["laws.s", "without a measure", 'unit = "cm"']),
        ('s = "t^3 + 2 * t"', 's = { law = "t", unit = "rpm" }', ["laws.s.unit", "unit of length or angle", "rpm"]),
        ('s = "t^3 + 2 * t"', 's = { law = "t", unit = "el" }', ["laws.s.unit", "unknown unit", "el"]),
        ('s = "t^3 + 2 * t"', 's = { law = "t" }', ["laws.s.unit", "missing"]),
    ],
)
def test_a_law_without_a_measure(old: str, new: str, said: list[str], tmp_path: Path) -> None:
    text = PLAIN.replace(old, new)
    if "3 * s" in new:
        text = text.replace('x = "s"', "x = 0").replace('v = "s_dot", a = "s_ddot"', "v = 1")
    with pytest.raises(InputError) as caught:
        read(tmp_path, text)
    assert all(part in str(caught.value) for part in said), str(caught.value)


LADDER = (Path(__file__).parents[1] / "kind_scenes" / "ladder_by_law.toml").read_text("utf-8")


@pytest.mark.parametrize(
    ("scene", "said"),
    [
        # s = 1 + 0.5 t^2 at t = 1.2: the derivatives are 1.2 and 1.
        (LADDER.replace('"s_dot"', '"-s_dot"'), ["drivers[1].v", "expected 1.2 m/s", "is -1.2", "-s_dot", "laws.s"]),
        (LADDER.replace('"s_dot"', '"2*s_dot"'), ["drivers[1].v", "expected 1.2 m/s", "is 2.4", "2*s_dot", "laws.s"]),
        (LADDER.replace('"s_ddot"', '"-s_ddot"'), ["drivers[1].a", "expected 1 m/s^2", "is -1", "-s_ddot"]),
        # pi cos(5 pi / 3) = pi / 2
        (
            PLAIN.replace('"phi_dot"', '"-phi_dot"'),
            ["drivers[2].omega", "expected 1.571 rad/s", "is -1.571", "laws.phi"],
        ),
    ],
)
def test_a_driver_that_contradicts_its_law(scene: str, said: list[str], tmp_path: Path) -> None:
    with pytest.raises(InputError) as caught:
        read(tmp_path, scene)
    assert all(part in str(caught.value) for part in said), str(caught.value)


BLOCK = """
length_unit = "ft"
ask = ["v_B", "a_B"]
[parameters]
t = { unit = "s", values = [10] }
[laws]
time = "t"
s = { law = "t^3 - 6*t^2 - 15*t + 7", unit = "ft" }
[points]
B = { coordinates = { x = "s", y = 0 } }
[bodies]
block = ["B"]
[[joints]]
guide = { point = "B" }
[[drivers]]
travel = { point = "B", v = "s_dot" }
"""


def test_an_acceleration_that_is_left_out_follows_from_the_law(
    tmp_path: Path, capsys: pytest.CaptureFixture[str]
) -> None:
    scene = tmp_path / "block.toml"
    scene.write_text(BLOCK)
    assert main(["solve", str(scene)]) == 0
    said = capsys.readouterr().out
    # s' = 3 t^2 - 12 t - 15, s'' = 6 t - 12, at 10 s
    assert "v_B = 165 ft/s\n" in said and "a_B = 48 ft/s^2\n" in said


MOWER = """
length_unit = "mm"
ask = ["v_M", "a_M", "rho_M"]
[parameters]
t = { unit = "s", values = [2] }
[laws]
time = "t"
y = "x^2 / 160 + 3"
x = "50 * t"
[points]
M = { coordinates = { x = "x", y = "y" } }
[[drivers]]
travel = { point = "M", v = "x_dot", a = "x_ddot" }
[[drivers]]
travel = { point = "M", v = "y_dot", a = "y_ddot", angle = 90 }
"""


def test_a_law_names_another_one(tmp_path: Path, capsys: pytest.CaptureFixture[str]) -> None:
    """On y = x^2 / 160: y' = x x' / 80 = 62.5, y'' = x'^2 / 80, rho = (1 + (x / 80)^2)^1.5 * 80 at x = 100."""
    path = scene_file(tmp_path, MOWER)
    expected = {"v_M": math.hypot(50, 62.5), "a_M": 2500 / 80, "rho_M": 80 * (1 + (100 / 80) ** 2) ** 1.5}
    assert solved_values(path, capsys) == pytest.approx(expected)
    for unit, factor in (("cm", 10), ("mm", 1)):
        beside = f'{{ law = "x^2 / 160 + 3", unit = "{unit}" }}'
        path.write_text(MOWER.replace('"x^2 / 160 + 3"', beside), encoding="utf-8")
        assert solved_values(path, capsys)["a_M"] == pytest.approx(factor * 2500 / 80)
    assert main(["show", str(path), "--explain"]) == 0
    out = capsys.readouterr().out.replace("\N{NO-BREAK SPACE}", " ")
    assert "y_M = y = (x^2 / 160 + 3) mm" in out
    assert "125 t / 4 = 125 · 2 / 4 = 62.5 mm/s" in out
    path.write_text(MOWER.replace("50 * t", "50 * t + y"), encoding="utf-8")
    assert main(["solve", str(path)]) == 2  # in a circle
    assert "unknown name" in capsys.readouterr().err


SPINDLE = """
length_unit = "mm"
ask = ["omega_OA", "epsilon_OA", "a_A", "x_A"]
[parameters]
t = { unit = "s", values = [0.5] }
r = { unit = "mm", values = [200] }
[laws]
time = "t"
phi = "10 * (t + 0.5 * (exp(-2 * t) - 1))"
[points]
O = { coordinates = { x = 0, y = 0 } }
A = { polar = { origin = "O", distance = "r", angle = "phi" } }
[bodies]
OA = ["O", "A"]
[[joints]]
pivot = { point = "O" }
[[drivers]]
rotation = { body = "OA", omega = "phi_dot" }
"""


@pytest.mark.parametrize("language", ["en", "ru"])
def test_a_law_with_an_exponential_function(language: str, tmp_path: Path, capsys: pytest.CaptureFixture[str]) -> None:
    """A spindle that comes up to 10 rad/s: omega = 10 (1 - e^(-2t)), epsilon = 20 e^(-2t)."""
    path = scene_file(tmp_path, SPINDLE)
    omega, epsilon = 10 * (1 - math.exp(-1)), 20 * math.exp(-1)
    phi = 10 * (0.5 + 0.5 * (math.exp(-1) - 1))
    assert solved_values(path, capsys) == pytest.approx(
        {
            "omega_OA": omega,
            "epsilon_OA": epsilon,
            "a_A": 200 * math.hypot(omega**2, epsilon),
            "x_A": 200 * math.cos(phi),
        }
    )
    assert main(["show", str(path), "--explain", "--lang", language]) == 0
    out = capsys.readouterr().out.replace("\N{NO-BREAK SPACE}", " ")
    assert "= 10 · (1 − exp(−2 t)) = 10 · (1 − exp(−2 · 0" in out
    assert main(["solve", str(path), "--explain", "--method", "coordinates"]) == 0


def test_a_coordinate_that_a_law_tells_is_not_told_as_a_number(
    tmp_path: Path, capsys: pytest.CaptureFixture[str]
) -> None:
    path = scene_file(tmp_path, LADDER.replace('ask = ["v_B"', 'ask = ["x_A", "v_B"'))
    assert main(["show", str(path)]) == 0, capsys.readouterr().err
    given, _, _ = capsys.readouterr().out.partition("Key")
    assert "y_A = 0\N{NO-BREAK SPACE}m" in given
    assert "x_A = 1" not in given


def test_a_rigid_body_of_changing_length_is_refused(tmp_path: Path, capsys: pytest.CaptureFixture[str]) -> None:
    path = tmp_path / "scene.toml"
    text = SPINDLE.replace('distance = "r"', 'distance = "s"').replace("[laws]", '[laws]\ns = "100 + 50 * t"')
    path.write_text(text, encoding="utf-8")
    assert main(["solve", str(path)]) == 2
    said = capsys.readouterr().err
    assert "OA is rigid, and the distance of its points O and A changes (got s)" in said
    assert 'S = "A"' in said
