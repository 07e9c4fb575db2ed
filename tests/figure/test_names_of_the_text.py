"""Figures of motion against the text of the solution beside which they stand, both as they are read on paper."""

from __future__ import annotations

import math
import re
from functools import cache

import pytest

from tests.figure.reading import FORMS
from variantgen.exam.solution_figures import STATEMENT, SolutionFigures, view_order
from variantgen.methods.solution_options import SolutionOptions
from variantgen.resources import languages
from variantgen.single import asked_quantities, one_variant
from variantgen.variants.variant import solve_variants
from variantgen.wording.formula import Measured, to_plain
from variantgen.wording.language import load_language
from variantgen.wording.solution.document import FormulaLine, FormulaLines, Paragraph, SolutionText, VectorTable
from variantgen.wording.solution.explain import explain
from variantgen.wording.text import Text

ARROW = "\N{COMBINING RIGHT ARROW ABOVE}"
WHOLE = re.compile(r"[va]_[A-Z]")  # the vector of a point, which needs no derivation: v_A
SHORT = 0.05  # of the longest vector: below this an arrow of a plan is too short to be drawn
NO_PLAN = ("guided_plate", "three_rod_plate")  # groups of the third class
EQUATION = {1: "velocity_equation", 2: "acceleration_equation"}
CASES = [(n, f, m) for n, f in FORMS for m in ((), ("graphical",)) if not m or n not in NO_PLAN]


@cache
def shown(
    name: str, form: str, lang: str, methods: tuple[str, ...], seed: str = "1"
) -> tuple[SolutionText, dict[str, set[str]]]:
    """The text of a solution, and what is written in each of its figures of motion."""
    variant = one_variant(name, form=form, seed=seed)
    asked, language = asked_quantities(variant), load_language(lang)
    motion = solve_variants([variant], max(quantity.order for quantity in asked))
    text = explain(variant, motion, 0, asked, language, SolutionOptions(methods))
    figures = SolutionFigures(variant, asked, language, (motion, 0), None, text)
    figures.draw(view_order(text))
    found = {figure.name: figure.drawing for row in figures.rows() for figure in row if figure.name != STATEMENT}
    return text, {
        view: {part for label in drawing.labels for part in re.split(" = |, ", to_plain(label.formula))}
        for view, drawing in found.items()
    }


def formula_lines(text: SolutionText) -> list[FormulaLine]:
    """The lines of formulas of all steps."""
    blocks = [block for section in text.sections for block in section.blocks]
    return [line for block in blocks if isinstance(block, FormulaLines) for line in block.lines]


def formulas(text: SolutionText) -> list[str]:
    """All formulas of a solution as they are read, without the arrows above vectors."""
    blocks = [block for section in text.sections for block in section.blocks]
    parts: list[Text] = [block.text for block in blocks if isinstance(block, Paragraph)]
    parts += [(row.vector,) for block in blocks if isinstance(block, VectorTable) for row in block.rows]
    parts += [
        tuple(f for _, f in line.pieces) for block in blocks if isinstance(block, FormulaLines) for line in block.lines
    ]
    return [to_plain(part).replace(ARROW, "") for run in parts for part in run if not isinstance(part, str)]


def equations(text: SolutionText, letter: str) -> list[tuple[list[str], list[str]]]:
    """The vector equations of one letter: the vectors on their two sides."""
    lines = [
        line for section in text.sections for b in section.blocks if isinstance(b, FormulaLines) for line in b.lines
    ]
    sides = [[to_plain(formula) for _, formula in line.pieces] for line in lines]
    vectors = [pair for pair in sides if len(pair) == 2 and ARROW in pair[1]]
    return [
        (left.replace(ARROW, "").split(" + "), right.replace(ARROW, "").split(" + "))
        for left, right in vectors
        if f"{letter}{ARROW}" in left + right
    ]


