"""The speed ``omega r`` of a point in rotation, or its tangential acceleration ``epsilon r``, from first quantities.

A rate that was found as ``v_A / AP`` leads to ``v_B = v_A BP / AP``: a ratio of lengths, and no rounded rate between
two numbers that a reader has. At the same distance the speed is the same one, whatever the rate. A rate that is given,
or that the printed digits show in full, is simply multiplied.
"""

from __future__ import annotations

from variantgen.algebra.expression import PRINTED_DIGITS, Expression, Ratio, Value, rounded

_SAME = 1e-10  # relative difference of two numbers that are one, but for rounding of the arithmetic


def turning_speed(rate: Value, arm: Value) -> Expression:
    """The product of the magnitude of a rate and a distance, as an expression of what the rate was found from."""
    match rate.expression:
        case Ratio(Value() as speed, Value() as radius) if speed.measure in ("velocity", "acceleration"):
            if is_same(arm.exact, radius.exact):
                return speed
            if not is_same(rounded(rate.exact, PRINTED_DIGITS), rate.exact):
                return speed * arm / radius
    return rate * arm


def is_same(first: float, second: float) -> bool:
    """Whether two numbers are one, but for rounding."""
    return abs(first - second) <= _SAME * max(abs(first), abs(second))
