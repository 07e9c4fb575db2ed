"""The method of three angular velocities and accelerations for a whole problem.

The chains of three links between fixed pivots are solved by it (:mod:`variantgen.methods.by_groups.closed_chain`), the
rest of the mechanism by the vector equation with a pole and by relative motion. It does not apply to a mechanism
without such a chain: a slider in the place of a link moves on a line and has no angular velocity of its own. Nor does
it apply to a parallelogram, whose coupler is known to translate.
"""

from __future__ import annotations

from variantgen.methods.by_groups import closed_chain, solve_groups
from variantgen.methods.groups.group import Dyad
from variantgen.methods.linkage.problem import Task
from variantgen.methods.solution.book import Book
from variantgen.methods.steps.method_style import MethodStyle
from variantgen.methods.steps.not_applicable import NOT_APPLICABLE

STYLE = MethodStyle("three_rates", "three_rates")


def applies(task: Task) -> bool:
    """Whether a chain of three links between fixed pivots leads to what is asked."""
    book = Book(task, style=STYLE)
    try:
        groups = solve_groups.velocities(book)
    except NOT_APPLICABLE:  # the rest of the mechanism cannot be solved group by group
        return False
    return any(isinstance(group, Dyad) and closed_chain.applies(book, group) for group in groups)


def solve(book: Book) -> None:
    """Write the steps of the method; what is asked is then known to the book."""
    book.style = STYLE
    groups = solve_groups.velocities(book)
    if book.task.order == 2:
        solve_groups.accelerations(book, groups)
