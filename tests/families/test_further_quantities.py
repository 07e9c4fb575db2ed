"""Positions, components along lines and paths, radii of curvature, coordinates of centres, ratios: values by hand."""

from __future__ import annotations

import math
from collections.abc import Callable
from typing import Any

import mpmath
import pytest
from msgspec.structs import replace

from variantgen.errors import InputError
from variantgen.exam.sections.tolerance import Tolerance
from variantgen.exam.sheets import answer_variants
from variantgen.families.asking import check_ask, read_ask
from variantgen.families.quantities import parse_quantity, split_name
from variantgen.families.reading.load import load_family
from variantgen.families.restrict import restrict
from variantgen.figure.build import statement_figure
from variantgen.finished.verify import independent
from variantgen.mechanism.scene import Scene
from variantgen.mechanism.solving.solve import solve
from variantgen.outputs.single.explanation import explain
from variantgen.single import answers, one_variant
from variantgen.testing.linkages import four_bar, sleeve_on_crank, slider_crank, spool, wheel
from variantgen.variants.draw import draw
from variantgen.variants.variant import solve_variants
from variantgen.wording.formula import to_plain, to_typst
from variantgen.wording.language import load_language
from variantgen.wording.latex import to_latex

A, B, C, D, PHI, OMEGA, EPSILON = 0.2, 0.6, 0.5, 0.7, 1.0, 2.0, 3.0
STEP = mpmath.mpf(10) ** -15  # of time; 60 digits are carried


def value(scene: Scene, name: str) -> float:
    return float(parse_quantity(name, scene).value(solve(scene))[0])


def crank_angle(t: Any) -> Any:
    return mpmath.mpf(PHI) + OMEGA * t + mpmath.mpf(EPSILON) / 2 * t * t


def on_four_bar(t: Any) -> dict[str, Any]:
    """Points of a four-bar: B by the law of cosines in the triangle A B C."""
    a, b, c, d = map(mpmath.mpf, (A, B, C, D))
    places = {"O": mpmath.mpc(0), "C": mpmath.mpc(d), "A": a * mpmath.expj(crank_angle(t))}
    line = places["C"] - places["A"]
    gap = abs(line)
    corner = mpmath.acos((b * b + gap * gap - c * c) / (2 * b * gap))
    places["B"] = places["A"] + b * mpmath.expj(mpmath.arg(line) + corner)
    places["M"] = (places["A"] + places["B"]) / 2
    return places


def derivatives(of: Callable[[Any], Any]) -> tuple[Any, Any, Any]:
    with mpmath.workdps(60):
        before, now, after = (of(k * STEP) for k in (-1, 0, 1))
        return now, (after - before) / (2 * STEP), (after - 2 * now + before) / STEP**2


def circle_radius(of: Callable[[Any], Any]) -> float:
    """The radius of the circle through three neighbouring places of a point."""
    with mpmath.workdps(60):
        p, q, r = (of(k * STEP * 1000) for k in (-1, 0, 1))
        area = abs(((q - p) * mpmath.conj(r - p)).imag) / 2
        return float(abs(q - p) * abs(r - q) * abs(p - r) / (4 * area))


@pytest.mark.parametrize("point", ["B", "M"])
def test_components_and_path_of_a_four_bar(point: str) -> None:
    scene = four_bar(A, B, C, D, PHI, OMEGA, EPSILON)
    z, v, a = derivatives(lambda t: on_four_bar(t)[point])
    places = on_four_bar(mpmath.mpf(0))
    unit = (places["B"] - places["O"]) / abs(places["B"] - places["O"])
    assert value(scene, f"v_{point}.along_OB") == pytest.approx(float((v * mpmath.conj(unit)).real), rel=1e-9)
    assert value(scene, f"v_{point}.across_OB") == pytest.approx(float((v * mpmath.conj(unit)).imag), rel=1e-9)
    assert value(scene, f"a_{point}.along_BO") == pytest.approx(float(-(a * mpmath.conj(unit)).real), rel=1e-9)
    assert value(scene, f"x_{point}") == pytest.approx(float(z.real), rel=1e-12)
    assert value(scene, f"y_{point}") == pytest.approx(float(z.imag), rel=1e-12)
    # The tangential acceleration is the rate of the speed.
    with mpmath.workdps(60):
        speed = derivatives(lambda t: abs(derivatives(lambda s: on_four_bar(t + s)[point])[1]))[1]
    radius = circle_radius(lambda t: on_four_bar(t)[point])
    assert value(scene, f"a_{point}.t") == pytest.approx(float(speed), rel=1e-7)
    assert value(scene, f"rho_{point}") == pytest.approx(radius, rel=1e-9)
    assert value(scene, f"a_{point}.n") == pytest.approx(float(abs(v)) ** 2 / radius, rel=1e-9)


