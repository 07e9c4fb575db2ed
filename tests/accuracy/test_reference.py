"""The reference against closed forms written by hand, and what it covers."""

from __future__ import annotations

import mpmath
import numpy as np
import pytest

from tests.joint_scenes import SCENES
from variantgen.accuracy.condition import condition
from variantgen.accuracy.norms import deviation
from variantgen.accuracy.precise import exact_number, many_digits
from variantgen.accuracy.reference.branches import on_branch
from variantgen.accuracy.reference.checked_positions import positions
from variantgen.accuracy.reference.definitions import definition
from variantgen.accuracy.reference.exact_scene import data, exact_scene, kind, wide_scene
from variantgen.accuracy.reference.motion import ExactMotion, solve_exactly
from variantgen.accuracy.reference.positions import NoSuchPointError, construction
from variantgen.mechanism.component import discover
from variantgen.mechanism.constructions.circle_circle import CircleCircle
from variantgen.mechanism.constructions.coordinates import Coordinates
from variantgen.mechanism.constructions.polar import Polar
from variantgen.mechanism.drivers.rotation import Rotation
from variantgen.mechanism.joints.pivot import Pivot
from variantgen.mechanism.rows import Frame
from variantgen.mechanism.scene import Scene
from variantgen.mechanism.solving.solve import solve
from variantgen.testing.linkages import four_bar, sleeve_on_crank, slider_crank

TINY = 1e-22  # derivatives by mpmath.diff have about a third of the digits carried


def exactly(scene: Scene) -> ExactMotion:
    with many_digits():
        return solve_exactly(exact_scene(scene, 0, 1)).exact


def test_four_bar_by_hand() -> None:
    a, b, c, d, phi, omega, epsilon = 0.25, 0.8, 0.6, 0.9, 0.7, 2.0, -3.0
    found = exactly(four_bar(a, b, c, d, phi, omega, epsilon))
    with many_digits():

        def rocker(t: mpmath.mpf) -> mpmath.mpf:
            """Angle of the rocker by the law of cosines in the triangle A, B, C."""
            crank = mpmath.mpf(a) * mpmath.expj(mpmath.mpf(phi) + omega * t + epsilon * t**2 / 2)
            away = crank - mpmath.mpf(d)
            f = abs(away)
            inner = mpmath.acos((mpmath.mpf(c) ** 2 + f**2 - mpmath.mpf(b) ** 2) / (2 * mpmath.mpf(c) * f))
            return mpmath.arg(away) - inner

        assert abs(found.omega["BC"] - mpmath.diff(rocker, 0)) < TINY
        assert abs(found.epsilon["BC"] - mpmath.diff(rocker, 0, 2)) < 1e3 * TINY
        place = mpmath.mpf(d) + mpmath.mpf(c) * mpmath.expj(rocker(mpmath.mpf(0)))
        assert abs(found.z["B"] - place) < mpmath.mpf(10) ** -70


def test_slider_crank_by_hand() -> None:
    a, b, height, phi, omega, epsilon = 0.2, 0.7, 0.1, 1.1, 2.0, 5.0
    scene = slider_crank(a, b, 0.0, phi, omega, epsilon)
    scene = Scene(
        {**scene.points, "E": Coordinates(0.0, height)}, scene.bodies, scene.joints, scene.drivers, scene.frame
    )
    found = exactly(scene)
    with many_digits():

        def slider(t: mpmath.mpf) -> mpmath.mpf:
            crank = mpmath.mpf(a) * mpmath.expj(mpmath.mpf(phi) + omega * t + epsilon * t**2 / 2)
            return crank.real + mpmath.sqrt(mpmath.mpf(b) ** 2 - (mpmath.mpf(height) - crank.imag) ** 2)

        assert abs(found.v["B"] - mpmath.diff(slider, 0)) < TINY
        assert abs(found.a["B"] - mpmath.diff(slider, 0, 2)) < 1e3 * TINY


@pytest.mark.parametrize("name", SCENES)
@pytest.mark.parametrize("frame", [Frame(), Frame(1j, -1.0)])
def test_solver_agrees_with_the_reference(name: str, frame: Frame) -> None:
    plain = SCENES[name]
    scene = Scene(plain.points, plain.bodies, plain.joints, plain.drivers, frame, plain.conditions)
    motion, exact = solve(scene), exactly(scene)
    with many_digits():
        tables = [
            {k: exact_number(x[0]) for k, x in t.items()}
            for t in (motion.z, motion.v, motion.a, motion.omega, motion.epsilon)
        ]
        gaps = deviation(ExactMotion({}, *tables, exact.size), exact)
    assert max(float(gap) for gap in gaps) < 4e-15


