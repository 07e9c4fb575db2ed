"""Meshing gears: seen from the line of centres, equal arcs roll off."""

from __future__ import annotations

from typing import TYPE_CHECKING

from variantgen.algebra.name import Name
from variantgen.algebra.normal_form import Maybe, added, product
from variantgen.methods.coordinates.heading import Heading
from variantgen.methods.geometry.geometry import degrees
from variantgen.methods.steps.step import Body, Fact

if TYPE_CHECKING:
    from variantgen.mechanism.joints.gears import Gears
    from variantgen.methods.coordinates.model import Model


def state(model: Model, joint: Gears, template: None) -> None:
    """``r phi + R Phi = (r + R) psi`` outside, ``r phi - R Phi = (r - R) psi`` inside; psi: the line of centres."""
    d = abs(model.now(joint.other_centre, joint.centre))
    exact = model.length(joint.radius)
    small = model.radius(joint.body, joint.centre, exact)
    large = model.radius(joint.other, joint.other_centre, d + exact if joint.inside else d - exact)
    sign = -1 if joint.inside else 1
    other = model.swept(joint.other) if joint.other is not None else None
    left = added((1, product(small, model.swept(joint.body))), (sign, product(large, other)))
    right = product(added((1, small), (sign, large)), _line_of_centres(model, joint))
    facts: dict[str, Fact] = {"first": Body(joint.body)}
    if joint.other is not None:
        facts["second"] = Body(joint.other)
    key = "gears" if joint.other is not None else "gear_fixed"
    model.add(key, left, right, **facts)


def _line_of_centres(model: Model, joint: Gears) -> Maybe:
    """The angle through which the line of centres has turned: of the carrier, or one of its own."""
    ends = {joint.centre, joint.other_centre}
    if ends <= model.task.fixed:
        return None
    for body, members in model.task.scene.bodies.items():
        if ends <= set(members):
            return model.swept(body)
    now = degrees(model.now(joint.other_centre, joint.centre))
    turn = model.coordinate(Name("swing", joint.other_centre + joint.centre), "angle", 0.0)
    way = Heading(turn, now + 90.0).ray(model.one)
    shifts = [model.shift(joint.other_centre, joint.centre, axis) for axis in (0, 1)]
    across = added(*((1, product(shift, part)) for shift, part in zip(shifts, way, strict=True)))
    model.add("line_of_centres", across, None)
    return turn
