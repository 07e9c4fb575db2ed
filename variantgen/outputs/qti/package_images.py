"""The images of a package that show its figures; the figures are files, each made and kept once."""

from __future__ import annotations

from collections.abc import Callable
from xml.etree import ElementTree

from variantgen.figure.drawing import Drawing
from variantgen.outputs.platforms.figure_files import FigureFile, FigureFiles, UsedFigures
from variantgen.outputs.platforms.text import one_line
from variantgen.outputs.qti.xml_tree import element
from variantgen.outputs.typst.typesetter import Typesetter

FORMS = ("png", "svg")
FOLDER = "images"


def package_figures(engine: Typesetter, form: str, source: Callable[[str], str] = lambda name: name) -> UsedFigures:
    """UsedFigures of the form ``png`` or ``svg``; ``source`` makes of a name what an image points to."""

    def image(file: FigureFile, size: tuple[int, int]) -> str:
        width, height = map(str, size)
        shown = {"src": source(_path(file.name)), "alt": one_line(file.alt), "width": width, "height": height}
        return ElementTree.tostring(element("img", shown), encoding="unicode")

    return UsedFigures(FigureFiles(form, engine), image)


def statement_figure(figures: UsedFigures, drawing: Drawing) -> str:
    """The figure of a problem, as a paragraph."""
    return f'<p class="figure">{figures.image(drawing)}</p>'


def files(figures: UsedFigures) -> dict[str, bytes]:
    """The files of a package by their paths."""
    return {_path(name): file.content for name, file in figures.used.items()}


def _path(name: str) -> str:
    return f"{FOLDER}/{name}"
