"""A slot or sleeve: a point has a way s along a line of a body."""

from __future__ import annotations

from typing import TYPE_CHECKING

from variantgen.algebra.expression import Constant, Expression, Value
from variantgen.algebra.name import Name
from variantgen.methods.coordinates.heading import fixed_number
from variantgen.methods.geometry.geometry import degrees, normal_angle
from variantgen.methods.steps.step import Body, Fact, Point

if TYPE_CHECKING:
    from variantgen.mechanism.joints.slot import Slot
    from variantgen.methods.coordinates.model import Model

_LEVEL = 1e-9  # of the size, or of a unit vector: what is smaller is none


def state(model: Model, joint: Slot, template: None) -> None:
    """``x_P = x_A + s cos phi - h sin phi``, ``y_P = y_A + s sin phi + h cos phi`` with the pole A of the body."""
    pole, line = model.pole(joint.body), model.now(*joint.along)
    way = line / abs(line)
    place = model.now(pole, joint.point) * way.conjugate()
    if abs(place.imag) < _LEVEL * model.task.size:
        place = complex(place.real)
    heading = model.turned(joint.body, degrees(way))
    slide = model.slide(joint.point, joint.body, place.real)
    terms = [heading.ray(slide)]
    if place.imag:
        terms.append(model.turned(joint.body, degrees(1j * way)).ray(_off_pole(joint.point, place.imag)))
    facts: dict[str, Fact] = {"point": Point(joint.point), "body": Body(joint.body), "pole": Point(pole)}
    key = "slot_off" if place.imag else "slot"
    if place.imag:
        facts["offset"] = Name("offset", joint.point)
    if not model.is_turning(joint.body) and min(abs(way.real), abs(way.imag)) > _LEVEL:
        key, facts["angle"] = f"{key}_oblique", fixed_number("angle", normal_angle(degrees(way)))
    facts["way"] = Name("slide", joint.point, slide.name.about if slide.name else "")
    model.add_vector(key, pole, joint.point, terms, **facts)
    if joint.sleeve is not None and model.is_needed(joint.sleeve):
        turns = model.swept(joint.sleeve), model.swept(joint.body)
        model.add("sleeve", *turns, first=Body(joint.sleeve), second=Body(joint.body))


def _off_pole(point: str, number: float) -> Expression:
    """How far the line of a point passes by the pole, with the sign of its side."""
    value = Value(Name("offset", point), "length", abs(number), Constant(abs(number)))
    return value if number > 0 else -value
