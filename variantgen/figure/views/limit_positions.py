"""The figure of the limit positions of a slider or a rocker, which a rod drives from the pin of a crank."""

from __future__ import annotations

from collections.abc import Sequence

from variantgen.figure.equations.body_board import FigureSubject
from variantgen.figure.equations.limit_figure import draw_limits
from variantgen.figure.making import Making
from variantgen.methods.steps.point_vectors import PointVectors

ORDER = 1


def draw(subject: FigureSubject, vectors: Sequence[PointVectors], which: str) -> Making:
    """The figure; ``which`` are the points of crank, rod and rocker: ``O-A-B`` or ``O-A-B-C``."""
    return draw_limits(subject, which.split("-"))
