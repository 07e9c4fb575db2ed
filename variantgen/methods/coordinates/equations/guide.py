"""A guide: along an axis one coordinate is constant, otherwise a way along the line is introduced."""

from __future__ import annotations

from typing import TYPE_CHECKING, Any

from variantgen.algebra.name import Name
from variantgen.methods.coordinates.heading import Heading, fixed_number
from variantgen.methods.geometry.geometry import degrees
from variantgen.methods.steps.step import Fact, Point

if TYPE_CHECKING:
    from variantgen.mechanism.joints.guide import Guide
    from variantgen.methods.coordinates.model import Model

_LEVEL = 1e-12


def direction(model: Model, joint: Any) -> complex:
    """The unit vector of a direction of the scene, on paper."""
    return complex(model.task.scene.frame.direction(joint.angle))


def prepare(model: Model, joint: Guide, template: None) -> None:
    """The coordinate across a line along an axis is constant."""
    way = direction(model, joint)
    for axis, part in enumerate((way.real, way.imag)):
        if abs(part) < _LEVEL:
            model.hold(joint.point, axis)


def state(model: Model, joint: Guide, template: None) -> None:
    """``x = x_0 + s cos alpha``, ``y = y_0 + s sin alpha`` on an oblique line, s counted from the given place."""
    way = direction(model, joint)
    if min(abs(way.real), abs(way.imag)) < _LEVEL:
        return
    slide, angle = model.slide(joint.point, "", 0.0), degrees(way)
    ray = Heading(None, angle).ray(slide)
    facts: dict[str, Fact] = {"point": Point(joint.point), "angle": fixed_number("angle", angle)}
    facts["way"] = slide.name or Name("slide", joint.point)
    for axis in (0, 1):
        model.add_sum("guide", model.of(joint.point, axis), model.start(joint.point, axis), ray[axis], **facts)
