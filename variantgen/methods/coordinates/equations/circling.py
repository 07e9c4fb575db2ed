"""A given motion of a point along a circular slot of a moving body."""

from __future__ import annotations

from typing import TYPE_CHECKING

from variantgen.algebra.expression import Ratio
from variantgen.methods.coordinates.equations.prescribed import rates
from variantgen.methods.geometry.geometry import degrees

if TYPE_CHECKING:
    from variantgen.families.family import ComponentTemplate
    from variantgen.mechanism.drivers.circling import Circling
    from variantgen.methods.coordinates.model import Model


def state(model: Model, driver: Circling, template: ComponentTemplate) -> None:
    """``psi' = v / R``, ``psi'' = a / R``, the angle of the circular slot."""
    turn = model.rotation(driver.body)
    now = degrees(model.now(driver.centre, driver.point)) - (turn.exact if turn is not None else 0.0)
    sign = float(model.task.scene.frame.sense)
    radius = model.geometry.length(driver.centre, driver.point)
    speed, acceleration = rates(model, driver, template, sign)
    model.prescribe(model.arc(driver.point, driver.body, now), Ratio(speed, radius), Ratio(acceleration, radius))
