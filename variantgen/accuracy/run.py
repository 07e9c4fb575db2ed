"""The whole measurement: all classes of cases in all ways, and the passages over time."""

from __future__ import annotations

import importlib
import os
import platform
from collections.abc import Callable
from types import ModuleType

import numpy as np
from msgspec import Struct

from variantgen.accuracy import cases
from variantgen.accuracy.integration.compare import PassageErrors, follow
from variantgen.accuracy.integration.passage import Passage, passing, turning
from variantgen.accuracy.measure import Errors, discovered, measure, reference_cases
from variantgen.accuracy.precise import DIGITS, mpmath
from variantgen.resources import module_names
from variantgen.version import VERSION

SEED = 20260
Progress = Callable[[str], None]


class MeasurementExtent(Struct, frozen=True):
    """How much is measured: about so many variants of a class; so many of its groups are timed, in so many rounds.

    Passages: turns of the long one, gaps of the stiff ones, instants of each, tolerances, most evaluations of one
    integration.
    """

    count: int
    timed: int
    rounds: int
    turns: tuple[int, ...]
    gaps: tuple[float, ...]
    checks: int
    tolerances: tuple[float, ...]
    most: int


QUICK = MeasurementExtent(8, 2, 2, (10,), (1e-3, 1e-6), 16, (1e-3, 1e-6, 1e-9), 4_000)
FULL = MeasurementExtent(
    192, 6, 5, (1, 100), (1e-3, 1e-4, 1e-5, 1e-6), 40, tuple(10.0**-k for k in range(3, 13)), 100_000
)  # fmt: skip


class CaseClass(Struct, frozen=True):
    """A class of cases: its title, what it is about, errors by group and way, number of variants."""

    title: str
    about: str
    errors: tuple[Errors, ...]
    variants: int


class PassageResult(Struct, frozen=True):
    """A passage: its title, stiffness ratio, largest over smallest angular velocity of the rocker, results."""

    title: str
    stiffness: float
    jump: float
    results: tuple[PassageErrors, ...]


class Measurement(Struct, frozen=True):
    """Everything that was measured, and on what."""

    classes: tuple[CaseClass, ...]
    trips: tuple[PassageResult, ...]
    machine: dict[str, str]


def run(extent: MeasurementExtent, progress: Progress = lambda _: None) -> Measurement:
    """Measure everything. Raises ToolMissingError without mpmath."""
    mpmath()
    classes = []
    for module in case_modules():
        progress(module.TITLE)
        classes.append(_measured(module, extent))
    trips = []
    passages = [turning(n, extent.checks) for n in extent.turns]
    passages += [passing(gap, extent.checks) for gap in extent.gaps]
    for passage in passages:
        progress(passage.title)
        trips.append(_followed(passage, extent))
    return Measurement(tuple(classes), tuple(trips), machine())


def case_modules() -> list[ModuleType]:
    """The classes of cases in the order of the report."""
    names = [name for name in module_names(cases.__path__) if not name.startswith("_")]
    found = [importlib.import_module(f"{cases.__name__}.{name}") for name in names]
    return sorted(found, key=lambda module: int(module.PLACE))


def machine() -> dict[str, str]:
    """Versions and machine."""
    import scipy

    processor = platform.processor() or platform.machine()
    return {
        "variantgen": VERSION,
        "Python": platform.python_version(),
        "numpy": np.__version__,
        "scipy": scipy.__version__,
        "mpmath": f"{mpmath().__version__} ({DIGITS} digits)",
        "machine": f"{platform.system()} {processor}, {os.cpu_count()} processors",
        "extended precision": f"epsilon {float(np.finfo(np.longdouble).eps):.1e}",
    }


def _measured(module: ModuleType, extent: MeasurementExtent) -> CaseClass:
    groups = module.groups(extent.count, np.random.default_rng([SEED, int(module.PLACE)]))
    timed = {round(k) for k in np.linspace(0, len(groups) - 1, min(extent.timed, len(groups)))}
    timed |= {number for number, group in enumerate(groups) if group.label == "four-bar"}
    found: list[Errors] = []
    variants = 0
    for number, group in enumerate(groups):
        kept, known = reference_cases(group)
        variants += len(known)
        for way in discovered():
            found.append(measure(way, kept, known, extent.rounds if number in timed else 0))
    return CaseClass(module.TITLE, module.ABOUT, tuple(found), variants)


def _followed(passage: Passage, extent: MeasurementExtent) -> PassageResult:
    speeds = [abs(float(exact.omega["BC"])) for exact in passage.exact]
    jump = max(speeds) / max(min(speeds), 1e-300)
    results = tuple(follow(passage, extent.tolerances, extent.most, extent.rounds))
    return PassageResult(passage.title, passage.stiffness(), jump, results)