def test_centres_and_ratio_of_a_four_bar() -> None:
    """The centres lie where the velocity, the acceleration, which is linear in the place, is zero."""
    scene = four_bar(A, B, C, D, PHI, OMEGA, EPSILON)
    one, other = (derivatives(lambda t, p=point: on_four_bar(t)[p]) for point in "AB")
    for kind, order in (("P", 1), ("Q", 2)):
        centre = one[0] - one[order] * (other[0] - one[0]) / (other[order] - one[order])
        assert value(scene, f"{kind}_AB.x") == pytest.approx(float(centre.real), rel=1e-9)
        assert value(scene, f"{kind}_AB.y") == pytest.approx(float(centre.imag), rel=1e-9)
    turning = derivatives(lambda t: mpmath.arg(on_four_bar(t)["B"] - on_four_bar(t)["A"]))[1]
    assert value(scene, "ratio_AB.OA") == pytest.approx(float(turning) / OMEGA, rel=1e-9)


def test_position_of_a_slider_crank() -> None:
    a, b, e, phi, omega = 0.2, 0.6, 0.1, 0.9, 3.0
    scene = slider_crank(a, b, e, phi, omega)
    slope = math.asin((e - a * math.sin(phi)) / b)
    way = a * math.cos(phi) + b * math.cos(slope)
    assert value(scene, "x_B") == pytest.approx(way, rel=1e-12)
    assert value(scene, "angle_AB") == pytest.approx(slope, rel=1e-12)
    assert value(scene, "angle_BA") == pytest.approx(slope + math.pi, rel=1e-12)
    assert value(scene, "distance_O.B") == pytest.approx(math.hypot(way, e), rel=1e-12)
    corner = math.acos((a * a + b * b - way**2 - e * e) / (2 * a * b))
    assert value(scene, "angle_O.A.B") == pytest.approx(corner, rel=1e-12)
    # omega_AB = - omega a cos(phi) / (b cos(slope))
    assert value(scene, "ratio_AB.OA") == pytest.approx(-a * math.cos(phi) / (b * math.cos(slope)), rel=1e-12)
    # The path of the slider is straight.
    assert math.isinf(value(scene, "rho_B"))
    assert value(scene, "a_B.n") == pytest.approx(0.0, abs=1e-12)


def test_signed_motion_along_a_slot() -> None:
    """The relative velocity and acceleration along the rod are the derivatives of the distance of its ends."""
    oa, oc, ab, h, phi, omega, epsilon = 0.6, 0.3, 0.4, 0.1, 0.8, 2.0, 1.0

    def rod(t: Any) -> Any:
        turn = mpmath.expj(mpmath.mpf(phi) + omega * t + mpmath.mpf(epsilon) / 2 * t * t)
        crank = mpmath.mpf(oa) * turn
        slider = crank.real + mpmath.sqrt(mpmath.mpf(ab) ** 2 - (crank.imag - mpmath.mpf(h)) ** 2) + 1j * mpmath.mpf(h)
        return mpmath.mpf(oc) * turn - slider  # from B to C

    scene = sleeve_on_crank(oa, oc, ab, h, phi, omega, epsilon)
    _, speed, rate = derivatives(lambda t: abs(rod(t)))
    turning = derivatives(lambda t: mpmath.arg(rod(t)))[1]
    assert value(scene, "v_rel_C.along_BC") == pytest.approx(float(speed), rel=1e-9)
    assert value(scene, "v_rel_C.along_CB") == pytest.approx(-float(speed), rel=1e-9)
    assert value(scene, "a_rel_C.along_BC") == pytest.approx(float(rate), rel=1e-9)
    assert value(scene, "a_cor_C.across_BC") == pytest.approx(2 * float(turning * speed), rel=1e-9)


def test_path_of_points_of_a_wheel() -> None:
    """A cycloid: its radius of curvature is twice the distance from the contact."""
    r, v = 0.5, 3.0
    scene = wheel(r, v)
    assert value(scene, "rho_T") == pytest.approx(4 * r, rel=1e-12)
    assert value(scene, "rho_A") == pytest.approx(2 * math.sqrt(2) * r, rel=1e-12)
    # v^2 / r points from A to O, the velocity is at 45 degrees to it.
    assert value(scene, "a_A.t") == pytest.approx(v * v / r / math.sqrt(2), rel=1e-12)
    assert value(scene, "a_T.t") == pytest.approx(0.0, abs=1e-12)
    assert value(scene, "a_T.n") == pytest.approx(v * v / r, rel=1e-12)
    assert value(scene, "P_wheel.x") == pytest.approx(0.0, abs=1e-12)
    assert value(scene, "Q_wheel.y") == pytest.approx(r, rel=1e-12)
    assert math.isinf(value(scene, "a_P.t"))  # a point at rest has no path


