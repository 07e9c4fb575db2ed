"""Derivatives and linear forms of expressions against hand calculation."""

from __future__ import annotations

import gc
import math

import numpy as np
import pytest

from variantgen.algebra import python_source
from variantgen.algebra.derivative import derivative
from variantgen.algebra.expression import (
    Applied,
    Constant,
    Expression,
    Magnitude,
    Pi,
    Raised,
    Ratio,
    SquareRoot,
    Times,
    Total,
    Value,
    Variable,
    cos,
    sin,
)
from variantgen.algebra.linear import linear, reduced
from variantgen.algebra.name import Name
from variantgen.algebra.normal_form import added, product, simplified
from variantgen.algebra.substitution import pruned, substituted
from variantgen.algebra.values import in_order


def value(name: str, number: float, measure: str = "length") -> Value:
    return Value(Name("parameter", name), measure, number)


R, X, Y = value("r", 3.0), value("x", 2.0), value("y", -5.0)
X_RATE, Y_RATE = value("vx", 7.0), value("vy", 11.0)
PHI, OMEGA = value("phi", 30.0, "angle"), value("omega", 4.0, "angular velocity")
RATES: dict[Value, Expression | None] = {X: X_RATE, Y: Y_RATE, PHI: OMEGA}


def number(item: Expression | None) -> float:
    assert item is not None
    return item.number(True)


@pytest.mark.parametrize(
    ("item", "wanted"),
    [
        (X * Y, 7 * -5 + 2 * 11),
        (X**2 + Y**2, 2 * 2 * 7 + 2 * -5 * 11),
        (X**3, 3 * 4 * 7),
        (R * cos(PHI), -3 * 4 * 0.5),
        (R * sin(PHI), 3 * 4 * math.sqrt(3) / 2),
        (X * sin(PHI), 7 * 0.5 + 2 * 4 * math.sqrt(3) / 2),
        (sin(Constant(2.0) * PHI), 2 * 4 * 0.5),
        (X / R, 7 / 3),
        (X / Y, (7 * -5 - 2 * 11) / 25),
        (SquareRoot(X**2 + Y**2), (2 * 7 - 5 * 11) / math.sqrt(29)),
        (R - X, -7),
        (Applied("tan", PHI), 4 * 4 / 3),
        (Applied("arcsin", X / R), 7 / 3 / math.sqrt(1 - 4 / 9)),
        (Applied("arccos", X / R), -7 / 3 / math.sqrt(1 - 4 / 9)),
        (Applied("arctan", X), 7 / 5),
        (X**1, 7),
        (Magnitude(R) * X, 3 * 7),
    ],
)
def test_derivatives_by_hand(item: Expression, wanted: float) -> None:
    assert number(derivative(item, RATES)) == pytest.approx(wanted, rel=1e-14)


def test_what_does_not_change_has_no_derivative() -> None:
    assert derivative(R * cos(Constant(20.0, "angle")), RATES) is None


def test_an_absolute_value_has_no_derivative() -> None:
    with pytest.raises(TypeError):
        derivative(Magnitude(X), RATES)


def test_second_derivative_of_a_circle_has_the_normal_term_once() -> None:
    acceleration = value("epsilon", 0.5)
    first = derivative(R * cos(PHI), RATES)
    assert first is not None
    second = derivative(first, {**RATES, OMEGA: acceleration})
    assert second == Total(((-1, R * OMEGA**2 * cos(PHI)), (-1, R * acceleration * sin(PHI)))) or second == Total(
        ((-1, R * acceleration * sin(PHI)), (-1, R * OMEGA**2 * cos(PHI)))
    )
    assert number(second) == pytest.approx(-3 * 16 * math.sqrt(3) / 2 - 3 * 0.5 * 0.5)


def test_by_one_of_its_names() -> None:
    t, k = Variable("t"), Variable("k")
    assert derivative(k * t**3, {t: Constant(1.0)}) == Constant(3.0) * k * t**2
    assert derivative(k**2, {t: Constant(1.0)}) is None


