"""The analytical method: coordinates and angles as functions of time, differentiated once and twice.

The motion of a plane figure is given by its equations ``x_A(t)``, ``y_A(t)``, ``phi(t)``; for any of its points then
``x_M = x_A + b cos phi``, ``y_M = y_A + b sin phi`` (guide, 3.1.1 and 3.2.1). The method applies where every coordinate
that is asked for is such a function of what drivers prescribe: no system of equations has to be solved. It does not
apply to linkages that close (a slider-crank, a four-bar), nor to an angle that follows from a distance.
"""

from __future__ import annotations

from msgspec import Struct, field

from variantgen.algebra.derivative import derivative
from variantgen.algebra.expression import Constant, Expression, Ratio, Value
from variantgen.algebra.linear import linear
from variantgen.algebra.name import Name
from variantgen.algebra.normal_form import Maybe, added, forward, hypotenuse, product
from variantgen.algebra.substitution import pruned, substituted
from variantgen.algebra.values import parts
from variantgen.methods.coordinates import results
from variantgen.methods.coordinates.blocks import CoordinateBlock, blocks_for, given_coordinates
from variantgen.methods.coordinates.coordinate import Coordinate, PositionEquation
from variantgen.methods.coordinates.equations import model_of
from variantgen.methods.coordinates.model import Model, changing
from variantgen.methods.coordinates.places import locate
from variantgen.methods.linkage.problem import Task
from variantgen.methods.solution.book import Book
from variantgen.methods.steps.not_applicable import NOT_APPLICABLE
from variantgen.methods.steps.shown_system import ZERO, enter
from variantgen.methods.steps.step import Derived, EquationLine, Point

_INNER = ("x", "y")  # coordinates that are replaced by their functions; angles and ways keep their names
_WAYS = ("slide", "arc")  # coordinates that have to be introduced


class Functions(Struct):
    """The motion as functions of time: the given coordinates, and the others by expressions of them, in their order."""

    given: list[Coordinate]
    of: dict[Value, Expression] = field(default_factory=dict)
    source: dict[Value, PositionEquation] = field(default_factory=dict)


def applies(task: Task) -> bool:
    """Whether what is asked is an explicit function of the given motion."""
    book = Book(task)
    with book.step("analytical.functions"):
        try:
            model = model_of(book)
            return _functions(model) is not None
        except NOT_APPLICABLE:
            return False


def solve(book: Book) -> None:
    """Write the steps of the method. Raises LookupError for a mechanism to which it does not apply."""
    with book.step("analytical.functions", "coordinate_axes") as first:
        model = model_of(book)
        functions = _functions(model)
        if functions is None:
            raise LookupError("analytical")
        _state(model, functions)
    shown = _shown(model, functions)
    blocks = [CoordinateBlock((), tuple(model.coordinates[value] for value in functions.of))]
    written: dict[Value, Maybe] = dict(functions.of)
    for order in (1, 2)[: book.task.order]:
        model = model.at(order)
        book = model.book
        with book.step(f"analytical.{book.measure}"):
            book.say(f"analytical.differentiate_{order}", False)
            written = _differentiate(model, functions, written, order, shown)
            results.enter(model, blocks)
            for point in _asked_points(book):
                _modulus_and_cosines(book, point)
    locate(model, first)


def _functions(model: Model) -> Functions | None:
    """The functions of time that lead to what is asked; None where one does not follow explicitly."""
    targets = results.targets(model)
    blocks = blocks_for(model, targets)
    functions = Functions(given_coordinates(model, blocks, targets))
    inner: dict[Value, Expression] = {}
    for block in blocks:
        if len(block.unknowns) > 1:
            return None
        value = block.unknowns[0].place
        explicit = _explicit(value, added((1, block.equations[0].left), (-1, block.equations[0].right)))
        if explicit is None:
            return None
        found = substituted(explicit, inner) or ZERO
        functions.of[value], functions.source[value] = found, block.equations[0]
        if value.name is not None and value.name.kind in _INNER:
            inner[value] = found
    return functions


