"""Options that several commands share."""

from __future__ import annotations

import argparse
from collections.abc import Sequence
from pathlib import Path
from typing import TYPE_CHECKING

from variantgen.cli.messages import tell
from variantgen.errors import InputError, Problem
from variantgen.resources import languages, module_names

if TYPE_CHECKING:
    from variantgen.outputs.single.explanation import Explanation
    from variantgen.variants.variant import Variant


def some_text(text: str) -> str:
    """The value of an option that may be any text but none: it would be taken for an option that is not given."""
    if not text.strip():
        raise argparse.ArgumentTypeError("expected a text that is not empty")
    return text


def add_families(parser: argparse.ArgumentParser) -> None:
    """``--families DIR``: where else families are looked for."""
    parser.add_argument(
        "--families",
        type=Path,
        action="append",
        default=[],
        metavar="DIR",
        help="folder of your own families, searched before the catalogue (also: environment VARIANTGEN_FAMILIES)",
    )


def add_choice(parser: argparse.ArgumentParser, files: str = "family or scene file") -> None:
    """The ways to choose one problem; ``files`` says which files may be named."""
    parser.add_argument("family", metavar="FAMILY_OR_FILE", help=f"name of a family, or path of a {files}")
    parser.add_argument(
        "--set", action="append", default=[], metavar="NAME=VALUE", help="fix a parameter: OA=30, OA='0.3 m', side=left"
    )
    parser.add_argument(
        "--range",
        action="append",
        default=[],
        metavar="NAME=LOW..HIGH",
        help="draw a parameter from a part of its range: phi=30..60; of words some: side=left",
    )
    parser.add_argument("--form", default="", help="take this form of the family")
    parser.add_argument(
        "--ask", action="append", default=[], metavar="QUANTITY", help="ask for this (v_B, a_B.x, omega_AB, ...)"
    )
    parser.add_argument("--seed", type=some_text, default="0", help="seed of the draw (default: 0)")
    add_nice(parser)
    parser.add_argument(
        "--units", default="", metavar="UNIT", help="unit of length of data and answers: cm, mm, m, in, ft"
    )
    add_families(parser)


def add_built_folder(parser: argparse.ArgumentParser) -> None:
    """``OUT_DIR``: the folder of a finished exam."""
    parser.add_argument("folder", metavar="OUT_DIR", type=Path, help="folder that  variantgen build  has made")


def add_language(parser: argparse.ArgumentParser) -> None:
    """``--lang``: the language of what is printed."""
    parser.add_argument("--lang", default="en", help=f"language: {' or '.join(languages())} (default: en)")


def add_nice(parser: argparse.ArgumentParser) -> None:
    """``--nice``: hand-friendly variants only."""
    parser.add_argument(
        "--nice", action="store_true", help="hand-friendly variants: angles of 30, 45, 60, 90 degrees, simple answers"
    )


def add_explaining(parser: argparse.ArgumentParser) -> None:
    """``--explain`` and what is wished of the solution."""
    parser.add_argument("--explain", action="store_true", help="with the worked solution")
    parser.add_argument(
        "--method",
        action="append",
        default=[],
        metavar="NAME",
        help="solve by this method: velocity_centre, acceleration_pole, graphical, ... (may be repeated)",
    )
    parser.add_argument("--depth", metavar="DEPTH", help="answers, short or full (default: full)")
    parser.add_argument(
        "--notation",
        action="append",
        default=[],
        metavar="WORD",
        help="letters of the solution: alpha, epsilon (angular acceleration), rotational (components of accelerations)",
    )


def check_explaining(arguments: argparse.Namespace) -> None:
    """Raise InputError for what is wished of a solution that is not asked for."""
    names = () if arguments.explain else ("method", "depth", "notation")
    given = [f"--{name}" for name in names if getattr(arguments, name)]
    if given:
        problem = "only has a meaning for solutions"
        raise InputError([Problem(problem, key=option, remedy="add --explain") for option in given])


def explained(arguments: argparse.Namespace, variant: Variant) -> Explanation | None:
    """The solution that is asked for, None without ``--explain``; where no method leads there it is said, and None.

    Raises InputError.
    """
    if not arguments.explain:
        return None
    from variantgen.outputs.single.explanation import explain
    from variantgen.wording.solution.explain import UnexplainedError

    depth = arguments.depth or "full"
    try:
        true_scale = getattr(arguments, "true_scale", False)
        return explain(variant, arguments.lang, arguments.method, depth, arguments.ask, arguments.notation, true_scale)
    except UnexplainedError as error:
        tell(str(error))
        return None


def settings(arguments: argparse.Namespace) -> dict[str, str]:
    """The parameters fixed by ``--set``. Raises InputError."""
    return _named(arguments.set, "--set", "NAME=VALUE", "OA=30")


def ranges(arguments: argparse.Namespace) -> dict[str, str | list[str]]:
    """The parameters narrowed by ``--range``: lowest and highest value, or words of a choice. Raises InputError."""
    found = _named(arguments.range, "--range", "NAME=LOW..HIGH", "phi=30..60")
    parts = {name: [part.strip() for part in text.split(".." if ".." in text else ",")] for name, text in found.items()}
    return {name: own if len(own) > 1 else own[0] for name, own in parts.items()}


def _named(texts: Sequence[str], option: str, expected: str, example: str) -> dict[str, str]:
    """What stands behind each name. Raises InputError."""
    found: dict[str, str] = {}
    for text in texts:
        name, equals, value = text.partition("=")
        if not equals or not name.strip() or not value.strip():
            remedy = f"for example {option} {example}"
            raise InputError(Problem(f"expected {expected}", key=option, value=text, remedy=remedy))
        if name.strip() in found:
            raise InputError(Problem("the parameter is set twice", key=option, value=text, remedy="keep one of them"))
        found[name.strip()] = value.strip()
    return found


def wanted_variant(arguments: argparse.Namespace) -> Variant:
    """The variant of ``show`` and ``solve``: of a family or a scene, by its seed, form, settings and units.

    Raises InputError where there is none.
    """
    from variantgen.families.reading.folders import family_folders
    from variantgen.single import one_variant

    return one_variant(
        arguments.family,
        settings(arguments),
        arguments.seed,
        arguments.form,
        arguments.ask,
        family_folders(arguments.families),
        arguments.nice,
        arguments.units,
        ranges(arguments),
    )


def tell_doubts(arguments: argparse.Namespace, variant: Variant) -> None:
    """What is hardly meant in a variant that can be solved: a pin beside its slot, a rope on the wrong side."""
    from variantgen.single import variant_doubts

    for problem in variant_doubts(variant):
        tell(f"look at this: {problem.located(arguments.family)}")


def at_least_one(option: str, value: int) -> int:
    """A positive whole number; InputError otherwise."""
    if value < 1:
        raise InputError(Problem("expected at least 1", key=option, value=str(value)))
    return value


def format_names() -> list[str]:
    """The names of outputs, found without importing them."""
    folder = Path(__file__).parents[1] / "outputs" / "formats"
    return sorted(
        {*module_names([str(folder)])} - {"qti"} | {"qti21", "qti30"}
    )  # one module makes both packages of QTI
