"""Whether answers can be computed, marked and explained: what ``solve``, ``--explain`` and ``build`` would do."""

from __future__ import annotations

from collections.abc import Sequence
from contextlib import suppress
from pathlib import Path

from variantgen.check.report import Report
from variantgen.check.untold import untold_numbers
from variantgen.errors import VariantgenError
from variantgen.exam.solution_figures import solution_figure_faults
from variantgen.families.literal_data import literal_data
from variantgen.families.quantities import Quantity, motion_order
from variantgen.figure.build import statement_figure
from variantgen.mechanism.doubts import doubts
from variantgen.mechanism.motion import Motion
from variantgen.mechanism.outcome import Outcome
from variantgen.resources import languages
from variantgen.single import asked_quantities, one_variant, solution_document
from variantgen.variants.variant import Variant, solve_variants
from variantgen.wording.language import load_language
from variantgen.wording.solution.explain import UnexplainedError, explain


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
    check_told([variant], asked, report)
    stated = {datum.name for datum in literal_data(variant.form) if datum.kind == "rate"}
    for name in dict.fromkeys(q.name for q in asked if q.whole_name in stated and q.component in ("", "abs", "sense")):
        report.remark(f"ask: {name} is a number of the data; what is asked should have to be found")
    try:
        statement_figure(variant, motion, 0, asked, load_language(languages()[0]))
    except VariantgenError as error:
        report.fail(f"the figure cannot be drawn: {error}")


def check_told(variants: Sequence[Variant], asked: Sequence[Quantity], report: Report, where: str = "") -> None:
    """Whether the sheets of variants of one form tell every number that answers depend on.

    Where only something that nobody asks yet depends on one, that is a remark.
    """
    with suppress(VariantgenError):  # the check of the texts has told what is wrong with a statement
        for found in untold_numbers(variants, asked):
            place = ", ".join(filter(None, (where, found.places)))
            if found.asked:
                report.fail(found.message, place, found.message)
            else:
                report.remark(f"{place}: {found.message}")


def check_explained(
    variant: Variant, motion: Motion, asked: Sequence[Quantity], report: Report, where: str = ""
) -> None:
    """Write the solution of the first variant of a solved batch; that there is no method for it is a remark.

    What can be solved and is hardly meant (:mod:`variantgen.mechanism.doubts`) is a remark, too.
    """
    for problem in doubts(motion):
        report.remark(str(problem))
    for language in languages():
        try:
            text = explain(variant, motion, 0, asked, load_language(language))
            for fault in solution_figure_faults(variant, motion, asked, load_language(language), text):
                report.fail(fault, where)
        except UnexplainedError as error:
            report.remarks.append(str(error))
            return
        except VariantgenError as error:
            report.fail(f"the worked solution ({language}): {error}", where)
