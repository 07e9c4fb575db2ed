"""Sums of lengths and of other expressions, collected and simplified before they are shown."""

from __future__ import annotations

from collections.abc import Iterable

from variantgen.methods.algebra.expression import Constant, Expression, Ratio, Times, Total

Signed = tuple[int, Expression]


def terms_of(item: Expression, sign: int = 1) -> list[Signed]:
    """The terms of a sum, of sums in it too; a product with a negative number is a negative term."""
    if isinstance(item, Total):
        return [found for s, term in item.terms for found in terms_of(term, sign * s)]
    if isinstance(item, Times) and isinstance(item.factors[0], Constant) and item.factors[0].value < 0:
        count, rest = -item.factors[0].value, item.factors[1:]
        return [(-sign, _multiple(count, rest[0] if len(rest) == 1 else Times(rest)))]
    if isinstance(item, Times):
        for i, factor in enumerate(item.factors):
            if isinstance(factor, Total) and len(factor.terms) == 1:
                (own, bare), others = factor.terms[0], (item.factors[:i], item.factors[i + 1 :])
                return terms_of(Times((*others[0], bare, *others[1])), sign * own)
    if isinstance(item, Ratio) and isinstance(item.above, Total) and len(item.above.terms) == 1:
        return [(sign * item.above.terms[0][0], Ratio(item.above.terms[0][1], item.below))]
    if isinstance(item, Constant) and item.value < 0:
        return [(-sign, Constant(-item.value, item.measure))]
    return [(sign, item)]


def summed(terms: Iterable[Signed]) -> Expression:
    """The sum of terms: equal ones collected, opposite ones cancelled, positive ones first."""
    found: list[tuple[float, Expression]] = []
    for sign, item in terms:
        for s, term in terms_of(item, sign):
            count, core = _counted(term)
            place = next((i for i, (_, other) in enumerate(found) if other is core or other == core), None)
            if place is None:
                found.append((s * count, core))
            else:
                found[place] = (found[place][0] + s * count, core)
    kept = [(1 if count > 0 else -1, _multiple(abs(count), core)) for count, core in found if not _is_zero(count, core)]
    kept.sort(key=lambda term: -term[0])
    if not kept:
        return Constant(0.0)
    return kept[0][1] if len(kept) == 1 and kept[0][0] > 0 else Total(tuple(kept))


def positive(item: Expression) -> tuple[int, Expression]:
    """The sign of a number and the expression of its magnitude; (0, ...) for zero."""
    number = item.number(True)
    if number == 0:
        return 0, item
    return (1, summed([(1, item)])) if number > 0 else (-1, summed([(-1, item)]))


def _counted(item: Expression) -> tuple[float, Expression]:
    """A number before a quantity, and the quantity."""
    if isinstance(item, Times) and isinstance(item.factors[0], Constant):
        rest = item.factors[1:]
        return float(item.factors[0].value), rest[0] if len(rest) == 1 else Times(rest)
    return 1.0, item


def _is_zero(count: float, item: Expression) -> bool:
    return count == 0 or (isinstance(item, Constant) and item.value == 0)


def _multiple(count: float, item: Expression) -> Expression:
    return item if count == 1 else Constant(count) * item


def squared(parts: Iterable[Expression]) -> Expression:
    """The sum of squares, without a minus before what is squared."""
    kept = (terms_of(part) for part in parts)
    bare = (terms[0][1] if len(terms) == 1 else Total(tuple(terms)) for terms in kept)
    return summed((1, part**2) for part in bare if part != Constant(0.0))
