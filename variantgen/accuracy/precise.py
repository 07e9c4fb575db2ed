"""Numbers of many digits, by the optional package mpmath (gmpy2, where installed, makes it several times faster)."""

from __future__ import annotations

import cmath
from collections.abc import Iterator
from contextlib import contextmanager
from typing import Any

import numpy as np

from variantgen.errors import missing_package

DIGITS = 80  # carried; at least 50 are left where a case loses 30 of them


def mpmath() -> Any:
    """The package mpmath. Raises ToolMissingError where it is not installed."""
    try:
        import mpmath as package
    except ImportError:
        raise missing_package("the reference needs", "mpmath", "accuracy") from None
    return package


@contextmanager
def many_digits(digits: int = DIGITS) -> Iterator[Any]:
    """The package mpmath with so many decimal digits inside the block."""
    package = mpmath()
    with package.workdps(digits):
        yield package


def unit_vector(angle: Any) -> Any:
    """``exp(i angle)`` of a number of many digits, or of a double."""
    return cmath.rect(1.0, angle) if isinstance(angle, float) else mpmath().expj(angle)


def exact_number(x: Any) -> Any:
    """A double (or extended double, or complex number) as the number of many digits that it is exactly."""
    package = mpmath()
    value: Any = np.asarray(x)[()]
    if isinstance(value, complex | np.complexfloating):
        return package.mpc(_exact_real(value.real), _exact_real(value.imag))
    return _exact_real(value)


def _exact_real(x: Any) -> Any:
    """A real number; what a double cannot hold of an extended double is added."""
    package = mpmath()
    head = float(x)
    rest = float(x - type(x)(head)) if isinstance(x, np.longdouble) and np.isfinite(head) else 0.0
    return package.mpf(head) + package.mpf(rest)
