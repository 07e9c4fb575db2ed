"""Builds: the one that runs, those that are finished, their files."""

from __future__ import annotations

import asyncio
import hashlib
import json
import os
import re
import signal
import sys
import time
from datetime import date
from pathlib import Path
from typing import Any

from msgspec import Struct, field

from variantgen.errors import InputError, Problem
from variantgen.studio.events import Events
from variantgen.studio.workspace import BUILDS, MANIFEST, Workspace, is_own

_KEY = re.compile(r"[A-Za-z0-9][A-Za-z0-9_-]{0,79}")
_DAY = r"-\d{4}-\d\d-\d\d(?:-\d{1,3})?"  # what the name of a build has after that of its exam
_FIRST = 3.0  # seconds before a rate is told


class FinishedBuild(Struct, frozen=True):
    """A finished build: its folder, whose exam it is, for how many, when, its files with their sizes.

    ``groups`` are those of its students, with what the file of each is called (no ending) where there is one.
    """

    key: str
    folder: Path
    title: str
    seed: str
    students: int
    day: date
    files: tuple[tuple[str, int], ...]
    groups: tuple[tuple[str, str], ...] = ()

    @property
    def size(self) -> int:
        """Bytes of all files."""
        return sum(size for _, size in self.files)


class RunningBuild(Struct):
    """A build under way; ``state`` is what pages are told of it."""

    out: str
    state: dict[str, Any] = field(default_factory=dict)
    process: asyncio.subprocess.Process | None = None
    begun: float = field(default_factory=time.monotonic)
    stage: tuple[str, float, int] = ("", 0.0, 0)


