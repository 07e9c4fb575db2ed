"""Every joint and driver has a symbol of the same stem, an equation in its docstring, rows that match its residual."""

from __future__ import annotations

import importlib

import numpy as np
import pytest

from tests.joint_scenes import SCENES as JOINT_SCENES
from variantgen.families.reading.folders import family_names
from variantgen.families.reading.load import load_family
from variantgen.mechanism.component import discover, field_specs
from variantgen.mechanism.rows import Placement, ScalarRow
from variantgen.mechanism.scene import Scene
from variantgen.mechanism.solving.solve import solve
from variantgen.testing.linkages import four_bar, sleeve_on_crank, slider_crank, spool, wheel

JOINTS, DRIVERS = (discover(f"variantgen.mechanism.{folder}") for folder in ("joints", "drivers"))
SCENES = [
    four_bar(0.2, 0.6, 0.5, 0.7, 1.0, 2.0, 3.0),
    slider_crank(0.2, 0.6, 0.1, 1.0, 2.0, -1.0, 0.4),
    sleeve_on_crank(0.4, 0.2, 0.6, 0.3, 1.0, 2.0, 1.0),
    wheel(0.5, 1.0, 2.0),
    spool(0.2, 0.5, 1.0, 2.0),
    *JOINT_SCENES.values(),
]


def test_every_kind_has_a_scene() -> None:
    used = {type(item) for scene in SCENES for item in (*scene.constraints, *scene.conditions)}
    conditions = discover("variantgen.mechanism.conditions")
    assert used >= {*JOINTS.values(), *DRIVERS.values(), *conditions.values()}


def test_every_joint_appears_in_three_families_and_every_driver_in_one() -> None:
    homes: dict[type, set[str]] = {}
    for name in family_names():
        for form in load_family(name).forms.values():
            for template in (*form.joints, *form.drivers):
                homes.setdefault(template.component, set()).add(name)
    for kind in JOINTS.values():
        assert len(homes.get(kind, ())) >= 3, (kind, homes.get(kind))
    for kind in DRIVERS.values():
        assert homes.get(kind), kind


@pytest.mark.parametrize("stem", [*JOINTS, *DRIVERS])
def test_symbol_of_the_same_stem(stem: str) -> None:
    assert callable(importlib.import_module(f"variantgen.figure.symbols.{stem}").draw)


@pytest.mark.parametrize("kind", [*JOINTS.values(), *DRIVERS.values()])
def test_docstring_states_the_constraint(kind: type) -> None:
    assert kind.__doc__
    assert "=" in kind.__doc__


@pytest.mark.parametrize("package", ["constructions", "conditions", "joints", "drivers"])
def test_fields_say_what_they_expect(package: str) -> None:
    for kind in discover(f"variantgen.mechanism.{package}").values():
        for spec in field_specs(kind):
            assert spec.ref or spec.dimension or spec.flag or spec.part, (kind, spec.name)


@pytest.mark.parametrize("scene", SCENES)
def test_rows_are_the_derivative_of_the_residual(scene: Scene) -> None:
    """Move every point and body at random: the residuals change at the rate that the rows say."""
    motion = solve(scene)
    start = Placement({name: z.astype(complex) for name, z in motion.z.items()}, scene.frame)
    rng = np.random.default_rng(5)
    velocity = {name: complex(*rng.normal(size=2)) for name in motion.z}
    turning = {body: float(rng.normal()) for body in scene.bodies}
    for constraint in scene.constraints:
        fixed_points = _immobile(scene)

        def moved(h: float, still: frozenset[str] = fixed_points) -> Placement:
            z = {name: start.z[name] + (0 if name in still else h * velocity[name]) for name in start.z}
            return Placement(z, scene.frame, {body: np.array([h * rate]) for body, rate in turning.items()})

        h = 1e-6
        slopes = [
            (np.asarray(a) - np.asarray(b)) / (2 * h)
            for a, b in zip(
                constraint.residual(moved(h), start, np.zeros(1)),
                constraint.residual(moved(-h), start, np.zeros(1)),
                strict=True,
            )
        ]
        said: list[float] = []
        for shape, row in zip(constraint.shapes(), constraint.rows(start), strict=True):
            if isinstance(row, ScalarRow):
                total = sum((np.conj(c) * velocity[p]).real for p, c in row.points.items())
                said.append(total + sum(k * turning[b] for b, k in row.bodies.items()))
            else:
                pole = velocity[shape.pole] if shape.pole else 0.0
                gap = velocity[row.point] - pole - sum(c * turning[b] for b, c in row.bodies.items())
                said += [np.real(gap), np.imag(gap)]
        # The residual may count the other way round (a length that shrinks).
        assert np.allclose(np.abs(np.ravel(slopes)), np.abs(np.ravel(said)), rtol=1e-6, atol=1e-7), constraint


def _immobile(scene: Scene) -> frozenset[str]:
    """Places that are no material points (the fixed pulley of a thread, the contact of a wheel)."""
    material = {p for members in scene.bodies.values() for p in members}
    material |= {p for c in scene.constraints for shape in c.shapes() for p in shape.points}
    return frozenset(scene.points) - material
