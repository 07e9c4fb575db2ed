"""A plan of vectors by the equations of a solution: rays to the ends of vectors of points, sides laid end to end."""

from __future__ import annotations

from collections.abc import Sequence

from variantgen.algebra.name import Name
from variantgen.figure.motion.plans import PlanVector, VectorPlan
from variantgen.figure.motion.vectors import Vectors
from variantgen.methods.steps.point_vectors import Arrow, PointEquation
from variantgen.wording.formula import Symbol


def solution_plan(named: Vectors, letter: str, pole: Symbol, points: Sequence[str]) -> VectorPlan:
    """The plan of velocities (``letter`` v) or accelerations (a) with rays to the ends of vectors of the ``points``."""
    plan = VectorPlan(pole)
    for point in points:
        vector = named.found.own[point].vector
        plan.ends.append((named.symbols.letter(Name("image", point, body=letter)), vector))
        plan.vectors.append(PlanVector(0j, vector, named.symbols.letter(Name(letter, point)), whole=True))
    for equation in named.found.equations:
        sides = [_laid(side) for side in (equation.left, equation.right)]
        many = sum(arrow.sought for side in sides for arrow in side) == 2
        _add_transport(plan, named, letter, equation)
        for side in sides[::-1]:
            _add_side(plan, named, equation, side, many)
    return plan


def _laid(side: Sequence[Arrow]) -> list[Arrow]:
    """The vectors of a side as they are laid off: two that are sought meet, what is known follows."""
    first = next((i for i, arrow in enumerate(side) if arrow.sought), len(side))
    rest = side[first:]
    known = [arrow for arrow in rest if not arrow.sought]
    return [*side[:first], *(arrow for arrow in rest if arrow.sought), *reversed(known)]


def _add_side(plan: VectorPlan, named: Vectors, equation: PointEquation, side: Sequence[Arrow], crossing: bool) -> None:
    """The vectors of a side one after the other; lines of the directions of sought ones that cross."""
    place, meeting = 0j, None
    whole = {arrow.name for arrow in named.found.own.values()}
    for arrow in side:
        end = place + arrow.vector
        symbol = named.symbols.letter(arrow.name)
        # The vectors of points are rays; what two equations have in common is drawn once.
        if arrow.name not in whole and all(symbol != vector.symbol for vector in plan.vectors):
            plan.vectors.append(PlanVector(place, end, symbol))
        place = end
        if arrow.sought and meeting is None:
            meeting = end
    if crossing and meeting is not None:
        plan.lines += [(meeting, arrow.way) for arrow in side if arrow.sought]


def _add_transport(plan: VectorPlan, named: Vectors, letter: str, equation: PointEquation) -> None:
    """The point of a turning carrier below a sliding point: its image where it is sought, its ray where it has one.

    About a fixed axis the components of a transport acceleration stand for it.
    """
    side, point = equation.right, equation.point
    before = [arrow.name.of != point and arrow.name.kind == letter for arrow in side].count(True)
    turning = [arrow for arrow in side[before:] if arrow.name.about or "tr" in arrow.name.part.split()]
    if point not in named.found.compound or not turning or side[before] not in turning:
        return
    end = sum((arrow.vector for arrow in (*side[:before], *turning)), 0j)
    if any(arrow.sought for arrow in turning):
        plan.ends.append((named.symbols.letter(Name("image", point, part="tr", body=letter)), end))
    if before or len(turning) == 1:
        plan.vectors.append(PlanVector(0j, end, named.symbols.letter(Name(letter, point, part="tr")), whole=True))
