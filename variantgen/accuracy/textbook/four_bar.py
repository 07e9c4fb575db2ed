"""The four-bar linkage: crank a at O, coupler b, rocker c at C, base d along x."""

from __future__ import annotations

from collections.abc import Mapping
from typing import Any

import numpy as np
from msgspec import Struct
from msgspec.structs import astuple

from variantgen.accuracy.computed import Computed
from variantgen.mechanism.constructions.circle_circle import CircleCircle
from variantgen.mechanism.constructions.coordinates import Coordinates
from variantgen.mechanism.constructions.polar import Polar
from variantgen.mechanism.drivers.rotation import Rotation
from variantgen.mechanism.joints.pivot import Pivot
from variantgen.mechanism.scene import Scene


class FourBar(Struct, frozen=True):
    """Lengths (m), crank angle (rad), omega (rad/s), epsilon (rad/s^2), side of B on the way A -> C; shape (N,)."""

    a: Any
    b: Any
    c: Any
    d: Any
    phi: Any
    omega: Any
    epsilon: Any
    side: Any

    def scene(self) -> Scene:
        """As a scene."""
        return Scene(
            {
                "O": Coordinates(0.0, 0.0),
                "C": Coordinates(self.d, 0.0),
                "A": Polar("O", self.a, self.phi),
                "B": CircleCircle("A", self.b, "C", self.c, self.side),
            },
            {"OA": ("O", "A"), "AB": ("A", "B"), "BC": ("C", "B")},
            (Pivot("O"), Pivot("C")),
            (Rotation("OA", self.omega, self.epsilon),),
        )

    def closed_form(self) -> Computed:
        """By the law of cosines; with the angles phi, theta (coupler), psi (rocker) of the links to the x axis::

        omega_2 = a omega sin(phi - psi) / (b sin(psi - theta))
        omega_3 = a omega sin(phi - theta) / (c sin(psi - theta))

        and the accelerations by projection of ``a_A + a_BA = a_B`` on the coupler and on the rocker.
        """
        a, b, c, phi, omega = self.a, self.b, self.c, self.phi, self.omega
        ax, ay = a * np.cos(phi), a * np.sin(phi)
        f = np.hypot(self.d - ax, ay)
        base = np.arctan2(-ay, self.d - ax)
        theta = base + self.side * np.arccos((b**2 + f**2 - c**2) / (2 * b * f))
        bx, by = ax + b * np.cos(theta), ay + b * np.sin(theta)
        psi = np.arctan2(by, bx - self.d)
        sine = np.sin(psi - theta)
        w2, w3 = a * omega * np.sin(phi - psi) / (b * sine), a * omega * np.sin(phi - theta) / (c * sine)
        tangential = a * self.epsilon
        e2 = (
            tangential * np.sin(phi - psi) + a * omega**2 * np.cos(phi - psi) + b * w2**2 * np.cos(theta - psi)
            - c * w3**2
        ) / (b * sine)  # fmt: skip
        e3 = (
            tangential * np.sin(phi - theta) + a * omega**2 * np.cos(phi - theta) + b * w2**2
            - c * w3**2 * np.cos(psi - theta)
        ) / (c * sine)  # fmt: skip
        arm, rocker = ax + 1j * ay, c * np.exp(1j * psi)
        return Computed(
            {"A": arm, "B": bx + 1j * by},
            {"A": 1j * omega * arm, "B": 1j * w3 * rocker},
            {"A": (1j * self.epsilon - omega**2) * arm, "B": (1j * e3 - w3**2) * rocker},
            {"OA": omega, "AB": w2, "BC": w3},
            {"OA": self.epsilon, "AB": e2, "BC": e3},
        )

    def coordinates(self, time: Any) -> dict[str, tuple[Any, Any]]:
        """B from the foot of the perpendicular on AC, in squares and one root."""
        angle = self.phi + (self.omega + 0.5 * self.epsilon * time) * time
        ax, ay = self.a * np.cos(angle), self.a * np.sin(angle)
        dx, dy = self.d - ax, -ay
        square = dx * dx + dy * dy
        x = (square + self.b**2 - self.c**2) / (2 * square)
        h = self.side * np.sqrt(self.b**2 / square - x * x)
        zero = 0.0 * ax
        return {
            "O": (zero, zero),
            "A": (ax, ay),
            "B": (ax + x * dx - h * dy, ay + x * dy + h * dx),
            "C": (self.d + zero, zero),
        }

    def links(self) -> Mapping[str, tuple[str, str]]:
        """Crank, coupler, rocker."""
        return {"OA": ("O", "A"), "AB": ("A", "B"), "BC": ("C", "B")}

    def take(self, index: Any) -> FourBar:
        """The variants at some indices."""
        return FourBar(*(table[index] for table in astuple(self)))

    def rate(self) -> Any:
        """Of the crank."""
        return np.maximum(np.abs(self.omega), np.sqrt(np.abs(self.epsilon)))