def magnitudes(text: SolutionText) -> dict[str, float]:
    """The numbers that lines of a solution end with, without signs, by what stands on the left."""
    found = {}
    for line in (
        line for section in text.sections for b in section.blocks if isinstance(b, FormulaLines) for line in b.lines
    ):
        if isinstance(last := line.pieces[-1][1], Measured):
            found[to_plain(line.pieces[0][1])] = abs(float(re.sub("[^0-9.]", "", last.number.text.replace(",", "."))))
    return found


def is_vector(label: str, view: str) -> bool:
    """Whether a label is the name of a vector; small letters of a plan are ends of vectors."""
    return re.match(r"\(?[va][_^](?!′)", label) is not None or (not view.endswith("_plan") and label in "auvw")


@pytest.mark.parametrize("lang", languages())
@pytest.mark.parametrize(("name", "form", "methods"), CASES)
def test_a_figure_names_no_vector_that_the_text_does_not(
    name: str, form: str, methods: tuple[str, ...], lang: str
) -> None:
    text, figures = shown(name, form, lang, methods)
    written = formulas(text)
    for view, labels in figures.items():
        for label in (label for label in labels if is_vector(label, view) and not WHOLE.fullmatch(label)):
            assert any(re.search(rf"(?<!\w){re.escape(label)}(?!\w)", formula) for formula in written), (view, label)


@pytest.mark.parametrize("lang", languages())
@pytest.mark.parametrize(("name", "form", "methods"), CASES)
def test_a_figure_of_an_equation_has_exactly_its_vectors(
    name: str, form: str, methods: tuple[str, ...], lang: str
) -> None:
    text, figures = shown(name, form, lang, methods)
    for order, letter in enumerate("va", start=1):
        written = iter(equations(text, letter))
        views = {view for view in figures if view.startswith(f"{EQUATION[order]}:")}
        for number, equation in enumerate(text.vectors[order - 1].equations if order <= len(text.vectors) else (), 1):
            if equation.step < 0:
                continue
            left, right = next(written)
            view = f"{EQUATION[order]}:{number}"
            if view in figures:
                views.remove(view)
                vectors = {label for label in figures[view] if is_vector(label, view)}
                assert vectors == {*left, *right} - {"0"}, view
        assert not views


@pytest.mark.parametrize("lang", languages())
@pytest.mark.parametrize(("name", "form"), [(name, form) for name, form, methods in CASES if methods])
def test_a_plan_takes_vectors_apart_as_the_text_does(name: str, form: str, lang: str) -> None:
    text, figures = shown(name, form, lang, ("graphical",))
    sizes = magnitudes(text)
    for view, labels in ((view, labels) for view, labels in figures.items() if view.endswith("_plan")):
        for left, right in equations(text, view[0]):
            for term in (term for term in (*left, *right) if term != "0" and term not in labels):
                # The vector of which (a_B/A)_n, in Russian a^n_BA, is a component.
                inner = re.sub(r"^\((.+)\)_[nt]$", r"\1", term)
                whole = re.sub(r"\^\w+_|_", "_", inner.split()[0])
                if term == whole:
                    # The vector of a point is named by it even where the data name it.
                    assert whole[0] in labels, (view, term)
                elif whole not in labels or len(whole) > 3:
                    # What the text has no number of may be too short here: then it is drawn in another variant.
                    size = sizes.get(term, math.inf) / max(sizes[t] for t in sizes if t.lstrip("(")[0] == whole[0])
                    other = shown(name, form, lang, ("graphical",), "3")[1]
                    assert size < SHORT or term in other[view], (view, term)


@pytest.mark.parametrize("lang", ["en", "ru"])
def test_a_contact_at_rest_has_one_letter(lang: str) -> None:
    """Of two gears in plane motion the text calls the contact with the fixed gear P_2: so does the figure."""
    text, written = shown("planetary_train", "two_planets", lang, ())
    blocks = [block for section in text.sections for block in section.blocks if isinstance(block, Paragraph)]
    said = {to_plain(part) for block in blocks for part in block.text if not isinstance(part, str)}
    assert "P_2" in said
    letters = set().union(*written.values())
    assert "P_2" in letters
    assert "K" not in letters
