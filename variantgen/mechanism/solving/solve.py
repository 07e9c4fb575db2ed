"""Positions, velocities and accelerations of a scene, vectorised over a batch of variants."""

from __future__ import annotations

from collections.abc import Mapping, Sequence
from functools import reduce
from typing import Any

import numpy as np
from msgspec.structs import replace
from numpy.typing import NDArray

from variantgen.mechanism.arithmetic import Complex, Flags, Real
from variantgen.mechanism.assembly import assemble
from variantgen.mechanism.constructions.near import Near
from variantgen.mechanism.motion import Motion
from variantgen.mechanism.outcome import Outcome
from variantgen.mechanism.rows import Placement, Speeds
from variantgen.mechanism.scene import Scene
from variantgen.mechanism.solving.digits import decided_by_rounding, near_singular
from variantgen.mechanism.solving.forms import QuadraticTerms, VelocityForms
from variantgen.mechanism.solving.linear import ScaledDeterminant, ScaledEquation, solve_block
from variantgen.mechanism.solving.memory import LARGE, keep_freed_memory
from variantgen.mechanism.solving.structure import Closure, Plan, analyse


def solve(scene: Scene, order: int = 2, plan: Plan | None = None) -> Motion:
    """Solve a scene: ``order`` 0 gives positions, 1 also velocities, 2 also accelerations.

    ``plan`` is the scene's structure if it is known already. Raises InputError for a scene that is under- or
    over-determined; ``Motion.outcome`` says what happened to single variants.
    """
    plan = plan or analyse(scene)
    return mark_undecidable(solve_equations(scene, order, plan), plan, order)


def solve_equations(scene: Scene, order: int, plan: Plan) -> Motion:
    """The motion as it comes out, whether doubles can tell it or not: what a program of a form repeats."""
    motion = _batch(scene, *place(scene, plan))
    return add_speeds(motion, plan, order) if order else motion


def mark_undecidable(motion: Motion, plan: Plan, order: int) -> Motion:
    """The motion with the variants marked as DEAD_POINT whose result changes by more than 4 % under input rounding."""
    near = near_singular(motion)
    if not near.size:
        return motion
    few = motion.take(near)

    def again(scene: Scene) -> Motion:
        scene = from_picture(scene, {name: few.frame.unplace(z) for name, z in few.z.items()})
        return solve_equations(scene, order, plan)

    outcome = motion.outcome.copy()
    outcome[near[decided_by_rounding(few, again)]] = Outcome.DEAD_POINT
    return replace(motion, outcome=outcome)


def place(scene: Scene, plan: Plan) -> tuple[dict[str, Complex], Real]:
    """Positions on paper (m) and outcomes; the first failing construction decides the outcome."""
    at: dict[str, Complex] = {}
    outcome: Real = 0.0
    for name in (*plan.placing, *plan.together):
        outcome = _construct(scene, name, at, outcome)
    if plan.together:
        picture = {name: at.pop(name) for name in plan.together}
        places, found = assemble(picture, at, scene.conditions)
        at.update(places)
        outcome = np.where((outcome == 0) & np.logical_not(found), float(Outcome.NOT_ASSEMBLED), outcome)
    for name in plan.later:
        outcome = _construct(scene, name, at, outcome)
    placed = {name: scene.frame.place(z) for name, z in at.items()}
    for joint in scene.joints:
        sound = joint.sound(Placement(placed, scene.frame))
        if sound is not True:
            outcome = np.where((outcome == 0) & np.logical_not(sound), float(Outcome.DEGENERATE), outcome)
    return placed, outcome


def from_picture(scene: Scene, z: Mapping[str, Complex]) -> Scene:
    """The scene with known places (m, scene frame) as the picture from which its conditions are met."""
    near = {name: Near(np.real(z[name]), np.imag(z[name])) for name, p in scene.points.items() if isinstance(p, Near)}
    return replace(scene, points={**scene.points, **near}) if near else scene


def _construct(scene: Scene, name: str, at: dict[str, Complex], outcome: Real) -> Real:
    """Place one point; returns the outcomes so far."""
    construction = scene.points[name]
    at[name], exists = construction.place(at)
    if exists is True:
        return outcome
    return np.where((outcome == 0) & np.logical_not(exists), float(construction.failure), outcome)


