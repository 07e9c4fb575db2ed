"""Angles of a check as a reader knows them: with numbers chosen so that each relation is seen by hand."""

from __future__ import annotations

from math import cos, radians, sin

import pytest

from variantgen.algebra.expression import Applied, Constant, Expression, Total, Value
from variantgen.algebra.name import Name
from variantgen.methods.checks.known_angles import by_known_angles
from variantgen.methods.steps.step import Balance

FORCE = 10.0
P, A = 62.375, 21.684  # angles with lines: no hundredths


def angle(letter: str, degrees: float) -> Value:
    return Value(Name("angle", letter), "angle", degrees, Constant(degrees, "angle"))


KNOWN = (angle("P", P), angle("A", A), Value(Name("parameter", "phi"), "angle", 80.0))


def written(function: str, argument: Expression) -> tuple[int, str, list[float]]:
    """The sign of ``10 f(argument)`` by known angles, the function, and the angles of which its own is made."""
    size = Value(None, "velocity", FORCE)
    whole = size * Applied(function, argument)
    side = Value(None, "number", whole.number(True), whole)
    (found,) = by_known_angles([Balance(side, Value(None, "number", 1.0))], KNOWN)
    assert isinstance(found, Balance)
    item, sign = found.left.expression, 1
    if isinstance(item, Total):
        ((sign, item),) = item.terms
    assert item is not None
    applied = item.operands()[1]
    assert isinstance(applied, Applied)
    plain = {"cos": cos, "sin": sin}
    as_before = plain[function](radians(argument.number(True)))
    assert sign * plain[applied.function](radians(applied.argument.number(True))) == pytest.approx(as_before)
    terms = applied.argument.terms if isinstance(applied.argument, Total) else ((1, applied.argument),)
    return sign, applied.function, [s * term.number(True) for s, term in terms]


def sum_of(*numbers: float) -> Expression:
    return Total(tuple((1 if number >= 0 else -1, Constant(abs(number), "angle")) for number in numbers))


@pytest.mark.parametrize(
    ("function", "parts", "sign", "other", "angles"),
    [
        ("cos", (180, -60, -60), 1, "cos", [60]),  # data alone: the number
        ("sin", (60, 60), 1, "sin", [60]),
        ("cos", (60, 60), -1, "cos", [60]),
        ("sin", (180, -P), 1, "sin", [P]),  # a supplement
        ("cos", (180, -P), -1, "cos", [P]),
        ("sin", (90, -P), 1, "cos", [P]),  # a complement
        ("cos", (90, P), -1, "sin", [P]),
        ("sin", (80, A), 1, "sin", [80, A]),  # the sum and the difference of two
        ("cos", (180, -80, -A), -1, "cos", [80, A]),
        ("cos", (P, -A), 1, "cos", [P, -A]),
        ("sin", (90, -P, A), 1, "cos", [P, -A]),
        ("sin", (33.3333, 11), 1, "sin", [33.3333, 11]),  # no known one fits
    ],
)
def test_an_angle_of_a_check(
    function: str, parts: tuple[float, ...], sign: int, other: str, angles: list[float]
) -> None:
    assert written(function, sum_of(*parts)) == (sign, other, pytest.approx(angles))


def test_a_known_angle_stays_as_the_solution_has_it() -> None:
    """Also an obtuse one: the steps have written its cosine so."""
    obtuse = angle("B", 145.0)
    whole = Value(None, "velocity", FORCE) * Applied("cos", obtuse)
    side = Value(None, "number", whole.number(True), whole)
    (found,) = by_known_angles([Balance(side, side)], (*KNOWN, obtuse))
    assert isinstance(found, Balance)
    assert found.left.expression == whole