def test_a_product_of_fractions_is_one_fraction() -> None:
    assert simplified(X * (Constant(2.0) * Y) * Constant(2.0) / Constant(2.0) ** 2) == X * Y
    assert simplified(-(X / Y) * (Y / R)) == Total(((-1, Ratio(X, R)),))
    assert simplified(X * Y / Constant(4.0)) == Ratio(X * Y, Constant(4.0))


def test_like_terms_are_put_together() -> None:
    assert added((1, X * Y), (1, Constant(2.0) * X * Y)) == Constant(3.0) * X * Y
    assert added((1, X), (-1, X)) is None
    assert added((-1, X), (1, Y)) == Total(((1, Y), (-1, X)))


def test_signs_and_numbers_come_to_the_front() -> None:
    assert product(-X, Constant(2.0), -Y) == Constant(2.0) * X * Y
    assert product(X, None) is None
    assert product(X, X) == Raised(X, 2)
    assert product(Total(((-1, X), (-1, Y))), R) == Total(((-1, (X + Y) * R),))


def test_a_common_number_is_divided_out() -> None:
    left, right = reduced(Constant(2.0) * X * Y, Constant(2.0) * R)
    assert (left, right) == (X * Y, R)
    assert reduced(Constant(2.0) * X, R) == (Constant(2.0) * X, R)


def test_linear_form() -> None:
    found, rest = linear((X - R) * (X_RATE - Y_RATE) + R * X_RATE, [X_RATE])
    assert number(found[X_RATE]) == pytest.approx((2 - 3) + 3)
    assert number(rest) == pytest.approx((2 - 3) * -11)
    assert linear(Ratio(X_RATE, R), [X_RATE])[0] == {X_RATE: Ratio(Constant(1.0), R)}


def test_a_square_of_an_unknown_is_not_linear() -> None:
    with pytest.raises(TypeError):
        linear(X_RATE**2, [X_RATE])


def test_zero_values_and_replaced_ones() -> None:
    zero = value("zero", 0.0)
    assert pruned(X * zero + Y * R) == Y * R
    assert pruned(zero**2) is None
    assert substituted(X * cos(PHI), {X: R * Y}) == R * Y * cos(PHI)


@pytest.mark.parametrize(
    ("value", "measure", "text"),
    [
        (42.99999999999999, "length", "43"),
        (0.1 + 0.2, "length", "0.3"),
        (1 / 3, "length", "0.3333333333333"),
        (0.0, "length", "0"),
        (59.99999999999999, "angle", "np.radians(60)"),
    ],
)
def test_a_program_has_no_rounding_of_the_machine(value: float, measure: str, text: str) -> None:
    assert python_source.number(value, measure) == text


def test_angles_in_degrees_are_converted_in_a_program() -> None:
    """Variables of angles are in radians: ``pi phi / 180`` and ``sin(540 t / pi)`` of a formula are, too."""
    phi, time = Value(Name("parameter", "phi"), "angle", 60.0), Value(Name("parameter", "t"), "time", 0.3)
    names = {phi: "phi", time: "t"}
    way = Ratio(Times((Pi(), Constant(4.0), phi)), Constant(180.0)) * cos(phi)
    swing = sin(Total(((1, Ratio(Times((Constant(540.0), time)), Pi())), (1, Constant(90.0, "angle")), (1, phi))))
    known = {"np": np, "phi": math.pi / 3, "t": 0.3}
    assert eval(python_source.written(way, names), known) == pytest.approx(4 * math.pi / 3 * 0.5)
    assert eval(python_source.written(swing, names), known) == pytest.approx(math.cos(0.9 + math.pi / 3))
    assert eval(python_source.written(Times((Constant(2.0), phi)), names), known) == pytest.approx(2 * math.pi / 3)


def test_values_come_after_what_they_are_computed_from() -> None:
    """Each once, without what is known, and nothing is left that only the search for garbage finds."""
    first = Value(Name("parameter", "p"), "length", 5.0, X - Y)
    second = Value(Name("parameter", "q"), "length", 10.0, first + R + X)
    gc.collect()
    gc.disable()
    try:
        assert in_order([second, X]) == [X, Y, first, R, second]
        assert in_order([second], known={first, R}) == [X, second]
        assert gc.collect() == 0
    finally:
        gc.enable()
