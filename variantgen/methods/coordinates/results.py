"""What the coordinate method leads to: vectors of points, rates of bodies, relative motion, for the answers."""

from __future__ import annotations

from collections.abc import Iterable

from variantgen.algebra.expression import Constant, Expression, Magnitude, Raised, Ratio, Value
from variantgen.algebra.name import Name
from variantgen.algebra.normal_form import added, product, signed
from variantgen.algebra.substitution import pruned
from variantgen.mechanism.relative import sliding_points
from variantgen.methods.coordinates.blocks import CoordinateBlock
from variantgen.methods.coordinates.model import Model
from variantgen.methods.geometry.geometry import Geometry, degrees
from variantgen.methods.solution.book import Known, Rate
from variantgen.methods.steps.step import Body, Point, Term, VectorOf
from variantgen.methods.vectors.points import RIGHT, UP, positive


def targets(model: Model) -> list[Value]:
    """The coordinates whose derivatives give what is asked."""
    found: list[Value] = []
    for quantity in model.task.sought:
        if quantity.kind in ("v", "a", "P", "Q"):
            found += _of_point(model, quantity.point) if quantity.point else _of_centre(model, quantity.target)
        if quantity.kind in ("omega", "epsilon", "P", "Q", "mu"):
            found += _of_body(model, quantity.target)
        if quantity.is_relative:
            carrier = sliding_points(model.task.scene)[quantity.target]
            found += [model.slides[quantity.target, carrier]]
            found += _of_body(model, carrier) if model.is_turning(carrier) else []
    return list(dict.fromkeys(found))


def _of_point(model: Model, point: str) -> list[Value]:
    return [own for axis in (0, 1) if (own := model.unknown(point, axis)) is not None]


def _of_centre(model: Model, body: str) -> list[Value]:
    """The coordinates of the points from which a centre is laid off."""
    return [value for point in model.task.scene.bodies[body][:2] for value in _of_point(model, point)]


def _of_body(model: Model, body: str) -> list[Value]:
    """The angle of a body, or the coordinates of two of its points."""
    if not model.is_turning(body):
        return []
    if model.has_angle(body):
        return [model.angle(body)]
    return [value for point in _ends(model, body) for value in _of_point(model, point)]


def _ends(model: Model, body: str) -> tuple[str, str]:
    ends = model.reference(body)
    if ends is None:
        raise LookupError(body)
    return ends


def say_start(model: Model, values: Iterable[Value]) -> None:
    """Say from where angles of turning count, if there are any."""
    if any(value.name is not None and value.name.kind in ("rotation", "swing") for value in values):
        model.book.say("coordinates.start", False)


def enter(model: Model, blocks: list[CoordinateBlock]) -> None:
    """Enter what has been found at the order of the book: all points of the equations, the rates that are asked."""
    book = model.book
    solved = {own.place for block in blocks for own in block.unknowns}
    solved |= {value for value, own in model.coordinates.items() if own.given}
    for point in model.points:
        values = _of_point(model, point)
        if all(value in solved for value in values):
            book.vectors[point] = _vector(model, point)
    wanted = {q.target for q in book.task.sought if q.kind in ("omega", "epsilon", "P", "Q", "mu")}
    carriers = sliding_points(book.task.scene)
    wanted |= {carriers[q.target] for q in book.task.sought if q.is_relative}
    for body in book.task.scene.bodies:
        if body in wanted and model.is_turning(body):
            _enter_rate(model, body)
    for quantity in dict.fromkeys(q.target for q in book.task.sought if q.is_relative):
        _enter_relative(model, quantity, carriers[quantity])


def rate_of(model: Model, place: Value) -> Value:
    """The first or second derivative of a coordinate, by the order of the book."""
    own = model.coordinates[place]
    return own.speed if model.book.order == 1 else own.acceleration


def _vector(model: Model, point: str) -> Known:
    """The vector of a point by its components."""
    book, terms = model.book, list[Term]()
    for axis, (angle, word) in enumerate(((RIGHT, "x"), (UP, "y"))):
        place = model.unknown(point, axis)
        size = None if place is None else rate_of(model, place)
        name = Name(book.letter, point).component(word)
        book.values[name] = size if size is not None else Value(name, book.measure, 0.0)
        if size is not None and size.exact != 0:
            way = angle if size.exact > 0 else Geometry.turned(angle, 180.0)
            terms.append(book.term(name, positive(size), way, f"axis_{word}"))
    return tuple(terms)


