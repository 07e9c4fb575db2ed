"""The tables: CSV with everything, Markdown with a line for each class and way."""

from __future__ import annotations

import csv
import io
import math
from collections.abc import Iterable, Sequence

from variantgen.accuracy.integration.compare import PassageErrors
from variantgen.accuracy.measure import FAILURES
from variantgen.accuracy.report.result_rows import ResultRow, by_class, by_group
from variantgen.accuracy.run import Measurement


def instants_csv(measured: Measurement) -> str:
    """Every group and way."""
    head = [
        "class", "group", "way", "variants", "velocity error, median", "velocity error, largest",
        "acceleration error, median", "acceleration error, largest", "error/(kappa eps), median",
        "error/(kappa eps), largest", "us per variant", "batch", *FAILURES,
    ]  # fmt: skip
    rows = [
        [
            line.title, line.group, line.way, line.variants, *_numbers(line), _short(line.microseconds), line.batch,
            *(line.failures[name] for name in FAILURES),
        ]
        for line in by_group(measured)
    ]  # fmt: skip
    return _csv(head, rows)


def motion_csv(measured: Measurement) -> str:
    """Every passage, method, stabilisation and tolerance."""
    names = PassageErrors.__struct_fields__
    rows = [
        [*(_cell(getattr(result, name)) for name in names), _short(trip.stiffness), _short(trip.jump)]
        for trip in measured.trips
        for result in trip.results
    ]
    return _csv([*names, "stiffness", "jump"], rows)


def classes_markdown(measured: Measurement) -> str:
    """A table per class."""
    parts = []
    for case in measured.classes:
        head = (
            "| way | us per variant | velocity error, median / largest | acceleration error, median / largest "
            "| error/(κ ε), median / largest | without a result |\n|---|---|---|---|---|---|"
        )
        rows = [_row(line) for line in by_class(case)]
        parts.append(f"### {case.title} ({case.variants} variants)\n\n{case.about}\n\n{head}\n" + "\n".join(rows))
    return "\n\n".join(parts)


def motion_markdown(measured: Measurement) -> str:
    """A table per passage: for each method the cheapest result at every second power of ten."""
    parts = []
    for trip in measured.trips:
        head = (
            f"### {trip.title}\n\nStiffness ratio {trip.stiffness:.1e}; the angular velocity of the rocker changes by a"
            f" factor of {trip.jump:.1e}.\n\n| method | stabilisation | tolerance | evaluations | ms | position error |"
            " velocity error | open chain | |\n|---|---|---|---|---|---|---|---|---|"
        )
        parts.append(head + "\n" + "\n".join(_motion_row(result) for result in trip.results))
    return "\n\n".join(parts)


def failures(line: ResultRow) -> str:
    """The failures of a line in words."""
    return ", ".join(f"{count} {name}" for name, count in line.failures.items() if count)


def _row(line: ResultRow) -> str:
    time = f"{_short(line.microseconds)} (batches of {line.batch})" if line.batch else ""
    lost = f"{failures(line)} of {line.variants}" if failures(line) else ""
    cells = [
        line.module.TITLE,
        time,
        f"{_short(line.velocity)} / {_short(line.velocity_most)}",
        f"{_short(line.acceleration)} / {_short(line.acceleration_most)}",
        f"{_short(line.factor)} / {_short(line.factor_most)}",
        lost,
    ]
    return "| " + " | ".join(cells) + " |"


def _motion_row(result: PassageErrors) -> str:
    tolerance = f"{result.tolerance:.0e}" if result.tolerance else ""
    count = str(result.evaluations or "")
    errors = [_short(x) for x in (result.position, result.velocity, result.drift)]
    cells = [result.method, result.stabilisation, tolerance, count, f"{1e3 * result.seconds:.2g}", *errors]
    return "| " + " | ".join([*cells, result.failed]) + " |"


def _numbers(line: ResultRow) -> list[str]:
    values = (
        line.velocity, line.velocity_most, line.acceleration, line.acceleration_most, line.factor, line.factor_most
    )  # fmt: skip
    return [_short(x) for x in values]


def _cell(value: object) -> object:
    return _short(value) if isinstance(value, float) else value


def _short(x: float) -> str:
    return f"{x:.2g}" if math.isfinite(x) else ""


def _csv(head: Sequence[str], rows: Iterable[Sequence[object]]) -> str:
    text = io.StringIO()
    writer = csv.writer(text, lineterminator="\n")
    writer.writerow(head)
    writer.writerows(rows)
    return text.getvalue()
