"""When places are reached whose velocities are functions of them, against formulas of the time."""

from __future__ import annotations

from collections.abc import Callable

import numpy as np
import pytest
from numpy.typing import NDArray

from variantgen.mechanism.turn.timed_places import Chosen, Numbers, TimedPlaces

K: NDArray[np.float64] = np.linspace(0.5, 3.0, 40)
V: NDArray[np.float64] = np.linspace(4.0, 8.0, 40)[::-1]
ONE = np.ones_like(K)
InTime = Callable[[Numbers, Numbers, Numbers], Numbers]


def _ways(velocity: InTime, acceleration: InTime, first: float, last: float) -> TimedPlaces:
    """Velocity and acceleration by k, v and the place."""

    def rates(chosen: Chosen, s: Numbers) -> tuple[Numbers, Numbers]:
        return velocity(K[chosen], V[chosen], s), acceleration(K[chosen], V[chosen], s)

    return TimedPlaces(rates, first * ONE, last * ONE)


def _swing(k: Numbers, v: Numbers, s: Numbers) -> Numbers:
    return -(k**2) * s


@pytest.mark.parametrize(
    ("velocity", "acceleration", "ends", "duration", "place"),
    [
        pytest.param(  # a = -k v from v: s = v/k (1 - e^(-k t))
            lambda k, v, s: v - k * s,
            lambda k, v, s: -k * (v - k * s),
            (0.0, 1.0),
            -np.log1p(-K / V) / K,
            lambda k, v, t: -v / k * np.expm1(-k * t),
            id="slowed by its velocity",
        ),
        pytest.param(  # s = v/k sin kt
            lambda k, v, s: np.sqrt(v**2 - (k * s) ** 2),
            _swing,
            (0.0, 1.0),
            np.arcsin(K / V) / K,
            lambda k, v, t: v / k * np.sin(k * t),
            id="slowed by a spring",
        ),
        pytest.param(  # s = -cos kt
            lambda k, v, s: k * np.sqrt(1 - s * s),
            _swing,
            (-1.0, 0.5),
            np.arccos(-0.5) / K,
            lambda k, v, t: -np.cos(k * t),
            id="from rest",
        ),
        pytest.param(
            lambda k, v, s: k * np.sqrt(1 - s * s),
            _swing,
            (-1.0, 1.0),
            np.pi / K,
            lambda k, v, t: -np.cos(k * t),
            id="from rest to rest",
        ),
        pytest.param(  # s = cos(kt + 60 degrees)
            lambda k, v, s: -k * np.sqrt(1 - s * s),
            _swing,
            (0.5, -0.9),
            (np.arccos(-0.9) - np.pi / 3) / K,
            lambda k, v, t: np.cos(k * t + np.pi / 3),
            id="backwards",
        ),
        pytest.param(  # the uniform one, v^2 - 2 k s
            lambda k, v, s: np.sqrt(v**2 - 2 * k * s),
            lambda k, v, s: -k,
            (0.0, 1.0),
            (V - np.sqrt(V**2 - 2 * K)) / K,
            lambda k, v, t: v * t - k * t**2 / 2,
            id="uniformly slowed",
        ),
    ],
)
def test_the_time_of_a_place(
    velocity: InTime, acceleration: InTime, ends: tuple[float, float], duration: Numbers, place: InTime
) -> None:
    ways = _ways(velocity, acceleration, *ends)
    assert ways.end == pytest.approx(duration, rel=1e-12)
    shares = np.linspace(0.0, 1.0, 23)
    chosen, times = np.repeat(np.arange(K.size), 23), np.outer(duration, shares).ravel()
    assert ways.places(chosen, times) == pytest.approx(place(K[chosen], V[chosen], times), abs=1e-12)


def test_a_place_that_is_never_reached() -> None:
    """``v^2 = v_0^2 - k^2 s^2`` ends at ``s = v_0 / k``: 3 lies beyond for some of the variants."""
    ways = _ways(lambda k, v, s: np.sqrt(v**2 - (k * s) ** 2), _swing, 0.0, 3.0)
    reached = V / K > 3
    assert np.any(reached) and not np.all(reached)
    assert np.isfinite(ways.end).tolist() == reached.tolist()


def test_what_turns_back_is_followed() -> None:
    """``a = -k^2 s`` forwards from 0.5, to a place behind it: ``s = cos(kt - 60 degrees)`` comes to -0.5."""
    ways = _ways(lambda k, v, s: k * np.sqrt(1 - s * s), _swing, 0.5, -0.5)
    assert ways.end == pytest.approx(np.pi / K, rel=1e-9)
