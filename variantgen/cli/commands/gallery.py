"""``variantgen gallery``: figures of families to look at."""

from __future__ import annotations

import argparse
import time
from pathlib import Path

from variantgen.cli.messages import counted, tell
from variantgen.cli.options import add_families, add_language, add_nice, at_least_one

HELP = "make a gallery of figures"
DESCRIPTION = "Make a gallery of families: index.html, gallery.pdf and the figures as SVG in a new folder."


def add_arguments(parser: argparse.ArgumentParser) -> None:
    """Options of the command."""
    parser.add_argument("family", nargs="*", metavar="FAMILY", help="families to show (default: all)")
    parser.add_argument("--out", type=Path, required=True, metavar="DIR", help="folder to be made")
    add_language(parser)
    parser.add_argument("--each", type=int, default=3, metavar="N", help="variants of each form (default: 3)")
    parser.add_argument("--seed", type=int, default=1, metavar="S", help="seed of the first of them (default: 1)")
    add_nice(parser)
    parser.add_argument("--force", action="store_true", help="replace an earlier gallery whole")
    add_families(parser)


def run(arguments: argparse.Namespace) -> int:
    """Write the folder."""
    from variantgen.families.reading.folders import family_folders, family_names
    from variantgen.families.reading.load import load_family
    from variantgen.outputs.gallery import GalleryRequest, write_gallery

    at_least_one("--each", arguments.each)
    folders = family_folders(arguments.families)
    names = list(dict.fromkeys(arguments.family)) or family_names(folders)
    families = [load_family(name, folders) for name in names]
    options = tuple(part for folder in arguments.families for part in ("--families", str(folder)))
    options += ("--nice",) if arguments.nice else ()
    wanted = GalleryRequest(families, arguments.lang, arguments.each, arguments.seed, folders, options, arguments.nice)
    start = time.perf_counter()
    count = write_gallery(wanted, arguments.out, arguments.force)
    tell(f"{counted(count, 'figure')} in {arguments.out} ({time.perf_counter() - start:.1f} s)")
    return 0