def test_speed_of_a_rope() -> None:
    """The load falls with the rope; on the other side of the fixed pulley the rope is as fast."""
    scene = spool(0.2, 0.5, 1.5, 0.4)
    assert value(scene, "v_rope.K.B") == pytest.approx(1.5, rel=1e-12)
    assert value(scene, "v_rope.O.K") == pytest.approx(1.5, rel=1e-12)
    with pytest.raises(InputError, match=r"v_rope\.O\.K, v_rope\.K\.B"):
        parse_quantity("v_rope.O.B", scene)


@pytest.mark.parametrize(
    ("name", "unit"),
    [
        ("v_B.along_OA", "cm/s"),
        ("a_B.t", "cm/s^2"),
        ("rho_M", "cm"),
        ("P_AB.x", "cm"),
        ("ratio_OA.AB", "1"),
        ("angle_AB", "deg"),
        ("angle_O.A.B", "deg"),
        ("distance_O.B", "cm"),
        ("y_B", "cm"),
        ("v_rope.A.B", "cm/s"),
        ("v_rel_C.across_OA", "cm/s"),
    ],
)
def test_names_and_units(name: str, unit: str) -> None:
    assert split_name(name).name == name
    assert split_name(name).unit("cm").name == unit


@pytest.mark.parametrize(
    ("name", "plain", "typst", "latex"),
    [
        ("v_B.along_OA", "v_B ∥OA", 'v_(B class("normal", parallel) O A)', r"v_{B\,\parallel O A}"),
        ("v_B.across_OC", "v_B ⟂OC", 'v_(B class("normal", perp) O C)', r"v_{B\,\perp O C}"),
        ("a_B.t", "a^τ_B", "a_(B)^(tau)", r"a_{B}^{\tau}"),
        ("rho_B", "ρ_B", "rho_(B)", r"\rho_{B}"),
        ("P_AB.x", "x_P AB", "x_(P A B)", r"x_{P\,A B}"),
        ("ratio_OA.AB", "ω_OA/ω_AB", r"omega_(O A)\/omega_(A B)", r"\omega_{O A}/\omega_{A B}"),
        ("x_B", "x_B", "x_(B)", "x_{B}"),
        ("v_rope.O.B", "v_нити OB", 'v_("нити" O B)', r"v_{\text{нити}\,O B}"),
        ("angle_AB", "φ_AB", "phi_(A B)", r"\varphi_{A B}"),
        ("angle_O.A.B", "∠OAB", "angle O A B", r"\angle O A B"),
        ("distance_O.B", "OB", "O B", "O B"),
    ],
)
def test_how_they_are_written(name: str, plain: str, typst: str, latex: str) -> None:
    symbol = load_language("ru").quantity(split_name(name), {})
    assert (to_plain(symbol), to_typst(symbol), to_latex(symbol)) == (plain, typst, latex)


@pytest.mark.parametrize(
    ("family", "name", "reason"),
    [
        ("four_bar", "x_C", "C rests"),
        ("four_bar", "distance_A.B", "both points belong to AB"),
        ("four_bar", "rho_B", "the radius is their distance"),
        ("rolling_wheel", "x_O", "the data tell it"),
        ("slider_crank", "distance_O.A", "both points belong to OA"),
        ("four_bar", "P_OA.x", "OA turns about O, which rests"),
    ],
)
def test_positions_that_are_data_are_refused(family: str, name: str, reason: str) -> None:
    form = next(iter(load_family(family).forms.values()))
    with pytest.raises(InputError, match="is given, so it cannot be asked") as found:
        read_ask(form, [name])
    assert reason in str(found.value)


def test_a_line_is_named_by_points_of_one_letter() -> None:
    """``PinB`` would be read as the points P and inB on a sheet, ``ABC`` as A-BC or as AB-C."""
    scene = four_bar(0.2, 0.6, 0.5, 0.7, 1.0, 2.0, 3.0)
    points = {**scene.points, "Pin": scene.points["A"], "BC": scene.points["B"]}
    scene = replace(scene, points=points)
    assert parse_quantity("v_B.along_OA", scene).line == "OA"
    for name in ("v_B.along_PinB", "v_B.along_ABC"):
        with pytest.raises(InputError, match="each a letter or a letter with a number"):
            parse_quantity(name, scene)


@pytest.mark.parametrize(
    ("name", "remedy"),
    [
        ("v_B.along_OX", "each a letter or a letter with a number, of: A, B, C, M, O"),
        ("ratio_AB.XY", "write the two bodies of omega / omega"),
        ("angle_XY", "points: A, B, C, M, O"),
        ("distance_A", "the distance of two points distance_A.B"),
    ],
)
def test_remedies(name: str, remedy: str) -> None:
    with pytest.raises(InputError, match="unknown quantity") as found:
        read_ask(load_family("four_bar").forms["crank"], [name])
    assert remedy in str(found.value)


