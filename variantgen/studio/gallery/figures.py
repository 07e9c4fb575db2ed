"""Figures of families as images for pages: they take the colours of light and dark pages by themselves."""

from __future__ import annotations

import hashlib
from typing import TYPE_CHECKING, Any

from variantgen.errors import InputError, Problem
from variantgen.resources import catalog_dir
from variantgen.studio.gallery.cards import ONLY, family_file, family_version, own_folders
from variantgen.studio.gallery.shipped import shipped_figure
from variantgen.studio.workspace import Workspace, write_whole

if TYPE_CHECKING:
    from collections.abc import Sequence
    from pathlib import Path

    from variantgen.variants.variant import Variant

FIRST_SEED = 11  # of the figure on a card
MOST_SEEDS = 100_000
_STYLE = (
    "<style>svg{color:#12161c}.variantgen-paper{fill:#fff}.variantgen-shade{fill:#ebebeb}"
    "@media(prefers-color-scheme:dark){svg{color:#eceff3}.variantgen-paper{fill:#181c22}"
    ".variantgen-shade{fill:#2b313a}}</style>"
)


def card_figure(workspace: Workspace, family: str, form: str, seed: int, language: str) -> str:
    """The figure of a variant of a form, kept on disk. Raises InputError for what there is not."""
    known = known_figure(workspace, family, form, seed, language)
    if known is not None:
        return known
    text = draw_card(workspace, family, "" if form == ONLY else form, seed, language)
    write_whole(_places(workspace, family, form, seed, language)[1], text)
    return text


def known_figure(workspace: Workspace, family: str, form: str, seed: int, language: str) -> str | None:
    """The figure of a variant of a form, if it was made in advance or is kept on disk. Raises InputError."""
    path, kept = _places(workspace, family, form, seed, language)
    if seed == FIRST_SEED and catalog_dir() in path.parents:
        shipped = shipped_figure(family, path, "" if form == ONLY else form, language)
        if shipped is not None:
            return shipped
    try:
        return kept.read_text("utf-8")
    except OSError:
        return None


def _places(workspace: Workspace, family: str, form: str, seed: int, language: str) -> tuple[Path, Path]:
    """The file of a family, and where a figure is kept. Raises InputError for what there is not."""
    file = family_file(workspace, family)
    name = f"{family_version(file)}-{family}-{form}-{seed}-{language}.svg"
    if not name.replace("-", "").replace("_", "").replace(".", "").isalnum():
        raise InputError(Problem("unknown form", key="form", value=form))
    return file, workspace.state("cache", "figures", name)


def draw_card(workspace: Workspace, family: str, form: str, seed: int, language: str) -> str:
    """The figure of a variant of a form, drawn. Raises InputError for what there is not."""
    from variantgen.single import one_variant

    return figure_of(one_variant(family, seed=str(seed), form=form, folders=own_folders(workspace, family)), language)


def figure_of(variant: Variant, language: str) -> str:
    """The figure of a variant as an image of its own."""
    return styled(drawn(variant, language))


def drawn(variant: Variant, language: str, ask: Sequence[str] = ()) -> str:
    """The figure of a variant for what is asked (nothing: what its form asks), in the style of the page around it."""
    from variantgen.figure.build import statement_figure
    from variantgen.outputs.figures.svg import svg
    from variantgen.single import asked_quantities
    from variantgen.variants.variant import solve_variants
    from variantgen.wording.language import load_language

    asked = asked_quantities(variant, ask)
    drawing = statement_figure(variant, solve_variants([variant], 0), 0, asked, load_language(language))
    return svg(drawing)


def styled(text: str) -> str:
    """A figure with a style of its own inside, for an image."""
    head, mark, rest = text.partition(">")
    return f"{head}{mark}{_STYLE}{rest}"


def specimen(workspace: Workspace, family: str, form: str, seed: int, language: str) -> dict[str, Any]:
    """A variant of a form as an open card shows it: figure, statement, answers, worked solution."""
    from markupsafe import Markup

    from variantgen.single import answers, asked_quantities, one_variant
    from variantgen.wording.html import to_html
    from variantgen.wording.language import load_language
    from variantgen.wording.statement import statement

    figure = card_figure(workspace, family, form, seed, language)
    name = "" if form == ONLY else form
    variant = one_variant(family, seed=str(seed), form=name, folders=own_folders(workspace, family))
    asked, spoken = asked_quantities(variant), load_language(language)
    said = statement(variant, asked, spoken)

    def markup(text: Any) -> Markup:
        return Markup("").join(part if isinstance(part, str) else Markup(to_html(part)) for part in text)  # noqa: S704

    found = [
        (
            markup([spoken.quantity(answer.quantity, variant.form.symbols)]),
            markup([spoken.answer(answer.quantity, answer.value)]),
            markup([spoken.unit(answer.unit)]),
        )
        for answer in answers(variant)
    ]
    return {
        "title": variant.family.title(language),
        "family": family,
        "form": name,
        "seed": seed,
        "figure": f"/figure/{family}/{form}/{seed}.svg?lang={language}&v={hash_of(figure)}",
        "text": markup(said.text),
        "given": [markup([equation]) for equation in said.given],
        "asked": [markup([symbol]) for symbol in said.asked],
        "answers": found,
    }


def hash_of(text: str) -> str:
    """A short name of a text, for addresses whose answer lasts."""
    return hashlib.sha256(text.encode()).hexdigest()[:12]
