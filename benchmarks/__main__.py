"""Scale and speed: how fast the program starts, what builds cost by size of the class and by stage, the solver.

    python -m benchmarks [--quick] [--only PART ...] [--students N] [--solutions N] [--rounds N] [--out DIR]

Prints tables and writes them to DIR: ``measured.md`` with all parts that have been measured there, and one JSON file
for each part. What is compared is measured in interleaved rounds of one run, and the least counts; ratios mean
something anywhere, times only on one machine. By default classes end at 1000 students; ``--students 10000`` takes about
an hour more.
"""

from __future__ import annotations

import argparse
import importlib
import sys
from collections.abc import Sequence
from pathlib import Path

from benchmarks.measure import Report, document, machine
from benchmarks.options import Options

PARTS = ("startup", "scale", "stages", "solver", "batches", "caches", "joining")


def main(arguments: Sequence[str] | None = None) -> None:
    """Measure and write."""
    usual = Options()
    parser = argparse.ArgumentParser(
        "python -m benchmarks", description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter
    )
    parser.add_argument("--quick", action="store_true", help="a trial of everything on at most three students")
    parser.add_argument("--only", nargs="+", choices=PARTS, default=PARTS, metavar="PART", help=", ".join(PARTS))
    parser.add_argument("--students", type=int, help=f"largest class without solutions ({usual.students})")
    parser.add_argument("--solutions", type=int, help=f"largest class with solutions ({usual.solutions})")
    parser.add_argument("--rounds", type=int, help=f"of whole builds ({usual.rounds})")
    parser.add_argument("--out", type=Path, default=Path(__file__).parent / "measured", metavar="DIR")
    given = parser.parse_args(arguments)
    if given.quick:
        options = Options(True, min(given.students or 3, 3), 1, 1)
    else:
        options = Options(
            False,
            given.students or usual.students,
            given.solutions or usual.solutions,
            given.rounds or usual.rounds,
        )
    command = " ".join(["python -m benchmarks", *(sys.argv[1:] if arguments is None else arguments)])
    for part in given.only:
        module, where = importlib.import_module(f"benchmarks.{part}"), machine()
        Report(part, module.TITLE, command, module.run(options), where).write(given.out)
    text = document(given.out, PARTS)
    (given.out / "measured.md").write_text(text, "utf-8")
    print(text)


if __name__ == "__main__":
    main()
