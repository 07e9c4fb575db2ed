"""What may be chosen of the benchmarks."""

from __future__ import annotations

from dataclasses import dataclass


@dataclass(frozen=True)
class Options:
    """``students`` and ``solutions`` are the largest classes without and with solutions; ``quick`` is for a trial."""

    quick: bool = False
    students: int = 1000
    solutions: int = 1000
    rounds: int = 3
