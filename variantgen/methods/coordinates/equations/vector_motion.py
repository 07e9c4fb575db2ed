"""A point whose velocity and acceleration are given as vectors: both coordinates are known functions of time."""

from __future__ import annotations

import math
from typing import TYPE_CHECKING

from variantgen.algebra.expression import Constant, Expression
from variantgen.methods.coordinates.heading import Heading
from variantgen.methods.geometry.geometry import degrees
from variantgen.methods.vectors.given_motion import amount

if TYPE_CHECKING:
    from variantgen.families.family import ComponentTemplate
    from variantgen.mechanism.drivers.vector_motion import VectorMotion
    from variantgen.methods.coordinates.model import Model

_KINDS = (("v", "angle", "velocity"), ("a", "a_angle", "acceleration"))


def prepare(model: Model, driver: VectorMotion, template: ComponentTemplate) -> None:
    """``x' = v cos alpha`` and so on; a component that is never there keeps its coordinate."""
    rays = [_vector(model.at(order), driver, template, *kind) for order, kind in enumerate(_KINDS, 1)]
    for axis in (0, 1):
        first, second = (ray[axis] for ray in rays)
        if first is None and second is None:
            model.hold(driver.point, axis)
        elif (own := model.unknown(driver.point, axis)) is not None:
            model.prescribe(own, first or Constant(0.0), second or Constant(0.0))


def _vector(
    model: Model, driver: VectorMotion, template: ComponentTemplate, key: str, angle: str, measure: str
) -> tuple[Expression | None, Expression | None]:
    """The components of a given vector on paper."""
    number = float(getattr(driver, key))
    if number == 0:
        return None, None
    way = complex(model.task.scene.frame.direction(getattr(driver, angle))) * math.copysign(1.0, number)
    return Heading(None, degrees(way)).ray(amount(model.book, template, key, measure))
