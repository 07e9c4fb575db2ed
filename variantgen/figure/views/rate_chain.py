"""The figure of a chain of links between fixed pivots, with the graph of its links: three angular velocities."""

from __future__ import annotations

from collections.abc import Sequence

from variantgen.families.quantities import Quantity
from variantgen.figure.drawing import Drawing
from variantgen.figure.equations.body_board import FigureSubject
from variantgen.figure.equations.chain_figure import draw_chain
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
    """The figure of the chain that the ``geometry`` of a step names. Raises InputError where it names none."""
    return draw_chain(FigureSubject(variant, motion, index, asked, language, geometry, true_scale), vectors)
