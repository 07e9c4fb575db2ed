"""What mistakes with a body that a point slides on make of answers, as a student works them out.

The table of :mod:`variantgen.variants.distractors`, by which tolerances are chosen, drops with the normal acceleration
of a body that of Coriolis on it too, and finds the relative acceleration from all right terms. A student drops one term
of ``a_S = a_P + i epsilon r - omega^2 r + 2 i omega v_rel + a_rel`` and keeps to the rest.
"""

from __future__ import annotations

from collections.abc import Mapping, Sequence

import numpy as np
from msgspec.structs import replace

from variantgen.families.family import Form
from variantgen.families.quantities import Quantity
from variantgen.mechanism.motion import ComplexField, Field, Motion
from variantgen.mechanism.relative import relative_motion, sliding_points
from variantgen.mechanism.rows import Speeds
from variantgen.mechanism.solving.solve import Equations

_HOW = {"forgotten": 1.0, "reversed": 2.0}  # how many times the term is taken away


def sliding_mistakes(form: Form, asked: Sequence[Quantity], motion: Motion) -> dict[str, Field]:
    """The answers (SI) by the names of such mistakes, shape (answers, N) each; {} where nothing slides or turns."""
    slides = sliding_points(motion.scene)
    bodies = [body for body in dict.fromkeys(slides.values()) if np.any(motion.omega[body] != 0)]
    points = [point for point, body in slides.items() if body in bodies]
    if not bodies or not motion.a:
        return {}
    relative = {point: relative_motion(motion, point, slides[point]).velocity for point in points}
    count = len(bodies) + len(points)
    v = {name: np.repeat(x[None], count, axis=0) for name, x in motion.v.items()}
    omega = {body: np.repeat(x[None], count, axis=0) for body, x in motion.omega.items()}
    for row, body in enumerate(bodies):
        omega[body][row] = 0.0
    for row, point in enumerate(points, start=len(bodies)):
        v[point][row] -= relative[point]
    without = Equations(motion, form.plan).accelerated(Speeds(v, omega))
    found: dict[str, Field] = {}
    for row, name in enumerate((*bodies, *points)):
        weights = np.zeros(count)  # with the body the terms of Coriolis are gone too: they are put back
        weights[row] = 1.0
        weights[len(bodies) :] -= [row < len(bodies) and slides[point] == name for point in points]
        change = {point: np.tensordot(weights, x - motion.a[point], 1) for point, x in without.a.items()}
        turned = {body: np.tensordot(weights, x - motion.epsilon[body], 1) for body, x in without.epsilon.items()}
        gone = _terms_gone(motion, slides, relative, name)
        term = f"{'normal acceleration' if row < len(bodies) else 'Coriolis acceleration'} of {name}"
        for how, times in _HOW.items():
            wrong = replace(
                motion,
                a={point: motion.a[point] + times * x for point, x in change.items()},
                epsilon={body: motion.epsilon[body] + times * x for body, x in turned.items()},
            )
            values = [_value(quantity, wrong, {point: times * x for point, x in gone.items()}) for quantity in asked]
            found[f"{term} {how}"] = np.where(motion.solved, np.array(values), np.nan)
    return found


def _terms_gone(
    motion: Motion, slides: Mapping[str, str], relative: Mapping[str, ComplexField], name: str
) -> dict[str, ComplexField]:
    """The dropped term of each sliding point, ``-omega^2 r`` of a body or ``2 i omega v_rel`` of a point."""
    if name in slides:
        return {name: 2j * motion.omega[slides[name]] * relative[name]}
    start = motion.z[motion.scene.bodies[name][0]]
    return {p: -(motion.omega[name] ** 2) * (motion.z[p] - start) for p, body in slides.items() if body == name}


def _value(quantity: Quantity, wrong: Motion, gone: Mapping[str, ComplexField]) -> Field:
    """An answer; in a relative acceleration the dropped term is missing among those that are taken away."""
    if quantity.kind == "a_rel" and quantity.target in gone:
        own = wrong.a[quantity.target] + gone[quantity.target]
        wrong = replace(wrong, a={**wrong.a, quantity.target: own})
    return quantity.value(wrong)
