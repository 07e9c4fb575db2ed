"""A figure of a variant at hand: shown in notebooks, saved in any format (``variantgen.picture(variant)``)."""

from __future__ import annotations

from collections.abc import Sequence
from pathlib import Path
from typing import TYPE_CHECKING

from msgspec import Struct

from variantgen.errors import InputError, Problem
from variantgen.exam.solution_figures import SolutionFigures, view_order
from variantgen.families.asking import read_ask
from variantgen.figure.drawing import Drawing
from variantgen.figure.making import all_made
from variantgen.figure.views import is_of_parts
from variantgen.figure.views import view as find_view
from variantgen.methods.solution_options import SolutionOptions
from variantgen.outputs.figures import mpl, write_figure
from variantgen.outputs.figures.svg import svg
from variantgen.outputs.figures.tikz import tikz
from variantgen.variants.variant import Variant, solve_variants
from variantgen.wording.language import load_language
from variantgen.wording.solution.explain import explain

if TYPE_CHECKING:
    from matplotlib.axes import Axes
    from matplotlib.figure import Figure, SubFigure


class Picture(Struct, frozen=True):
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
    """The figure of one kind of a variant for the asked quantities (none: those of its form); of several the first.

    A number chooses another one: ``velocity_equation:2``. Raises InputError.
    """
    return pictures(variant, view, language, ask)[0]


def pictures(
    variant: Variant,
    view: str = "statement",
    language: str = "en",
    ask: Sequence[str] = (),
    methods: Sequence[str] = (),
    true_scale: bool = False,
) -> list[Picture]:
    """All figures of a kind: a solution by the ``methods`` (none: the natural ones) has one for each equation or body.

    A number after the kind chooses one of them: ``velocity_equation:2``. With ``true_scale`` no vector is lengthened to
    be seen. Raises InputError.
    """
    kind, _, number = view.partition(":")
    module, asked, spoken = find_view(kind), read_ask(variant.form, tuple(ask) or None), load_language(language)
    # A figure of motion draws what the solution finds of all that is asked.
    motion = solve_variants([variant], module.ORDER and max(module.ORDER, *(quantity.order for quantity in asked)))
    if not is_of_parts(kind):
        if number:
            raise InputError(
                Problem("there is one figure of this kind", key="view", value=view, remedy=f"write {kind}")
            )
        further = {"true_scale": True} if true_scale and kind in ("velocities", "accelerations") else {}
        return [Picture(module.draw(variant, motion, 0, asked, spoken, **further))]
    text = explain(variant, motion, 0, asked, spoken, SolutionOptions(tuple(methods), "full", true_scale))
    figures = SolutionFigures(variant, asked, spoken, (motion, 0), None, text)
    names = [name for name in view_order(text) if name.partition(":")[0] == kind]
    if not names:
        other = sorted({name.partition(":")[0] for name in view_order(text)})
        remedy = f"its figures are: {', '.join(other)}"
        raise InputError(Problem("the solution has no figure of this kind", key="view", value=view, remedy=remedy))
    if number:
        chosen = [str(i) for i in range(1, len(names) + 1)]
        if number not in chosen:
            remedy = f"one of {', '.join(chosen)}"
            raise InputError(Problem("the solution has no such figure", key="view", value=view, remedy=remedy))
        names = [names[int(number) - 1]]
    return [Picture(drawing) for drawing in all_made([*figures.begun(names).values()])]
