"""A prescribed rotation: the angle of a body, or its difference to that of another, is a known function of time."""

from __future__ import annotations

from typing import TYPE_CHECKING

from variantgen.algebra.name import Name
from variantgen.algebra.normal_form import added
from variantgen.methods.coordinates.equations.prescribed import rates
from variantgen.methods.steps.step import Body

if TYPE_CHECKING:
    from variantgen.families.family import ComponentTemplate
    from variantgen.mechanism.drivers.rotation import Rotation
    from variantgen.methods.coordinates.model import Model


def prepare(model: Model, driver: Rotation, template: ComponentTemplate) -> None:
    """The angle of the body is given."""
    if driver.relative_to is None:
        model.prescribe(model.angle(driver.body), *rates(model, driver, template))


def state(model: Model, driver: Rotation, template: ComponentTemplate) -> None:
    """``phi = phi_other + given angle`` (all from the given place on)."""
    if driver.relative_to is not None:
        given = model.coordinate(Name("swing", driver.body), "angle", 0.0)
        model.prescribe(given, *rates(model, driver, template))
        turns = model.swept(driver.body), added((1, model.swept(driver.relative_to)), (1, given))
        model.add("composed", *turns, first=Body(driver.body), second=Body(driver.relative_to))
