"""The command line. Messages and progress go to stderr; exit codes: 0 done, 1 a check failed, 2 wrong input,
3 an external tool is missing.
"""

from __future__ import annotations

import argparse
import json
import os
import sys
import time
from collections.abc import Callable, Sequence
from pathlib import Path
from typing import TypeAlias

from variantgen.errors import InputError, Problem, VariantgenError
from variantgen.version import VERSION

Commands: TypeAlias = "argparse._SubParsersAction[argparse.ArgumentParser]"

_EPILOG = """\
examples:
  variantgen list
  variantgen show four_bar --seed 3 --out problem.pdf
  variantgen solve slider_crank --set OA=20 --set "AB=0.6 m" --json
  variantgen build exam.toml --roster class.csv --out exam-2026
"""


def main(argv: Sequence[str] | None = None) -> int:
    """Run a command; returns the exit code."""
    arguments = _parser().parse_args(argv)
    try:
        run: Callable[[argparse.Namespace], int] = arguments.run
        code = run(arguments)
        sys.stdout.flush()
        return code
    except VariantgenError as error:
        print(f"variantgen: {error}", file=sys.stderr)
        return error.exit_code
    except KeyboardInterrupt:
        print("variantgen: interrupted, nothing was written", file=sys.stderr)
        return 130
    except BrokenPipeError:
        # The reader has gone; nothing more can be said to it, not even when Python flushes at the end.
        os.dup2(os.open(os.devnull, os.O_WRONLY), sys.stdout.fileno())
        return 0
    except OSError as error:
        print(f"variantgen: writing failed: {error.strerror}; free some space or choose another file", file=sys.stderr)
        os.dup2(os.open(os.devnull, os.O_WRONLY), sys.stdout.fileno())
        return 2


def _parser() -> argparse.ArgumentParser:
    parser = argparse.ArgumentParser(
        prog="variantgen",
        description="Individual problem sheets in planar kinematics, with figures to scale, keys and a manifest.",
        epilog=_EPILOG,
        formatter_class=argparse.RawDescriptionHelpFormatter,
    )
    parser.add_argument("--version", action="version", version=f"variantgen {VERSION}")
    commands = parser.add_subparsers(title="commands", required=True, metavar="COMMAND")
    _add_list(commands)
    _add_single(commands)
    _add_check(commands)
    _add_build(commands)
    return parser


def _add_list(commands: Commands) -> None:
    listing = commands.add_parser(
        "list", help="list the problem families", description="List the problem families of the catalogue."
    )
    listing.add_argument("--lang", default="en", help="language of the titles (default: en)")
    listing.add_argument("--json", action="store_true", help="print one JSON document")
    listing.set_defaults(run=_list)


def _add_single(commands: Commands) -> None:
    """``show`` and ``solve``: one problem, with the same ways to choose it."""
    one = argparse.ArgumentParser(add_help=False)
    one.add_argument("family", metavar="FAMILY_OR_FILE", help="name of a family, or path of a family or scene file")
    one.add_argument(
        "--set", action="append", default=[], metavar="NAME=VALUE", help="fix a parameter: OA=30, OA='0.3 m', side=left"
    )
    one.add_argument("--form", default="", help="take this form of the family")
    one.add_argument(
        "--ask", action="append", default=[], metavar="QUANTITY", help="ask for this (v_B, a_B.x, omega_AB, ...)"
    )
    one.add_argument("--seed", default="0", help="seed of the draw (default: 0)")

    show = commands.add_parser(
        "show",
        parents=[one],
        help="show one problem of a family",
        description="Show one problem: statement, data, answers; with --out also its figure.",
    )
    show.add_argument("--lang", default="en", help="language: en or ru (default: en)")
    show.add_argument("--out", type=Path, metavar="FILE", help="write a page: .pdf, .png or .svg")
    show.set_defaults(run=_show)

    solve = commands.add_parser(
        "solve",
        parents=[one],
        help="solve one variant",
        description="Solve one variant of a family, or a scene file: positions, velocities, accelerations.",
    )
    solve.add_argument("--json", action="store_true", help="print one JSON document (SI units and radians)")
    solve.set_defaults(run=_solve)


def _add_check(commands: Commands) -> None:
    check = commands.add_parser(
        "check",
        help="check families",
        description="Check families: worked cases, languages, many seeds, independent computation. "
        "Exit code 1 if anything is wrong.",
    )
    check.add_argument(
        "families", nargs="*", metavar="FAMILY_OR_FILE", help="families to check (default: the whole catalogue)"
    )
    check.add_argument("--seeds", type=int, default=200, help="variants to draw per form (default: 200)")
    check.add_argument("--json", action="store_true", help="print one JSON document")
    check.set_defaults(run=_check)


def _add_build(commands: Commands) -> None:
    build = commands.add_parser(
        "build",
        help="build an exam",
        description="Build an exam: sheets.pdf, key.pdf, key.csv and manifest.json in a new folder.",
    )
    build.add_argument("exam", metavar="EXAM.toml", type=Path, help="exam file, or the name of a sample exam")
    students = build.add_mutually_exclusive_group(required=True)
    students.add_argument(
        "--roster", type=Path, metavar="FILE", help="class list: CSV or XLSX with the columns id, name, group"
    )
    students.add_argument("--variants", type=int, metavar="N", help="no class list: N numbered variants")
    build.add_argument("--out", type=Path, required=True, metavar="DIR", help="folder to be made")
    build.add_argument("--seed", help="seed of the draw (default: the one in the exam file, or 0)")
    build.add_argument("--jobs", type=int, default=1, metavar="N", help="processes (default: 1)")
    build.add_argument("--force", action="store_true", help="replace an earlier output of this program whole")
    build.set_defaults(run=_build)


