"""The figure of the coordinate method: the mechanism with the axes x and y at their origin."""

from __future__ import annotations

from collections.abc import Sequence

from variantgen.figure.equations.body_board import FigureSubject
from variantgen.figure.equations.marked_mechanism import draw_marked_mechanism
from variantgen.figure.making import Making
from variantgen.methods.steps.point_vectors import PointVectors

ORDER = 1


def draw(subject: FigureSubject, vectors: Sequence[PointVectors], which: str) -> Making:
    """The figure of one variant; ``which`` are the axes, ``xy``."""
    return draw_marked_mechanism(subject, vectors, True)
