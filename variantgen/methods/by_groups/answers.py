"""The asked quantities, read from what a solution has found: magnitudes, signed rates, components, positions."""

from __future__ import annotations

import math

from variantgen.algebra.expression import Constant, Expression, Ratio, Value
from variantgen.algebra.name import Name
from variantgen.algebra.normal_form import added
from variantgen.families.quantities import Quantity
from variantgen.mechanism.rope_speed import rope_piece
from variantgen.methods.by_groups.position_answers import centre_coordinate, position_answer
from variantgen.methods.by_groups.vector_answers import curvature_radius, vector_answer
from variantgen.methods.centres import acceleration_centre, velocity_centre
from variantgen.methods.geometry.geometry import degrees
from variantgen.methods.groups.carriers import is_translating
from variantgen.methods.on_demand import on_demand
from variantgen.methods.solution.book import Book
from variantgen.methods.steps.step import Body, Derived, Point
from variantgen.methods.vectors.natural_sum import signed
from variantgen.methods.vectors.points import vector
from variantgen.methods.vectors.vector_equation import named_shares

_turn_answer = on_demand("by_groups.turn_answers", "turn_answer")
_passage_answer = on_demand("by_groups.passage_answers", "passage_answer")


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
        case "rope":
            return _rope(book, quantity)
        case "path":
            return curvature_radius(book, quantity.target)
        case "position":
            return position_answer(book, quantity)
        case "turn":
            found: Value = _turn_answer(book, quantity)
            return found
        case "course":
            value: Value = _passage_answer(book, quantity)
            return value
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


def _rope(book: Book, quantity: Quantity) -> Value:
    """The speed of a rope: of the rim of the drum, or of its end along it, from which it runs over pulleys.

    Behind a pulley with the velocity v it is ``w + (u - u_before).v``: seen from the axle it is as fast as before it.
    Raises LookupError where the rope has no such end.
    """
    task = book.task
    piece, resting = rope_piece(task.scene, quantity.target, quantity.component), task.linkage.resting
    way = piece.way(resting) if piece else None
    if way is None:
        raise LookupError(quantity.name)
    end, at = way.bends[0], task.in_metres
    axes = [Value(None, "angle", degrees(complex(ray))) for ray in way.rays(at)]
    pulleys = [number for number, bend in enumerate(way.bends) if number and bend.point not in resting]
    name = Name("rope", quantity.target, quantity.component)
    word = "belt" if piece is not None and piece.rope.belt else "rope"
    with book.step(f"answers.{word}", first=Point(quantity.target), second=Point(quantity.component)):
        terms: list[tuple[int, Expression]] = []
        if end.body is not None:
            book.say(f"answers.{word}_on_drum", False, body=Body(end.body))
            radius = book.geometry.radius(end.point, float(end.radius) / task.length_unit, end.body)
            away = 1 if way.rim(at) * task.now.omega[end.body] >= 0 else -1
            terms.append((away, _rate(book, Quantity("omega", end.body, "abs")) * radius))
        elif end.point not in resting:
            book.say("answers.rope_at_moving_end" if pulleys else "answers.rope_at_end", False, point=Point(end.point))
            terms += signed(named_shares(book, vector(book, end.point), axes[0]))
        for number in pulleys:
            book.say(f"answers.{word}_behind_pulley", False, point=Point(way.bends[number].point))
            own = vector(book, way.bends[number].point)
            terms += signed(named_shares(book, own, axes[number]))
            terms += [(-sign, part) for sign, part in signed(named_shares(book, own, axes[number - 1]))]
        sense = 1 if sum(sign * part.number(True) for sign, part in terms) >= 0 else -1
        whole = added(*sorted(((sense * sign, part) for sign, part in terms), key=lambda term: -term[0]))
        return book.derive(name, "velocity", Constant(0.0) if whole is None else whole)


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
