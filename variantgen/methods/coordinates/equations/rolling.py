"""Rolling on a straight line, fixed or of a moving body: the way along the line is the arc that is rolled off."""

from __future__ import annotations

from typing import TYPE_CHECKING

from variantgen.algebra.expression import Expression
from variantgen.algebra.normal_form import Maybe, added, product
from variantgen.methods.geometry.geometry import degrees
from variantgen.methods.steps.step import Body, Fact, Point

if TYPE_CHECKING:
    from variantgen.mechanism.joints.rolling import Rolling
    from variantgen.methods.coordinates.model import Model

_LEVEL = 1e-12


def prepare(model: Model, joint: Rolling, template: None) -> None:
    """On a fixed line along an axis the centre keeps one coordinate."""
    if joint.on is None:
        arm = model.now(joint.contact, joint.centre)
        for axis, part in enumerate((arm.imag, arm.real)):
            if abs(part) < _LEVEL * abs(arm):
                model.hold(joint.centre, axis)


def state(model: Model, joint: Rolling, template: None) -> None:
    """``z_O = z_K + h n + s u``: h the radius, s the way rolled, u the line, which may turn with its body.

    The way is ``-r (phi - Phi)`` along the line that has the wheel on its left; angles count from the given place.
    """
    centre, contact, on = joint.centre, joint.contact, joint.on
    arm = model.now(contact, centre)
    radius = model.radius(joint.body, centre, abs(arm))
    turn = added((1, model.swept(joint.body)), (-1, model.swept(on) if on else None))
    along = model.turned(on, degrees(-1j * arm))  # the line with the wheel on its left
    rolled = along.ray(product(radius, turn))
    way = tuple(product(model.minus, part) for part in rolled)
    facts: dict[str, Fact] = {"body": Body(joint.body), "centre": Point(centre)}
    if joint.axle_held:
        _along_line(model, joint, radius, turn, facts)
    elif on is None or joint.on_point is None:
        for axis in (0, 1):
            if not model.is_held(centre, axis):
                model.add_sum("rolling", model.of(centre, axis), model.start(centre, axis), way[axis], **facts)
    else:
        base = model.now(joint.on_point, centre)
        held = model.turned(on, degrees(base)).ray(model.offset(abs(base))) if base else (None, None)
        model.add_vector("rolling_on", joint.on_point, centre, [held, (way[0], way[1])], on=Body(on), **facts)


def _along_line(model: Model, joint: Rolling, radius: Expression, turn: Maybe, facts: dict[str, Fact]) -> None:
    """Only the way along the line: other joints keep the distance from it."""
    centre, on = joint.centre, joint.on
    arm = model.now(joint.contact, centre)
    direction = model.turned(on, degrees(-1j * arm)).ray(model.one)
    start = joint.on_point
    shifts = [model.shift(start, centre, axis) if start else model.of(centre, axis) for axis in (0, 1)]
    base = model.now(start, centre) if start else model.task.now.z[centre]
    line = -1j * arm / abs(arm)
    along_line = model.offset((base * line.conjugate()).real)
    left = added(*((1, product(shift, way)) for shift, way in zip(shifts, direction, strict=True)))
    right = added((1, along_line), (-1, product(radius, turn)))
    model.add("rolling_along", left, right, **facts)
