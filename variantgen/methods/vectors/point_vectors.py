"""The vector equations of a solution with their vectors, and its names of rates: what figures of its motion draw."""

from __future__ import annotations

import cmath
import math
from collections.abc import Iterable, Sequence
from itertools import groupby

import numpy as np
from msgspec.structs import replace

from variantgen.algebra.name import Name
from variantgen.methods.solution.book import Book
from variantgen.methods.steps.point_vectors import Arrow, Axis, PointEquation, PointVectors
from variantgen.methods.steps.step import Body, Derived, Projection, Segment, Step, Term, VectorLine
from variantgen.methods.steps.whole_vectors import written_sides
from variantgen.methods.vectors.given_motion import as_stated

_RODS = ("crank", "rod")  # facts of headings
_OWN = ("n", "tau")  # components of the vector of a point on its path


def point_vectors(book: Book, steps: Sequence[Step], order: int) -> PointVectors:
    """What the ``steps`` of a solution say of the vectors of one order, with what its book knows."""
    book = book.at(order)
    task, unit = book.task, book.task.length_unit
    own = {point: Arrow(Name(book.letter, point), book.exact(point) * unit) for point in task.now.z}
    for point, known in book.vectors.items():
        if len(known) == 1 and known[0].name.kind == "parameter" and known[0].point == point:
            own[point] = Arrow(known[0].name, own[point].vector)
    kind = "omega" if order == 1 else "epsilon"
    rates = {body: Name(kind, body) for body in task.scene.bodies}
    rates |= {body: as_stated(rates[body], rate.size) for body, rate in book.rates.items()}
    found = [
        replace(_equation(book, own, line), bodies=_bodies(step), axes=_axes(step, line), step=number, rods=_rods(step))
        for number, step in enumerate(steps)
        for line in step.items
        if isinstance(line, VectorLine) and any(term.name.kind == book.letter for term in (*line.left, *line.right))
    ]
    if order == 2:
        derived = {item.value.name for step in steps for item in step.items if isinstance(item, Derived)}
        found = [*_turning(book, own, found, derived), *found]
    return PointVectors(own, rates, frozenset(point for point, _ in book.relative), tuple(found))


def _bodies(step: Step) -> tuple[str, ...]:
    """The bodies that the heading of a step names."""
    return tuple(fact.name for fact in step.heading.facts.values() if isinstance(fact, Body))


def _rods(step: Step) -> tuple[tuple[str, str], ...]:
    """The ends of the links that the heading of a step puts in the place of a contact."""
    found = (step.heading.facts.get(name) for name in _RODS)
    return tuple((fact.start, fact.end) for fact in found if isinstance(fact, Segment))


def _axes(step: Step, line: VectorLine) -> tuple[Axis, ...]:
    """The axes on which an equation is projected in its step."""
    terms = {term.name for term in (*line.left, *line.right)}
    axes = [
        Axis(cmath.rect(1.0, math.radians(item.axis.exact)), item.letter)
        for item in step.items
        if isinstance(item, Projection)
        and item.axis is not None
        and terms.issuperset(share.term.name for share in (*item.left, *item.right))
    ]
    return tuple(dict.fromkeys(axes))


def _equation(book: Book, own: dict[str, Arrow], line: VectorLine) -> PointEquation:
    """A vector equation with its vectors; those of another point than that which it is about are one."""
    left, right = written_sides(line)
    point = left[0].point if len(left) == 1 else right[-1].point
    vectors = _vectors(book, own, line)

    def arrow(term: Term) -> Arrow:
        """A term as an arrow."""
        if term.name not in vectors:
            return own[term.point]
        return Arrow(term.name, vectors[term.name], term.size is None, _way(term))

    def arrows(side: Sequence[Term]) -> Iterable[Arrow]:
        """The terms of a side as arrows, those of another point as one."""
        for other, group in groupby(side, lambda term: term.point):
            if other != point:
                yield own[other]
            else:
                yield from map(arrow, group)

    terms = tuple(map(arrow, (*left, *right)))
    return PointEquation(point, tuple(arrows(left)), tuple(arrows(right)), terms=terms)


def _way(term: Term) -> complex:
    return cmath.rect(1.0, math.radians(term.angle.exact))


def _vectors(book: Book, own: dict[str, Arrow], line: VectorLine) -> dict[Name, complex]:
    """The vectors of an equation (SI) by name; what is not known of them closes it."""
    vectors: dict[Name, complex] = {}
    unknown: list[tuple[Name, complex, int]] = []
    rest = 0j
    for sign, side in ((1, line.left), (-1, line.right)):
        for term in side:
            name, way = term.name, _way(term)
            if term.size is not None:
                vectors[name] = term.size.exact * book.task.length_unit * way
            elif name in (own[term.point].name, Name(book.letter, term.point)):
                vectors[name] = own[term.point].vector
            elif _is_own(name):
                vectors[name] = (own[term.point].vector * way.conjugate()).real * way
            else:
                unknown.append((name, way, sign))
                continue
            rest -= sign * vectors[name]
    if unknown:
        matrix = np.array([[sign * way.real, sign * way.imag] for _, way, sign in unknown]).T
        sizes = np.linalg.lstsq(matrix, np.array([rest.real, rest.imag]), rcond=None)[0]
        vectors |= {name: float(size) * way for (name, way, _), size in zip(unknown, sizes, strict=True)}
    return vectors


def _turning(
    book: Book, own: dict[str, Arrow], found: Sequence[PointEquation], derived: set[Name | None]
) -> Iterable[PointEquation]:
    """Normal and tangential acceleration of one point of each body on a fixed axis where no equation shows them.

    Only what is ``derived`` in the solution.
    """
    task = book.task

    def axis(point: str) -> str:
        """The body that leads a point round a fixed axis; the point itself where a joint does."""
        owners = task.linkage.owners(point)
        return next((body for body in owners if task.linkage.pivot(body) is not None), point)

    about = {equation.point for equation in found}
    arrows = [(equation.point, arrow.name) for equation in found for arrow in (*equation.left, *equation.right)]
    shown = {carrier for point, carrier in book.relative if point in about}
    shown |= {axis(point) for point, name in arrows if _is_own(name)}
    named = {name for _, name in arrows}
    # First the points whose accelerations are terms of equations.
    for point, known in sorted(book.acceleration.items(), key=lambda item: own[item[0]].name not in named):
        parts = tuple(
            Arrow(term.name, term.size.exact * task.length_unit * _way(term))
            for term in known
            if term.size is not None and _is_own(term.name) and term.name in derived
        )
        # The points of a body in translation repeat what the point shows by which it is led.
        repeated = task.translating.issuperset(task.linkage.owners(point))
        if parts and axis(point) not in shown and not repeated:
            shown.add(axis(point))
            yield PointEquation(point, (own[point],), parts)


def _is_own(name: Name) -> bool:
    return not name.about and name.part in _OWN
