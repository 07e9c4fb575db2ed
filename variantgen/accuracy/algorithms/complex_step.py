"""Differentiation of the closed form of the positions by complex steps of time.

Velocities ``Im x(i h)/h`` with a tiny h, without cancellation; accelerations of order four by Lai and Crassidis,
``Im(x(h sqrt(i)) + x(-h sqrt(i))) / h^2``.
"""

from __future__ import annotations

from collections.abc import Callable
from typing import Any

import numpy as np

from variantgen.accuracy.computed import CaseGroup, Computed, Textbook

TITLE = "complex steps of the closed form"
SHORT = "complex step"
DOUBLE = True
BATCH = 10_000

_TINY = 1e-30
_STEP = 3e-3  # balances truncation h^4 and rounding eps/h^2
_WAY = np.exp(0.25j * np.pi)


def applies(group: CaseGroup) -> str:
    """Where there is a closed form."""
    return "" if group.textbook else "no closed form in the textbooks"


def prepare(group: CaseGroup) -> Callable[[], Computed]:
    """Differentiates the coordinates."""
    textbook = group.textbook
    assert textbook is not None, "asked before"
    return lambda: _run(textbook)


def _run(textbook: Textbook) -> Computed:
    rate = textbook.rate()
    tiny, h = _TINY / rate, _STEP / rate
    near, after, before = (textbook.coordinates(t) for t in (1j * tiny, h * _WAY, -h * _WAY))
    z = {name: np.real(x) + 1j * np.real(y) for name, (x, y) in near.items()}
    v = {name: (np.imag(x) + 1j * np.imag(y)) / tiny for name, (x, y) in near.items()}
    a = {name: sum(np.imag(x) + 1j * np.imag(y) for x, y in (after[name], before[name])) / h**2 for name in near}
    omega, epsilon = {}, {}
    for link, (start, end) in textbook.links().items():
        ray, speed, change = (table[end] - table[start] for table in (z, v, a))
        square = np.abs(ray) ** 2
        omega[link] = _across(ray, speed) / square
        epsilon[link] = _across(ray, change) / square
    return Computed(z, v, a, omega, epsilon)


def _across(a: Any, b: Any) -> Any:
    return np.imag(np.conj(a) * b)