def _batch(scene: Scene, places: Mapping[str, Complex], outcome: Real) -> Motion:
    drives = [rate for driver in scene.drivers for order in (1, 2) for rate in driver.rates(order)]
    shape = np.broadcast_shapes((1,), np.shape(outcome), *(np.shape(x) for x in (*places.values(), *drives)))
    if shape[0] >= LARGE:
        keep_freed_memory()
    return Motion(
        scene,
        _full(outcome, shape).astype(np.int8),
        np.ones(shape),
        {name: _full(z, shape, np.complex128) for name, z in places.items()},
        {},
        {},
        {},
        {},
    )


def add_speeds(motion: Motion, plan: Plan, order: int) -> Motion:
    """The motion with velocities (order 1) and accelerations (order 2) added to its positions."""
    equations = Equations(motion, plan)
    moving = equations.motion
    return equations.accelerated(Speeds(moving.v, moving.omega)) if order > 1 else moving


class Equations:
    """The equations of velocities and accelerations of a placed batch; ``motion`` has the velocities added."""

    def __init__(self, motion: Motion, plan: Plan) -> None:
        scene, shape = motion.scene, motion.outcome.shape
        self._plan, self._at = plan, Placement(motion.z, scene.frame)
        self._rows = [constraint.rows(self._at) for constraint in scene.constraints]
        self._velocities = VelocityForms(plan, self._rows, motion.z)
        self._assembly = [self._velocities.equation(equation) for equation in plan.equations]
        rates = _rates(scene, plan, 1)
        values, self._sines = _solve_blocks(plan, self._assembly, [(rate, np.abs(rate)) for rate in rates])
        regular: Flags = reduce(np.logical_and, (sine.regular for sine in self._sines), np.True_)
        outcome = np.where((motion.outcome == 0) & ~regular, np.int8(Outcome.DEAD_POINT), motion.outcome)
        self.motion = replace(
            motion,
            outcome=outcome.astype(np.int8),
            transmission=_full(reduce(np.minimum, (sine.value for sine in self._sines), 1.0), shape),
            v={name: _full(x, shape, np.complex128) for name, x in self._velocities.points(values).items()},
            omega={body: _full(values[u], shape) for body, u in plan.omega.items()},
        )

    def accelerated(self, known: Speeds) -> Motion:
        """The motion with the accelerations that go with known velocities.

        These may be other than its own: that shows the effect of mistakes in them. Of several such, in arrays of shape
        (mistakes, N), the accelerations have the same shape.
        """
        motion, plan = self.motion, self._plan
        shape = np.broadcast_shapes(
            motion.outcome.shape, *(np.shape(x) for x in (*known.v.values(), *known.omega.values()))
        )
        extra = [constraint.quadratic(self._at, known) for constraint in motion.scene.constraints]
        drifts = QuadraticTerms(self._velocities, self._rows, extra, known.omega)
        right = [drifts.side(*item) for item in zip(plan.equations, _rates(motion.scene, plan, 2), strict=True)]
        values, _ = _solve_blocks(plan, self._assembly, right, self._sines)
        return replace(
            motion,
            a={name: _full(x, shape, np.complex128) for name, x in self._velocities.points(values, drifts).items()},
            epsilon={body: _full(values[u], shape) for body, u in plan.omega.items()},
        )


def _full(x: Complex, shape: tuple[int, ...], least: type = np.float64) -> NDArray[Any]:
    """An array over the batch, of doubles (``least``) or of what the scene is given in if that has more digits."""
    fits = getattr(x, "shape", None) == shape and x.dtype == least
    return x if fits else np.broadcast_to(np.asarray(x, dtype=np.result_type(x, least)), shape)


def _rates(scene: Scene, plan: Plan, order: int) -> list[Real]:
    return [
        scene.constraints[e.constraint].rates(order)[e.row] if not isinstance(e, Closure) else 0.0
        for e in plan.equations
    ]


def _solve_blocks(
    plan: Plan, assembly: list[ScaledEquation], right: list[tuple[Real, Real]], known: Sequence[ScaledDeterminant] = ()
) -> tuple[dict[int, Real], list[ScaledDeterminant]]:
    """Values of all unknowns, block by block, and how regular each block is (``known`` from an earlier solution)."""
    values: dict[int, Real] = {}
    sines: list[ScaledDeterminant] = []
    for number, block in enumerate(plan.blocks):
        sides = []
        for e in block.equations:
            total, size = right[e]
            for unknown, c in assembly[e].coefficients.items():
                if unknown in values:
                    term = c * values[unknown]
                    total, size = total - term, size + assembly[e].sizes[unknown] * np.abs(values[unknown])
            sides.append((total, size))
        before = known[number] if known else None
        found, sine = solve_block([assembly[e] for e in block.equations], block.unknowns, sides, before)
        values.update(found)
        sines.append(sine)
    return values, sines
