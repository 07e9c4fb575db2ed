"""The arithmetic of family files: values, dimensions, refusals."""

from __future__ import annotations

import math
import pickle

import numpy as np
import pytest
from hypothesis import given
from hypothesis import strategies as st

from variantgen.errors import InputError
from variantgen.families.parameters.expressions import parse
from variantgen.families.parameters.units import UNITS, parse_value

DIMENSIONS = {"OA": (1, 0), "phi": (0, 0), "omega": (0, -1)}


@pytest.mark.parametrize(
    ("text", "value"),
    [
        ("2 + 3 * 4", 14),
        ("-OA * 2", -1.0),
        ("OA * cos(phi)", 0.5 * math.cos(0.3)),
        ("sqrt(OA**2 + (2*OA)**2)", 0.5 * math.sqrt(5)),
        ("180*deg - phi", math.pi - 0.3),
        ("min(OA, 30*cm)", 0.3),
        ("atan2(3, 4) / deg", math.degrees(math.atan2(3, 4))),
        ("abs(-OA)", 0.5),
        ("exp(-2 * phi) + ln(OA / (1 * cm))", math.exp(-0.6) + math.log(50)),
    ],
)
def test_values(text: str, value: float) -> None:
    assert parse(text).value({"OA": 0.5, "phi": 0.3}) == pytest.approx(value)


@pytest.mark.parametrize(
    "text", ["sqrt(-1.0)", "1 / 0", "1 / (OA - OA)", "acos(3)", "asin(-7)", "exp(1000)", "ln(0)", "ln(-1)"]
)
def test_no_value_is_nan_or_raises(text: str) -> None:
    assert np.all(np.isfinite(parse(text).value({"OA": np.array([1.0, 2.0])})))


@pytest.mark.parametrize(
    ("text", "dimension"),
    [
        ("OA", (1, 0)),
        ("OA * omega", (1, -1)),
        ("OA * omega**2", (1, -2)),
        ("OA / (2*OA)", (0, 0)),
        ("sqrt(OA * OA)", (1, 0)),
    ],
)
def test_dimensions(text: str, dimension: tuple[int, int]) -> None:
    assert parse(text).dimension(DIMENSIONS) == dimension


@pytest.mark.parametrize("text", ["OA + phi", "sin(OA)", "max(OA, omega)", "OA + omega * OA"])
def test_mixed_dimensions_are_refused(text: str) -> None:
    with pytest.raises(InputError):
        parse(text).dimension(DIMENSIONS)


@pytest.mark.parametrize(
    "text",
    [
        "__import__('os')", "().__class__", "OA.real", "[1][0]", "lambda: 1", "'a'", "True", "1 if OA else 2", "OA < 1",
        "9**9**9", "2**99", "1e400", "x := 3", "f(1)", "sin()", "sin(1, 2)", "sin(x=1)", "{1}", "1;2", "", "a" * 500,
        "(" * 150 + ")" * 150, "1 +", "10**8**8", "*OA", "OA OA",
    ],
)  # fmt: skip
def test_everything_else_is_refused(text: str) -> None:
    with pytest.raises(InputError):
        parse(text)


@given(st.text(max_size=60))
def test_arbitrary_text_is_refused_or_evaluated_but_never_crashes(text: str) -> None:
    try:
        expression = parse(text)
        value = expression.value(dict.fromkeys(expression.names, 0.5))
    except InputError as error:
        assert error.problems[0].message
    else:
        assert isinstance(value, float | int), value


@pytest.mark.parametrize(
    "text", ["-" * 198 + "OA", "(" * 60 + "OA" + ")" * 60, "sin(" * 39 + "OA" + ")" * 39, "OA" + "+OA" * 66]
)
def test_deeply_nested_expressions_reach_other_processes(text: str) -> None:
    expression = pickle.loads(pickle.dumps(parse(text)))
    assert expression.text == text
    assert expression.value({"OA": 0.5}) == pytest.approx(eval(text, {"OA": 0.5, "sin": math.sin}))


def test_units_convert_exactly() -> None:
    from decimal import Decimal

    assert UNITS["cm"].to_si(Decimal("37")) == 0.37
    assert UNITS["deg"].to_si(Decimal("180")) == pytest.approx(math.pi)
    assert UNITS["rpm"].to_si(Decimal("30")) == pytest.approx(math.pi)
    assert parse_value("0.3 m", UNITS["cm"], "OA") == 30
    with pytest.raises(InputError, match="measures angle, length is due"):
        parse_value("30 deg", UNITS["cm"], "OA")
    with pytest.raises(InputError, match="unknown unit"):
        parse_value("30 kg", UNITS["cm"], "OA")
