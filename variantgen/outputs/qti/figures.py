"""The figures of a package as files, each made and kept once, and the images that show them."""

from __future__ import annotations

import hashlib
from collections.abc import Callable
from xml.etree import ElementTree

from variantgen.figure.drawing import Drawing
from variantgen.outputs.figures import unit
from variantgen.outputs.figures.engine import page_by
from variantgen.outputs.figures.svg import render
from variantgen.outputs.qti.tree import element, line
from variantgen.outputs.typesetter import Typesetter

FORMS = ("png", "svg")
FOLDER = "images"
_PIXELS = 96 / 25.4  # of a style sheet in a millimetre
_SCREEN = 1.3  # of the size on paper, which is seen from nearer
_PLAN = 0.99  # of the usual size: only plans of vectors have it in solutions
_DOTS = 200.0  # of a picture to the inch, at the usual size


class Figures:
    """Figures of the form ``png`` or ``svg``; ``source`` makes of a name what an image points to."""

    def __init__(self, engine: Typesetter, form: str, source: Callable[[str], str] = lambda name: name) -> None:
        self.files: dict[str, bytes] = {}
        self._engine, self._form, self._source = engine, form, source
        self._known: dict[int, tuple[Drawing, str]] = {}  # with the drawing, so that no other one takes its place

    def image(self, drawing: Drawing, millimetres: float) -> str:
        """The image of a figure that has a width on paper; its words are those for readers who do not see.

        It is larger on the screen, but for plans: the text tells lengths of them.
        """
        is_plan = millimetres > _PLAN * unit(drawing) * drawing.width
        return self._image(drawing, millimetres if is_plan else _SCREEN * millimetres)

    def statement(self, drawing: Drawing) -> str:
        """The figure of a problem, as a paragraph."""
        return f'<p class="figure">{self._image(drawing, _SCREEN * unit(drawing) * drawing.width)}</p>'

    def _image(self, drawing: Drawing, millimetres: float) -> str:
        width = round(millimetres * _PIXELS)
        shown = {
            "src": self._source(self._name(drawing)),
            "alt": line(drawing.alt),
            "width": str(width),
            "height": str(round(width * drawing.height / drawing.width)),
        }
        return ElementTree.tostring(element("img", shown), encoding="unicode")

    def _name(self, drawing: Drawing) -> str:
        if id(drawing) not in self._known:
            content = page_by(self._engine, drawing, "png", ppi=_DOTS) if self._form == "png" else render(drawing)
            name = f"{FOLDER}/{hashlib.sha256(content).hexdigest()[:24]}.{self._form}"
            self.files[name] = content
            self._known[id(drawing)] = (drawing, name)
        return self._known[id(drawing)][1]
