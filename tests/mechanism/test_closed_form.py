"""Roots and fractions among computed numbers: found when they are there, hardly ever when they are not."""

from __future__ import annotations

import math
import timeit
from fractions import Fraction
from itertools import pairwise

import mpmath
import numpy as np
import pytest
from hypothesis import given
from hypothesis import strategies as st

from variantgen.mechanism.solving.closed_form import (
    MOST_DENOMINATOR,
    MOST_NUMERATOR,
    MOST_PRODUCT,
    MOST_RADICAND,
    TOLERANCE,
    closed_form,
    is_simple,
    root_of_fraction,
    square_fractions,
)

SQUARE_FREE = [n for n in range(1, MOST_RADICAND + 1) if all(n % (k * k) for k in range(2, 23))]


@pytest.mark.parametrize(
    ("value", "expected"),
    [
        (23.094010767585030580, (40, 3, 3)),  # 40 sqrt(3) / 3
        (-1.1180339887498948482, (-1, 2, 5)),
        (124.89995996796796, (20, 1, 39)),
        (1.3333333333333333, (4, 3, 1)),
        (0.25, (1, 4, 1)),
        (-120.0, (-120, 1, 1)),
        (0.60621778264910705, (7, 20, 3)),  # 0.35 sqrt(3)
        (1 / 60, (1, 60, 1)),
        (5000.0, (5000, 1, 1)),
    ],
)
def test_values_worked_by_hand(value: float, expected: tuple[int, int, int]) -> None:
    assert closed_form(value) == expected


@pytest.mark.parametrize(
    "value",
    [
        0.0,
        math.inf,
        -math.inf,
        math.nan,
        1e300,
        1e-300,
        math.pi,
        math.e,
        math.pi * math.sqrt(3),
        (1 + math.sqrt(5)) / 2,  # not of this form
        math.sqrt(2) + math.sqrt(3),
        23.094,  # a rounded 40 sqrt(3) / 3
        1 / 61,  # beyond the bounds
        5001.0,
        math.sqrt(503),
        4999 * math.sqrt(499) / 59,
    ],
)
def test_what_is_none(value: float) -> None:
    assert closed_form(value) is None


