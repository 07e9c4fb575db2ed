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
from variantgen.figure.motion_data import motion_data
from variantgen.figure.plans import PlanVector, VectorPlan, draw_plan, scale_of_plan
from variantgen.mechanism.motion import Motion
from variantgen.methods.graphical.vector_chain import Cylinder, SlidingPoint, Turn, VectorChain, taken_apart
from variantgen.methods.linkage.instant import Instant
from variantgen.variants.variant import Variant
from variantgen.wording.formula import Index, Symbol
from variantgen.wording.language import Language
from variantgen.wording.vector_names import (
    absolute,
    component_marks,
    compound_part,
    image,
    relative_to_pole,
    transport_image,
)

ORDER = 2


def draw(variant: Variant, motion: Motion, index: int, asked: Sequence[Quantity], language: Language) -> Drawing:
    """The plan of one variant. Raises InputError where accelerations are not asked or there are none."""
    found = motion_data(variant, motion, index, asked, ORDER)
    scale = scale_of_plan(found.chain, found.now, ORDER, found.unit)
    return draw_plan(acceleration_plan(found.chain, found.now, language), scale, language)


def acceleration_plan(chain: VectorChain, now: Instant, language: Language) -> VectorPlan:
    """What the plan shows, in m/s^2."""
    plan = VectorPlan(Symbol("pi"))
    for point in chain.points:
        plan.ends.append((image(point, primed=True), now.a[point]))
        plan.vectors.append(PlanVector(0j, now.a[point], absolute("a", point), whole=True))
    shown = taken_apart(chain)
    for turn in chain.turns:
        _add_turn(plan, chain, now, turn, component_marks(language) if (turn.body, turn.point) in shown else ())
    for sliding_point in chain.sliding_points:
        _add_sliding_point(
            plan, chain, now, sliding_point, language, (sliding_point.body, sliding_point.point) in shown
        )
    for cylinder in chain.cylinders:
        _add_cylinder(plan, now, cylinder, language)
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
    parts = [absolute("a", turn.point, u) if fixed else relative_to_pole("a", turn.point, turn.pole, u) for u in marks]
    if parts:
        _add_pair(plan, start, normal, now.tangential(turn.point, turn.pole), parts)
    if chain.is_found(turn.point):
        plan.lines.append((now.a[turn.point], 1j * (now.z[turn.point] - now.z[turn.pole])))


def _add_pair(plan: VectorPlan, start: complex, first: complex, second: complex, names: Sequence[Symbol]) -> complex:
    """Two components one after the other; returns the end of the second."""
    middle, end = start + first, start + first + second
    plan.vectors += [PlanVector(start, middle, names[0]), PlanVector(middle, end, names[1])]
    return end


def _add_sliding_point(
    plan: VectorPlan, chain: VectorChain, now: Instant, sliding_point: SlidingPoint, language: Language, apart: bool
) -> None:
    """Transport (in its components if ``apart``), Coriolis and relative acceleration, one after the other."""
    point, body = sliding_point.point, sliding_point.body
    transport, coriolis = now.transport_acceleration(point, body), now.coriolis(point, body)
    plan.ends.append((transport_image(point, primed=True, language=language), transport))
    plan.vectors.append(PlanVector(0j, transport, compound_part("a", "tr", point, language), whole=True))
    if sliding_point.pole is not None:
        arm = now.z[point] - now.z[sliding_point.pole]
        fixed = sliding_point.pole in chain.resting
        names = [
            compound_part("a", "tr", point, language, upper)
            if fixed
            else relative_to_pole("a", point, sliding_point.pole, upper)
            for upper in component_marks(language)
        ]
        if apart:
            _add_pair(
                plan, now.a[sliding_point.pole], -(now.omega[body] ** 2) * arm, 1j * now.epsilon[body] * arm, names
            )
        if not sliding_point.carried:
            plan.lines.append((transport, 1j * arm))
    if sliding_point.carried:
        plan.vectors.append(PlanVector(transport, transport + coriolis, compound_part("a", "cor", point, language)))
        _add_relative(plan, now, sliding_point, transport + coriolis, language)
        plan.lines.append((now.a[point], sliding_point.path.tangent(now.z)))
    else:
        end = _add_relative(plan, now, sliding_point, transport, language)
        plan.vectors.append(PlanVector(end, end + coriolis, compound_part("a", "cor", point, language)))
        plan.lines.append((transport, sliding_point.path.tangent(now.z)))


def _add_relative(
    plan: VectorPlan, now: Instant, sliding_point: SlidingPoint, start: complex, language: Language
) -> complex:
    """The relative acceleration, on a curved path in two components; returns its end."""
    point = sliding_point.point
    relative = now.relative_acceleration(point, sliding_point.body)
    bend = complex(sliding_point.path.curvature(now.z))
    speed = abs(now.v[point] - now.transport_velocity(point, sliding_point.body))
    if bend == 0:
        plan.vectors.append(PlanVector(start, start + relative, compound_part("a", "rel", point, language)))
        return start + relative
    normal = bend * speed**2
    names = [compound_part("a", "rel", point, language, upper) for upper in component_marks(language)]
    if sliding_point.carried:
        return _add_pair(plan, start, normal, relative - normal, names)
    # The unknown vectors meet, so what is known comes last.
    return _add_pair(plan, start, relative - normal, normal, names[::-1])


def _add_cylinder(plan: VectorPlan, now: Instant, cylinder: Cylinder, language: Language) -> None:
    """The acceleration along a line that grows, and those of its rotation, one after the other."""
    place = now.a[cylinder.base]
    normal, tangential = component_marks(language)
    words: tuple[tuple[str, tuple[Index, ...]], ...] = (
        ("rel", ()), ("tr", normal), ("cor", ()), ("tr", tangential),
    )  # fmt: skip
    for step, (word, upper) in zip(now.growing_acceleration(cylinder.point, cylinder.base), words, strict=True):
        plan.vectors.append(PlanVector(place, place + step, compound_part("a", word, cylinder.point, language, upper)))
        place += step
    plan.lines.append((place, 1j * (now.z[cylinder.point] - now.z[cylinder.base])))
