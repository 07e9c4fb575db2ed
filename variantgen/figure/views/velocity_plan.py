"""The velocity plan: rays from a pole to the ends of the velocities, between them the velocities about the poles.

For ``v_B = v_A + v_BA`` the ray o-a is v_A, o-b is v_B and the side a-b is v_BA, perpendicular to AB. The points of a
rigid body make a figure similar to the body, turned by a right angle. Where a point slides on a body, the velocity of
the point of that body below it has a letter of its own, and the side from there is the relative velocity.
"""

from __future__ import annotations

from collections.abc import Sequence
from itertools import combinations

from variantgen.families.quantities import Quantity
from variantgen.figure.drawing import Drawing
from variantgen.figure.plans import Vector, VectorPlan, draw_plan, scale_of_plan
from variantgen.figure.solved import solved
from variantgen.mechanism.motion import Motion
from variantgen.methods.graphical.plan_scale import pole_letter
from variantgen.methods.graphical.vector_chain import Cylinder, SlidingPoint, Turn, VectorChain
from variantgen.methods.linkage.instant import Instant
from variantgen.methods.steps.step import PointVectors
from variantgen.variants.variant import Variant
from variantgen.wording.formula import Symbol
from variantgen.wording.language import Language
from variantgen.wording.vector_names import about, absolute, compound, image, transport_image

ORDER = 1
_AT_REST = 1e-9  # of the largest velocity


def draw(
    variant: Variant,
    motion: Motion,
    index: int,
    asked: Sequence[Quantity],
    language: Language,
    vectors: Sequence[PointVectors] = (),
) -> Drawing:
    """The plan of one variant. Raises InputError where nothing moves."""
    found = solved(variant, motion, index, asked, ORDER)
    scale = scale_of_plan(found.chain, found.now, ORDER, found.unit)
    return draw_plan(velocity_plan(found.chain, found.now, language), scale, language)


def velocity_plan(chain: VectorChain, now: Instant, language: Language) -> VectorPlan:
    """What the plan shows, in m/s."""
    largest = max(abs(now.v[point]) for point in chain.points)
    moving = [point for point in chain.points if abs(now.v[point]) > _AT_REST * largest]
    plan = VectorPlan(Symbol(pole_letter(moving)))
    for point in chain.points:
        plan.ends.append((image(point, primed=False), now.v[point]))
        plan.vectors.append(Vector(0j, now.v[point], absolute("v", point), whole=True))
    for turn in chain.turns:
        if turn.point in moving:
            _add_turn(plan, chain, now, turn)
    for slip in chain.slips:
        _add_slip(plan, chain, now, slip, language)
    for reach in chain.reaches:
        _add_reach(plan, now, reach, language)
    for point, way in chain.guides.items():
        if chain.is_found(point):
            plan.lines.append((now.v[point], way))
    for body in now.scene.bodies:
        members = chain.members(body)[1:]
        plan.edges += [(now.v[p], now.v[q]) for p, q in combinations(members, 2) if _are_apart(now, body, p, q)]
    return plan


def _add_turn(plan: VectorPlan, chain: VectorChain, now: Instant, turn: Turn) -> None:
    """The side between two ends; the line of its direction, where the point is found by two of them."""
    if turn.pole not in chain.resting:
        symbol = about("v", turn.point, turn.pole)
        plan.vectors.append(Vector(now.v[turn.pole], now.v[turn.point], symbol))
    if chain.is_found(turn.point):
        plan.lines.append((now.v[turn.point], 1j * (now.z[turn.point] - now.z[turn.pole])))


def _add_slip(plan: VectorPlan, chain: VectorChain, now: Instant, slip: SlidingPoint, language: Language) -> None:
    """Transport velocity, and from its end the relative velocity."""
    transport = now.transport_velocity(slip.point, slip.body)
    plan.ends.append((transport_image(slip.point, primed=False, language=language), transport))
    plan.vectors.append(Vector(0j, transport, compound("v", "tr", slip.point, language), whole=True))
    if slip.pole is not None and slip.pole not in chain.resting:
        plan.vectors.append(Vector(now.v[slip.pole], transport, about("v", slip.point, slip.pole)))
    plan.vectors.append(Vector(transport, now.v[slip.point], compound("v", "rel", slip.point, language)))
    # The end that is found by two directions: that of the point or, if it is known, that of the carrier's point.
    end = now.v[slip.point] if slip.carried else transport
    plan.lines.append((end, slip.path.tangent(now.z)))
    if not slip.carried and slip.pole is not None:
        plan.lines.append((end, 1j * (now.z[slip.point] - now.z[slip.pole])))


def _add_reach(plan: VectorPlan, now: Instant, reach: Cylinder, language: Language) -> None:
    """The velocity along a line that grows, and across it."""
    point, start = reach.point, now.v[reach.base]
    along, across = now.growth(point, reach.base)
    plan.vectors.append(Vector(start, start + along, compound("v", "rel", point, language)))
    plan.vectors.append(Vector(start + along, start + along + across, compound("v", "tr", point, language)))
    plan.lines.append((now.v[point], 1j * (now.z[point] - now.z[reach.base])))


def _are_apart(now: Instant, body: str, first: str, second: str) -> bool:
    """Whether two points and the pole of their body are corners of a triangle."""
    pole = now.scene.bodies[body][0]
    arms = [now.z[p] - now.z[pole] for p in (first, second)]
    return abs((arms[0].conjugate() * arms[1]).imag) > 0.05 * abs(arms[0]) * abs(arms[1])
