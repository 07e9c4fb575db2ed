"""Velocity and acceleration plans: to one scale, as the solved motion and the sources say."""

from __future__ import annotations

import cmath
import math
from functools import cache
from itertools import pairwise
from typing import ClassVar

import numpy as np
import pytest
from msgspec.structs import replace

from tests.figure.reading import FORMS, arrows, has_arrow, variants_of, view_drawings
from variantgen.errors import InputError
from variantgen.families.parameters.units import unit
from variantgen.figure.drawing import THIN, Drawing, Layer, Path
from variantgen.figure.inspection.faults import inspect_labels
from variantgen.figure.motion.motion_data import MovingMechanism, motion_data
from variantgen.figure.motion.plans import COINCIDENT, PlanVector, round_length
from variantgen.figure.motion.vectors import vectors_of
from variantgen.figure.views import acceleration_plan, velocity_plan
from variantgen.mechanism.drivers.extension import Extension
from variantgen.mechanism.motion import Motion
from variantgen.mechanism.outcome import Outcome
from variantgen.resources import languages
from variantgen.single import asked_quantities, one_variant
from variantgen.variants.variant import Variant, solve_variants
from variantgen.wording.formula import Measured, to_plain
from variantgen.wording.language import load_language

EN = load_language("en")
SEEDS = 3


@cache
def drawings(name: str, form: str, order: int) -> list[tuple[Variant, Motion, int, Drawing]]:
    """The plans of several variants."""
    return view_drawings(name, form, order, (velocity_plan, acceleration_plan), SEEDS)


@pytest.mark.parametrize("order", [1, 2])
@pytest.mark.parametrize(("name", "form"), FORMS)
def test_asked_vectors_are_rays_to_one_scale(name: str, form: str, order: int) -> None:
    for variant, motion, i, drawing in drawings(name, form, order):
        found = arrows(drawing, Layer.VECTOR)
        table = motion.v if order == 1 else motion.a
        asked = {
            q.point for q in asked_quantities(variant) if q.point in table and q.kind in ("v", "a", "v_rel", "a_rel")
        }
        assert asked or name in ("wheel_between_racks", "slider_crank", "planetary_train")
        fixed = {p for p in asked if abs(table[p][i]) * drawing.scale < COINCIDENT}
        for point in asked - fixed:
            tip = drawing.origin + drawing.scale * complex(table[point][i])
            # A ray that ends where another one ends is drawn once.
            assert has_arrow(found, drawing.origin, tip, COINCIDENT), (point, variant.printed)


@pytest.mark.parametrize(("name", "form"), FORMS)
def test_every_ray_is_the_vector_of_a_point_or_of_the_carrier_below_it(name: str, form: str) -> None:
    for _, motion, i, drawing in drawings(name, form, 1):
        ends = [complex(v[i]) for v in motion.v.values()]
        bodies = {b: (m[0], complex(1j * motion.omega[b][i])) for b, m in motion.scene.bodies.items()}
        for joint in motion.scene.joints:
            if path := joint.sliding():
                pole, turn = bodies[path.body]
                ends.append(complex(motion.v[pole][i]) + turn * complex(motion.z[path.point][i] - motion.z[pole][i]))
        for driver in motion.scene.drivers:
            if isinstance(driver, Extension):  # the velocity along a cylinder that is hinged to the ground
                way = complex(motion.z[driver.end][i] - motion.z[driver.start][i])
                ends.append(complex(np.ravel(driver.v)[i % np.size(driver.v)]) * way / abs(way))
        rays = [(a, b) for a, b in arrows(drawing, Layer.VECTOR) if abs(a - drawing.origin) < 1e-9]
        assert rays
        for start, tip in rays:
            ray, nothing = (tip - start) / drawing.scale, 1e-9 * max(map(abs, ends))
            # A vector that is known by components across each other is drawn by them: each is a leg over it.
            legs = (abs(abs(ray - end / 2) - abs(end) / 2) for end in ends)
            assert min(abs(ray - end) for end in ends) < nothing or min(legs) < nothing


