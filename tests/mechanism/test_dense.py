"""One dense linear system per variant, against what was computed by hand."""

from __future__ import annotations

import numpy as np
import pytest
from msgspec.structs import replace

from tests.solved_cases import every_case
from variantgen.families.family import Family
from variantgen.families.quantities import parse_quantity
from variantgen.families.reading.cases import Case
from variantgen.mechanism.motion import Motion
from variantgen.mechanism.solving.dense import DenseSystem

CASES = every_case()


def by_dense_system(motion: Motion) -> Motion:
    system = DenseSystem(motion)
    speeds = system.solve(1)
    gains = system.solve(2, speeds)
    return replace(motion, v=speeds.points, a=gains.points, omega=speeds.bodies, epsilon=gains.bodies)


@pytest.mark.parametrize(("family", "case"), CASES, ids=[f"{family.name}-{case.id}" for family, case in CASES])
def test_worked_cases(family: Family, case: Case) -> None:
    motion = by_dense_system(case.motion())
    scale = max(abs(value) for value in case.exact.values())
    for name, wanted in case.exact.items():
        quantity = parse_quantity(name, case.form.sample)
        value = quantity.unit(family.length_unit).from_si(float(quantity.value(motion)[0]))
        assert (abs(value) if case.magnitudes else value) == pytest.approx(wanted, abs=1e-9 * scale), name


def test_a_dead_point_is_an_error_of_the_algebra() -> None:
    _, case = next((f, c) for f, c in CASES if c.id == "M26")
    motion = case.motion()
    line = {"O": 0, "A": 1, "M": 1.5, "B": 2, "C": 4}
    stretched = {name: np.array([complex(line[name])]) for name in motion.z}
    with pytest.raises(np.linalg.LinAlgError):
        DenseSystem(replace(motion, z=stretched)).solve(1)
