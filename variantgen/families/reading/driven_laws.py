"""Whether drivers move what laws of time place as these laws say, and accelerations are derivatives of velocities.

Compared are numbers, at an instant t and shortly before and after it, for values from all over the parameters.
"""

from __future__ import annotations

import re
from collections.abc import Callable, Collection, Iterator, Mapping, Sequence
from typing import Any

import numpy as np
from msgspec.structs import replace
from numpy.typing import NDArray

from variantgen.errors import InputError, Problem
from variantgen.families.family import ComponentTemplate, Form
from variantgen.families.parameters.draw_rules import Pose
from variantgen.families.parameters.expressions import FamilyExpression
from variantgen.families.parameters.parameter import Parameter
from variantgen.mechanism.arithmetic import Complex, Real
from variantgen.mechanism.component import field_specs
from variantgen.mechanism.constructions.coordinates import Coordinates
from variantgen.mechanism.constructions.polar import Polar
from variantgen.mechanism.rows import Placement
from variantgen.mechanism.scene import Scene
from variantgen.mechanism.solving.solve import place

_DRAWS = 32
_STEP = 2e-5  # s; short for a fast machine, and rounding does not show in the differences
_NEAR = 0.01  # relative difference of rates that are the same
_UNITS = {"velocity": "m/s", "acceleration": "m/s^2", "angular velocity": "rad/s", "angular acceleration": "rad/s^2"}


def with_accelerations(
    drivers: Sequence[ComponentTemplate], laws: Collection[str], expression: Callable[[str], FamilyExpression]
) -> tuple[ComponentTemplate, ...]:
    """The drivers, each whose velocity is by a law of time with the acceleration by the same law.

    One that states no acceleration gets that with ``x_ddot`` in the place of ``x_dot``, along the velocity: the
    derivative where all else is constant, and :func:`check_driven` refuses it where it is not.
    """

    def whole(template: ComponentTemplate) -> ComponentTemplate:
        velocity = _field(template, "velocity")
        lacking = [spec.name for spec in field_specs(template.component) if _measures(spec.dimension, "acceleration")]
        if velocity is None or not lacking or lacking[0] in template.fields:
            return template
        if not velocity[1].names & {f"{law}_dot" for law in laws}:
            return template
        text = re.sub(rf"\b({'|'.join(map(re.escape, laws))})_dot\b", r"\1_ddot", velocity[1].text)
        added = {lacking[0]: expression(text)}
        if "angle" in template.fields and "a_angle" in (spec.name for spec in field_specs(template.component)):
            added = {"a_angle": template.fields["angle"]} | added
        return replace(template, fields={**added, **template.fields})

    return tuple(map(whole, drivers))


def as_written(form: Form) -> Form:
    """The form of a scene, never reflected or turned where its laws tell places and directions by the axes x and y."""
    by_axes = {Coordinates: ("x", "y"), Polar: ("angle",)}
    stated = [
        template.fields.get(field)
        for template in form.points.values()
        for field in by_axes.get(template.component, ())
        if "towards" not in template.fields
    ]
    by_law = any(item.names & form.laws.keys() for item in stated if isinstance(item, FamilyExpression))
    return replace(form, pose=Pose(mirror=False)) if by_law else form


