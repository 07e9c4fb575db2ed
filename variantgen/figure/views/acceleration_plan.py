"""The acceleration plan: rays from a pole to the ends of the accelerations, between them their components in chains.

For ``a_B = a_A + a^n_BA + a^tau_BA`` the normal component starts at the end of a_A and the tangential one leads from
there to the end of a_B; where B turns about a fixed point as well, ``a^n_B + a^tau_B`` leads there from the pole. For a
point that slides on a body ``a = a_tr + a_cor + a_rel``; where the motion of the body is what is sought, the known
Coriolis acceleration comes last, so that the two unknown vectors meet.
"""

from __future__ import annotations

from collections.abc import Sequence

from variantgen.families.quantities import Quantity
from variantgen.figure.drawing import Drawing
from variantgen.figure.motion.motion_data import MotionData, MovingMechanism, motion_data
from variantgen.figure.motion.plans import VectorPlan, draw_plan, scale_of_plan
from variantgen.figure.motion.solution_plan import solution_plan
from variantgen.figure.motion.vectors import Vectors, vectors_of
from variantgen.mechanism.motion import Motion
from variantgen.methods.steps.point_vectors import PointVectors
from variantgen.variants.variant import Variant
from variantgen.wording.formula import Symbol
from variantgen.wording.language import Language

ORDER = 2


def draw(
    variant: Variant,
    motion: Motion,
    index: int,
    asked: Sequence[Quantity],
    language: Language,
    vectors: Sequence[PointVectors] = (),
) -> Drawing:
    """The plan of one variant. Raises InputError where accelerations are not asked or there are none."""
    mechanism = MovingMechanism(variant, motion, index, asked, language)
    found = motion_data(mechanism, ORDER)
    named = vectors_of(mechanism, ORDER, vectors, ("graphical",))
    return draw_plan(
        acceleration_plan(found, named), scale_of_plan(found.chain, found.now, ORDER, found.unit), language
    )


def acceleration_plan(found: MotionData, named: Vectors) -> VectorPlan:
    """What the plan shows, in m/s^2."""
    return solution_plan(named, "a", Symbol("pi"), found.chain.points)
