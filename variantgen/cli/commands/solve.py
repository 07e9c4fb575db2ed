"""``variantgen solve``: the numbers of one problem."""

from __future__ import annotations

import argparse
import json
from collections.abc import Iterator, Sequence
from math import isfinite
from typing import TYPE_CHECKING, Any

from variantgen.cli.columns import in_columns
from variantgen.cli.exam_preview import refuse_exam
from variantgen.cli.messages import say
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
    from variantgen.everything import ResultTable
    from variantgen.exam.sheets import Answer
    from variantgen.variants.variant import Variant

_DIGITS = 5
_NO_COURSE = (
    "no value: it does not come in the interval of time, the mechanism cannot move all through it, or no law places "
    "its points"
)
_NO_TURN = "no value: it does not change over a turn, nothing moves to and fro, or the crank cannot make the turn"
HELP = "solve one variant"
DESCRIPTION = "Solve one variant of a family, or a scene file: positions, velocities, accelerations."


def add_arguments(parser: argparse.ArgumentParser) -> None:
    """Options of the command."""
    add_choice(parser)
    parser.add_argument("--json", action="store_true", help="print one JSON document (SI units and radians)")
    parser.add_argument("--all", action="store_true", help="tables of everything that can be known of it")
    add_language(parser)
    add_explaining(parser)


def run(arguments: argparse.Namespace) -> int:
    """Print parameters and answers, the solution in words, or all numbers as JSON.

    Raises InputError where the problem cannot be read or solved, and for options that contradict each other.
    """
    _check_options(arguments)
    from variantgen.mechanism.outcome import Outcome
    from variantgen.single import document_and_answers
    from variantgen.wording.words import check_language

    check_language(arguments.lang)
    variant = wanted_variant(arguments)
    document, answers = document_and_answers(variant, arguments.ask)
    outcome = Outcome[document["outcome"].upper()]
    tell_doubts(arguments, variant)
    tables: list[ResultTable] = []
    if arguments.all and outcome is Outcome.SOLVED:
        from variantgen.everything import all_values, everything

        tables = everything(variant)
        document |= {"all": all_values(variant), "tables": [table.data for table in tables]}
    if arguments.json:
        try:
            say(json.dumps(document, ensure_ascii=False, indent=2, allow_nan=False))
        except ValueError:
            raise InputError(Problem("the numbers grow beyond all bounds", file=arguments.family)) from None
    if outcome is not Outcome.SOLVED:
        raise InputError(Problem(outcome.text, file=arguments.family))
    if not arguments.json:
        _say_parameters(document["parameters"])
        _say_results(arguments, variant, answers, tables)
    return 0


def _check_options(arguments: argparse.Namespace) -> None:
    """Raise InputError for options that contradict each other, and for an exam."""
    check_explaining(arguments)
    if arguments.json and arguments.explain:
        raise InputError(Problem("the document holds numbers only", key="--json", remedy="choose --json or --explain"))
    for option, chosen in (("--ask", arguments.ask), ("--explain", arguments.explain)):
        if arguments.all and chosen:
            raise InputError(Problem("has everything in tables", key="--all", remedy=f"leave out --all or {option}"))
    refuse_exam(arguments, "solve works out one problem")


def _say_parameters(parameters: dict[str, dict[str, Any]]) -> None:
    """A line for each parameter, words without a unit."""
    for name, item in parameters.items():
        value = f"{item['value']:g} {item['unit']}".removesuffix(" 1") if item["unit"] else item["value"]
        say(f"{name} = {value}")
    if parameters:
        say()


def _say_results(
    arguments: argparse.Namespace, variant: Variant, answers: Sequence[Answer], tables: Sequence[ResultTable]
) -> None:
    """The tables of everything, the solution, or the answers."""
    if arguments.all:
        say("\n\n".join("\n".join(_lines(table)) for table in tables))
    elif (solution := explained(arguments, variant)) is not None:
        say(solution)
    else:
        for answer in answers:
            say(_told(answer))


def _lines(table: ResultTable) -> Iterator[str]:
    """A table with names and units of its columns, numbers with five digits."""
    rows = [[table.title, *(name for name, _ in table.columns)], ["", *(unit for _, unit in table.columns)]]
    rows += [[name, *("-" if x is None else f"{x:.{_DIGITS}g}" for x in row)] for name, row in table.rows.items()]
    return in_columns(rows, numbers=True)


def _told(answer: Answer) -> str:
    """``v_B = 40√3/3 ≈ 23.094 cm/s``: the closed form, if there is one, and the decimal."""
    if not isfinite(answer.value):
        quantity = answer.quantity
        reason = _NO_TURN if quantity.is_of_turn else _NO_COURSE if quantity.is_of_interval else ""
        return quantity.name + (f": {reason}" if reason else " = infinite")
    exact = "="
    if answer.surd:
        from variantgen.wording.formula import to_plain  # few answers have a closed form

        exact = f"= {to_plain(answer.surd)} ≈".replace("\N{MINUS SIGN}", "-")
    return f"{answer.quantity.name} {exact} {answer.value:.6g} {answer.unit.name}".removesuffix(" 1")
