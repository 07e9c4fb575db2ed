"""The figure of the velocities of a wheel's centre and of the points at which it touches others."""

from __future__ import annotations

from collections.abc import Sequence

from variantgen.figure.equations.body_board import FigureSubject
from variantgen.figure.equations.body_figure import draw_body_figure
from variantgen.figure.making import Making
from variantgen.methods.steps.point_vectors import PointVectors

ORDER = 1


def draw(subject: FigureSubject, vectors: Sequence[PointVectors], which: str) -> Making:
    """The figure of the body ``which``, with what is marked in it. Raises InputError where it has no such vectors."""
    return draw_body_figure(subject, vectors, which, "contacts", ORDER)
