"""A whole document: class, packages and definitions for an engine, around the pieces that templates have made."""

from __future__ import annotations

import shutil
from collections.abc import Iterator, Mapping, Sequence
from dataclasses import dataclass
from pathlib import Path
from typing import Any

from variantgen.outputs.latex.characters import Alphabet, Engine, is_cyrillic_language
from variantgen.outputs.latex.templates import fill
from variantgen.wording.language import load_language

_MARGINS = {"sheets": (18, 16, 18), "key": (15, 14, 16), "solutions": (15, 14, 17)}  # mm: sides, top, bottom
_CYRILLIC_FONTS = ("CMU Serif", "CMU Typewriter Text")  # for LuaLaTeX: its usual font has no Cyrillic letters
_PREAMBLE, _BODY = "@preamble@", "@body@"


@dataclass(frozen=True)
class Needs:
    """What the text of a document needs beside its own letters."""

    inlatin: bool  # the commands of these names
    incyrillic: bool
    cyrillic: bool
    programs: bool


@dataclass(frozen=True)
class Look:
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
    head, tail = _frame(look, needs)
    with path.open("w", encoding="utf-8", newline="\n") as file:
        file.write(head.replace(_PREAMBLE, definitions))
        for piece in pieces:
            with piece.open(encoding="utf-8") as source:
                shutil.copyfileobj(source, file)
        file.write(tail)


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


def _frame(look: Look, needs: Needs) -> tuple[str, str]:
    """The source before and after the pieces."""
    from pylatex import Document, NoEscape, Package

    document = Document(
        documentclass="article", document_options="a4paper", fontenc=None, inputenc=None, lmodern=False, textcomp=False
    )
    document.packages.clear()
    document.data.clear()
    for name, options in _packages(look, needs):
        document.packages.append(Package(name, options=NoEscape(options) if options else None))
    document.preamble += [NoEscape(line) for line in (*_fonts(look, needs), _PREAMBLE)]
    document.append(NoEscape(_BODY))
    source = document.dumps().replace("%\n", "\n")  # its lines end with comments
    head, tail = source.split(_BODY)
    return _before_class(look) + head.replace("\n\n\n", "\n"), tail.lstrip("\n") + "\n"


def _before_class(look: Look) -> str:
    """What stands before the class: fonts of any size, where the fonts are not Latin Modern."""
    return "\\RequirePackage{fix-cm}\n" if look.engine == "pdflatex" and is_cyrillic_language(look.language) else ""


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


def _fonts(look: Look, needs: Needs) -> Iterator[str]:
    """The fonts of LuaLaTeX that are not the usual ones."""
    if look.engine != "lualatex":
        return
    if look.font or needs.cyrillic:
        yield rf"\setmainfont{{{look.font or _CYRILLIC_FONTS[0]}}}"
    if needs.cyrillic and needs.programs:
        yield rf"\setmonofont{{{_CYRILLIC_FONTS[1]}}}"
