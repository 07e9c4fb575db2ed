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
from variantgen.figure.plans import Vector, VectorPlan, draw_plan, scale_of_plan
from variantgen.figure.solved import solved
from variantgen.mechanism.motion import Motion
from variantgen.methods.graphical.vector_chain import Cylinder, SlidingPoint, Turn, VectorChain, taken_apart
from variantgen.methods.linkage.instant import Instant
from variantgen.methods.steps.step import PointVectors
from variantgen.variants.variant import Variant
from variantgen.wording.formula import Index, Symbol
from variantgen.wording.language import Language
from variantgen.wording.vector_names import (
    about,
    absolute,
    component_marks,
    compound,
    image,
    transport_image,
)

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
    found = solved(variant, motion, index, asked, ORDER)
    scale = scale_of_plan(found.chain, found.now, ORDER, found.unit)
    return draw_plan(acceleration_plan(found.chain, found.now, language), scale, language)


def acceleration_plan(chain: VectorChain, now: Instant, language: Language) -> VectorPlan:
    """What the plan shows, in m/s^2."""
    plan = VectorPlan(Symbol("pi"))
    for point in chain.points:
        plan.ends.append((image(point, primed=True), now.a[point]))
        plan.vectors.append(Vector(0j, now.a[point], absolute("a", point), whole=True))
    shown = taken_apart(chain)
    for turn in chain.turns:
        _add_turn(plan, chain, now, turn, component_marks(language) if (turn.body, turn.point) in shown else ())
    for slip in chain.slips:
        _add_slip(plan, chain, now, slip, language, (slip.body, slip.point) in shown)
    for reach in chain.reaches:
        _add_reach(plan, now, reach, language)
    for point, way in chain.guides.items():
        if any(turn.point == point for turn in chain.turns):
            plan.lines.append((now.a[point], way))
    return plan


def _add_turn(
    plan: VectorPlan, chain: VectorChain, now: Instant, turn: Turn, marks: Sequence[tuple[Index, ...]]
) -> None:
    """Normal and tangential component (if there are ``marks`` for them) from the end of the pole's acceleration."""
    fixed = turn.pole in chain.resting
    start, normal = now.a[turn.pole], now.normal(turn.point, turn.pole)
    parts = [absolute("a", turn.point, u) if fixed else about("a", turn.point, turn.pole, u) for u in marks]
    if parts:
        _add_pair(plan, start, normal, now.tangential(turn.point, turn.pole), parts)
    if chain.is_found(turn.point):
        plan.lines.append((now.a[turn.point], 1j * (now.z[turn.point] - now.z[turn.pole])))


def _add_pair(plan: VectorPlan, start: complex, first: complex, second: complex, names: Sequence[Symbol]) -> complex:
    """Two components one after the other; returns the end of the second."""
    middle, end = start + first, start + first + second
    plan.vectors += [Vector(start, middle, names[0]), Vector(middle, end, names[1])]
    return end


def _add_slip(
    plan: VectorPlan, chain: VectorChain, now: Instant, slip: SlidingPoint, language: Language, apart: bool
) -> None:
    """Transport (in its components if ``apart``), Coriolis and relative acceleration, one after the other."""
    point, body = slip.point, slip.body
    transport, coriolis = now.transport_acceleration(point, body), now.coriolis(point, body)
    plan.ends.append((transport_image(point, primed=True, language=language), transport))
    plan.vectors.append(Vector(0j, transport, compound("a", "tr", point, language), whole=True))
    if slip.pole is not None:
        arm = now.z[point] - now.z[slip.pole]
        fixed = slip.pole in chain.resting
        names = [
            compound("a", "tr", point, language, upper) if fixed else about("a", point, slip.pole, upper)
            for upper in component_marks(language)
        ]
        if apart:
            _add_pair(plan, now.a[slip.pole], -(now.omega[body] ** 2) * arm, 1j * now.epsilon[body] * arm, names)
        if not slip.carried:
            plan.lines.append((transport, 1j * arm))
    if slip.carried:
        plan.vectors.append(Vector(transport, transport + coriolis, compound("a", "cor", point, language)))
        _add_relative(plan, now, slip, transport + coriolis, language)
        plan.lines.append((now.a[point], slip.path.tangent(now.z)))
    else:
        end = _add_relative(plan, now, slip, transport, language)
        plan.vectors.append(Vector(end, end + coriolis, compound("a", "cor", point, language)))
        plan.lines.append((transport, slip.path.tangent(now.z)))


def _add_relative(plan: VectorPlan, now: Instant, slip: SlidingPoint, start: complex, language: Language) -> complex:
    """The relative acceleration, on a curved path in two components; returns its end."""
    point = slip.point
    relative = now.relative_acceleration(point, slip.body)
    bend = complex(slip.path.curvature(now.z))
    speed = abs(now.v[point] - now.transport_velocity(point, slip.body))
    if bend == 0:
        plan.vectors.append(Vector(start, start + relative, compound("a", "rel", point, language)))
        return start + relative
    normal = bend * speed**2
    names = [compound("a", "rel", point, language, upper) for upper in component_marks(language)]
    if slip.carried:
        return _add_pair(plan, start, normal, relative - normal, names)
    # The unknown vectors meet, so what is known comes last.
    return _add_pair(plan, start, relative - normal, normal, names[::-1])


def _add_reach(plan: VectorPlan, now: Instant, reach: Cylinder, language: Language) -> None:
    """The acceleration along a line that grows, and those of its rotation, one after the other."""
    place = now.a[reach.base]
    normal, tangential = component_marks(language)
    words: tuple[tuple[str, tuple[Index, ...]], ...] = (
        ("rel", ()), ("tr", normal), ("cor", ()), ("tr", tangential),
    )  # fmt: skip
    for step, (word, upper) in zip(now.growing_acceleration(reach.point, reach.base), words, strict=True):
        plan.vectors.append(Vector(place, place + step, compound("a", word, reach.point, language, upper)))
        place += step
    plan.lines.append((place, 1j * (now.z[reach.point] - now.z[reach.base])))