def about_poles(vectors: list[PlanVector], points: list[str], kind: str) -> list[tuple[PlanVector, str, str]]:
    """Vectors named by two points (``v_BA``), with the two points."""
    pairs = {f"{p}/{q}": (p, q) for p in points for q in points if p != q}
    found = [
        (v, pairs.get(v.symbol.index[0].text)) for v in vectors if v.symbol.base == kind and len(v.symbol.index) == 1
    ]
    return [(v, *pair) for v, pair in found if pair is not None]


@pytest.mark.parametrize(("name", "form"), FORMS)
def test_sides_are_perpendicular_to_the_links(name: str, form: str) -> None:
    variants, motion, asked = variants_of(name, form, SEEDS)
    for i, variant in enumerate(variants):
        mechanism = MovingMechanism(variant, motion, i, asked, EN)
        found = motion_data(mechanism, 1)
        plan = velocity_plan.velocity_plan(found, vectors_of(mechanism, 1, methods=("graphical",)))
        for vector, point, pole in about_poles(plan.vectors, list(motion.z), "v"):
            arm = complex(motion.z[point][i] - motion.z[pole][i])
            side = vector.end - vector.start
            assert abs((side * arm.conjugate()).real) <= 1e-9 * abs(arm) * max(abs(side), abs(vector.end))


@pytest.mark.parametrize(("name", "form"), FORMS)
def test_components_lead_from_the_pole_of_the_body_to_the_point(name: str, form: str) -> None:
    variants, motion, asked = variants_of(name, form, SEEDS)
    if max(q.order for q in asked) < 2:
        return
    bodies = motion.scene.bodies
    for i, variant in enumerate(variants):
        mechanism = MovingMechanism(variant, motion, i, asked, EN)
        found = motion_data(mechanism, 2)
        named = vectors_of(mechanism, 2, methods=("graphical",))
        plan = acceleration_plan.acceleration_plan(found, named)
        turning = about_poles(plan.vectors, list(motion.z), "a")
        scale = max(abs(complex(a[i])) for a in motion.a.values())
        for vector, point, pole in turning:
            body = next(
                b
                for b, members in bodies.items()
                if pole in members and (point in members or sliding(motion, point, b))
            )
            arm = complex(motion.z[point][i] - motion.z[pole][i])
            omega, epsilon = float(motion.omega[body][i]), float(motion.epsilon[body][i])
            size = vector.end - vector.start
            if vector.symbol.part[0].text == "n":
                assert abs(size + omega**2 * arm) < 1e-8 * scale
                assert abs(vector.start - complex(motion.a[pole][i])) < 1e-8 * scale
            else:
                assert abs(size - 1j * epsilon * arm) < 1e-8 * scale
        for _, point, pole in turning:
            # The tangential component (there is none of a body that turns uniformly) follows the normal one.
            parts = [vector for vector, *ends in turning if ends == [point, pole]]
            assert all(abs(first.end - second.start) < 1e-8 * scale for first, second in pairwise(parts))
            if any({point, pole} <= set(members) for members in bodies.values()):
                assert abs(parts[-1].end - complex(motion.a[point][i])) < 1e-8 * scale


def sliding(motion: Motion, point: str, body: str) -> bool:
    return any((path := joint.sliding()) and (path.point, path.body) == (point, body) for joint in motion.scene.joints)


