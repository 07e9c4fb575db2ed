"""A check of limit positions of a rocker: the height of the triangle OCB of a limit position by two of its angles.

The angles at O and at C, which a swing and a ratio of times need, were found by two laws of cosines. The distance of B
from OC is ``OB sin COB`` and ``CB sin OCB``: the law of sines. It costs one line.
"""

from __future__ import annotations

from collections.abc import Iterator

from variantgen.algebra.expression import Value, sin
from variantgen.algebra.name import Name
from variantgen.methods.solution.book import Book
from variantgen.methods.steps.step import Balance, Fact, Item, Segment, Sentence


def limit_triangle(book: Book) -> list[Item]:
    """Both heights in the first limit position of which both angles were found; nothing where there is none."""
    for pivot, centre, end, number in _corners(book):
        at_centre = book.values.get(Name("limit_corner", f"{pivot} {end}", number, body=centre))
        at_pivot = book.values[Name("limit_corner", f"{centre} {end}", number, body=pivot)]
        span = book.values[Name("limit", pivot + end, number)]
        if at_centre is not None:
            heights = (span * sin(at_pivot), book.geometry.length(centre, end) * sin(at_centre))
            sides = [Value(None, "number", height.number(True), height, span.exact) for height in heights]
            facts: dict[str, Fact] = {"base": Segment(pivot, centre), "reach": span, "arm": Segment(centre, end)}
            return [Sentence(f"check.limit_triangle_{number}", facts, detail=False), Balance(*sides)]
    return []


def _corners(book: Book) -> Iterator[tuple[str, str, str, str]]:
    """The pivot of the crank, the centre of the rocker, its pin and the position of each angle found at the pivot."""
    for name in book.values:
        if name.kind == "limit_corner":
            centre, end = name.of.split()
            if Name("limit", name.body + end, name.about) in book.values:
                yield name.body, centre, end, name.about