def _enter_rate(model: Model, body: str) -> None:
    """The rate of a body: the derivative of its angle, or by two of its points."""
    book = model.book
    kind = "omega" if book.order == 1 else "epsilon"
    name = Name(kind, body)
    given = model.has_angle(body) and model.coordinates[model.angle(body)].given
    rate: Expression = rate_of(model, model.angle(body)) if model.has_angle(body) else _by_points(model, body)
    exact = rate.number(True)
    if abs(exact) <= 1e-10 * book.size_of(book.rate_measure):
        book.rates[body] = Rate(Value(name, book.rate_measure, 0.0), 0)
        book.say(f"rates.no_{kind}", False, body=Body(body))
        return
    sense = 1 if exact > 0 else -1
    if given and (size := _given_size(model, body)) is not None:
        book.rates[body] = Rate(size, sense)
        return
    size = book.derive(name, book.rate_measure, rate if sense > 0 else Magnitude(rate))
    book.rates[body] = Rate(size, sense)
    book.say(f"coordinates.{kind}_{book.rates[body].word}", body=Body(body))


def _given_size(model: Model, body: str) -> Value | None:
    """The datum behind the rate of a driven body, without its sign."""
    expression = rate_of(model, model.angle(body)).expression
    size = None if expression is None else signed(expression)[1]
    return size if isinstance(size, Value) else None


def _by_points(model: Model, body: str) -> Expression:
    """``((x_B - x_A)(y_B' - y_A') - (y_B - y_A)(x_B' - x_A')) / AB^2``, for accelerations with second derivatives."""
    first, second = _ends(model, body)
    shifts = [model.shift(first, second, axis) for axis in (0, 1)]
    rates = []
    for axis in (0, 1):
        ends = [model.unknown(point, axis) for point in (second, first)]
        found = [None if place is None else rate_of(model, place) for place in ends]
        rates.append(added((1, found[0]), (-1, found[1])))
    above = pruned(added((1, product(shifts[0], rates[1])), (-1, product(shifts[1], rates[0]))))
    return Ratio(above or Constant(0.0), Raised(model.geometry.length(first, second), 2))


def _enter_relative(model: Model, point: str, carrier: str) -> None:
    """Relative motion: along a line the derivatives of the way, on a circle those of the angle times the radius."""
    book = model.book
    place = model.slides[point, carrier]
    path = book.task.linkage.slide(point, carrier)
    along = rate_of(model, place)
    tangent = _tangent(model, point, carrier)
    name = Name(book.letter, point, part="rel")
    terms: Known = ()
    rate: Expression = along
    if path.centre:
        radius = book.geometry.length(path.centre, point)
        rate = radius * along
        if book.order == 2:
            speed = model.coordinates[place].speed
            if speed.exact:
                normal = book.derive(name.component("n"), book.measure, radius * speed**2)
                angle = book.geometry.direction(point, path.centre)
                facts = {"start": Point(point), "end": Point(path.centre)}
                terms = (book.term(normal.name or name, normal, angle, "towards", **facts),)
            name = name.component("tau")
    if along.exact:
        ahead = rate.number(True) > 0
        size = book.derive(name, book.measure, rate if ahead else Magnitude(rate))
        way = Value(None, "angle", degrees(tangent if ahead else -tangent))
        terms = (*terms, book.term(name, size, way, "track", point=Point(point)))
    table = book.relative if book.order == 1 else book.relative_acceleration
    table[point, carrier] = terms
    if book.order == 2:
        book.coriolis[point, carrier] = _coriolis(model, point, carrier, tangent)


def _tangent(model: Model, point: str, carrier: str) -> complex:
    """The direction in which the way or the angle of a sliding point grows."""
    return complex(model.task.linkage.slide(point, carrier).tangent(model.task.now.z))


def _coriolis(model: Model, point: str, carrier: str, tangent: complex) -> Known:
    """``a_cor = 2 omega v_rel``: the relative velocity turned by a right angle in the sense of the rotation."""
    book = model.book
    relative, rate = book.relative[point, carrier], book.omega.get(carrier)
    if rate is None or not rate.sense or not relative or relative[0].size is None:
        return ()
    name = Name("a", point, part="cor")
    size = book.derive(name, book.measure, Constant(2.0) * rate.size * relative[0].size)
    slip = Name("v", point, part="rel")
    way = Geometry.turned(relative[0].angle, 90.0 * rate.sense)
    return (book.term(name, size, way, "zhukovsky", relative=VectorOf(slip)),)
