"""Values of the form (p/q) sqrt(n) beside their decimals: ``v_B = 40 sqrt(3)/3 = 23.09 cm/s``."""

from __future__ import annotations

from variantgen.mechanism.closed_form import closed_form
from variantgen.wording.formula import Equation, Relation, Surd
from variantgen.wording.language import ANSWER_DIGITS

_THIRDS = 100  # smallest numerator of a fraction that is no help beside its decimal
_ROOT, _RADICAND = 4, 7  # largest denominator of a root, largest number under it


def surd(value: float) -> Surd | None:
    """The root or fraction that a computed value is (see :mod:`variantgen.mechanism.closed_form`), or None.

    None also where a root or fraction tells nothing new: zero, and decimals of no more digits than are printed
    (0.25 and 120 are none, 4/3 is), and for forms that help nobody: 825/4, 84 sqrt(41)/5.
    """
    found = closed_form(value)
    if (
        found is None
        or not _is_simple(*found)
        or (found[2] == 1 and float(f"{value:.{ANSWER_DIGITS - 1}e}") == found[0] / found[1])
    ):
        return None
    return Surd(*found)


def _is_simple(numerator: int, denominator: int, radicand: int) -> bool:
    """Whether a root or fraction is one that a reader would write: 4/3 and 6 sqrt(5), but not 400/3 or sqrt(194)/26."""
    if radicand == 1:
        return denominator == 3 and abs(numerator) < _THIRDS
    return denominator <= _ROOT and radicand <= _RADICAND


def with_surd(equation: Equation, exact: Surd | None) -> Equation | Relation:
    """``symbol = value``, with the exact form before the rounded value if there is one."""
    if exact is None:
        return equation
    return Relation((equation.left, exact, equation.right), ("=", "≈"))