def check_driven(form: Form, time: str) -> None:
    """Raise InputError for drivers that contradict the law of time by which their place or their velocity is given.

    ``time`` is the parameter that is the instant, or the place whose velocity is given. A place that no law gives, or
    that cannot be assembled, proves nothing and is passed over.
    """
    base = _with_meaning(form, _draws(form))
    rate = form.values(base).get(f"{time}_dot", 1.0)  # of a place its velocity
    values = [form.values(base | {time: base[time] + side * _STEP * rate}) for side in (0, 1, -1)]
    instant = _instants(form.parameters[time], base[time])
    derived = {f"{law}{dots}": law for law in form.laws for dots in ("_dot", "_ddot")}
    problems = list(_stretched(form))
    for i, template in enumerate(form.drivers):
        velocity, acceleration = _field(template, "velocity"), _field(template, "acceleration")
        if velocity is None or not velocity[1].names & derived.keys():
            continue
        used = sorted({law for name, law in derived.items() if name in template.names})
        key = f"drivers[{i + 1}]"
        if wrong := _by_place(form, i, values, used):
            remedy = (
                f"{' and '.join(f'laws.{law}' for law in used)} gives the place that is driven: let both say the same"
            )
            problems.append(_problem(key, velocity, wrong, "its place changes at", instant, remedy))
        elif acceleration and acceleration[1].names & derived.keys() and (wrong := _by_velocity(template, values)):
            remedy = f'give the derivative of {velocity[0]} = "{velocity[1].text}"'
            problems.append(_problem(key, acceleration, wrong, f"{velocity[0]} changes at", instant, remedy))
    if problems:
        raise InputError(problems)


def _stretched(form: Form) -> Iterator[Problem]:
    """Bodies, which are rigid, with a point whose distance from another one of theirs is a law of time.

    A point in the place of another one is named anew at every instant, and so may be at another place of its body.
    """
    for body, members in form.bodies.items():
        for name in members:
            template = form.points[name]
            distance = template.fields.get("distance")
            law = distance.names & form.laws.keys() if isinstance(distance, FamilyExpression) else set()
            alone = sum(other is template for other in form.points.values()) == 1
            if law and alone and template.fields.get("origin") in members:
                said = f"{body} is rigid, and the distance of its points {template.fields['origin']} and {name} changes"
                remedy = f'let {name} slide in it: another point in its place (S = "{name}") in the body, and a slot'
                yield Problem(said, key=f"points.{name}", value=" and ".join(sorted(law)), remedy=remedy)


_Field = tuple[str, FamilyExpression, str]  # its name, what is written there, the unit of its rate
_Wrong = tuple[int, float, float]  # the draw, the rate that the law gives, the rate of the driver
_Values = Mapping[str, Real]


def _draws(form: Form) -> dict[str, NDArray[np.float64]]:
    """Values (SI) of all parameters, from all over their ranges."""
    found = {}
    for i, (name, parameter) in enumerate(form.parameters.items()):
        words = np.random.Philox(i).random_raw(_DRAWS)
        found[name] = parameter.si[(words % np.uint64(len(parameter.si))).astype(int)]
    return found


def _with_meaning(form: Form, draws: Mapping[str, NDArray[np.float64]]) -> dict[str, NDArray[np.float64]]:
    """The draws, in the place of those for which a law has no value others for which all have one."""
    values = form.values(draws)
    rates = [
        form.derived[law + dots] for law in form.laws for dots in ("", "_dot", "_ddot") if law + dots in form.derived
    ]
    known = np.logical_and.reduce([np.broadcast_to(rate.defined(values), _DRAWS) for rate in rates])
    chosen = np.where(known, np.arange(_DRAWS), np.argmax(known))
    return {name: drawn[chosen] for name, drawn in draws.items()}


def _field(template: ComponentTemplate, measure: str) -> _Field | None:
    """The field of a driver that is a velocity or an acceleration, of a point or of a body."""
    for spec in field_specs(template.component):
        item = template.fields.get(spec.name)
        if _measures(spec.dimension, measure) and isinstance(item, FamilyExpression):
            return spec.name, item, _UNITS[spec.dimension]
    return None


def _measures(dimension: str, measure: str) -> bool:
    return dimension in (measure, f"angular {measure}")


