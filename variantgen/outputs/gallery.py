"""The gallery: figures of families, several of each form, as a page of HTML, a PDF and single files."""

from __future__ import annotations

import os
import shlex
from collections.abc import Sequence
from pathlib import Path
from typing import Any

from markupsafe import Markup
from msgspec import Struct

from variantgen.errors import InputError
from variantgen.families.family import Family
from variantgen.families.nice import no_nice_forms
from variantgen.figure.build import statement_figure
from variantgen.figure.drawing import Drawing
from variantgen.outputs.figures.svg import render, svg
from variantgen.outputs.files.folder import check_free, whole_folder
from variantgen.outputs.html.environment import environment
from variantgen.outputs.typst.markup import markup
from variantgen.outputs.typst.typesetter import typesetter
from variantgen.outputs.typst.writing import figure_data
from variantgen.single import asked_quantities, one_variant
from variantgen.variants.variant import solve_variants
from variantgen.wording.html import to_html
from variantgen.wording.language import Language, load_language
from variantgen.wording.statement import Statement, statement
from variantgen.wording.text import Text

FILES = ("index.html", "gallery.pdf", "figures/*.svg")


class Example(Struct, frozen=True):
    """One variant of a form: the name of its file, its seed, drawing and statement."""

    name: str
    seed: str
    drawing: Drawing
    statement: Statement


class FormRow(Struct, frozen=True):
    """The variants of one form, and the command that shows one of them but for its seed."""

    form: str
    examples: tuple[Example, ...]
    command: str


SolutionFigure = Sequence[tuple[Family, Sequence[FormRow]]]


class GalleryRequest(Struct, frozen=True):
    """What a gallery shows: ``each`` variants of every form, of the seeds ``seed``, ``seed + 1``, and so on.

    ``folders`` are those of families besides the catalogue, ``options`` what the commands need to find them.
    ``nice``: only hand-friendly variants, of the forms that have any.
    """

    families: Sequence[Family]
    language: str = "en"
    each: int = 3
    seed: int = 1
    folders: tuple[Path, ...] = ()
    options: tuple[str, ...] = ()
    nice: bool = False


def write_gallery(wanted: GalleryRequest, out: Path, force: bool = False) -> int:
    """Write the gallery into the folder ``out``, which is complete or not there; returns the number of figures.

    ``index.html`` stands alone; ``gallery.pdf`` has a bookmark for each family; ``figures`` holds the figures as SVG.
    The same input gives the same bytes. Raises InputError for wrong input.
    """
    language = load_language(wanted.language)
    families = [family for family in wanted.families if not wanted.nice or family.nice_forms]
    if not families:
        raise InputError(no_nice_forms(wanted.families[0]))
    check_free(out, force, lambda: FILES)
    with whole_folder(out, force, lambda: FILES) as folder:
        shown = [(family, _rows(wanted, family, language)) for family in families]
        every = [example for _, rows in shown for row in rows for example in row.examples]
        (folder / "figures").mkdir()
        for example in every:
            (folder / "figures" / f"{example.name}.svg").write_bytes(render(example.drawing))
        _write(folder / "index.html", _page(shown, language).encode())
        with typesetter() as engine:
            _write(folder / "gallery.pdf", engine.compile("gallery.typ", _document(shown, language))[0])
    return len(every)


def _rows(wanted: GalleryRequest, family: Family, language: Language) -> list[FormRow]:
    """The forms of a family with their variants."""
    rows = []
    for form in family.nice_forms if wanted.nice else family.forms:
        command = ["variantgen", "show", family.name, *(["--form", form] if form else [])]
        command += [*(["--lang", language.name] if language.name != "en" else []), *wanted.options]
        examples = tuple(_example(wanted, family, form, number, language) for number in range(1, wanted.each + 1))
        rows.append(FormRow(form, examples, shlex.join(command)))
    return rows


def _example(wanted: GalleryRequest, family: Family, form: str, number: int, language: Language) -> Example:
    """One variant of a form; the same that the command shows."""
    seed = str(wanted.seed + number - 1)
    variant = one_variant(family.name, seed=seed, form=form, folders=wanted.folders, nice=wanted.nice)
    asked = asked_quantities(variant)
    drawing = statement_figure(variant, solve_variants([variant], 0), 0, asked, language)
    name = "-".join(part for part in (family.name, form, str(number)) if part)
    return Example(name, seed, drawing, statement(variant, asked, language))


def _counts(shown: SolutionFigure, language: Language) -> str:
    """How many families, forms and figures there are."""
    rows = [row for _, own in shown for row in own]
    figures = sum(len(row.examples) for row in rows)
    return language.words("gallery")["counts"].format(families=len(shown), forms=len(rows), figures=figures)


def _page(shown: SolutionFigure, language: Language) -> str:
    """The page of HTML."""
    families = [
        {
            "name": family.name,
            "title": family.title(language.name),
            "forms": [
                {"name": row.form, "figures": [_figure(family, row, e, language) for e in row.examples]} for row in rows
            ],
        }
        for family, rows in shown
    ]
    return (
        environment("gallery")
        .get_template("index.html.j2")
        .render(
            lang=language.name,
            words=language.words("gallery"),
            sheet=language.words("sheet"),
            counts=_counts(shown, language),
            families=families,
        )
    )


def _figure(family: Family, row: FormRow, example: Example, language: Language) -> dict[str, Any]:
    """A figure of the page: markup that the program has made itself is marked as such."""
    comma = Markup(", ")
    return {
        "svg": Markup(svg(example.drawing, f"{family.title(language.name)} ({example.name})")),  # noqa: S704
        "text": _markup(example.statement.text),
        "given": comma.join(_markup([equation]) for equation in example.statement.given),
        "asked": comma.join(_markup([symbol]) for symbol in example.statement.asked),
        "command": f"{row.command} --seed {example.seed}",
    }


def _markup(text: Text | Sequence[Any]) -> Markup:
    """Text with formulas: strings are escaped, formulas are markup."""
    return Markup("").join(part if isinstance(part, str) else Markup(to_html(part)) for part in text)  # noqa: S704


def _document(shown: SolutionFigure, language: Language) -> dict[str, Any]:
    """Data for ``gallery.typ``."""
    return {
        "lang": language.name,
        "words": {**language.words("sheet"), **language.words("gallery")},
        "counts": _counts(shown, language),
        "families": [
            {"title": family.title(language.name), "forms": [_form_data(row) for row in rows]} for family, rows in shown
        ],
    }


def _form_data(row: FormRow) -> dict[str, Any]:
    return {
        "name": row.form,
        "asked": [markup(symbol) for symbol in row.examples[0].statement.asked],
        "command": row.command,
        "figures": [{"figure": figure_data(example.drawing), "seed": example.seed} for example in row.examples],
    }


def _write(path: Path, content: bytes) -> None:
    with path.open("wb") as file:
        file.write(content)
        file.flush()
        os.fsync(file.fileno())
