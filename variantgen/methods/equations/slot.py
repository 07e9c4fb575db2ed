"""A slot or sleeve: a point has a way s along a line of a body."""

from __future__ import annotations

from typing import TYPE_CHECKING

from variantgen.methods.expression import Constant, Expression, Value
from variantgen.methods.geometry import degrees
from variantgen.methods.name import Name
from variantgen.methods.step import Body, Fact, Point

if TYPE_CHECKING:
    from variantgen.mechanism.joints.slot import Slot
    from variantgen.methods.coordinate_model import Model


def state(model: Model, joint: Slot, template: None) -> None:
    """``x_P = x_A + s cos phi - h sin phi``, ``y_P = y_A + s sin phi + h cos phi`` with the pole A of the body."""
    pole, line = model.pole(joint.body), model.now(*joint.along)
    way = line / abs(line)
    place = model.now(pole, joint.point) * way.conjugate()
    if abs(place.imag) < 1e-9 * model.task.size:
        place = complex(place.real)
    heading = model.turned(joint.body, degrees(way))
    terms = [heading.ray(model.slide(joint.point, joint.body, place.real))]
    if place.imag:
        terms.append(model.turned(joint.body, degrees(1j * way)).ray(_off_pole(joint.point, place.imag)))
    facts: dict[str, Fact] = {"point": Point(joint.point), "body": Body(joint.body), "pole": Point(pole)}
    model.add_vector("slot", pole, joint.point, terms, **facts)
    if joint.sleeve is not None and joint.sleeve in model.task.needed.bodies:
        turns = model.rotation(joint.sleeve), model.rotation(joint.body)
        model.add("sleeve", *turns, first=Body(joint.sleeve), second=Body(joint.body))


def _off_pole(point: str, number: float) -> Expression:
    """How far the line of a point passes by the pole, with the sign of its side."""
    value = Value(Name("offset", point), "length", abs(number), Constant(abs(number)))
    return value if number > 0 else -value
