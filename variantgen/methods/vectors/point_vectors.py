"""The vectors of points and the rates of bodies as a solution names them: what figures of its motion draw.

At a point B with ``a^n_B + a^tau_B = a_A + a^n_BA + a^tau_BA`` these are the terms of the equation in its order, the
vector of another point as a whole. A point that turns about a fixed one without such an equation has its components.
"""

from __future__ import annotations

import cmath
import math
from collections.abc import Iterable
from itertools import groupby

import numpy as np

from variantgen.methods.algebra.name import Name
from variantgen.methods.solution.book import Book
from variantgen.methods.steps.step import Derived, Named, PointVectors, Step, Term, VectorLine
from variantgen.methods.vectors.given import as_stated

_OWN = ("n", "tau")  # components of the vector of a point on its path


def point_vectors(book: Book, steps: Iterable[Step], order: int) -> PointVectors:
    """What the ``steps`` of a solution say of the vectors of one order, with what its book knows."""
    book = book.at(order)
    task, unit = book.task, book.task.length_unit
    own = {point: (Name(book.letter, point), book.exact(point) * unit) for point in task.now.z}
    for point, known in book.vectors.items():
        if len(known) == 1 and known[0].name.kind == "parameter" and known[0].point == point:
            own[point] = known[0].name, own[point][1]
    kind = "omega" if order == 1 else "epsilon"
    rates = {body: Name(kind, body) for body in task.scene.bodies}
    rates |= {body: as_stated(rates[body], rate.size) for body, rate in book.rates.items()}
    found = PointVectors(own, rates, frozenset(point for point, _ in book.relative))
    for step in steps:
        for item in step.items:
            if isinstance(item, VectorLine) and any(term.name.kind == book.letter for term in _terms(item)):
                _add_equation(book, found, item)
    if order == 2:
        _add_turning(book, found, steps)
    return found


def _terms(line: VectorLine) -> tuple[Term, ...]:
    return (*line.left, *line.right)


def _add_equation(book: Book, found: PointVectors, line: VectorLine) -> None:
    """The terms of a vector equation, at the point that it is about; what is there already is not added again."""
    point = line.left[0].point if len(line.left) == 1 else line.right[-1].point
    vectors = _vectors(book, found, line)
    terms: list[Named] = []
    for side in (line.left, line.right):
        for other, group in groupby(side, lambda term: term.point):
            terms += [found.own[other]] if other != point else [(term.name, vectors[term.name]) for term in group]
    parts = found.terms.setdefault(point, [])
    known = {found.own[point][0], *(name for name, _ in parts)}
    parts += [(name, vector) for name, vector in terms if name not in known and not {"x", "y"} & {*name.part.split()}]


def _vectors(book: Book, found: PointVectors, line: VectorLine) -> dict[Name, complex]:
    """The vectors of an equation (SI) by name; what it does not give closes it."""
    unit = book.task.length_unit
    vectors: dict[Name, complex] = {}
    unknown: list[tuple[int, Name, complex]] = []
    rest = 0j
    for sign, side in ((1, line.left), (-1, line.right)):
        for term in side:
            way = cmath.rect(1.0, math.radians(term.angle.exact))
            whole, vector = found.own[term.point]
            if term.size is not None:
                vectors[term.name] = term.size.exact * unit * way
            elif term.name == whole:
                vectors[term.name] = vector
            elif not term.name.about and term.name.part in _OWN:
                vectors[term.name] = (vector * way.conjugate()).real * way
            else:
                unknown.append((sign, term.name, way))
                continue
            rest -= sign * vectors[term.name]
    if unknown:
        ways = [sign * way for sign, _, way in unknown]
        matrix = np.array([[way.real for way in ways], [way.imag for way in ways]])
        sizes = np.linalg.lstsq(matrix, np.array([rest.real, rest.imag]), rcond=None)[0]
        vectors |= {name: float(size) * way for (_, name, way), size in zip(unknown, sizes, strict=True)}
    return vectors


def _add_turning(book: Book, found: PointVectors, steps: Iterable[Step]) -> None:
    """Normal and tangential acceleration of one point of each body on a fixed axis where no equation shows them."""
    linkage, unit = book.task.linkage, book.task.length_unit
    derived = {item.value.name for step in steps for item in step.items if isinstance(item, Derived)}
    pivoted = {body for body in book.task.scene.bodies if linkage.pivot(body) is not None}

    def axis(point: str) -> str:
        """The body that leads a point round a fixed axis; the point itself where a joint does."""
        return next((body for body in linkage.owners(point) if body in pivoted), point)

    shown = {carrier for point, carrier in book.relative if point in found.terms}
    shown |= {axis(point) for point, terms in found.terms.items() if any(_is_own(name) for name, _ in terms)}
    named = {name for terms in found.terms.values() for name, _ in terms}
    # First the points whose accelerations are terms of equations.
    for point, known in sorted(book.acceleration.items(), key=lambda item: found.own[item[0]][0] not in named):
        parts = [
            (term.name, cmath.rect(term.size.exact * unit, math.radians(term.angle.exact)))
            for term in known
            if term.size is not None and _is_own(term.name) and term.name in derived
        ]
        # The points of a body in translation repeat what the point shows by which it is led.
        repeated = book.task.translating.issuperset(linkage.owners(point))
        if parts and axis(point) not in shown and not repeated:
            found.terms[point] = [*parts, *found.terms.get(point, [])]
            shown.add(axis(point))


def _is_own(name: Name) -> bool:
    return not name.about and name.part in _OWN
