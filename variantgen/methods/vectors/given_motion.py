"""What the statement gives: rates of driven bodies, vectors of driven points."""

from __future__ import annotations

from msgspec.structs import replace

from variantgen.algebra.expression import Constant, Expression, Magnitude, Pi, Ratio, Times, Total, Value
from variantgen.algebra.name import Name
from variantgen.algebra.normal_form import simplified
from variantgen.families.family import ComponentTemplate
from variantgen.families.literal_data import rate_name
from variantgen.families.parameters.expressions import FamilyExpression
from variantgen.families.parameters.units import IN_LONGER_TIMES, LENGTHS, Unit, short_unit, unit
from variantgen.mechanism.drivers.circling import Circling
from variantgen.mechanism.drivers.extension import Extension
from variantgen.mechanism.drivers.relative_travel import RelativeTravel
from variantgen.mechanism.drivers.rotation import Rotation
from variantgen.mechanism.drivers.travel import Travel
from variantgen.mechanism.rows import Constraint
from variantgen.mechanism.scene import label
from variantgen.methods.geometry.geometry import Geometry, degrees, normal_angle
from variantgen.methods.groups.group import PointPath
from variantgen.methods.groups.route import Route
from variantgen.methods.linkage.time_laws import is_uniformly_accelerated, law_behind, law_of, places, rate_of_law
from variantgen.methods.solution.book import Book, Known, Rate, resultant
from variantgen.methods.steps.step import Body, Derived, Fact, Point, Segment, Term
from variantgen.methods.vectors.point_paths import on_path
from variantgen.methods.vectors.points import sum_up

_IN_GROUPS = (Rotation, Extension, RelativeTravel, Circling)  # relative motion: given with a group of the route
_RATES = ("omega", "epsilon")
_LEVEL = 1e-9  # of a unit vector
_REST = 1e-12  # of the natural scale: a vector below it is none


def enter_given_motion(book: Book) -> None:
    """Enter what the drivers give at the order that is being worked out; what has to be worked out is a step.

    Raises LookupError for a driver of a kind that neither this step nor a group knows.
    """
    driven, scene = book.task.linkage.driven, book.task.scene
    points = [point for _, point in driven if point]
    one = {"point": Point(points[0])} if len(points) == 1 else {}
    with book.step(f"given.{book.measure}{'_of' if one else ''}", **one) as made:
        for template, driver, (body, point) in zip(book.task.form.drivers, scene.drivers, driven, strict=True):
            if body:
                value = amount(book, template, "omega" if book.order == 1 else "epsilon", book.rate_measure)
                book.rates[body] = Rate(value, _sign(book.exact_rate(body)))
            elif point and len(driver.shapes()) == 2:
                book.vectors[point] = _straight(book, template, point)
            elif point and points.count(point) > 1:
                _enter_component(book, template, driver, point)
            elif point:
                _enter_travel(book, template, point)
            elif not isinstance(driver, _IN_GROUPS):
                raise LookupError(f"no step takes what is given by {label(driver)}")
    if not made.items:
        book.steps.remove(made)


def _enter_component(book: Book, template: ComponentTemplate, driver: Constraint, point: str) -> None:
    """One of two components of a vector, along an axis. Raises LookupError for one that is along no axis."""
    ray = complex(book.task.scene.frame.direction(driver.angle)) if isinstance(driver, Travel) else 0j
    axis, way = next(
        ((n, w) for n, w in (("x", 1 + 0j), ("y", 1j)) if abs((ray * w.conjugate()).imag) < _LEVEL), ("", 0j)
    )
    if not axis or not ray:
        raise LookupError("components of one vector along other directions than the axes")
    if book.order == 1 and not book.has_said("given.law_coordinates"):
        book.say("given.law_coordinates", False, point=Point(point))
    name, source = Name(book.letter, point).component(axis), template.fields.get(book.letter)
    of_law = isinstance(source, FamilyExpression) and _is_of_law(book, source)
    stated = book.task.expressed(source) if of_law and isinstance(source, FamilyExpression) else None
    if stated is None:
        size = amount(book, template, book.letter, book.measure)
        way *= _sign((book.exact(point) * way.conjugate()).real)
    else:
        ahead = (ray * way.conjugate()).real > 0
        by_law = rate_of_law(book.task, source) if isinstance(source, FamilyExpression) else None
        law = None if by_law is None else by_law[1] if ahead else -by_law[1]
        size = book.derive(name, book.measure, simplified(stated if ahead else -stated), law)
    before = book.vectors.get(point, ())
    angle = book.geometry.stated_angle(None, way)
    book.vectors[point] = (*before, book.term(name, size, angle, "given", point=Point(point)))
    if before:
        sum_up(book, point)


