"""By how much the numbers of a solution are off: values against the solved motion, equations against themselves.

A value whose name the motion knows is compared with it, and what a printed formula gives with the number behind it. A
vector of an equation is compared with its direction. Everything is relative to a natural scale: the largest velocity or
acceleration, the size of the mechanism, one radian.
"""

from __future__ import annotations

import cmath
import math
from collections.abc import Iterator, Sequence
from functools import cached_property
from itertools import pairwise, product

from msgspec import Struct, field
from msgspec.structs import replace

from variantgen.algebra.expression import Applied, Expression, Raised, Ratio, Times, Total, Value
from variantgen.algebra.name import AXES, ON_LINE, OWN_AXES, Name
from variantgen.algebra.values import in_order
from variantgen.families.quantities import Quantity, split_name
from variantgen.methods.linkage.problem import Task
from variantgen.methods.solved_motion import SolvedMotion
from variantgen.methods.steps.printed_digits import shown_values
from variantgen.methods.steps.step import (
    Ascending,
    Balance,
    Derived,
    EquationLine,
    Item,
    LinearSystem,
    Projection,
    Share,
    Step,
    Term,
    TermTable,
    VectorLine,
)

_ANYWHERE = "ways.unknown"  # the way of a vector of which not even the direction is known
_ASKED = {"curvature": "rho", "ratio": "ratio", "rope": "v_rope"}  # names of asked quantities, by the motion
_SMALL = 1e-6  # of a natural scale: numbers below it are not compared with each other alone, they may be rounding
Off = tuple[str | Name | None, float]  # what it is, or its name, and by how much it is off


