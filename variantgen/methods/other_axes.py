"""A check of a sum of known vectors: its magnitude on other axes than those on which it was found.

A sum such as ``a_M = a^n_A + a^tau_A + a^n_MA + a^tau_MA`` is worked out along and across the vector that leaves the
fewest oblique ones. Along and across another of its vectors other ones are oblique, with other sines and cosines, and
the root of the squares is the same. It applies where some vector is oblique, and costs one line.
"""

from __future__ import annotations

from collections.abc import Sequence

from variantgen.algebra.expression import Expression, Value
from variantgen.algebra.normal_form import hypotenuse
from variantgen.methods.geometry.geometry import Geometry
from variantgen.methods.result_check import projected
from variantgen.methods.solution.book import Book
from variantgen.methods.solution.named_angles import renamed
from variantgen.methods.steps.step import Balance, Derived, Fact, Item, Sentence, Step, Term, VectorLine, VectorOf
from variantgen.methods.vectors.natural_sum import first_along, ordered_sum
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
                whole = _on_axes(book, terms, along.angle)
                sides = [Value(None, "number", item.number(True), item, own.exact) for item in (own, whole)]
                facts: dict[str, Fact] = {"vector": VectorOf(line.left[0].name), "along": VectorOf(along.name)}
                return [Sentence("check.other_axes", facts, detail=False), Balance(sides[0], sides[1])]
    return []


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
