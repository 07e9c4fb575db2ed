"""The summary for docs/accuracy.md: a line for each class of cases, a line for each passage."""

from __future__ import annotations

import math

from variantgen.accuracy.integration.compare import DIRECT
from variantgen.accuracy.report.result_rows import ResultRow, by_class
from variantgen.accuracy.run import CaseClass, Measurement, PassageResult

_OTHERS = ("dense", "closed_form", "newton")  # those without differences, which lose half of the digits


def summary(measured: Measurement) -> str:
    """Production in each class beside other ways in double precision; integration beside direct evaluation."""
    head = (
        "| class of cases | variants | velocity error, median / largest | acceleration error, median / largest"
        " | largest error / (κ ε) | refused | the same of other ways in doubles (share without a result) |\n"
        "|---|---|---|---|---|---|---|"
    )
    over_time = (
        "| motion over time | stiffness ratio | direct evaluation: error, time | best integration: error, time"
        " | with projection: error, time |\n|---|---|---|---|---|"
    )
    parts = [
        "\n".join([head, *(_class_row(case) for case in measured.classes)]),
        "\n".join([over_time, *(_trip_row(trip) for trip in measured.trips)]),
        _times(measured.classes[0]),
        "Measured with " + ", ".join(f"{name} {value}" for name, value in measured.machine.items()) + ".",
    ]
    return "\n\n".join(parts) + "\n"


def _class_row(case: CaseClass) -> str:
    lines = by_class(case)
    mine = next(line for line in lines if line.way == "production")
    others = [line for line in lines if line.way in _OTHERS and math.isfinite(line.factor_most)]
    cells = [
        case.title,
        str(case.variants),
        f"{mine.velocity:.1e} / {mine.velocity_most:.1e}",
        f"{mine.acceleration:.1e} / {mine.acceleration_most:.1e}",
        f"{mine.factor_most:.2g}",
        str(mine.failures["refused"]),
        ", ".join(_other(line) for line in others),
    ]
    return "| " + " | ".join(cells) + " |"


def _other(line: ResultRow) -> str:
    lost = line.variants - line.solved
    share = f" ({100 * lost / line.variants:.0f} %)" if lost else ""
    return f"{line.module.SHORT} {line.factor_most:.2g}{share}"


def _trip_row(trip: PassageResult) -> str:
    direct = next(r for r in trip.results if r.method == DIRECT)
    cells = [trip.title, f"{trip.stiffness:.1e}", f"{direct.velocity:.0e}, {1e3 * direct.seconds:.2g} ms"]
    for stabilisation in ("none", "projection"):
        found = [r for r in trip.results if r.stabilisation == stabilisation and r.method != DIRECT and not r.failed]
        best = min(found, key=lambda r: r.velocity, default=None)
        cells.append(
            f"{best.method} at {best.tolerance:.0e}: {best.velocity:.0e}, {1e3 * best.seconds:.2g} ms"
            if best
            else "none"
        )
    return "| " + " | ".join(cells) + " |"


def _times(case: CaseClass) -> str:
    lines = [line for line in by_class(case) if math.isfinite(line.microseconds)]
    return "Microseconds per variant on ordinary variants: " + ", ".join(_time(line) for line in lines) + "."


def _time(line: ResultRow) -> str:
    return f"{line.module.SHORT} {line.microseconds:.2g} (batches of {line.batch})"
