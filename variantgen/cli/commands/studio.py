"""``variantgen studio``: exams by sight, in a browser on this machine."""

from __future__ import annotations

import argparse
from pathlib import Path

from variantgen.cli.messages import say, tell
from variantgen.errors import InputError, Problem, missing_package

HELP = "compose and build exams in a browser, on this machine alone"
DESCRIPTION = """\
Open the studio for a folder: choose problems from pictures, compose the exam, build it.
It edits the files that the other commands read. It answers only to a browser of this machine
that was opened with the address that it prints; Ctrl+C ends it, and nothing is lost."""
_PORTS = 65_535


def add_arguments(parser: argparse.ArgumentParser) -> None:
    """Options of the command."""
    parser.add_argument("folder", nargs="?", type=Path, default=Path(), metavar="FOLDER", help="default: this folder")
    parser.add_argument("--port", type=int, metavar="N", help="port (default: the first free one from 8765)")
    parser.add_argument("--no-browser", action="store_true", help="open no browser, print the address only")


def run(arguments: argparse.Namespace) -> int:
    """Serve until interrupted. Raises InputError for a folder or port that cannot be used, ToolMissingError."""
    if arguments.port is not None and not 0 <= arguments.port <= _PORTS:
        raise InputError(Problem(f"expected 0 to {_PORTS}", key="--port", value=str(arguments.port)))
    try:
        from variantgen.studio.server import serve
    except ImportError as error:
        if error.name is None or error.name.partition(".")[0] not in ("starlette", "uvicorn", "anyio", "h11"):
            raise
        raise missing_package("the studio needs", error.name.partition(".")[0], "studio") from None
    try:
        serve(arguments.folder, arguments.port, not arguments.no_browser, say)
    except KeyboardInterrupt:
        tell("the studio has ended; all is on disk")
    return 0