def _by_place(form: Form, driver: int, values: Sequence[_Values], used: Sequence[str]) -> _Wrong | None:
    """Where the rate of a driver is not that of the place that it drives, which moves by the ``used`` laws alone."""
    still = {law: values[0][law] for law in form.laws if law not in used}
    scenes = [form.scene({**moved, **still}) for moved in values]
    placed = [place(scene, form.plan) for scene in scenes]
    solved = np.logical_and.reduce([np.broadcast_to(np.equal(outcome, 0), _DRAWS) for _, outcome in placed])
    at = [z for z, _ in placed]
    driven, frame = scenes[0].drivers[driver], scenes[0].frame
    contacts = _contacts(scenes[0], at[0])
    bodies = {body for shape in driven.shapes() for body in shape.bodies}
    if contacts & {point for shape in driven.shapes() for point in shape.points}:
        return None
    turned: list[dict[str, Real]] = [{}, {}, {}]
    for body in bodies:
        members = [point for point in scenes[0].bodies[body] if point not in contacts]
        for side in (1, 2):
            turned[side][body], rigid = _turn(members, at[0], at[side])
            solved = solved & rigid
    start = Placement(at[0], frame)
    ahead = driven.residual(Placement(at[1], frame, turned[1]), start, _STEP)
    back = driven.residual(Placement(at[2], frame, turned[2]), start, -_STEP)
    for given, after, before in zip(driven.rates(1), ahead, back, strict=True):
        right = given + (after - before) / (2 * _STEP)
        # A place that stays is not given by the law; where it turns back, differences say little.
        usable = solved & (np.abs(right) > 1e-6) & (np.abs(after + before) < 0.1 * _STEP * np.abs(right))
        if wrong := _worst(right, given, usable):
            return wrong
    return None


def _contacts(scene: Scene, z: Mapping[str, Complex]) -> set[str]:
    """Points that no body carries along: contacts of wheels."""
    at = Placement(z, scene.frame, dict.fromkeys(scene.bodies, 0.0))
    return {point for joint in scene.joints for point in joint.marked(at, at)}


def _turn(members: Sequence[str], start: Mapping[str, Complex], moved: Mapping[str, Complex]) -> tuple[Real, Any]:
    """The angle (rad) through which the points of a body have turned, and whether they have done so as one body."""
    for end in members[1:]:
        before, after = start[end] - start[members[0]], moved[end] - moved[members[0]]
        if np.all(np.abs(before) > 0):
            ratio = after / before
            return np.angle(ratio), np.abs(np.abs(ratio) - 1) < 1e-3 * np.abs(ratio - 1) + 1e-11
    return 0.0, False


def _by_velocity(template: ComponentTemplate, values: Sequence[_Values]) -> _Wrong | None:
    """Where the acceleration of a driver is not the derivative of its velocity."""
    now, ahead, back = (template.build(moved) for moved in values)
    for given, after, before in zip(now.rates(2), ahead.rates(1), back.rates(1), strict=True):
        if wrong := _worst((after - before) / (2 * _STEP), given, True):
            return wrong
    return None


def _worst(right: Real, given: Real, usable: Any) -> _Wrong | None:
    """The first draw in which two rates (SI) differ by more than the error of differences."""
    right, given, usable = np.broadcast_arrays(right, given, np.broadcast_to(usable, _DRAWS))
    apart = usable & (np.abs(right - given) > _NEAR * (np.abs(right) + np.abs(given)) + 1e-7)
    first = int(np.argmax(apart))
    return (first, float(right[first]), float(given[first])) if apart[first] else None


def _instants(parameter: Parameter, values: NDArray[np.float64]) -> list[str]:
    """What each draw says of the instant, or of the place whose velocity is given, in the unit of the file."""
    own = parameter.unit
    assert own is not None, "instants and places are measured"
    return [f"{parameter.name} = {own.from_si(float(value)):.4g} {own.name}" for value in values]


def _problem(key: str, field: _Field, wrong: _Wrong, what: str, instants: Sequence[str], remedy: str) -> Problem:
    name, expression, unit = field
    draw, right, given = wrong
    said = f"expected {right:.4g} {unit}, for at {instants[draw]} {what} this rate, but it is {given:.4g} {unit}"
    return Problem(said, key=f"{key}.{name}", value=expression.text, remedy=remedy)
