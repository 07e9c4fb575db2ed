"""``variantgen compose``: a family that nobody wrote."""

from __future__ import annotations

import argparse
from pathlib import Path

from variantgen.cli.messages import say, tell

_MOST = 30  # structures that are tried
HELP = "make a family of a mechanism that nobody drew"
DESCRIPTION = (
    "Make a mechanism of a driving link and groups of two links (dyads), lay it out, and write it as an ordinary family"
    " folder to check, to edit and to use in exams. The same options and seed give the same family."
)


def add_arguments(parser: argparse.ArgumentParser) -> None:
    """Options of the command."""
    parser.add_argument("--groups", default="", metavar="RRR,RRP,...", help="the kinds of its dyads (default: any)")
    parser.add_argument("--links", type=int, metavar="N", help="how many links move: 3, 5 or 7")
    parser.add_argument("--level", choices=("easy", "medium", "hard"), default="", help="by the work of its solutions")
    parser.add_argument("--structure", default="", metavar="CODE", help="one structure: a code of list --structures")
    parser.add_argument("--seed", default="0", metavar="SEED", help="chooses structure and layout (default: 0)")
    parser.add_argument("--out", type=Path, required=True, metavar="FOLDER", help="the folder of the new family")


def run(arguments: argparse.Namespace) -> int:
    """Choose a structure, make the family, say what to do next. Raises InputError."""
    from variantgen.errors import InputError, Problem
    from variantgen.exam.composed import shuffled, write
    from variantgen.exam.wanted_work import LEVELS, level_of
    from variantgen.synthesis.levels import chosen_structures
    from variantgen.synthesis.structures import code, parse_code

    out: Path = arguments.out
    if out.exists():
        raise InputError(Problem("exists already", file=str(out), key="--out", remedy="choose another folder"))
    if arguments.structure:
        structures = [parse_code(arguments.structure)]
    else:
        groups = tuple(filter(None, arguments.groups.split(",")))
        structures = shuffled(chosen_structures(groups, arguments.links), arguments.seed, arguments.level)
    span = LEVELS[arguments.level] if arguments.level else None
    for number, structure in enumerate(structures[:_MOST], start=1):
        try:
            calculations = write(structure, arguments.seed, out, span)
        except InputError:
            if number == min(_MOST, len(structures)):
                raise
            continue
        break
    say(out)
    tell(f"structure {code(structure)}, {calculations} calculations: {level_of(calculations)}")
    tell(f"look:  variantgen show {out} --out page.png\ncheck: variantgen check {out}")
    return 0
