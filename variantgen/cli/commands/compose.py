"""``variantgen compose``: a family that nobody wrote."""

from __future__ import annotations

import argparse
from pathlib import Path

from variantgen.cli.messages import say, tell
from variantgen.errors import InputError, Problem

_MOST = 30  # structures that are tried
HELP = "make a family of a mechanism that nobody drew"
DESCRIPTION = (
    "Make a mechanism of a driving link and groups of two links (dyads), lay it out, and write it as an ordinary family"
    " folder to check, to edit and to use in exams. The same options and seed give the same family."
)


def add_arguments(parser: argparse.ArgumentParser) -> None:
    """Options of the command."""
    parser.add_argument("--groups", default="", metavar="RRR,RRP,...", help="the kinds of its groups (default: any)")
    parser.add_argument("--links", type=int, metavar="N", help="how many links move: 3, 5, 7 (4, 6 with gear or rack)")
    parser.add_argument("--level", choices=("easy", "medium", "hard"), default="", help="by the work of its solutions")
    parser.add_argument("--structure", default="", metavar="CODE", help="one structure: a code of list --structures")
    parser.add_argument("--seed", default="0", metavar="SEED", help="chooses structure and layout (default: 0)")
    parser.add_argument("--out", type=Path, metavar="FOLDER", help="the folder of the new family")
    parser.add_argument(
        "--exam", type=Path, metavar="FILE", help="write the families of all pools of this exam beside it, to keep them"
    )


def _check_together(arguments: argparse.Namespace) -> None:
    """Raise InputError for options of which one would be passed over."""
    chosen = [f"--{name}" for name in ("groups", "links", "level", "structure", "out") if getattr(arguments, name)]
    if arguments.exam is not None and chosen:
        raise InputError(Problem(f"has no place for {chosen[0]}", key="--exam", remedy="the exam file says what it is"))
    if arguments.structure and (arguments.groups or arguments.links):
        raise InputError(Problem("says all of them", key="--structure", remedy="leave out --groups and --links"))


def _keep_pools(path: Path) -> None:
    """Write the families of the pools of an exam beside its file, where every later command finds them."""
    from variantgen.exam.sections.named_families import composing
    from variantgen.families.reading.files import family_files
    from variantgen.outputs.formats import read_exam

    composing.set(tell)
    found = {f.name: f.folder for task in read_exam(path).tasks if task.composed for f in task.families if f.folder}
    for name, folder in sorted(found.items()):
        new = path.resolve().parent / name
        if folder.resolve() != new:
            new.mkdir()
            for file, content in family_files(folder).items():
                (new / file).write_bytes(content)
            say(new)
    tell(f"{len(found)} families of pools lie beside {path}" if found else f"{path} has no problem with compose = ...")


def _groups(text: str) -> tuple[str, ...]:
    """The kinds of groups that are named; none for no text. Raises InputError for an empty or repeated one."""
    kinds = tuple(kind.strip() for kind in text.split(",")) if text else ()
    if "" in kinds:
        raise InputError(Problem("a kind is empty", key="--groups", value=text, remedy="write it like RRR,RRP"))
    if len(set(kinds)) < len(kinds):
        remedy = "name each kind once; how many of them there are is said by --structure CODE"
        raise InputError(Problem("a kind is named twice", key="--groups", value=text, remedy=remedy))
    return kinds


def run(arguments: argparse.Namespace) -> int:
    """Choose a structure, make the family, say what to do next; or keep the pools of an exam. Raises InputError."""
    _check_together(arguments)
    if arguments.exam is not None:
        _keep_pools(arguments.exam)
        return 0
    if arguments.out is None:
        raise InputError(Problem("missing", key="--out", remedy="name the folder of the new family"))
    from variantgen.exam.composed import write
    from variantgen.exam.composed_pools import shuffled
    from variantgen.exam.work.wanted_work import LEVELS, level_of
    from variantgen.synthesis.levels import chosen_structures
    from variantgen.synthesis.structures import code, is_textbook, parse_code

    out: Path = arguments.out
    if out.exists():
        raise InputError(Problem("exists already", file=str(out), key="--out", remedy="choose another folder"))
    if arguments.structure:
        structures = [parse_code(arguments.structure)]
    else:
        groups = _groups(arguments.groups)
        structures = shuffled(chosen_structures(groups, arguments.links), arguments.seed, arguments.level)
    spans = dict.fromkeys((2, 1), LEVELS[arguments.level]) if arguments.level else None
    for number, structure in enumerate(structures[:_MOST], start=1):
        try:
            calculations = write(structure, arguments.seed, out, spans)
        except InputError:
            if number == min(_MOST, len(structures)):
                raise
            continue
        break
    say(out)
    if not is_textbook(structure):
        tell(f"{code(structure)} is a structure that no textbook would print: several outputs, many joints or slides")
    tell(f"structure {code(structure)}, {calculations} calculations: {level_of(calculations)}")
    tell(f"look:  variantgen show {out} --out page.png\ncheck: variantgen check {out}")
    return 0
