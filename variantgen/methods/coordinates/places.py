"""Positions behind the numbers of the coordinate method: worked out where a line with numbers needs them."""

from __future__ import annotations

from variantgen.algebra.expression import Constant, Expression, Value
from variantgen.algebra.name import Name
from variantgen.algebra.normal_form import added, product
from variantgen.algebra.substitution import pruned
from variantgen.algebra.values import in_order
from variantgen.methods.coordinates.model import Model
from variantgen.methods.steps.printed_digits import items_values
from variantgen.methods.steps.step import Derived, EquationLine, Sentence, Step


def locate(model: Model, step: Step) -> None:
    """Give every position that the numbers of the steps use its value from the geometry.

    Angles and ways, which the geometry does not show, are shown at the end of ``step``.
    """
    items = [item for step in model.book.steps for item in step.items if not isinstance(item, EquationLine)]
    shown: list[Value] = []
    for value in in_order(items_values(items)):
        if value.name is not None and value.name.kind == "offset":
            shown.append(value)
        if value.expression is None and value.name is not None:
            value.expression = _place(model, value, value.name)
            if value in model.coordinates and value.name.kind not in ("x", "y"):
                shown.append(value)
    known = {item.value.name for item in model.geometry.items if isinstance(item, Derived)}
    lines = [Derived(value) for value in shown if value.name not in known]
    if lines:
        step.items.append(Sentence("coordinates.now", detail=False))
        step.items.extend(lines)


def _place(model: Model, value: Value, name: Name) -> Expression | None:
    """Where a coordinate, an angle or a way comes from."""
    geometry = model.geometry
    match name.kind:
        case "x" | "y" if not name.dots and name.of in model.task.now.z:
            own = geometry.coordinates(name.of)["xy".index(name.kind)]
            return None if own is value else own
        case "direction" if value in model.coordinates:
            ray = geometry.direction(name.of, name.about)
            return ray if ray.expression is not None and ray.name != name else ray.expression  # phi_CA is phi
        case "slide" if value in model.coordinates and name.about in model.task.now.z:
            return model.geometry.length(name.of, name.about)
        case "slide" | "arc" if value in model.coordinates and value.exact:
            return _slid_distance(model, value, name)
    return None


def _slid_distance(model: Model, value: Value, name: Name) -> Expression:
    """The way from the pole of the body, or the angle on it."""
    body = next(body for (point, body), own in model.slides.items() if own is value)
    if name.kind == "arc":
        joint = model.task.linkage.slide(name.of, body)
        turn = model.rotation(body)
        ray = model.geometry.direction(joint.centre, name.of)
        found = pruned(added((1, ray), (-1, turn)))
        shown = any(isinstance(item, Derived) and item.value is ray for item in model.geometry.items)
        return found if shown and found is not None else Constant(value.exact)
    pole = model.pole(body)
    length = model.geometry.length(pole, name.of)
    if abs(length.exact - abs(value.exact)) > 1e-9 * model.task.size:
        return Constant(value.exact)  # a line off the pole
    return length if value.exact > 0 else product(Constant(-1.0), length) or length
