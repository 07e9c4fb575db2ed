"""``variantgen check``: whether families can be trusted."""

from __future__ import annotations

import argparse
import json
from pathlib import Path

from variantgen.cli.messages import counted, say, tell
from variantgen.cli.options import add_families
from variantgen.errors import InputError, Problem

_MOST_SEEDS = 100_000
HELP = "check families"
DESCRIPTION = """\
Check families, those of the catalogue or your own: schema, worked cases, every language, many seeds,
agreement with the independent computation, invariants, variety, spread of the answers, figures;
lengths, radii, angles, rates and words for senses on the sheets agree with what is solved.
With --figures the figure of every form is drawn, so that you see what the scene is.
Exit code 1 if anything is wrong."""


def add_arguments(parser: argparse.ArgumentParser) -> None:
    """Options of the command."""
    parser.add_argument(
        "names", nargs="*", metavar="FAMILY_OR_FILE", help="families to check (default: all that are found)"
    )
    parser.add_argument("--seeds", type=int, default=200, help="variants to draw per form (default: 200)")
    parser.add_argument(
        "--figures",
        type=Path,
        metavar="DIR",
        help="draw every form into this folder: FAMILY-FORM.svg; only files of an earlier check are replaced",
    )
    parser.add_argument("--json", action="store_true", help="print one JSON document")
    add_families(parser)


def run(arguments: argparse.Namespace) -> int:
    """Print a report per family. Raises InputError for a wrong option and for files that cannot be read."""
    from variantgen.check.family import check_family
    from variantgen.check.figures import FigureFolder
    from variantgen.check.report import Report
    from variantgen.families.reading.folders import family_folders, family_names

    if not 1 <= arguments.seeds <= _MOST_SEEDS:
        raise InputError(Problem(f"expected 1 to {_MOST_SEEDS}", key="--seeds", value=str(arguments.seeds)))
    folders = family_folders(arguments.families)
    names = arguments.names or family_names(folders)
    drawn = FigureFolder(arguments.figures, names, folders) if arguments.figures else None
    reports: list[Report] = []
    problems: list[Problem] = []
    for name in names:
        try:
            reports.append(check_family(name, arguments.seeds, folders))
            if drawn:
                reports[-1].remarks += drawn.draw(name)
        except InputError as error:
            problems += error.problems
            continue
        if not arguments.json:
            say(reports[-1].as_text())
    if drawn:
        tell(f"{counted(drawn.count, 'figure')} in {arguments.figures}")
    if problems:
        raise InputError(problems)
    if arguments.json:
        say(json.dumps([report.as_json() for report in reports], ensure_ascii=False, indent=2))
    return 1 if any(report.failures for report in reports) else 0
