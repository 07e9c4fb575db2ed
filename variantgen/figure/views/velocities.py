"""The figure of velocities: the mechanism with all velocities to one scale, true senses of rotation, velocity centres.

The velocity centre P of a body is where the dashed perpendiculars to the velocities of its points meet; one that is
too far away is not shown, then short rays show the way to it. Vectors bear the names that the solution gives to them;
the speed of a rope or belt is shown where it is asked.
"""

from __future__ import annotations

from collections.abc import Sequence
from functools import partial

from variantgen.families.quantities import Quantity
from variantgen.figure.drawing import MEDIUM, Drawing
from variantgen.figure.equations.body_board import FigureSubject
from variantgen.figure.equations.marked_geometry import MOST_ANGLES, draw_geometry
from variantgen.figure.making import made
from variantgen.figure.motion.centre_rays import draw_centres
from variantgen.figure.motion.contact_letters import contact_points, draw_contacts
from variantgen.figure.motion.motion_board import NOTHING, MotionBoard, draw_on_mechanism, named_together, scale_of
from variantgen.figure.motion.motion_data import MotionData, MovingMechanism, motion_data
from variantgen.figure.motion.rope_arrows import RopeSpeed, draw_rope_speeds, rope_speeds
from variantgen.figure.motion.vectors import Vectors, vectors_of
from variantgen.figure.symbols.rotation import draw_arcs
from variantgen.mechanism.motion import Motion
from variantgen.methods.steps.point_vectors import PointVectors
from variantgen.methods.steps.step_geometry import NOTHING_MARKED, StepGeometry
from variantgen.variants.variant import Variant
from variantgen.wording.language import Language

ORDER = 1
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

    Raises InputError where nothing moves.
    """
    mechanism = MovingMechanism(variant, motion, index, asked, language)
    rims = contact_points(mechanism.task, mechanism.now, mechanism.shown) if motion.solved[index] else {}
    found = motion_data(mechanism, ORDER, points_move=not rims)
    named = vectors_of(mechanism, ORDER, vectors)
    ropes = rope_speeds(motion, index, asked)
    annotate = partial(_annotate, found, named, ropes, FigureSubject(mechanism, {}, geometry))
    return made(draw_on_mechanism(mechanism, annotate, true_scale))


def _annotate(
    found: MotionData,
    named: Vectors,
    ropes: Sequence[RopeSpeed],
    subject: FigureSubject,
    board: MotionBoard,
    stretch: float,
) -> None:
    """Velocities, then centres, then arcs where there is room left."""
    now = found.now
    # What another method than the vector equation needs of a velocity is the velocity itself.
    parts = {point: named.terms(point) for point in named.found.compound}
    points = named.telling([name for name in board.shown if name in found.chain.points])
    touching = contact_points(named.task, now, board.shown)
    shown = [*(now.v[name] for name in points), *(vector for terms in parts.values() for _, vector in terms)]
    shown += [*(contact.velocity for contact in touching.values()), *(rope.speed for rope in ropes)]
    scale = stretch * scale_of(shown)
    straight = set()
    for name in (*points, *named.slid_over()):
        vectors = named_together([named.own(name), *parts.get(name, [])], scale)
        for i, (symbol, vector) in enumerate(vectors):
            whole = i == 0 and abs(vector - now.v[name]) * scale < NOTHING
            if board.vector(name, scale * vector, symbol, *(() if whole else (MEDIUM,))) and whole:
                straight.add(name)
    draw_contacts(board, touching, scale, named.symbols)
    draw_rope_speeds(board, ropes, scale, named.symbols)
    draw_centres(board, now, points, straight)
    draw_geometry(board, subject, named.symbols, MOST_ANGLES if stretch == 1.0 else 0)
    fastest = max((abs(rate) for rate in now.omega.values()), default=0.0)
    for body, rate in now.omega.items():
        if abs(rate) > _NOTHING * fastest:
            draw_arcs(board, body, [(named.rate(body), rate)])
