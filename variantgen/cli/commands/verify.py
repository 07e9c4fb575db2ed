"""``variantgen verify``: are the answers of a finished exam right, and its files as they were built?"""

from __future__ import annotations

import argparse
import json
import sys
from dataclasses import asdict
from pathlib import Path

from variantgen.cli.options import add_families

HELP = "compute every answer of a finished exam again"
DESCRIPTION = (
    "Compute every answer of a finished exam again, from its manifest alone and by a path that shares nothing with\n"
    "the solver, and compare the files with those that were built. Exit code 1 if anything is wrong; workbooks and\n"
    "LaTeX sources are there to be edited, which is said and no fault."
)
_SHOWN = 20


def add_arguments(parser: argparse.ArgumentParser) -> None:
    """Options of the command."""
    parser.add_argument("folder", metavar="OUT_DIR", type=Path, help="folder that  variantgen build  has made")
    parser.add_argument("--json", action="store_true", help="the result as one JSON document on stdout")
    add_families(parser)


def run(arguments: argparse.Namespace) -> int:
    """Verify the folder."""
    from variantgen.exam.record import read_record
    from variantgen.families.folders import family_folders
    from variantgen.finished.restore import restore
    from variantgen.finished.verify import verify

    finished = restore(read_record(arguments.folder), family_folders(arguments.families))
    found = verify(finished, arguments.folder)
    if arguments.json:
        print(json.dumps({**asdict(found), "differences": finished.differences}, ensure_ascii=False, indent=1))
    for difference in finished.differences:
        print(f"not as when the exam was made: {difference}", file=sys.stderr)
    for fault in found.faults[:_SHOWN]:
        print(fault, file=sys.stderr)
    if len(found.faults) > _SHOWN:
        print(f"and {len(found.faults) - _SHOWN} more", file=sys.stderr)
    for name in found.edited:
        print(f"edited since the build, which is no fault: {name}", file=sys.stderr)
    told = f"{found.answers} answers of {found.students} students computed again"
    if found.faults:
        print(f"{told}; faults: {len(found.faults)}", file=sys.stderr)
        return 1
    changed = "no other file changed" if found.edited else "no file changed"
    print(f"{told}: all right (largest difference {found.largest:.0e}), {changed}", file=sys.stderr)
    return 0
