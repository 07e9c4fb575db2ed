"""Antiderivatives, against the quadrature of mpmath."""

from __future__ import annotations

import mpmath
import pytest

from variantgen.algebra.antiderivative import antiderivative
from variantgen.families.parameters.expressions import FamilyExpression, parse

_DATA = {"k": 0.7, "c": 1.3}
_KNOWN = [
    ("3*t^2 - 2*t + 5", lambda t: 3 * t**2 - 2 * t + 5),
    ("(t - 2)^3 * (1 + t)", lambda t: (t - 2) ** 3 * (1 + t)),
    ("(2*t - t^2) / 4", lambda t: (2 * t - t**2) / 4),
    ("c * (1 - exp(-k*t))", lambda t: 1.3 * (1 - mpmath.exp(-0.7 * t))),
    ("4 * sin(3*t + 0.5) - cos(2*t)", lambda t: 4 * mpmath.sin(3 * t + 0.5) - mpmath.cos(2 * t)),
    ("t^2 * exp(-2*t)", lambda t: t**2 * mpmath.exp(-2 * t)),
    ("5 * t * cos(k*t)", lambda t: 5 * t * mpmath.cos(0.7 * t)),
    ("60 / (1 + 2*t)", lambda t: 60 / (1 + 2 * t)),
    ("60 / (1 + 2*t)^2", lambda t: 60 / (1 + 2 * t) ** 2),
    ("3 * sqrt(4 + t)", lambda t: 3 * mpmath.sqrt(4 + t)),
    ("3 / sqrt(4 + t)", lambda t: 3 / mpmath.sqrt(4 + t)),
    ("c", lambda t: 1.3),
]


@pytest.mark.parametrize(("text", "function"), _KNOWN, ids=[text for text, _ in _KNOWN])
def test_its_change_is_the_integral(text: str, function) -> None:
    tree = antiderivative(parse(text).tree, "t")
    assert tree is not None
    found = FamilyExpression(text, tree)
    change = found.value(_DATA | {"t": 2.5}) - found.value(_DATA | {"t": 0.4})
    assert change == pytest.approx(float(mpmath.quad(function, [0.4, 2.5])), rel=1e-12)


def test_zero_stays_zero() -> None:
    assert antiderivative(parse("0*t").tree, "t") is None


@pytest.mark.parametrize(
    "text", ["sin(t)^2", "exp(t^2)", "1 / (1 + t^2)", "sin(t) * exp(t)", "sqrt(1 + t^2)", "tan(t)"]
)
def test_what_the_rules_do_not_know_is_said(text: str) -> None:
    with pytest.raises(LookupError):
        antiderivative(parse(text).tree, "t")
