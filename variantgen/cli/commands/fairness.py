"""``variantgen fairness``: did everyone in a finished exam get as much work as the others?"""

from __future__ import annotations

import argparse
from pathlib import Path

from variantgen.cli.columns import in_columns
from variantgen.cli.messages import say, tell
from variantgen.cli.options import add_built_folder, add_families
from variantgen.errors import InputError, Problem

HELP = "how equal the variants of a finished exam are in work"
DESCRIPTION = (
    "Say how much work the variants of a finished exam take, by problem and form and by sheet: calculations\n"
    "(operations and functions), negative numbers, obtuse angles; and how often each configuration was drawn\n"
    "in each group. With --out as a page with plots."
)


def add_arguments(parser: argparse.ArgumentParser) -> None:
    """Options of the command."""
    add_built_folder(parser)
    parser.add_argument("--out", type=Path, metavar="FILE.html", help="write a page with plots")
    add_families(parser)


def run(arguments: argparse.Namespace) -> int:
    """Print the table, and write the page. Raises InputError."""
    from variantgen.exam.manifest import read_manifest
    from variantgen.families.reading.folders import family_folders
    from variantgen.finished.restore import restore
    from variantgen.finished.work_report import counted, ratio, spread, work_report, write_report

    record = read_manifest(arguments.folder)
    report = work_report(record)
    if not report.forms:
        remedy = "build it without  fair = false,  or with  level  or  work  in its problems"
        raise InputError(Problem("no work is recorded in it", file=str(record.path), remedy=remedy))
    rows: list[tuple[str, ...]] = [
        ("problem", "form", "students", "calculations", "most/fewest", "negatives", "obtuse")
    ]
    for (number, form), own in report.forms.items():
        size = own["calculations"]
        spreads = spread(size), f"{ratio(size):.2f}", spread(own["negatives"]), spread(own["obtuse"])
        rows.append((str(number), form, str(size.total()), *spreads))
    if report.sheets:
        rows.append(("sheet", "", str(report.sheets.total()), spread(report.sheets), f"{ratio(report.sheets):.2f}"))
    for line in in_columns(rows):
        say(line)
    if report.configurations:
        say("\nhow often each configuration was drawn")
    for line in in_columns(
        [(str(number), form, group, counted(own)) for (number, form, group), own in report.configurations.items()]
    ):
        say(line)
    if arguments.out:
        exam = restore(record, family_folders(arguments.families)).exam
        try:
            write_report(arguments.out, report, exam.title, exam.course, exam.spoken)
        except OSError as error:
            raise InputError(Problem(f"cannot be written: {error.strerror}", file=str(arguments.out))) from None
        tell(f"written: {arguments.out}")
    return 0
