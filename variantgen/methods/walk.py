"""Goes through the groups of a mechanism: velocities from the given motion to what is asked, then accelerations."""

from __future__ import annotations

from collections.abc import Callable
from typing import Any

from variantgen.methods import given
from variantgen.methods.book import Book
from variantgen.methods.group import Composed, Crossed, Dyad, Group, Rolled, Slid, Turned
from variantgen.methods.points import vector
from variantgen.methods.pole import solve_crossing, solve_dyad
from variantgen.methods.relative_motion import solve_slid
from variantgen.methods.route import Route
from variantgen.methods.turning import solve_composed, solve_rolled, solve_turned

Handler = Callable[[Book, Any], None]

HANDLERS: dict[type, Handler] = {
    Turned: solve_turned,
    Rolled: solve_rolled,
    Dyad: solve_dyad,
    Crossed: solve_crossing,
    Slid: solve_slid,
    Composed: solve_composed,
}


def velocities(book: Book) -> list[Group]:
    """Work out the velocities that are needed; returns the groups in their order."""
    book.order = 1
    given.take(book)
    route, groups = Route(book), []
    while group := route.next():
        HANDLERS[type(group)](book, group)
        groups.append(group)
    for point in _asked_points(book, 1):
        vector(book, point)
    return groups


def accelerations(book: Book, groups: list[Group]) -> None:
    """Work out the accelerations, group by group in the same order."""
    book.order = 2
    given.take(book)
    for group in groups:
        HANDLERS[type(group)](book, group)
    for point in _asked_points(book, 2):
        vector(book, point)


def _asked_points(book: Book, order: int) -> list[str]:
    kind = "v" if order == 1 else "a"
    return [q.point for q in book.task.asked if q.kind == kind and q.order == order]
