"""The figure of the velocities of one body with their equal projections on the line through two points."""

from __future__ import annotations

from collections.abc import Sequence

from variantgen.families.quantities import Quantity
from variantgen.figure.drawing import Drawing
from variantgen.figure.equations.body_board import FigureSubject
from variantgen.figure.equations.centre_figure import draw_centre_figure
from variantgen.mechanism.motion import Motion
from variantgen.methods.steps.point_vectors import PointVectors
from variantgen.variants.variant import Variant
from variantgen.wording.language import Language

ORDER = 1


def draw(
    variant: Variant,
    motion: Motion,
    index: int,
    asked: Sequence[Quantity],
    language: Language,
    vectors: Sequence[PointVectors] = (),
    which: str = "",
) -> Drawing:
    """The figure of the body ``which`` (none: the first in plane motion). Raises InputError where it is at rest."""
    return draw_centre_figure(FigureSubject(variant, motion, index, asked, language), vectors, which, centre=False)
