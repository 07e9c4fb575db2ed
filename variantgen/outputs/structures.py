"""The structures that can be composed: code, level, families of the catalogue that have them, a page with pictures."""

from __future__ import annotations

import tempfile
from collections.abc import Iterator, Sequence
from contextlib import suppress
from pathlib import Path

import jinja2
from markupsafe import Markup
from msgspec import Struct

from variantgen.errors import InputError
from variantgen.families.asking import read_ask
from variantgen.families.family import Family
from variantgen.figure.build import statement_figure
from variantgen.outputs.figures import write_whole
from variantgen.outputs.figures.svg import svg
from variantgen.resources import templates_dir
from variantgen.synthesis.compose import sketched
from variantgen.synthesis.levels import level
from variantgen.synthesis.recognition import structures_of
from variantgen.synthesis.structures import Structure, code, textbook_structures
from variantgen.synthesis.terminal import geared_structures, rolling_structures
from variantgen.variants.draw import draw
from variantgen.variants.variant import solve_variants
from variantgen.wording.language import load_language


class StructureRow(Struct, frozen=True):
    """A structure: its code, its level, the families (with their forms) that have it."""

    structure: Structure
    code: str
    level: str
    families: tuple[str, ...]


def structure_rows(families: Sequence[Family], most_links: int) -> list[StructureRow]:
    """The structures with up to so many moving links, each with the families that have it."""
    found: dict[Structure, list[str]] = {}
    for family in families:
        for form in family.forms.values():
            for structure in structures_of(form.sample):
                found.setdefault(structure, []).append(" ".join(filter(None, (family.name, form.name))))
    return [
        StructureRow(structure, code(structure), level(structure), tuple(found.get(structure, ())))
        for structure in [
            *textbook_structures(most_links),
            *rolling_structures(most_links),
            *geared_structures(most_links),
        ]
    ]


def write_structures(rows: Sequence[StructureRow], most_links: int, path: Path) -> None:
    """Write the page with a picture of each structure. Raises InputError where it cannot be written."""
    loader = jinja2.FileSystemLoader(templates_dir() / "synthesis")
    page = jinja2.Environment(loader=loader, autoescape=True).get_template("structures.html")
    shown = [
        {"picture": Markup(picture), "code": row.code, "level": row.level, "families": row.families}  # noqa: S704
        for row, picture in zip(rows, _pictures(rows), strict=True)
    ]
    write_whole(path, (page.render(rows=shown, links=most_links) + "\n").encode(), "--figure")


def _pictures(rows: Sequence[StructureRow]) -> Iterator[str]:
    """A picture of each structure, as one of its layouts is; "" where none was found."""
    english = load_language("en")
    with tempfile.TemporaryDirectory() as scratch:
        for number, row in enumerate(rows):
            picture = ""
            with suppress(InputError):
                variant = draw(sketched(row.structure, 0, Path(scratch)), None, [("structure", row.code, 0)])[0]
                drawing = statement_figure(variant, solve_variants([variant], 1), 0, read_ask(variant.form), english)
                picture = svg(drawing, row.code, name=f"s{number}")
            yield picture
