"""The floor under a build: the typesetting engine alone, in a fresh process, on what the build itself gives to it.

    python -m benchmarks.floor record FOLDER build EXAM.toml ...     # a build that hands over its input
    python -m benchmarks.floor replay FOLDER RESULT.json             # the engine alone on that input

Every call of the engine is kept with its arguments and played again in the same order, with the same parts and options.
What counts is the CPU of these calls.
"""

from __future__ import annotations

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


def record(folder: Path, arguments: Sequence[str]) -> None:
    """Run a command of the program in this process and keep the arguments of each call of the engine."""
    import typst

    from variantgen.cli import main

    engine = typst.Compiler

    class Recorded:
        """The engine, which notes what it is given."""

        def __init__(self, template: Path | None = None, *, root: Path, **made: Any) -> None:
            self._template, self._root, self._made = template, root, made
            self._engine = engine(template, root=root, **made)

        def compile(self, template: Path | bytes, **named: Any) -> Any:
            if isinstance(template, Path):  # an empty document, given as text, is no part of the input
                self._note(template, named)
            return self._engine.compile(template, **named)

        def query(self, selector: str, **named: Any) -> Any:
            assert self._template is not None
            self._note(self._template, {"selector": selector, **named})
            return self._engine.query(selector, **named)

        def _note(self, template: Path, named: dict[str, Any]) -> None:
            (told,) = {**self._made, **named}["sys_inputs"].values()  # the file that names the others
            inputs = json.loads((self._root / told).read_text("utf-8")).values()
            # Not all that is told is the name of a file, and pages are named before they are planned.
            data = {name: (self._root / name).read_bytes() for name in (told, *inputs) if (self._root / name).is_file()}
            # Names in the order of the calls, whichever process makes them.
            with (folder / f"{time.monotonic_ns():020}-{os.getpid()}.call").open("wb") as file:
                pickle.dump((template.relative_to(self._root), self._made, named, data), file, pickle.HIGHEST_PROTOCOL)

    typst.Compiler = Recorded
    if main(list(arguments)):
        raise SystemExit("the build failed")
    if not any(folder.iterdir()):
        raise SystemExit("the build has not called typst.Compiler.compile: see benchmarks/floor.py")


def replay(folder: Path) -> Clock:
    """CPU milliseconds of the engine by template."""
    import typst

    from variantgen.outputs.typst.typesetter import typesetter

    clock = Clock()
    made: Any = None
    with typesetter() as engine:
        for path in sorted(folder.iterdir()):
            with path.open("rb") as file:
                template, options, named, data = pickle.load(file)
            for name, content in data.items():
                (engine.root / name).write_bytes(content)
            with clock.measuring(template.stem):
                if "selector" in named:  # a query has an engine of its own, which is given the data
                    typst.Compiler(engine.root / template, root=engine.root, **options).query(**named)
                    continue
                made = made or typst.Compiler(root=engine.root, **options)
                made.compile(engine.root / template, **named)
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
        return float(sum(clock.values())) / 1e3

    def close(self) -> None:
        """Forget the input."""
        self._folder.cleanup()


if __name__ == "__main__":
    if sys.argv[1] == "record":
        record(Path(sys.argv[2]), sys.argv[3:])
    else:
        Path(sys.argv[3]).write_text(json.dumps(replay(Path(sys.argv[2]))), "utf-8")
