"""How a wrong number may have come about: what the answer would be by each mistake, and which of them fits best.

A mistake is recognised where its result is as near to the number as the tolerance of the answer allows; of several the
nearest is told, of equally near ones the first in the order of the rules. It is a suspicion and nothing more: it may
give a share of the points (see :mod:`variantgen.exam.sections.marking_policy`), and never takes any.
"""

from __future__ import annotations

import math
from collections.abc import Callable, Iterator, Mapping

from msgspec import Struct, field

from variantgen.exam.sheets import Answer
from variantgen.marking.key import is_right, scale

_POWERS = (1, -1, 2, -2, 3, -3)
# Factors between units that are no power of ten, by the exponents of length and time.
_UNITS = {
    (0, 0): (math.degrees(1.0),),
    (0, -1): (math.degrees(1.0), math.pi / 30, math.tau),
    (0, -2): (math.degrees(1.0), math.tau),
    (1, -1): (3.6,),
}
_METRES = {1: (100.0, 1000.0), 2: ()}  # exponent of length: metres taken for centimetres, for millimetres
_NEAR = 3.0  # tolerances within which a number is right but for rounding
_TIED = 0.02  # tolerances by which results differ that no one can tell apart: the first one counts
_SAME = 1e-9


class Cause(Struct, frozen=True):
    """Why an answer may be wrong: one of ``marking_policy.CAUSES``, and what it is about (a mistake, a quantity)."""

    name: str
    detail: str = ""


OTHER = Cause("other")


class Comparisons(Struct, frozen=True):
    """What else a number may be: of the student's own sheet, and results of plausible mistakes.

    ``siblings`` are the other answers of the sheet by ``problem.quantity``; ``parts`` components and magnitudes of the
    same vector by name; ``mistakes`` results of this answer by the name of the mistake, all in units of the answer.
    """

    siblings: Mapping[str, Answer] = field(default_factory=dict)
    parts: Mapping[str, float] = field(default_factory=dict)
    mistakes: Mapping[str, float] = field(default_factory=dict)


def cause_of(value: float, answer: Answer, around: Comparisons) -> Cause:
    """The likeliest cause of a wrong value (in the unit of the answer)."""
    distance_to = _distances(value, answer)
    best, least = OTHER, 1.0 + _TIED
    for name, detail, result in _every(answer, around):
        distance = distance_to(result)
        if distance <= 1.0 and distance < least - _TIED and not is_right(answer, result):
            best, least = Cause(name, detail), distance  # a mistake that leads to what is right all the same is none
    if best is not OTHER:
        return best
    return Cause("rounding") if distance_to(answer.value) <= _NEAR else OTHER


def _distances(value: float, answer: Answer) -> Callable[[float], float]:
    """How far a value is from the result of a mistake, in tolerances of the answer that are as wide as the result."""
    size = scale(answer)
    is_direction = answer.quantity.is_direction
    fixed = answer.tolerance if answer.quantity.is_angle or not size else None

    def distance_to(result: float) -> float:
        if not math.isfinite(result):
            return math.inf
        width = fixed if fixed is not None else answer.tolerance * abs(result) / size
        gap = abs(value - result)
        if is_direction:
            gap = abs(math.remainder(gap, 360.0))
        if width == 0:
            return 0.0 if gap <= _SAME * max(abs(result), 1.0) else math.inf
        return gap / width

    return distance_to


def _every(answer: Answer, around: Comparisons) -> Iterator[tuple[str, str, float]]:
    """What the answer would be by each mistake: name and detail of the cause, and the result."""
    right, is_angle = answer.value, answer.quantity.is_angle
    yield "sign", "", -right
    if answer.quantity.is_direction:
        yield "sign", "", right - 180.0 if right > 0 else right + 180.0
        for other in (90.0 - right, 180.0 - right):
            yield "component", "", other
    for name, result in around.mistakes.items():
        yield "mistake", name, result
    if not is_angle:
        for name, result in around.mistakes.items():
            yield "mistake", name, -result
    for name, result in around.parts.items():
        yield "component", name, result
        yield "component", name, -result
    if answer.quantity.component == "sense":
        return
    dimension = answer.unit.dimension
    for factor in _UNITS.get(dimension, ()):
        for other in (factor, 1 / factor):
            yield "unit", "", right * other
    if not is_angle:
        metres = _METRES.get(dimension[0], ())
        for power in _POWERS:
            factor = 10.0**power
            name = "unit" if factor in metres or 1 / factor in metres else "power_of_ten"
            yield name, "", right * factor
            yield name, "", -right * factor
    for name, sibling in around.siblings.items():
        if sibling.unit.dimension == dimension and sibling.quantity.is_angle == is_angle:
            yield "other_answer", name, answer.unit.from_si(sibling.value * sibling.unit.size)
