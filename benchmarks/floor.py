"""The floor under a build: the typesetting engine alone, in a fresh process, on what the build itself gives to it.

    python -m benchmarks.floor record FOLDER build EXAM.toml ...     # a build that hands over its input
    python -m benchmarks.floor replay FOLDER RESULT.json             # the engine alone on that input

Every call of ``Typesetter.compile`` is kept with its arguments and played again in the same order with the same parts
and options. What counts is the CPU of these calls but for writing the data as JSON, which is not the engine's work.
"""

from __future__ import annotations

import gc
import json
import os
import pickle
import sys
import tempfile
import time
from collections.abc import Sequence
from pathlib import Path
from typing import Any

from benchmarks import processes
from benchmarks.measure import Clock

JSON = "JSON"


def record(folder: Path, arguments: Sequence[str]) -> None:
    """Run a command of the program in this process and keep the arguments of each call of the engine."""
    from variantgen.cli import main
    from variantgen.outputs.typesetter import Typesetter

    compile_ = Typesetter.compile

    def kept(self: Typesetter, *values: Any, **named: Any) -> Any:
        # Names in the order of the calls, whichever process makes them.
        with (folder / f"{time.monotonic_ns():020}-{os.getpid()}.call").open("wb") as file:
            pickle.dump((values, named), file, pickle.HIGHEST_PROTOCOL)
        return compile_(self, *values, **named)

    Typesetter.compile = kept  # type: ignore[method-assign]
    if main(list(arguments)):
        raise SystemExit("the build failed")
    if not any(folder.iterdir()):
        raise SystemExit(
            "the build has not called variantgen.outputs.typesetter:Typesetter.compile: see benchmarks/floor.py"
        )


def replay(folder: Path) -> Clock:
    """CPU milliseconds of the engine by template, and of writing its data as JSON."""
    from variantgen.outputs.typesetter import typesetter

    clock = Clock()
    gc.disable()
    with typesetter() as engine:
        for path in sorted(folder.iterdir()):
            with path.open("rb") as file:
                values, named = pickle.load(file)
            template, data = [*values, *(named[name] for name in ("template", "data") if name in named)][:2]
            with clock.measuring(Path(template).stem):
                engine.compile(*values, **named)
            with clock.measuring(JSON):
                json.dumps(data, ensure_ascii=False, separators=(",", ":"))
    return clock


class Floor:
    """The engine's part of one build, recorded once."""

    def __init__(self, arguments: Sequence[str]) -> None:
        self._folder = tempfile.TemporaryDirectory(prefix="floor-")
        processes.run([sys.executable, "-m", "benchmarks.floor", "record", self._folder.name, *arguments])

    def seconds(self) -> float:
        """CPU seconds of the engine alone, in a fresh process."""
        with tempfile.TemporaryDirectory() as name:
            result = Path(name) / "clock.json"
            processes.run([sys.executable, "-m", "benchmarks.floor", "replay", self._folder.name, str(result)])
            clock = json.loads(result.read_text("utf-8"))
        # The data are written as JSON inside the calls, too.
        return float(sum(clock.values()) - 2 * clock[JSON]) / 1e3

    def close(self) -> None:
        """Forget the input."""
        self._folder.cleanup()


if __name__ == "__main__":
    if sys.argv[1] == "record":
        record(Path(sys.argv[2]), sys.argv[3:])
    else:
        Path(sys.argv[3]).write_text(json.dumps(replay(Path(sys.argv[2]))), "utf-8")