class PrintedNumbers(Struct, dict=True):
    """The numbers of a solution; ``measured``: vectors were read from drawings, with their directions."""

    task: Task
    measured: bool = False
    _checked: set[Value] = field(default_factory=set)
    _pointed: set[tuple[Name, Value | None, Value, str]] = field(default_factory=set)  # vectors that were checked

    @cached_property
    def solved(self) -> SolvedMotion:
        """What the solver found, in printed units."""
        return SolvedMotion(self.task)

    def step(self, step: Step) -> Iterator[Off]:
        """By how much each number and each equation of a step is off."""
        unknown: dict[Name, Term] = {}
        projections = []
        for item in step.items:
            for value in in_order(shown_values(item), self._checked):
                self._checked.add(value)
                yield value.name, self._value(value)
            yield from self._equation(item)
            for term in _terms(item):
                if (key := (term.name, term.size, term.angle, term.way.key)) not in self._pointed:
                    self._pointed.add(key)
                    yield term.name, self._term(term)
                if term.size is None and term.way.key != _ANYWHERE:
                    unknown[term.name] = term
            if isinstance(item, Derived) and item.law is not None:
                gap = item.law.number(True) - item.value.exact
                yield "the law of a line", _relative(gap, max(abs(item.value.exact), _largest(item.law)))
            if isinstance(item, Derived) and item.value.name is not None:
                # A negative number is opposite to the direction that was assumed.
                if item.value.name in unknown and not self.measured:
                    yield item.value.name, self._term(replace(unknown[item.value.name], size=item.value))
                if self.measured and item.value.exact < 0 and self._is_magnitude(item.value.name):
                    yield f"the sign of {text_of(item.value.name)}", math.inf
                if item.value.name.kind == "projection":
                    projections.append(item.value.exact)
        if projections:
            yield "equal projections", _relative(max(projections) - min(projections), self.task.largest_speed)

    def _is_magnitude(self, name: Name) -> bool:
        """Whether it is the name of a vector, not of a component on an axis or a line, nor an asked one on a path."""
        if name.kind not in ("v", "a") or name.part.endswith(AXES) or name.part.rpartition(" ")[2].startswith(ON_LINE):
            return False
        return not any(q.component == "t" and Name("a", q.target, part="tau") == name for q in self.task.asked)

    def answer(self, quantity: Quantity, value: Value) -> float:
        """By how much an answer is off, with its sign."""
        right = self.solved.answer(quantity)
        if quantity.is_angle:
            whole = abs(self.solved.answer(quantity.whole)) if quantity.component == "angle" else math.inf
            nothing = whole <= 1e-9 * self._scale(quantity.order)  # a vector that is zero has no direction
            return 0.0 if nothing else _turn(value.exact - right)
        if not math.isfinite(right) or not math.isfinite(value.exact):
            return 0.0 if value.exact == right else math.inf
        scale = self.task.scales.get(value.measure, 1.0) or 1.0
        far = (1.0 + abs(right) / scale) ** 2 if quantity.is_centre or quantity.group in ("path", "ratio") else 1.0
        return abs(value.exact - right) / scale / far

    def _value(self, value: Value) -> float:
        """A value: what its formula gives, and what the motion says of its name."""
        off = 0.0
        if value.expression is not None and math.isfinite(value.exact):
            gap = value.expression.number(True) - value.exact
            if value.measure == "angle":
                off = _turn(gap)
            else:
                off = _relative(gap, max(abs(value.exact), value.size, _largest(value.expression)))
        return off if value.name is None else max(off, self._named(value, value.name))

    def _named(self, value: Value, name: Name) -> float:
        """A value beside what the motion says of its name; zero where it says nothing."""
        exact = value.exact
        if name.kind in ("v", "a"):
            return self._size_of_vector(exact, name)
        if name.kind == "heading":
            headed = replace(name, kind=name.body, body="")  # the vector of which it is the direction
            return min((_turn(exact - _degrees(v)) for v in self.solved.vectors(headed) if v), default=0.0)
        if name.kind == "parameter":  # signs of laws of time are left to the figure, as those of rates
            found = self.solved.derived(name, value.measure)
            return min((_relative(abs(exact) - abs(right), abs(right)) for right in found), default=0.0)
        if name.kind == "mu":
            return _turn(abs(exact) - self.solved.answer(Quantity("mu", name.of)))
        if name.kind == "turn":
            return self.answer(split_name(name.of), value)
        if name.kind in _ASKED:
            return self.answer(Quantity(_ASKED[name.kind], name.of, name.about), value)
        if (rate := self.solved.rate(name)) is not None:
            # The magnitude is never negative, so that a negative number has a sign.
            gap = exact - rate if name.part == "z" or name.dots or exact < 0 else exact - abs(rate)
            return _relative(gap, self.task.scales.get(value.measure, 1.0))
        if (coordinate := self.solved.coordinate(name)) is not None:
            gap = abs(exact) - abs(coordinate) if _is_opposite(value) else exact - coordinate
            return _relative(gap, max(self.task.scales.get(value.measure, 1.0), abs(coordinate)))
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
            offs.append(_relative(gap, max(self._scale(1 if name.kind == "v" else 2), abs(vector))))
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
        return _turn(exact - right) * min(lengths) / size / coarse

    def _term(self, term: Term) -> float:
        """A vector of an equation with its direction; one of unknown magnitude lies along its line."""
        offs = []
        on_axis = term.name.part.endswith(OWN_AXES)
        way = _vector(1.0, term)
        for found in self.solved.vectors(term.name.whole if on_axis else term.name):
            vector = (found / way).real * way if on_axis else found
            if term.size is not None:
                gap = abs(_vector(term.size.exact, term) - vector)
            else:
                gap = 0.0 if term.way.key == _ANYWHERE else abs((vector / _vector(1.0, term)).imag)
            offs.append(_relative(gap, max(self._scale(1 if term.name.kind == "v" else 2), abs(vector))))
        return min(offs, default=0.0)

    def _equation(self, item: Item) -> Iterator[Off]:
        """By how much the sides of an equation differ."""
        match item:
            case VectorLine(left, right):
                terms = [*((1.0, term) for term in left), *((-1.0, term) for term in right)]
                meant = [[sign * v for v in self._meant(term)] for sign, term in terms]
                yield "the vector equation", _closing(meant, self._nothing([term for _, term in terms]))
            case Projection(_, left, right):
                shares = [*((1.0, share) for share in left), *((-1.0, share) for share in right)]
                found = [self._projections(side, share) for side, share in shares]
                yield "the projected equation", _closing(found, self._nothing([share.term for _, share in shares]))
            case LinearSystem(unknowns, rows, right_side):
                for row, end in zip(rows, right_side, strict=True):
                    products = [factor.exact * value.exact for factor, value in zip(row, unknowns, strict=True)]
                    nothing = max(abs(f.exact) * v.size for f, v in zip(row, unknowns, strict=True)) * _SMALL
                    largest = max(abs(end.exact), nothing, *map(abs, products))
                    yield "an equation of the system", _relative(sum(products) - end.exact, largest)
            case Balance(one, other):
                yield "a sum beside its equal", _relative(one.exact - other.exact, max(_largest(one), _largest(other)))
            case Ascending(values):
                rising = all(low.exact < high.exact for low, high in pairwise(values))
                yield "the order of magnitudes", 0.0 if rising else math.inf
            case EquationLine(left, right):
                gap = left.number(True) - right.number(True)
                yield "an equation", _relative(gap, max(_largest(left), _largest(right)))

    def _meant(self, term: Term) -> list[complex]:
        """The vector of a term: the known one, or what the solver has for it."""
        return self.solved.vectors(term.name) if term.size is None else [_vector(term.size.exact, term)]

    def _nothing(self, terms: Sequence[Term]) -> float:
        """What terms that are zero, but for rounding, are held against: where all are, none is a measure."""
        return _SMALL * max((self._scale(1 if term.name.kind == "v" else 2) for term in terms), default=0.0)

    def _projections(self, side: float, share: Share) -> list[complex]:
        """What stands in a projected equation, with the sign of its side."""
        cosine = 1.0 if (factor := share.factor) is None else factor.number(True)
        sizes = [(vector / _vector(1.0, share.term)).real for vector in self._meant(share.term)]
        return [complex(side * share.sign * size * cosine) for size in sizes]

    def _scale(self, order: int) -> float:
        return self.task.largest_speed if order == 1 else self.task.largest_acceleration


