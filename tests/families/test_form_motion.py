"""The motion of a form: by the solver at first, by its program from then on, and always the same."""

from __future__ import annotations

import numpy as np
import pytest
from msgspec.structs import replace

from variantgen.families import form_motion
from variantgen.families.form_motion import motion_of
from variantgen.families.parameters.draw_rules import frame
from variantgen.families.reading.load import load_family
from variantgen.mechanism.outcome import Outcome
from variantgen.mechanism.program.program import MotionProgram
from variantgen.mechanism.solving.solve import solve, solve_equations


@pytest.fixture
def made(monkeypatch: pytest.MonkeyPatch) -> list[int]:
    """How many variants each call of a program had."""
    calls: list[int] = []
    own = MotionProgram.motion

    def motion(self: MotionProgram, scene: object, inputs: list[np.ndarray]) -> object:
        calls.append(np.size(inputs[0]))
        return own(self, scene, inputs)  # type: ignore[arg-type]

    monkeypatch.setattr(MotionProgram, "motion", motion)
    return calls


def upright(size: int) -> dict[str, np.ndarray]:
    """A crank of 3 m upright at 2 rad/s, a rod of 5 m.

    So A is at 3i and B at 4, both have the velocity -6, and the rod does not turn; ``a_A = -12i`` and
    ``a_B = a_A + i epsilon (4 - 3i)`` is real with epsilon = 3: a_B = 9.
    """
    values = {"OA": 3.0, "AB": 5.0, "phi": 0.5 * np.pi, "sense": 1.0, "omega_OA": 2.0, "epsilon_OA": 0.0}
    return {name: np.full(size, value) for name, value in values.items()}


@pytest.mark.parametrize("size", [1, 3])
def test_the_program_takes_over_and_nothing_changes(made: list[int], size: int) -> None:
    form = replace(load_family("slider_crank").forms["central"])  # which remembers nothing yet
    for count in range(60):
        motion = motion_of(form, upright(size), frame([1] * size, [0] * size))
        assert len(made) == max(0, count + 1 - form_motion.OFTEN)
        assert motion.outcome.tolist() == [Outcome.SOLVED] * size
        assert motion.omega["AB"].tolist() == [0.0] * size
        assert motion.z["B"] == pytest.approx(np.full(size, 4.0 + 0j), abs=1e-14)
        assert motion.v["B"] == pytest.approx(np.full(size, -6.0 + 0j), abs=1e-14)
        assert motion.a["B"] == pytest.approx(np.full(size, 9.0 + 0j), abs=1e-13)
        assert motion.epsilon["AB"] == pytest.approx(np.full(size, 3.0), abs=1e-13)


def test_each_order_and_a_plain_frame_have_a_program_of_their_own(made: list[int]) -> None:
    form = replace(load_family("slider_crank").forms["central"])
    for _ in range(form_motion.OFTEN + 1):
        for order, tables in ((0, 0), (1, 1), (2, 2)):
            motion = motion_of(form, upright(2), order=order)
            assert (bool(motion.v) + bool(motion.a)) == tables
            assert motion.transmission == pytest.approx(np.full(2, 0.8 if order else 1.0))
    assert len(made) == 3


def test_a_dead_point_is_one_for_the_program_too(made: list[int]) -> None:
    form = replace(load_family("slider_crank").forms["driven_by_slider"])
    values = {name: np.full(3, float(p.si[0])) for name, p in form.parameters.items()}
    values["phi"] = np.array([0.0, 1e-12, 1.0])  # crank and rod in line, all but in line, at an angle
    outcomes = [motion_of(form, values).outcome.tolist() for _ in range(form_motion.OFTEN + 1)]
    assert made == [3]
    assert outcomes == [[Outcome.DEAD_POINT, Outcome.DEAD_POINT, Outcome.SOLVED]] * len(outcomes)


def test_what_rounding_decides_is_marked_behind_the_program_too(made: list[int]) -> None:
    form = replace(load_family("parallelogram_with_disc").forms["fixed_point"])
    near = np.geomspace(1e-9, 1e-3, 40)  # rad from the change point, where all links of a parallelogram are in line
    values = {name: np.full(near.size, float(p.si[0])) for name, p in form.parameters.items()} | {"phi": near}
    outcomes = [motion_of(form, values).outcome.tolist() for _ in range(form_motion.OFTEN + 1)]
    assert made == [near.size]
    assert outcomes[-1] == outcomes[0]
    scene = form.scene(form.values(values))
    assert outcomes[0] == solve(scene, 2, form.plan).outcome.tolist()
    assert outcomes[0] != solve_equations(scene, 2, form.plan).outcome.tolist()


def test_numbers_in_place_of_arrays_go_to_the_solver() -> None:
    form = replace(load_family("slider_crank").forms["central"])
    values = {name: float(x[0]) for name, x in upright(1).items()}
    for _ in range(form_motion.OFTEN + 1):
        assert motion_of(form, values).v["B"] == pytest.approx([-6.0])


def test_a_plate_on_three_rods_has_no_program(made: list[int]) -> None:
    (form,) = load_family("three_rod_plate").forms.values()
    values = {name: np.array([float(p.si[0])]) for name, p in form.parameters.items()}
    first = motion_of(form, values, order=0)
    for _ in range(form_motion.OFTEN + 1):
        assert motion_of(form, values, order=0).z == first.z
    assert not made
