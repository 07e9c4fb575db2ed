"""All states of a file that were left behind, on disk: undo and redo through restarts, and what another has changed."""

from __future__ import annotations

import hashlib
import json
from dataclasses import dataclass
from pathlib import Path
from typing import Any

from variantgen.studio.workspace import write_whole

_STEPS = 500


@dataclass(frozen=True)
class Change:
    """A change: the versions before and after it, the key of the words for it with what they name, whose it was."""

    before: str
    after: str
    words: str
    about: dict[str, str]
    window: str


class Journal:
    """The steps of one file, and how many of them are done; later ones can be done again."""

    def __init__(self, folder: Path) -> None:
        self._folder = folder
        self._file = folder / "journal.json"
        self.steps, self.done = self._read()

    def _read(self) -> tuple[list[Change], int]:
        """What is on disk; a file that cannot be read counts as none."""
        try:
            data = json.loads(self._file.read_text("utf-8"))
            steps = [Change(**step) for step in data["steps"]]
            done = int(data["done"])
        except (OSError, ValueError, KeyError, TypeError):
            return [], 0
        return (steps, done) if 0 <= done <= len(steps) else ([], 0)

    def _write(self) -> None:
        self._folder.mkdir(parents=True, exist_ok=True)
        data: dict[str, Any] = {"done": self.done, "steps": [vars(step) for step in self.steps]}
        write_whole(self._file, json.dumps(data, ensure_ascii=False))

    def keep(self, text: str) -> str:
        """Keep a state; returns its version."""
        version = version_of(text)
        path = self._folder / f"{version}.toml"
        if not path.exists():
            self._folder.mkdir(parents=True, exist_ok=True)
            write_whole(path, text)
        return version

    def text(self, version: str) -> str | None:
        """The state of a version, if it is kept."""
        if not version.isalnum():
            return None
        try:
            text = (self._folder / f"{version}.toml").read_bytes().decode()
        except (OSError, UnicodeDecodeError):
            return None
        return text if version_of(text) == version else None

    def add(self, before: str, after: str, words: str, about: dict[str, str], window: str) -> None:
        """A new step; those that could be done again are forgotten."""
        self.steps = [*self.steps[: self.done], Change(self.keep(before), self.keep(after), words, about, window)]
        for step in self.steps[:-_STEPS]:
            self._forget(step.before)
        self.steps = self.steps[-_STEPS:]
        self.done = len(self.steps)
        self._write()

    def _forget(self, version: str) -> None:
        if not any(version in (step.before, step.after) for step in self.steps[-_STEPS:]):
            (self._folder / f"{version}.toml").unlink(missing_ok=True)

    @property
    def undoable(self) -> Change | None:
        """The step that undo takes back."""
        return self.steps[self.done - 1] if self.done else None

    @property
    def redoable(self) -> Change | None:
        """The step that is done again."""
        return self.steps[self.done] if self.done < len(self.steps) else None

    def move(self, by: int) -> None:
        """So many steps more or less are done."""
        self.done = min(len(self.steps), max(0, self.done + by))
        self._write()


def version_of(text: str) -> str:
    """The version of a text: the begin of its SHA-256."""
    return hashlib.sha256(text.encode()).hexdigest()[:16]
