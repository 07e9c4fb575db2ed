"""A check of a sum of known vectors: on another axis than those on which it was found.

A sum such as ``a_M = a^n_A + a^tau_A + a^n_MA + a^tau_MA`` is worked out along and across the vector that leaves the
fewest oblique ones. Along another of its vectors other ones are oblique, with other sines and cosines. There the two
components, where they have lines, and the vectors of the sum have one projection; else the root of the squares along
that vector and across it is the magnitude, in one line if it is short, else below the two sums. It applies where some
vector is oblique.
"""

from __future__ import annotations

from collections.abc import Mapping, Sequence

from variantgen.algebra.expression import Expression, Value
from variantgen.algebra.name import Name
from variantgen.algebra.normal_form import hypotenuse
from variantgen.methods.checks.result_check import projected
from variantgen.methods.geometry.geometry import Geometry
from variantgen.methods.solution.book import Book
from variantgen.methods.solution.named_angles import renamed
from variantgen.methods.steps.step import Balance, Derived, Fact, Item, Sentence, Step, Term, VectorLine, VectorOf
from variantgen.methods.vectors.natural_sum import first_along, ordered_sum, signed
from variantgen.methods.vectors.points import positive
from variantgen.methods.vectors.vector_equation import shares

_IN_ROOT = 3  # projections that a root holds in a column; with more of them it would be set too small to be read


def other_axes(book: Book, steps: Sequence[Step]) -> list[Item]:
    """The last sum of known vectors of which the magnitude has a line, on other axes; nothing where there is none."""
    for step in reversed(steps):
        found = {item.value.name: item.value for item in step.items if isinstance(item, Derived)}
        for line in (item for item in reversed(step.items) if isinstance(item, VectorLine)):
            terms = [term for term in line.right if term.size is not None and term.size.exact]
            if len(line.left) != 1 or len(terms) < len(line.right) or line.left[0].name not in found:
                continue
            own = found[line.left[0].name]
            used = first_along(terms)
            oblique = [term for term in terms if _is_oblique(term, used.angle)]
            if own.exact and oblique:
                along = min(oblique, key=lambda term: sum(_is_oblique(other, term.angle) for other in terms))
                parts = _components(line.left[0], terms, used, found)
                if not parts and (apart := _apart(book, line.left[0], terms, along, own)):
                    return apart
                key = "check.components" if parts else "check.other_axes"
                left = _on_axis(book, parts, along.angle) if parts else own
                right = (_on_axis if parts else _on_axes)(book, terms, along.angle)
                sides = [Value(None, "number", item.number(True), item, own.exact) for item in (left, right)]
                facts: dict[str, Fact] = {"vector": VectorOf(line.left[0].name), "along": VectorOf(along.name)}
                return [Sentence(key, facts, detail=False), Balance(sides[0], sides[1])]
    return []


def _apart(book: Book, whole: Term, terms: Sequence[Term], along: Term, own: Value) -> list[Item]:
    """The magnitude by components that have lines of their own; nothing where the sums are short enough for a root."""
    sums = _sums(book, terms, along.angle)
    if sum(len(parts) for parts in sums) <= _IN_ROOT:
        return []
    names = [whole.name.component(word) for word in ("xi", "eta")]
    sizes = [
        Value(name, own.measure, total.number(True), total, own.size)
        for name, total in zip(names, map(ordered_sum, sums), strict=False)
    ]
    root = hypotenuse(sizes)
    facts: dict[str, Fact] = {"vector": VectorOf(whole.name), "along": VectorOf(along.name)}
    sides = [Value(None, "number", item.number(True), item, own.exact) for item in (own, root)]
    lines = [Derived(size, symbolic=False) for size in sizes]
    return [Sentence("check.other_axes_apart", facts, detail=False), *lines, Balance(*sides)]


def _components(whole: Term, terms: Sequence[Term], used: Term, found: Mapping[Name | None, Value]) -> list[Term]:
    """The components of the sum along and across the vector ``used``; nothing unless both have a line."""
    for words in (("on_n", "on_tau"), ("xi", "eta")):
        sizes = [found.get(whole.name.component(word)) for word in words]
        if sizes[0] is None or sizes[1] is None:
            continue
        across = Geometry.turned(used.angle, 90.0)
        turned = sum(sign * part.number(True) for sign, part in signed(shares(terms, across)))
        if turned * sizes[1].exact < 0:
            across = Geometry.turned(used.angle, -90.0)
        return [_turned(whole, size, way) for size, way in zip(sizes, (used.angle, across), strict=True) if size]
    return []


def _turned(whole: Term, size: Value, way: Value) -> Term:
    """A component along an axis, with its magnitude to the side to which it points."""
    return Term(whole.name, positive(size), way if size.exact >= 0 else Geometry.turned(way, 180.0), whole.way)


def _on_axis(book: Book, terms: Sequence[Term], axis: Value) -> Expression:
    """The sum along an axis."""
    return ordered_sum(projected([renamed(book, share) for share in shares(terms, axis)]))


def _is_oblique(term: Term, axis: Value) -> bool:
    """Whether a vector lies neither along an axis nor across it."""
    return any(share.angle is not None for share in shares([term], axis))


def _on_axes(book: Book, terms: Sequence[Term], axis: Value) -> Expression:
    """The root of the squares of the sums along an axis and across it."""
    return hypotenuse([ordered_sum(parts) for parts in _sums(book, terms, axis)])


def _sums(book: Book, terms: Sequence[Term], axis: Value) -> list[list[tuple[int, Expression]]]:
    """The projections on an axis and across it, each to the side on which their sum is positive; none where none is."""
    sums = []
    for way in (axis, Geometry.turned(axis, 90.0)):
        parts = projected([renamed(book, share) for share in shares(terms, way)])
        flip = 1 if sum(sign * part.number(True) for sign, part in parts) >= 0 else -1
        if parts:
            sums.append([(flip * sign, part) for sign, part in parts])
    return sums
