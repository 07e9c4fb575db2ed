"""The asked quantities, read from what a solution has found: magnitudes, signed rates, components, positions."""

from __future__ import annotations

import math

from variantgen.algebra.expression import Expression, Ratio, Value
from variantgen.algebra.name import Name
from variantgen.families.quantities import Quantity
from variantgen.methods.by_groups.position_answers import centre_coordinate, position_answer
from variantgen.methods.by_groups.vector_answers import curvature_radius, vector_answer
from variantgen.methods.centres import acceleration_centre, velocity_centre
from variantgen.methods.groups.carriers import is_translating
from variantgen.methods.solution.book import Book
from variantgen.methods.steps.step import Body, Derived


def answer(book: Book, quantity: Quantity) -> Value:
    """The value of an asked quantity in its printed unit; lines that it still needs are added to the solution.

    Rates are positive counter-clockwise. Raises LookupError for a quantity that the steps so far do not lead to.
    """
    if quantity.is_vector:
        return vector_answer(book, quantity)
    match quantity.group:
        case "rotation":
            return _rate(book, quantity)
        case "ratio":
            return _ratio(book, quantity)
        case "path":
            return curvature_radius(book, quantity.target)
        case "position":
            return position_answer(book, quantity)
        case "centre angle":
            return acceleration_centre.asked_angle(book, quantity.target)
    if quantity.is_coordinate:
        return centre_coordinate(book, quantity)
    distance = velocity_centre.distance if quantity.kind == "P" else acceleration_centre.distance
    return distance(book, quantity.target, quantity.component)


def _rate(book: Book, quantity: Quantity) -> Value:
    """A rate with its sign, its magnitude, or its sense."""
    rates = book.omega if quantity.kind == "omega" else book.epsilon
    name = Name(quantity.kind, quantity.target)
    measure = "angular velocity" if quantity.kind == "omega" else "angular acceleration"
    if quantity.target not in rates:
        if not is_translating(book, quantity.target):
            raise LookupError(quantity.name)
        with book.step(f"turning.{quantity.kind}", body=Body(quantity.target)):
            book.say(f"rates.no_{quantity.kind}", False, body=Body(quantity.target))
        return Value(name, measure, 0.0)
    rate = rates[quantity.target]
    if quantity.component == "sense":
        return Value(name, "number", float(rate.sense))
    if quantity.component == "abs" or rate.sense >= 0:
        return rate.size
    return Value(rate.size.name, measure, -rate.size.exact, -rate.size)


def _ratio(book: Book, quantity: Quantity) -> Value:
    """The quotient of two angular velocities, negative where they have opposite senses; infinite by zero."""
    name = Name("ratio", quantity.target, quantity.component)
    bodies = (quantity.target, quantity.component)
    sizes = [_rate(book, Quantity("omega", body, "abs")) for body in bodies]
    if sizes[1].exact == 0:
        return Value(name, "number", math.inf)
    opposite = math.prod(book.omega[body].sense for body in bodies if body in book.omega) < 0
    whole: Expression = Ratio(*sizes)
    with book.step("answers.ratio", first=Body(bodies[0]), second=Body(bodies[1])):
        if opposite:
            book.say("answers.opposite", False, first=Body(bodies[0]), second=Body(bodies[1]))
        whole = -whole if opposite else whole
        value = Value(name, "number", whole.number(True), whole)
        book.items.append(Derived(value, symbolic=False))  # in symbols it would be itself
        book.values[name] = value
        return value
