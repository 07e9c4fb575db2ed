"""Every method in numbers, for a whole batch at once: each must give what the solver gives.

The groups of the solution say which bodies and points a method applies to; its own formula is evaluated there on arrays
and compared with the solved motion. Deviations are relative to the largest velocity or acceleration of the mechanism.
"""

from __future__ import annotations

from collections.abc import Callable, Iterable, Iterator, Sequence
from itertools import pairwise

import numpy as np

from variantgen.mechanism.arithmetic import cross, dot
from variantgen.mechanism.dense import DenseSystem
from variantgen.mechanism.linkage import Linkage
from variantgen.mechanism.motion import ComplexField, Field, Motion
from variantgen.methods.groups.group import Dyad, FloatingDyad, Group, SlidingPair

AGREES = 1e-9

_FLAT = 1e-6  # sine of the least angle at which lines that cross decide anything


def deviations(motion: Motion, groups: Sequence[Group]) -> dict[str, Field]:
    """The largest deviation of each method that applies, by the name of the method, shape (N,)."""
    found: dict[str, Field] = {}
    for name, method in _METHODS.items():
        worst = [np.abs(defect) for defect in method(motion, groups)]
        if worst:
            found[name] = np.max(worst, axis=0)
    return found


def _speed(motion: Motion) -> Field:
    return _scale(motion.v.values(), motion)


def _largest_acceleration(motion: Motion) -> Field:
    return _scale(motion.a.values(), motion)


def _scale(vectors: Iterable[ComplexField], motion: Motion) -> Field:
    """The largest of the vectors, shape (N,); one where nothing moves."""
    sizes = [np.abs(vector) for vector in vectors]
    largest = np.max(sizes, axis=0) if sizes else np.ones(motion.size)
    result: Field = np.where(largest > 0, largest, 1.0)
    return result


def _dyads(motion: Motion, groups: Sequence[Group]) -> Iterator[tuple[Dyad, ComplexField, ComplexField]]:
    """Dyads with the vector from the pole to the point, and the unit direction of the point's velocity."""
    for group in groups:
        if isinstance(group, Dyad):
            arm = motion.z[group.point_path.point] - motion.z[group.pole]
            if group.point_path.straight:
                # The direction of the guide on paper differs from variant to variant; the velocity shows it.
                v = motion.v[group.point_path.point]
                way: ComplexField = np.where(np.abs(v) > 0, v, 1.0)
            else:
                way = 1j * (motion.z[group.point_path.point] - motion.z[group.point_path.centre])
            unit: ComplexField = way / np.abs(way)
            yield group, arm, unit


def _projections(motion: Motion, groups: Sequence[Group]) -> Iterator[Field]:
    """``v_A cos alpha = v_B cos beta`` on the line AB."""
    speed = _speed(motion)
    for group, arm, way in _dyads(motion, groups):
        ray = arm / np.abs(arm)
        cosine = dot(ray, way)
        fit = np.abs(cosine) > _FLAT
        size = dot(ray, motion.v[group.pole]) / np.where(fit, cosine, 1.0)
        defect = np.abs(size * way - motion.v[group.point_path.point]) * np.minimum(1.0, np.abs(cosine)) / speed
        yield np.where(fit, defect, 0.0)


def _velocity_centre(motion: Motion, groups: Sequence[Group]) -> Iterator[Field]:
    """The perpendiculars at A and B meet in P: ``omega = v_A / AP``, ``v_B = omega BP``."""
    speed = _speed(motion)
    for group, arm, way in _dyads(motion, groups):
        v = motion.v[group.pole]
        moving = np.abs(v) > 1e-9 * speed
        first = 1j * v / np.where(moving, np.abs(v), 1.0)
        sine = cross(first, 1j * way)
        fit = moving & (np.abs(sine) > _FLAT)
        distance = cross(arm, 1j * way) / np.where(fit, sine, 1.0)  # P = A + reach * first
        # Near its pole a centre says little of the rate: what is compared is the rotation times the distance.
        turn = motion.omega[group.body]
        own = np.abs(np.abs(v) - turn * distance)
        other = np.abs(1j * turn * (arm - distance * first) - motion.v[group.point_path.point])
        yield np.where(fit, np.maximum(own, other) * np.minimum(1.0, np.abs(sine)) / speed, 0.0)


