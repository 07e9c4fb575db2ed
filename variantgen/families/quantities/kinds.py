"""The kinds of quantities that may be asked: what each needs of the motion, what it measures, how it is computed.

One entry of :data:`KINDS` per kind: whoever wants to know anything of a kind looks there.
"""

from __future__ import annotations

import re
from collections.abc import Callable, Mapping
from dataclasses import dataclass
from typing import Any

import numpy as np

from variantgen.mechanism.centres import acceleration_centre, velocity_centre
from variantgen.mechanism.motion import ComplexField, Field, Motion
from variantgen.mechanism.point_path import curvature_radius, normal_acceleration, tangential_acceleration
from variantgen.mechanism.relative import relative_motion, sliding_points
from variantgen.mechanism.rope_speed import rope_piece, rope_speed

ROPE = "v_rope"  # the kind whose name has a dot before both of its points
ALONG, ACROSS = "along_", "across_"  # before the two points of a named direction
_ENDS = re.compile(r"([A-Za-z]\d*)([A-Za-z]\d*)")
MAX, MIN, ANGLE_OF, MEAN = "max_", "min_", "phi_", "mean_"  # before a kind: what is asked of a turn of the crank
NATURAL = {"t": tangential_acceleration, "n": normal_acceleration}  # components of an acceleration along the path

Computed = Callable[[Motion, str, str], Field]  # of a motion, a target and what is asked of it, in SI


@dataclass(frozen=True)
class Kind:
    """A kind of quantities: ``group`` tells how it is named and read, ``measure`` is that of its value.

    ``order`` is 0 if positions are enough to know it, 1 if velocities are needed, 2 if accelerations. ``of`` is the
    kind of which an extreme or a mean value over a turn of the crank is taken.
    """

    group: str
    order: int
    measure: str
    value: Computed
    of: str = ""


def line_ends(text: str, points: Mapping[str, object]) -> tuple[str, str] | None:
    """The two points whose names make up a text, ``("O1", "A")`` of ``O1A``; None where it is no such text.

    A point is told from the next by its letter: names of several letters could be read in two ways.
    """
    found = _ENDS.fullmatch(text)
    if found is None or found[1] == found[2] or not {found[1], found[2]} <= points.keys():
        return None
    return found[1], found[2]


def direction(motion: Motion, text: str) -> ComplexField:
    """The unit vector from the first of two points to the second, shape (N,); zero where they coincide."""
    start, end = _ends(motion, text)
    step = motion.z[end] - motion.z[start]
    length = np.abs(step)
    found: ComplexField = step / np.where(length > 0, length, 1.0)
    return found


def _ends(motion: Motion, text: str) -> tuple[str, str]:
    ends = line_ends(text, motion.scene.points)
    if ends is None:
        raise ValueError(f"{text} is not made of the names of two points")
    return ends


def _of_vector(vectors: Callable[[Motion, str], ComplexField]) -> Computed:
    """The magnitude of a vector, one of its components, its direction."""

    def value(motion: Motion, target: str, component: str) -> Field:
        if component in NATURAL:
            return NATURAL[component](motion, target)
        vector = vectors(motion, target)
        if component.startswith((ALONG, ACROSS)):
            seen = vector * np.conj(direction(motion, component.partition("_")[2]))
            return np.real(seen) if component.startswith(ALONG) else np.imag(seen)
        match component:
            case "x":
                return np.real(vector)
            case "y":
                return np.imag(vector)
            case "angle":
                return np.asarray(np.angle(vector))
        return np.abs(vector)

    return value


def _relative(part: str) -> Callable[[Motion, str], ComplexField]:
    """A vector of the relative motion of a sliding point."""

    def vectors(motion: Motion, point: str) -> ComplexField:
        found = getattr(relative_motion(motion, point, sliding_points(motion.scene)[point]), part)
        if found is None:
            raise ValueError(f"the relative {part} of {point} needs accelerations, which were not computed")
        vector: ComplexField = found
        return vector

    return vectors


def _of_rotation(order: int) -> Computed:
    """A rate with its sign, its magnitude, its sense."""

    def value(motion: Motion, body: str, component: str) -> Field:
        rate = (motion.omega if order == 1 else motion.epsilon)[body]
        if component == "sense":
            return np.sign(rate)
        return np.abs(rate) if component == "abs" else rate

    return value


def _of_centre(order: int) -> Computed:
    """The distance of a point from a centre, or a coordinate of it; infinite for a centre at infinity."""

    def value(motion: Motion, body: str, component: str) -> Field:
        centre = (velocity_centre if order == 1 else acceleration_centre)(motion, body)
        if component in ("x", "y"):
            size = np.real(centre.z) if component == "x" else np.imag(centre.z)
        else:
            size = np.abs(motion.z[component] - centre.z)
        found: Field = np.where(centre.finite, size, np.inf)
        return found

    return value


