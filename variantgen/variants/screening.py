"""Screens: the conditions that a variant must meet, evaluated on a batch.

Each returns a flag per variant. They are grouped by what they need: parameters, positions, motion, and the motion
for slightly changed parameters.
"""

from __future__ import annotations

from collections.abc import Mapping, Sequence
from typing import Any

import numpy as np
from numpy.typing import NDArray

from variantgen.errors import InputError, Problem
from variantgen.families.family import Form
from variantgen.families.literal_parameters import with_literal_parameters
from variantgen.families.quantities import Quantity, motion_order, split_name
from variantgen.families.reading.soundness import demands
from variantgen.mechanism.arithmetic import dot
from variantgen.mechanism.motion import Motion
from variantgen.mechanism.relative import sliding_points
from variantgen.mechanism.rows import Frame
from variantgen.mechanism.scene import fixed_points
from variantgen.mechanism.solving.solve import from_picture, solve
from variantgen.mechanism.verification.verify import invariants, recompute

Passed = NDArray[np.bool_]
Values = Mapping[str, NDArray[np.float64]]

# A variant reaches paper only if the two computations agree this well (relative to the fastest point).
VERIFIED = 1e-7
# How far a point stays from a link that it does not belong to, in spacings of hinges: a fixed hinge has a base.
_OFF_LINKS, _BASE_OFF_LINKS = 0.75, 1.3
# How far a velocity or acceleration centre or a centre of curvature that is asked may lie, in sizes of the mechanism.
_FAR = 4.0
# Relative change of a parameter in the search for sensitive answers.
_STEP = 1e-6
_AT_ONCE = 1_000_000  # distances of points that are in memory together
_STRAIGHT = 1e-3  # rad: a link so near to horizontal or vertical lies so on paper
_MARGIN = 0.12  # of a rod, at each end, that a sleeve or an inner joint keeps clear


def _at_least(value: Any, limit: Any) -> Passed:
    """``value >= limit``, with room for rounding: grids of round numbers meet limits exactly, and the last bit of a
    sine differs between machines (and between batches), which must not decide about a variant.
    """
    return np.asarray(value >= limit * (1 - 1e-9))


def parameter_screens(form: Form, values: Values, size: int) -> dict[str, Passed]:
    """Comparisons that the family requires of its parameters."""
    found = {
        f"require {item.text}": np.broadcast_to(np.asarray(item.holds(values)), (size,))
        for item in form.screens.require
    }
    for demand in demands(form):
        if demand.expression.names:
            found[f"{demand.key} with a meaning"] = np.broadcast_to(np.asarray(demand.met(values)), (size,))
    return found


def position_screens(form: Form, motion: Motion, values: Values) -> dict[str, Passed]:
    """Assembles, hinges apart, hinges off foreign links, sane aspect, joints inside their links, not too large."""
    shown = [name for name in motion.z if name not in form.figure.hidden]
    z = np.array([motion.z[name] for name in shown])
    low, high = _box(form, motion, values, z)
    size = np.maximum(np.real(high - low), np.imag(high - low))
    safe = np.where(size > 0, size, 1.0)
    spacing = form.screens.spacing
    found = {
        "assembles": motion.solved,
        "hinges apart": _at_least(_closest(z) / safe, spacing),
        "hinges off other links": _at_least(_clearance(form, motion, shown) / safe, spacing),
        "aspect": _at_least(np.minimum(np.real(high - low), np.imag(high - low)) * form.screens.aspect, size),
    }
    if form.screens.slant:
        found["no link nearly horizontal or vertical"] = _slanted(form, motion)
    for point, start, end in form.screens.inside:
        line = motion.z[end] - motion.z[start]
        square = np.where(np.abs(line) > 0, np.abs(line) ** 2, 1.0)
        part = dot(line, motion.z[point] - motion.z[start]) / square
        found[f"{point} inside {start}{end}"] = _at_least(part, _MARGIN) & _at_least(1 - part, _MARGIN)
    if form.machine:
        found[form.machine.rule("length")] = _at_least(form.machine.length, size)
    return found