def _velocity_pole(motion: Motion, groups: Sequence[Group]) -> Iterator[Field]:
    """``v_B = v_A + v_BA`` solved for the two magnitudes, across each other's direction."""
    speed = _speed(motion)
    for group, arm, way in _dyads(motion, groups):
        turn = 1j * arm
        sine = cross(turn, way) / np.abs(turn)
        fit = np.abs(sine) > _FLAT
        safe = np.where(fit, cross(turn, way), 1.0)
        v = motion.v[group.pole]
        size, rate = cross(turn, v) / safe, cross(way, v) / safe
        defect = np.maximum(
            np.abs(size * way - motion.v[group.point_path.point]),
            np.abs(rate - motion.omega[group.body]) * np.abs(arm),
        )
        yield np.where(fit, defect * np.minimum(1.0, np.abs(sine)) / speed, 0.0)
    for floating in groups:
        if isinstance(floating, FloatingDyad):
            yield from (x / speed for x in _crossing(motion, floating, 1))


def _crossing(motion: Motion, group: FloatingDyad, order: int) -> Iterator[Field]:
    """The rates of two bodies with a common hinge, from their poles' vectors: the deviation at the hinge."""
    vectors, rates = (motion.v, motion.omega) if order == 1 else (motion.a, motion.epsilon)
    arms = [motion.z[group.point] - motion.z[pole] for pole in group.poles]
    gap = vectors[group.poles[1]] - vectors[group.poles[0]]
    if order == 2:
        gap = gap - motion.omega[group.bodies[1]] ** 2 * arms[1] + motion.omega[group.bodies[0]] ** 2 * arms[0]
    sine = cross(arms[0], arms[1])
    for body, other, arm in ((group.bodies[0], arms[1], arms[0]), (group.bodies[1], arms[0], arms[1])):
        # i w0 d0 - i w1 d1 = gap: the product with the other arm leaves one rate.
        rate = dot(other, gap) / np.where(sine == 0, 1.0, sine)
        yield np.abs(rate - rates[body]) * np.abs(arm) * (sine != 0)


def _acceleration_pole(motion: Motion, groups: Sequence[Group]) -> Iterator[Field]:
    """``a_B = a_A + a^n_BA + a^tau_BA`` with the point's own normal component, solved for the two magnitudes."""
    if not motion.a:
        return
    acceleration = _largest_acceleration(motion)
    for group, arm, way in _dyads(motion, groups):
        point, turn = group.point_path.point, 1j * arm
        sine = cross(turn, way) / np.abs(turn)
        fit = np.abs(sine) > _FLAT
        known = motion.a[group.pole] - motion.omega[group.body] ** 2 * arm
        own = np.zeros_like(known)
        if not group.point_path.straight:
            ray = motion.z[group.point_path.centre] - motion.z[point]
            own = np.abs(motion.v[point]) ** 2 / np.abs(ray) ** 2 * ray
        safe = np.where(fit, cross(turn, way), 1.0)
        size, rate = cross(turn, known - own) / safe, cross(way, known - own) / safe
        defect = np.maximum(
            np.abs(own + size * way - motion.a[point]), np.abs(rate - motion.epsilon[group.body]) * np.abs(arm)
        )
        yield np.where(fit, defect * np.minimum(1.0, np.abs(sine)) / acceleration, 0.0)
    for floating in groups:
        if isinstance(floating, FloatingDyad):
            yield from (x / acceleration for x in _crossing(motion, floating, 2))


def _acceleration_centre(motion: Motion, groups: Sequence[Group]) -> Iterator[Field]:
    """``a = BQ sqrt(epsilon^2 + omega^4)`` for every point of every body that has an acceleration centre."""
    del groups
    if not motion.a:
        return
    acceleration = _largest_acceleration(motion)
    for body, members in motion.scene.bodies.items():
        omega, epsilon = motion.omega[body], motion.epsilon[body]
        rate = np.sqrt(epsilon**2 + omega**4)
        pole = members[0]
        fit = rate * motion.length_scale() > 1e-9 * acceleration
        distance = np.abs(motion.a[pole]) / np.where(fit, rate, 1.0)
        mu = np.arctan2(epsilon, omega**2)
        ray = motion.a[pole] * np.exp(1j * mu)
        length = np.where(np.abs(ray) > 0, np.abs(ray), 1.0)
        centre = motion.z[pole] + distance * ray / length
        for point in members[1:]:
            size = np.abs(motion.z[point] - centre) * rate
            far = 1.0 + distance / motion.length_scale()
            yield np.where(fit, np.abs(size - np.abs(motion.a[point])) / (acceleration * far), 0.0)


