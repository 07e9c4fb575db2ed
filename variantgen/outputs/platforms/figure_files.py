"""UsedFigures as files beside or inside a question: SVG or PNG of the usual size, each drawing made once."""

from __future__ import annotations

import hashlib
from collections.abc import Callable

from msgspec import Struct
from msgspec.structs import replace

from variantgen.figure.drawing import Drawing
from variantgen.figure.motion.plans import without_millimetres
from variantgen.outputs.figures import svg, unit
from variantgen.outputs.figures.engine import page_by
from variantgen.outputs.typst.typesetter import Typesetter

FORMS = ("svg", "png")
_PIXELS = 96 / 25.4  # of style sheets, in a millimetre
_LARGER = 1.4  # than on paper, as the letters of a page are


class FigureFile(Struct, frozen=True):
    """A file with a figure. ``name`` is made from the content, so that a reader cannot guess those of others."""

    name: str
    content: bytes
    drawing: Drawing

    @property
    def alt(self) -> str:
        """What the figure shows, in words."""
        return self.drawing.alt

    def size(self, millimetres: float | None = None) -> tuple[int, int]:
        """Width and height on a screen, in pixels, for a width on paper (None: the usual one).

        A plan that tells what a millimetre means keeps its millimetres, which the browser prints true.
        """
        measured = len(without_millimetres(self.drawing).labels) < len(self.drawing.labels)
        scale = unit(self.drawing, millimetres) * _PIXELS * (1.0 if measured else _LARGER)
        return round(scale * self.drawing.width), round(scale * self.drawing.height)


class FigureFiles:
    """The figures of a few students in one of :data:`FORMS`, each made once."""

    def __init__(self, form: str, engine: Typesetter) -> None:
        self._form, self._engine = form, engine
        self._made: dict[int, FigureFile] = {}  # with their drawings, so that no other one takes the place of one

    def file(self, drawing: Drawing) -> FigureFile:
        """The file of a drawing."""
        if id(drawing) not in self._made:
            content = page_by(self._engine, drawing, "png") if self._form == "png" else svg.render(drawing)
            name = f"{hashlib.sha256(content).hexdigest()[:20]}.{self._form}"
            self._made[id(drawing)] = FigureFile(name, content, drawing)
        return self._made[id(drawing)]


class UsedFigures:
    """The figures of one text or package; ``element(file, size)`` is one of them in a text, of a size in pixels."""

    def __init__(self, files: FigureFiles, element: Callable[[FigureFile, tuple[int, int]], str]) -> None:
        self.used: dict[str, FigureFile] = {}
        self._files, self._element = files, element

    def file(self, drawing: Drawing, caption: str = "") -> FigureFile:
        """The file of a figure, which is used from now on; the caption is told where the drawing tells nothing."""
        file = self._files.file(drawing if drawing.alt else replace(drawing, tell=lambda: caption))
        self.used[file.name] = file
        return file

    def image(self, drawing: Drawing, millimetres: float | None = None, caption: str = "") -> str:
        """A figure in a text, which has a width on paper (None: the usual one)."""
        file = self.file(drawing, caption)
        return self._element(file, file.size(millimetres))
