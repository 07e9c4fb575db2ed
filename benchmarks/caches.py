"""Caches: what each saves of the commands in which it is asked.

Every ``cache``, ``lru_cache`` and ``cached_property`` of the program is put under observation before the program is
loaded. Of the times that one has its answer ready, every 37th, the first included, the answer is worked out again and
timed: that is what the command would take without it, the other caches being there. Times are CPU of the same thread,
so that shares of the command do not depend on what else the machine does. What a cache keeps together besides its own
answer (``IDENTITY``) is not seen that way.

The settings of the collector of garbage and of freed memory are left out one by one, in interleaved fresh processes.
"""

from __future__ import annotations

import functools
import json
import statistics
import subprocess
import sys
import tempfile
import time
from collections.abc import Callable, Mapping
from pathlib import Path
from typing import Any

from benchmarks import exams, processes
from benchmarks.measure import Table
from benchmarks.options import Options

TITLE = "Caches, and settings of memory"
# Caches that are kept because others have what hangs on their answer, whatever they save by themselves.
IDENTITY = {
    "builder.build_spec:WorkerContext.drawer": "its samplers count what was tried, which messages tell",
    "exam.roster.columns:_kinds": "it is asked for every cell of a class",
    "families.restrict:_restricted": "problems of the same ranges have the same forms, and what these remember",
    "families.family:Form.remembered": "it is what forms remember",
    "figure.build:Mechanism.linkage": "the linkage remembers what rests",
    "methods.linkage.problem:Task.linkage": "the linkage remembers what rests",
    "methods.linkage.problem:Task.remembered": "it is what tasks remember",
    "outputs.html.pages:_environment": "it has the compiled templates",
    "outputs.html.pages:_style": "beside the templates",
    "outputs.latex.templates:_environment": "it has the compiled templates",
    "mechanism.solving.memory:keep_freed_memory": "once for a process",
}
SETTINGS = {
    "as it is": "",
    "no thresholds of the collector": "cli.gc = types.SimpleNamespace(set_threshold=lambda *a: 0, freeze=gc.freeze)",
    "no freezing at the end": "cli.atexit = types.SimpleNamespace(register=lambda f: 0)",
    "collector on in jobs": "import variantgen.builder.jobs as j; j.gc.disable = lambda: None",
    "freed memory given back": "import variantgen.mechanism.solving.solve as s; s.keep_freed_memory = lambda: None",
}
TRIED = {
    "list": (["list"], ("no thresholds of the collector", "no freezing at the end")),
    "solve four_bar": (["solve", "four_bar"], ("no thresholds of the collector", "no freezing at the end")),
    "build sample_en --variants 16 --no-solutions": (
        ["build", "sample_en", "--variants", "16", "--no-solutions", "--force", "--out"],
        ("no thresholds of the collector", "collector on in jobs"),
    ),
    "check four_bar": (["check", "four_bar"], ("freed memory given back",)),
}
_ROUNDS = 5
_QUICK = ("list", "solve")  # commands of a trial
_EVERY = 37
_now = time.thread_time


class Observer:
    """Counts for every cache how often it was asked, and how long its answers would have taken."""

    def __init__(self) -> None:
        self.asked: dict[str, int] = {}
        self.ready: dict[str, int] = {}
        self.sampled: dict[str, int] = {}
        self.seconds: dict[str, float] = {}
        self.repeating, self.spent = False, 0.0
        self.timer = min(-_now() + _now() for _ in range(1000))

    def ask(self, name: str, ready: bool, again: Callable[[], Any]) -> None:
        """A cache was asked; ``again`` works its answer out."""
        if self.repeating:
            return
        self.asked[name] = self.asked.get(name, 0) + 1
        if not ready:
            return
        count = self.ready[name] = self.ready.get(name, 0) + 1
        if count % _EVERY != 1:
            return
        self.repeating = True
        start = _now()
        try:
            again()
        finally:
            took = _now() - start
            self.repeating = False
        self.spent += took
        self.sampled[name] = self.sampled.get(name, 0) + 1
        self.seconds[name] = self.seconds.get(name, 0.0) + max(took - self.timer, 0.0)

    def saved(self, name: str) -> float:
        """Seconds of work that a cache has saved."""
        return self.seconds.get(name, 0.0) / self.sampled.get(name, 1) * self.ready.get(name, 0)


