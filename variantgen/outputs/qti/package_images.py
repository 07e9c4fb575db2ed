"""The images of a package that show its figures; the figures are files, each made and kept once."""

from __future__ import annotations

from collections.abc import Callable
from xml.etree import ElementTree

from variantgen.figure.drawing import Drawing
from variantgen.outputs.platforms.figure_files import FigureFiles
from variantgen.outputs.qti.xml_tree import element, line
from variantgen.outputs.typst.typesetter import Typesetter

FORMS = ("png", "svg")
FOLDER = "images"


class PackageImages:
    """Figures of the form ``png`` or ``svg``; ``source`` makes of a name what an image points to."""

    def __init__(self, engine: Typesetter, form: str, source: Callable[[str], str] = lambda name: name) -> None:
        self.files: dict[str, bytes] = {}
        self._made, self._source = FigureFiles(form, engine), source

    def image(self, drawing: Drawing, millimetres: float | None = None) -> str:
        """The image of a figure that has a width on paper; its words are those for readers who do not see."""
        file = self._made.file(drawing)
        name = f"{FOLDER}/{file.name}"
        self.files[name] = file.content
        width, height = file.size(millimetres)
        shown = {"src": self._source(name), "alt": line(file.alt), "width": str(width), "height": str(height)}
        return ElementTree.tostring(element("img", shown), encoding="unicode")

    def statement(self, drawing: Drawing) -> str:
        """The figure of a problem, as a paragraph."""
        return f'<p class="figure">{self.image(drawing)}</p>'
