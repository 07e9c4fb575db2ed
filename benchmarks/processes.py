"""Commands in fresh processes: time, memory of the process and of its workers, bytes written (on Linux)."""

from __future__ import annotations

import os
import subprocess
import sys
import tempfile
import threading
import time
from collections.abc import Mapping, Sequence
from dataclasses import dataclass
from pathlib import Path

ROOT = Path(__file__).resolve().parent.parent
PROGRAM = (sys.executable, "-m", "variantgen")
_THREADS = ("RAYON_NUM_THREADS", "OPENBLAS_NUM_THREADS", "OMP_NUM_THREADS")
_EVERY = 0.1  # seconds between two looks at the memory of the workers
_MB = 1e6


@dataclass(frozen=True)
class Ran:
    """What a command took: seconds (``cpu`` with those of its workers), megabytes (None: no workers, or not told).

    ``written`` is all that was given to the system to write, temporary files and messages between processes included.
    """

    wall: float
    cpu: float
    main_mb: float
    worker_mb: float | None
    written_mb: float | None


def environment(one_thread: bool = True) -> dict[str, str]:
    """The environment of a measured process: this checkout, compiled modules kept, one thread in each process."""
    kept = {k: v for k, v in os.environ.items() if k not in {*_THREADS, "PYTHONDONTWRITEBYTECODE"}}
    path = os.pathsep.join(filter(None, (str(ROOT), kept.get("PYTHONPATH"))))
    return {**kept, "PYTHONPATH": path, **(dict.fromkeys(_THREADS, "1") if one_thread else {})}


def run(command: Sequence[str], settings: Mapping[str, str] | None = None) -> Ran:
    """Run a command in a fresh process and measure it. Raises RuntimeError with its messages if it fails."""
    with tempfile.TemporaryFile() as said:
        start = time.perf_counter()
        process = subprocess.Popen(
            command, stdout=said, stderr=said, env=environment() if settings is None else dict(settings)
        )
        with _Watch(process.pid) as watch:
            os.waitid(os.P_PID, process.pid, os.WEXITED | os.WNOWAIT)
            wall = time.perf_counter() - start
            written = _written(process.pid)
        _, status, usage = os.wait4(process.pid, 0)
        process.returncode = os.waitstatus_to_exitcode(status)
        if process.returncode:
            said.seek(0)
            raise RuntimeError(f"{' '.join(command)}:\n{said.read().decode(errors='replace')}")
    # The largest memory that the system tells with the CPU would count that of this process, which was copied first.
    return Ran(wall, usage.ru_utime + usage.ru_stime, watch.main or 0.0, watch.worker, written)


def least(runs: Sequence[Ran]) -> Ran:
    """The least wall time and CPU of several runs of one command, the largest memory."""

    def largest(values: Sequence[float | None]) -> float | None:
        return max((x for x in values if x is not None), default=None)

    return Ran(
        min(r.wall for r in runs),
        min(r.cpu for r in runs),
        max(r.main_mb for r in runs),
        largest([r.worker_mb for r in runs]),
        largest([r.written_mb for r in runs]),
    )


class _Watch:
    """Looks at the memory of a process and of those that it has started, as long as the block lasts (Linux)."""

    def __init__(self, pid: int) -> None:
        self._pid, self._over = pid, threading.Event()
        self._peaks: dict[int, float] = {}
        self._thread = threading.Thread(target=self._look, daemon=True)

    def __enter__(self) -> _Watch:
        self._thread.start()
        return self

    def __exit__(self, *error: object) -> None:
        self._over.set()
        self._thread.join()

    @property
    def main(self) -> float | None:
        """Largest memory of the process itself, MB."""
        return self._peaks.get(self._pid)

    @property
    def worker(self) -> float | None:
        """Largest memory of one that it has started, MB."""
        return max((peak for pid, peak in self._peaks.items() if pid != self._pid), default=None)

    def _look(self) -> None:
        while not self._over.wait(_EVERY):
            parents = _parents()
            for pid in parents:
                above = pid
                while above in parents and above != self._pid:
                    above = parents[above]
                if above == self._pid and (peak := _peak(pid)):
                    self._peaks[pid] = peak


def _parents() -> dict[int, int]:
    """The parent of every process."""
    found = {}
    for entry in Path("/proc").iterdir():
        if entry.name.isdecimal():
            try:
                # The name of a program, in parentheses, may hold anything.
                found[int(entry.name)] = int(
                    (entry / "stat").read_text("utf-8", "replace").rsplit(")", 1)[1].split()[1]
                )
            except OSError:  # it has ended
                continue
    return found


def _peak(pid: int) -> float:
    """The largest memory that a process has had, MB; 0 if it has ended."""
    try:
        text = Path(f"/proc/{pid}/status").read_text("utf-8", "replace")
    except OSError:
        return 0.0
    return next((int(line.split()[1]) * 1024 / _MB for line in text.splitlines() if line.startswith("VmHWM")), 0.0)


def _written(pid: int) -> float | None:
    """What a process that has ended, and is not yet forgotten, has written with its workers, MB."""
    try:
        lines = Path(f"/proc/{pid}/io").read_text("utf-8").splitlines()
    except OSError:
        return None
    return next((int(line.split()[1]) / _MB for line in lines if line.startswith("wchar")), None)


def size(folder: Path) -> float:
    """Megabytes of the files in a folder."""
    return sum(path.stat().st_size for path in folder.rglob("*") if path.is_file()) / _MB
