"""``variantgen show``: one problem as a student sees it, with its answers; of an exam the sheet of one student."""

from __future__ import annotations

import argparse
from pathlib import Path
from typing import TYPE_CHECKING

from variantgen.cli.exam_preview import add_students, check_options, exam_file, show_exam
from variantgen.cli.messages import say, tell
from variantgen.cli.options import (
    add_choice,
    add_explaining,
    add_language,
    check_explaining,
    explained,
    tell_doubts,
    wanted_variant,
)
from variantgen.errors import InputError, Problem

if TYPE_CHECKING:
    from variantgen.variants.variant import Variant

HELP = "show one problem of a family, or one sheet of an exam"
DESCRIPTION = """\
Show one problem of a family or of a scene file: statement, data, answers;
with --out also its figure, with --motion plots of its motion.
Of an exam file: the sheet of one student (--student, --roster), with --explain the solutions."""


def add_arguments(parser: argparse.ArgumentParser) -> None:
    """Options of the command."""
    add_choice(parser, "family, scene or exam file")
    add_language(parser)
    add_explaining(parser)
    parser.add_argument(
        "--motion",
        type=Path,
        metavar="FILE",
        help="plot the motion over the way of the driver: .pdf, .svg, .png or .gif",
    )
    parser.add_argument("--out", type=Path, metavar="FILE", help="write a page: .pdf, .png or .svg")
    parser.add_argument(
        "--figure", type=Path, metavar="FILE", help="write the figure alone: .svg, .png, .pdf, .tikz or .tex"
    )
    parser.add_argument(
        "--view",
        default="",
        metavar="KIND",
        help="kind of figure (default: statement); of several in a solution one by its number: velocity_equation:2",
    )
    parser.add_argument("--true-scale", action="store_true", help="no vector of a figure is lengthened to be seen")
    add_students(parser)
    parser.set_defaults(seed=None, lang="")  # an exam has its own


def run(arguments: argparse.Namespace) -> int:
    """Print the problem or write its page. Raises InputError where it cannot be read or solved."""
    from variantgen.families.reading.folders import family_folders

    exam = exam_file(arguments.family, family_folders(arguments.families))
    check_options(arguments, of_an_exam=exam is not None)
    check_explaining(arguments)
    if exam is not None:
        show_exam(arguments, exam)
    elif arguments.view and not arguments.figure:
        raise InputError(Problem("only has a meaning for a figure", key="--view", remedy="add --figure FILE"))
    else:
        arguments.seed, arguments.lang = "0" if arguments.seed is None else arguments.seed, arguments.lang or "en"
        _show_problem(arguments)
    return 0


def _show_problem(arguments: argparse.Namespace) -> None:
    """One problem of a family or a scene."""
    from variantgen.mechanism.outcome import Outcome
    from variantgen.single import asked_quantities, document_and_answers
    from variantgen.wording.language import load_language
    from variantgen.wording.plain import plain_problem

    variant = wanted_variant(arguments)
    document, answers = document_and_answers(variant, arguments.ask)
    outcome = Outcome[document["outcome"].upper()]
    if outcome is not Outcome.SOLVED:
        raise InputError(Problem(outcome.text, file=arguments.family))
    tell_doubts(arguments, variant)
    asked = asked_quantities(variant, arguments.ask)
    if arguments.figure:
        _write_figures(arguments, variant)
    solution = explained(arguments, variant)
    remark = f"{variant.family.name}  ·  seed {arguments.seed}"
    if arguments.motion:
        from variantgen.outputs.single.motion_plot import write_motion

        write_motion(variant, asked, arguments.lang, arguments.motion, remark)
        tell(f"written: {arguments.motion}")
    if arguments.out and solution is not None:
        solution.save(arguments.out, remark)
        tell(f"written: {arguments.out}")
    elif arguments.out:
        from variantgen.outputs.single.problem_page import write_single

        write_single(variant, asked, answers, arguments.lang, arguments.out, remark)
        tell(f"written: {arguments.out}")
    if not (arguments.out or arguments.motion or arguments.figure):
        values = [(answer.value, answer.unit, answer.surd) for answer in answers]
        say(plain_problem(variant, asked, values, load_language(arguments.lang)))
        if solution is not None:
            say(f"\n{solution}")


def _write_figures(arguments: argparse.Namespace, variant: Variant) -> None:
    """The figure of a kind; where a solution has several, a file for each, with its number before the ending."""
    from variantgen.outputs.single.picture import pictures

    path: Path = arguments.figure
    methods = arguments.method if arguments.explain else ()
    found = pictures(
        variant, arguments.view or "statement", arguments.lang, arguments.ask, methods, arguments.true_scale
    )
    for number, each in enumerate(found, start=1):
        goal = path if len(found) == 1 else path.with_stem(f"{path.stem}-{number}")
        each.save(goal)
        tell(f"written: {goal}")