def _centre_angle(motion: Motion, body: str, _: str) -> Field:
    found: Field = np.arctan2(np.abs(motion.epsilon[body]), motion.omega[body] ** 2)
    return found


def _angle(motion: Motion, target: str, component: str) -> Field:
    """The direction of the line of two points, or the corner at a point between two others."""
    if not component:
        return np.asarray(np.angle(direction(motion, target)))
    corner, last = component.split(".")
    arms = [motion.z[point] - motion.z[corner] for point in (target, last)]
    return np.abs(np.angle(arms[1] * np.conj(arms[0])))


def _ratio(motion: Motion, body: str, other: str) -> Field:
    above, below = motion.omega[body], motion.omega[other]
    found: Field = np.where(below != 0, above / np.where(below != 0, below, 1.0), np.inf)
    return found


def _rope(motion: Motion, first: str, second: str) -> Field:
    piece = rope_piece(motion.scene, first, second)
    if piece is None:
        raise ValueError(f"no rope runs from {first} to {second}")
    return rope_speed(motion, piece)


def _over_turn(kind: Kind, find: str, result: str = "") -> Computed:
    """What is found of a quantity over a turn of the crank: of the magnitude of a rate.

    ``find`` names a function of :mod:`variantgen.mechanism.turn.turn_values`, which few problems need.
    """

    def value(motion: Motion, target: str, component: str) -> Field:
        part = "abs" if kind.group == "rotation" else component

        def of_motion(at: Motion, _: object) -> Field:
            return kind.value(at, target, part)

        found = _found_over_turn(motion, kind.order, find, of_motion)
        numbers: Field = getattr(found, result) if result else found
        return numbers

    return value


def _to_and_fro(find: str) -> Computed:
    """What is found of a point or a body that moves to and fro in a turn of the crank."""

    def value(motion: Motion, target: str, _: str) -> Field:
        found: Field = _found_over_turn(motion, 1, find, target)
        return found

    return value


def _found_over_turn(motion: Motion, order: int, find: str, what: object) -> Any:
    from variantgen.mechanism.turn import crank_turn, turn_values

    with np.errstate(all="ignore"):
        return getattr(turn_values, find)(crank_turn.crank_turn(motion, order), what)


_OF_INSTANT: Mapping[str, Kind] = {
    "v": Kind("vector", 1, "velocity", _of_vector(lambda motion, point: motion.v[point])),
    "a": Kind("vector", 2, "acceleration", _of_vector(lambda motion, point: motion.a[point])),
    "v_rel": Kind("relative", 1, "velocity", _of_vector(_relative("velocity"))),
    "a_rel": Kind("relative", 2, "acceleration", _of_vector(_relative("acceleration"))),
    "a_cor": Kind("relative", 2, "acceleration", _of_vector(_relative("coriolis"))),
    "omega": Kind("rotation", 1, "angular velocity", _of_rotation(1)),
    "epsilon": Kind("rotation", 2, "angular acceleration", _of_rotation(2)),
    "P": Kind("centre", 1, "length", _of_centre(1)),
    "Q": Kind("centre", 2, "length", _of_centre(2)),
    "mu": Kind("centre angle", 2, "angle", _centre_angle),
    "rho": Kind("path", 2, "length", lambda motion, point, _: curvature_radius(motion, point)),
    "ratio": Kind("ratio", 1, "number", _ratio),
    ROPE: Kind("rope", 1, "velocity", _rope),
    "x": Kind("position", 0, "length", lambda motion, point, _: np.real(motion.z[point])),
    "y": Kind("position", 0, "length", lambda motion, point, _: np.imag(motion.z[point])),
    "angle": Kind("position", 0, "angle", _angle),
    "distance": Kind("position", 0, "length", lambda motion, a, b: np.abs(motion.z[a] - motion.z[b])),
}

_EXTREMES = {MAX: "largest", MIN: "smallest"}
_WITH_EXTREMES = ("v", "a", "omega", "epsilon", "x", "y", "angle", "distance")


def _of_turn() -> dict[str, Kind]:
    found = {"stroke": Kind("turn", 1, "length", _to_and_fro("travel"))}
    found["swing"] = Kind("turn", 1, "angle", _to_and_fro("travel"))
    found["time_ratio"] = Kind("turn", 1, "number", _to_and_fro("time_ratio"))
    for name in _WITH_EXTREMES:
        kind = _OF_INSTANT[name]
        order = max(1, kind.order)
        for word, find in _EXTREMES.items():
            found[word + name] = Kind("turn", order, kind.measure, _over_turn(kind, find, "value"), name)
        for word, find in _EXTREMES.items():
            found[ANGLE_OF + word + name] = Kind("turn", order, "angle", _over_turn(kind, find, "angle"), name)
    for name in ("v", "omega"):
        kind = _OF_INSTANT[name]
        found[MEAN + name] = Kind("turn", 1, kind.measure, _over_turn(kind, "mean"), name)
    return found


KINDS: Mapping[str, Kind] = {**_OF_INSTANT, **_of_turn()}
