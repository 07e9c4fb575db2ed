"""The figure of the velocities of a wheel's centre and of the points at which it touches others."""

from __future__ import annotations

from collections.abc import Sequence

from variantgen.families.quantities import Quantity
from variantgen.figure.drawing import Drawing
from variantgen.figure.equations.body_board import FigureSubject
from variantgen.figure.equations.body_figure import draw_body_figure
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
    """The figure of the body ``which``, with what is marked in it. Raises InputError where it has no such vectors."""
    subject = FigureSubject(variant, motion, index, asked, language, geometry, true_scale)
    return draw_body_figure(subject, vectors, which, "contacts", ORDER)
