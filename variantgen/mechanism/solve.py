"""Positions, velocities and accelerations of a scene, vectorised over a batch of variants."""

from __future__ import annotations

from collections.abc import Mapping, Sequence
from dataclasses import replace
from functools import reduce
from typing import Any

import numpy as np
from numpy.typing import NDArray

from variantgen.mechanism.arithmetic import Complex, Flags, Real
from variantgen.mechanism.assembly import assemble
from variantgen.mechanism.constructions.near import Near
from variantgen.mechanism.linear import Assembly, Sine, solve_block
from variantgen.mechanism.motion import Motion
from variantgen.mechanism.outcome import Outcome
from variantgen.mechanism.rows import Placement, Row, ScalarRow, Speeds, VectorRow
from variantgen.mechanism.scene import Scene
from variantgen.mechanism.structure import Carry, Closure, Equation, Lead, Loose, Plan, Slide, Step, analyse

Form = dict[int, Complex]


def solve(scene: Scene, order: int = 2, plan: Plan | None = None) -> Motion:
    """Solve a scene: ``order`` 0 gives positions, 1 also velocities, 2 also accelerations.

    ``plan`` is the scene's structure if it is known already. Raises InputError for a scene that is under- or
    over-determined; what happens to single variants is told by ``Motion.outcome``.
    """
    plan = plan or analyse(scene)
    places, outcome = place(scene, plan)
    motion = _batch(scene, places, outcome)
    return add_speeds(motion, plan, order) if order else motion


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
    return Motion(
        scene,
        np.broadcast_to(np.asarray(outcome, dtype=np.int8), shape),
        np.ones(shape),
        {name: _full(z, shape, np.complex128) for name, z in places.items()},
        {},
        {},
        {},
        {},
    )


def add_speeds(motion: Motion, plan: Plan, order: int) -> Motion:
    """The motion with velocities (order 1) and accelerations (order 2) added to its positions."""
    scene, shape = motion.scene, motion.outcome.shape
    at = Placement(motion.z, scene.frame)
    rows = [constraint.rows(at) for constraint in scene.constraints]
    forms = _forms(plan, rows, motion.z)
    assembly = [_equation(equation, plan, rows, forms, motion.z) for equation in plan.equations]
    rates = _rates(scene, plan, 1)
    values, sines = _solve_blocks(plan, assembly, [(rate, np.abs(rate)) for rate in rates])
    regular: Flags = reduce(np.logical_and, (sine.regular for sine in sines), np.True_)
    v = _point_rates(plan, rows, motion.z, values, {})
    omega = {body: _full(values[u], shape) for body, u in plan.omega.items()}
    outcome = np.where((motion.outcome == 0) & ~regular, np.int8(Outcome.DEAD_POINT), motion.outcome)
    motion = replace(
        motion,
        outcome=outcome.astype(np.int8),
        transmission=_full(reduce(np.minimum, (sine.value for sine in sines), 1.0), shape),
        v={name: _full(x, shape, np.complex128) for name, x in v.items()},
        omega=omega,
    )
    if order < 2:
        return motion
    speeds = Speeds(motion.v, motion.omega)
    extra = [constraint.quadratic(at, speeds) for constraint in scene.constraints]
    drift = _quadratic_terms(plan, extra, motion)
    right = [
        _acceleration_side(equation, rows, extra, drift, rate, motion)
        for equation, rate in zip(plan.equations, _rates(scene, plan, 2), strict=True)
    ]
    values, _ = _solve_blocks(plan, assembly, right, sines)
    a = _point_rates(plan, rows, motion.z, values, drift)
    return replace(
        motion,
        a={name: _full(x, shape, np.complex128) for name, x in a.items()},
        epsilon={body: _full(values[u], shape) for body, u in plan.omega.items()},
    )


def _full(x: Complex, shape: tuple[int, ...], least: type = np.float64) -> NDArray[Any]:
    """An array over the batch, of doubles (``least``) or of what the scene is given in if that has more digits."""
    return np.broadcast_to(np.asarray(x, dtype=np.result_type(x, least)), shape)


def _rates(scene: Scene, plan: Plan, order: int) -> list[Real]:
    return [
        scene.constraints[e.constraint].rates(order)[e.row] if not isinstance(e, Closure) else 0.0
        for e in plan.equations
    ]


def _through(step: Step, rows: list[tuple[Row, ...]], z: Mapping[str, Complex], plan: Plan) -> Form:
    """Coefficients that one step adds: velocity of its point less that of its pole, by unknown."""
    match step:
        case Carry(point, body, pole):
            return {plan.omega[body]: 1j * (z[point] - z[pole])}
        case Lead(_, constraint, number, _):
            row = rows[constraint][number]
            assert isinstance(row, VectorRow)
            return {plan.omega[body]: c for body, c in row.bodies.items()}
        case Slide(point, constraint, number, unknown, _):
            row = rows[constraint][number]
            assert isinstance(row, ScalarRow)
            return {unknown: -1j * row.points[point]}
        case Loose(_, x, y, _):
            return {x: 1.0, y: 1.0j}


