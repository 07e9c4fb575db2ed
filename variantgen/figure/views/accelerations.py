"""The figure of accelerations: the mechanism with the accelerations of the chain and their components to one scale.

At a point B that is reached from the pole A: a_B, a_A moved there (thin), ``a^n_BA`` towards A and ``a^tau_BA`` across
AB; where B turns about a fixed point ``a^n_B`` and ``a^tau_B``; at a point that slides on a body the transport,
relative and Coriolis accelerations. Arcs show the true senses of the angular accelerations.
"""

from __future__ import annotations

from collections.abc import Collection, Sequence
from functools import partial

from variantgen.families.quantities import Quantity
from variantgen.figure.acceleration_centre import draw_acceleration_centres
from variantgen.figure.drawing import BOLD, MEDIUM, THIN, Drawing
from variantgen.figure.growing import growing_accelerations
from variantgen.figure.motion_board import LONGEST_OF_MANY, MotionBoard, draw_on_mechanism, named_together, scale_of
from variantgen.figure.solved import Solved, solved
from variantgen.mechanism.motion import Motion
from variantgen.methods.chain import Slip, Turn, taken_apart
from variantgen.methods.instant import Instant
from variantgen.variants.variant import Variant
from variantgen.wording.formula import Symbol
from variantgen.wording.language import Language
from variantgen.wording.vector_names import about, absolute, component_marks, compound

ORDER = 2
_NOTHING = 1e-9  # of the largest rate
Named = list[tuple[Symbol, complex]]


def draw(variant: Variant, motion: Motion, index: int, asked: Sequence[Quantity], language: Language) -> Drawing:
    """The figure of one variant. Raises InputError where accelerations are not asked or there are none."""
    found = solved(variant, motion, index, asked, ORDER)
    annotate = partial(_annotate, found, asked, language)
    return draw_on_mechanism(variant, motion, index, asked, language, annotate)


def _annotate(found: Solved, asked: Sequence[Quantity], language: Language, board: MotionBoard, stretch: float) -> None:
    """Accelerations with their components, an asked centre, then arcs where there is room left."""
    now = found.now
    # A point that is found by the ray to an acceleration centre has its acceleration whole.
    rays = {(q.target, q.component) for q in asked if q.kind == "Q"}
    parts = components(found, language, rays)
    for point, growing in growing_accelerations(board, found, language).items():
        parts[point] += growing
    scale = stretch * scale_of([vector for named in parts.values() for _, vector in named], LONGEST_OF_MANY)
    for point, named in parts.items():
        for symbol, vector in named_together(named, scale):
            poles = {absolute("a", turn.pole) for turn in found.chain.turns if turn.point == point}
            weight = BOLD if symbol == absolute("a", point) else THIN if symbol in poles else MEDIUM
            board.vector(point, scale * vector, symbol, weight)
    draw_acceleration_centres(board, now, asked)
    fastest = max((abs(rate) for rate in now.epsilon.values()), default=0.0)
    for body, rate in now.epsilon.items():
        if abs(rate) > _NOTHING * max(fastest, max(abs(omega) for omega in now.omega.values()) ** 2):
            board.turn(body, rate, "epsilon")


def components(found: Solved, language: Language, whole: Collection[tuple[str, str]] = ()) -> dict[str, Named]:
    """The acceleration of each point of the chain and what it is put together from (m/s^2).

    ``whole`` are bodies and points of which the components are not wanted.
    """
    now, chain = found.now, found.chain
    parts: dict[str, Named] = {point: [(absolute("a", point), now.a[point])] for point in chain.points}
    apart = taken_apart(chain)
    for turn in chain.turns:
        if (turn.body, turn.point) in apart and (turn.body, turn.point) not in whole:
            parts[turn.point] += _turn_parts(now, turn, turn.pole in chain.resting, language)
    for slip in chain.slips:
        parts.setdefault(slip.point, []).extend(_slip_parts(now, slip, language))
    return parts


def _turn_parts(now: Instant, turn: Turn, fixed: bool, language: Language) -> Named:
    """The acceleration of the pole, normal and tangential component."""
    point, pole = turn.point, turn.pole
    names = [
        absolute("a", point, upper) if fixed else about("a", point, pole, upper) for upper in component_marks(language)
    ]
    vectors = now.normal(point, pole), now.tangential(point, pole)
    own = list(zip(names, vectors, strict=True))
    return own if fixed else [(absolute("a", pole), now.a[pole]), *own]


def _slip_parts(now: Instant, slip: Slip, language: Language) -> Named:
    """Transport, relative and Coriolis acceleration."""
    point, body = slip.point, slip.body
    vectors = {
        "tr": now.transport_acceleration(point, body),
        "rel": now.relative_acceleration(point, body),
        "cor": now.coriolis(point, body),
    }
    return [(compound("a", word, point, language), vector) for word, vector in vectors.items()]
