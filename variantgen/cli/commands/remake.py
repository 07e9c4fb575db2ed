"""``variantgen remake``: one student's sheet again, from the manifest of a finished exam."""

from __future__ import annotations

import argparse
from pathlib import Path

from variantgen.cli.messages import tell
from variantgen.cli.options import add_built_folder, add_families
from variantgen.errors import InputError, Problem

HELP = "make one student's sheet of a finished exam again"
DESCRIPTION = (
    "Make the sheet of one student again, from the manifest of a finished exam alone, and compare it with what was\n"
    "handed out. Where it is not the same, what differs is said (exit code 1), and nothing is written without --anyway."
)


def add_arguments(parser: argparse.ArgumentParser) -> None:
    """Options of the command."""
    add_built_folder(parser)
    parser.add_argument(
        "--student",
        required=True,
        metavar="WHO",
        help="the code of the sheet, the text of its QR code, the name or a part of it, or the id",
    )
    parser.add_argument("--solutions", action="store_true", help="the worked solutions instead of the sheet")
    parser.add_argument("--out", type=Path, metavar="FILE.pdf", help="default: the code of the sheet, here")
    parser.add_argument("--anyway", action="store_true", help="write it although something differs")
    add_families(parser)


def run(arguments: argparse.Namespace) -> int:
    """Make the sheet. Raises InputError, before anything is made, for a file whose ending is not that of a PDF."""
    out: Path | None = arguments.out
    if out is not None and out.suffix.lower() != ".pdf":
        remedy = str(out / "sheet.pdf") if out.is_dir() else f"{out}.pdf"
        raise InputError(Problem("expected a file that ends in .pdf", key="--out", value=str(out), remedy=remedy))
    from variantgen.exam.manifest import read_manifest
    from variantgen.families.reading.folders import family_folders
    from variantgen.finished.find import find
    from variantgen.finished.remake import SHEETS, SOLUTIONS, remake
    from variantgen.finished.restore import restore
    from variantgen.outputs.figures import write_whole
    from variantgen.outputs.typst.typesetter import typesetter

    record = read_manifest(arguments.folder)
    place = find(record, arguments.student)
    finished = restore(record, family_folders(arguments.families))
    target = SOLUTIONS if arguments.solutions else SHEETS
    with typesetter() as engine:
        made = remake(finished, place, target, arguments.folder, engine)
    for difference in finished.differences:
        tell(f"not as when the exam was made: {difference}")
    for fault in made.faults:
        tell(f"not the same: {fault}")
    unsure = bool(made.faults) or (not made.same and bool(finished.differences))
    if unsure and not arguments.anyway:
        tell("nothing was written; --anyway writes what can be made now")
        return 1
    path = out or Path(f"{made.stem}{'-solutions' if arguments.solutions else ''}.pdf")
    write_whole(path, made.content, "--out")
    same = f", the same as {made.same}" if made.same else ""
    tell(f"{path}{same}")
    return 0
