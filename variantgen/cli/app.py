"""The program ``variantgen``: its commands, its exit codes.

Messages and progress go to stderr; exit codes: 0 done, 1 a check failed, 2 wrong input, 3 an external tool is missing.
A command is a module of :mod:`variantgen.cli.commands` with the texts ``HELP`` and ``DESCRIPTION`` and the functions
``add_arguments(parser)`` and ``run(arguments)``; its name is the module's.
"""

from __future__ import annotations

import argparse
import importlib
import os
import sys
from collections.abc import Sequence

from variantgen.cli import commands
from variantgen.cli.messages import tell
from variantgen.errors import VariantgenError
from variantgen.resources import module_names
from variantgen.version import VERSION

_EPILOG = """\
examples:
  variantgen list
  variantgen show four_bar --seed 3 --out problem.pdf
  variantgen solve slider_crank --set OA=20 --set "AB=0.6 m" --json
  variantgen build exam.toml --roster class.csv --out exam-2026
  variantgen new family my_mechanism
"""


def main(argv: Sequence[str] | None = None) -> int:
    """Run a command; returns the exit code."""
    words = sys.argv[1:] if argv is None else list(argv)
    arguments = _parser(words).parse_args(words)
    try:
        code: int = arguments.run(arguments)
        sys.stdout.flush()
        return code
    except VariantgenError as error:
        tell(f"variantgen: {error}")
        return error.exit_code
    except KeyboardInterrupt:
        tell("variantgen: interrupted, no output was written")
        return 130
    except BrokenPipeError:
        # The reader has gone; nothing more can be said to it, not even when Python flushes at the end.
        os.dup2(os.open(os.devnull, os.O_WRONLY), sys.stdout.fileno())
        return 0
    except OSError as error:
        tell(f"variantgen: writing failed: {error.strerror}; free some space or choose another file")
        os.dup2(os.open(os.devnull, os.O_WRONLY), sys.stdout.fileno())
        return 2


def _parser(words: Sequence[str]) -> argparse.ArgumentParser:
    """The parser for a command line. If it begins with a command, no other command is loaded."""
    parser = argparse.ArgumentParser(
        prog="variantgen",
        description="Individual problem sheets in planar kinematics, with figures to scale, keys and a manifest.",
        epilog=_EPILOG,
        formatter_class=argparse.RawDescriptionHelpFormatter,
    )
    parser.add_argument("--version", action="version", version=f"variantgen {VERSION}")
    choices = parser.add_subparsers(title="commands", required=True, metavar="COMMAND")
    known = module_names(commands.__path__)
    for name in words[:1] if words and words[0] in known else known:
        command = importlib.import_module(f"variantgen.cli.commands.{name}")
        added = choices.add_parser(
            name,
            help=command.HELP,
            description=command.DESCRIPTION,
            formatter_class=argparse.RawDescriptionHelpFormatter,
        )
        command.add_arguments(added)
        added.set_defaults(run=command.run)
    return parser