def _terms(item: Item) -> Sequence[Term]:
    """The vectors in an item."""
    match item:
        case TermTable(terms):
            return terms
        case VectorLine(left, right):
            return (*left, *right)
        case Projection(_, left, right):
            return [share.term for share in (*left, *right)]
    return ()


def _vector(size: float, term: Term) -> complex:
    return cmath.rect(size, math.radians(term.angle.exact))


def _closing(terms: Sequence[Sequence[complex]], nothing: float) -> float:
    """By how much a sum is not zero; of terms for which there are several numbers, by those that fit best."""
    sums = (_relative(abs(sum(numbers)), max([nothing, *map(abs, numbers)])) for numbers in product(*terms))
    return min(sums, default=0.0)


def _largest(item: Expression) -> float:
    """The number of an expression if its terms did not cancel: beside it rounding is small."""
    match item:
        case Total(terms):
            return sum(_largest(term) for _, term in terms)
        case Times(factors):
            return math.prod(map(_largest, factors))
        case Ratio(above, below):
            return _largest(above) / abs(below.number(True))
        case Raised(base, exponent) if exponent > 0:
            return float(_largest(base) ** exponent)
        case Applied("cos" | "sin"):
            return 1.0  # that of a right angle is rounding
    return abs(item.number(True))


def _is_opposite(value: Value) -> bool:
    """Whether a value is the magnitude of a negative one of its name."""
    match value.expression:
        case Total(((-1, Value() as other),)):
            return other.name == value.name
    return False


def _relative(gap: float, scale: float) -> float:
    return abs(gap) / scale if gap else 0.0


def _degrees(vector: complex) -> float:
    return math.degrees(cmath.phase(vector))


def _turn(degrees: float) -> float:
    """An angle between two directions in radians, without whole turns."""
    return abs(math.remainder(math.radians(degrees), math.tau))


def text_of(what: str | Name | None) -> str:
    """What is off, in a message."""
    if isinstance(what, Name):
        return " ".join(filter(None, (f"{what.kind}_{what.of}", what.about, what.part)))
    return what or "a number"
