"""Answers by mistakes, against formulas written by hand; and how far they are from the right ones."""

from __future__ import annotations

import math

import numpy as np
import pytest

from variantgen.families.asking import read_ask
from variantgen.families.parameters.draw_rules import frame
from variantgen.families.reading.load import load_family
from variantgen.families.restrict import restrict
from variantgen.variants.distractors import distances, wrong_answers
from variantgen.variants.draw import draw
from variantgen.variants.variant import Variant, parameter_arrays, solve_variants


def drawn(name: str, form: str, count: int = 6) -> list[Variant]:
    family = restrict(load_family(name), None, None, (form,) if form else ())
    return draw(family, None, [("mistakes", i) for i in range(count)])


def by_mistakes(variants: list[Variant], ask: list[str]) -> dict[str, np.ndarray]:
    asked = read_ask(variants[0].form, ask)
    motion = solve_variants(variants, max(q.order for q in asked))
    on_paper = frame([v.sense for v in variants], [v.turns for v in variants])
    return wrong_answers(variants[0].form, parameter_arrays(variants), on_paper, asked, motion)


def test_the_slider_crank_without_the_normal_acceleration_of_the_rod() -> None:
    """``a_B cos b = a_A^n cos(phi + b) + a_A^tau sin(phi + b) [+ a_BA^n]`` on the line AB."""
    variants = drawn("slider_crank", "central")
    found = by_mistakes(variants, ["a_B", "v_B"])
    for i, variant in enumerate(variants):
        r, rod_length, phi = (variant.si(name) for name in ("OA", "AB", "phi"))
        omega, epsilon = (abs(variant.si(name)) for name in ("omega_OA", "epsilon_OA"))
        if variant.si("epsilon_OA") < 0:
            epsilon = -epsilon
        b = math.asin(r * math.sin(phi) / rod_length)
        rod = omega * r * math.cos(phi) / (rod_length * math.cos(b))
        normal, tangential, of_rod = omega**2 * r, epsilon * r, rod**2 * rod_length
        on_line = normal * math.cos(phi + b) + tangential * math.sin(phi + b)
        without = abs(on_line / math.cos(b))
        reversed_ = abs((on_line - of_rod) / math.cos(b))
        assert found["normal acceleration of AB forgotten"][0, i] == pytest.approx(without, rel=1e-9)
        assert found["normal acceleration of AB reversed"][0, i] == pytest.approx(reversed_, rel=1e-9)
        no_epsilon = abs((normal * math.cos(phi + b) + of_rod) / math.cos(b))
        assert found["given accelerations forgotten"][0, i] == pytest.approx(no_epsilon, rel=1e-9)
        # Velocities do not notice.
        v = abs(omega * r * math.sin(phi + b) / math.cos(b))
        assert found["normal acceleration of AB forgotten"][1, i] == pytest.approx(v, rel=1e-9)


def test_the_radian_mode_of_a_calculator() -> None:
    variants = drawn("slider_crank", "central")
    found = by_mistakes(variants, ["v_B"])["phi in degrees for radians"]
    for i, variant in enumerate(variants):
        r, rod_length, phi = variant.si("OA"), variant.si("AB"), math.degrees(variant.si("phi"))
        b = math.asin(r * math.sin(phi) / rod_length)
        v = abs(variant.si("omega_OA") * r * math.sin(phi + b) / math.cos(b))
        assert found[0, i] == pytest.approx(v, rel=1e-9)


def test_a_point_in_a_groove_without_the_coriolis_acceleration() -> None:
    """``a^2`` without it: components along and across the groove are ``a_rel - omega^2 s`` and ``epsilon s``."""
    variants = drawn("sliding_block_on_rotating_rod", "central")
    asked = read_ask(variants[0].form, ["a_M"])
    motion = solve_variants(variants, 2)
    found = by_mistakes(variants, ["a_M"])["Coriolis acceleration of M forgotten"]
    body = next(joint.sliding().body for joint in motion.scene.joints if joint.sliding())
    pivot = motion.scene.bodies[body][0]
    arm = motion.z["M"] - motion.z[pivot]
    slip = motion.v["M"] - 1j * motion.omega[body] * arm
    by_hand = np.abs(motion.a["M"] - 2j * motion.omega[body] * slip)
    assert np.all(np.abs(asked[0].value(motion) - by_hand) > 0)
    assert found[0] == pytest.approx(by_hand, rel=1e-9)


def test_the_other_branch_of_a_four_bar_is_its_mirror_image_in_the_diagonal() -> None:
    variants = drawn("four_bar", "crank")
    asked = read_ask(variants[0].form, ["v_B"])
    motion = solve_variants(variants, 1)
    found = by_mistakes(variants, ["v_B"])["B on the other branch"]
    for i, variant in enumerate(variants):
        o, a, b, c = (complex(motion.z[name][i]) for name in "OABC")
        line = (c - a) / abs(c - a)
        mirrored = a + line * ((b - a) / line).conjugate()
        # v_B is across BC and has the projection of v_A on the rod.
        rod, way = (mirrored - a) / abs(mirrored - a), 1j * (mirrored - c) / abs(mirrored - c)
        v_a = 1j * float(motion.omega["OA"][i]) * (a - o)
        v = (v_a.conjugate() * rod).real / (way.conjugate() * rod).real
        assert found[0, i] == pytest.approx(abs(v), rel=1e-9)
        assert abs(asked[0].value(motion)[i] - abs(v)) > 0
        assert variant.form.name == "crank"


def test_distances_are_relative_and_leave_out_what_no_mistake_touches() -> None:
    asked = read_ask(load_family("rolling_wheel").forms[""], ["v_M", "omega_wheel.sense", "v_M.angle"])
    right = np.array([[2.0, 2.0], [1.0, 1.0], [3.1, 0.0]])
    wrong = np.array([[2.05, 2.0], [-1.0, 1.0], [-3.1, np.nan]])
    found = distances(right, wrong, asked)
    assert found[0].tolist() == [pytest.approx(0.025), math.inf]
    assert found[1].tolist() == [math.inf, math.inf]
    assert found[2, 0] == pytest.approx(2 * math.pi - 6.2)
    assert found[2, 1] == math.inf
