"""The report as a folder: tables, diagrams, text."""

from __future__ import annotations

from pathlib import Path

from variantgen.accuracy.report.diagrams import draw
from variantgen.accuracy.report.docs_summary import summary
from variantgen.accuracy.report.findings import findings
from variantgen.accuracy.report.result_tables import classes_markdown, instants_csv, motion_csv, motion_markdown
from variantgen.accuracy.run import Measurement

REPORT, SUMMARY = "report.md", "summary.md"
FILES = {REPORT, SUMMARY, "instants.csv", "motion.csv", "*.pdf", "*.png"}

_METHOD = """\
Reference: positions from the definitions of all points, velocities and accelerations from the residuals of joints and
drivers, evaluated on power series in time, all in mpmath with {digits}; the doubles of the scene are taken for exact.
Errors are normwise for each variant: the largest error of any point, and of any angular velocity times the size of the
mechanism, by the largest of these. The condition number κ is the sum, over all numbers that the scene is given by, of
|d| |∂y/∂d| / |y|, found by perturbing each of them in the reference. Variants without a result (exception, not a
number, refused, no convergence, wrong branch) are counted and do not enter the errors. Times are the least of several
rounds, for a batch as large as is told."""


def write(measured: Measurement, folder: Path) -> None:
    """Write all files into an existing folder. Raises ToolMissingError without matplotlib."""
    (folder / "instants.csv").write_text(instants_csv(measured), "utf-8")
    (folder / "motion.csv").write_text(motion_csv(measured), "utf-8")
    draw(measured, folder)
    (folder / REPORT).write_text(report(measured), "utf-8")
    (folder / SUMMARY).write_text(summary(measured), "utf-8")


def report(measured: Measurement) -> str:
    """The report in Markdown, diagrams included by name."""
    machine = "\n".join(f"| {name} | {value} |" for name, value in measured.machine.items())
    shown = "\n".join(f"- {finding}" for finding in findings(measured))
    parts = [
        "# Error against run time",
        f"|  |  |\n|---|---|\n{machine}",
        "## What the diagrams show",
        shown,
        "![Error against time per variant](work_precision.png)",
        "![Error against condition number](conditioning.png)",
        "![Error against time of a passage](motion.png)",
        "## How it was measured",
        _METHOD.format(digits=measured.machine["mpmath"].split("(")[-1].rstrip(")")),
        "## An instant",
        classes_markdown(measured),
        "## Motion over time",
        motion_markdown(measured),
    ]
    return "\n\n".join(parts) + "\n"
