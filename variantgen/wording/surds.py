"""Values of the form (p/q) sqrt(n) beside their decimals: ``v_B = 40 sqrt(3)/3 = 23.09 cm/s``."""

from __future__ import annotations

from variantgen.mechanism.solving.closed_form import closed_form, is_simple
from variantgen.wording.formula import Equation, Relation, Surd


def surd(value: float) -> Surd | None:
    """The root or fraction that a computed value is (see :mod:`variantgen.mechanism.solving.closed_form`), or None.

    None also where a root or fraction tells nothing new (0.25, 120) and for forms that help nobody
    (825/4, 84 sqrt(41)/5): see :func:`variantgen.mechanism.solving.closed_form.is_simple`.
    """
    found = closed_form(value)
    return Surd(*found) if found and is_simple(*found) else None


def with_surd(equation: Equation, exact: Surd | None) -> Equation | Relation:
    """``symbol = value``, with the exact form before the rounded value if there is one."""
    if exact is None:
        return equation
    return Relation((equation.left, exact, equation.right), ("=", "≈"))