def _enter_travel(book: Book, template: ComponentTemplate, point: str) -> None:
    """A given vector along a path; on a circle the given acceleration is the tangential one, the normal one follows."""
    point_path = Route(book).point_path(point)
    if point_path is None or point_path.straight:
        book.vectors[point] = _straight(book, template, point)
        return
    if book.order == 1:
        found = _straight(book, template, point)
        book.vectors[point] = tuple(replace(term, angle=_on_circle(book, point_path, term)) for term in found)
        return
    normal, path = on_path(book, point_path)
    rest = book.exact(point) - resultant(normal)
    if abs(rest) < _REST * book.scale:
        book.vectors[point] = normal
        return
    size = amount(book, template, book.letter, book.measure)
    if as_stated(path.name, size) != path.name:
        size = book.derive(path.name, book.measure, size)  # what has a letter of its own is named by its point too
    ahead = abs(normal_angle(path.angle.exact - degrees(rest))) < 90.0
    angle = path.angle if ahead else Geometry.turned(path.angle, 180.0)
    book.vectors[point] = (*normal, book.term(path.name, size, angle, "given", point=Point(point)))
    sum_up(book, point)


def _on_circle(book: Book, point_path: PointPath, term: Term) -> Value:
    """The direction of a given velocity, across the radius of the path."""
    _, path = on_path(book, point_path)
    ahead = abs(normal_angle(path.angle.exact - term.angle.exact)) < 90.0
    return path.angle if ahead else Geometry.turned(path.angle, 180.0)


def _straight(book: Book, template: ComponentTemplate, point: str) -> Known:
    """A given vector of a point: its magnitude by the data, its direction as the figure shows it."""
    vector = book.exact(point)
    if abs(vector) <= _REST * book.scale:
        return ()
    size = amount(book, template, book.letter, book.measure)
    key = "a_angle" if book.order == 2 and "a_angle" in template.fields else "angle"
    angle = book.geometry.stated_angle(template.fields.get(key), vector)
    return (book.term(as_stated(Name(book.letter, point), size), size, angle, "given", point=Point(point)),)


def as_stated(name: Name, size: Value) -> Name:
    """The name of a given vector: the symbol that the statement gives to its magnitude, if that is another one."""
    stated = size.name
    if stated is None or stated.kind != "parameter":
        return name
    usual = {f"{name.kind}_{name.of}", f"{name.kind}_{name.part}_{name.of}"}
    return name if stated.of in usual else stated


def amount(book: Book, template: ComponentTemplate, key: str, measure: str) -> Value:
    """The magnitude of a given rate: the given parameter itself, or a value worked out from the data."""
    source = template.fields.get(key)
    if not isinstance(source, FamilyExpression):
        return Value(None, measure, 0.0)
    expression = unsigned(book.task.expressed(source))
    if isinstance(expression, Value) and expression.measure == measure:  # not the time t, a derivative of t^2 / 2
        name = _name_of(book, template, key)
        if expression.exact < 0:  # a law that has been integrated goes backwards
            return book.derive(name, measure, Magnitude(expression))
        if expression.expression is None or name.kind not in _RATES or _is_letter_of_rate(expression):
            return expression
        return book.derive(name, measure, expression.expression)  # n in rpm is no angular velocity
    si = abs(book.task.read(source))
    number = si / book.task.length_unit if measure in ("velocity", "acceleration") else si
    if number == 0 or expression is None or (isinstance(expression, Constant) and not _is_of_law(book, source)):
        usual = unit(book.task.unit_of(measure))
        printed = short_unit(si, usual)
        if printed == usual:
            return book.task.stated_rates.get(rate_name(template, key)) or Value(None, measure, number)
        return book.derive(_name_of(book, template, key), measure, _converted(si, printed, usual))
    if book.order == 1:
        _say_law(book, template, source)
    name = _name_of(book, template, key)
    by_law = rate_of_law(book.task, source)
    if by_law is not None:
        stated = book.task.expressed(source)
        assert stated is not None, "by its law it can be"
        return _by_law(book, name, measure, simplified(stated), *by_law)
    simple = unsigned(simplified(expression))
    assert simple is not None
    expression = simple if simple.number(True) >= 0 else -simple  # a magnitude: the figure shows the sense
    return book.derive(name, measure, expression)


