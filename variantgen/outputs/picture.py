"""A figure of a variant at hand: shown in notebooks, saved in any format (``variant.figure()``)."""

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
    from matplotlib.figure import Figure


@dataclass(frozen=True)
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

    def save(self, path: str | Path) -> None:
        """Write the figure; the ending names the format (.svg, .png, .pdf, .tikz). Raises InputError."""
        write_figure(self.drawing, Path(path))

    def matplotlib(self) -> Figure:
        """The figure as one of matplotlib. Raises ToolMissingError without matplotlib."""
        return mpl.figure(self.drawing)

    def _repr_svg_(self) -> str:
        """What a notebook shows."""
        return self.svg


def picture(variant: Variant, view: str = "statement", language: str = "en", ask: Sequence[str] = ()) -> Picture:
    """The figure of one kind of a variant for the asked quantities (none: those of its form). Raises InputError."""
    kind, asked = find_view(view), read_ask(variant.form, tuple(ask) or None)
    motion = solve_variants([variant], kind.ORDER)
    return Picture(kind.draw(variant, motion, 0, asked, load_language(language)))
