"""What figures of solved motion start from: the chain of the solution and the numbers of one variant, checked."""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import dataclass

from variantgen.errors import InputError, Problem
from variantgen.families.parameters.units import Unit, unit
from variantgen.families.quantities import Quantity
from variantgen.mechanism.motion import Motion
from variantgen.mechanism.outcome import Outcome
from variantgen.methods.graphical.vector_chain import VectorChain, chain_of
from variantgen.methods.linkage.instant import Instant, instant
from variantgen.methods.linkage.problem import Task, task_of
from variantgen.variants.printed_data import shown_points
from variantgen.variants.variant import Variant

_NOTHING = 1e-9  # of the largest vector


@dataclass(frozen=True)
class MotionData:
    """One variant with its chain, its numbers, the unit of its vectors, and the task of its solution."""

    chain: VectorChain
    now: Instant
    unit: Unit
    task: Task


def motion_data(variant: Variant, motion: Motion, index: int, asked: Sequence[Quantity], order: int) -> MotionData:
    """The chain and the numbers for a figure of velocities (``order`` 1) or accelerations (2).

    Raises InputError where the variant has no motion, accelerations are not asked, or nothing moves.
    """
    name = variant.family.name
    if not motion.solved[index]:
        text = Outcome(int(motion.outcome[index])).text
        raise InputError(Problem(f"there is no motion to draw: {text}", key="view", value=name))
    if order == 2 and not any(quantity.order == 2 for quantity in asked):
        raise InputError(
            Problem(
                "there are no accelerations to draw: none are asked, so the data for them are not given",
                key="view",
                value=name,
                remedy="ask for an acceleration as well, such as a_B or epsilon_AB",
            )
        )
    now = instant(motion, index)
    chain = chain_of(variant.form, now, asked, shown_points(variant, asked))
    vectors = now.v if order == 1 else now.a
    sizes = [abs(vectors[point]) for point in chain.points]
    if max(sizes, default=0.0) <= _NOTHING * max((abs(vector) for vector in vectors.values()), default=0.0):
        kind = "velocity" if order == 1 else "acceleration"
        raise InputError(Problem(f"no shown point has a {kind}", key="view", value=name))
    measure = unit(variant.family.length_unit + ("/s" if order == 1 else "/s^2"))
    return MotionData(chain, now, measure, task_of(variant, motion, index, asked))
