"""The kinds of quantities of an interval of time: extremes, instants, ways, means."""

from __future__ import annotations

from collections.abc import Callable, Mapping

import numpy as np

from variantgen.families.quantities.kind import MAX, MEAN, MIN, WITH_EXTREMES, Computed, Kind
from variantgen.mechanism.motion import ComplexField, Field, Motion
from variantgen.mechanism.turn import timed_values
from variantgen.mechanism.turn.timed_motion import TimedMotion, timed_motion
from variantgen.mechanism.turn.timed_values import Scalar

IN_TIME, INSTANT_OF, ZERO = "t_", "t_", "t_zero_"  # max_t_v, the instants t_max_v, t_zero_v
_WITH_ZEROS = ("v", "a", "omega", "epsilon", "x", "y")

Vectors = Callable[[Motion, str], ComplexField]  # of a motion and a point


def _over_interval(kind: Kind, find: Callable[[TimedMotion, Scalar, bool], Field], signed: bool = False) -> Computed:
    """What is found of a quantity over an interval of time: of the magnitude of a rate unless it is ``signed``."""

    def value(motion: Motion, target: str, component: str) -> Field:
        part = "abs" if kind.group == "rotation" and not signed else component
        is_magnitude = part == "abs" or (kind.group == "vector" and not part)

        def of_motion(at: Motion, _: object) -> Field:
            return kind.value(at, target, part)

        with np.errstate(all="ignore"):
            return find(timed_motion(motion, kind.order), of_motion, is_magnitude)

    return value


def _of_passage(find: Callable[[TimedMotion, str], Field]) -> Computed:
    """What is found of a point or a body that moves in an interval of time."""

    def value(motion: Motion, target: str, _: str) -> Field:
        with np.errstate(all="ignore"):
            return find(timed_motion(motion, 1), target)

    return value


def _change(name: str, order: int, per_second: bool) -> Vectors:
    """The change of a vector over an interval of time, in all or per second."""

    def vectors(motion: Motion, point: str) -> ComplexField:
        timed = timed_motion(motion, max(1, order))
        with np.errstate(all="ignore"):
            found = timed_values.change(timed, lambda at: getattr(at, name)[point])
            return found / np.where(timed.complete, timed.duration, 1.0) if per_second else found

    return vectors


def _way(timed: TimedMotion, point: str) -> Field:
    return timed_values.way(timed, lambda motion, _: np.abs(motion.v[point]))


def of_interval(of_instant: Mapping[str, Kind], of_vector: Callable[[Vectors], Computed]) -> dict[str, Kind]:
    """The kinds by name, made of those of an instant and of what can be asked of a vector."""
    found = {
        "way": Kind("course", 1, "length", _of_passage(_way)),
        "turned": Kind("course", 1, "angle", _of_passage(timed_values.turned)),
        INSTANT_OF + "back": Kind("course", 1, "time", _of_passage(timed_values.first_return)),
        "shift": Kind("course", 1, "length", of_vector(_change("z", 1, False))),
        "average_v": Kind("course", 1, "velocity", of_vector(_change("z", 1, True))),
        "average_a": Kind("course", 1, "acceleration", of_vector(_change("v", 1, True))),
    }
    extremes = {MAX: timed_values.largest, MIN: timed_values.smallest}
    for name in WITH_EXTREMES:
        kind = of_instant[name]
        order = max(1, kind.order)
        for word, find in extremes.items():
            value = _over_interval(kind, lambda *found, find=find: find(*found).value)
            found[word + IN_TIME + name] = Kind("course", order, kind.measure, value, name)
            value = _over_interval(kind, lambda *found, find=find: find(*found).time)
            found[INSTANT_OF + word + name] = Kind("course", order, "time", value, name)
    for name in _WITH_ZEROS:
        kind = of_instant[name]
        value = _over_interval(kind, lambda timed, of, _: timed_values.first_zero(timed, of), signed=True)
        found[ZERO + name] = Kind("course", max(1, kind.order), "time", value, name)
    for name in ("v", "omega"):
        kind = of_instant[name]
        value = _over_interval(kind, lambda timed, of, _: timed_values.mean(timed, of))
        found[MEAN + IN_TIME + name] = Kind("course", 1, kind.measure, value, name)
    return found
