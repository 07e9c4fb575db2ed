"""The slider-crank mechanism: crank a at O, rod b, slider B on a line parallel to x at a height."""

from __future__ import annotations

from collections.abc import Mapping
from typing import Any

import numpy as np
from msgspec import Struct
from msgspec.structs import astuple

from variantgen.accuracy.computed import Computed
from variantgen.mechanism.constructions.coordinates import Coordinates
from variantgen.mechanism.constructions.line_circle import LineCircle
from variantgen.mechanism.constructions.polar import Polar
from variantgen.mechanism.drivers.rotation import Rotation
from variantgen.mechanism.joints.guide import Guide
from variantgen.mechanism.joints.pivot import Pivot
from variantgen.mechanism.scene import Scene


class SliderCrank(Struct, frozen=True):
    """Lengths and height of the guide (m), crank angle (rad), omega (rad/s), epsilon (rad/s^2); shape (N,)."""

    a: Any
    b: Any
    height: Any
    phi: Any
    omega: Any
    epsilon: Any

    def scene(self) -> Scene:
        """As a scene."""
        return Scene(
            {
                "O": Coordinates(0.0, 0.0),
                "E": Coordinates(0.0, self.height),
                "A": Polar("O", self.a, self.phi),
                "B": LineCircle("E", "A", self.b),
            },
            {"OA": ("O", "A"), "AB": ("A", "B")},
            (Pivot("O"), Guide("B")),
            (Rotation("OA", self.omega, self.epsilon),),
        )

    def closed_form(self) -> Computed:
        """With ``b sin(beta) = height - a sin(phi)``: derivatives of this and of ``x = a cos(phi) + b cos(beta)``."""
        a, b, phi, omega, epsilon = self.a, self.b, self.phi, self.omega, self.epsilon
        sin, cos = np.sin(phi), np.cos(phi)
        beta = np.arcsin((self.height - a * sin) / b)
        w2 = -a * omega * cos / (b * np.cos(beta))
        e2 = (a * omega**2 * sin - a * epsilon * cos + b * w2**2 * np.sin(beta)) / (b * np.cos(beta))
        v = -a * omega * sin - b * w2 * np.sin(beta)
        acceleration = (
            -a * epsilon * sin - a * omega**2 * cos - b * e2 * np.sin(beta) - b * w2**2 * np.cos(beta)
        )  # fmt: skip
        arm = a * (cos + 1j * sin)
        return Computed(
            {"A": arm, "B": a * cos + b * np.cos(beta) + 1j * self.height},
            {"A": 1j * omega * arm, "B": v + 0j},
            {"A": (1j * epsilon - omega**2) * arm, "B": acceleration + 0j},
            {"OA": omega, "AB": w2},
            {"OA": epsilon, "AB": e2},
        )

    def coordinates(self, time: Any) -> dict[str, tuple[Any, Any]]:
        """B by the theorem of Pythagoras."""
        angle = self.phi + (self.omega + 0.5 * self.epsilon * time) * time
        ax, ay = self.a * np.cos(angle), self.a * np.sin(angle)
        rise = self.height - ay
        zero = 0.0 * ax
        return {
            "O": (zero, zero),
            "A": (ax, ay),
            "B": (ax + np.sqrt(self.b**2 - rise * rise), self.height + zero),
        }

    def links(self) -> Mapping[str, tuple[str, str]]:
        """Crank and rod."""
        return {"OA": ("O", "A"), "AB": ("A", "B")}

    def take(self, index: Any) -> SliderCrank:
        """The variants at some indices."""
        return SliderCrank(*(table[index] for table in astuple(self)))

    def rate(self) -> Any:
        """Of the crank."""
        return np.maximum(np.abs(self.omega), np.sqrt(np.abs(self.epsilon)))
