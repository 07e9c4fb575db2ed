"""The speed ``omega r`` of a point in rotation, or its tangential acceleration ``epsilon r``, from first quantities.

A rate that was found as ``v_A / AP`` leads to ``v_B = v_A BP / AP``: a ratio of lengths, and no rounded rate between
two numbers that a reader has. At the same distance the speed is the same one, whatever the rate. A rate that is given,
or that the printed digits show in full, is simply multiplied.
"""

from __future__ import annotations

from collections.abc import Mapping

from variantgen.algebra.decimals import PRINTED_DIGITS, rounded
from variantgen.algebra.expression import Ratio, Value
from variantgen.algebra.name import Name
from variantgen.methods.solution.book import Book, Known, Rate
from variantgen.methods.steps.step import Fact

_SAME = 1e-10  # relative difference of two numbers that are one, but for rounding of the arithmetic


def turning_speed(book: Book, name: Name, rate: Value, arm: Value) -> Value:
    """The product of the magnitude of a rate and a distance, with its line; the same vector is itself."""
    match rate.expression:
        case Ratio(Value() as speed, Value() as radius) if is_rounded(rate) and speed.measure == book.measure:
            if not is_same(arm.exact, radius.exact):
                return book.derive(name, book.measure, speed * arm / radius)
            return speed if speed.name == name else book.derive(name, book.measure, speed, law=rate * arm)
    return book.derive(name, book.measure, rate * arm)


def related(book: Book, body: str, centre: str, part: str) -> dict[str, Fact]:
    """The letters of ``v_O = omega r`` and ``a_O = epsilon r`` as the solution has them; ``part`` is that of a_O."""

    def rate(kind: str, known: Mapping[str, Rate]) -> Name:
        found = known.get(body)
        return found.size.name if found is not None and found.size.name is not None else Name(kind, body)

    def size(name: Name, known: Known) -> Name:
        return known[-1].name if known else name

    return {
        "velocity": size(Name("v", centre), book.velocity.get(centre, ())),
        "acceleration": size(Name("a", centre, part=part), book.acceleration.get(centre, ())),
        "omega": rate("omega", book.omega),
        "epsilon": rate("epsilon", book.epsilon),
    }


def is_rounded(value: Value) -> bool:
    """Whether a value is printed with fewer digits than it has."""
    return not is_same(rounded(value.exact, PRINTED_DIGITS, value.measure), value.exact)


def is_same(first: float, second: float) -> bool:
    """Whether two numbers are one, but for rounding."""
    return abs(first - second) <= _SAME * max(abs(first), abs(second))
