"""A whole document: class, packages and definitions for an engine, around the pieces that templates have made.

The commands before the definitions are PyLaTeX's. Its ``Document`` would hold all pieces in memory and adds commands of
its own: the pieces go from their files into the source.
"""

from __future__ import annotations

import shutil
from collections.abc import Iterator, Mapping, Sequence
from pathlib import Path
from typing import TYPE_CHECKING, Any

from msgspec import Struct

from variantgen.outputs.latex.characters import Alphabet, Engine, is_cyrillic_language
from variantgen.outputs.latex.templates import fill
from variantgen.wording.language import load_language

if TYPE_CHECKING:
    from pylatex import Command

_MARGINS = {"sheets": (18, 16, 18), "key": (15, 14, 16), "solutions": (15, 14, 17)}  # mm: sides, top, bottom
_CYRILLIC_FONTS = ("CMU Serif", "CMU Typewriter Text")  # for LuaLaTeX: its usual font has no Cyrillic letters


class Needs(Struct, frozen=True):
    """What the text of a document needs beside its own letters."""

    inlatin: bool  # the commands of these names
    incyrillic: bool
    cyrillic: bool
    programs: bool


class Look(Struct, frozen=True):
    """What kind of document in which language, for an engine; ``font`` is one of LuaLaTeX, or nothing."""

    kind: str
    language: str
    engine: Engine
    font: str
    alphabet: Alphabet


def write_document(path: Path, look: Look, pieces: Sequence[Path], data: Mapping[str, Any]) -> None:
    """Write the source; ``data`` is what the definitions of the document are filled with."""
    needs = _needs(look, pieces)
    definitions = fill(f"{look.kind}_head.tex.j2", {**data, "needs": needs}, look.alphabet)
    with path.open("w", encoding="utf-8", newline="\n") as file:
        file.writelines(f"{command.dumps()}\n" for command in _loaded(look, needs))
        file.write("\n")
        file.writelines(f"{command.dumps()}\n" for command in _fonts(look, needs))
        file.write(f"{definitions}\n\n\\begin{{document}}\n")
        for piece in pieces:
            with piece.open(encoding="utf-8") as source:
                shutil.copyfileobj(source, file)
        file.write("\\end{document}\n")


def _needs(look: Look, pieces: Sequence[Path]) -> Needs:
    """What is found in the pieces."""
    inlatin = incyrillic = cyrillic = programs = False
    for piece in pieces:
        text = piece.read_text("utf-8")
        inlatin |= r"\inlatin{" in text
        incyrillic |= r"\incyrillic{" in text
        cyrillic |= any("Ѐ" <= letter <= "ӿ" for letter in text)
        programs |= r"\begin{Verbatim}" in text
    return Needs(inlatin, incyrillic, cyrillic, programs)


def _loaded(look: Look, needs: Needs) -> Iterator[Command]:
    """The class and the packages."""
    from pylatex import Command, NoEscape, Package

    if look.engine == "pdflatex" and is_cyrillic_language(look.language):
        yield Command("RequirePackage", NoEscape("fix-cm"))  # fonts of any size, where the fonts are not Latin Modern
    yield Command("documentclass", "article", "a4paper")
    for name, options in _packages(look, needs):
        yield Package(name, options=options or None)


def _packages(look: Look, needs: Needs) -> Iterator[tuple[str, str]]:
    """Names and options of the packages, in the order in which they are loaded."""
    yield from _encodings(look, needs)
    yield "babel", load_language(look.language).words("language")["babel"]
    sides, top, bottom = _MARGINS[look.kind]
    yield "geometry", f"hmargin={sides}mm, top={top}mm, bottom={bottom}mm, headheight=14pt, headsep=0pt, footskip=9mm"
    yield from ((name, "") for name in ("fancyhdr", "amsmath", "array", "xcolor"))
    if look.kind == "key":
        yield "longtable", ""
    else:
        yield "tikz", ""
    if look.kind == "solutions":
        yield "graphicx", ""
        yield "multicol", ""
    if needs.programs:
        yield "fancyvrb", ""


def _encodings(look: Look, needs: Needs) -> Iterator[tuple[str, str]]:
    """Packages of fonts: pdfLaTeX has one encoding for Latin letters and one for Cyrillic ones."""
    if look.engine == "lualatex":
        yield "fontspec", ""
        return
    russian = is_cyrillic_language(look.language)
    if russian or needs.incyrillic:
        yield "cmap", ""  # Cyrillic letters of the PDF can be copied and found
    first = {True: "T1," if needs.inlatin else "", False: "T2A," if needs.incyrillic else ""}[russian]
    yield "fontenc", first + ("T2A" if russian else "T1")
    yield "inputenc", "utf8"
    if not russian:
        yield "lmodern", ""


def _fonts(look: Look, needs: Needs) -> Iterator[Command]:
    """The fonts of LuaLaTeX that are not the usual ones."""
    from pylatex import Command, NoEscape

    if look.engine != "lualatex":
        return
    if look.font or needs.cyrillic:
        yield Command("setmainfont", NoEscape(look.font or _CYRILLIC_FONTS[0]))
    if needs.cyrillic and needs.programs:
        yield Command("setmonofont", _CYRILLIC_FONTS[1])
