"""The sum of known vectors on natural axes: the lines on which most of them lie, not the axes x and y of the paper.

Vectors across each other are ``sqrt(a^2 + b^2)``, vectors along one line are added. Else the axes go along and across
that vector which leaves the fewest oblique ones, a normal component of an acceleration before others. Each oblique
vector costs two cosines. A root of more than three projections would be set too small to be read in a column: of more
than two vectors, some of them oblique, the two components have lines of their own.
"""

from __future__ import annotations

from collections.abc import Sequence
from functools import cached_property

from msgspec import Struct
from msgspec.structs import replace

from variantgen.algebra.expression import Constant, Expression, Ratio, Total, Value
from variantgen.algebra.name import Name
from variantgen.algebra.normal_form import hypotenuse
from variantgen.methods.geometry.geometry import Geometry
from variantgen.methods.solution.book import Book, Known
from variantgen.methods.solution.named_angles import named
from variantgen.methods.steps.step import Fact, Share, Term, VectorOf, Word
from variantgen.methods.vectors.collected import collected
from variantgen.methods.vectors.directions import on_paper
from variantgen.methods.vectors.vector_equation import shares

_STRAIGHT = 1e-7  # degrees within which two directions are one line, or square
_NOTHING = 1e-9  # of the largest vector: a smaller sum is none
_ONE_LINE = 2  # so many vectors fit into one line where some are oblique
_NATURAL, _OWN = ("on_n", "on_tau"), ("xi", "eta")  # components by their axes: of a path or a rim, and others


class _Axis(Struct, frozen=True, dict=True):
    """An axis with the projections of the vectors on it; ``along`` is a vector that lies on it."""

    angle: Value
    along: Term | None
    parts: tuple[Share, ...]

    @cached_property
    def total(self) -> float:
        """The sum of the projections."""
        return sum(sign * part.number(True) for sign, part in signed(self.parts))

    def sum(self, flip: int = 1) -> Expression:
        """The sum of the projections as an expression, all signs multiplied by ``flip``."""
        return ordered_sum([(sign * flip, part) for sign, part in signed(self.parts)])


def signed(parts: Sequence[Share]) -> list[tuple[int, Expression]]:
    """Projections of known vectors as signs and expressions."""
    return collected([(share.sign, share) for share in parts])


def ordered_sum(terms: Sequence[tuple[int, Expression]]) -> Expression:
    """A sum of expressions with signs, a positive one first where there is one."""
    if not terms:
        return Constant(0.0)
    ordered = sorted(terms, key=lambda term: -term[0])
    return ordered[0][1] if len(ordered) == 1 and ordered[0][0] > 0 else Total(tuple(ordered))


def natural_modulus(book: Book, name: Name, terms: Sequence[Term], divisor: int = 1) -> Value:
    """The magnitude of a sum of known vectors (divided by a whole number), with its lines."""
    axes = _axes(terms)
    if len(terms) > _ONE_LINE and _oblique(terms, axes[0].angle):
        found = natural_components(book, name, terms, divisor)
        return book.derive(name, book.measure, hypotenuse([term.size for term in found if term.size is not None]))
    axes = _named(book, axes)
    _say_lines(book, terms, axes)
    kept = _kept(book, terms, axes, in_root=True)
    if not kept:
        return Value(name, book.measure, 0.0)
    sums = [axis.sum(1 if _is_positive(axis, squared=len(kept) > 1) else -1) for axis in kept]
    whole = sums[0] if len(sums) == 1 else hypotenuse(sums)
    return book.derive(name, book.measure, whole if divisor == 1 else Ratio(whole, Constant(float(divisor))))


def _is_positive(axis: _Axis, squared: bool) -> bool:
    """Whether a sum is written as it is, not with opposite signs: projections of one sign without a minus before it.

    Of a sum that is not ``squared`` and has several projections the number is positive.
    """
    first = axis.parts[0].sign
    if len(axis.parts) == 1 or (squared and all(share.sign == first for share in axis.parts)):
        return first > 0
    return axis.total > 0


def natural_components(book: Book, name: Name, terms: Sequence[Term], divisor: int = 1) -> Known:
    """The sum of known vectors as its components on natural axes, which keep their signs, with their lines."""
    axes = _named(book, _axes(terms))
    natural = axes[0].along is not None and axes[0].along.name.part.endswith("n")
    words = _NATURAL if natural else _OWN
    _say_axes(book, axes, "n_tau" if natural else "xi_eta")
    kept = _kept(book, terms, axes)
    found = []
    for axis, word in zip(axes, words, strict=True):
        if axis in kept:
            whole = axis.sum() if divisor == 1 else Ratio(axis.sum(), Constant(float(divisor)))
            own = name.component(word)
            found.append(book.term(own, book.derive(own, book.measure, whole), axis.angle, f"axis_{word}"))
    return tuple(found)


