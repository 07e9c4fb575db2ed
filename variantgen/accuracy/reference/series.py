"""Truncated power series in time over numbers of many digits: ``x(t) = x0 + x1 t + x2 t^2 + ...``.

The residuals of joints and drivers are written with numpy; numpy calls the method of the same name of a number that is
none of its own (``np.cos(x)`` is ``x.cos()``), so that they can be evaluated on series as they stand. Then the
coefficients of the residual are its derivatives over ``k!``, exact to the digits carried.
"""

from __future__ import annotations

from typing import Any

from variantgen.accuracy.precise import exact_number, mpmath


class Series:
    """A series of few terms; one term alone is a constant. Numbers are real or complex."""

    __slots__ = ("terms",)

    def __init__(self, terms: tuple[Any, ...]) -> None:
        self.terms = terms

    @property
    def value(self) -> Any:
        """The value at time zero."""
        return self.terms[0]

    def term(self, order: int) -> Any:
        """The coefficient of ``t^order``."""
        return self.terms[order] if order < len(self.terms) else mpmath().mpf(0)

    def _padded(self, count: int) -> tuple[Any, ...]:
        return self.terms + (mpmath().mpf(0),) * (count - len(self.terms))

    @property
    def real(self) -> Series:
        """Real part."""
        return Series(tuple(x.real for x in self.terms))

    @property
    def imag(self) -> Series:
        """Imaginary part."""
        return Series(tuple(x.imag for x in self.terms))

    def conjugate(self) -> Series:
        """Complex conjugate."""
        return Series(tuple(x.conjugate() for x in self.terms))

    def __add__(self, other: Any) -> Series:
        a, b = self.terms, series(other).terms
        count = max(len(a), len(b))
        if len(a) == len(b):
            return Series(tuple(x + y for x, y in zip(a, b, strict=True)))
        short, long = sorted((a, b), key=len)
        return Series(tuple(x + y for x, y in zip(short, long, strict=False)) + long[len(short) : count])

    __radd__ = __add__

    def __neg__(self) -> Series:
        return Series(tuple(-x for x in self.terms))

    def __sub__(self, other: Any) -> Series:
        return self + (-series(other))

    def __rsub__(self, other: Any) -> Series:
        return series(other) + (-self)

    def __mul__(self, other: Any) -> Series:
        a, b = self.terms, series(other).terms
        if len(a) == 1:
            return Series(tuple(a[0] * y for y in b))
        if len(b) == 1:
            return Series(tuple(x * b[0] for x in a))
        count = max(len(a), len(b))
        a, b = self._padded(count), series(other)._padded(count)
        return Series(tuple(sum(a[k] * b[n - k] for k in range(n + 1)) for n in range(count)))

    __rmul__ = __mul__

    def __truediv__(self, other: Any) -> Series:
        divisor = series(other)
        if len(divisor.terms) == 1:
            return Series(tuple(x / divisor.value for x in self.terms))
        count = max(len(self.terms), len(divisor.terms))
        a, b = self._padded(count), divisor._padded(count)
        found: list[Any] = []
        for n in range(count):
            found.append((a[n] - sum(b[k] * found[n - k] for k in range(1, n + 1))) / b[0])
        return Series(tuple(found))

    def __rtruediv__(self, other: Any) -> Series:
        return series(other) / self

    def __pow__(self, power: int) -> Series:
        found = series(1)
        for _ in range(power):
            found = found * self
        return found

    def sqrt(self) -> Series:
        """Square root; the value must not be zero, unless the series is a constant."""
        a = self.terms
        found = [mpmath().sqrt(a[0])]
        for n in range(1, len(a)):
            found.append((a[n] - sum(found[k] * found[n - k] for k in range(1, n))) / (2 * found[0]))
        return Series(tuple(found))

    def exp(self) -> Series:
        """Exponential function: ``n e_n = sum k a_k e_(n-k)``."""
        a = self.terms
        found = [mpmath().exp(a[0])]
        for n in range(1, len(a)):
            found.append(sum(k * a[k] * found[n - k] for k in range(1, n + 1)) / n)
        return Series(tuple(found))

    def cos(self) -> Series:
        """Cosine of a real series."""
        return (1j * self).exp().real

    def sin(self) -> Series:
        """Sine of a real series."""
        return (1j * self).exp().imag

    def __abs__(self) -> Series:
        if len(self.terms) == 1:
            return Series((abs(self.value),))
        re, im = self.real, self.imag
        return (re * re + im * im).sqrt()

    def arctan2(self, other: Any) -> Series:
        """Angle of the vector (other, self): its derivative is ``(x y' - y x') / (x^2 + y^2)``."""
        x = series(other)
        count = max(len(self.terms), len(x.terms))
        first = mpmath().atan2(self.value, x.value)
        if count == 1:
            return Series((first,))
        y_all, x_all = Series(self._padded(count)), Series(x._padded(count))
        slope = (x_all * y_all.slope() - y_all * x_all.slope()) / (x_all * x_all + y_all * y_all)
        return Series((first, *(slope.terms[n - 1] / n for n in range(1, count))))

    def slope(self) -> Series:
        """Derivative by time, with one term less (the last one is kept as zero)."""
        return Series((*(n * x for n, x in enumerate(self.terms) if n), mpmath().mpf(0)))

    def __lt__(self, other: Any) -> bool:
        return bool(self.value < series(other).value)

    def __le__(self, other: Any) -> bool:
        return bool(self.value <= series(other).value)

    def __gt__(self, other: Any) -> bool:
        return bool(self.value > series(other).value)

    def __ge__(self, other: Any) -> bool:
        return bool(self.value >= series(other).value)

    def __repr__(self) -> str:
        return f"Series({', '.join(str(x) for x in self.terms)})"


def series(x: Any) -> Series:
    """A number as a constant series; a series as it is."""
    if isinstance(x, Series):
        return x
    package = mpmath()
    if isinstance(x, package.mpf | package.mpc):
        return Series((x,))
    return Series((exact_number(x),))
