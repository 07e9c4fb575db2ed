"""The check of a solution: the first that applies and comes out, its angles as a reader of the steps knows them."""

from __future__ import annotations

from collections.abc import Iterator, Sequence

from variantgen.algebra.decimals import PRINTED_DIGITS
from variantgen.algebra.expression import Value
from variantgen.algebra.values import in_order
from variantgen.methods.checks.about_axis import about_axis
from variantgen.methods.checks.carrier_frame import from_the_arm
from variantgen.methods.checks.elimination import elimination
from variantgen.methods.checks.growth_of_speed import growth_of_speed
from variantgen.methods.checks.known_angles import by_known_angles, known_angles
from variantgen.methods.checks.limit_triangle import limit_triangle
from variantgen.methods.checks.magnitudes import magnitudes
from variantgen.methods.checks.other_axes import other_axes
from variantgen.methods.checks.other_base_point import other_base_point
from variantgen.methods.checks.result_check import equal_projections, third_axis
from variantgen.methods.checks.velocity_check import base_point_of_velocities
from variantgen.methods.solution.book import Book
from variantgen.methods.solution.used import used_lines
from variantgen.methods.steps.printed_digits import items_values
from variantgen.methods.steps.step import Item, Step

_NEAR = 1e-3  # of a number: so near comes who works it out with the printed ones before it


def check_of(book: Book, steps: Sequence[Step], found: Sequence[Value]) -> tuple[Item, ...]:
    """The check of a solution group by group with the answers ``found``; nothing where no relation is left."""
    needed = used_lines(steps, found)  # what is compared: a check works out no quantity of its own
    angles = known_angles(needed, found)
    checks = (by_known_angles(check, angles) for check in _checks(book, steps, needed))
    return next((check for check in checks if check and _is_repeated(check)), ())


def _checks(book: Book, steps: Sequence[Step], needed: Sequence[Step]) -> Iterator[Sequence[Item]]:
    """What each theorem says, in the order in which they are tried; worked out when it is its turn."""
    yield third_axis(steps)
    yield other_base_point(book, steps)
    yield base_point_of_velocities(book, needed)
    yield equal_projections(book)
    yield other_axes(book, steps)
    yield from_the_arm(book, steps)
    yield about_axis(book, steps)
    yield growth_of_speed(book, steps)
    yield limit_triangle(book)
    yield elimination(book, steps)
    yield magnitudes(book, steps)


def _is_repeated(check: Sequence[Item]) -> bool:
    """Whether a reader with the printed numbers gets those of a check; not where large numbers nearly cancel."""
    values = items_values(check)
    for value in in_order(values):
        value.round_to(PRINTED_DIGITS)
    return all(value.comes_out or _is_near(value) for value in values)


def _is_near(value: Value) -> bool:
    """Whether the printed numbers before a value lead to one near it."""
    again = value.shown if value.expression is None else value.expression.number(exact=False)
    return abs(again - value.shown) <= _NEAR * abs(value.shown)


def third_axis_of(steps: Sequence[Step], found: Sequence[Value]) -> tuple[Item, ...]:
    """The check of a solution by one method for the whole problem: its last vector equation on a third axis."""
    return by_known_angles(third_axis(steps), known_angles(steps, found))
