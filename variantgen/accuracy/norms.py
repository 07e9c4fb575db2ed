"""Errors of a motion, normwise: the largest error of any point or body by the largest velocity or acceleration."""

from __future__ import annotations

from collections.abc import Mapping
from typing import Any, Protocol

from variantgen.accuracy.reference.motion import ExactMotion


class Tables(Protocol):
    """What is compared: numbers by point and by body, those of mpmath or such as it can subtract."""

    @property
    def z(self) -> Mapping[str, Any]:
        """Places (m)."""
        ...

    @property
    def v(self) -> Mapping[str, Any]:
        """Velocities (m/s)."""
        ...

    @property
    def a(self) -> Mapping[str, Any]:
        """Accelerations (m/s^2)."""
        ...

    @property
    def omega(self) -> Mapping[str, Any]:
        """Angular velocities (rad/s)."""
        ...

    @property
    def epsilon(self) -> Mapping[str, Any]:
        """Angular accelerations (rad/s^2)."""
        ...


def deviation(found: Tables, exact: ExactMotion) -> tuple[Any, Any, Any]:
    """Relative deviation of positions, velocities and accelerations from the exact ones, numbers of mpmath.

    Positions by the size of the mechanism; the others by the largest of all ``|v|`` and ``|omega| size`` (``|a|`` and
    ``|epsilon| size``). Where all accelerations vanish, by the square of that velocity over the size. What was not
    found (an order, a point) is not compared.
    """
    size, speed, acceleration = scales(exact)
    return (
        _worst(found.z, exact.z, {}, {}, exact.size) / size,
        _worst(found.v, exact.v, found.omega, exact.omega, exact.size) / speed,
        _worst(found.a, exact.a, found.epsilon, exact.epsilon, exact.size) / acceleration,
    )


def scales(exact: ExactMotion) -> tuple[Any, Any, Any]:
    """Size (m), largest velocity (m/s), largest acceleration (m/s^2); 1 where nothing moves."""
    speed = _largest(exact.v, exact.omega, exact.size)
    acceleration = _largest(exact.a, exact.epsilon, exact.size)
    return exact.size, speed or 1, acceleration or (speed**2 / exact.size if speed else 1)


def _largest(points: Mapping[str, Any], bodies: Mapping[str, Any], size: Any) -> Any:
    return max([*(abs(x) for x in points.values()), *(abs(x) * size for x in bodies.values())], default=0)


def _worst(
    points: Mapping[str, Any],
    exact_points: Mapping[str, Any],
    bodies: Mapping[str, Any],
    exact_bodies: Mapping[str, Any],
    size: Any,
) -> Any:
    """Largest deviation of a point, or of a body's rotation times the size."""
    gaps = [abs(points[name] - x) for name, x in exact_points.items() if name in points]
    gaps += [abs(bodies[name] - x) * size for name, x in exact_bodies.items() if name in bodies]
    return max(gaps, default=0)