@pytest.mark.parametrize(("name", "form"), FORMS)
def test_compound_accelerations_close(name: str, form: str) -> None:
    variants, motion, asked = variants_of(name, form, SEEDS)
    paths = [path for joint in motion.scene.joints if (path := joint.sliding())]
    if max(q.order for q in asked) < 2 or not paths:
        return
    for i, variant in enumerate(variants):
        mechanism = MovingMechanism(variant, motion, i, asked, EN)
        found = motion_data(mechanism, 2)
        named = vectors_of(mechanism, 2, methods=("graphical",))
        plan = acceleration_plan.acceleration_plan(found, named)
        scale = max(abs(complex(a[i])) for a in motion.a.values())
        given = {p.symbol: EN.symbol(p.symbol, {}) for p in variant.form.parameters.values() if p.unit}
        for path in paths:
            own = [v for v in plan.vectors if [index.text for index in v.symbol.index][1:] == [path.point]]
            parts = [v for v in own if v.symbol.index[0].text in ("rel", "Cor")]
            # What is given along the path bears the letter of the data.
            parts += [v for v in plan.vectors if v.symbol in given.values() and not v.whole and v not in parts]
            # One after the other from the end of the transport acceleration to that of the whole.
            place = carried(path.point, path.body, motion, i)
            for transport in (v for v in plan.vectors if v.whole and v.symbol.index[0].text == f"{path.point}′"):
                assert abs(transport.end - place) < 1e-9 * scale
            for part in parts:
                assert abs(part.start - place) < 1e-9 * scale
                place = part.end
            assert abs(place - complex(motion.a[path.point][i])) < 1e-9 * scale
            rel = velocity_of(path.point, path.body, motion, i)
            cor = sum(v.end - v.start for v in own if v.symbol.index[0].text == "Cor")
            assert abs(cor - 2j * motion.omega[path.body][i] * rel) < 1e-9 * scale


def carried(point: str, body: str, motion: Motion, i: int) -> complex:
    """The acceleration of the point of a body below another point, by the pole formula."""
    pole = motion.scene.bodies[body][0]
    turn = 1j * motion.epsilon[body][i] - motion.omega[body][i] ** 2
    return complex(motion.a[pole][i] + turn * (motion.z[point][i] - motion.z[pole][i]))


def velocity_of(point: str, body: str, motion: Motion, i: int) -> complex:
    """The velocity of a point relative to a body, by two points of the body (which gives its rotation)."""
    first, second = motion.scene.bodies[body][:2]
    turn = complex((motion.v[second][i] - motion.v[first][i]) / (motion.z[second][i] - motion.z[first][i]))
    return complex(motion.v[point][i] - motion.v[first][i] - turn * (motion.z[point][i] - motion.z[first][i]))


def near(value: complex, expected: complex, relative: float) -> bool:
    return abs(value - expected) < relative * abs(expected)


class TestProblem28:
    """The plans of Kirsanov, problem 28: lengths measured there with a ruler (cm/s, cm/s^2), to its reading error."""

    DATA: ClassVar = {"OA": 40, "AB": 111, "BC": 43, "OC": 62, "DB": 99.3, "phi": 135, "omega_OA": 3, "epsilon_OA": 0}
    WORDS: ClassVar = {"branch": "ahead", "sense": "counter_clockwise"}
    CRANK = cmath.rect(1, math.radians(45))

    def drawn(self, view: str) -> tuple[list[tuple[complex, complex]], Drawing]:
        variant = one_variant("four_bar_with_sleeve", {**self.DATA, **self.WORDS})
        motion = solve_variants([variant], 2)
        module = velocity_plan if view == "v" else acceleration_plan
        drawing = module.draw(variant, motion, 0, asked_quantities(variant), EN)
        scale = drawing.scale / 100
        found = [((a - drawing.origin) / scale, (b - drawing.origin) / scale) for a, b in arrows(drawing, Layer.VECTOR)]
        return found, drawing

    def one(self, found: list[tuple[complex, complex]], start: complex, length: float, off: float) -> complex:
        """The end of the only arrow from a place with a printed length."""
        ends = [b for a, b in found if abs(a - start) < 2.0 and abs(abs(b - a) - length) < off * length]
        assert len(ends) == 1, (start, length, found)
        return ends[0]

    def test_velocity_plan(self) -> None:
        found, _ = self.drawn("v")
        a = self.one(found, 0, 120, 1e-3)
        assert near(a, 120j * self.CRANK, 1e-6)  # counter-clockwise, perpendicular to the crank
        b = self.one(found, 0, 109.7, 1e-3)
        assert abs(self.one(found, a, 137.2, 1e-3) - b) < 1e-6
        tr = self.one(found, 0, 60, 0.01)
        assert near(tr, 60j * self.CRANK, 0.01)
        d = self.one(found, b, 54.4, 0.01)
        assert abs(self.one(found, tr, 58.4, 0.01) - d) < 1e-6
        assert near((d - tr) / abs(d - tr), -self.CRANK, 1e-6)  # from D to O

    def test_acceleration_plan(self) -> None:
        found, _ = self.drawn("a")
        a = self.one(found, 0, 360, 1e-3)
        assert near(a, -360 * self.CRANK, 1e-6)
        b = self.one(found, 0, 380, 2e-3)
        middle = self.one(found, 0, 280, 2e-3)
        assert abs(self.one(found, middle, 257, 2e-3) - b) < 1e-6
        tr = self.one(found, 0, 180, 0.01)
        assert near(tr, -180 * self.CRANK, 0.01)
        known = self.one(found, tr, 350.2, 0.01)
        assert near((known - tr) / abs(known - tr), -1j * self.CRANK, 1e-6)  # v_rel turned with the crank
        d = self.one(found, known, 464, 0.01)
        normal = self.one(found, b, 29.9, 0.015)
        assert any(abs(p - normal) < 1e-6 and abs(q - d) < 1e-6 for p, q in found)