class Builds:
    """The builds of a folder: at most one of an exam runs at a time."""

    def __init__(self, workspace: Workspace, events: Events) -> None:
        self._workspace, self._events = workspace, events
        self._running: dict[str, RunningBuild] = {}
        self._tasks: set[asyncio.Task[None]] = set()
        self._known: dict[Path, tuple[int, FinishedBuild]] = {}

    def state(self, exam: str) -> dict[str, Any]:
        """How far the build of an exam is; nothing if none was begun.

        One that ended with another studio, before it was done, is stopped: what it has is there for the next one.
        """
        found = self._running.get(exam)
        if found:
            return found.state
        home = self._workspace.folder / BUILDS
        if home.is_symlink() or not any(home.glob(".*")):
            return {}
        name = self.next_name(exam)
        left = any(path.is_dir() for path in home.glob(f".{name}.*"))  # where the builder keeps its parts
        return {"exam": exam, "name": name, "phase": "stopped"} if left else {}

    def next_name(self, exam: str) -> str:
        """The folder of the next build: the name of the exam and the day, with a number where it is there.

        Raises InputError for a day with a thousand builds.
        """
        home = self._workspace.folder / BUILDS
        if home.is_symlink():
            raise InputError(Problem("is a link", file=BUILDS, remedy="remove it"))
        home.mkdir(exist_ok=True)  # the command that pages show needs it, too
        for number in range(1, 1000):
            name = f"{exam}-{date.today().isoformat()}" + (f"-{number}" if number > 1 else "")
            if not (home / name).exists():
                return name
        raise InputError(Problem("there are too many builds of today", remedy="move some elsewhere"))

    async def start(self, exam: str, path: Path, variants: int | None) -> None:
        """Begin a build for the roster, or for numbered variants. Raises InputError while one runs."""
        running = self._running.get(exam)
        if running and (running.process is None or running.process.returncode is None):
            raise InputError(Problem("a build of this exam is under way", remedy="wait for it, or stop it"))
        folder = self._workspace.folder
        name = self.next_name(exam)
        found = self._running[exam] = RunningBuild(name)
        wanted = {
            "exam": str(path),
            "roster": "" if variants else str(self._workspace.roster()),
            "variants": variants,
            "out": str(folder / BUILDS / name),
            "jobs": max(1, min(4, (os.cpu_count() or 1) - 1)),
        }
        try:
            found.process = await asyncio.create_subprocess_exec(
                sys.executable, "-m", "variantgen.studio.building.process",
                stdin=asyncio.subprocess.PIPE, stdout=asyncio.subprocess.PIPE,
            )  # fmt: skip
        except BaseException:
            del self._running[exam]
            raise
        assert found.process.stdin is not None, "it was asked for"
        found.process.stdin.write(json.dumps(wanted).encode() + b"\n")
        self._tell(exam, found, {"phase": "begun", "done": 0, "total": 0})
        task = asyncio.create_task(self._follow(exam, found))
        self._tasks.add(task)
        task.add_done_callback(self._tasks.discard)

    async def _follow(self, exam: str, found: RunningBuild) -> None:
        """Tell pages what the process says, until it ends."""
        assert found.process is not None and found.process.stdout is not None, "it was started"
        async for line in found.process.stdout:
            self._tell(exam, found, json.loads(line))
        await found.process.wait()
        if found.state.get("phase") not in ("built", "failed"):
            self._tell(exam, found, {**found.state, "phase": "stopped"})

    def _tell(self, exam: str, found: RunningBuild, said: dict[str, Any]) -> None:
        now = time.monotonic()
        phase, done, total = said.get("phase", ""), said.get("done", 0), said.get("total", 0)
        if found.stage[0] != phase:
            found.stage = (phase, now, done)
        seconds, more = now - found.stage[1], done - found.stage[2]
        each = seconds / more if more > 0 and seconds > _FIRST else 0.0
        rest = round(each * (total - done)) if each else None
        found.state = {"exam": exam, "name": found.out, **said, "each": round(each, 2), "rest": rest}
        self._events.tell("build", **found.state)

    def stop(self, exam: str) -> None:
        """Stop a build; what is finished of it is kept for the next one of the same exam."""
        found = self._running.get(exam)
        if found and found.process is not None and found.process.returncode is None:
            found.process.send_signal(signal.SIGTERM)

    def close(self) -> None:
        """Stop all builds."""
        for exam in self._running:
            self.stop(exam)

    def finished(self, exam: str = "") -> dict[str, FinishedBuild]:
        """The finished builds by their keys, the newest first; those of an exam are known by their names."""
        home = self._workspace.folder / BUILDS
        paths = [] if home.is_symlink() else list(home.glob(f"*/{MANIFEST}"))
        found = [one for one in map(self._read, paths) if one is not None]
        found.sort(key=lambda one: (one.day, one.folder.name), reverse=True)
        return {one.key: one for one in found if not exam or re.fullmatch(re.escape(exam) + _DAY, one.folder.name)}

    def _read(self, path: Path) -> FinishedBuild | None:
        """A build by its manifest, which is read once; None for what is none."""
        if not is_own(path, self._workspace.folder) or path.parent.name.startswith("."):
            return None
        changed = path.stat().st_mtime_ns
        if path not in self._known or self._known[path][0] != changed:
            found = _finished(path)
            if found is None:
                return None
            self._known[path] = changed, found
        return self._known[path][1]


def _finished(path: Path) -> FinishedBuild | None:
    from variantgen.outputs.files.student_groups import GroupFiles

    try:
        data = json.loads(path.read_text("utf-8"))
        names = sorted({*data["files"], MANIFEST})
        files = tuple((n, (path.parent / n).stat().st_size) for n in names if is_own(path.parent / n, path.parent))
        title = str(data.get("exam", {}).get("title", "")) if isinstance(data.get("exam"), dict) else ""
        students, seed = len(data["students"]), str(data["seed"])
        listed = [str(student["group"]) for student in data["students"] if isinstance(student, dict)]
        groups = tuple(GroupFiles.of(listed).stems.items())
    except (OSError, ValueError, KeyError, TypeError, RecursionError):
        return None
    name = path.parent.name
    key = name if _KEY.fullmatch(name) else "build-" + hashlib.sha256(name.encode()).hexdigest()[:8]
    return FinishedBuild(
        key, path.parent, title, seed, students, date.fromtimestamp(path.stat().st_mtime), files, groups
    )
