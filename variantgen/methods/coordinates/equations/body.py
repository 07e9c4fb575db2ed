"""Rigid bodies: points of a body with an angle, the length of a rod, a third point of a plate, translation."""

from __future__ import annotations

from typing import TYPE_CHECKING

from variantgen.algebra.expression import Expression
from variantgen.algebra.normal_form import Maybe, added, product
from variantgen.methods.coordinates.heading import fixed_number
from variantgen.methods.geometry.geometry import degrees
from variantgen.methods.steps.step import Body, Fact, Point, Segment

if TYPE_CHECKING:
    from variantgen.methods.coordinates.model import Model

_CLOSE = 1e-9  # of a length: an offset below it is none


def state_body(model: Model, body: str) -> None:
    """The equations by which the points of a body belong together."""
    members = model.members(body)
    if not model.is_turning(body):
        _translation(model, body, members)
    elif model.has_angle(body) and members:
        _turning(model, body, members)
    elif len(members) > 1:
        _rod(model, body, members)


def _translation(model: Model, body: str, members: list[str]) -> None:
    """``x_M = x_P + const``."""
    for point in members[1:]:
        for axis in (0, 1):
            if not model.is_held(point, axis):
                step = model.now(members[0], point)
                offset = model.offset((step.real, step.imag)[axis])
                right = added((1, model.of(members[0], axis)), (1, offset))
                model.add("translation", model.of(point, axis), right, body=Body(body), point=Point(point))


def _turning(model: Model, body: str, members: list[str]) -> None:
    """``x_M = x_P + b cos(phi + beta)``: every point by the first one."""
    pole, *others = members
    for point in others:
        heading = model.turned(body, degrees(model.now(pole, point)))
        arm = heading.ray(model.geometry.length(pole, point))
        model.add_vector("turning", pole, point, [arm], body=Body(body), point=Point(point), pole=Point(pole))


def _rod(model: Model, body: str, members: list[str]) -> None:
    """The distance of two points is kept; each other point is a combination of these."""
    first, second, *others = members
    if second in model.task.fixed:
        return
    model.add_distance(
        "rod", first, second, model.geometry.length(first, second), body=Body(body), segment=Segment(first, second)
    )
    base = model.now(first, second)
    for point in others:
        share = model.now(first, point) / base
        rows = [_combined(model, first, second, axis, share) for axis in (0, 1)]
        facts: dict[str, Fact] = {
            "body": Body(body),
            "point": Point(point),
            "first": Point(first),
            "second": Point(second),
        }
        model.add_vector("plate", first, point, [(rows[0], rows[1])], **facts)


def _combined(model: Model, first: str, second: str, axis: int, share: complex) -> Maybe:
    """``p (x_B - x_A) - q (y_B - y_A)``, for y with the axes exchanged and the other sign."""
    own, other = model.shift(first, second, axis), model.shift(first, second, 1 - axis)
    along, across = (
        None if abs(part) < _CLOSE else fixed_number("number", abs(part)) for part in (share.real, share.imag)
    )
    signs = (1 if share.real > 0 else -1, (-1 if axis == 0 else 1) * (1 if share.imag > 0 else -1))
    parts: list[tuple[int, Expression | None]] = [
        (signs[0], None if along is None else product(along, own)),
        (signs[1], None if across is None else product(across, other)),
    ]
    return added(*parts)
