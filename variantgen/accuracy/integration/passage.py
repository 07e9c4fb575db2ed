"""A four-bar driven over a way: the instants at which it is looked at, and its exact motion there."""

from __future__ import annotations

import cmath
import math
from functools import cached_property
from typing import Any

import numpy as np
from msgspec import Struct
from msgspec.structs import astuple, replace
from numpy.typing import NDArray

from variantgen.accuracy.precise import exact_number, many_digits, mpmath
from variantgen.accuracy.reference.exact_scene import exact_scene
from variantgen.accuracy.reference.motion import ExactMotion, solve_exactly
from variantgen.accuracy.reference.series import Series
from variantgen.accuracy.textbook.four_bar import FourBar
from variantgen.mechanism.scene import Scene

State = tuple[float, float]


class Passage(Struct, frozen=True, dict=True):
    """A four-bar (numbers, not arrays) whose crank turns evenly from ``phi``; looked at at the ``instants`` (s).

    The state is (theta, psi): the angles of coupler and rocker to the base (rad).
    """

    title: str
    bar: FourBar
    instants: NDArray[np.float64]

    @property
    def duration(self) -> float:
        """From the start to the last instant (s)."""
        return float(self.instants[-1])

    @property
    def start(self) -> State:
        """The state at the start, by the law of cosines."""
        one = FourBar(*(np.array([x]) for x in astuple(self.bar))).closed_form()
        tip, end = complex(one.z["A"][0]), complex(one.z["B"][0])
        return cmath.phase(end - tip), cmath.phase(end - self.bar.d)

    def scene(self) -> Scene:
        """All instants as one batch."""
        return replace(self.bar, phi=self.bar.phi + self.bar.omega * self.instants).scene()

    @cached_property
    def exact(self) -> list[ExactMotion]:
        """The exact motion at each instant, for the exact crank angle ``phi + omega t``."""
        scene = self.bar.scene()
        found = []
        for instant in self.instants:
            with many_digits():
                one = exact_scene(scene, 0, 1)
                turned = exact_number(self.bar.phi) + exact_number(self.bar.omega) * exact_number(instant)
                points = {**one.points, "A": replace(one.points["A"], angle=Series((turned,)))}  # type: ignore[type-var]
                found.append(solve_exactly(replace(one, points=points)).exact)
        return found

    def gap(self, t: float, state: Any) -> complex:
        """What is open in the chain (m): ``a e^(i phi) + b e^(i theta) - d - c e^(i psi)``."""
        bar, (theta, psi) = self.bar, state
        phi = bar.phi + bar.omega * t
        open_chain = bar.a * cmath.exp(1j * phi) + bar.b * cmath.exp(1j * theta) - bar.d - bar.c * cmath.exp(1j * psi)
        return complex(open_chain)

    def rates(self, t: float, state: Any, pull: float = 0.0) -> State:
        """Angular velocities (theta', psi') of a state; ``pull`` (1/s) closes the gap (Baumgarte)::

        i b theta' e^(i theta) - i c psi' e^(i psi) = R,   R = -i a omega e^(i phi) - pull gap
        theta' = Re(e^(-i psi) R) / (b sin(psi - theta)),   psi' = Re(e^(-i theta) R) / (c sin(psi - theta))
        """
        bar, (theta, psi) = self.bar, state
        phi = bar.phi + bar.omega * t
        sine = math.sin(psi - theta)
        across, along = bar.a * bar.omega * math.sin(phi - psi), bar.a * bar.omega * math.sin(phi - theta)
        if pull:
            gap = self.gap(t, state)
            across -= pull * (gap.real * math.cos(psi) + gap.imag * math.sin(psi))
            along -= pull * (gap.real * math.cos(theta) + gap.imag * math.sin(theta))
        return across / (bar.b * sine), along / (bar.c * sine)

    def projected(self, t: float, state: Any) -> State:
        """The state with the gap closed: two steps of Newton's method."""
        bar, (theta, psi) = self.bar, state
        for _ in range(2):
            gap = self.gap(t, (theta, psi))
            sine = math.sin(psi - theta)
            theta, psi = (
                theta - (gap.real * math.cos(psi) + gap.imag * math.sin(psi)) / (bar.b * sine),
                psi - (gap.real * math.cos(theta) + gap.imag * math.sin(theta)) / (bar.c * sine),
            )
        return theta, psi

    def stiffness(self) -> float:
        """Stiffness ratio: the length of the way times the largest real part, of either sign, of the eigenvalues.

        Those of the derivative of the velocity equations by the state, at the exact states: how many of the shortest
        time constants the way has. With f = theta', g = psi' and cot of (psi - theta) the derivative is::

            f cot    -a omega cos(phi - psi) / (b sin(psi - theta)) - f cot
            g cot - a omega cos(phi - theta) / (c sin(psi - theta))    -g cot
        """
        with many_digits():
            return float(max(self._growth(exact) for exact in self.exact)) * self.duration

    def _growth(self, exact: ExactMotion) -> Any:
        """Largest real part of an eigenvalue, of either sign (1/s), as a number of mpmath."""
        mp, bar = mpmath(), self.bar
        crank, rod, rocker = exact.z["A"], exact.z["B"] - exact.z["A"], exact.z["B"] - exact.z["C"]
        sine, cosine = (rod.conjugate() * rocker).imag, (rod.conjugate() * rocker).real
        cot, push = cosine / sine, bar.omega / sine
        f, g = exact.omega["AB"], exact.omega["BC"]
        upper = -push * (rocker.conjugate() * crank).real - f * cot
        lower = g * cot - push * (rod.conjugate() * crank).real
        half, product = (f - g) * cot / 2, -f * g * cot * cot - upper * lower
        root = mp.sqrt(mp.mpc(half * half - product))
        return max(abs((half + root).real), abs((half - root).real))


def turning(turns: int, checks: int) -> Passage:
    """An ordinary crank and rocker over so many turns; looked at at some instants of every part of the way."""
    bar = FourBar(0.25, 0.8, 0.6, 0.9, 0.4, 2.0, 0.0, 1.0)
    duration = 2 * math.pi * turns / bar.omega
    title = "one turn" if turns == 1 else f"{turns} turns"
    # Not at whole turns only: the golden ratio spreads the instants over the phases.
    spread = np.sort(np.mod(np.arange(1, checks) * 0.6180339887498949, 1.0))
    return Passage(title, bar, np.concatenate([spread, [1.0]]) * duration)


def passing(gap: float, checks: int) -> Passage:
    """The crank's tip passes the pivot of the rocker at a distance of ``gap`` lengths; coupler and rocker are equal.

    Near it the two turn by nearly half a turn, about ``1/gap`` times as fast as the crank.
    """
    bar = FourBar(0.5, 0.8, 0.8, 0.5 * (1 + gap), -1.0, 1.0, 0.0, 1.0)
    # Half of the instants lie within some gaps of the passage, evenly by their logarithm.
    near = np.geomspace(0.3 * gap, 0.5, checks // 4)
    return Passage(f"past the pivot, gap {gap:.0e}", bar, 1.0 + np.concatenate([-near[::-1], [0.0], near, [1.0]]))
