"""Figures that are lettered together: each as if it were alone, and what cannot be drawn stands in no other's way."""

from __future__ import annotations

import numpy as np
import pytest

from variantgen.errors import InputError, Problem
from variantgen.exam.solution_figures import STATEMENT, SolutionFigures, draw_together, view_order
from variantgen.figure.build import draw_statement
from variantgen.figure.drawing import Drawing, Layer
from variantgen.figure.inspection.faults import count_label_faults, misread_labels
from variantgen.figure.making import Making, Unlettered, all_made, made, tried
from variantgen.figure.placement.label_requests import around
from variantgen.figure.placement.occupancy import Occupancy
from variantgen.figure.sketch import Sketch
from variantgen.single import asked_quantities, one_variant
from variantgen.variants.variant import solve_variants
from variantgen.wording.formula import Symbol
from variantgen.wording.language import load_language
from variantgen.wording.solution.explain import explain

ENGLISH = load_language("en")
# From a lone wheel to links full of letters; a sketch without a label beside them.
FAMILIES = ("four_bar", "rolling_wheel", "spool", "movable_pulley", "planetary_train", "sleeve_on_crank", "ladder")
SEEDS = ("1", "2")


def statement_of(family: str, seed: str) -> Making:
    """The figure of a statement in the making."""
    variant = one_variant(family, seed=seed)
    return draw_statement(variant, solve_variants([variant], 0), 0, asked_quantities(variant), ENGLISH)


def solution_figures(family: str, seed: str) -> tuple[SolutionFigures, list[str]]:
    """The figures of a solution, not yet drawn, and their names."""
    variant = one_variant(family, seed=seed)
    asked, motion = asked_quantities(variant), solve_variants([variant], 2)
    text = explain(variant, motion, 0, asked, ENGLISH)
    return SolutionFigures(variant, asked, ENGLISH, (motion, 0), None, text), view_order(text)


def seen(drawing: Drawing) -> tuple[object, ...]:
    """What is seen of a drawing."""
    return drawing.width, drawing.height, drawing.lines, drawing.labels, drawing.lengthened, drawing.beyond


def shown(figures: SolutionFigures) -> dict[str, Drawing]:
    """The drawings of a solution by name."""
    return {figure.name: figure.drawing for row in figures.rows() for figure in row}


def bare(corner: complex) -> Making:
    """A line from the origin without any label."""
    sketch = Sketch({}, 1.0)
    sketch.path((0j, corner), Layer.LINK)
    return (yield Unlettered(sketch, {})).drawing


def broken(after: int) -> Making:
    """A figure that gives up after so many sketches."""
    for _ in range(after):
        sketch = Sketch({"A": 0j}, 1.0)
        sketch.label(around(Symbol("A"), 0j, 1.0))
        yield Unlettered(sketch, {})
    raise InputError(Problem("cannot be drawn", key="view", value=str(after)))


def test_statements_drawn_together_are_as_alone() -> None:
    chosen = [(family, seed) for family in FAMILIES for seed in SEEDS]
    alone = [seen(made(statement_of(*one))) for one in chosen]
    assert [seen(drawing) for drawing in all_made([statement_of(*one) for one in chosen])] == alone
    between = all_made([bare(3 + 4j), *(statement_of(*one) for one in chosen[:3]), bare(5j)])
    assert [seen(drawing) for drawing in between[1:4]] == alone[:3]


def test_solutions_drawn_together_are_as_alone() -> None:
    together = [solution_figures(family, "1") for family in FAMILIES]
    draw_together(together)
    for family, (figures, names) in zip(FAMILIES, together, strict=True):
        alone, _ = solution_figures(family, "1")
        for name in names:
            alone.draw([name])
        assert [seen(one) for one in shown(figures).values()] == [seen(one) for one in shown(alone).values()]
        assert list(figures.numbers) == list(alone.numbers)


def test_what_cannot_be_drawn_leaves_the_others() -> None:
    found = tried([broken(0), bare(3 + 4j), broken(2), statement_of("four_bar", "1")])
    assert [isinstance(one, InputError) for one in found] == [True, False, True, False]
    with pytest.raises(InputError, match="cannot be drawn"):
        all_made([bare(1j), broken(1)])


def test_labels_that_are_not_doubtful_have_no_faults() -> None:
    known = [solution_figures(family, "3") for family in FAMILIES]
    draw_together(known)
    drawings = [one for figures, _ in known for name, one in shown(figures).items() if name != STATEMENT]
    good = [drawing for drawing in drawings if not drawing.doubtful]
    assert len(good) > len(drawings) / 2
    for drawing in good:
        assert not count_label_faults(drawing)
        assert not misread_labels(drawing)


def test_the_ink_of_each_figure_is_its_own() -> None:
    figures = [np.array([[0j, 10 + 0j]]), np.zeros((0, 2), dtype=complex), np.array([[20 + 5j, 20 + 9j]])]
    papers = Occupancy(figures)
    places, numbers = np.array([5 + 0j, 20 + 7j, 5 + 6j]), np.arange(3)[:, None]
    taken = papers.taken(places, 1.0, 1.0, numbers) > 0
    assert taken.tolist() == [[True, False, False], [False, False, False], [False, True, False]]
