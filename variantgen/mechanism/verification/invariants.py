"""Theorems of plane kinematics that every motion obeys, as the size of their violation; of whatever solver it comes.

Each function takes a :class:`~variantgen.mechanism.motion.Motion` and gives one number for each variant, shape (N,):
zero but for rounding for a motion that is right, and relative, so that 1e-9 means nine digits.
"""

from __future__ import annotations

from collections.abc import Iterator
from typing import Any

import numpy as np

from variantgen.mechanism.arithmetic import Complex, cross, dot
from variantgen.mechanism.centres import velocity_centre
from variantgen.mechanism.motion import Field, Motion
from variantgen.mechanism.relative import relative_motion
from variantgen.mechanism.rows import Placement
from variantgen.mechanism.verification.closure_residuals import ClosureResiduals

_TIME_STEP = 1e-4  # over which drivers are followed, in the time that the fastest part takes for its own size


def equal_projections(motion: Motion) -> Field:
    """The velocities of two points of a body have equal projections on the line through them, shape (N,).

    Largest difference of the projections by the largest velocity. Needs positions and velocities of points alone.
    """
    defects: list[Field] = []
    for members in motion.scene.bodies.values():
        for number, point in enumerate(members):
            for other in members[:number]:
                line = motion.z[point] - motion.z[other]
                # Two names of one place move alike anyway.
                defects.append(np.abs(dot(line, motion.v[point] - motion.v[other])) / _one_for_zero(np.abs(line)))
    return _largest(motion, defects) / _one_for_zero(_fastest(motion))


def centre_consistent(motion: Motion) -> Field:
    """Velocities are perpendicular to the rays from the velocity centre and omega times as large, shape (N,).

    Of all points of all bodies, by the largest velocity. A far centre is the difference of nearly equal numbers: there
    the violation counts in proportion less.
    """
    _check_rotations(motion)
    defects: list[Field] = []
    for body, members in motion.scene.bodies.items():
        centre = velocity_centre(motion, body)
        for point in members:
            ray = motion.z[point] - centre.z
            size = _one_for_zero(np.abs(ray))
            along = dot(ray, motion.v[point])
            across = cross(ray, motion.v[point]) - motion.omega[body] * np.abs(ray) ** 2
            far = 1.0 + np.abs(ray) / motion.length_scale()
            defects += [np.where(centre.finite, np.abs(x) / size / far, 0.0) for x in (along, across)]
    return _largest(motion, defects) / _one_for_zero(_fastest(motion))


def coriolis_direction(motion: Motion) -> Field:
    """A point that slides on a body does so along its slot, in velocity and in acceleration, shape (N,).

    What is left of its acceleration without that of the place below it and without ``2 i omega v_rel``, the relative
    velocity turned with the body, must lie along the slot (towards the centre of a curved one, ``v_rel^2 / rho``). Who
    forgets the acceleration of Coriolis, or turns it the other way, violates it. Relative to the largest velocity or
    acceleration; without accelerations only the relative velocity is looked at. Zero where nothing slides.
    """
    defects: list[Field] = []
    speed, acceleration = _one_for_zero(_fastest(motion)), None
    if motion.a:
        acceleration = _one_for_zero(np.max([np.abs(a) for a in motion.a.values()], axis=0))
    for slide in [slide for joint in motion.scene.joints if (slide := joint.sliding())]:
        _check_rotations(motion)
        relative = relative_motion(motion, slide.point, slide.body)
        ray = slide.tangent(motion.z)
        defects.append(np.abs(cross(ray, relative.velocity)) / speed)
        if acceleration is not None and relative.acceleration is not None:
            normal = slide.curvature(motion.z) * np.abs(relative.velocity) ** 2
            defects.append(np.abs(cross(ray, relative.acceleration - normal)) / acceleration)
    return _largest(motion, defects)


def rolling_contact_at_rest(motion: Motion) -> Field:
    """Two bodies that touch without slip have one velocity at the contact, shape (N,): on a fixed rail, none.

    By the largest velocity; zero where nothing rolls.
    """
    at = Placement(motion.z, motion.frame)
    defects: list[Field] = []
    for contact in [contact for joint in motion.scene.joints if (contact := joint.contact_at(at))]:
        _check_rotations(motion)
        slip = _material(motion, contact.body, contact.place) - _material(motion, contact.other, contact.place)
        defects.append(np.abs(slip))
    return _largest(motion, defects) / _one_for_zero(_fastest(motion))


def power_balance_of_constraints(motion: Motion) -> Field:
    """Whatever forces act in joints and inside bodies, their power is zero, shape (N,): ideal constraints do no work.

    A unit force in each constraint in turn (a couple of one unit by the size of the mechanism where it holds a
    rotation), its power by that of the same force at the fastest point; in a driver, by what it prescribes. The
    directions of these forces are those in which the closing equations change with positions, so neither the rows nor
    the blocks of the solver are used; they are found by central differences, so that some 1e-9 are left.
    """
    _check_rotations(motion)
    chain, scene = ClosureResiduals(motion), motion.scene
    speed = np.max([_fastest(motion), *(np.abs(rate) * chain.length for rate in motion.omega.values())], axis=0)
    pace = _one_for_zero(speed) / chain.length
    rates = [part for body, members in scene.bodies.items() for part in _rates(motion, members[0], body)]
    rates += [part for point in chain.single for part in _rates(motion, point)]
    still, step = np.zeros((motion.size, chain.unknowns)), _TIME_STEP / pace
    driven = (chain.residual(still, step) - chain.residual(still, -step)) / (2 * step[:, None])
    moved = np.einsum("nij,nj->ni", chain.jacobian(), np.stack(rates, axis=-1)) if rates else 0.0 * driven
    defects = list(np.abs(moved + driven).T / pace)
    for body, members in scene.bodies.items():
        defects += [
            np.abs(motion.v[point] - _material(motion, (body, members[0]), motion.z[point])) / _one_for_zero(speed)
            for point in members[1:]
        ]
    return _largest(motion, defects)


def _rates(motion: Motion, point: str, body: str = "") -> Iterator[Field]:
    """How fast the unknowns of the closing equations change that belong to a body with its first point, or to a
    point.
    """
    velocity = motion.v[point] / motion.length_scale()
    yield np.real(velocity)
    yield np.imag(velocity)
    if body:
        yield motion.omega[body]


def _material(motion: Motion, body: tuple[str, str] | None, place: Complex) -> Complex:
    """Velocity of the point of a body (name, one of its points) that is at a place; zero for the ground."""
    if body is None:
        return 0.0
    name, pole = body
    return motion.v[pole] + 1j * motion.omega[name] * (place - motion.z[pole])


def _fastest(motion: Motion) -> Field:
    """The largest velocity of a point (m/s)."""
    return np.asarray(np.max([np.abs(v) for v in motion.v.values()], axis=0))


def _largest(motion: Motion, defects: list[Field]) -> Field:
    return np.asarray(np.max([np.zeros(motion.size), *defects], axis=0))


def _one_for_zero(x: Any) -> Field:
    return np.where(x > 0, x, 1.0)


def _check_rotations(motion: Motion) -> None:
    """Raise ValueError where the angular velocity of a body is not known."""
    missing = motion.scene.bodies.keys() - motion.omega.keys()
    if missing:
        raise ValueError(f"the angular velocity of {', '.join(sorted(missing))} is needed, in rad/s")