def _kept(book: Book, terms: Sequence[Term], axes: Sequence[_Axis], in_root: bool = False) -> list[_Axis]:
    """The axes on which the sum is not zero; of projections that cancel it is said that they do.

    Oblique ones that cancel by their numbers stand in the root of a magnitude (``in_root``), where that is seen.
    """
    largest = max(abs(term.size.exact) for term in terms if term.size is not None)
    kept = []
    for axis in axes:
        straight = all(share.angle is None for share in axis.parts)
        if abs(axis.total) > _NOTHING * largest or (in_root and not straight):
            kept.append(axis)
        elif len(axis.parts) > 1:
            facts: dict[str, Fact] = {"vectors": tuple(VectorOf(share.term.name) for share in axis.parts)}
            book.say("natural.cancel" if straight else "natural.cancel_components", False, **facts)
    return kept


def first_along(terms: Sequence[Term]) -> Term:
    """The vector along the first axis: the one that leaves the fewest oblique vectors."""
    return min(terms, key=lambda term: (_oblique(terms, term.angle), not term.name.part.endswith("n")))


def _axes(terms: Sequence[Term]) -> tuple[_Axis, _Axis]:
    """The axes that leave the fewest oblique vectors."""
    best = first_along(terms)
    first = _Axis(best.angle, best, shares(terms, best.angle))
    square = (term for term in terms if _is_square(term.angle, best.angle))
    beside = next(square, None)
    second = beside.angle if beside is not None else Geometry.turned(best.angle, 90.0)
    other = _Axis(second, beside, shares(terms, second))
    if beside is None and other.total < 0:
        second = Geometry.turned(best.angle, -90.0)
        other = _Axis(second, None, tuple(replace(share, sign=-share.sign) for share in other.parts))
    return first, other


def _named(book: Book, axes: tuple[_Axis, _Axis]) -> tuple[_Axis, _Axis]:
    """The axes with names for angles that are long sums, said to be those with the axis or what it is across."""
    crossed = _line(axes[0])
    first, second = (
        replace(axis, parts=tuple(named(book, share, _line(axis), crossed) for share in axis.parts)) for axis in axes
    )
    return first, second


def _line(axis: _Axis) -> VectorOf | None:
    """The vector along an axis."""
    return None if axis.along is None else VectorOf(axis.along.name)


def _oblique(terms: Sequence[Term], axis: Value) -> int:
    """How many vectors lie neither on an axis nor across it."""
    straight = axis.exact
    return sum([_STRAIGHT <= (term.angle.exact - straight) % 90.0 <= 90.0 - _STRAIGHT for term in terms])


def _is_square(first: Value, second: Value) -> bool:
    return abs((first.exact - second.exact) % 180.0 - 90.0) < _STRAIGHT


def _say_lines(book: Book, terms: Sequence[Term], axes: Sequence[_Axis]) -> None:
    """How the vectors lie, where the magnitude follows in one line."""
    first, second = axes
    facts: dict[str, Fact] = {"vector": VectorOf(terms[0].name)}
    if _oblique(terms, first.angle):
        assert first.along is not None
        book.say("natural.across", False, vector=VectorOf(first.along.name))
    elif len(terms) == 2 and not second.parts:
        book.say("natural.collinear", False, other=VectorOf(terms[1].name), **facts)
    elif len(terms) == 2:
        book.say("natural.square", False, other=VectorOf(terms[1].name), **facts)


def _say_axes(book: Book, axes: Sequence[_Axis], letters: str) -> None:
    """What the axes are that components are named by."""
    first, second = axes
    assert first.along is not None
    facts: dict[str, Fact] = {"vector": VectorOf(first.along.name)}
    if second.along is not None:
        book.say(f"natural.{letters}", False, other=VectorOf(second.along.name), **facts)
    else:
        book.say(f"natural.{letters}_across", False, side=Word(on_paper(second.angle.exact)), **facts)


def unshown_components(book: Book, name: Name, terms: Sequence[Term], divisor: int) -> Known:
    """The same components without their lines, for what only needs their numbers."""
    found = []
    for axis, word in zip(_axes(terms), _OWN, strict=True):
        whole = Ratio(axis.sum(), Constant(float(divisor)))
        size = Value(name.component(word), book.measure, whole.number(True), whole, book.size_of(book.measure))
        if size.exact:
            found.append(book.term(name.component(word), size, axis.angle, f"axis_{word}"))
    return tuple(found)
