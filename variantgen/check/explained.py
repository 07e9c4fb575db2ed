"""Whether answers can be computed, marked and explained: what ``solve``, ``--explain`` and ``build`` would do."""

from __future__ import annotations

from collections.abc import Iterator, Sequence
from pathlib import Path

from variantgen.check.report import Report
from variantgen.errors import VariantgenError
from variantgen.exam.solution_figures import STATEMENT, SolutionFigures, view_order
from variantgen.families.quantities import Quantity, motion_order
from variantgen.figure.build import statement_figure
from variantgen.figure.faults import figure_faults, vector_faults
from variantgen.mechanism.motion import Motion
from variantgen.mechanism.outcome import Outcome
from variantgen.resources import languages
from variantgen.single import asked_quantities, one_variant, solution_document
from variantgen.variants.variant import Variant, solve_variants
from variantgen.wording.language import Language, load_language
from variantgen.wording.solution.document import SolutionText
from variantgen.wording.solution.explain import UnexplainedError, explain

LEAST_INDEX = 7.0  # size of the indices of figures, pt


def check_single_scene(name_or_path: str, folders: tuple[Path, ...], report: Report) -> None:
    """Look at a scene in which nothing varies. Raises InputError for one that cannot be read or contradicts itself."""
    variant = one_variant(name_or_path, folders=folders)
    document = solution_document(variant)
    outcome = Outcome[document["outcome"].upper()]
    if outcome is not Outcome.SOLVED:
        report.fail(outcome.text)
        return
    asked = asked_quantities(variant)
    motion = solve_variants([variant], motion_order(asked))
    check_explained(variant, motion, asked, report)
    try:
        statement_figure(variant, motion, 0, asked, load_language(languages()[0]))
    except VariantgenError as error:
        report.fail(f"the figure cannot be drawn: {error}")


def check_explained(
    variant: Variant, motion: Motion, asked: Sequence[Quantity], report: Report, where: str = ""
) -> None:
    """Write the solution of the first variant of a solved batch; that there is no method for it is a remark."""
    for language in languages():
        try:
            text = explain(variant, motion, 0, asked, load_language(language))
            for fault in _figure_faults(variant, motion, asked, load_language(language), text):
                report.fail(fault, where)
        except UnexplainedError as error:
            report.remarks.append(str(error))
            return
        except VariantgenError as error:
            report.fail(f"the worked solution ({language}): {error}", where)


def _figure_faults(
    variant: Variant, motion: Motion, asked: Sequence[Quantity], language: Language, text: SolutionText
) -> Iterator[str]:
    """What is wrong with the figures of a solution, in words."""
    figures = SolutionFigures(variant, asked, language, (motion, 0), None, text)
    figures.draw(view_order(text))
    for figure in (figure for row in figures.rows() for figure in row if figure.name != STATEMENT):
        faults = [*figure_faults(figure.drawing), *vector_faults(figure.drawing)]
        # A plan is as large as its scale says.
        if figure.index_size < LEAST_INDEX and not figure.name.endswith("_plan"):
            faults.append(f"its indices have {figure.index_size:.1f} pt, fewer than {LEAST_INDEX:g}")
        yield from (f"the figure {figure.name} of the solution ({language.name}): {fault}" for fault in faults)
