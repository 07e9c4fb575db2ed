"""The figure of the coordinate method: the mechanism with the axes x and y at their origin."""

from __future__ import annotations

from collections.abc import Sequence

from variantgen.families.quantities import Quantity
from variantgen.figure.drawing import Drawing
from variantgen.figure.equations.body_board import FigureSubject
from variantgen.figure.equations.marked_mechanism import draw_marked_mechanism
from variantgen.mechanism.motion import Motion
from variantgen.methods.steps.point_vectors import PointVectors
from variantgen.methods.steps.step_geometry import NOTHING_MARKED, StepGeometry
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
    geometry: StepGeometry = NOTHING_MARKED,
    true_scale: bool = False,
) -> Drawing:
    """The figure of one variant; ``which`` are the axes, ``xy``."""
    return draw_marked_mechanism(FigureSubject(variant, motion, index, asked, language, geometry), vectors, True)
