"""One problem with figure and answers as PDF, PNG or SVG (``show --out``)."""

from __future__ import annotations

from collections.abc import Sequence
from pathlib import Path
from typing import Literal, get_args

from variantgen.errors import InputError, Problem, nearest
from variantgen.exam.sheets import Answer
from variantgen.families.quantities import Quantity
from variantgen.figure.build import statement_figure
from variantgen.outputs.documents.key_content import equation
from variantgen.outputs.documents.sheet_data import statement_data
from variantgen.outputs.documents.solution_data import notes_data
from variantgen.outputs.figures import write_whole
from variantgen.outputs.typst.typesetter import typesetter
from variantgen.outputs.typst.writing import TYPST
from variantgen.variants.variant import Variant, solve_variants
from variantgen.wording.answer_notes import answer_notes
from variantgen.wording.graph_words import read_off
from variantgen.wording.language import load_language
from variantgen.wording.statement import statement

Format = Literal["pdf", "png", "svg"]
FORMATS: tuple[Format, ...] = get_args(Format)


def page_format(path: Path) -> Format:
    """The format of a page, by the ending of its path. Raises InputError for another ending."""
    form = path.suffix.lstrip(".").lower()
    if form not in FORMATS:
        raise InputError(Problem("unknown format", key="--out", value=path.name, remedy=nearest(form, FORMATS)))
    return form


def write_single(
    variant: Variant, asked: Sequence[Quantity], answers: Sequence[Answer], language_name: str, path: Path, remark: str
) -> None:
    """Write one problem; the format follows the ending of the path. Raises InputError for another ending."""
    form = page_format(path)
    language = load_language(language_name)
    said = statement(variant, asked, language)
    data = {
        "lang": language_name,
        "title": variant.family.title(language_name),
        "remark": remark,
        "words": dict(language.words("sheet")),
        **statement_data(said, TYPST),
        "answers-title": language.words("key")["title"] + ":",
        "answers": [TYPST.equals(equation(a, language, variant.form.symbols), a.surd) for a in answers],
        "notes": notes_data(answer_notes(read_off(variant.form, asked), language, variant.form.symbols), TYPST),
        "figure": TYPST.figure(statement_figure(variant, solve_variants([variant], 0), 0, asked, language)),
    }
    with typesetter() as engine:
        made = engine.compile("single.typ", data, form)[0]
    write_whole(path, made, "--out")
