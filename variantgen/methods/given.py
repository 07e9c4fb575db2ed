"""What the statement gives: rates of driven bodies, vectors of driven points."""

from __future__ import annotations

from variantgen.families.expressions import Expression as FamilyExpression
from variantgen.families.family import Template
from variantgen.mechanism.drivers.rotation import Rotation
from variantgen.mechanism.drivers.travel import Travel
from variantgen.mechanism.drivers.vector_motion import VectorMotion
from variantgen.methods.angles import degrees
from variantgen.methods.book import Book, Rate
from variantgen.methods.expression import Constant, Expression, Total, Value
from variantgen.methods.name import Name
from variantgen.methods.step import Point


def take(book: Book) -> None:
    """Enter what the drivers give at the order that is being worked out."""
    for template, driver in zip(book.task.form.drivers, book.task.scene.drivers, strict=True):
        if isinstance(driver, Rotation) and driver.relative_to is None:
            value = amount(book, template, "omega" if book.order == 1 else "epsilon", book.rate_measure)
            book.rates[driver.body] = Rate(value, _sign(book.exact_rate(driver.body)))
        elif isinstance(driver, Travel | VectorMotion):
            _take_vector(book, template, driver.point, book.letter)


def _take_vector(book: Book, template: Template, point: str, key: str) -> None:
    """A given vector of a point: its magnitude by the data, its direction as the figure shows it."""
    vector = book.exact(point)
    if vector == 0 or abs(vector) < 1e-12 * book.scale:
        book.vectors[point] = ()
        return
    size = amount(book, template, key, book.measure)
    angle = Value(None, "angle", degrees(vector))
    term = book.term(Name(book.letter, point), size, angle, "given", point=Point(point))
    book.vectors[point] = (term,)


def amount(book: Book, template: Template, key: str, measure: str) -> Value:
    """The magnitude of a given rate: the given parameter itself, or a value worked out from the data."""
    source = template.fields.get(key)
    if not isinstance(source, FamilyExpression):
        return Value(None, measure, 0.0)
    expression = unsigned(book.task.expressed(source))
    if isinstance(expression, Value):
        return expression
    number = abs(book.task.read(source))
    if measure in ("velocity", "acceleration"):
        number /= book.task.length_unit
    if number == 0 or expression is None or isinstance(expression, Constant):
        return Value(None, measure, number)
    return book.derive(_name_of(book, template, key), measure, expression)


def _name_of(book: Book, template: Template, key: str) -> Name:
    """The name of a rate that is not given itself."""
    target = template.fields.get("body") or template.fields.get("point")
    assert isinstance(target, str)
    return Name(key, target)


def unsigned(expression: Expression | None) -> Expression | None:
    """An expression without a leading sign."""
    if isinstance(expression, Total) and len(expression.terms) == 1:
        return unsigned(expression.terms[0][1])
    return expression


def _sign(number: float) -> int:
    return (number > 0) - (number < 0)
