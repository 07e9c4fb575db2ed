"""Goes through the groups of a mechanism: velocities from the given motion to what is asked, then accelerations."""

from __future__ import annotations

from variantgen.methods.by_groups.group_methods import GROUP_METHODS, Solve
from variantgen.methods.groups.group import (
    ContactGroup,
    Dyad,
    ExtendingLink,
    FixedSleeve,
    FloatingDyad,
    Group,
    PivotedLink,
    RelativeRotation,
    RollingContactPole,
    RollingWheel,
    SlidingPair,
    ThirdClassGroup,
    TwoPointBody,
)
from variantgen.methods.groups.route import Route
from variantgen.methods.groups.wanted import is_accelerated
from variantgen.methods.on_demand import on_demand
from variantgen.methods.solution.book import Book
from variantgen.methods.vectors import given_motion
from variantgen.methods.vectors.points import vector

HANDLERS: dict[type, Solve] = {
    PivotedLink: on_demand("centres.turning", "solve_pivoted_link"),
    RollingWheel: on_demand("centres.turning", "solve_rolling_wheel"),
    Dyad: on_demand("vectors.pole", "solve_dyad"),
    FloatingDyad: on_demand("vectors.pole", "solve_floating_dyad"),
    SlidingPair: on_demand("vectors.sliding.relative_motion", "solve_sliding_pair"),
    RelativeRotation: on_demand("centres.turning", "solve_relative_rotation"),
    FixedSleeve: on_demand("centres.turning", "solve_fixed_sleeve"),
    ContactGroup: on_demand("vectors.contacts.contact_motion", "solve_contact"),
    ExtendingLink: on_demand("vectors.sliding.cylinder", "solve_extending_link"),
    RollingContactPole: on_demand("centres.turning", "solve_rolling_contact_pole"),
    TwoPointBody: on_demand("vectors.pole", "solve_two_point_body"),
    ThirdClassGroup: on_demand("vectors.third_class_group", "solve_third_class_group"),
}


def at_order(book: Book, order: int) -> Book:
    """The book for velocities (1) or accelerations (2), where further points of bodies are found in its style."""
    return book.at(order, GROUP_METHODS[book.style.at(order)].carry)


def velocities(book: Book) -> list[Group]:
    """Work out the velocities that are needed; returns the groups in their order."""
    book = at_order(book, 1)
    given_motion.enter_given_motion(book)
    route, groups = Route(book), []
    while group := route.next():
        _solve(book, group)
        groups.append(group)
    for point in _asked_points(book, 1):
        vector(book, point)
    return groups


def accelerations(book: Book, groups: list[Group]) -> None:
    """Work out the accelerations, group by group in the same order."""
    book = at_order(book, 2)
    given_motion.enter_given_motion(book)
    for group in groups:
        if is_accelerated(book.task, group):
            _solve(book, group)
    for point in _asked_points(book, 2):
        vector(book, point)


def solve_groups(book: Book) -> list[Group]:
    """Velocities and, where any are asked, accelerations; returns the groups in their order."""
    groups = velocities(book)
    if book.task.order == 2:
        accelerations(book, groups)
    return groups


def _solve(book: Book, group: Group) -> None:
    """Solve a group by the method of the book's style if that applies, and else by vector equations."""
    applies, solve = GROUP_METHODS[book.style.at(book.order)].solvers.get(type(group), (None, None))
    if applies and solve and applies(book, group):
        solve(book, group)
    else:
        HANDLERS[type(group)](book, group)


def _asked_points(book: Book, order: int) -> list[str]:
    kind = "v" if order == 1 else "a"
    return [q.point for q in book.task.sought if q.kind == kind and q.order == order]
