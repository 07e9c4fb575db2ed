"""Solvers in plain numpy as students write them, right ones and two deliberately wrong ones."""

from __future__ import annotations

from typing import Any

import numpy as np

from variantgen.mechanism.motion import Motion
from variantgen.testing import motion_of


def slotted_arm(p: dict[str, float], coriolis: float = 1.0) -> Motion:
    """Crank OA in the slot of the arm CB (``slotted_rocker``); wrong for any other factor of the Coriolis term."""
    omega, epsilon = p["sense"] * p["omega_OA"], p["epsilon_OA"]
    crank = p["OA"] * np.exp(1j * (np.pi / 2 - p["phi"]))
    v, a = 1j * omega * crank, (1j * epsilon - omega**2) * crank
    pivot = -1j * p["OC"]
    arm = crank - pivot
    u, s = arm / abs(arm), abs(arm)
    turning, sliding = (np.conj(u) * v).imag / s, (np.conj(u) * v).real
    faster = ((np.conj(u) * a).imag - coriolis * 2 * turning * sliding) / s
    end = p["CB"] * u
    return motion_of(
        {"OA": ("O", "A"), "CB": ("C", "B")},
        z={"O": 0, "A": crank, "C": pivot, "B": pivot + end},
        v={"O": 0, "A": v, "C": 0, "B": 1j * turning * end},
        a={"O": 0, "A": a, "C": 0, "B": (1j * faster - turning**2) * end},
        omega={"OA": omega, "CB": turning},
        epsilon={"OA": epsilon, "CB": faster},
        pivots=("O", "C"),
        slots={"A": ("CB", "C", "B")},
    )


def four_bar(p: dict[str, float], flipped: str = "") -> Motion:
    """A four-bar (``four_bar``, driven by its crank).

    Wrong where ``flipped`` is "always" (B is to the left of AC, whatever is said) or "velocities" (those of the other
    branch at the places of this one).
    """
    omega, epsilon = p["sense"] * p["omega_OA"], p["epsilon_OA"]
    crank, base = p["OA"] * np.exp(1j * p["phi"]), p["OC"]
    side = 1.0 if flipped == "always" else p["side"]
    place = joint(crank, p["AB"], base, p["BC"], side)
    at = joint(crank, p["AB"], base, p["BC"], -side) if flipped == "velocities" else place
    rod, rocker = at - crank, at - base
    v, a = 1j * omega * crank, (1j * epsilon - omega**2) * crank
    matrix = np.array([[-rod.imag, rocker.imag], [rod.real, -rocker.real]])

    def solve(right: complex) -> Any:
        return np.linalg.solve(matrix, [right.real, right.imag])

    w = solve(-v)
    e = solve(-a + w[0] ** 2 * rod - w[1] ** 2 * rocker)
    return motion_of(
        {"OA": ("O", "A"), "AB": ("A", "B"), "BC": ("C", "B")},
        z={"O": 0, "A": crank, "B": place, "C": base},
        v={"O": 0, "A": v, "B": 1j * w[1] * rocker, "C": 0},
        a={"O": 0, "A": a, "B": (1j * e[1] - w[1] ** 2) * rocker, "C": 0},
        omega={"OA": omega, "AB": w[0], "BC": w[1]},
        epsilon={"OA": epsilon, "AB": e[0], "BC": e[1]},
        pivots=("O", "C"),
    )


def joint(first: complex, r: float, second: complex, s: float, side: float) -> complex:
    """Where circles about two points meet, to the left of the way from the first to the second (``side`` 1) or not."""
    line = second - first
    along = (abs(line) ** 2 + r**2 - s**2) / (2 * abs(line))
    return complex(first + line / abs(line) * (along + side * 1j * np.sqrt(r**2 - along**2)))
