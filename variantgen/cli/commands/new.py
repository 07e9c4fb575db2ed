"""``variantgen new``: a working beginning to edit."""

from __future__ import annotations

import argparse
from pathlib import Path

from variantgen.cli.messages import say, tell

HELP = "start a family or an exam"
DESCRIPTION = "Write a working family folder or exam file to edit."


def add_arguments(parser: argparse.ArgumentParser) -> None:
    """Options of the command."""
    parser.add_argument("kind", choices=("family", "exam"), help="what to write")
    parser.add_argument("name", metavar="NAME", help="its name: small letters, digits, underscores")
    parser.add_argument(
        "--out", type=Path, default=Path(), metavar="DIR", help="folder to write into (default: the current one)"
    )


def run(arguments: argparse.Namespace) -> int:
    """Write the files and say what to do next."""
    from variantgen.skeletons import new_exam, new_family

    if arguments.kind == "family":
        path = new_family(arguments.name, arguments.out)
        hint = f"look:  variantgen show {path} --out page.png\ncheck: variantgen check {path}"
    else:
        path = new_exam(arguments.name, arguments.out)
        hint = f"build: variantgen build {path} --variants 3 --out {path.stem}-sheets"
    say(path)
    tell(hint)
    return 0
