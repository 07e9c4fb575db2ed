"""The error of a way to compute, against many digits, and the time it takes, for one group of variants."""

from __future__ import annotations

import importlib
import time
import warnings
from collections.abc import Callable, Iterable, Sequence
from functools import cache
from types import ModuleType

import numpy as np
from msgspec import Struct, field

from variantgen.accuracy import algorithms
from variantgen.accuracy.computed import CaseGroup, Computed
from variantgen.accuracy.condition import ConditionNumbers, condition
from variantgen.accuracy.norms import deviation
from variantgen.accuracy.precise import exact_number, many_digits
from variantgen.accuracy.reference.branches import on_branch
from variantgen.accuracy.reference.exact_scene import exact_scene
from variantgen.accuracy.reference.motion import ExactMotion, solve_exactly
from variantgen.accuracy.reference.positions import NoSuchPointError
from variantgen.mechanism.arithmetic import EPS
from variantgen.mechanism.motion import take_scene
from variantgen.mechanism.scene import Scene
from variantgen.resources import module_names

# What can become of a variant besides a result: each is counted, none enters the errors.
FAILURES = ("exception", "not a number", "refused", "no convergence", "wrong branch")


class ReferenceCase(Struct, frozen=True):
    """One variant as exact scene, its exact motion and how well conditioned it is."""

    scene: Scene
    exact: ExactMotion
    condition: ConditionNumbers


class Errors(Struct):
    """Errors of one way in one group: relative, by order (positions, velocities, accelerations), a row per variant.

    ``factors`` are the errors of velocities and accelerations divided by (condition number x machine epsilon), and
    ``kappas`` their condition numbers. ``least_failed`` is the smallest condition number of an acceleration at which
    the way failed in any manner.
    ``seconds`` per variant, with ``batch`` variants at once. ``absent``: why the way does not apply.
    """

    way: str
    group: str
    notes: dict[str, float] = field(default_factory=dict)
    rows: list[tuple[float, float, float]] = field(default_factory=list)
    factors: list[tuple[float, float]] = field(default_factory=list)
    kappas: list[tuple[float, float]] = field(default_factory=list)
    least_failed: float = float("inf")
    failures: dict[str, int] = field(default_factory=lambda: dict.fromkeys(FAILURES, 0))
    variants: int = 0
    seconds: float = float("nan")
    batch: int = 0
    absent: str = ""


@cache
def discovered() -> dict[str, ModuleType]:
    """The ways by name, production first."""
    names = [name for name in module_names(algorithms.__path__) if not name.startswith("_")]
    names.sort(key=lambda name: (name != "production", name))
    return {name: importlib.import_module(f"{algorithms.__name__}.{name}") for name in names}


def reference_cases(group: CaseGroup) -> tuple[CaseGroup, list[ReferenceCase]]:
    """The exact motion of every variant of a group; without those that do not assemble."""
    found, kept = [], []
    for index in range(group.size):
        with many_digits():
            scene = exact_scene(group.scene, index, group.size)
            try:
                solution = solve_exactly(scene)
            except (NoSuchPointError, ZeroDivisionError):
                continue
            found.append(ReferenceCase(scene, solution.exact, condition(scene, solution)))
        kept.append(index)
    return part(group, kept), found


def part(group: CaseGroup, index: Sequence[int]) -> CaseGroup:
    """The variants of a group at some indices, which may repeat."""
    chosen = np.array(index, dtype=int)
    textbook = group.textbook.take(chosen) if group.textbook else None
    return CaseGroup(group.label, take_scene(group.scene, chosen, group.size), len(chosen), textbook, group.notes)


def measure(name: str, group: CaseGroup, known: Sequence[ReferenceCase], rounds: int) -> Errors:
    """Errors of a way in a group whose exact motions are known, and its time in so many rounds (0: not timed)."""
    way = discovered()[name]
    found = Errors(name, group.label, dict(group.notes), variants=group.size, absent=way.applies(group))
    if found.absent or not group.size:
        return found
    with warnings.catch_warnings(), np.errstate(all="ignore"):
        warnings.simplefilter("ignore")
        results = zip(_results(way.prepare, group), known, strict=True)
        good = [number for number, (result, truth) in enumerate(results) if _assess(result, truth, found)]
        if rounds and good:
            found.batch = way.BATCH
            batch = part(group, [good[i % len(good)] for i in range(way.BATCH)])
            found.seconds = _seconds(way.prepare(batch), rounds) / way.BATCH
    return found


def _results(prepare: Callable[[CaseGroup], Callable[[], Computed]], group: CaseGroup) -> Iterable[Computed | None]:
    """The result of each variant; None where an exception was raised."""
    try:
        every = prepare(group)()
    except (ArithmeticError, ValueError, np.linalg.LinAlgError):
        if group.size == 1:
            return [None]
        return [x for i in range(group.size) for x in _results(prepare, part(group, [i]))]
    return [_single(every, i) for i in range(group.size)]


def _single(every: Computed, index: int) -> Computed:
    one = every.one(index)
    flags = {name: None if (x := getattr(every, name)) is None else x[index] for name in ("refused", "lost")}
    return Computed(one.z, one.v, one.a, one.omega, one.epsilon, **flags)


def _assess(result: Computed | None, truth: ReferenceCase, found: Errors) -> bool:
    """Count a variant as failed or note its errors; whether it has a result."""
    failure = _failure(result, truth)
    if failure:
        found.failures[failure] += 1
        found.least_failed = min(found.least_failed, truth.condition.acceleration)
        return False
    assert result is not None, "that would be a failure"
    with many_digits():
        gaps = tuple(float(gap) for gap in deviation(result.each(exact_number), truth.exact))
    found.rows.append((gaps[0], gaps[1], gaps[2]))
    kappa = truth.condition
    found.kappas.append((kappa.velocity, kappa.acceleration))
    found.factors.append((gaps[1] / (kappa.velocity * EPS), gaps[2] / (kappa.acceleration * EPS)))
    return True


def _failure(result: Computed | None, truth: ReferenceCase) -> str:
    if result is None:
        return "exception"
    if result.refused is not None and bool(result.refused):
        return "refused"
    if not result.finite:
        return "not a number"
    with many_digits():
        frame = truth.scene.frame
        turn, sense = frame.turn.value, frame.sense.value
        back = {name: turn.conjugate() * exact_number(z) for name, z in result.z.items()}
        places = {**truth.exact.places, **{name: sense * z.real + 1j * z.imag for name, z in back.items()}}
        if not on_branch(truth.scene, places, truth.exact.places, truth.exact.size):
            return "no convergence" if result.lost is not None and bool(result.lost) else "wrong branch"
    return "no convergence" if result.lost is not None and bool(result.lost) else ""


def _seconds(action: Callable[[], object], rounds: int) -> float:
    """Least seconds of a call in several rounds, after one that does not count."""
    action()
    times = []
    for _ in range(rounds):
        start = time.perf_counter()
        action()
        times.append(time.perf_counter() - start)
    return min(times)
