"""The figure of one vector equation of accelerations: the body concerned, and at the point what it adds up."""

from __future__ import annotations

from collections.abc import Sequence

from variantgen.figure.equations.body_board import FigureSubject
from variantgen.figure.equations.equation_figure import draw_equation
from variantgen.figure.making import Making
from variantgen.methods.steps.point_vectors import PointVectors

ORDER = 2


def draw(subject: FigureSubject, vectors: Sequence[PointVectors], which: str) -> Making:
    """The figure of the equation numbered ``which``. Raises InputError where there is no such equation."""
    return draw_equation(subject, ORDER, vectors, which)