def _relative_motion(motion: Motion, groups: Sequence[Group]) -> Iterator[Field]:
    """``v_rel`` lies along the path, ``a = a_tr + a_cor + a_rel`` with ``a_rel`` along it but for its normal part."""
    speed = _speed(motion)
    for group in groups:
        if not isinstance(group, SlidingPair):
            continue
        pole = motion.scene.bodies[group.carrier][0]
        arm = motion.z[group.path.point] - motion.z[pole]
        omega = motion.omega[group.carrier]
        relative = motion.v[group.path.point] - motion.v[pole] - 1j * omega * arm
        ray = group.path.tangent(motion.z)
        yield cross(ray, relative) / speed
        if motion.a:
            transport = motion.a[pole] + (1j * motion.epsilon[group.carrier] - omega**2) * arm
            rest = motion.a[group.path.point] - transport - 2j * omega * relative
            yield cross(ray, rest - group.path.curvature(motion.z) * np.abs(relative) ** 2) / _largest_acceleration(
                motion
            )


def _three_rates(motion: Motion, groups: Sequence[Group]) -> Iterator[Field]:
    """Loops O A B C between two pivots: ``sum omega_k d_k = 0``, ``sum (epsilon_k + i omega_k^2) d_k = 0``."""
    linkage = Linkage(motion.scene)
    for group in groups:
        if not isinstance(group, Dyad) or not group.point_path.body:
            continue
        for first, members in motion.scene.bodies.items():
            pivot = linkage.pivot(first)
            if group.pole in members and pivot is not None:
                names = (pivot, group.pole, group.point_path.point, group.point_path.centre)
                yield from _loop(motion, names, (first, group.body, group.point_path.body))


def _loop(motion: Motion, points: tuple[str, ...], bodies: tuple[str, ...]) -> Iterator[Field]:
    """Rates of the second and third link of a loop from that of the first; as velocities at the size of the links."""
    d = [motion.z[end] - motion.z[start] for start, end in pairwise(points)]
    sine = cross(d[1], d[2])
    fit = np.abs(sine) > _FLAT * np.abs(d[1] * d[2])
    safe = np.where(fit, sine, 1.0)
    share = np.minimum(1.0, np.abs(sine) / np.abs(d[1] * d[2]))
    omega = [motion.omega[body] for body in bodies]
    known = omega[0] * d[0]
    found = [-cross(known, d[2]) / safe, cross(known, d[1]) / safe]
    for k in (1, 2):
        yield np.where(fit, np.abs(found[k - 1] - omega[k]) * np.abs(d[k]) * share / _speed(motion), 0.0)
    if motion.a:
        epsilon = [motion.epsilon[body] for body in bodies]
        known = epsilon[0] * d[0] + 1j * sum(w**2 * arm for w, arm in zip(omega, d, strict=True))
        found = [-cross(known, d[2]) / safe, cross(known, d[1]) / safe]
        for k in (1, 2):
            yield np.where(
                fit, np.abs(found[k - 1] - epsilon[k]) * np.abs(d[k]) * share / _largest_acceleration(motion), 0.0
            )


def _coordinates(motion: Motion, groups: Sequence[Group]) -> Iterator[Field]:
    """All constraint equations differentiated and solved at once."""
    del groups
    system = DenseSystem(motion)
    found = system.solve(1)
    length, speed = motion.length_scale(), _speed(motion)
    for name, v in found.points.items():
        yield np.abs(v - motion.v[name]) / speed
    for body, omega in found.bodies.items():
        yield np.abs(omega - motion.omega[body]) * length / speed
    if motion.a:
        acceleration, second = _largest_acceleration(motion), system.solve(2, found)
        for name, a in second.points.items():
            yield np.abs(a - motion.a[name]) / acceleration
        for body, epsilon in second.bodies.items():
            yield np.abs(epsilon - motion.epsilon[body]) * length / acceleration


_METHODS: dict[str, Callable[[Motion, Sequence[Group]], Iterator[Field]]] = {
    "velocity_centre": _velocity_centre,
    "projections": _projections,
    "velocity_pole": _velocity_pole,
    "acceleration_pole": _acceleration_pole,
    "acceleration_centre": _acceleration_centre,
    "relative_motion": _relative_motion,
    "three_rates": _three_rates,
    "coordinates": _coordinates,
}
