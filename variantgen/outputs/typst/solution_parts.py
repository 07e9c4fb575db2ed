"""What a solution consists of: parts, each with bodies of the source text, which together are units.

Between units a page or a column may end; where everything of them stands is found from their heights
(:mod:`variantgen.outputs.typst.solution_pages`).
"""

from __future__ import annotations

from collections.abc import Iterator, Mapping, Sequence

from msgspec import Struct, field

from variantgen.exam.solution_paper import EM
from variantgen.outputs.typst.solution_pages import Block, ProblemBlocks, figure_block, stacked

# How it is set, the number of a body, how far it is from the left and from the top (em).
Placed = tuple[str, int, float, float]


class Part(Struct, frozen=True):
    """A part of a solution: the number of its body and the space above and below it (em).

    It stays with what follows (``joined``), has the width of the page (``wide``), or what follows goes on in it
    (``open``). Of a row that is known these are its height (em) and, in the place of one body, its lines and ``marks``.
    At last the numbers of its figures.
    """

    body: int
    above: float
    below: float
    joined: bool = False
    wide: bool = False
    open: bool = False
    high: float | None = None
    placed: Sequence[Placed] = ()
    figures: Sequence[int] = ()


class ShownFigure(Struct, frozen=True):
    """The number of a drawing, its height in units, millimetres of a unit, the fewest of them, its caption's body."""

    drawing: int
    drawn: float
    unit: float
    least: float
    caption: int


class SolvedParts(Struct):
    """The bodies of the headings of a problem (below something else, at the head of a page), its parts, its figures."""

    headings: tuple[int, ...] = ()
    parts: list[Part] = field(default_factory=list)
    figures: list[ShownFigure] = field(default_factory=list)


def blocks_of(problem: SolvedParts, heights: Mapping[int, float], parted: bool) -> ProblemBlocks:
    """Its units and figures with their heights (mm); heights of what is measured are those of the bodies."""
    headings = [heights[number] for number in problem.headings]
    figures = [
        figure_block(number, figure.drawn, figure.unit, figure.least, heights[figure.caption])
        for number, figure in enumerate(problem.figures)
    ]
    units = []
    for number, parts in enumerate(units_of(problem.parts, parted)):
        own = [heights[part.body] if part.high is None else EM * part.high for part in parts]
        spaced = [(EM * part.above, EM * part.below, high) for part, high in zip(parts, own, strict=True)]
        high, starts = stacked(spaced)
        wide = any(part.wide for part in parts)
        shown = tuple(figures[number] for part in parts for number in part.figures)
        units.append(Block("unit", number, high, spaced[0][0], spaced[-1][1], wide, shown, starts))
    return ProblemBlocks((headings[0], headings[1]) if headings else (0.0, 0.0), tuple(units), figures[0])


def units_of(parts: Sequence[Part], parted: bool) -> Iterator[list[Part]]:
    """Parts that stand together."""
    own: list[Part] = []
    for part in parts:
        own.append(part)
        if parted or not part.joined:
            yield own
            own = []