@st.composite
def triples(draw: st.DrawFn) -> tuple[int, int, int]:
    """Whole numbers (p, q, n) within the bounds, p and q without a common divisor."""
    n = draw(st.sampled_from(SQUARE_FREE))
    q = draw(st.integers(1, min(MOST_DENOMINATOR, MOST_PRODUCT // n)))
    p = draw(st.integers(1, min(MOST_NUMERATOR, MOST_PRODUCT // (q * n))))
    return p // math.gcd(p, q), q // math.gcd(p, q), n


@given(triples(), st.floats(-0.9, 0.9))
def test_every_triple_is_found_from_a_value_near_it(triple: tuple[int, int, int], off: float) -> None:
    p, q, n = triple
    with mpmath.workdps(40):
        value = float(mpmath.mpf(p) / q * mpmath.sqrt(n) * (1 + off * mpmath.mpf(TOLERANCE)))
    assert closed_form(value) == (p, q, n)
    assert closed_form(-value) == (-p, q, n)
    top, under = square_fractions(np.array([value, 0.0, np.pi, value]))
    assert root_of_fraction(int(top[0]), int(under[0])) == (p, q, n)
    assert (top[1], top[0], under[0]) == (0, top[3], under[3])


@given(triples(), st.sampled_from([-1, 1]), st.floats(1.2, 50))
def test_a_value_beyond_the_tolerance_is_not_taken(triple: tuple[int, int, int], sign: int, off: float) -> None:
    p, q, n = triple
    value = p / q * math.sqrt(n) * (1 + sign * off * TOLERANCE)
    assert closed_form(value) != (p, q, n)


@given(st.floats(allow_nan=True, allow_infinity=True))
def test_any_number_is_answered_and_the_batch_agrees(value: float) -> None:
    found = closed_form(value)
    with np.errstate(over="ignore"):
        top, under = square_fractions(np.array([value]))
    of_batch = root_of_fraction(int(top[0]), int(under[0]))
    assert of_batch == (found and (abs(found[0]), *found[1:]))
    if found is not None:
        p, q, n = found
        assert p / q * math.sqrt(n) == pytest.approx(value, rel=1.1 * TOLERANCE)


@given(st.floats(-2, 4))
def test_the_batch_agrees_on_ordinary_numbers(exponent: float) -> None:
    values = 10**exponent * np.array([1.0, math.sqrt(2), 1 / 3, math.pi])
    found = [root_of_fraction(int(a), int(b)) for a, b in zip(*square_fractions(values), strict=True)]
    assert found == [closed_form(float(value)) for value in values]


def logarithms() -> np.ndarray:
    """Of all numbers that can be taken for roots, sorted; counted straight from the bounds."""
    found = []
    for n in SQUARE_FREE:
        for q in range(1, MOST_DENOMINATOR + 1):
            p = np.arange(1, min(MOST_NUMERATOR, MOST_PRODUCT // (q * n)) + 1)
            found.append(np.log10(p[np.gcd(p, q) == 1] / q * math.sqrt(n)))
    return np.sort(np.concatenate(found))


def test_a_number_that_is_no_root_is_hardly_ever_taken_for_one() -> None:
    # A number spread evenly (by its logarithm) over a decade is within the tolerance of one of the roots in it with
    # the probability 2 T / ln(10) times their number.
    logs = logarithms()
    in_decade = np.searchsorted(logs, logs + 1) - np.arange(logs.size)
    probability = int(np.max(in_decade)) * 2 * TOLERANCE / math.log(10)
    assert 1e-7 < probability < 2e-7
    rng = np.random.default_rng(7)
    assert [v for v in (10 ** rng.uniform(-1, 3, 20_000)).tolist() if closed_form(v)] == []


def test_roots_stay_apart_by_more_than_the_tolerance() -> None:
    # Else one number could have two forms: squares are fractions of a height up to MOST_PRODUCT^2.
    logs = logarithms()
    nearest = min(b - a for a, b in pairwise(logs.tolist())) * math.log(10)
    assert nearest > 10 * TOLERANCE


@given(triples())
def test_root_of_a_fraction_in_lowest_terms(triple: tuple[int, int, int]) -> None:
    p, q, n = triple
    square = Fraction(p * p * n, q * q)
    assert root_of_fraction(square.numerator, square.denominator) == triple


@pytest.mark.parametrize(("numerator", "denominator"), [(0, 0), (0, 1), (503, 1), (5001**2, 1), (1, 61**2), (6007, 2)])
def test_fractions_beyond_the_bounds_have_none(numerator: int, denominator: int) -> None:
    assert root_of_fraction(numerator, denominator) is None


def test_a_miss_costs_little() -> None:
    values = (10 ** np.random.default_rng(3).uniform(-1, 3, 2000)).tolist()
    seconds = min(timeit.repeat(lambda: [closed_form(value) for value in values], number=1, repeat=7))
    assert seconds / len(values) < 20e-6


@pytest.mark.parametrize(
    ("form", "simple"),
    [
        ((40, 3, 3), True),
        ((-120, 1, 3), True),
        ((1200, 1, 2), True),
        ((99, 4, 7), True),
        ((101, 4, 7), False),
        ((135, 1, 3), False),
        ((1, 1, 11), False),
        ((1, 5, 2), False),
        ((4, 3, 1), True),
        ((400, 3, 1), False),
        ((3, 4, 1), False),
        ((7, 1, 1), False),
    ],
)
def test_what_a_reader_takes_for_simple(form: tuple[int, int, int], simple: bool) -> None:
    assert is_simple(*form) is simple