def _list(arguments: argparse.Namespace) -> int:
    from variantgen.families.load import family_names, load_family
    from variantgen.wording.language import load_language

    load_language(arguments.lang)
    families = [load_family(name) for name in family_names()]
    if arguments.json:
        rows = [{"family": f.name, "title": dict(f.titles), "forms": [n for n in f.forms if n]} for f in families]
        print(json.dumps(rows, ensure_ascii=False, indent=2))
        return 0
    width = max(len(family.name) for family in families)
    for family in families:
        forms = ", ".join(name for name in family.forms if name)
        print(f"{family.name:{width}}  {family.title(arguments.lang)}" + (f"  [{forms}]" if forms else ""))
    return 0


def _settings(arguments: argparse.Namespace) -> dict[str, str]:
    settings = {}
    for text in arguments.set:
        name, equals, value = text.partition("=")
        if not equals or not name.strip() or not value.strip():
            raise InputError(Problem("expected NAME=VALUE", key="--set", value=text, remedy="for example --set OA=30"))
        if name.strip() in settings:
            raise InputError(Problem("the parameter is set twice", key="--set", value=text, remedy="keep one of them"))
        settings[name.strip()] = value.strip()
    return settings


def _solve(arguments: argparse.Namespace) -> int:
    from variantgen.mechanism.outcome import Outcome
    from variantgen.single import one_variant, solution_document

    variant = one_variant(arguments.family, _settings(arguments), arguments.seed, arguments.form, arguments.ask)
    document = solution_document(variant, arguments.ask)
    if arguments.json:
        print(json.dumps(document, ensure_ascii=False, indent=2))
    outcome = Outcome[document["outcome"].upper()]
    if outcome is not Outcome.SOLVED:
        raise InputError(Problem(outcome.text, file=arguments.family))
    if not arguments.json:
        for name, item in document["parameters"].items():
            print(f"{name} = {item['value']:g} {item['unit']}" if item["unit"] else f"{name} = {item['value']}")
        print()
        for answer in document["answers"]:
            print(f"{answer['quantity']} = {answer['value']:.6g} {answer['unit']}")
    return 0


def _show(arguments: argparse.Namespace) -> int:
    from variantgen.mechanism.outcome import Outcome
    from variantgen.single import answers, asked_quantities, one_variant, solution_document
    from variantgen.wording.language import load_language
    from variantgen.wording.plain import plain_problem

    variant = one_variant(arguments.family, _settings(arguments), arguments.seed, arguments.form, arguments.ask)
    outcome = Outcome[solution_document(variant, arguments.ask)["outcome"].upper()]
    if outcome is not Outcome.SOLVED:
        raise InputError(Problem(outcome.text, file=arguments.family))
    asked, found = asked_quantities(variant, arguments.ask), answers(variant, arguments.ask)
    values = [(answer.value, answer.unit) for answer in found]
    if arguments.out:
        from variantgen.outputs.single_page import write_single

        write_single(
            variant, asked, found, arguments.lang, arguments.out, f"{variant.family.name}  ·  seed {arguments.seed}"
        )
        print(f"written: {arguments.out}", file=sys.stderr)
    else:
        print(plain_problem(variant, asked, values, load_language(arguments.lang)))
    return 0


def _check(arguments: argparse.Namespace) -> int:
    from variantgen.check import check_family
    from variantgen.families.load import family_names

    if arguments.seeds < 1:
        raise InputError(Problem("expected at least 1", key="--seeds", value=str(arguments.seeds)))
    reports = []
    for name in arguments.families or family_names():
        reports.append(check_family(name, arguments.seeds))
        if not arguments.json:
            print(reports[-1].as_text(), flush=True)
    if arguments.json:
        print(json.dumps([report.as_json() for report in reports], ensure_ascii=False, indent=2))
    return 1 if any(report.failures for report in reports) else 0


def _build(arguments: argparse.Namespace) -> int:
    from variantgen.builder import build
    from variantgen.exam.roster import numbered, read_roster
    from variantgen.exam.samples import exam_path

    if arguments.jobs < 1:
        raise InputError(Problem("expected at least 1", key="--jobs", value=str(arguments.jobs)))
    if arguments.variants is not None and not 1 <= arguments.variants <= 1_000_000:
        raise InputError(Problem("expected 1 to 1000000", key="--variants", value=str(arguments.variants)))
    students = read_roster(arguments.roster) if arguments.roster else numbered(arguments.variants)
    start = time.perf_counter()
    made = build(
        exam_path(arguments.exam),
        students,
        arguments.out,
        arguments.seed,
        arguments.jobs,
        arguments.force,
        _Progress().show,
    )
    seconds = time.perf_counter() - start
    if made.redrawn:
        print(f"drawn again to keep variants distinct: {', '.join(made.redrawn)}", file=sys.stderr)
    print(f"{made.students} sheets in {made.folder} ({seconds:.1f} s)", file=sys.stderr)
    return 0


class _Progress:
    """Progress on stderr for long work: a living line on a terminal, elsewhere a line every five seconds."""

    def __init__(self) -> None:
        self._start = time.perf_counter()
        self._last = self._start
        self._live = sys.stderr.isatty()

    def show(self, stage: str, done: int, total: int) -> None:
        """Show how far a stage is, at most five times a second."""
        now = time.perf_counter()
        if now - self._last < (0.2 if self._live else 5.0) and not (
            self._live and done == total and now - self._start > 1
        ):
            return
        self._last = now
        rate = done / (now - self._start)
        rest = f", {(total - done) / rate:.0f} s left" if rate and done < total else ""
        start, end = ("\r", "\n" if done == total else "") if self._live else ("", "\n")
        print(f"{start}{stage}: {done} of {total}{rest}   ", end=end, file=sys.stderr, flush=True)
