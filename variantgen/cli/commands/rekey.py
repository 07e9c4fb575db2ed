"""``variantgen rekey``: another tolerance for sheets that are printed already."""

from __future__ import annotations

import argparse

from variantgen.cli.messages import counted, tell
from variantgen.cli.options import add_built_folder, add_families
from variantgen.errors import InputError, Problem

HELP = "give a finished exam another tolerance"
DESCRIPTION = (
    "Give a finished exam another tolerance: a new key, manifest, workbooks and files for platforms, from the\n"
    "manifest alone. The data, the sheets and the solutions stay as they are; of what is made again, files that\n"
    "somebody has edited are kept in the folder edited/."
)


def add_arguments(parser: argparse.ArgumentParser) -> None:
    """Options of the command."""
    add_built_folder(parser)
    parser.add_argument(
        "--tolerance",
        "--floor",
        dest="floors",
        action="append",
        default=[],
        metavar="[PROBLEM=]NUMBER",
        help="least relative tolerance, like 0.02, or 3=0.05 for problem 3 (may be repeated); where rounding needs"
        " more, an answer has more",
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
    from variantgen.exam.manifest import read_manifest
    from variantgen.families.reading.folders import family_folders
    from variantgen.finished.rekey import marking, rekey
    from variantgen.finished.restore import restore_unchanged
    from variantgen.outputs.typst.typesetter import typesetter

    finished = restore_unchanged(read_manifest(arguments.folder), family_folders(arguments.families))
    chosen = marking(finished.exam, dict(map(_floor, arguments.floors)), arguments.ceiling)
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


def _floor(text: str) -> tuple[int | None, float]:
    """A tolerance with the number of its problem, if it is for one. Raises InputError."""
    number, equals, value = text.rpartition("=")
    try:
        return (int(number) if equals else None), float(value)
    except ValueError:
        remedy = "for example 0.02, or 3=0.05 for problem 3 alone"
        raise InputError(Problem("expected a number", key="--tolerance", value=text, remedy=remedy)) from None


def _few(files: tuple[str, ...]) -> str:
    """The files by name, folders of many by theirs."""
    return ", ".join(dict.fromkeys(f"{name.split('/')[0]}/" if name.count("/") > 1 else name for name in files))
