"""Tests of solvers of plane mechanisms: random mechanisms, and theorems that every right motion obeys.

Mechanisms come from Hypothesis (the extra ``testing``), theorems are functions of a motion, each of which gives the
size of its violation: zero but for rounding where the motion is right. A motion is one of this program
(``variant.motion()``, ``variantgen.solve(scene)``) or of any solver (:func:`motion_of`).

>>> from variantgen.testing import equal_projections, motion_of
>>> rod = motion_of({"AB": ("A", "B")}, z={"A": 0, "B": 3 + 4j}, v={"A": 5, "B": 1 + 3j})
>>> equal_projections(rod).max() < 1e-12  # both velocities have the component 3 along AB
np.True_
"""

from __future__ import annotations

from variantgen.mechanism.verification.invariants import (
    centre_consistent,
    coriolis_direction,
    equal_projections,
    power_balance_of_constraints,
    rolling_contact_at_rest,
)
from variantgen.testing.changes import mirrored, parameters, rescaled
from variantgen.testing.comparisons import mirror, scaling, time_reversal
from variantgen.testing.motions import motion_of
from variantgen.testing.strategies import mechanisms, scenes, variants

__all__ = [
    "centre_consistent",
    "coriolis_direction",
    "equal_projections",
    "mechanisms",
    "mirror",
    "mirrored",
    "motion_of",
    "parameters",
    "power_balance_of_constraints",
    "rescaled",
    "rolling_contact_at_rest",
    "scaling",
    "scenes",
    "time_reversal",
    "variants",
]
