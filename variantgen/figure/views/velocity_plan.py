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
from variantgen.figure.motion_data import motion_data
from variantgen.figure.plans import PlanVector, VectorPlan, draw_plan, scale_of_plan
from variantgen.mechanism.motion import Motion
from variantgen.methods.graphical.plan_scale import pole_letter
from variantgen.methods.graphical.vector_chain import Cylinder, SlidingPoint, Turn, VectorChain
from variantgen.methods.linkage.instant import Instant
from variantgen.variants.variant import Variant
from variantgen.wording.formula import Symbol
from variantgen.wording.language import Language
from variantgen.wording.vector_names import absolute, compound_part, image, relative_to_pole, transport_image

ORDER = 1
_AT_REST = 1e-9  # of the largest velocity


def draw(variant: Variant, motion: Motion, index: int, asked: Sequence[Quantity], language: Language) -> Drawing:
    """The plan of one variant. Raises InputError where nothing moves."""
    found = motion_data(variant, motion, index, asked, ORDER)
    scale = scale_of_plan(found.chain, found.now, ORDER, found.unit)
    return draw_plan(velocity_plan(found.chain, found.now, language), scale, language)


def velocity_plan(chain: VectorChain, now: Instant, language: Language) -> VectorPlan:
    """What the plan shows, in m/s."""
    largest = max(abs(now.v[point]) for point in chain.points)
    moving = [point for point in chain.points if abs(now.v[point]) > _AT_REST * largest]
    plan = VectorPlan(Symbol(pole_letter(moving)))
    for point in chain.points:
        plan.ends.append((image(point, primed=False), now.v[point]))
        plan.vectors.append(PlanVector(0j, now.v[point], absolute("v", point), whole=True))
    for turn in chain.turns:
        if turn.point in moving:
            _add_turn(plan, chain, now, turn)
    for sliding_point in chain.sliding_points:
        _add_sliding_point(plan, chain, now, sliding_point, language)
    for cylinder in chain.cylinders:
        _add_cylinder(plan, now, cylinder, language)
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
        symbol = relative_to_pole("v", turn.point, turn.pole)
        plan.vectors.append(PlanVector(now.v[turn.pole], now.v[turn.point], symbol))
    if chain.is_found(turn.point):
        plan.lines.append((now.v[turn.point], 1j * (now.z[turn.point] - now.z[turn.pole])))


def _add_sliding_point(
    plan: VectorPlan, chain: VectorChain, now: Instant, sliding_point: SlidingPoint, language: Language
) -> None:
    """Transport velocity, and from its end the relative velocity."""
    transport = now.transport_velocity(sliding_point.point, sliding_point.body)
    plan.ends.append((transport_image(sliding_point.point, primed=False, language=language), transport))
    plan.vectors.append(PlanVector(0j, transport, compound_part("v", "tr", sliding_point.point, language), whole=True))
    if sliding_point.pole is not None and sliding_point.pole not in chain.resting:
        plan.vectors.append(
            PlanVector(
                now.v[sliding_point.pole], transport, relative_to_pole("v", sliding_point.point, sliding_point.pole)
            )
        )
    plan.vectors.append(
        PlanVector(transport, now.v[sliding_point.point], compound_part("v", "rel", sliding_point.point, language))
    )
    # The end that is found by two directions: that of the point or, if it is known, that of the carrier's point.
    end = now.v[sliding_point.point] if sliding_point.carried else transport
    plan.lines.append((end, sliding_point.path.tangent(now.z)))
    if not sliding_point.carried and sliding_point.pole is not None:
        plan.lines.append((end, 1j * (now.z[sliding_point.point] - now.z[sliding_point.pole])))


def _add_cylinder(plan: VectorPlan, now: Instant, cylinder: Cylinder, language: Language) -> None:
    """The velocity along a line that grows, and across it."""
    point, start = cylinder.point, now.v[cylinder.base]
    along, across = now.growth(point, cylinder.base)
    plan.vectors.append(PlanVector(start, start + along, compound_part("v", "rel", point, language)))
    plan.vectors.append(PlanVector(start + along, start + along + across, compound_part("v", "tr", point, language)))
    plan.lines.append((now.v[point], 1j * (now.z[point] - now.z[cylinder.base])))


def _are_apart(now: Instant, body: str, first: str, second: str) -> bool:
    """Whether two points and the pole of their body are corners of a triangle."""
    pole = now.scene.bodies[body][0]
    arms = [now.z[p] - now.z[pole] for p in (first, second)]
    return abs((arms[0].conjugate() * arms[1]).imag) > 0.05 * abs(arms[0]) * abs(arms[1])
