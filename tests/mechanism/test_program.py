"""Recording: what computations leave behind, and the two ways to write it, by numbers worked out by hand."""

from __future__ import annotations

from collections.abc import Callable, Sequence
from typing import Any

import numpy as np
import pytest

from variantgen.mechanism.arithmetic import from_parts, unit_vector
from variantgen.mechanism.motion import Motion
from variantgen.mechanism.program.program import MotionProgram
from variantgen.mechanism.program.recording import INPUT, Recording
from variantgen.mechanism.scene import Scene

NO_SCENE = Scene({}, {})


def program(types: Sequence[type], rates: Callable[..., Any]) -> MotionProgram:
    """The program of a "motion" whose angular velocities are what is to be worked out."""

    def solved(inputs: Sequence[Any]) -> Motion:
        outcome = np.where(inputs[0] > 1e6, np.int8(1), np.int8(0))
        found = dict(enumerate(rates(*inputs)))
        return Motion(NO_SCENE, outcome, np.ones(1), {}, {}, {}, {str(k): x for k, x in found.items()}, {})

    return MotionProgram(types, solved)


def results(made: MotionProgram, *inputs: Sequence[complex]) -> list[list[complex]]:
    """What it gives for a batch; alone each of the batch gives the same."""
    arrays = [np.array(x) for x in inputs]
    motion = made.motion(NO_SCENE, arrays)
    assert motion is not None
    for i in range(len(arrays[0])):
        alone = made.motion(NO_SCENE, [x[i : i + 1] for x in arrays])
        assert alone is not None
        assert [x.tolist() for x in alone.omega.values()] == [[x[i]] for x in motion.omega.values()]
        assert alone.outcome.tolist() == [motion.outcome[i]]
    return [x.tolist() for x in motion.omega.values()]


def test_operators_and_functions_of_numpy_are_repeated() -> None:
    made = program([float, float], lambda a, b: [a * b - a / b, np.maximum(a, b), np.sqrt(a) + b**2, -abs(b)])
    assert results(made, [4.0, 9.0], [2.0, -3.0]) == [[6.0, -24.0], [4.0, 9.0], [6.0, 12.0], [-2.0, -3.0]]


def test_complex_numbers_and_their_parts() -> None:
    def rates(x: Any, z: Any) -> list[Any]:
        w = from_parts(x, z.imag)
        return [np.real(1j * z), w.imag, np.abs(z), np.real(np.conj(z) * w), np.imag(z * (3 + 4j))]

    # x = 2, z = 3 + 4i, w = 2 + 4i; then x = 1, z = i, w = 1 + i
    found = results(program([float, complex], rates), [2.0, 1.0], [3 + 4j, 1j])
    assert found == [[-4.0, -1.0], [4.0, 1.0], [5.0, 1.0], [22.0, 1.0], [24.0, 3.0]]


def test_choices_by_flags() -> None:
    def rates(a: Any, b: Any) -> list[Any]:
        small = (a < b) & ~(a < 0.0)
        return [np.where(small, a, 7.0), np.where(small, 0.0, b), np.where(small, a, b), np.where(small, 1.0, 2.0)]

    found = results(program([float, float], rates), [1.0, 5.0, -1.0], [3.0, 4.0, 2.0])
    assert found == [[1.0, 7.0, 7.0], [0.0, 4.0, 2.0], [1.0, 4.0, 2.0], [1.0, 2.0, 2.0]]


def test_what_is_no_number_is_the_smallest_of_nothing() -> None:
    made = program([float, float], lambda a, b: [np.minimum(a * 0.0, b), np.maximum(b, a * 0.0)])
    motion = made.motion(NO_SCENE, [np.array([np.inf]), np.array([1.0])])
    assert motion is not None
    assert np.isnan([motion.omega["0"][0], motion.omega["1"][0]]).all()


def test_one_variant_goes_back_to_numpy_where_python_stops() -> None:
    made = program([float, float], lambda a, b: [a / b])
    assert made.motion(NO_SCENE, [np.array([1.0]), np.array([0.0])]) is None


@pytest.mark.parametrize(
    "other",
    [
        [1.0, 2.0],
        [np.array([1.0]), np.array([1.0, 2.0])],
        [np.array([1]), np.array([1])],
        [np.array([1.0], dtype=np.longdouble)] * 2,
        [np.ones((1, 1))] * 2,
        [np.ones(0)] * 2,
    ],
    ids=["numbers", "shapes", "whole", "more digits", "tables", "nothing"],
)
def test_other_inputs_are_left_to_the_solver(other: list[Any]) -> None:
    assert program([float, float], lambda a, b: [a + b]).motion(NO_SCENE, other) is None


own = np.frompyfunc(abs, 1, 1)  # a function of arrays that numpy has not


@pytest.mark.parametrize("ask", [bool, float, np.asarray, lambda x: [1.0, 2.0][x], np.linalg.norm, own])
def test_a_computation_that_asks_for_values_is_refused(ask: Callable[[Any], Any]) -> None:
    with pytest.raises(TypeError):
        program([float], lambda a: [a if ask(a) else -a])


def test_the_same_operation_is_recorded_once_and_what_nobody_needs_is_left_out() -> None:
    recording = Recording()
    a, b = (recording.input(place, float) for place in (0, 1))
    first, second, _ = a * b + 1.0, 2.0 * (a * b), np.cos(a)
    needed = recording.needed([first.operation, second.operation])
    assert [operation.name for operation in needed] == [INPUT, INPUT, "multiply", "add", "multiply"]
    assert (1.0 * a).operation is a.operation
    assert np.maximum(a, a).operation is a.operation


def test_zero_and_negative_zero_are_two_constants() -> None:
    found = results(program([float], lambda a: [a + 0.0, a + -0.0, a * 0.0, a * -0.0]), [-0.0])
    assert [str(x[0]) for x in found] == ["0.0", "-0.0", "-0.0", "0.0"]


def test_unit_vectors_stay_exact_at_right_angles() -> None:
    found = results(program([float], lambda a: [unit_vector(a).real, unit_vector(a).imag]), [0.5 * np.pi, np.pi])
    assert found == [[0.0, -1.0], [1.0, 0.0]]


def test_results_of_a_batch_are_arrays_of_their_own() -> None:
    made = program([float, float], lambda a, b: [a + b, (a + b) * b, (a + b) * b - a])
    first = made.motion(NO_SCENE, [np.array([1.0, 2.0]), np.array([3.0, 4.0])])
    second = made.motion(NO_SCENE, [np.array([5.0, 6.0]), np.array([7.0, 8.0])])
    assert first is not None
    assert second is not None
    assert [x.tolist() for x in first.omega.values()] == [[4.0, 6.0], [12.0, 24.0], [11.0, 22.0]]
    assert [x.tolist() for x in second.omega.values()] == [[12.0, 14.0], [84.0, 112.0], [79.0, 106.0]]
