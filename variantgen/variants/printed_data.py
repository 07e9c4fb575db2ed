"""What the asked quantities of a variant need: which data are given, which points are shown."""

from __future__ import annotations

from collections.abc import Sequence
from functools import lru_cache

from variantgen.families.family import Form
from variantgen.families.parameters.parameter import Parameter
from variantgen.families.quantities import Quantity, motion_order
from variantgen.mechanism.linkage import Linkage
from variantgen.mechanism.rows import Placement
from variantgen.mechanism.solving.solve import place
from variantgen.variants.variant import Variant


def given_names(variant: Variant, asked: Sequence[Quantity]) -> list[str]:
    """Names of the parameters that are printed, in the order of printing."""
    return list(_given(variant.form, _points_of(variant.form, tuple(asked)), _without(variant, asked)))


def max_distinct_problems(form: Form, asked: Sequence[Quantity]) -> int:
    """An upper bound of the different problems on the grid of a form, by printed data and answers."""
    idle = _unneeded(form, _points_of(form, tuple(asked)))
    velocities_only = motion_order(asked) == 1
    size = (len(form.ties.rows) if form.ties else 1) * _ways_on_paper(form, asked)
    for name in form.free_names:
        parameter = form.parameters[name]
        if name not in idle and not (name in form.of_accelerations_alone and velocities_only):
            size *= len(parameter.printed)
    return size


def _ways_on_paper(form: Form, asked: Sequence[Quantity]) -> int:
    """How many different answers the same mechanism has at most, as it is mirrored and turned on paper."""
    if any(quantity.refers_to_axes for quantity in asked):
        return len(form.pose.frames())
    signed = any(quantity.turns_with_mirror for quantity in asked)
    return 2 if signed and form.pose.mirror else 1


def _rank(parameter: Parameter) -> int:
    """Lengths first, then angles and numbers, times, velocities, accelerations, constants."""
    if parameter.constant:
        return 5
    if parameter.is_rate:
        return 4 if parameter.of_second_order else 3
    measures = parameter.unit.measures if parameter.unit else ""
    return {"length": 0, "time": 2}.get(measures, 1)


def shown_points(variant: Variant, asked: Sequence[Quantity]) -> list[str]:
    """Points that the figure shows: all but plain points of a body that nobody asks for."""
    return list(_shown(variant.form, _points_of(variant.form, tuple(asked))))


def _without(variant: Variant, asked: Sequence[Quantity]) -> frozenset[str]:
    """Parameters of accelerations alone that are not printed: all, where only velocities are asked, and zeros."""
    names = variant.form.of_accelerations_alone
    if motion_order(asked) == 1:
        return names
    return frozenset([name for name in names if variant.printed[name] == 0])


@lru_cache(maxsize=1000)
def _given(form: Form, asked: tuple[str, ...], without: frozenset[str]) -> tuple[str, ...]:
    """The parameters that are printed, in the order of printing, the same for all variants of a form."""
    idle = _unneeded(form, asked) | without
    names = [name for name, parameter in form.parameters.items() if parameter.given and name not in idle]
    return tuple(sorted(names, key=lambda name: _rank(form.parameters[name])))


@lru_cache(maxsize=1000)
def _points_of(form: Form, asked: tuple[Quantity, ...]) -> tuple[str, ...]:
    """The points that the asked quantities speak of."""
    named = (quantity.points(form.points) or ("",) for quantity in asked)
    return tuple(dict.fromkeys(point for points in named for point in points))


def _unneeded(form: Form, asked: tuple[str, ...]) -> frozenset[str]:
    """Parameters that place only points which are not asked for, the same for all variants of a form."""
    shown = _shown(form, asked)
    used: set[str] = set()
    idle: set[str] = set()
    for name, template in form.points.items():
        (used if name in shown or name in form.figure.hidden else idle).update(template.names)
    for template in (*form.conditions, *form.joints, *form.drivers):
        used |= template.names
    for derived, expression in reversed(list(form.derived.items())):
        if derived in used:
            used |= expression.names
        else:
            idle |= expression.names
    return frozenset(idle - used)


@lru_cache(maxsize=1000)
def _shown(form: Form, asked: tuple[str, ...]) -> tuple[str, ...]:
    """Points that the figure shows, the same for all variants of a form."""
    scene = form.sample
    count: dict[str, int] = {}
    for members in form.bodies.values():
        for point in members:
            count[point] = count.get(point, 0) + 1
    discs = {disc.body for disc in form.figure.discs}
    plates = set(form.figure.plates)
    ends = {
        p
        for body, members in form.bodies.items()
        if body not in discs
        for p in (members if body in plates else members[:2])
    }
    named = {p for c in scene.constraints for shape in c.shapes() for p in shape.points}
    named |= {*form.figure.named, *(p for joint in scene.joints for p in joint.landmarks())}
    named |= {*Linkage(scene).aslant_stations(Placement(place(scene, form.plan)[0], scene.frame))}
    return tuple(
        p
        for p in form.points
        if p not in form.figure.hidden and (count.get(p, 0) > 1 or p in ends or p in named or p in asked)
    )
