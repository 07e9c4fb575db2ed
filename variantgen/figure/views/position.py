"""The figure of the geometry of a step: the mechanism with its perpendiculars, sides and angles."""

from __future__ import annotations

from collections.abc import Sequence

from variantgen.figure.equations.body_board import FigureSubject
from variantgen.figure.equations.marked_mechanism import draw_marked_mechanism
from variantgen.figure.making import Making
from variantgen.methods.steps.point_vectors import PointVectors

ORDER = 1


def draw(subject: FigureSubject, vectors: Sequence[PointVectors], which: str) -> Making:
    """The figure of one variant; ``which`` is the number of the step."""
    return draw_marked_mechanism(subject, vectors, False)
