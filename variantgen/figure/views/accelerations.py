"""The figure of accelerations: the mechanism with the accelerations of the chain and their components to one scale.

At a point B that is reached from the pole A: a_B, a_A moved there (thin), ``a^n_BA`` towards A and ``a^tau_BA`` across
AB; where B turns about a fixed point ``a^n_B`` and ``a^tau_B``; at a point that slides on a body the transport (as the
solution writes it), relative and Coriolis accelerations. Arcs show the true senses of the angular accelerations.
"""

from __future__ import annotations

from collections.abc import Sequence
from functools import partial

from variantgen.families.quantities import Quantity
from variantgen.figure.drawing import BOLD, MEDIUM, THIN, Drawing
from variantgen.figure.equations.body_board import FigureSubject
from variantgen.figure.equations.marked_geometry import MOST_ANGLES, draw_geometry
from variantgen.figure.making import made
from variantgen.figure.motion.acceleration_centre import draw_acceleration_centres
from variantgen.figure.motion.contact_letters import draw_dot
from variantgen.figure.motion.motion_board import (
    LONGEST_OF_MANY,
    MotionBoard,
    draw_on_mechanism,
    named_together,
    scale_of,
)
from variantgen.figure.motion.motion_data import MotionData, MovingMechanism, motion_data
from variantgen.figure.motion.vectors import Named, Vectors, vectors_of
from variantgen.figure.symbols.rotation import draw_arcs
from variantgen.mechanism.motion import Motion
from variantgen.methods.steps.point_vectors import PointVectors
from variantgen.methods.steps.step_geometry import NOTHING_MARKED, StepGeometry
from variantgen.variants.variant import Variant
from variantgen.wording.language import Language

ORDER = 2
_NOTHING = 1e-9  # of the largest rate


def draw(
    variant: Variant,
    motion: Motion,
    index: int,
    asked: Sequence[Quantity],
    language: Language,
    vectors: Sequence[PointVectors] = (),
    true_scale: bool = False,
    geometry: StepGeometry = NOTHING_MARKED,
) -> Drawing:
    """The figure of one variant with the ``vectors`` of a solution and the ``geometry`` of its steps.

    Raises InputError where accelerations are not asked or there are none.
    """
    mechanism = MovingMechanism(variant, motion, index, asked, language)
    # A point that is asked only for its velocity is no matter of this figure.
    found = motion_data(mechanism, ORDER, [quantity for quantity in asked if quantity.order == ORDER])
    named = vectors_of(mechanism, ORDER, vectors)
    annotate = partial(_annotate, found, named, FigureSubject(mechanism, {}, geometry))
    return made(draw_on_mechanism(mechanism, annotate, true_scale))


def _annotate(found: MotionData, named: Vectors, subject: FigureSubject, board: MotionBoard, stretch: float) -> None:
    """Accelerations with their components, an asked centre, then arcs where there is room left."""
    now = found.now
    parts = components(found, named)
    scale = stretch * scale_of([vector for terms in parts.values() for _, vector in terms], LONGEST_OF_MANY)
    for point, terms in parts.items():
        if point not in board.shown:
            draw_dot(board, board.sketch.at[point], point)
        whole = terms[0][0]
        wholes = {others[0][0] for others in parts.values()} - {whole}
        for symbol, vector in named_together(terms, scale):
            weight = BOLD if symbol == whole else THIN if symbol in wholes else MEDIUM
            board.vector(point, scale * vector, symbol, weight)
    draw_acceleration_centres(board, now, named.task.asked)
    draw_geometry(board, subject, named.symbols, MOST_ANGLES if stretch == 1.0 else 0)
    fastest = max((abs(rate) for rate in now.epsilon.values()), default=0.0)
    for body, rate in now.epsilon.items():
        if abs(rate) > _NOTHING * max(fastest, max(abs(omega) for omega in now.omega.values()) ** 2):
            draw_arcs(board, body, [(named.rate(body), rate)])


def components(found: MotionData, named: Vectors) -> dict[str, Named]:
    """The acceleration of each point of the chain, first, and what it is put together from (m/s^2)."""
    points = named.telling(found.chain.points)
    parts = {point: [named.own(point), *named.terms(point)] for point in points}
    return parts | {point: named.terms(point) for point in named.slid_over()}