def _converted(si: float, printed: Unit, usual: Unit) -> Expression:
    """A rate in the usual unit by the number in that of the data: ``pi n/30`` of turns a minute, ``v/3.6`` of km/h."""
    number = Constant(float(f"{printed.from_si(si):.9g}"))
    if printed.name not in IN_LONGER_TIMES:
        return Ratio(Times((Pi(), number)), Constant(30.0))
    seconds = float(IN_LONGER_TIMES[printed.name])
    way = float(LENGTHS[printed.name.partition("/")[0]] / LENGTHS[usual.name.partition("/")[0]])
    if way <= seconds:
        return Ratio(number, Constant(seconds / way))
    return Ratio(Times((number, Constant(way))), Constant(seconds))


def _is_letter_of_rate(value: Value) -> bool:
    return value.name is not None and value.name.of.startswith(_RATES)


def _by_law(book: Book, name: Name, measure: str, expression: Expression, rate: Value, by_letter: Expression) -> Value:
    """The magnitude of a rate that a law gives: ``omega = phi' = ...``; a negative derivative has a line of its own."""
    assert rate.name is not None
    if expression.number(True) >= 0:
        found = book.derive(name, measure, expression, by_letter)
    else:
        book.items.append(Derived(rate))
        found = book.derive(name, measure, Magnitude(by_letter))
    velocity = replace(rate.name, dots=1)
    book.values[rate.name] = rate
    if velocity in book.values and book.values[velocity].exact * rate.exact < 0:
        book.say("given.slowing", False, first=velocity, second=rate.name)
    return found


def _is_of_law(book: Book, source: FamilyExpression) -> bool:
    return law_behind(book.task, source) is not None


def _say_law(book: Book, template: ComponentTemplate, source: FamilyExpression) -> None:
    """The law of time of which a given rate is the derivative, if it is one."""
    law = law_behind(book.task, source)
    if law is None:
        return
    if by := places(book.task.form):
        if law_of(book.task.form, source) in by:
            return
        place = Name("parameter", by[0])
        book.say("given.law_by_place", False, place=place, velocity=replace(place, dots=1))
        return
    if template.component is Extension:
        book.say("given.law_d", False, segment=Segment(template.fields["start"], template.fields["end"]))
        return
    point = template.fields.get("point")
    facts: dict[str, Fact] = (
        {"point": Point(point)} if isinstance(point, str) else {"body": Body(template.fields["body"])}
    )
    uniform = isinstance(point, str) and is_uniformly_accelerated(book.task.form, source)
    book.say("given.law_" + ("s_uniform" if uniform else "s" if isinstance(point, str) else "phi"), False, **facts)
    if isinstance(point, str) and rate_of_law(book.task, source) is None:  # the statement has no letter for it
        book.derive(Name("parameter", "s"), "length", law)


def _name_of(book: Book, template: ComponentTemplate, key: str) -> Name:
    """The name of a rate that is not given itself; along a path on a body or along a cylinder it is relative."""
    fields = template.fields
    if key in ("omega", "epsilon"):
        return Name(key, fields["body"])
    is_relative = template.component in (RelativeTravel, Circling, Extension)
    target = fields["end"] if template.component is Extension else fields["point"]
    name = Name(book.letter if key in ("v", "a") else key, target, part="rel" if is_relative else "")
    # On a circle only the component along the path is given, the normal one follows from the velocity.
    return name.component("tau") if template.component is Circling and key == "a" else name


def unsigned(expression: Expression | None) -> Expression | None:
    """An expression without a leading sign."""
    if isinstance(expression, Total) and len(expression.terms) == 1:
        return unsigned(expression.terms[0][1])
    return expression


def _sign(number: float) -> int:
    return (number > 0) - (number < 0)