def _form(
    step: Step, rows: list[tuple[Row, ...]], forms: Mapping[str, Form], z: Mapping[str, Complex], plan: Plan
) -> Form:
    form = dict(forms[step.pole]) if step.pole else {}
    for unknown, coefficient in _through(step, rows, z, plan).items():
        form[unknown] = form[unknown] + coefficient if unknown in form else coefficient
    return form


def _forms(plan: Plan, rows: list[tuple[Row, ...]], z: Mapping[str, Complex]) -> dict[str, Form]:
    """The velocity of each reached point as a linear form in the unknowns."""
    forms: dict[str, Form] = {}
    for step in plan.steps:
        forms[step.point] = _form(step, rows, forms, z, plan)
    return forms


def _equation(
    equation: Equation, plan: Plan, rows: list[tuple[Row, ...]], forms: Mapping[str, Form], z: Mapping[str, Complex]
) -> Assembly:
    """Coefficients of one equation by unknown, and their size before cancellation."""
    coefficients: dict[int, Real] = {}
    sizes: dict[int, Real] = {}

    def add(unknown: int, value: Real, size: Real) -> None:
        coefficients[unknown] = coefficients[unknown] + value if unknown in coefficients else value
        sizes[unknown] = sizes[unknown] + size if unknown in sizes else size

    if isinstance(equation, Closure):
        known, again = forms[equation.step.point], _form(equation.step, rows, forms, z, plan)
        for sign, form in ((1.0, known), (-1.0, again)):
            for unknown, c in form.items():
                add(unknown, sign * (np.imag(c) if equation.part else np.real(c)), np.abs(c))
        return Assembly(coefficients, sizes)
    row = rows[equation.constraint][equation.row]
    assert isinstance(row, ScalarRow)
    for point, weight in row.points.items():
        for unknown, c in forms[point].items():
            product = np.conj(weight) * c
            add(unknown, np.real(product), np.abs(product))
    for body, k in row.bodies.items():
        add(plan.omega[body], k, np.abs(k))
    return Assembly(coefficients, sizes)


def _solve_blocks(
    plan: Plan, assembly: list[Assembly], right: list[tuple[Real, Real]], known: Sequence[Sine] = ()
) -> tuple[dict[int, Real], list[Sine]]:
    """Values of all unknowns, block by block, and how regular each block is (``known`` from an earlier solution)."""
    values: dict[int, Real] = {}
    sines: list[Sine] = []
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


def _point_rates(
    plan: Plan,
    rows: list[tuple[Row, ...]],
    z: Mapping[str, Complex],
    values: Mapping[int, Real],
    drift: Mapping[str, Complex],
) -> dict[str, Complex]:
    """Velocities (or, with the quadratic terms ``drift``, accelerations) of the points, pole by pole."""
    found: dict[str, Complex] = {}
    for step in plan.steps:
        total: Complex = found[step.pole] if step.pole else 0.0
        for unknown, c in _through(step, rows, z, plan).items():
            total = total + c * values[unknown]
        found[step.point] = total + drift[f"+{step.point}"] if drift else total
    return found


def _quadratic_terms(plan: Plan, extra: list[tuple[Complex, ...]], motion: Motion) -> dict[str, Complex]:
    """Per point: under its name the whole quadratic part of its acceleration, under ``+name`` what its step adds."""
    drift: dict[str, Complex] = {}
    for step in plan.steps:
        own = _own_drift(step, extra, motion)
        drift[f"+{step.point}"] = own
        drift[step.point] = own + drift[step.pole] if step.pole else own
    return drift


def _own_drift(step: Step, extra: list[tuple[Complex, ...]], motion: Motion) -> Complex:
    match step:
        case Carry(point, body, pole):
            return -(motion.omega[body] ** 2) * (motion.z[point] - motion.z[pole])
        case Lead(_, constraint, number, _):
            return extra[constraint][number]
        case _:
            return 0.0


def _acceleration_side(
    equation: Equation,
    rows: list[tuple[Row, ...]],
    extra: list[tuple[Complex, ...]],
    drift: Mapping[str, Complex],
    rate: Real,
    motion: Motion,
) -> tuple[Real, Real]:
    """Right-hand side of one equation for accelerations, and the size of its terms."""
    if isinstance(equation, Closure):
        step = equation.step
        again = _own_drift(step, extra, motion)
        if step.pole:
            again = again + drift[step.pole]
        known = drift[step.point]
        part = np.imag if equation.part else np.real
        return part(again) - part(known), np.abs(again) + np.abs(known)
    row = rows[equation.constraint][equation.row]
    assert isinstance(row, ScalarRow)
    term = np.real(extra[equation.constraint][equation.row])
    total, size = rate - term, np.abs(rate) + np.abs(term)
    for point, weight in row.points.items():
        product = np.conj(weight) * drift[point]
        total, size = total - np.real(product), size + np.abs(product)
    return total, size