def _explicit(value: Value, equation: Maybe) -> Expression | None:
    """The value by an equation ``= 0`` that is linear in it with a constant coefficient."""
    try:
        found, rest = linear(equation, [value])
    except TypeError:
        return None
    return _divided(found.get(value), rest)


def _divided(own: Expression | None, rest: Maybe) -> Expression | None:
    if own is None or not _is_constant(own):
        return None
    sign, coefficient = forward(own)
    above = added((-sign, rest))
    if above is None:
        return ZERO
    if isinstance(coefficient, Constant):
        return product(Constant(1.0 / coefficient.value), above)
    sign, above = forward(above)
    whole = Ratio(above, coefficient)
    return whole if sign > 0 else -whole


def _is_constant(item: Expression) -> bool:
    return all(part.name is None or part.name.kind in ("parameter", "length", "radius") for part in parts(item))


def _state(model: Model, functions: Functions) -> None:
    """What is given, and the coordinates of the asked points and the angles as functions."""
    book = model.book
    given = tuple(own.place.name for own in functions.given if own.place.name)
    if given:
        book.say("analytical.given", False, given=given)
    shown = _shown(model, functions)
    results.say_start(model, [*(own.place for own in functions.given), *shown])
    for value in shown:
        if value.name is not None and value.name.kind in _WAYS:
            source = functions.source[value]
            book.say(f"coordinates.{source.key}", False, **source.facts)
        elif value is shown[0]:
            book.say("analytical.position", True)
        book.items.append(EquationLine(value, functions.of[value]))


def _shown(model: Model, functions: Functions) -> list[Value]:
    """Functions that are written: of what is asked, and of the angles that these contain."""
    wanted = [value for value in results.targets(model) if value in functions.of]
    waiting = list(wanted)
    while waiting:
        for value in changing(functions.of[waiting.pop()], model):
            if value in functions.of and value not in wanted:
                wanted.append(value)
                waiting.append(value)
    return [value for value in functions.of if value in wanted]


def _differentiate(
    model: Model, functions: Functions, written: dict[Value, Maybe], order: int, shown: list[Value]
) -> dict[Value, Maybe]:
    """The derivatives by time with their numbers; those of coordinates that are not written are entered silently."""
    rates: dict[Value, Maybe] = {}
    for own in model.coordinates.values():
        rates[own.place] = None if own.given and own.speed.exact == own.acceleration.exact == 0 else own.speed
        if order == 2:
            rates[own.speed] = None if own.given and own.acceleration.exact == 0 else own.acceleration
    items = model.book.items
    for own in functions.given:
        items.append(Derived(own.speed if order == 1 else own.acceleration))
    found: dict[Value, Maybe] = {}
    for value, function in written.items():
        found[value] = None if function is None else derivative(function, rates)
        own = model.coordinates[value]
        rate = own.speed if order == 1 else own.acceleration
        expression = pruned(found[value]) or ZERO
        enter(rate, expression, expression.number(True))
        if value in shown:
            items.append(Derived(rate, symbolic=rate.exact != 0, numeric=rate.exact != 0))
    return found


def _asked_points(book: Book) -> list[str]:
    kind = book.letter
    return list(dict.fromkeys(q.target for q in book.task.sought if q.kind == kind))


def _modulus_and_cosines(book: Book, point: str) -> None:
    """``v = sqrt(x'^2 + y'^2)`` and the direction cosines of the vector of a point with two components."""
    terms = book.vectors[point]
    if len(terms) < 2:
        return
    name = Name(book.letter, point)
    components = [book.values[name.component(axis)] for axis in ("x", "y")]
    book.say("analytical.modulus", True, point=Point(point))
    size = book.derive(name, book.measure, hypotenuse(components))
    for axis, component in zip(("x", "y"), components, strict=True):
        cosine = Value(Name("cosine", point, part=axis, body=book.letter), "number", 0.0, Ratio(component, size))
        cosine.exact = component.exact / size.exact
        book.items.append(Derived(cosine))
