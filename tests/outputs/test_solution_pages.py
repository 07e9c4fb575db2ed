"""Where parts of solutions stand on their pages, worked out by hand."""

from __future__ import annotations

from typing import Any

from variantgen.outputs.typst.solution_pages import Block, ProblemBlocks, contents_of, is_too_high, pages_of
from variantgen.outputs.typst.typesetter import typesetter


def unit(number: int, high: float, **others: Any) -> Block:
    return Block("unit", number, high, 4.0, 4.0, **others)


def figure(number: int, high: float, drawn: float = 0.0, least: float = 1.0) -> Block:
    return Block("figure", number, high, 3.0, 3.0, unit=1.0, least=least, drawn=drawn)


def places(pages: dict[str, Any]) -> list[list[tuple[str, int, float, float]]]:
    """What stands on each page: what, which, from the left, from the top."""
    return [[(kind, number, x, y) for kind, _, number, x, y, _ in page] for page in pages["pages"]]


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
    assert found["high"] == 118


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

    assert len(pages_of(0, [problem(1.0)])["pages"]) == 2
    (page,) = pages_of(0, [problem(0.5)])["pages"]
    assert {unit for kind, _, number, _, _, unit in page if kind == "figure" and number} <= {0.92, 0.83}


def test_the_measured_heights_are_those_of_the_parts() -> None:
    # A part is the space above and below it and its height, which is measured where it is negative.
    units = [(False, [1], [(4, 2, -1), (3, 5, 10.5)]), (True, [], [(6, 4, -1)])]
    measured = {
        "heights": [20, 10, 8, 30, 40, 5, 6],
        "problems": [{"units": units, "figures": [(50, 0.5, 0.4), (60, 1, 1)]}],
    }
    head, (problem,) = contents_of(measured)
    assert (head, problem.headings) == (20, (10, 8))
    # 30 are measured, 3 are above the second part, whose 10.5 are known.
    assert [(block.high, block.wide) for block in problem.units] == [(43.5, False), (40, True)]
    assert [(block.above, block.below, block.parts) for block in problem.units] == [(4, 5, (0, 33)), (6, 4, (0,))]
    assert problem.beside.high == 50 * 0.5 + 1.6 + 5
    assert [own.high for own in problem.units[0].figures] == [60 + 1.6 + 6]
    assert not is_too_high([problem])
    assert is_too_high([ProblemBlocks((0, 0), (unit(0, 268),), figure(0, 1))])


def test_the_engine_has_one_input() -> None:
    # Several come to it in an order that changes from one document to the next, and what it remembers is lost.
    with typesetter() as engine:
        assert len(engine._told({"form": "pdf", "data": "data.json"})) == 1