def _closest(z: NDArray[np.complex128]) -> NDArray[np.float64]:
    """The smallest distance of two of the points, shape (P, N), of each variant (m); infinite for a single point.

    Pairs are looked at in parts, as scenes of hundreds of points have tens of thousands of them.
    """
    first, second = np.triu_indices(len(z), 1)
    smallest, step = np.full(z.shape[1], np.inf), max(1, _AT_ONCE // max(1, z.shape[1]))
    for start in range(0, len(first), step):
        part = slice(start, start + step)
        np.minimum(smallest, np.min(np.abs(z[first[part]] - z[second[part]]), axis=0), out=smallest)
    return smallest


def _box(
    form: Form, motion: Motion, values: Values, z: NDArray[np.complex128]
) -> tuple[NDArray[np.complex128], NDArray[np.complex128]]:
    """Lower left and upper right corner of everything that will be drawn."""
    corners = [z]
    for disc in (disc for disc in form.figure.discs if not disc.arc):
        half_box = np.asarray(disc.radius.value(values)) * (1 + 1j)
        corners += [(motion.z[disc.centre] + half_box)[None], (motion.z[disc.centre] - half_box)[None]]
    every = np.concatenate(corners)
    low = np.min(every.real, axis=0) + 1j * np.min(every.imag, axis=0)
    return low, np.max(every.real, axis=0) + 1j * np.max(every.imag, axis=0)


def _clearance(form: Form, motion: Motion, shown: Sequence[str]) -> NDArray[np.float64]:
    """Smallest distance of a point from a bar that it does not belong to and does not slide on (m), over its need."""
    slides, fixed = sliding_points(motion.scene), fixed_points(motion.scene)
    smallest = np.full(motion.size, np.inf)
    for body, start, end in form.bars:
        line = motion.z[end] - motion.z[start]
        square = np.where(np.abs(line) > 0, np.abs(line) ** 2, 1.0)
        for point in shown:
            if point in form.bodies[body] or slides.get(point) == body:
                continue
            step = motion.z[point] - motion.z[start]
            part = np.clip(dot(line, step) / square, 0.0, 1.0)
            need = _BASE_OFF_LINKS if point in fixed else _OFF_LINKS
            smallest = np.minimum(smallest, np.abs(step - part * line) / need)
    return smallest


def _slanted(form: Form, motion: Motion) -> Passed:
    """Whether each bar is horizontal or vertical, or well away from it."""
    passed = np.ones(motion.size, dtype=bool)
    for _, start, end in form.bars:
        line = motion.z[end] - motion.z[start]
        off = np.arctan2(*np.sort(np.abs([line.real, line.imag]), axis=0))
        passed &= (off < _STRAIGHT) | _at_least(off, form.screens.slant)
    return passed


def motion_screens(form: Form, motion: Motion, asked: Sequence[Quantity]) -> dict[str, Passed]:
    """Away from dead points; answers neither trivial nor out of proportion; nothing implausibly fast."""
    found = {"away from dead points": motion.solved & _at_least(motion.transmission, np.sin(form.screens.transmission))}
    return found | clear_answers(form, motion, asked) | _curved(form, motion) | plausibility_screens(form, motion)


def _curved(form: Form, motion: Motion) -> dict[str, Passed]:
    """Coordinates to be sketched change: as a mechanism lies on paper, a slider may keep one of them."""
    found = {}
    for quantity in (split_name(name) for name in form.figure.sketch):
        if quantity.kind in ("x", "y") and quantity.target in motion.v:
            v = motion.v[quantity.target]
            found[f"{quantity.name} changes"] = np.abs(v.real if quantity.kind == "x" else v.imag) > 1e-9 * np.abs(v)
    return found


def clear_answers(form: Form, motion: Motion, asked: Sequence[Quantity]) -> dict[str, Passed]:
    """Answers neither trivial nor out of proportion."""
    found = {}
    for quantity in asked:
        # A direction or a sense is as clear as its vector or rate is large.
        size = np.abs(quantity.whole.value(motion))
        scale = _scale(motion, quantity)
        clear = (size > 0) & np.isfinite(size) & _at_least(size, form.screens.trivial * scale)
        if quantity.is_length and quantity.is_of_instant:
            clear &= size <= _FAR * scale
        found[f"{quantity.name} not trivial"] = clear
    return found


def plausibility_screens(form: Form, motion: Motion) -> dict[str, Passed]:
    """Nothing faster than its machine would be (:class:`variantgen.families.machine.Machine`)."""
    if form.machine is None:
        return {}
    v, a = ({n: rates for n, rates in t.items() if n not in form.figure.hidden} for t in (motion.v, motion.a))
    tables = {"speed": v, "acceleration": a, "omega": motion.omega, "epsilon": motion.epsilon}
    return {
        form.machine.rule(name): _at_least(
            getattr(form.machine, name), np.max([np.abs(rates) for rates in table.values()], axis=0)
        )
        for name, table in tables.items()
        if table
    }


def _scale(motion: Motion, quantity: Quantity) -> NDArray[np.float64]:
    """The largest quantity of the same kind in the mechanism."""
    if quantity.is_length:
        return motion.length_scale()
    quantity = quantity.of_instant or quantity if not quantity.is_angle else quantity
    if not quantity.is_vector and not quantity.is_rotation:  # an angle or a number is as large as it is
        return np.ones(motion.size)
    if quantity.kind == "omega":
        table = [np.abs(x) for x in motion.omega.values()]
    elif quantity.kind == "epsilon":
        table = [np.abs(x) for x in motion.epsilon.values()] + [x * x for x in motion.omega.values()]
    else:
        table = [np.abs(x) for x in (motion.v if quantity.order == 1 else motion.a).values()]
    return np.asarray(np.max(table, axis=0))


def sensitivity(
    form: Form, parameters: Values, on_paper: Frame, asked: Sequence[Quantity], motion: Motion
) -> NDArray[np.float64]:
    """Relative change of the answers per relative change of the printed data, shape (N,), the largest of the answers.

    ``sqrt(sum_p (d ln q / d ln p)^2)`` over the printed parameters p (an angle counts with d phi in rad), by forward
    differences of 1e-6; the quantities q of a variant that a rounded hand calculation would miss have large values.
    Where no data are printed, the numbers that the scene states literally take their place.
    """
    moving = [name for name, parameter in form.parameters.items() if parameter.unit is not None]
    if not moving:
        form = with_literal_parameters(form)
        literal = {n: p for n, p in form.parameters.items() if n not in parameters}
        parameters = {**parameters, **{n: np.full(motion.size, p.si[0]) for n, p in literal.items()}}
        moving = list(literal)
    if not moving:
        return np.zeros(motion.size)
    moved = _moved_motion(form, parameters, moving, on_paper, asked, motion)
    silent = np.array([form.parameters[name].silent for name in moving])
    total = []
    # All of one motion, then all of the other: several values may be of one turn of the crank, found once.
    bases = [quantity.value(motion) for quantity in asked]
    others = [quantity.value(moved).reshape(len(moving), motion.size) for quantity in asked]
    for quantity, base, other in zip(asked, bases, others, strict=True):
        change = _change(quantity, other, base)
        for name in np.array(moving)[silent].tolist():
            _refuse_silent_influence(name, quantity, change[moving.index(name)], base, motion)
        size = 1.0 if quantity.is_angle else np.where(base == 0, np.inf, np.abs(base))
        total.append(np.sum((change[~silent] / size / _STEP) ** 2, axis=0))
    return np.asarray(np.sqrt(np.max(total, axis=0)))


def _moved_motion(
    form: Form,
    parameters: Values,
    moving: Sequence[str],
    on_paper: Frame,
    asked: Sequence[Quantity],
    motion: Motion,
) -> Motion:
    """The motion with each parameter in turn slightly changed, as one batch: shape (parameters * N,)."""
    count, size = len(moving), motion.size
    values, tiled = repeated(parameters, on_paper, size, count)
    for k, name in enumerate(moving):
        unit = form.parameters[name].unit
        pure = unit is not None and unit.dimension == (0, 0)
        values[name][k * size : (k + 1) * size] += _STEP * (1.0 if pure else parameters[name])
    solved = {name: np.tile(motion.frame.unplace(z), count) for name, z in motion.z.items()}
    scene = from_picture(form.scene(form.values(values), tiled), solved)
    return solve(scene, motion_order(asked), form.plan)


def repeated(
    parameters: Values, on_paper: Frame, size: int, count: int
) -> tuple[dict[str, NDArray[np.float64]], Frame]:
    """The parameters and poses of N variants so many times over, shape (count * N,)."""

    def over(value: Any) -> NDArray[Any]:
        return np.concatenate([value if np.shape(value) == (size,) else np.full(size, value)] * count)

    return {name: over(value) for name, value in parameters.items()}, Frame(over(on_paper.turn), over(on_paper.sense))


def _refuse_silent_influence(
    name: str, quantity: Quantity, change: NDArray[np.float64], base: NDArray[np.float64], motion: Motion
) -> None:
    """Raise InputError if an answer changes with a parameter that is not printed."""
    if np.any(motion.solved & (np.abs(change) > 1e-9 * (1.0 if quantity.is_angle else np.abs(base)))):
        raise InputError(
            Problem(
                f"{quantity.name} depends on a parameter that is not printed",
                key=f"parameters.{name}",
                value="silent = true",
                remedy="print it (silent = false) or ask for something else",
            )
        )


def _change(quantity: Quantity, value: NDArray[np.float64], base: NDArray[np.float64]) -> NDArray[np.float64]:
    """Difference of two values; for an angle the turn between them."""
    with np.errstate(invalid="ignore"):  # what has no value is infinite, before and after
        return np.angle(np.exp(1j * (value - base))) if quantity.is_angle else value - base


def verification(motion: Motion, order: int) -> Passed:
    """Whether the independent computation and the invariants agree with the solver, per variant."""
    again = recompute(motion)
    agrees = (again.velocity_error <= VERIFIED) & (invariants(motion) <= VERIFIED)
    return agrees & (again.acceleration_error <= VERIFIED) if order == 2 else agrees
