"""What follows from wrong answers by the theorems of a rigid body and by the solver: no step of a solution enters.

A follow-through is granted only where the steps of the solution and one of these agree:

- all velocities in proportion to the wrong one, as if it were the given motion of a mechanism with one freedom;
- what theorems make of the wrong numbers and right ones (:mod:`variantgen.marking.diagnosis.derived`);
- for a point C that slides along a line of a body through its point A, with the components along and across the line of
  ``v_C = v_A + omega x r + v_rel`` and ``a_C = a_A + epsilon x r - omega^2 r + 2 omega x v_rel + a_rel``;
- for centres ``PA = v_A / omega``, ``QA = a_A / sqrt(epsilon^2 + omega^4)``, ``tan mu = |epsilon| / omega^2``;
- the accelerations that the solver finds where rates are wrong as they follow from the wrong answers.
"""

from __future__ import annotations

import math
from collections.abc import Iterator, Mapping
from itertools import product
from typing import Any

import numpy as np
from msgspec.structs import replace

from variantgen.families.quantities import Quantity
from variantgen.marking.diagnosis.derived import DerivedMotion
from variantgen.mechanism.arithmetic import cross, dot
from variantgen.mechanism.motion import Motion
from variantgen.mechanism.relative import relative_motion, sliding_points
from variantgen.mechanism.rows import Speeds
from variantgen.mechanism.solving.solve import Equations
from variantgen.variants.variant import Variant

_MOST = 20000  # mixtures of right and wrong rates
_SAME = 1e-6  # relative


def confirms(variant: Variant, motion: Motion, wrong: Mapping[Quantity, float], asked: Quantity, number: float) -> bool:
    """Whether a number (SI) is what an asked quantity becomes with wrong answers (SI) in the place of right ones."""
    factors = [value / float(quantity.value(motion)[0]) for quantity, value in wrong.items()]
    if asked.order == 1:
        right = float(asked.value(motion)[0])
        if any(
            _same(right * factor, number)
            for quantity, factor in zip(wrong, factors, strict=True)
            if quantity.order == 1
        ):
            return True
    mixed = _mixed(motion, wrong)
    results = (
        *_by_moved_centre(motion, wrong, asked),
        *_by_sliding(motion, mixed, wrong, asked),
        *_by_centres(mixed, asked),
    )
    if any(_same(found, number) for found in results):
        return True
    derived = DerivedMotion(motion, wrong)
    if np.any(np.abs(derived.values(asked) - number) <= _SAME * abs(number)):
        return True
    return asked.order == 2 and _by_solver(variant, motion, derived, asked, number)


def _same(found: float, number: float) -> bool:
    return abs(found - number) <= _SAME * abs(number)


def _mixed(motion: Motion, wrong: Mapping[Quantity, float]) -> Motion:
    """The motion with the wrong answers in it, as magnitudes and rates; each in the direction that it has."""
    v, a, omega, epsilon = dict(motion.v), dict(motion.a), dict(motion.omega), dict(motion.epsilon)
    for quantity, value in wrong.items():
        right = float(quantity.value(motion)[0])
        factor = value / right if right else 1.0
        match quantity.kind:
            case "v" if quantity.target in v:
                v[quantity.target] = v[quantity.target] * factor
            case "a" if quantity.target in a:
                a[quantity.target] = a[quantity.target] * factor
            case "omega":
                omega[quantity.target] = omega[quantity.target] * factor
            case "epsilon":
                epsilon[quantity.target] = epsilon[quantity.target] * factor
    return replace(motion, v=v, a=a, omega=omega, epsilon=epsilon)


def _by_sliding(motion: Motion, mixed: Motion, wrong: Mapping[Quantity, float], asked: Quantity) -> Iterator[float]:
    """The values of an asked quantity by the components of a compound motion along and across the line of a slot."""
    for point, body in sliding_points(motion.scene).items():
        own = relative_motion(motion, point, body)
        parts: dict[str, Any] = {"v_rel": own.velocity, "a_rel": own.acceleration, "a_cor": own.coriolis}
        for quantity, value in wrong.items():
            part = parts.get(quantity.kind) if quantity.target == point else None
            if part is not None:
                parts[quantity.kind] = part * (value / float(quantity.value(motion)[0]))
        omega, v_rel = mixed.omega[body], parts["v_rel"]
        if asked.kind == "a_cor" and asked.target == point:
            yield float(np.abs(2.0 * omega * v_rel)[0])
        if asked.target == point:
            yield from _sums(motion, mixed, parts, asked, body)
        for start in motion.scene.bodies[body]:
            r = complex(motion.z[point][0] - motion.z[start][0])
            u = complex(own.velocity[0])
            if start == point or abs(cross(r, u)) > _SAME * abs(r) * abs(u) or not u:
                continue
            step = complex(mixed.v[point][0] - mixed.v[start][0])
            if asked.kind == "v_rel" and asked.target == point:
                yield abs(float(dot(r, step))) / abs(r)
            if asked.kind == "omega" and asked.target == body:
                yield _shown(asked, float(cross(r, step)) / abs(r) ** 2)
            if not mixed.a or parts["a_cor"] is None:
                continue
            step = complex(mixed.a[point][0] - mixed.a[start][0])
            for coriolis in (complex(parts["a_cor"][0]), complex((2j * omega * v_rel)[0])):
                if asked.kind == "epsilon" and asked.target == body:
                    yield _shown(asked, float(cross(r, step - coriolis)) / abs(r) ** 2)
            if asked.kind == "a_rel" and asked.target == point:
                yield abs(float(dot(r, step)) / abs(r) + float(omega[0]) ** 2 * abs(r))


