"""A prescribed motion of a point along a fixed direction."""

from __future__ import annotations

from typing import TYPE_CHECKING

from variantgen.algebra.name import Name
from variantgen.algebra.normal_form import added, product
from variantgen.mechanism.joints.guide import Guide
from variantgen.methods.coordinates.equations.guide import direction
from variantgen.methods.coordinates.equations.prescribed import rates
from variantgen.methods.coordinates.heading import Heading
from variantgen.methods.geometry.geometry import degrees
from variantgen.methods.steps.step import Point

if TYPE_CHECKING:
    from variantgen.families.family import ComponentTemplate
    from variantgen.mechanism.drivers.travel import Travel
    from variantgen.methods.coordinates.model import Model

_LEVEL = 1e-12


def state(model: Model, driver: Travel, template: ComponentTemplate) -> None:
    """Along an axis the coordinate is given; otherwise ``(x - x_0) cos alpha + (y - y_0) sin alpha = s(t)``."""
    way, point = direction(model, driver), driver.point
    for axis, (part, other) in enumerate(((way.real, way.imag), (way.imag, way.real))):
        if abs(other) < _LEVEL and (own := model.unknown(point, axis)) is not None:
            model.prescribe(own, *rates(model, driver, template, part))
            return
    for joint in model.task.scene.joints:
        if isinstance(joint, Guide) and joint.point == point:
            sign = (way * direction(model, joint).conjugate()).real
            if abs(abs(sign) - 1.0) < _LEVEL:
                model.prescribe(model.slide(point, "", 0.0), *rates(model, driver, template, sign))
                return
    given = model.coordinate(Name("slide", point + "0"), "length", 0.0)
    model.prescribe(given, *rates(model, driver, template))
    shifts = [added((1, model.of(point, axis)), (-1, model.start(point, axis))) for axis in (0, 1)]
    ray = Heading(None, degrees(way)).ray(model.one)
    left = added(*((1, product(shift, part)) for shift, part in zip(shifts, ray, strict=True)))
    model.add("travel", left, given, point=Point(point))
