"""The figure of accelerations: the mechanism with the accelerations of the chain and their components to one scale.

At a point B that is reached from the pole A: a_B, a_A moved there (thin), ``a^n_BA`` towards A and ``a^tau_BA`` across
AB; where B turns about a fixed point ``a^n_B`` and ``a^tau_B``; at a point that slides on a body the transport (as the
solution writes it), relative and Coriolis accelerations. Arcs show the true senses of the angular accelerations.
"""

from __future__ import annotations

from collections.abc import Collection, Sequence
from functools import partial

from variantgen.families.quantities import Quantity
from variantgen.figure.acceleration_centre import draw_acceleration_centres
from variantgen.figure.contact_letters import draw_dot
from variantgen.figure.cylinder_vectors import cylinder_accelerations
from variantgen.figure.drawing import BOLD, MEDIUM, THIN, Drawing
from variantgen.figure.given_vectors import distinct_points, given_rates, given_vectors, transport_name
from variantgen.figure.motion_board import LONGEST_OF_MANY, MotionBoard, draw_on_mechanism, named_together, scale_of
from variantgen.figure.motion_data import MotionData, motion_data
from variantgen.mechanism.motion import Motion
from variantgen.methods.graphical.vector_chain import SlidingPoint, Turn, taken_apart
from variantgen.methods.linkage.instant import Instant
from variantgen.variants.variant import Variant
from variantgen.wording.formula import Symbol
from variantgen.wording.language import Language
from variantgen.wording.vector_names import absolute, component_marks, compound_part, relative_to_pole

ORDER = 2
_NOTHING = 1e-9  # of the largest rate
Named = list[tuple[Symbol, complex]]


def draw(variant: Variant, motion: Motion, index: int, asked: Sequence[Quantity], language: Language) -> Drawing:
    """The figure of one variant. Raises InputError where accelerations are not asked or there are none."""
    # A point that is asked only for its velocity is no matter of this figure.
    sought = [quantity for quantity in asked if quantity.order == ORDER]
    found = motion_data(variant, motion, index, sought, ORDER)
    annotate = partial(_annotate, found, asked, language)
    return draw_on_mechanism(variant, motion, index, asked, language, annotate)


def _annotate(
    found: MotionData, asked: Sequence[Quantity], language: Language, board: MotionBoard, stretch: float
) -> None:
    """Accelerations with their components, an asked centre, then arcs where there is room left."""
    now = found.now
    # A point that is found by the ray to an acceleration centre has its acceleration whole.
    rays = {(q.target, q.component) for q in asked if q.kind == "Q"}
    parts = components(found, language, rays)
    for point, growing in cylinder_accelerations(board, found, language).items():
        parts[point] += growing
    scale = stretch * scale_of([vector for named in parts.values() for _, vector in named], LONGEST_OF_MANY)
    for point, named in parts.items():
        if point not in board.shown:
            draw_dot(board, board.sketch.at[point], point)
        whole = named[0][0]
        wholes = {others[0][0] for others in parts.values()} - {whole}
        for symbol, vector in named_together(named, scale):
            weight = BOLD if symbol == whole else THIN if symbol in wholes else MEDIUM
            board.vector(point, scale * vector, symbol, weight)
    draw_acceleration_centres(board, now, asked)
    rates = given_rates(found.task, ORDER, language)
    fastest = max((abs(rate) for rate in now.epsilon.values()), default=0.0)
    for body, rate in now.epsilon.items():
        if abs(rate) > _NOTHING * max(fastest, max(abs(omega) for omega in now.omega.values()) ** 2):
            board.turn(body, rate, "epsilon", rates.get(body))


def components(found: MotionData, language: Language, entire: Collection[tuple[str, str]] = ()) -> dict[str, Named]:
    """The acceleration of each point of the chain, first, and what it is put together from (m/s^2).

    ``entire`` are bodies and points of which the components are not wanted.
    """
    now, chain = found.now, found.chain
    stated = given_vectors(found.task, chain, ORDER, language)

    def whole(point: str) -> tuple[Symbol, complex]:
        return stated.get(point, absolute("a", point)), now.a[point]

    parts: dict[str, Named] = {point: [whole(point)] for point in distinct_points(found.task, chain, chain.points)}
    apart = taken_apart(chain)
    for turn in chain.turns:
        split = (turn.body, turn.point) in apart and (turn.body, turn.point) not in entire
        if split and turn.point in parts and turn.body not in found.task.translating:
            fixed = turn.pole in chain.resting
            parts[turn.point] += [] if fixed else [whole(turn.pole)]
            parts[turn.point] += _turn_parts(now, turn, fixed, language)
    for sliding_point in chain.sliding_points:
        named = parts.setdefault(sliding_point.point, [])
        leading_point = transport_name(found.task, chain, sliding_point, "a", stated)
        if leading_point is not None or sliding_point.pole is None:
            transport = now.transport_acceleration(sliding_point.point, sliding_point.body)
            named.append((leading_point or compound_part("a", "tr", sliding_point.point, language), transport))
        else:
            fixed = sliding_point.pole in chain.resting
            named += [] if fixed else [whole(sliding_point.pole)]
            named += _transport_parts(now, sliding_point, sliding_point.pole, fixed, language)
        named += _sliding_parts(now, sliding_point, language)
    return parts


def _turn_parts(now: Instant, turn: Turn, fixed: bool, language: Language) -> Named:
    """Normal and tangential component of the rotation about the pole."""
    point, pole = turn.point, turn.pole
    names = [
        absolute("a", point, upper) if fixed else relative_to_pole("a", point, pole, upper)
        for upper in component_marks(language)
    ]
    return list(zip(names, (now.normal(point, pole), now.tangential(point, pole)), strict=True))


def _transport_parts(now: Instant, sliding_point: SlidingPoint, pole: str, fixed: bool, language: Language) -> Named:
    """Normal and tangential component of the rotation about the pole, of the point of the carrier below a sliding one.

    They are parts of the transport acceleration where the pole is fixed.
    """
    point, arm = sliding_point.point, now.z[sliding_point.point] - now.z[pole]
    names = [
        compound_part("a", "tr", point, language, upper) if fixed else relative_to_pole("a", point, pole, upper)
        for upper in component_marks(language)
    ]
    return list(
        zip(
            names,
            (-(now.omega[sliding_point.body] ** 2) * arm, 1j * now.epsilon[sliding_point.body] * arm),
            strict=True,
        )
    )


def _sliding_parts(now: Instant, sliding_point: SlidingPoint, language: Language) -> Named:
    """Relative and Coriolis acceleration; on a curved path the components of the relative one."""
    point, body = sliding_point.point, sliding_point.body
    relative = now.relative_acceleration(point, body)
    coriolis = compound_part("a", "cor", point, language), now.coriolis(point, body)
    if sliding_point.path.line is not None:
        return [(compound_part("a", "rel", point, language), relative), coriolis]
    arm = now.z[point] - now.z[sliding_point.path.centre]
    normal = (relative / arm).real * arm
    names = [compound_part("a", "rel", point, language, upper) for upper in component_marks(language)]
    return [*zip(names, (normal, relative - normal), strict=True), coriolis]