@pytest.mark.parametrize("order", [1, 2])
@pytest.mark.parametrize(("name", "form"), FORMS)
def test_letters_find_room_and_the_scale_is_true(name: str, form: str, order: int) -> None:
    for variant, _, _, drawing in drawings(name, form, order):
        seen = inspect_labels(drawing)
        assert not seen.overlaps
        assert not seen.outside
        (label,) = [label for label in drawing.labels if isinstance(label.formula, Measured)]
        assert isinstance(label.formula, Measured)
        length = variant.family.length_unit
        printed = unit(f"{length}/s" + ("^2" if order == 2 else ""))
        assert to_plain(label.formula.unit).replace("²", "^2") == printed.name
        value = float(label.formula.number.text)
        bars = [
            line
            for line in drawing.lines
            if isinstance(line, Path) and line.layer == Layer.MARK and line.weight == THIN and len(line.points) == 2
        ]
        lengths = [abs(bar.points[1] - bar.points[0]) / drawing.scale for bar in bars]
        wanted = value / float(1 / printed.factor)
        assert min(abs(found - wanted) for found in lengths) < 1e-9 * wanted
        assert f"{value:e}"[0] in "125"


def test_both_languages_draw_the_same_arrows() -> None:
    variants, motion, asked = variants_of("slotted_rocker", "swinging", 1)
    found = [acceleration_plan.draw(variants[0], motion, 0, asked, load_language(name)) for name in languages()]
    words = [{to_plain(label.formula) for label in drawing.labels} for drawing in found]
    assert any("пер" in text for text in words[languages().index("ru")])
    assert any("tr" in text for text in words[languages().index("en")])
    for drawing in found[1:]:
        scale = drawing.scale / found[0].scale
        assert len(arrows(drawing, Layer.VECTOR)) == len(arrows(found[0], Layer.VECTOR))
        assert scale == pytest.approx(1, rel=0.2)


def test_instantaneous_translation_makes_one_point_of_two() -> None:
    # M28: the velocities of A and B are equal.
    data = {"OA": 20, "AB": 40, "BC": 34.6, "phi": 90, "beta": 60, "omega_OA": 2, "epsilon_OA": 0}
    variant = one_variant(
        "slider_crank_with_second_rod",
        {**data, "place": "same_side", "sense": "counter_clockwise"},
        form="perpendicular",
    )
    motion = solve_variants([variant], 2)
    drawing = velocity_plan.draw(variant, motion, 0, asked_quantities(variant), EN)
    texts = {to_plain(label.formula) for label in drawing.labels}
    assert "a, b" in texts
    assert "v_A = v_B" in texts


def test_no_plan_without_a_motion() -> None:
    variants, solved_motion, asked = variants_of("four_bar", "crank", 1)
    motion = replace(solved_motion, outcome=np.array([int(Outcome.NOT_ASSEMBLED)], dtype=np.int8))
    for view in (velocity_plan, acceleration_plan):
        with pytest.raises(InputError, match="no motion to draw"):
            view.draw(variants[0], motion, 0, asked, EN)


def test_round_lengths() -> None:
    assert [float(round_length(x)) for x in (1.0, 1.99, 2.0, 4.9, 0.07, 730.0)] == [1, 1, 2, 2, 0.05, 500]
