"""The check of a solution: the first that applies, its angles as a reader of the steps knows them."""

from __future__ import annotations

from collections.abc import Sequence

from variantgen.algebra.expression import Value
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
from variantgen.methods.steps.step import Item, Step


def check_of(book: Book, steps: Sequence[Step], found: Sequence[Value]) -> tuple[Item, ...]:
    """The check of a solution group by group with the answers ``found``; nothing where no relation is left."""
    needed = used_lines(steps, found)  # what is compared: a check works out no quantity of its own
    check = third_axis(steps) or other_base_point(book, steps) or base_point_of_velocities(book, needed)
    check = check or equal_projections(book) or other_axes(book, steps) or from_the_arm(book, steps)
    check = check or about_axis(book, steps) or growth_of_speed(book, steps) or limit_triangle(book)
    check = check or elimination(book, steps) or magnitudes(book, steps)
    return by_known_angles(check, known_angles(needed, found))


def third_axis_of(steps: Sequence[Step], found: Sequence[Value]) -> tuple[Item, ...]:
    """The check of a solution by one method for the whole problem: its last vector equation on a third axis."""
    return by_known_angles(third_axis(steps), known_angles(steps, found))
