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
from variantgen.figure.motion.motion_data import MotionData, MovingMechanism, motion_data
from variantgen.figure.motion.plans import VectorPlan, draw_plan, scale_of_plan
from variantgen.figure.motion.solution_plan import solution_plan
from variantgen.figure.motion.vectors import Vectors, vectors_of
from variantgen.mechanism.motion import Motion
from variantgen.methods.graphical.plan_scale import pole_letter
from variantgen.methods.linkage.instant import Instant
from variantgen.methods.steps.point_vectors import PointVectors
from variantgen.variants.variant import Variant
from variantgen.wording.formula import Symbol
from variantgen.wording.language import Language

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
    mechanism = MovingMechanism(variant, motion, index, asked, language)
    found = motion_data(mechanism, ORDER)
    named = vectors_of(mechanism, ORDER, vectors, ("graphical",))
    return draw_plan(velocity_plan(found, named), scale_of_plan(found.chain, found.now, ORDER, found.unit), language)


def velocity_plan(found: MotionData, named: Vectors) -> VectorPlan:
    """What the plan shows, in m/s."""
    chain, now = found.chain, found.now
    largest = max(abs(now.v[point]) for point in chain.points)
    moving = [point for point in chain.points if abs(now.v[point]) > _AT_REST * largest]
    plan = solution_plan(named, "v", Symbol(pole_letter(moving)), chain.points)
    for body in now.scene.bodies:
        members = chain.members(body)[1:]
        plan.edges += [(now.v[p], now.v[q]) for p, q in combinations(members, 2) if _are_apart(now, body, p, q)]
    return plan


def _are_apart(now: Instant, body: str, first: str, second: str) -> bool:
    """Whether two points and the pole of their body are corners of a triangle."""
    pole = now.scene.bodies[body][0]
    arms = [now.z[p] - now.z[pole] for p in (first, second)]
    return abs((arms[0].conjugate() * arms[1]).imag) > 0.05 * abs(arms[0]) * abs(arms[1])
