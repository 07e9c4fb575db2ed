"""The motion of variants of a form: by the solver, and by a program of the form once that has solved often."""

from __future__ import annotations

from collections.abc import Mapping, Sequence
from typing import TYPE_CHECKING

from variantgen.families.family import Form
from variantgen.mechanism.arithmetic import Real
from variantgen.mechanism.motion import Motion
from variantgen.mechanism.rows import Frame
from variantgen.mechanism.solving.solve import mark_undecidable, solve, solve_equations

if TYPE_CHECKING:
    from variantgen.mechanism.program.program import MotionProgram
    from variantgen.mechanism.program.recording import Recorded

# So many solutions take about as much longer as their program takes to make.
OFTEN = 40


def motion_of(form: Form, parameters: Mapping[str, Real], on_paper: Frame | None = None, order: int = 2) -> Motion:
    """The motion for SI values of the parameters, arrays of shape (N,); ``order`` as :func:`solve` has it."""
    scene = form.scene(form.values(parameters), on_paper)
    posed = not scene.frame.plain
    program = _program(form, posed, order)
    if program is not None:
        inputs = [parameters[name] for name in form.parameters]
        inputs += [scene.frame.turn, scene.frame.sense] if posed else []
        motion = program.motion(scene, inputs)
        if motion is not None:
            return mark_undecidable(motion, form.plan, order)
    return solve(scene, order, form.plan)


def _program(form: Form, posed: bool, order: int) -> MotionProgram | None:
    """The program of a form that has solved so often already; None before, and where there can be none."""
    key = motion_of, posed, order
    known: int | MotionProgram | None = form.remembered.get(key, 0)
    if isinstance(known, int):
        known = form.remembered[key] = known + 1 if known < OFTEN else recorded_program(form, posed, order)
    return None if isinstance(known, int) else known


def recorded_program(form: Form, posed: bool, order: int) -> MotionProgram | None:
    """The program of a form; None where the way depends on the numbers, as in searches for a place."""
    from variantgen.mechanism.program.program import MotionProgram  # few commands solve one form so often

    names = list(form.parameters)

    def solved(inputs: Sequence[Recorded]) -> Motion:
        frame = Frame(*inputs[len(names) :])
        scene = form.scene(form.values(dict(zip(names, inputs, strict=False))), frame)
        return solve_equations(scene, order, form.plan)

    try:
        return MotionProgram([float] * len(names) + [complex, float] * posed, solved)
    except (TypeError, AttributeError):  # of numbers that are none yet, and have not all that arrays have
        return None
