"""A given distance of two points: a hydraulic cylinder, a hauled rope."""

from __future__ import annotations

from typing import TYPE_CHECKING

from variantgen.algebra.name import Name
from variantgen.methods.coordinates.equations.prescribed import rates
from variantgen.methods.steps.step import Segment

if TYPE_CHECKING:
    from variantgen.families.family import ComponentTemplate
    from variantgen.mechanism.drivers.extension import Extension
    from variantgen.methods.coordinates.model import Model


def state(model: Model, driver: Extension, template: ComponentTemplate) -> None:
    """``(x_E - x_S)^2 + (y_E - y_S)^2 = s(t)^2``."""
    start, end = driver.start, driver.end
    given = model.coordinate(Name("slide", start, end), "length", abs(model.now(start, end)))
    model.prescribe(given, *rates(model, driver, template))
    model.add_distance("extension", start, end, given, segment=Segment(start, end))
