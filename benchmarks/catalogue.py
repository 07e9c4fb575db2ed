"""Every family of the catalogue: parameters, blocks, acceptance, distinct variants, time of 1000 accepted variants.

    python -m benchmarks.catalogue [--seeds N]

Prints a Markdown table and writes it to ``benchmarks/catalogue.md``. Times depend on the machine.
"""

from __future__ import annotations

import argparse

from benchmarks.measure import machine_line, write_beside
from variantgen.check.family import check_family
from variantgen.check.report import FormReport
from variantgen.families.reading.folders import family_names

HEAD = """\
| family | form | parameters | acceptance, % | distinct variants | blocks | 1000 variants, s |
|---|---|---|---|---|---|---|"""


def row(family: str, form: FormReport) -> str:
    """One line of the table."""
    distinct = str(form.valid) if form.valid_exact else f"{form.valid:.1e}"
    blocks = "+".join(map(str, form.blocks))
    return (
        f"| {family} | {form.name} | {form.parameters} | {100 * form.acceptance:.0f} | {distinct} | {blocks}"
        f" | {form.seconds_per_1000:.2f} |"
    )


def main() -> None:
    parser = argparse.ArgumentParser(description=__doc__.splitlines()[0])
    parser.add_argument("--seeds", type=int, default=1000)
    seeds = parser.parse_args().seeds
    lines = [HEAD]
    for name in family_names():
        report = check_family(name, seeds)
        assert not report.failures, (name, report.failures)
        lines += [row(name, form) for form in report.forms]
        print(*lines[-len(report.forms) :], sep="\n", flush=True)
    note = f"{seeds} seeds per form, {machine_line()}"
    write_beside(__file__, [f"# The catalogue, measured\n\n`python -m benchmarks.catalogue`: {note}.\n", *lines])


if __name__ == "__main__":
    main()
