"""The check at the end of a solution: equal projections of velocities, and the equations of all constraints at once."""

from __future__ import annotations

from collections.abc import Mapping
from itertools import combinations

import numpy as np

from variantgen.algebra.expression import Constant, Value, cos
from variantgen.algebra.name import Name
from variantgen.algebra.values import in_order
from variantgen.mechanism.dense import DenseSystem
from variantgen.mechanism.motion import Motion
from variantgen.methods.linkage.problem import Task
from variantgen.methods.solution.book import Book
from variantgen.methods.steps.step import Body, Derived, Fact, Item, Segment, Sentence, Share, VectorOf
from variantgen.methods.vectors.vector_equation import share_of


def equal_projections(book: Book) -> list[Item]:
    """Projections of two velocities of a body on the line of their points, each worked out; nothing if none is fit.

    Fit are two points that both move, with velocities of known direction that are not across their line.
    """
    for body, members in book.task.scene.bodies.items():
        moving = [p for p in members if len(book.velocity.get(p, ())) == 1]
        for first, second in combinations(moving, 2):
            items = _pair(book, body, first, second)
            if items:
                return items
    return []


def all_constraints(task: Task, found: Mapping[str, Value]) -> list[Item]:
    """Asked accelerations by the coordinate method: all constraint equations, differentiated twice and solved at once.

    Only rates and magnitudes are compared, which the method gives without more ado.
    """
    asked = [q for q in task.asked if q.order == 2 and q.kind in ("a", "epsilon") and not q.component]
    if not asked:
        return []
    system = DenseSystem(_placed(task))
    gains = system.solve(2, system.solve(1))
    values = []
    for quantity in asked:
        if quantity.kind == "a":
            number = float(abs(gains.points[quantity.target][0])) / task.length_unit
            scale = task.largest_acceleration
        else:
            number = float(gains.bodies[quantity.target][0])
            scale = task.largest_acceleration / task.size
        name, measure = Name(quantity.kind, quantity.target), found[quantity.name].measure
        values.append(Derived(Value(name, measure, number, Constant(number), scale)))
    return [Sentence("check.constraints", {}, detail=False), *values]


def by_links(found: Mapping[str, Value]) -> list[Item]:
    """The answers ``found`` by going through the links, as a check of a method for the whole problem."""
    named = [value for value in found.values() if value.name is not None and value.measure != "number"]
    values = [Value(v.name, v.measure, v.exact, Constant(v.exact)) for v in named]
    return [Sentence("check.links", {}, detail=False), *(Derived(value) for value in values)] if values else []


def _placed(task: Task) -> Motion:
    """The position of the variant as a batch of one (SI), without velocities."""
    places = {name: np.array([place * task.length_unit]) for name, place in task.now.z.items()}
    return Motion(task.scene, np.zeros(1, dtype=np.int8), np.ones(1), places, {}, {}, {}, {})


def _pair(book: Book, body: str, first: str, second: str) -> list[Item]:
    """The check on one pair of points."""
    terms = [book.velocity[p][0] for p in (first, second)]
    if terms[0].size is terms[1].size or terms[0].angle.exact == terms[1].angle.exact:
        return []
    axis = book.geometry.direction(first, second)
    found = [share_of(term, axis) for term in terms]
    if any(share is None for share in found):
        return []
    facts: dict[str, Fact] = {"body": Body(body), "segment": Segment(first, second)}
    facts |= {"first": VectorOf(terms[0].name), "second": VectorOf(terms[1].name)}
    items: list[Item] = [Sentence("check.projections", facts, detail=False)]
    angles = [share.angle for share in found if share is not None and share.angle is not None]
    items += [Derived(corner) for corner in in_order(angles) if _is_new(book, corner)]
    return items + [Derived(_projection(share)) for share in found if share is not None]


def _is_new(book: Book, value: Value) -> bool:
    """Whether a value is a corner of a triangle that no step has needed: the directions here follow from it."""
    return value.name is not None and value.name.kind == "angle" and value.name not in book.values


def _projection(share: Share) -> Value:
    """The projection of a vector as a value with its arithmetic."""
    size = share.term.size
    assert size is not None
    expression = size if share.angle is None else size * cos(share.angle)
    if share.sign < 0:
        expression = -expression
    name = Name("projection", share.term.name.of, share.term.name.about, share.term.name.part, share.term.name.kind)
    return Value(name, size.measure, expression.number(True), expression, size.exact)
