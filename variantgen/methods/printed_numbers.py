"""By how much the numbers of a solution are off: values against the solved motion, equations against themselves.

A value whose name the motion knows is compared with it, and what a printed formula gives with the number behind it. A
vector of an equation is compared with its direction. Everything is relative to the scales of ``beside_motion``.
"""

from __future__ import annotations

import math
from collections.abc import Iterator, Sequence
from functools import cached_property
from itertools import pairwise, product

from msgspec import Struct, field
from msgspec.structs import replace

from variantgen.algebra.expression import Applied, Expression, Raised, Ratio, Times, Total, Value
from variantgen.algebra.name import AXES, ON_LINE, Name
from variantgen.algebra.values import in_order
from variantgen.methods.beside_motion import ANYWHERE, BesideMotion, relative, turn, vector_of
from variantgen.methods.linkage.problem import Task
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

_SMALL = 1e-6  # of a natural scale: numbers below it are not compared with each other alone, they may be rounding
Off = tuple[str | Name | None, float]  # what it is, or its name, and by how much it is off


class PrintedNumbers(Struct, dict=True):
    """The numbers of a solution; ``measured``: vectors were read from drawings, with their directions."""

    task: Task
    measured: bool = False
    _checked: set[Value] = field(default_factory=set)
    _pointed: set[tuple[Name, Value | None, Value, str]] = field(default_factory=set)  # vectors that were checked

    @cached_property
    def beside(self) -> BesideMotion:
        """What compares numbers with the solved motion."""
        return BesideMotion(self.task)

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
                    yield term.name, self.beside.term(term)
                if term.size is None and term.way.key != ANYWHERE:
                    unknown[term.name] = term
            if isinstance(item, Derived) and item.law is not None:
                gap = item.law.number(True) - item.value.exact
                yield "the law of a line", relative(gap, max(abs(item.value.exact), _largest(item.law)))
            if isinstance(item, Derived) and item.value.name is not None:
                # A negative number is opposite to the direction that was assumed.
                if item.value.name in unknown and not self.measured:
                    yield item.value.name, self.beside.term(replace(unknown[item.value.name], size=item.value))
                if self.measured and item.value.exact < 0 and self._is_magnitude(item.value.name):
                    yield f"the sign of {text_of(item.value.name)}", math.inf
                if item.value.name.kind == "projection":
                    projections.append(item.value.exact)
        if projections:
            yield "equal projections", relative(max(projections) - min(projections), self.task.largest_speed)

    def _is_magnitude(self, name: Name) -> bool:
        """Whether it is the name of a vector, not of a component on an axis or a line, nor an asked one on a path."""
        if name.kind not in ("v", "a") or name.part.endswith(AXES) or name.part.rpartition(" ")[2].startswith(ON_LINE):
            return False
        return not any(q.component == "t" and Name("a", q.target, part="tau") == name for q in self.task.asked)

    def _value(self, value: Value) -> float:
        """A value: what its formula gives, and what the motion says of its name."""
        off = 0.0
        if value.expression is not None and math.isfinite(value.exact):
            gap = value.expression.number(True) - value.exact
            if value.measure == "angle":
                off = turn(gap)
            else:
                off = relative(gap, max(abs(value.exact), value.size, _largest(value.expression)))
        return off if value.name is None else max(off, self.beside.named(value, value.name))

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
                    yield "an equation of the system", relative(sum(products) - end.exact, largest)
            case Balance(one, other):
                yield "a sum beside its equal", relative(one.exact - other.exact, max(_largest(one), _largest(other)))
            case Ascending(values):
                rising = all(low.exact < high.exact for low, high in pairwise(values))
                yield "the order of magnitudes", 0.0 if rising else math.inf
            case EquationLine(left, right):
                gap = left.number(True) - right.number(True)
                yield "an equation", relative(gap, max(_largest(left), _largest(right)))

    def _meant(self, term: Term) -> list[complex]:
        """The vector of a term: the known one, or what the solver has for it."""
        return self.beside.solved.vectors(term.name) if term.size is None else [vector_of(term.size.exact, term)]

    def _nothing(self, terms: Sequence[Term]) -> float:
        """What terms that are zero, but for rounding, are held against: where all are, none is a measure."""
        return _SMALL * max((self.beside.scale(1 if term.name.kind == "v" else 2) for term in terms), default=0.0)

    def _projections(self, side: float, share: Share) -> list[complex]:
        """What stands in a projected equation, with the sign of its side."""
        cosine = 1.0 if (factor := share.factor) is None else factor.number(True)
        sizes = [(vector / vector_of(1.0, share.term)).real for vector in self._meant(share.term)]
        return [complex(side * share.sign * size * cosine) for size in sizes]


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


def _closing(terms: Sequence[Sequence[complex]], nothing: float) -> float:
    """By how much a sum is not zero; of terms for which there are several numbers, by those that fit best."""
    sums = (relative(abs(sum(numbers)), max([nothing, *map(abs, numbers)])) for numbers in product(*terms))
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


def text_of(what: str | Name | None) -> str:
    """What is off, in a message."""
    if isinstance(what, Name):
        return " ".join(filter(None, (f"{what.kind}_{what.of}", what.about, what.part)))
    return what or "a number"