def observe(observer: Observer) -> None:
    """Put an observer into the caches of all modules of the program that are loaded from now on."""
    plain, property_ = functools.lru_cache, functools.cached_property

    def lru_cache(maxsize: Any = 128, typed: bool = False) -> Any:
        if callable(maxsize):
            return observed(maxsize, 128)
        return lambda function: observed(function, maxsize, typed)

    def observed(function: Callable[..., Any], maxsize: int | None, typed: bool = False) -> Any:
        known = plain(maxsize, typed)(function)
        name = f"{getattr(function, '__module__', '')}:{getattr(function, '__qualname__', '')}"
        if not name.startswith("variantgen"):
            return known

        @functools.wraps(function)
        def asked(*args: Any, **named: Any) -> Any:
            before = known.cache_info().hits
            found = known(*args, **named)
            observer.ask(name, known.cache_info().hits > before, lambda: function(*args, **named))
            return found

        asked.cache_clear, asked.cache_info = known.cache_clear, known.cache_info  # type: ignore[attr-defined]
        return asked

    class Observed:
        def __init__(self, function: Callable[[Any], Any]) -> None:
            self.function, self.__doc__ = function, function.__doc__
            self.name = f"{function.__module__}:{function.__qualname__}"

        def __set_name__(self, owner: type, name: str) -> None:
            self.attribute = name

        def __get__(self, instance: Any, owner: type | None = None) -> Any:
            if instance is None:
                return self
            values = vars(instance)
            ready = self.attribute in values
            if not ready:
                values[self.attribute] = self.function(instance)
            observer.ask(self.name, ready, lambda: self.function(instance))
            return values[self.attribute]

        def __set__(self, instance: Any, value: Any) -> None:
            vars(instance)[self.attribute] = value

        def __delete__(self, instance: Any) -> None:
            del vars(instance)[self.attribute]

    def cached_property(function: Callable[[Any], Any]) -> Any:
        return (Observed if function.__module__.startswith("variantgen") else property_)(function)

    functools.lru_cache = lru_cache  # type: ignore[assignment]
    functools.cache = lambda function: observed(function, None)  # type: ignore[assignment]
    functools.cached_property = cached_property  # type: ignore[assignment,misc]


def commands(folder: Path, students: int, few: int) -> dict[str, list[str]]:
    """The commands by their names in the table; those behind the builds need what these have made."""
    built, every = str(folder / "built"), str(folder / "every")
    formats = "canvas,html,latex,moodle,prairielearn,qti21,qti30,xlsx"
    return {
        "build": ["build", "sample_en", "--variants", str(students), "--out", built],
        "build without solutions": [
            "build",
            "sample_en",
            "--variants",
            str(6 * students),
            "--no-solutions",
            "--out",
            str(folder / "short"),
        ],
        "build with methods": [
            "build",
            str(_exam_with_methods(folder)),
            "--roster",
            str(_class(folder)),
            "--out",
            str(folder / "methods"),
        ],
        "build, other formats": ["build", "sample_ru", "--variants", str(few), "--out", every, "--format", formats],
        "check": ["check", "four_bar"],
        "gallery": ["gallery", "four_bar", "spool", "--out", str(folder / "gallery")],
        "show": ["show", "four_bar", "--out", str(folder / "page.pdf")],
        "show --motion": ["show", "four_bar", "--motion", str(folder / "motion.svg")],
        "solve": ["solve", "four_bar", "--explain"],
        "list": ["list"],
        "verify": ["verify", built],
    }


