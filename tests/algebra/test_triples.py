"""Right triangles with whole sides: which angles are theirs, and that their functions are printed as fractions."""

from __future__ import annotations

import math

import pytest

from variantgen.algebra.expression import Applied, Constant, Ratio, Value, cos, sin
from variantgen.algebra.name import Name
from variantgen.algebra.triples import ratio
from variantgen.outputs.single.explanation import explain
from variantgen.single import one_variant

PSI = math.degrees(math.atan(3 / 4))


@pytest.mark.parametrize(
    ("function", "degrees", "expected"),
    [
        ("cos", PSI, (4, 5)),
        ("sin", PSI, (3, 5)),
        ("tan", PSI, (3, 4)),
        ("tan", 90.0 - PSI, (4, 3)),
        ("cos", math.degrees(math.acos(12 / 13)), (12, 13)),
        ("sin", math.degrees(math.asin(8 / 17)), (8, 17)),
        ("cos", math.degrees(math.atan(24 / 7)), (7, 25)),
        ("cos", 36.87, None),  # an angle that is given to a hundredth
        ("cos", 60.0, None),
        ("cos", 180.0 - PSI, None),
        ("arctan", 0.75, None),
    ],
)
def test_functions_that_are_ratios_of_sides(function: str, degrees: float, expected: tuple[int, int] | None) -> None:
    assert ratio(function, degrees) == expected


def test_every_whole_or_printed_angle_is_none() -> None:
    assert not any(ratio(function, i / 100) for function in ("cos", "sin", "tan") for i in range(9000))


def test_printed_numbers_lead_to_the_exact_product() -> None:
    angle = Value(Name("angle", "A", "B O"), "angle", PSI, Applied("arctan", Ratio(Constant(3.0), Constant(4.0))))
    angle.round_to(4)
    assert angle.shown == 36.87
    assert (Constant(1210.0) * cos(angle)).number(exact=False) == 968.0
    assert (Constant(50.0) * sin(angle)).number(exact=False) == 30.0


def test_a_solution_computes_with_the_fractions() -> None:
    # The crank is across the guide: A is 50 - 40 = 10 cm from it, AB = 26 cm, so that B is 24 cm below A.
    data = {"OA": 40, "OC": 22, "AB": 26, "h": 50, "phi": 90, "omega_OA": 5.5, "epsilon_OA": 3}
    text = str(explain(one_variant("sleeve_on_crank", data, seed="146"), language="en"))
    text = text.replace("\N{NO-BREAK SPACE}", " ")
    assert "arcsin((50 − 40) / 26) = 22.62°" in text
    assert "a_B cos ψ = (a_A)_n sin ψ + (a_A)_t cos ψ" in text
    # 1210 * 5 + 120 * 12 = 7490, over 12: 624.2.
    assert "a_B = (1210 · 5/13 + 120 · 12/13) / (12/13) = 624.2 cm/s²" in text
