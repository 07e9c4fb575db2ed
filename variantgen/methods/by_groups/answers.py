"""The asked quantities, read from what a solution has found: magnitudes, signed rates, components, directions."""

from __future__ import annotations

from variantgen.algebra.expression import Applied, Constant, Ratio, Total, Value
from variantgen.algebra.name import Name
from variantgen.families.quantities import Quantity
from variantgen.mechanism.relative import sliding_points
from variantgen.methods.centres import acceleration_centre, velocity_centre
from variantgen.methods.geometry.geometry import Geometry, degrees
from variantgen.methods.groups.carriers import is_translating
from variantgen.methods.solution.book import Book, Known, resultant
from variantgen.methods.steps.step import Body, Derived, Point, VectorOf
from variantgen.methods.vectors.points import components, modulus, vector


def answer(book: Book, quantity: Quantity) -> Value:
    """The value of an asked quantity in its printed unit; lines that it still needs are added to the solution.

    Rates are positive counter-clockwise. Raises LookupError for a quantity that the steps so far do not lead to.
    """
    if quantity.is_rotation:
        return _rate(book, quantity)
    if not quantity.is_vector:
        return _of_centre(book, quantity)
    name, terms = _vector(book, quantity)
    if quantity.component in ("x", "y"):
        return _component(book, name, terms, quantity.component)
    if quantity.component == "angle":
        return _angle(book, name, terms)
    if len(terms) == 1 and terms[0].size is not None and terms[0].size.exact > 0:
        return terms[0].size
    if len(terms) > 1 and name not in book.values:
        kind = quantity.kind if quantity.kind.endswith("_rel") else quantity.kind[0]
        with book.step(f"answers.magnitude_{kind}", point=Point(quantity.target)):
            return modulus(book, name, terms)
    return modulus(book, name, terms)


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


def _of_centre(book: Book, quantity: Quantity) -> Value:
    """A distance from the velocity or acceleration centre, or the angle of the latter."""
    if quantity.kind == "mu":
        return acceleration_centre.asked_angle(book, quantity.target)
    distance = velocity_centre.distance if quantity.kind == "P" else acceleration_centre.distance
    return distance(book, quantity.target, quantity.component)


def _vector(book: Book, quantity: Quantity) -> tuple[Name, Known]:
    """The name of a vector and its known terms."""
    point, kind = quantity.target, quantity.kind
    if kind in ("v", "a"):
        return Name(kind, point), vector(book, point)
    carrier = sliding_points(book.task.scene)[point]
    tables = {"v_rel": book.relative, "a_rel": book.relative_acceleration, "a_cor": book.coriolis}
    return Name(kind[0], point, part=kind[2:]), tables[kind][point, carrier]


def _component(book: Book, name: Name, terms: Known, axis: str) -> Value:
    """The projection of a vector on an axis of the paper."""
    own = name.component(axis)
    if own in book.values:
        return book.values[own]
    with book.step(f"answers.components_{name.kind}", vector=VectorOf(name)):
        components(book, name, terms)
    return book.values[own]


def _angle(book: Book, name: Name, terms: Known) -> Value:
    """The direction of a vector: that of its only term, or by the arc tangent of its components."""
    if len(terms) == 1 and terms[0].size is not None:
        return terms[0].angle if terms[0].size.exact >= 0 else Geometry.turned(terms[0].angle, 180.0)
    x, y = (_component(book, name, terms, axis) for axis in ("x", "y"))
    exact = degrees(resultant(terms))
    if x.exact == 0 or y.exact == 0:
        return Value(None, "angle", exact)
    slope = Applied("arctan", Ratio(y, x))
    turn = round((exact - slope.number(True)) / 180.0) * 180
    whole = Total(((1, slope), (1 if turn > 0 else -1, Constant(abs(turn), "angle")))) if turn else slope
    value = Value(Name("heading", name.of, name.about, name.part, name.kind), "angle", exact, whole)
    with book.step(f"answers.direction_{name.kind}", vector=VectorOf(name)):
        book.items.append(Derived(value))
    return value
