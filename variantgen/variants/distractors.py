"""Wrong but plausible results: what the answers become by the mistakes that students make.

- the normal acceleration of a body (``omega^2 r``) is forgotten, or has the wrong sign;
- the Coriolis acceleration of a sliding point is forgotten, or has the wrong sign;
- the given angular accelerations (or accelerations) are forgotten, or taken with the wrong sign;
- a given angle in degrees goes into a calculator that counts in radians;
- a distance is laid off to the other side, so that the mechanism is assembled on the other branch.

A key must tell each of these from the right answer.
"""

from __future__ import annotations

import math
from collections.abc import Mapping, Sequence
from typing import Any

import numpy as np
from msgspec.structs import replace
from numpy.typing import NDArray

from variantgen.families.family import Form
from variantgen.families.quantities import Quantity, motion_order
from variantgen.families.reading.soundness import demands
from variantgen.mechanism.motion import Motion
from variantgen.mechanism.relative import relative_motion, sliding_points
from variantgen.mechanism.rows import Frame, Speeds
from variantgen.mechanism.solving.solve import Equations, solve
from variantgen.variants.screening import repeated

Array = NDArray[np.float64]

# Of the size of an answer: what a mistake changes by less it does not change, but for rounding.
_UNCHANGED = 1e-6


def wrong_answers(
    form: Form, parameters: Mapping[str, Any], on_paper: Frame, asked: Sequence[Quantity], motion: Motion
) -> dict[str, Array]:
    """The answers (SI) by each mistake, shape (answers, N); not a number where it leads to no mechanism."""
    order = motion_order(asked)
    found = _by_accelerations(form, asked, motion) if order == 2 else {}
    with np.errstate(all="ignore"):
        return found | _by_positions(form, parameters, on_paper, asked, motion.size)


def distances(right: Array, wrong: Array, asked: Sequence[Quantity]) -> Array:
    """Relative distances of wrong answers from the right ones (angles in radians), shape (..., answers, N).

    Infinite where the mistake does not touch an answer, or leads to no mechanism.
    """
    found = np.full(wrong.shape, np.inf)
    for i, quantity in enumerate(asked):
        if quantity.component == "sense":
            continue
        change, size = wrong[..., i, :] - right[i], np.abs(right[i])
        if quantity.is_angle:
            change, size = np.angle(np.exp(1j * change)), np.ones_like(size)
        change = np.abs(change)
        safe = np.where(size > 0, size, 1.0)
        with np.errstate(invalid="ignore"):
            found[..., i, :] = np.where(change > _UNCHANGED * size, change / safe, np.inf)
    return found


def _by_accelerations(form: Form, asked: Sequence[Quantity], motion: Motion) -> dict[str, Array]:
    """Forgotten and reversed terms of accelerations; these are linear in each such term.

    ``without`` has in its rows the accelerations without one term after the other, in the last those that the given
    ones make alone.
    """
    turning = [body for body, omega in motion.omega.items() if np.any(omega != 0)]
    sliding = sliding_points(motion.scene)
    terms = [f"normal acceleration of {body}" for body in turning]
    terms += [f"Coriolis acceleration of {point}" for point in sliding]
    count = len(terms) + 1
    v = {name: np.repeat(x[None], count, axis=0) for name, x in motion.v.items()}
    omega = {body: np.repeat(x[None], count, axis=0) for body, x in motion.omega.items()}
    for row, body in enumerate(turning):
        omega[body][row] = 0.0
    for row, (point, body) in enumerate(sliding.items(), start=len(turning)):
        # As if it did not slide: its transport velocity.
        v[point][row] -= relative_motion(motion, point, body).velocity
    for table in (*v.values(), *omega.values()):
        table[-1] = 0.0
    without = Equations(motion, form.plan).accelerated(Speeds(v, omega))
    # By mistake: the row of ``without``, its share in the sum, and that of the right accelerations.
    sums = [(row, *shares) for row in range(len(terms)) for shares in ((1.0, 0.0), (2.0, -1.0))]
    rows, shares, own = map(np.array, zip(*sums, (count - 1, -1.0, 1.0), (count - 1, -2.0, 1.0), strict=True))

    def mixed(right: Mapping[str, Any], wrong: Mapping[str, Any]) -> dict[str, Any]:
        return {name: own[:, None] * x + shares[:, None] * wrong[name][rows] for name, x in right.items()}

    wrong = replace(
        motion, a=mixed(motion.a, without.a), epsilon=mixed(motion.epsilon, without.epsilon), outcome=without.outcome
    )
    names = [f"{term} {how}" for term in (*terms, "given accelerations") for how in ("forgotten", "reversed")]
    shape = (len(names), motion.size)
    answers = np.array([np.broadcast_to(quantity.value(wrong), shape) for quantity in asked], dtype=float)
    return _by_mistake(names, answers, wrong.solved)


def _by_positions(
    form: Form, parameters: Mapping[str, Any], on_paper: Frame, asked: Sequence[Quantity], size: int
) -> dict[str, Array]:
    """Degrees for radians, and the other branches, all of them solved as one batch."""
    degrees = [name for name, p in form.parameters.items() if p.given and p.unit is not None and p.unit.name == "deg"]
    branches = [name for name, template in form.points.items() if getattr(template.component, "chooses", "")]
    count = len(degrees) + len(branches)
    if not count:
        return {}
    blocks = [slice(k * size, (k + 1) * size) for k in range(count)]
    numbers, tiled = repeated(parameters, on_paper, size, count)
    for block, name in zip(blocks, degrees, strict=False):
        numbers[name][block] *= 180.0 / math.pi
    values = form.values(numbers)
    scene = form.scene(values, tiled)
    points = dict(scene.points)
    for block, name in zip(blocks[len(degrees) :], branches, strict=True):
        other, side = np.ones(count * size), getattr(points[name], "chooses", "")
        other[block] = -1.0
        points[name] = replace(points[name], **{side: getattr(points[name], side) * other})  # type: ignore[type-var]
    wrong = solve(replace(scene, points=points), motion_order(asked), form.plan)
    good = wrong.solved
    for demand in demands(form):
        good = good & demand.met(values)
    names = [f"{name} in degrees for radians" for name in degrees] + [
        f"{name} on the other branch" for name in branches
    ]
    answers = np.array([quantity.value(wrong) for quantity in asked], dtype=float)
    return _by_mistake(names, answers.reshape(len(asked), count, size), good.reshape(count, size))


def _by_mistake(names: Sequence[str], answers: Array, good: NDArray[np.bool_]) -> dict[str, Array]:
    """The answers, shape (answers, mistakes, N), by the names of the mistakes."""
    valid = np.where(good, answers, np.nan)
    return {name: valid[:, k] for k, name in enumerate(names)}
