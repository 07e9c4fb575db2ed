"""By how much a number of a solution is off from what the solved motion says of its name.

Everything is relative to a natural scale: the largest velocity or acceleration, the size of the mechanism, one radian.
"""

from __future__ import annotations

import cmath
import math
from functools import cached_property

from msgspec import Struct
from msgspec.structs import replace

from variantgen.algebra.expression import Total, Value
from variantgen.algebra.name import OWN_AXES, Name
from variantgen.families.quantities import Quantity, split_name
from variantgen.methods.linkage.problem import Task
from variantgen.methods.solved_motion import SolvedMotion
from variantgen.methods.steps.step import Term

ANYWHERE = "ways.unknown"  # the way of a vector of which not even the direction is known
_ASKED = {"curvature": "rho", "ratio": "ratio", "rope": "v_rope"}  # names of asked quantities, by the motion


class BesideMotion(Struct, frozen=True, dict=True):
    """Numbers beside the motion of a task."""

    task: Task

    @cached_property
    def solved(self) -> SolvedMotion:
        """What the solver found, in printed units."""
        return SolvedMotion(self.task)

    def answer(self, quantity: Quantity, value: Value) -> float:
        """By how much an answer is off, with its sign."""
        right = self.solved.answer(quantity)
        if quantity.is_angle:
            whole = abs(self.solved.answer(quantity.whole)) if quantity.component == "angle" else math.inf
            nothing = whole <= 1e-9 * self.scale(quantity.order)  # a vector that is zero has no direction
            return 0.0 if nothing else turn(value.exact - right)
        if not math.isfinite(right) or not math.isfinite(value.exact):
            return 0.0 if value.exact == right else math.inf
        scale = self.task.scales.get(value.measure, 1.0) or 1.0
        far = (1.0 + abs(right) / scale) ** 2 if quantity.is_centre or quantity.group in ("path", "ratio") else 1.0
        return abs(value.exact - right) / scale / far

    def named(self, value: Value, name: Name) -> float:
        """A value beside what the motion says of its name; zero where it says nothing."""
        exact = value.exact
        if name.kind in ("v", "a"):
            return self._size_of_vector(exact, name)
        if name.kind == "heading":
            headed = replace(name, kind=name.body, body="")  # the vector of which it is the direction
            return min((turn(exact - _degrees(v)) for v in self.solved.vectors(headed) if v), default=0.0)
        if name.kind == "parameter":  # signs of laws of time are left to the figure, as those of rates
            found = self.solved.derived(name, value.measure)
            return min((relative(abs(exact) - abs(right), abs(right)) for right in found), default=0.0)
        if name.kind == "mu":
            return turn(abs(exact) - self.solved.answer(Quantity("mu", name.of)))
        if name.kind == "turn":
            return self.answer(split_name(name.of), value)
        if name.kind in _ASKED:
            return self.answer(Quantity(_ASKED[name.kind], name.of, name.about), value)
        if (rate := self.solved.rate(name)) is not None:
            # The magnitude is never negative, so that a negative number has a sign.
            gap = exact - rate if name.part == "z" or name.dots or exact < 0 else exact - abs(rate)
            return relative(gap, self.task.scales.get(value.measure, 1.0))
        if (coordinate := self.solved.coordinate(name)) is not None:
            gap = abs(exact) - abs(coordinate) if _is_opposite(value) else exact - coordinate
            return relative(gap, max(self.task.scales.get(value.measure, 1.0), abs(coordinate)))
        return self._measured(exact, name)

    def _size_of_vector(self, exact: float, name: Name) -> float:
        """The magnitude of a vector, or a component along an axis with its sign."""
        word = name.part.rpartition(" ")[2]
        offs = []
        if word in OWN_AXES:
            return 0.0  # what axis that is, only the vector with its direction tells
        for vector in self.solved.vectors(name):
            number = self.solved.component(vector, word)
            gap = abs(exact) - abs(vector) if number is None else exact - number
            offs.append(relative(gap, max(self.scale(1 if name.kind == "v" else 2), abs(vector))))
        return min(offs, default=0.0)

    def _measured(self, exact: float, name: Name) -> float:
        """A length, the direction of a ray, or a corner of a triangle; far from the mechanism that is coarser."""
        arms, size = self.solved.arms(name), self.task.size
        if not arms:
            return 0.0
        lengths = [abs(arm) for arm in arms]
        coarse = (1.0 + max(lengths) / size) ** 2
        if name.kind == "length":
            return abs(exact - lengths[0]) / size / coarse
        if min(lengths) == 0:
            return 0.0
        right = _degrees(arms[0]) if name.kind == "direction" else abs(_degrees(arms[1] / arms[0]))
        return turn(exact - right) * min(lengths) / size / coarse

    def term(self, term: Term) -> float:
        """A vector of an equation with its direction; one of unknown magnitude lies along its line."""
        offs = []
        on_axis = term.name.part.endswith(OWN_AXES)
        way = vector_of(1.0, term)
        for found in self.solved.vectors(term.name.whole if on_axis else term.name):
            vector = (found / way).real * way if on_axis else found
            if term.size is not None:
                gap = abs(vector_of(term.size.exact, term) - vector)
            else:
                gap = 0.0 if term.way.key == ANYWHERE else abs((vector / vector_of(1.0, term)).imag)
            offs.append(relative(gap, max(self.scale(1 if term.name.kind == "v" else 2), abs(vector))))
        return min(offs, default=0.0)

    def scale(self, order: int) -> float:
        """The largest velocity (``order`` 1) or acceleration."""
        return self.task.largest_speed if order == 1 else self.task.largest_acceleration


def vector_of(size: float, term: Term) -> complex:
    """A vector of that size in the direction of a term."""
    return cmath.rect(size, math.radians(term.angle.exact))


def relative(gap: float, scale: float) -> float:
    """The size of a gap beside a scale; zero where there is no gap, be the scale zero too."""
    return abs(gap) / scale if gap else 0.0


def turn(degrees: float) -> float:
    """An angle between two directions in radians, without whole turns."""
    return abs(math.remainder(math.radians(degrees), math.tau))


def _degrees(vector: complex) -> float:
    return math.degrees(cmath.phase(vector))


def _is_opposite(value: Value) -> bool:
    """Whether a value is the magnitude of a negative one of its name."""
    match value.expression:
        case Total(((-1, Value() as other),)):
            return other.name == value.name
    return False
