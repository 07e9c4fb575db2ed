"""``variantgen rekey``: another tolerance for sheets that are printed already."""

from __future__ import annotations

import argparse
from pathlib import Path

from variantgen.cli.messages import counted, tell
from variantgen.cli.options import add_families

HELP = "give a finished exam another tolerance"
DESCRIPTION = (
    "Give a finished exam another tolerance: a new key, manifest, workbooks and files for platforms, from the\n"
    "manifest alone. The data, the sheets and the solutions stay as they are; of what is made again, files that\n"
    "somebody has edited are kept in the folder edited/."
)


def add_arguments(parser: argparse.ArgumentParser) -> None:
    """Options of the command."""
    parser.add_argument("folder", metavar="OUT_DIR", type=Path, help="folder that  variantgen build  has made")
    parser.add_argument(
        "--tolerance",
        "--floor",
        dest="floor",
        type=float,
        metavar="NUMBER",
        help="least relative tolerance of an answer, like 0.02; where rounding needs more, the answer has more",
    )
    parser.add_argument(
        "--ceiling",
        type=float,
        metavar="NUMBER",
        help="refuse if an answer of a sheet would need more than this",
    )
    add_families(parser)


def run(arguments: argparse.Namespace) -> int:
    """Write the new key."""
    from variantgen.exam.record import read_record
    from variantgen.families.folders import family_folders
    from variantgen.finished.rekey import marking, rekey
    from variantgen.finished.restore import restore
    from variantgen.outputs.typesetter import typesetter

    finished = restore(read_record(arguments.folder), family_folders(arguments.families))
    chosen = marking(finished.exam.tolerance, arguments.floor, arguments.ceiling)
    with typesetter() as engine:
        made = rekey(finished, arguments.folder, chosen, engine)
    for difference in finished.differences:
        tell(f"not as when the exam was made: {difference}")
    for note in made.notes:
        tell(note)
    have = "has" if made.changed == 1 else "have"
    tell(f"{made.changed} of {counted(made.answers, 'answer')} {have} another tolerance; no data, no sheets changed")
    tell(f"made again in {arguments.folder}: {_few(made.files)}")
    return 0


def _few(files: tuple[str, ...]) -> str:
    """The files by name, folders of many by theirs."""
    return ", ".join(dict.fromkeys(f"{name.split('/')[0]}/" if name.count("/") > 1 else name for name in files))
