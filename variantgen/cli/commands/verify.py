"""``variantgen verify``: are the answers of a finished exam right, and its files as they were built?"""

from __future__ import annotations

import argparse
import json

from msgspec.structs import asdict

from variantgen.cli.messages import counted, say, tell
from variantgen.cli.options import add_built_folder, add_families

HELP = "compute every answer of a finished exam again"
DESCRIPTION = (
    "Compute every answer of a finished exam again, from its manifest alone and by a path that shares nothing with\n"
    "the solver, and compare the files with those that were built. Exit code 1 if anything is wrong; workbooks and\n"
    "LaTeX sources are there to be edited, which is said and no fault."
)
_SHOWN = 20


def add_arguments(parser: argparse.ArgumentParser) -> None:
    """Options of the command."""
    add_built_folder(parser)
    parser.add_argument("--json", action="store_true", help="the result as one JSON document on stdout")
    add_families(parser)


def run(arguments: argparse.Namespace) -> int:
    """Verify the folder."""
    from variantgen.exam.manifest import read_manifest
    from variantgen.families.reading.folders import family_folders
    from variantgen.finished.restore import restore
    from variantgen.finished.verify import verify

    finished = restore(read_manifest(arguments.folder), family_folders(arguments.families))
    found = verify(finished, arguments.folder)
    if arguments.json:
        say(json.dumps({**asdict(found), "differences": finished.differences}, ensure_ascii=False, indent=1))
    for difference in finished.differences:
        tell(f"not as when the exam was made: {difference}")
    for fault in found.faults[:_SHOWN]:
        tell(fault)
    if len(found.faults) > _SHOWN:
        tell(f"and {len(found.faults) - _SHOWN} more")
    for name in found.edited:
        tell(f"edited since the build, which is no fault: {name}")
    summary = f"{counted(found.answers, 'answer')} of {counted(found.students, 'student')} computed again"
    if found.faults:
        tell(f"{summary}; faults: {len(found.faults)}")
        return 1
    changed = "no other file changed" if found.edited else "no file changed"
    tell(f"{summary}: all right (largest difference {found.largest:.0e}), {changed}")
    return 0
