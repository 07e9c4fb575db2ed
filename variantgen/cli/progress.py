"""How far long work is: a bar on a terminal, elsewhere a line every five seconds."""

from __future__ import annotations

import sys
import time
from typing import Any

from variantgen.cli.messages import tell

_SHORT = 1.0  # seconds


class Progress:
    """Progress on stderr, of stages one after another."""

    def __init__(self) -> None:
        self._stage = ""
        self._bar: Any = None
        self._start = time.perf_counter()

    def __enter__(self) -> Progress:
        return self

    def __exit__(self, *_: object) -> None:
        self._end()

    def show(self, stage: str, done: int, total: int) -> None:
        """Show how many students of a stage are done."""
        over = stage != self._stage and done == total
        if over or time.perf_counter() - self._start < _SHORT:
            return  # short work needs no bar, nor the time to load its library
        if stage != self._stage:
            self._end()
            self._stage, self._bar = stage, _bar(stage, done, total)
        self._bar.update(done - self._bar.n)

    def _end(self) -> None:
        if self._bar is not None:
            self._bar.close()


def pace(rate: float | None, done: int, total: int) -> str:
    """How fast it goes (``rate`` students a second) and how long it will last; nothing as long as that is unknown."""
    if not rate:
        return ""
    speed = f"{rate:.1f} students/s" if rate >= 1.0 else f"{1.0 / rate:.1f} s per student"
    minutes, seconds = divmod(round((total - done) / rate), 60)
    hours, minutes = divmod(minutes, 60)
    left = f"{hours}:{minutes:02d}:{seconds:02d}" if hours else f"{minutes:02d}:{seconds:02d}"
    return f", {speed}, {left} left"


def _bar(stage: str, done: int, total: int) -> Any:
    from tqdm import tqdm

    class Bar(tqdm):  # type: ignore[misc]  # the library has no types
        """A bar that tells its pace in words."""

        @property
        def format_dict(self) -> dict[str, Any]:
            """What the format of the bar may name."""
            known: dict[str, Any] = super().format_dict
            rate = known["rate"]
            if not rate and known["elapsed"]:
                rate = (known["n"] - known["initial"]) / known["elapsed"]
            return {**known, "pace": pace(rate, known["n"], known["total"])}

    live = sys.stderr.isatty()
    return Bar(
        total=total,
        initial=done,
        desc=stage,
        file=sys.stderr if live else _Lines(),
        mininterval=0.2 if live else 5.0,
        bar_format="{desc}: {n_fmt} of {total_fmt}{pace} |{bar}|" if live else "{desc}: {n_fmt} of {total_fmt}{pace}",
        leave=False,
    )


class _Lines:
    """Standard error as a file of whole lines: no line is written over another."""

    def write(self, text: str) -> None:
        """Write a state of the bar as a line."""
        if line := text.strip("\r\n "):
            tell(line)

    def flush(self) -> None:
        """Nothing is kept back."""
