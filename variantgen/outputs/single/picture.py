"""A figure of a variant at hand: shown in notebooks, saved in any format (``variantgen.picture(variant)``)."""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import dataclass
from pathlib import Path
from typing import TYPE_CHECKING

from variantgen.families.asking import read_ask
from variantgen.figure.drawing import Drawing
from variantgen.figure.views import view as find_view
from variantgen.outputs.figures import mpl, write_figure
from variantgen.outputs.figures.svg import svg
from variantgen.outputs.figures.tikz import tikz
from variantgen.variants.variant import Variant, solve_variants
from variantgen.wording.language import load_language

if TYPE_CHECKING:
    from matplotlib.axes import Axes
    from matplotlib.figure import Figure, SubFigure


@dataclass(frozen=True, repr=False)
class Picture:
    """A drawing with its renderings; a notebook shows it by itself."""

    drawing: Drawing

    @property
    def alt(self) -> str:
        """What is seen, in words."""
        return self.drawing.alt

    @property
    def svg(self) -> str:
        """The figure as SVG."""
        return svg(self.drawing)

    @property
    def tikz(self) -> str:
        """The figure as TikZ source."""
        return tikz(self.drawing)

    def save(self, path: str | Path, width_mm: float | None = None) -> None:
        """Write the figure, of a width if one is given; the ending names the format: .svg, .png, .pdf, .tikz, .tex.

        A ``.tikz`` is a picture for a document of yours, a ``.tex`` a document by itself. Raises InputError.
        """
        write_figure(self.drawing, Path(path), width_mm)

    def matplotlib(self, ax: Axes | None = None) -> Figure | SubFigure:
        """The figure on axes of matplotlib, or as a figure of its own. Raises ToolMissingError without matplotlib."""
        if ax is None:
            return mpl.figure(self.drawing)
        mpl.draw_on(ax, self.drawing)
        return ax.figure

    def __repr__(self) -> str:
        drawing = self.drawing
        return f"<Picture {drawing.width:.0f} x {drawing.height:.0f} u: {self.alt.split('.', 1)[0] or 'no words'}>"

    def _repr_svg_(self) -> str:
        """What a notebook shows."""
        return self.svg


def picture(variant: Variant, view: str = "statement", language: str = "en", ask: Sequence[str] = ()) -> Picture:
    """The figure of one kind of a variant for the asked quantities (none: those of its form). Raises InputError."""
    kind, asked = find_view(view), read_ask(variant.form, tuple(ask) or None)
    # A figure of motion draws what the solution finds of all that is asked.
    motion = solve_variants([variant], kind.ORDER and max(kind.ORDER, *(quantity.order for quantity in asked)))
    return Picture(kind.draw(variant, motion, 0, asked, load_language(language)))
