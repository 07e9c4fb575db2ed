"""``variantgen accuracy``: error against run time, for those who want to know why the key can be trusted."""

from __future__ import annotations

import argparse
from pathlib import Path

from variantgen.cli.messages import say, tell

HELP = "measure error against run time"
DESCRIPTION = """\
Measure the errors of the solver and of other ways to compute against a reference of many digits, and their times:
report.md, tables (CSV) and diagrams (PDF, PNG) in a new folder. Takes some fifteen minutes, --quick less than one.
Needs the packages mpmath and matplotlib: pip install ".[accuracy]" in the folder of variantgen."""


def add_arguments(parser: argparse.ArgumentParser) -> None:
    """Options of the command."""
    parser.add_argument("--out", type=Path, required=True, metavar="DIR", help="folder to be made")
    parser.add_argument("--quick", action="store_true", help="fewer variants, tolerances and turns")
    parser.add_argument("--force", action="store_true", help="replace an earlier output of this command whole")


def run(arguments: argparse.Namespace) -> int:
    """Measure and write the folder."""
    from variantgen.accuracy.report.diagrams import need_matplotlib
    from variantgen.accuracy.report.findings import findings
    from variantgen.accuracy.report.report_files import FILES, write
    from variantgen.accuracy.run import FULL, QUICK
    from variantgen.accuracy.run import run as measure
    from variantgen.outputs.files.folder import check_free, whole_folder

    need_matplotlib()
    check_free(arguments.out, arguments.force, lambda: FILES)
    measured = measure(QUICK if arguments.quick else FULL, tell)
    with whole_folder(arguments.out, arguments.force, lambda: FILES) as folder:
        write(measured, folder)
    for finding in findings(measured):
        say(finding)
    return 0
