"""The kinds of quantities of an interval of time: extremes, instants, ways, means."""

from __future__ import annotations

from collections.abc import Callable, Mapping
from typing import Any

import numpy as np

from variantgen.families.quantities.kind import MAX, MEAN, MIN, WITH_EXTREMES, Computed, Kind
from variantgen.mechanism.motion import ComplexField, Field, Motion

IN_TIME, INSTANT_OF, ZERO = "t_", "t_", "t_zero_"  # max_t_v, the instants t_max_v, t_zero_v
_WITH_ZEROS = ("v", "a", "omega", "epsilon", "x", "y")
_EXTREMES = {MAX: "largest", MIN: "smallest"}

Vectors = Callable[[Motion, str], ComplexField]  # of a motion and a point


def of_interval(of_instant: Mapping[str, Kind], of_vector: Callable[[Vectors], Computed]) -> dict[str, Kind]:
    """The kinds by name, made of those of an instant and of what can be asked of a vector."""
    found = {
        "way": Kind("course", 1, "length", _of_one("way_of")),
        "instant": Kind("course", 1, "time", _instant),
        "turned": Kind("course", 1, "angle", _of_one("turned")),
        "duration": Kind("course", 1, "time", _of_one("duration")),
        INSTANT_OF + "back": Kind("course", 1, "time", _of_one("first_return")),
        "shift": Kind("course", 1, "length", of_vector(_change("change", 1, "z"))),
        "average_v": Kind("course", 1, "velocity", of_vector(_change("change_per_second", 1, "z"))),
        "average_a": Kind("course", 1, "acceleration", of_vector(_change("change_per_second", 1, "v"))),
    }
    for name in WITH_EXTREMES:
        kind = of_instant[name]
        order = max(1, kind.order)
        for word, find in _EXTREMES.items():
            found[word + IN_TIME + name] = Kind("course", order, kind.measure, _of_quantity(kind, find, "value"), name)
            found[INSTANT_OF + word + name] = Kind("course", order, "time", _of_quantity(kind, find, "time"), name)
    for name in _WITH_ZEROS:
        kind = of_instant[name]
        found[ZERO + name] = Kind("course", max(1, kind.order), "time", _of_quantity(kind, "first_zero"), name)
    for name in ("v", "omega"):
        kind = of_instant[name]
        found[MEAN + IN_TIME + name] = Kind("course", 1, kind.measure, _of_quantity(kind, "mean"), name)
    return found


def _of_quantity(kind: Kind, find: str, result: str = "") -> Computed:
    """What is found of a quantity over an interval of time: of the magnitude of a rate, but for a zero of it.

    ``find`` names a function of :mod:`variantgen.mechanism.turn.timed_values`, which few problems need, ``result`` what
    of the found is asked.
    """

    def value(motion: Motion, target: str, component: str) -> Field:
        part = "abs" if kind.group == "rotation" and find != "first_zero" else component
        is_magnitude = part == "abs" or (kind.group == "vector" and not part)

        def of_motion(at: Motion, _: object) -> Field:
            return kind.value(at, target, part)

        found = _found(motion, kind.order, find, of_motion, *([is_magnitude] if result else []))
        numbers: Field = getattr(found, result) if result else found
        return numbers

    return value


def _of_one(find: str) -> Computed:
    """What is found of a point or a body that moves in an interval of time."""

    def value(motion: Motion, target: str, _: str) -> Field:
        numbers: Field = _found(motion, 1, find, target)
        return numbers

    return value


def _instant(motion: Motion, target: str, _: str) -> Field:
    """The instant of the problem, which is found (s), shape (N,)."""
    course = motion.scene.course
    assert course is not None, "the scene states an interval of time"
    found: Field = np.array(np.broadcast_to(np.asarray(course.parameters[target], dtype=float), (motion.size,)))
    return found


def _change(find: str, order: int, name: str) -> Vectors:
    """The change over an interval of time of a vector of a point, which the motion has by that ``name``."""

    def vectors(motion: Motion, point: str) -> ComplexField:
        found: ComplexField = _found(motion, order, find, lambda at: getattr(at, name)[point])
        return found

    return vectors


def _found(motion: Motion, order: int, find: str, *what: object) -> Any:
    from variantgen.mechanism.turn import timed_motion, timed_values

    with np.errstate(all="ignore"):
        return getattr(timed_values, find)(timed_motion.timed_motion(motion, order), *what)
