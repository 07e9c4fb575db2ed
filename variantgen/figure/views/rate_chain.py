"""The figure of a chain of links between fixed pivots, with the graph of its links: three angular velocities."""

from __future__ import annotations

from collections.abc import Sequence

from variantgen.figure.equations.body_board import FigureSubject
from variantgen.figure.equations.chain_figure import draw_chain
from variantgen.figure.making import Making
from variantgen.methods.steps.point_vectors import PointVectors

ORDER = 1


def draw(subject: FigureSubject, vectors: Sequence[PointVectors], which: str) -> Making:
    """The figure of the chain that the ``geometry`` of a step names. Raises InputError where it names none."""
    return draw_chain(subject)
