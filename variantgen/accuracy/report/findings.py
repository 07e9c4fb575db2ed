"""What the numbers show, in sentences made from them."""

from __future__ import annotations

import math
from collections.abc import Iterator

from variantgen.accuracy.integration.compare import DIRECT, PassageErrors
from variantgen.accuracy.integration.integrate import IMPLICIT
from variantgen.accuracy.measure import discovered
from variantgen.accuracy.report.result_rows import ResultRow, by_class
from variantgen.accuracy.run import CaseClass, Measurement, PassageResult
from variantgen.mechanism.arithmetic import EPS

_PROJECTED = "with every step projected on the closed chain, that is with positions solved again, the best"
BOUND = 32.0  # of (condition number x machine epsilon): what is promised of the production


def findings(measured: Measurement) -> list[str]:
    """The findings, each a sentence or two."""
    return [*_production(measured), *_others(measured), *_over_time(measured)]


def _production(measured: Measurement) -> Iterator[str]:
    lines = [(case, _of(case, "production")) for case in measured.classes]
    first = lines[0][1]
    yield (
        f"On {lines[0][0].title} production has a median relative error of {first.velocity:.1e} in velocities and"
        f" {first.acceleration:.1e} in accelerations, at {first.microseconds:.2g} microseconds per variant in batches"
        f" of {first.batch}."
    )
    within = [line for _, line in lines if line.factor_most <= BOUND]
    above = [line for _, line in lines if line.factor_most > BOUND]
    factor = max(line.factor_most for line in within)
    yield (
        f"Its error is at most {factor:.2g} times (condition number x machine epsilon) in {len(within)} of"
        f" {len(lines)} classes ({', '.join(line.title for line in within)}); {BOUND:.0f} is promised."
    )
    for line in above:
        yield (
            f"In the class '{line.title}' it reaches {line.factor_most:.2g} times, with a median of {line.factor:.2g}."
        )
    wrong = ("exception", "not a number", "wrong branch")
    bad = {name: sum(line.failures[name] for _, line in lines) for name in wrong}
    count = sum(line.variants for _, line in lines)
    if not any(bad.values()):
        yield f"No exception, no NaN and no wrong branch in {count} variants."
    else:
        yield f"Of {count} variants: " + ", ".join(f"{n} {name}" for name, n in bad.items() if n) + "."
    refused = [line for _, line in lines if line.failures["refused"]]
    if refused:
        least = min(line.least_failed for line in refused) * EPS
        yield (
            f"Refused as dead points or not assembled: {sum(line.failures['refused'] for line in refused)}, the best"
            f" conditioned of them with a product of condition number and machine epsilon of {least:.1g}"
            + (": no digit of its accelerations can be had from doubles." if least > 0.1 else ".")
        )


def _others(measured: Measurement) -> Iterator[str]:
    better: list[str] = []
    for case in measured.classes:
        mine = _of(case, "production")
        for line in by_class(case):
            other = line.way != "production" and line.module.DOUBLE and line.solved == line.variants
            if other and line.acceleration < 0.5 * mine.acceleration:
                better.append(f"{line.module.SHORT} in '{case.title}' ({line.acceleration:.1g})")
    yield (
        "No other way in double precision that solves all variants of a class has a median error of accelerations less"
        " than half of production's."
        if not better
        else "A median error of accelerations less than half of production's: " + "; ".join(better) + "."
    )
    for name in ("newton", "central_six", "closed_form"):
        lines = [line for case in measured.classes for line in by_class(case) if line.way == name]
        lost = {kind: sum(line.failures[kind] for line in lines) for kind in lines[0].failures}
        total, tried = sum(lost.values()), sum(line.variants for line in lines)
        if total:
            worst = max(lines, key=lambda line: (line.variants - line.solved) / max(1, line.variants))
            share = 100 * (worst.variants - worst.solved) / worst.variants
            words = ", ".join(f"{count} {kind}" for kind, count in lost.items() if count)
            yield (
                f"{_capital(discovered()[name].TITLE)} fails for {total} of {tried} variants ({words}),"
                f" most in '{worst.title}' ({share:.0f} %)."
            )
    ordinary = {line.way: line for line in by_class(measured.classes[0])}
    times = [
        f"{line.module.SHORT} {line.microseconds / ordinary['production'].microseconds:.2g}"
        for line in ordinary.values()
        if line.way != "production" and math.isfinite(line.microseconds)
    ]
    yield "Time per variant on ordinary variants, in units of production's: " + ", ".join(times) + "."


def _over_time(measured: Measurement) -> Iterator[str]:
    for trip in measured.trips:
        direct = next(r for r in trip.results if r.method == DIRECT)
        plain = _best(trip, "none")
        kept = _best(trip, "projection")
        text = (
            f"{_capital(trip.title)} (stiffness ratio {trip.stiffness:.1e}, angular velocity of the"
            f" rocker changing by a factor of {trip.jump:.0e}): direct evaluation has an error of"
            f" {direct.velocity:.0e} in {1e3 * direct.seconds:.2g} ms"
        )
        for result, word in ((plain, "the best integration"), (kept, _PROJECTED)):
            if result:
                text += (
                    f"; {word} is {result.method} at {result.tolerance:.0e} with {result.velocity:.0e} in"
                    f" {1e3 * result.seconds:.2g} ms"
                )
        yield text + "."
    explicit, implicit = _explicit_implicit(measured.trips[-1])
    if explicit and implicit:
        yield (
            f"On the stiffest passage the explicit {explicit.method} reaches {explicit.velocity:.0e} with"
            f" {explicit.evaluations} evaluations, the implicit {implicit.method} {implicit.velocity:.0e} with"
            f" {implicit.evaluations}: the equations are fast there for a moment and not damped, which implicit methods"
            " do not help."
        )


def _best(trip: PassageResult, stabilisation: str) -> PassageErrors | None:
    found = [r for r in trip.results if r.stabilisation == stabilisation and r.method != DIRECT and not r.failed]
    return min(found, key=lambda r: r.velocity, default=None)


def _explicit_implicit(trip: PassageResult) -> tuple[PassageErrors | None, PassageErrors | None]:
    found = [r for r in trip.results if r.stabilisation == "none" and r.evaluations and not r.failed]
    implicit = [r for r in found if r.method in IMPLICIT]
    explicit = [r for r in found if r.method in {"RK45", "DOP853"}]
    return min(explicit, key=lambda r: r.velocity, default=None), min(implicit, key=lambda r: r.velocity, default=None)


def _capital(text: str) -> str:
    return text[:1].upper() + text[1:]


def _of(case: CaseClass, way: str) -> ResultRow:
    return next(line for line in by_class(case) if line.way == way)
