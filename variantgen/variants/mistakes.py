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
from collections.abc import Callable, Iterator, Mapping, Sequence
from dataclasses import replace
from typing import Any

import numpy as np
from numpy.typing import NDArray

from variantgen.families.family import Form
from variantgen.families.quantities import Quantity
from variantgen.mechanism.constructions.circle_circle import CircleCircle
from variantgen.mechanism.constructions.line_circle import LineCircle
from variantgen.mechanism.motion import Motion
from variantgen.mechanism.relative import relative_motion, sliding_points
from variantgen.mechanism.rows import Frame
from variantgen.mechanism.solve import add_speeds, solve

Table = NDArray[np.float64]

# Of the size of an answer: what a mistake changes by less it does not change, but for rounding.
_UNCHANGED = 1e-6


def wrong_answers(
    form: Form, parameters: Mapping[str, Any], on_paper: Frame, asked: Sequence[Quantity], motion: Motion
) -> dict[str, Table]:
    """The answers (SI) by each mistake, shape (answers, N); not a number where it leads to no mechanism."""
    order = max(quantity.order for quantity in asked)
    found: dict[str, Table] = {}
    for name, wrong in _mistakes(form, parameters, on_paper, order, motion):
        values = np.array([quantity.value(wrong) for quantity in asked], dtype=float)
        found[name] = np.where(wrong.solved, values, np.nan)
    return found


def distances(right: Table, wrong: Table, asked: Sequence[Quantity]) -> Table:
    """How far wrong answers are from the right ones, relative (of an angle in radians), shape (answers, N).

    Infinite where the mistake does not touch an answer, or leads to no mechanism.
    """
    found = np.full(right.shape, np.inf)
    for i, quantity in enumerate(asked):
        if quantity.component == "sense":
            continue
        change, size = np.abs(wrong[i] - right[i]), np.abs(right[i])
        if quantity.is_angle:
            change, size = np.abs(np.angle(np.exp(1j * (wrong[i] - right[i])))), np.ones_like(size)
        safe = np.where(size > 0, size, 1.0)
        with np.errstate(invalid="ignore"):
            found[i] = np.where(change > _UNCHANGED * size, change / safe, np.inf)
    return found


def _mistakes(
    form: Form, parameters: Mapping[str, Any], on_paper: Frame, order: int, motion: Motion
) -> Iterator[tuple[str, Motion]]:
    if order == 2:
        yield from _mistaken_accelerations(form, motion)
    yield from _degrees_for_radians(form, parameters, on_paper, order)
    yield from _other_branches(form, parameters, on_paper, order)


def _mistaken_accelerations(form: Form, motion: Motion) -> Iterator[tuple[str, Motion]]:
    """Forgotten and reversed terms of accelerations; these are linear in each such term."""

    def taken(change: Callable[[Motion], Motion]) -> Motion:
        return add_speeds(motion, form.plan, 2, change)

    for body, omega in motion.omega.items():
        if np.any(omega != 0):
            without = taken(lambda m, body=body: replace(m, omega={**m.omega, body: np.zeros(m.size)}))  # type: ignore[misc]
            yield f"normal acceleration of {body} forgotten", without
            yield f"normal acceleration of {body} reversed", _combined(motion, without, -1.0, 2.0)
    for point, body in sliding_points(motion.scene).items():
        without = taken(lambda m, point=point, body=body: _without_slip(m, point, body))  # type: ignore[misc]
        yield f"Coriolis acceleration of {point} forgotten", without
        yield f"Coriolis acceleration of {point} reversed", _combined(motion, without, -1.0, 2.0)
    driven = taken(_at_rest)
    yield "given accelerations forgotten", _combined(motion, driven, 1.0, -1.0)
    yield "given accelerations reversed", _combined(motion, driven, 1.0, -2.0)


def _without_slip(motion: Motion, point: str, body: str) -> Motion:
    """The velocity of a sliding point as if it did not slide: its transport velocity."""
    relative = relative_motion(motion, point, body)
    return replace(motion, v={**motion.v, point: motion.v[point] - relative.velocity})


def _at_rest(motion: Motion) -> Motion:
    """No velocities: what is left of accelerations comes from the given ones."""
    return replace(
        motion,
        v={name: np.zeros_like(v) for name, v in motion.v.items()},
        omega={body: np.zeros_like(omega) for body, omega in motion.omega.items()},
    )


def _combined(first: Motion, second: Motion, share: float, other: float) -> Motion:
    """Accelerations as a sum of those of two motions."""
    return replace(
        first,
        a={name: share * a + other * second.a[name] for name, a in first.a.items()},
        epsilon={body: share * e + other * second.epsilon[body] for body, e in first.epsilon.items()},
    )


def _degrees_for_radians(
    form: Form, parameters: Mapping[str, Any], on_paper: Frame, order: int
) -> Iterator[tuple[str, Motion]]:
    for name, parameter in form.parameters.items():
        if parameter.given and parameter.unit is not None and parameter.unit.name == "deg":
            wrong = {**parameters, name: parameters[name] * (180.0 / math.pi)}
            with np.errstate(all="ignore"):
                values = form.values(wrong)
                if not all(np.all(demand.met(values)) for demand in form.demands):
                    continue
                yield f"{name} in degrees for radians", solve(form.scene(values, on_paper), order, form.plan)


def _other_branches(
    form: Form, parameters: Mapping[str, Any], on_paper: Frame, order: int
) -> Iterator[tuple[str, Motion]]:
    scene = form.scene(form.values(parameters), on_paper)
    for name, construction in scene.points.items():
        match construction:
            case CircleCircle():
                other: Any = replace(construction, side=-construction.side)
            case LineCircle():
                other = replace(construction, branch=-construction.branch)
            case _:
                continue
        yield (
            f"{name} on the other branch",
            solve(replace(scene, points={**scene.points, name: other}), order, form.plan),
        )
