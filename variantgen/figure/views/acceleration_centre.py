"""The figure of the accelerations of one body with the rays to its acceleration centre and the angle mu."""

from __future__ import annotations

from collections.abc import Sequence

from variantgen.figure.equations.body_board import FigureSubject
from variantgen.figure.equations.body_figure import draw_body_figure
from variantgen.figure.making import Making
from variantgen.methods.steps.point_vectors import PointVectors

ORDER = 2


def draw(subject: FigureSubject, vectors: Sequence[PointVectors], which: str) -> Making:
    """The figure of the body ``which``, with what is marked in it. Raises InputError where it has no such vectors."""
    return draw_body_figure(subject, vectors, which, "centre", ORDER)