def test_every_kind_has_its_reference() -> None:
    for name in discover("variantgen.mechanism.constructions"):
        assert construction(name), f"write positions.{name} and definitions.{name}"
        assert definition(name), f"write definitions.{name}"
    for name in discover("variantgen.mechanism.conditions"):
        assert definition(name), f"write definitions.{name}"


def test_residuals_of_every_kind_are_evaluated_on_series() -> None:
    used = {kind(c) for scene in SCENES.values() for c in scene.constraints}
    used |= {kind(c) for c in sleeve_on_crank(0.6, 0.25, 0.6, 0.1, 0.5, 2.0).constraints}
    for package in ("joints", "drivers"):
        assert set(discover(f"variantgen.mechanism.{package}")) <= used


def test_what_does_not_assemble_is_told() -> None:
    with many_digits(), pytest.raises(NoSuchPointError):
        solve_exactly(exact_scene(four_bar(0.1, 0.2, 0.2, 0.9, 0.3, 1.0), 0, 1))


def test_condition_number_of_a_crank() -> None:
    phi = 1.25
    scene = Scene(
        {"O": Coordinates(0.0, 0.0), "A": Polar("O", 0.5, phi)},
        {"OA": ("O", "A")},
        (Pivot("O"),),
        (Rotation("OA", 3.0),),
    )
    with many_digits():
        exact = exact_scene(scene, 0, 1)
        assert len(list(data(exact))) == 3
        found = condition(exact, solve_exactly(exact))
    # v = i a omega exp(i phi), a = -omega^2 a exp(i phi): the length counts once, phi phi times, omega by its power.
    assert found.velocity == pytest.approx(1 + 1 + phi)
    assert found.acceleration == pytest.approx(1 + 2 + phi)


def test_condition_number_near_a_dead_point_grows_with_the_square_of_the_angle() -> None:
    def kappa(angle: float) -> float:
        a, b, c = 0.3, 0.7, 0.5
        reach = np.sqrt(b**2 + c**2 + 2 * b * c * np.cos(angle))
        scene = four_bar(a, b, c, a * np.cos(1.0) + np.sqrt(reach**2 - (a * np.sin(1.0)) ** 2), 1.0, 2.0, 1.0)
        with many_digits():
            exact = exact_scene(scene, 0, 1)
            return condition(exact, solve_exactly(exact)).velocity

    assert kappa(1e-4) / kappa(1e-3) == pytest.approx(100, rel=0.1)


def test_branches_are_told_apart() -> None:
    scene = four_bar(0.25, 0.8, 0.6, 0.9, 0.7, 2.0)
    with many_digits():
        exact = exact_scene(scene, 0, 1)
        places = solve_exactly(exact).exact.places
        assert on_branch(exact, places, places, 1)
        other = exactly(four_bar(0.25, 0.8, 0.6, 0.9, 0.7, 2.0, side=-1.0)).places
        assert not on_branch(exact, other, places, 1)


def test_solver_follows_the_precision_of_its_scene() -> None:
    scene = four_bar(0.25, 0.8, 0.6, 0.9, 0.7, 2.0, -3.0)
    motion, wide = solve(scene), solve(wide_scene(scene))
    assert motion.a["B"].dtype == np.complex128
    assert motion.omega["BC"].dtype == motion.epsilon["BC"].dtype == np.float64
    assert wide.a["B"].dtype == np.clongdouble
    exact = exactly(scene)
    with many_digits():
        gap = abs(exact_number(wide.epsilon["BC"][0]) - exact.epsilon["BC"]) / abs(exact.epsilon["BC"])
    assert gap < 100 * np.finfo(np.longdouble).eps


def test_angles_of_the_reference_are_not_rounded_to_right_angles() -> None:
    scene = Scene(
        {"O": Coordinates(0.0, 0.0), "A": Polar("O", 1.0, np.pi / 2), "B": CircleCircle("O", 1.0, "A", 1.0, 1.0)},
        {"OA": ("O", "A"), "AB": ("A", "B")},
        (Pivot("O"), Pivot("B")),
        (),
    )
    with many_digits():
        at = exact_scene(scene, 0, 1)
        assert float(positions(at)["A"].real) == pytest.approx(6.123e-17, rel=1e-3)
