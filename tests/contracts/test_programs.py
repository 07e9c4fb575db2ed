"""The program of a form and the solver: the same bits, for every form, alone and in batches, valid or not."""

from __future__ import annotations

from collections.abc import Iterator

import numpy as np
import pytest
from numpy.typing import NDArray

from tests.tools import NIGHTLY
from variantgen.families.family import Form
from variantgen.families.form_motion import recorded_program
from variantgen.families.parameters.draw_rules import frame
from variantgen.families.reading.folders import family_names
from variantgen.families.reading.load import load_family
from variantgen.mechanism.motion import Motion
from variantgen.mechanism.outcome import Outcome
from variantgen.mechanism.program.program import MotionProgram
from variantgen.mechanism.rows import Frame
from variantgen.mechanism.solving.solve import solve_equations

MANY, ALONE = (2000, 400) if NIGHTLY else (300, 40)
TABLES = ("z", "v", "a", "omega", "epsilon")


def any_values(form: Form, size: int) -> dict[str, NDArray[np.float64]]:
    """Values of the grids in any combination, some of them a little beside; angles at and near right angles, so that
    dead points, points that coincide, and mechanisms that cannot be put together are among the variants.
    """
    random = np.random.default_rng(size)
    found = {}
    for name, parameter in form.parameters.items():
        values = np.asarray(parameter.si, dtype=float)[random.integers(0, len(parameter.si), size)]
        if parameter.unit is not None and parameter.unit.dimension == (0, 0):
            upright = 0.5 * np.pi * random.integers(0, 5, size)
            values = np.where(random.random(size) < 0.3, upright, values)
        beside = random.choice([0.0, 1e-15, 1e-12, 1e-9, 1e-6], size) * random.choice([1.0, -1.0], size)
        found[name] = values * (1.0 + np.where(random.random(size) < 0.3, beside, 0.0))
    return found


def both(
    form: Form, program: MotionProgram, values: dict[str, NDArray[np.float64]], pose: Frame | None
) -> list[Motion]:
    """The motion by the solver and by the program."""
    scene = form.scene(form.values(values), pose)
    inputs = [values[name] for name in form.parameters] + ([pose.turn, pose.sense] if pose else [])
    found = program.motion(scene, inputs)
    assert found is not None, "these are arrays of doubles, and no number of them is infinite"
    with np.errstate(all="ignore"):
        return [solve_equations(scene, 2, form.plan), found]


def numbers(motion: Motion) -> Iterator[tuple[str, str, str, bytes]]:
    """All arrays with their names, bit by bit: a negative zero is another number than zero."""
    tables = {name: getattr(motion, name) for name in TABLES}
    tables[""] = {"outcome": motion.outcome, "transmission": motion.transmission}
    for table, items in tables.items():
        for name, x in items.items():
            yield f"{table} {name}", str(x.shape), str(x.dtype), x.tobytes()


@pytest.mark.parametrize("name", family_names())
def test_a_program_gives_the_bits_of_the_solver(name: str) -> None:
    random = np.random.default_rng(7)
    for form in load_family(name).forms.values():
        values = any_values(form, MANY)
        sense, turns = random.choice([1, -1], MANY), random.integers(0, 4, MANY)
        for posed in (False, True):
            program = recorded_program(form, posed, 2)
            assert (program is None) == bool(form.conditions), "only the search for a place depends on numbers"
            if program is None:
                continue
            solved, found = both(form, program, values, frame(sense, turns) if posed else None)
            assert list(numbers(found)) == list(numbers(solved))
            for i in range(ALONE):
                one = {key: x[i : i + 1] for key, x in values.items()}
                solved, found = both(form, program, one, frame(sense[i : i + 1], turns[i : i + 1]) if posed else None)
                assert list(numbers(found)) == list(numbers(solved))


def test_the_values_have_every_outcome() -> None:
    outcomes = set()
    for name, own in (("four_bar", "crank"), ("slider_crank", "driven_by_slider"), ("scotch_yoke", "oblique")):
        form = load_family(name).forms[own]
        program = recorded_program(form, False, 2)
        assert program is not None
        outcomes |= {Outcome(int(n)) for n in both(form, program, any_values(form, MANY), None)[1].outcome}
    assert outcomes == set(Outcome)
