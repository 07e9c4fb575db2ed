"""Asked positions, read from the geometry of the figure, and coordinates of the centres that a solution has found."""

from __future__ import annotations

import math
from contextlib import nullcontext

from variantgen.algebra.expression import Expression, Value
from variantgen.algebra.name import Name
from variantgen.algebra.normal_form import Signed, summed
from variantgen.families.quantities import Quantity
from variantgen.methods.centres import acceleration_centre, known_centre
from variantgen.methods.geometry.angle_sums import difference
from variantgen.methods.geometry.angles import corner_name
from variantgen.methods.solution.book import Book
from variantgen.methods.solution.named_angles import named
from variantgen.methods.solution.rays import Centre
from variantgen.methods.steps.step import Body, Derived, Sentence, Term
from variantgen.methods.vectors.points import RIGHT, UP, known_point
from variantgen.methods.vectors.vector_equation import share_of

_AXES = {"x": RIGHT, "y": UP}


def position_answer(book: Book, quantity: Quantity) -> Value:
    """A coordinate, a direction, a corner or a distance, with the lines of the position that lead to it."""
    geometry, points = book.geometry, quantity.points(book.task.now.z)
    if quantity.kind in _AXES:
        return geometry.coordinates(quantity.target)[0 if quantity.kind == "x" else 1]
    if quantity.kind == "distance":
        return geometry.length(*points)
    if not quantity.component:
        return geometry.direction(*points)
    first, vertex, last = points
    known = geometry.known_corner(vertex, first, last)
    if known is not None:
        return known
    name = corner_name(vertex, first, last)
    corner = difference(name, geometry.direction(vertex, first), geometry.direction(vertex, last))
    if corner.expression is not None:
        geometry.items.append(Derived(corner))
    return corner


def centre_coordinate(book: Book, quantity: Quantity) -> Value:
    """``x_P = x_A + AP cos phi_AP``, ``y_P = y_A + AP sin phi_AP`` by a known ray to the centre of a body."""
    body, axis = quantity.target, quantity.component
    name = Name(axis, quantity.kind, body=body)
    pole = known_point(book, body)
    key, facts = f"answers.coordinate_{quantity.kind}", {"body": Body(body)}
    # Both coordinates are found in one step.
    known = bool(book.steps) and (book.steps[-1].heading.key, book.steps[-1].heading.facts) == (key, facts)
    with nullcontext() if known else book.step(key, body=Body(body)):
        if quantity.kind == "P":
            centre = known_centre.centre_of(book, body)
        else:
            centre = acceleration_centre.centre_of(book, body, pole)
        if centre.infinite:
            return Value(name, "length", math.inf)
        number = 0 if axis == "x" else 1
        if centre.at:
            return book.geometry.coordinates(centre.at)[number]
        return book.derive(name, "length", _beyond(book, centre, number))


def _beyond(book: Book, centre: Centre, number: int) -> Expression:
    """The coordinate of a point of the body and the projection of its ray to the centre."""
    base = min(centre.rays, key=lambda point: abs(book.task.now.z[point]))
    ray = centre.rays[base]
    start = book.geometry.coordinates(base)[number]
    parts: list[Signed] = [(1, start)] if start.exact != 0 else []
    term = Term(centre.length(base), ray.arm, ray.angle, Sentence("ways.unknown"))
    share = share_of(term, (RIGHT, UP)[number])
    if share is not None:
        share = named(book, share)
        parts.append((share.sign, share.size))
    return summed(parts)
