"""A check of a sum of known vectors: on another axis than those on which it was found.

A sum such as ``a_M = a^n_A + a^tau_A + a^n_MA + a^tau_MA`` is worked out along and across the vector that leaves the
fewest oblique ones. Along another of its vectors other ones are oblique, with other sines and cosines. There the two
components, where they have lines, and the vectors of the sum have one projection; else the root of the squares along
that vector and across it is the magnitude. It applies where some vector is oblique, and costs one line.
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
                key = "check.components" if parts else "check.other_axes"
                left = _on_axis(book, parts, along.angle) if parts else own
                right = (_on_axis if parts else _on_axes)(book, terms, along.angle)
                sides = [Value(None, "number", item.number(True), item, own.exact) for item in (left, right)]
                facts: dict[str, Fact] = {"vector": VectorOf(line.left[0].name), "along": VectorOf(along.name)}
                return [Sentence(key, facts, detail=False), Balance(sides[0], sides[1])]
    return []


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
    sums = []
    for way in (axis, Geometry.turned(axis, 90.0)):
        parts = projected([renamed(book, share) for share in shares(terms, way)])
        flip = 1 if sum(sign * part.number(True) for sign, part in parts) >= 0 else -1
        if parts:
            sums.append(ordered_sum([(flip * sign, part) for sign, part in parts]))
    return hypotenuse(sums)
