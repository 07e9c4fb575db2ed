"""Sums of angles and lengths, simplified as by hand."""

from __future__ import annotations

import pytest

from variantgen.algebra.expression import Constant, Times, Total, Value
from variantgen.algebra.name import Name
from variantgen.algebra.normal_form import positive, summed
from variantgen.methods.geometry.angles import AngleForm, between, normal_angle
from variantgen.methods.geometry.legs import Leg, collected
from variantgen.methods.geometry.lines import Lines


def length(symbol: str, number: float) -> Value:
    return Value(Name("parameter", symbol), "length", number)


R, S = length("R", 5.0), length("r", 2.0)
PHI = AngleForm((("phi", 1.0),))


def test_opposite_terms_cancel() -> None:
    assert summed(((1, R + S), (-1, S))) is R


def test_equal_terms_are_counted() -> None:
    assert summed(((1, R), (1, R))) == Times((Constant(2.0), R))


def test_positive_terms_come_first() -> None:
    assert summed(((-1, S), (1, R))) == Total(((1, R), (-1, S)))


def test_nothing_is_zero() -> None:
    assert summed(((1, R), (-1, R))) == Constant(0.0)


@pytest.mark.parametrize(("item", "sign", "number"), [(R - S, 1, 3.0), (S - R, -1, 3.0), (-R, -1, 5.0)])
def test_a_magnitude_without_bars(item: Total, sign: int, number: float) -> None:
    found, magnitude = positive(item)
    assert (found, magnitude.number(True)) == (sign, number)


def test_legs_along_a_line_are_added() -> None:
    legs = [Leg(R, PHI), Leg(S, PHI.turned(180.0)), Leg(S, AngleForm((), 90.0))]
    assert [(leg.length.number(True), leg.form) for leg in collected(legs, 1e-9)] == [
        (3.0, PHI),
        (2.0, AngleForm((), 90.0)),
    ]


def test_a_leg_that_leads_back_is_turned() -> None:
    (leg,) = collected([Leg(S, PHI), Leg(R, PHI.turned(-180.0))], 1e-9)
    assert (leg.length.number(True), leg.form) == (3.0, PHI.turned(180.0))


def test_a_way_there_and_back_is_nothing() -> None:
    assert not collected([Leg(R, PHI), Leg(R, PHI.turned(180.0))], 1e-9)


def test_angles_that_cancel_leave_a_number() -> None:
    assert PHI.turned(30.0).minus(PHI.turned(10.0)) == AngleForm((), 20.0)


@pytest.mark.parametrize(("angle", "normal"), [(190.0, -170.0), (-180.0, 180.0), (720.0, 0.0), (180.0, 180.0)])
def test_angles_lie_between_minus_and_plus_180(angle: float, normal: float) -> None:
    assert normal_angle(angle) == normal


def test_the_angle_between_two_rays() -> None:
    assert between(170.0, -170.0) == 20.0


def test_a_line_through_three_points_knows_its_two_ways() -> None:
    lines = Lines({"A": 0j, "B": 1j, "C": 3j, "D": 1 + 0j}, 1e-9, lambda form: 90.0)
    lines.add("A", "B", PHI)
    lines.add("C", "B", PHI.turned(180.0))
    assert lines.form("A", "C") == PHI
    assert lines.form("C", "A") == PHI.turned(180.0)
    assert lines.form("A", "D") is None


def test_the_sign_of_a_factor_is_the_sign_of_the_product() -> None:
    assert summed(((1, R), (-1, Times((-S, R))))) == Total(((1, R), (1, Times((S, R)))))
