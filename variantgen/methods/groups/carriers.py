"""Which bodies carry a point: those whose motion is known, or is within reach."""

from __future__ import annotations

from variantgen.methods.linkage.problem import Task
from variantgen.methods.solution.book import Book


def carrier_of(book: Book, point: str) -> tuple[str, str]:
    """A body with a known motion that has the point, and its pole: a fixed point, or one that is known.

    Raises LookupError where no such body has the point.
    """
    bodies = book.task.scene.bodies
    owners = [body for body, members in bodies.items() if point in members and is_moved(book, body)]
    for body in owners:
        fixed = [p for p in bodies[body] if p in book.task.fixed]
        if fixed:
            return body, fixed[0]
    for body in owners:
        known = [p for p in bodies[body] if p in book.vectors]
        return body, next((p for p in known if p in _driven(book.task)), known[0])
    for body, members in bodies.items():
        if point in members and (body in book.rates or is_translating(book, body)):
            reachable = (p for p in members if p != point and is_carried(book, p, body))
            if pole := next(reachable, None):
                return body, pole
    raise LookupError(f"the motion of {point} is not known")


def _driven(task: Task) -> set[str]:
    """Points whose motion the statement gives: the poles that one takes first."""
    return {p for driver in task.scene.drivers for s in driver.shapes() if len(s.points) == 1 for p in s.points}


def is_within_reach(book: Book, point: str) -> bool:
    """Whether the vector of a point is written, or follows from a body whose motion is known."""
    if point in book.vectors:
        return True
    try:
        carrier_of(book, point)
    except LookupError:
        return False
    return True


def is_carried(book: Book, point: str, but: str) -> bool:
    """Whether a point belongs to another body whose motion is known."""
    return any(
        point in members and body != but and is_moved(book, body) for body, members in book.task.scene.bodies.items()
    )


def is_moved(book: Book, body: str) -> bool:
    """Whether the motion of a body is known at the order that is being worked out."""
    members = book.task.scene.bodies[body]
    return (body in book.rates or is_translating(book, body)) and any(p in book.vectors for p in members)


def is_translating(book: Book, body: str) -> bool:
    """Whether a body is kept from turning."""
    return body in book.task.translating
