"""The rates that a driver gives, with their signs on paper."""

from __future__ import annotations

from typing import TYPE_CHECKING, Any

from variantgen.algebra.expression import Constant, Expression
from variantgen.algebra.normal_form import product
from variantgen.families.parameters.expressions import FamilyExpression
from variantgen.mechanism.linkage import driven_point
from variantgen.methods.vectors.given_motion import amount

if TYPE_CHECKING:
    from variantgen.families.family import ComponentTemplate
    from variantgen.methods.coordinates.model import Model

_ANGULAR = {"omega": "angular velocity", "epsilon": "angular acceleration"}
_LINEAR = {"v": "velocity", "a": "acceleration"}


def _is_component(model: Model, driver: Any) -> bool:
    """Whether another driver gives a second component of the motion of the same point."""
    point = driven_point(driver)
    return bool(point) and sum(driven_point(other) == point for other in model.task.scene.drivers) > 1


def rates(
    model: Model, driver: Any, template: ComponentTemplate, sign: float | None = None
) -> tuple[Expression, Expression]:
    """First and second derivative of what a driver prescribes; ``sign`` +1 or -1 as it counts on paper.

    A rotation counts as the frame of the scene does, a way along a line by itself.
    """
    rotation = hasattr(driver, "omega")
    if sign is None:
        sign = float(model.task.scene.frame.sense) if rotation else 1.0
    found = []
    for order, (key, measure) in enumerate((_ANGULAR if rotation else _LINEAR).items(), 1):
        number = float(getattr(driver, key)) * sign
        source = template.fields.get(key)
        if _is_component(model, driver) and isinstance(source, FamilyExpression):
            stated = model.task.expressed(source)
            if stated is not None:  # of two components neither is the velocity, whose name it would get
                found.append(product(Constant(sign), stated) or stated)
                continue
        size = amount(model.book.at(order), template, key, measure)
        found.append(size if number >= 0 else product(Constant(-1.0), size) or size)
    return found[0], found[1]
