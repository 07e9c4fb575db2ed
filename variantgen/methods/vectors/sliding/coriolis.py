"""The Coriolis acceleration: ``2 omega v_rel`` turned by the rule of Zhukovsky, and what a teacher remarks on it.

It is zero where the carrier does not turn or nothing moves relative to it, and often it is in none of the projections.
"""

from __future__ import annotations

from variantgen.algebra.expression import Constant
from variantgen.algebra.name import Name
from variantgen.methods.geometry.geometry import Geometry
from variantgen.methods.groups.carriers import is_translating
from variantgen.methods.groups.group import SlidingPair
from variantgen.methods.solution.book import Book, Known
from variantgen.methods.steps.step import Body, Projection, VectorOf, Word


def coriolis_of(book: Book, point: str, carrier: str) -> Known:
    """The Coriolis acceleration, known once the velocities are; where it is zero it is said why."""
    if book.order == 1:
        return ()
    rate = book.omega.get(carrier)
    relative = book.relative[point, carrier]
    if rate is None or not rate.sense or not relative:
        if not is_translating(book, carrier):  # of a translation it is said before
            turns = rate is not None and rate.sense
            book.say(f"relative.no_coriolis_{'relative' if turns else 'omega'}", carrier=Body(carrier))
        return ()
    name = Name("a", point, part="cor")
    assert relative[0].size is not None
    size = book.derive(name, "acceleration", Constant(2) * rate.size * relative[0].size)
    book.say("relative.zhukovsky", vector=VectorOf(name), relative=VectorOf(relative[0].name), sense=Word(rate.word))
    angle = Geometry.turned(relative[0].angle, 90.0 * rate.sense)
    return (book.term(name, size, angle, "zhukovsky", relative=VectorOf(relative[0].name)),)


def say_unneeded(book: Book, terms: Known) -> None:
    """Say that the Coriolis acceleration was not needed, where it is in none of the projections and not asked."""
    if book.graphics is not None or any(q.kind == "a_cor" for q in book.task.sought):
        return
    met = {
        share.term.name for item in book.items if isinstance(item, Projection) for share in (*item.left, *item.right)
    }
    for term in terms:
        if term.name not in met:
            book.say("relative.coriolis_not_needed", vector=VectorOf(term.name))


def say_uniform(book: Book, group: SlidingPair) -> None:
    """Why a relative acceleration is zero, or has no component along the path, if the point slides uniformly."""
    if book.order == 2 and book.relative[(point := group.path.point), group.carrier]:
        whole = Name("a", point, part="rel")
        key = "uniform" if group.path.line is not None else "uniform_circle"
        book.say(f"relative.{key}", False, vector=VectorOf(whole), normal=VectorOf(whole.component("n")))
