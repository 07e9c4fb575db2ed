"""Two points at a given distance: the ends of a rigid link."""

from __future__ import annotations

from collections.abc import Mapping
from dataclasses import dataclass

import numpy as np

from variantgen.mechanism.arithmetic import Complex, Real
from variantgen.mechanism.component import PointName, Size


@dataclass(frozen=True)
class Distance:
    """``|z_end - z_start| = length``."""

    start: PointName
    end: PointName
    length: Size

    def value(self, at: Mapping[str, Complex]) -> Real:
        """Distance less the wanted one (m)."""
        return np.abs(at[self.end] - at[self.start]) - self.length

    def gradient(self, at: Mapping[str, Complex]) -> dict[str, Complex]:
        """The unit vector start -> end, for the end; its negative for the start."""
        step = np.asarray(at[self.end] - at[self.start])
        length = np.abs(step)
        ray = np.where(length > 0, step, 1.0) / np.where(length > 0, length, 1.0)
        return {self.start: -ray, self.end: ray}