def _exam_with_methods(folder: Path) -> Path:
    problem = '[[problem]]\nfamily = "four_bar"\nform = "crank"\nask = ["v_B", "omega_AB"]\nmethod = "{}"\n'
    head = 'title = "T"\nlanguage = "en"\n'
    return exams.write(head + "".join(map(problem.format, ("velocity_pole", "projections", "coordinates"))), folder)


def _class(folder: Path) -> Path:
    path = folder / "class.csv"
    path.write_text("name;group\n" + "".join(f"Student {n};{n % 3}\n" for n in range(12)), "utf-8")
    return path


def run(options: Options) -> list[Table]:
    """Observe all commands, each in a fresh process; try the settings."""
    found: dict[str, dict[str, Any]] = {}
    with tempfile.TemporaryDirectory(prefix="caches-") as name:
        folder = Path(name)
        sizes = (2, 1) if options.quick else (30, 4)
        for title, arguments in commands(folder, *sizes).items():
            if options.quick and title not in _QUICK:
                continue
            result = folder / "found.json"
            command = [sys.executable, "-m", "benchmarks.caches", str(result), *arguments]
            subprocess.run(command, check=True, capture_output=True, env=processes.environment())
            found[title] = json.loads(result.read_text("utf-8"))
        settings = _settings_table(folder, options.quick)
    return [_table(found), settings]


def _settings_table(folder: Path, quick: bool) -> Table:
    """How much more CPU commands take without a setting."""
    rounds = 1 if quick else _ROUNDS
    table = Table(
        "What settings save",
        ("command", "setting", "CPU, least, s", "more than as it is, median, %"),
        f"{rounds} interleaved rounds; the ratio is taken in each round.",
    )
    for title, (arguments, ways) in TRIED.items():
        if quick and title not in _QUICK:
            continue
        command = [*arguments, str(folder / "tried")] if arguments[-1] == "--out" else arguments
        found: dict[str, list[float]] = {way: [] for way in ("as it is", *ways)}
        for _ in range(rounds):
            for way, seconds in found.items():
                code = f"import gc, sys, types; from variantgen import cli; {SETTINGS[way] or 'pass'}"
                ran = [sys.executable, "-c", f"{code}; sys.exit(cli.main({command!r}))"]
                seconds.append(processes.run(ran).cpu)
        for way, seconds in found.items():
            ratios = [mine / plain for mine, plain in zip(seconds, found["as it is"], strict=True)]
            table.add(title, way, min(seconds), 100 * (statistics.median(ratios) - 1))
    return table


def _table(found: Mapping[str, Mapping[str, Any]]) -> Table:
    """A line for each cache: the command of which it saves the largest share."""
    table = Table(
        "What caches save",
        ("cache", "command", "asked", "ready", "saved, ms", "saved, % of the command", "kept because"),
        "The command of which each saves most. " + ", ".join(f"{t}: {f['cpu']:.2f} s" for t, f in found.items()) + ".",
    )
    best: dict[str, tuple[float, str]] = {}
    for title, one in found.items():
        for name, (_, _, saved) in one["caches"].items():
            best[name] = max(best.get(name, (-1.0, "")), (saved / one["cpu"], title))
    for name, (share, title) in sorted(best.items(), key=lambda item: -item[1][0]):
        asked, ready, saved = found[title]["caches"][name]
        own = name.removeprefix("variantgen.")
        table.add(own, title, asked, ready, 1e3 * saved, 100 * share, IDENTITY.get(own, "of this"))
    return table


def main(arguments: list[str]) -> None:
    """The work of an observed process: a command of the program."""
    result, *command = arguments
    observer = Observer()
    observe(observer)
    from variantgen.cli import main as program

    code = program(command)
    cpu = time.process_time() - observer.spent
    caches = {
        name: (asked, observer.ready.get(name, 0), observer.saved(name)) for name, asked in observer.asked.items()
    }
    Path(result).write_text(json.dumps({"cpu": cpu, "caches": caches}), "utf-8")
    sys.exit(code)


if __name__ == "__main__":
    main(sys.argv[1:])
