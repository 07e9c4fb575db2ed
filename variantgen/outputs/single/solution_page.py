"""One problem with its worked solution as a page: PDF, PNG or SVG (``show --explain --out``)."""

from __future__ import annotations

from collections.abc import Sequence
from pathlib import Path

from variantgen.exam.content import Written, with_figures
from variantgen.families.quantities import Quantity, motion_order
from variantgen.methods.solution_options import SolutionOptions
from variantgen.outputs.documents.solution_data import notes_data, problem_data, solution_words
from variantgen.outputs.figures import write_whole
from variantgen.outputs.single.problem_page import page_format
from variantgen.outputs.typst.typesetter import typesetter
from variantgen.outputs.typst.writing import TYPST
from variantgen.variants.variant import Variant, solve_variants
from variantgen.wording.answer_notes import answer_notes
from variantgen.wording.graph_words import read_off
from variantgen.wording.language import Language
from variantgen.wording.solution.explain import explain


def write_explained(
    variant: Variant,
    asked: Sequence[Quantity],
    language: Language,
    options: SolutionOptions,
    path: Path,
    remark: str = "",
) -> None:
    """Write one problem with its solution; the format follows the ending of the path.

    Raises InputError for another ending, UnexplainedError where no method leads to what is asked.
    """
    form = page_format(path)
    motion = solve_variants([variant], motion_order(asked))
    text = explain(variant, motion, 0, asked, language, options)
    (solved,) = with_figures([Written(variant, asked, (motion, 0), text)], language)
    data = {
        "lang": language.name,
        "title": variant.family.title(language.name),
        "remark": remark,
        "words": solution_words(language),
        "problem": problem_data(solved, language, TYPST),
        "notes": notes_data(answer_notes(read_off(variant.form, asked), language, variant.form.symbols), TYPST),
    }
    with typesetter() as engine:
        made = engine.compile("explained.typ", data, form)[0]
    write_whole(path, made, "--out")
