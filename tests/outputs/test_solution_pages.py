"""Where parts of solutions stand on their pages, worked out by hand."""

from __future__ import annotations

from typing import Any

from variantgen.outputs.typst.solution_pages import (
    Block,
    Pages,
    ProblemBlocks,
    figure_block,
    is_too_high,
    pages_of,
    stacked,
)
from variantgen.outputs.typst.typesetter import typesetter


def unit(number: int, high: float, **others: Any) -> Block:
    return Block("unit", number, high, 4.0, 4.0, **others)


def figure(number: int, high: float, drawn: float = 0.0, least: float = 1.0) -> Block:
    return Block("figure", number, high, 3.0, 3.0, unit=1.0, least=least, drawn=drawn)


def places(pages: Pages) -> list[list[tuple[str, int, float, float]]]:
    """What stands on each page: what, which, from the left, from the top."""
    return [[(kind, number, x, y) for kind, _, number, x, y, _ in page] for page in pages.pages]


def test_columns_are_as_low_as_can_be() -> None:
    problem = ProblemBlocks((0, 0), tuple(unit(n, 40) for n in range(4)), figure(0, 30))
    found = pages_of(0, [problem])
    # Two units to the left are 84 high; figure and two units to the right 30 + 4 + 40 + 4 + 40 = 118. Three and one
    # would be 128.
    assert places(found) == [
        [
            ("unit", 0, 0, 0),
            ("unit", 1, 0, 44),
            ("figure", 0, 93, 0),
            ("unit", 2, 93, 34),
            ("unit", 3, 93, 78),
        ]
    ]
    assert found.y == 118


def test_what_is_wide_stands_between_columns() -> None:
    units = (unit(0, 20), unit(1, 20), unit(2, 15, wide=True), unit(3, 20), unit(4, 20))
    (page,) = places(pages_of(0, [ProblemBlocks((0, 0), units, figure(0, 44))]))
    # The units beside the figure take 20 + 4 + 20 = 44; 4 below the wide one, 4 below that the others, side by side.
    assert page[-3:] == [("unit", 2, 0, 48), ("unit", 3, 0, 67), ("unit", 4, 93, 67)]


def test_a_figure_comes_after_its_unit_or_where_there_is_room() -> None:
    units = (unit(0, 20), unit(1, 20, figures=(figure(1, 60),)), unit(2, 20))
    (page,) = places(pages_of(0, [ProblemBlocks((0, 0), units, figure(0, 20))]))
    # Columns are 20 + 3 + 60 = 83 high: after its unit, at 44, the figure would need 44 + 4 + 60. It goes to the right.
    assert page[-2:] == [("figure", 0, 93, 0), ("figure", 1, 93, 23)]


def test_no_statement_stands_alone_at_the_foot() -> None:
    first = ProblemBlocks((10, 8), (unit(0, 120), unit(1, 110)), figure(0, 20))
    second = ProblemBlocks((10, 8), (unit(0, 30), unit(1, 90)), figure(0, 20))
    found = places(pages_of(20, [first, second]))
    # Under the head (20) and the heading (8) some 140 are taken; of the other 100, a heading, a statement and what
    # follows it would need more.
    assert [page[0][0] for page in found] == ["head", "heading"]
    assert found[1][0] == ("heading", 1, 0, 0), "the one for the head of a page"


def test_figures_are_smaller_where_that_saves_a_nearly_empty_page() -> None:
    def problem(least: float) -> ProblemBlocks:
        tall = tuple(unit(n, 60, figures=(figure(n, 62, 100, least),)) for n in range(1, 5))
        return ProblemBlocks((0, 0), (unit(0, 20), *tall), figure(0, 20))

    assert len(pages_of(0, [problem(1.0)]).pages) == 2
    (page,) = pages_of(0, [problem(0.5)]).pages
    assert {unit for kind, _, number, _, _, unit in page if kind == "figure" and number} <= {0.92, 0.83}


def test_parts_stand_below_each_other() -> None:
    # 30 high, then 5 of space, as 3 below the first are fewer than 5 above the second, and 10.5.
    assert stacked([(4, 3, 30), (5, 2, 10.5)]) == (45.5, (0, 35))
    assert figure_block(0, 50, 0.5, 0.4, 5).high == 50 * 0.5 + 1.6 + 5
    assert not is_too_high([ProblemBlocks((0, 0), (unit(0, 267),), figure(0, 1))])
    assert is_too_high([ProblemBlocks((0, 0), (unit(0, 268),), figure(0, 1))])


def test_the_engine_has_one_input() -> None:
    # Several come to it in an order that changes from one document to the next, and what it remembers is lost.
    with typesetter() as engine:
        assert len(engine._told({"form": "pdf", "data": "data.json"})) == 1
