"""What figures of solved motion start from: the chain of the solution and the numbers of one variant, checked."""

from __future__ import annotations

from collections.abc import Sequence
from functools import cached_property

from msgspec import Struct
from msgspec.structs import replace

from variantgen.errors import InputError, Problem
from variantgen.families.parameters.units import Unit, unit
from variantgen.families.quantities import Quantity
from variantgen.figure.build import Mechanism
from variantgen.mechanism.outcome import Outcome
from variantgen.mechanism.scene import Scene
from variantgen.methods.graphical.vector_chain import VectorChain, chain_of
from variantgen.methods.linkage.instant import Instant, instant
from variantgen.methods.linkage.problem import Task, task_of
from variantgen.variants.printed_data import shown_points

_NOTHING = 1e-9  # of the largest vector


class MovingMechanism(Mechanism, frozen=True, dict=True):
    """A mechanism with the numbers of its motion: what all figures of its solution have in common."""

    @cached_property
    def now(self) -> Instant:
        """The numbers of its motion (SI)."""
        return instant(self.motion, self.index)

    @cached_property
    def scene(self) -> Scene:
        """The numbers of the variant, of which ``now`` has more."""
        return replace(self.now.scene, points={}, conditions=())

    @cached_property
    def task(self) -> Task:
        """The problem that its solution answers."""
        return task_of(self.variant, self.motion, self.index, self.asked)

    @cached_property
    def chain(self) -> VectorChain:
        """The chain that leads to all that is asked."""
        return chain_of(self.variant.form, self.now, self.asked, self.shown)


class MotionData(Struct, frozen=True):
    """One variant with its chain, its numbers and the unit of its vectors."""

    chain: VectorChain
    now: Instant
    unit: Unit


def motion_data(
    mechanism: MovingMechanism, order: int, asked: Sequence[Quantity] | None = None, points_move: bool = True
) -> MotionData:
    """The chain and the numbers for a figure of velocities (``order`` 1) or accelerations (2).

    The chain leads to what is ``asked`` (none: all that is asked of the mechanism). Raises InputError where the variant
    has no motion, accelerations are not asked, or no point has any while the figure is one of points (``points_move``).
    """
    variant, motion = mechanism.variant, mechanism.motion
    sought, name = mechanism.asked if asked is None else asked, variant.family.name
    if not motion.solved[mechanism.index]:
        text = Outcome(int(motion.outcome[mechanism.index])).text
        raise InputError(Problem(f"there is no motion to draw: {text}", key="view", value=name))
    if order == 2 and not any(quantity.order == 2 for quantity in sought):
        raise InputError(
            Problem(
                "there are no accelerations to draw: none are asked, so the data for them are not given",
                key="view",
                value=name,
                remedy="ask for an acceleration as well, such as a_B or epsilon_AB",
            )
        )
    now = mechanism.now
    chain = mechanism.chain if asked is None else chain_of(variant.form, now, asked, shown_points(variant, asked))
    vectors = now.v if order == 1 else now.a
    sizes = [abs(vectors[point]) for point in chain.points]
    largest = max((abs(vector) for vector in vectors.values()), default=0.0)
    if points_move and max(sizes, default=0.0) <= _NOTHING * largest:
        kind = "velocity" if order == 1 else "acceleration"
        raise InputError(Problem(f"no shown point has a {kind}", key="view", value=name))
    measure = unit(variant.family.length_unit + ("/s" if order == 1 else "/s^2"))
    return MotionData(chain, now, measure)
