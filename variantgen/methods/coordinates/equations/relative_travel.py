"""A given way of a point along a line of a moving body."""

from __future__ import annotations

from typing import TYPE_CHECKING

from variantgen.algebra.normal_form import added, product
from variantgen.methods.coordinates.equations.prescribed import rates
from variantgen.methods.geometry.geometry import degrees
from variantgen.methods.steps.step import Body, Point

if TYPE_CHECKING:
    from variantgen.families.family import ComponentTemplate
    from variantgen.mechanism.drivers.relative_travel import RelativeTravel
    from variantgen.methods.coordinates.model import Model


def state(model: Model, driver: RelativeTravel, template: ComponentTemplate) -> None:
    """The way s of the slot is given; without a slot ``(x - x_A) cos phi + (y - y_A) sin phi = s``."""
    point, body = driver.point, driver.body
    pole, line = model.pole(body), model.now(*driver.along)
    along_line = (model.now(pole, point) * (line / abs(line)).conjugate()).real
    way = model.slide(point, body, along_line)
    model.prescribe(way, *rates(model, driver, template))
    if any((path.point, path.body) == (point, body) for path in model.task.linkage.slides):
        return
    ray = model.turned(body, degrees(line)).ray(model.one)
    shifts = [model.shift(pole, point, axis) for axis in (0, 1)]
    left = added(*((1, product(shift, part)) for shift, part in zip(shifts, ray, strict=True)))
    model.add("relative_travel", left, way, point=Point(point), body=Body(body))
