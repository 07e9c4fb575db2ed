"""Comparison of a method with the solver: every vector and rate that a book has found, against the solved motion."""

from __future__ import annotations

from variantgen.methods.solution.book import Book, resultant
from variantgen.variants.attempts import VerificationError

AGREES = 1e-9  # of the natural scale: rounding of the arithmetic


def deviation(book: Book) -> float:
    """The largest deviation of what a book has found, relative to the largest velocity or acceleration.

    Rates are compared as the velocities (accelerations) that they give at the size of the mechanism.
    """
    task, worst = book.task, 0.0
    for order in (1, 2) if task.order == 2 and task.now.accelerated else (1,):
        book = book.at(order)
        scale = book.scale or 1.0
        for point, terms in book.vectors.items():
            if point in task.now.v:
                worst = max(worst, abs(resultant(terms) - book.exact(point)) / scale)
        for body, rate in book.rates.items():
            worst = max(worst, abs(rate.sense * rate.size.exact - book.exact_rate(body)) * task.size / scale)
    return worst


def confirm(book: Book) -> None:
    """Raise VerificationError, naming the data, if the steps of a solution lead to other numbers than the solver's."""
    found = deviation(book)
    if not found <= AGREES:
        variant = book.task.variant
        data = ", ".join(f"{name}={value}" for name, value in variant.printed.items())
        what = f"the solution deviates from the solver by {found:.1e}"
        raise VerificationError(f"{variant.family.name}: {what}" + (f" for {data}" if data else ""))