@pytest.mark.parametrize("name", ["angle_AA", "v_B.along_OX", "distance_A", "ratio_AB.XY"])
def test_a_mistake_in_all_forms_is_told_once(name: str) -> None:
    """They name their points and bodies in different orders."""
    family = load_family("four_bar")
    assert len({tuple(form.points) for form in family.forms.values()}) > 1
    with pytest.raises(InputError) as found:
        check_ask(family, [name], family)
    assert len(found.value.problems) == 1


def test_what_has_no_value_is_not_drawn() -> None:
    """A slider on a straight guide has no radius of curvature, a wheel no ratio to a body that does not turn."""
    with pytest.raises(InputError, match="rho_B not trivial"):
        draw(restrict(load_family("slider_crank"), forms=("central",)), ["rho_B"], [("straight", "0")])


CASES = [
    ("four_bar", "crank", ["v_B.along_OA", "v_B.across_OC", "ratio_AB.BC", "P_AB.x", "P_AB.y"]),
    ("four_bar", "crank", ["x_B", "y_B", "angle_AB", "angle_O.A.B", "distance_O.B"]),
    ("four_bar", "crank", ["a_B.t", "a_B.n", "Q_AB.x", "a_B.along_AB"]),
    ("slider_crank", "offset", ["a_B.across_OA", "ratio_AB.OA", "angle_BA"]),
    ("sleeve_on_crank", "", ["v_rel_C.along_BD", "a_rel_C.along_BD", "a_cor_C.across_BD"]),
    ("pulley_and_wheel", "axle", ["v_rope.O.B", "v_rope.C.O"]),
    ("rolling_wheel", "", ["rho_M", "a_M.t", "a_M.n", "Q_wheel.x"]),
]


@pytest.mark.parametrize(("family", "form", "ask"), CASES)
def test_solved_explained_and_confirmed(family: str, form: str, ask: list[str]) -> None:
    """Each has an answer by the solver, by the independent path, and by the steps of a solution in both languages."""
    for seed in ("1", "2"):
        variant = one_variant(family, {}, seed, form, ask)
        found = answers(variant, ask)
        _, again, _ = independent([variant], read_ask(variant.form, ask))
        for answer, other in zip(found, again[:, 0], strict=True):
            assert answer.value == pytest.approx(other, rel=1e-6)
        for language in ("en", "ru"):
            words = load_language(language)
            for method in ([], ["coordinates"]) if not all(q.quantity.order == 0 for q in found) else ([],):
                told = str(explain(variant, language, method, ask=ask))
                for answer in found:
                    symbol = to_plain(words.quantity(answer.quantity, variant.form.symbols))
                    assert f"{symbol} = {to_plain(words.answer(answer.quantity, answer.value))}" in told.replace(
                        "\n", " "
                    )
        (own,) = answer_variants([variant], [tuple(ask)], [Tolerance()])
        assert all(answer.tolerance > 0.0 for answer in own)


@pytest.mark.parametrize(
    ("ask", "letters"),
    [
        (["x_B"], {"x", "y"}),
        (["v_B.along_OA"], {"∥OA"}),
        (["v_B.along_OA", "v_B.across_OA"], {"∥OA", "⟂OA"}),
        (["ratio_AB.BC"], set()),
    ],
)
def test_the_figure_shows_what_is_counted_from(ask: list[str], letters: set[str]) -> None:
    variant = one_variant("four_bar", {}, "3", "crank", ask)
    asked = read_ask(variant.form, ask)
    drawing = statement_figure(variant, solve_variants([variant], 0), 0, asked, load_language("en"))
    shown = {to_plain(label.formula) for label in drawing.labels}
    assert shown & {"x", "y", "∥OA", "⟂OA"} == letters
    assert ("axes with the origin O" in drawing.alt) == ("x" in letters)
    assert ("in the direction OA" in drawing.alt) == ("∥OA" in letters)
    assert ("direction OA turned counterclockwise" in drawing.alt) == ("⟂OA" in letters)


@pytest.mark.parametrize("ask", [["v_B.along_OA", "a_M.t"], ["rho_M"], ["P_AB.x", "ratio_AB.BC"]])
def test_measured_on_plans(ask: list[str]) -> None:
    """Readings of a drawing have their signs too."""
    for seed in ("1", "2", "3"):
        variant = one_variant("four_bar", {}, seed, "crank", ask)
        told = str(explain(variant, "en", ["graphical"], ask=ask))
        assert "as measured on the drawing" in told
        assert told.count("−") > 0 or all(answer.value > 0 for answer in answers(variant, ask))
