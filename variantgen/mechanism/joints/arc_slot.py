"""Slot or guide curved as a circular arc, on a moving body or fixed."""

from __future__ import annotations

from collections.abc import Mapping
from typing import ClassVar

import numpy as np

from variantgen.mechanism.arithmetic import Complex, Flags, Real
from variantgen.mechanism.component import BodyName, PointName
from variantgen.mechanism.joint import Joint, Sliding
from variantgen.mechanism.rows import Placement, ScalarRow, Shape, Speeds


class ArcSlot(Joint, frozen=True):
    """``point`` slides along an arc about ``centre`` (C), a point of ``body`` or, without a body, a place at rest.

    The radius d = z - z_C keeps its length, ``|d| = const``; with its unit vector e::

        e.(v - v_C) = 0
        e.(a - a_C) + |v - v_C|^2 / |d| = 0
    """

    point: PointName
    centre: PointName
    body: BodyName | None = None
    belongs: ClassVar[Mapping[str, str]] = {"centre": "body"}

    def shapes(self) -> tuple[Shape, ...]:
        """One scalar row on the point and the centre."""
        return (Shape((self.point,) if self.body is None else (self.point, self.centre)),)

    def sound(self, at: Placement) -> Flags:
        """The point is off the centre."""
        return np.abs(at.z[self.point] - at.z[self.centre]) > 0

    def sliding(self) -> Sliding | None:
        """The point slides on the body along the arc; a fixed arc carries no relative motion."""
        return None if self.body is None else Sliding(self.point, self.body, centre=self.centre)

    def landmarks(self) -> tuple[str, ...]:
        """The centre of a fixed arc."""
        return (self.centre,) if self.body is None else ()

    def _ray(self, at: Placement) -> tuple[Complex, Real]:
        step = at.z[self.point] - at.z[self.centre]
        radius = np.abs(step)
        safe = np.where(radius > 0, radius, 1.0)
        return step / safe, safe

    def rows(self, at: Placement) -> tuple[ScalarRow, ...]:
        """``e.(v - v_C) = 0``."""
        ray, _ = self._ray(at)
        return (ScalarRow({self.point: ray} if self.body is None else {self.point: ray, self.centre: -ray}),)

    def quadratic(self, at: Placement, speeds: Speeds) -> tuple[Complex, ...]:
        """``|v - v_C|^2 / |d|``."""
        _, radius = self._ray(at)
        step = speeds.v[self.point] - (speeds.v[self.centre] if self.body is not None else 0.0)
        return (np.abs(step) ** 2 / radius,)

    def residual(self, moved: Placement, start: Placement, time: Real) -> tuple[Real, ...]:
        """Change of the radius (m)."""
        centre = moved.z[self.centre] if self.body is not None else start.z[self.centre]
        return (np.abs(moved.z[self.point] - centre) - np.abs(start.z[self.point] - start.z[self.centre]),)
