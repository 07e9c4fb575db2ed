"""Commands in fresh processes: what it takes to start the program, and to make one of everything."""

from __future__ import annotations

import statistics
import sys
import tempfile
from collections.abc import Mapping, Sequence
from pathlib import Path

from benchmarks import processes
from benchmarks.measure import Table
from benchmarks.options import Options
from benchmarks.processes import Ran

TITLE = "Starting the program"
PYTHON = "python -c pass"
_ROUNDS = 10


def commands(folder: Path) -> dict[str, list[str]]:
    """Commands by what the table calls them, that of Python alone first."""
    python, program = [sys.executable, "-c"], list(processes.PROGRAM)
    build = [*program, "build", "sample_en", "--variants", "1", "--force"]
    return {
        PYTHON: [*python, "pass"],
        "import variantgen": [*python, "import variantgen"],
        "--help": [*program, "--help"],
        "list": [*program, "list"],
        "solve four_bar": [*program, "solve", "four_bar"],
        "show four_bar --out page.svg": [*program, "show", "four_bar", "--out", str(folder / "page.svg")],
        "show four_bar --figure figure.svg": [*program, "show", "four_bar", "--figure", str(folder / "figure.svg")],
        "build sample_en --variants 1 --no-solutions": [*build, "--no-solutions", "--out", str(folder / "short")],
        "build sample_en --variants 1": [*build, "--out", str(folder / "full")],
    }


def run(options: Options) -> list[Table]:
    """Measure all commands in interleaved rounds."""
    found: dict[str, list[Ran]] = {}
    settings = processes.environment(one_thread=False)
    with tempfile.TemporaryDirectory(prefix="startup-") as name:
        every = commands(Path(name))
        for turn in range(1 if options.quick else 1 + _ROUNDS):
            for title, command in every.items():
                ran = processes.run(command, settings)
                if turn or options.quick:  # the first round puts the files into the memory of the system
                    found.setdefault(title, []).append(ran)
    return [table(found)]


def table(found: Mapping[str, Sequence[Ran]]) -> Table:
    """What the runs of each command took, above those of Python alone."""
    made = Table(
        "Commands in a fresh process",
        (
            "command",
            "wall, least, s",
            "wall, median, s",
            "CPU, least, s",
            "CPU, median, s",
            "CPU above Python alone, s",
        ),
        f"{len(found[PYTHON])} interleaved rounds; the files are in the memory of the system. The environment sets no "
        "number of threads.",
    )
    alone = processes.least(found[PYTHON]).cpu
    for title, runs in found.items():
        best = processes.least(runs)
        medians = [statistics.median(values) for values in ([r.wall for r in runs], [r.cpu for r in runs])]
        made.add(title, best.wall, medians[0], best.cpu, medians[1], best.cpu - alone)
    return made