def _sums(motion: Motion, mixed: Motion, parts: Mapping[str, Any], asked: Quantity, body: str) -> Iterator[float]:
    """A velocity or acceleration as the sum of the transport and relative parts."""
    point, omega = asked.target, mixed.omega[body]
    for start in motion.scene.bodies[body]:
        r = motion.z[point] - motion.z[start]
        if asked.kind == "v":
            moved = mixed.v[start] + 1j * omega * r + parts["v_rel"]
            yield float(asked.value(replace(mixed, v={**mixed.v, point: moved}))[0])
        elif asked.kind == "a" and parts["a_rel"] is not None:
            transport = mixed.a[start] + (1j * mixed.epsilon[body] - omega**2) * r + parts["a_rel"]
            for coriolis in (parts["a_cor"], 2j * omega * parts["v_rel"]):
                moved = transport + coriolis
                yield float(asked.value(replace(mixed, a={**mixed.a, point: moved}))[0])


def _by_centres(mixed: Motion, asked: Quantity) -> Iterator[float]:
    """Distances from the centres and the angle of the acceleration centre."""
    if asked.kind == "mu":
        yield float(asked.value(mixed)[0])
    if asked.is_centre and not asked.is_coordinate:
        omega, epsilon = mixed.omega[asked.target], mixed.epsilon.get(asked.target, 0.0)
        rate = np.abs(omega) if asked.kind == "P" else np.sqrt(np.square(epsilon) + omega**4)
        vector = (mixed.v if asked.kind == "P" else mixed.a)[asked.component]
        if np.all(rate > 0):
            yield float((np.abs(vector) / rate)[0])


def _by_moved_centre(motion: Motion, wrong: Mapping[Quantity, float], asked: Quantity) -> Iterator[float]:
    """Magnitudes about a centre whose distance from a point A is wrong: as the distances, by the right rate or by A."""
    for quantity, distance in wrong.items():
        kind, point = ("v", "a")[quantity.kind == "Q"], quantity.component
        if not quantity.is_centre or quantity.is_coordinate or asked.kind != kind or asked.component:
            continue
        omega = motion.omega[quantity.target]
        if kind == "v":
            ray, size = 1j * motion.v[point] / omega, np.abs(motion.v[point])
        else:
            ray, size = motion.a[point] / (omega**2 - 1j * motion.epsilon[quantity.target]), np.abs(motion.a[point])
        right = np.abs(ray)
        gap = np.abs(motion.z[asked.target] - motion.z[point] - distance * ray / right)
        yield from (float((size * gap / length)[0]) for length in (right, distance))


def _shown(asked: Quantity, rate: float) -> float:
    return abs(rate) if asked.component == "abs" else rate


def _by_solver(variant: Variant, motion: Motion, derived: DerivedMotion, asked: Quantity, number: float) -> bool:
    """Whether the solver finds the number where rates are wrong as they follow from wrong answers, in every mixture."""
    rates = {body: own if own.size > 1 else derived.in_proportion(body) for body, own in derived.omega.items()}
    carriers: list[tuple[str, str]] = [("omega", body) for body in rates if rates[body].size > 1]
    slid = {point: motion.v[point] - own[0] + own for point, own in derived.v_rel.items()}  # beside the right carrier
    velocities = {**{point: derived.v[point] for point in derived.given}, **slid}
    carriers += [("v", point) for point in sorted(velocities) if velocities[point].size > 1]
    if not carriers:
        return False
    tables = {"omega": rates, "v": velocities}
    lists = [tables[kind][name] for kind, name in carriers]
    while math.prod(map(len, lists)) > _MOST:  # the first candidates are those that the fewest theorems make
        longest = max(range(len(lists)), key=lambda k: len(lists[k]))
        lists[longest] = lists[longest][:-1]
    rows = list(product(*lists))
    chosen = np.array(rows)[..., None]  # by combination, by carrier, over a batch of one
    omega = {body: np.broadcast_to(x, (len(rows), 1)) for body, x in motion.omega.items()}
    v = {point: np.broadcast_to(x, (len(rows), 1)) for point, x in motion.v.items()}
    for k, (kind, name) in enumerate(carriers):
        if kind == "omega":
            omega[name] = chosen[:, k].real
        else:
            v[name] = chosen[:, k]
    moved = Equations(motion, variant.form.plan).accelerated(Speeds(v, omega))
    found = np.ravel(np.broadcast_to(asked.value(replace(moved, v=v, omega=omega)), (len(rows), 1)))
    return bool(np.any(np.abs(found - number) <= _SAME * abs(number)))
