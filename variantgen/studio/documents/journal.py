"""What was done to an exam, on disk: undo and redo through restarts, and what another has changed.

Most steps lead from one text of its file to another, and all texts are kept. What was done elsewhere, to the class list
or to marks, is a step with a ``deed``: how it is taken back is the business of who has done it.
"""

from __future__ import annotations

import hashlib
import json
import time
from pathlib import Path
from typing import Any

from msgspec import Struct, field
from msgspec.structs import asdict, replace

from variantgen.studio.workspace import write_whole

_STEPS = 500
_CONTINUED = ("changed", "changed_in_problem", "text")
_PAUSE = 1.5  # seconds between changes that are one step


class FileChange(Struct, frozen=True):
    """A change: the versions before and after it, the key of the words for it with what they name, whose it was.

    ``deed`` is what was done to another file than that of the exam.
    """

    before: str
    after: str
    words: str
    about: dict[str, str]
    window: str
    time: float = 0.0
    deed: dict[str, str] = field(default_factory=dict)

    def continues(self, other: FileChange) -> bool:
        """Whether it goes on with another one."""
        same = (self.words, self.about, self.window) == (other.words, other.about, other.window)
        return same and self.words in _CONTINUED and self.time - other.time < _PAUSE


class Journal:
    """The steps of one file, and how many of them are done; later ones can be done again."""

    def __init__(self, folder: Path) -> None:
        self._folder = folder
        self._file = folder / "journal.json"
        self.steps, self.done = self._read()

    def _read(self) -> tuple[list[FileChange], int]:
        """What is on disk; a file that cannot be read counts as none."""
        try:
            data = json.loads(self._file.read_text("utf-8"))
            steps = [FileChange(**step) for step in data["steps"]]
            done = int(data["done"])
            texts = [
                text
                for s in steps
                for text in (
                    s.before,
                    s.after,
                    s.words,
                    s.window,
                    *[t for own in (s.about, s.deed) for t in own.items()],
                )
            ]
            texts = [part for text in texts for part in (text if isinstance(text, tuple) else (text,))]
            if not all(isinstance(text, str) for text in texts) or not all(isinstance(s.time, float) for s in steps):
                raise ValueError(self._file)
        except (OSError, ValueError, KeyError, TypeError, AttributeError, OverflowError, RecursionError):
            return [], 0
        return (steps, done) if 0 <= done <= len(steps) else ([], 0)

    def _write(self) -> None:
        self._folder.mkdir(parents=True, exist_ok=True)
        data: dict[str, Any] = {"done": self.done, "steps": [asdict(step) for step in self.steps]}
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

    def add(
        self,
        before: str,
        after: str,
        words: str,
        about: dict[str, str],
        window: str,
        deed: dict[str, str] | None = None,
    ) -> None:
        """A new step; those that could be done again are forgotten.

        What a window goes on doing to the same key, as steps of a slider, is one step.
        """
        new = FileChange(self.keep(before), self.keep(after), words, about, window, time.time(), deed or {})
        steps, last = self.steps[: self.done], self.undoable
        if last is not None and new.continues(last):
            new, steps = replace(new, before=last.before), steps[:-1]
        self.steps = [*steps, new]
        for step in self.steps[:-_STEPS]:
            self._forget(step.before)
        self.steps = self.steps[-_STEPS:]
        self.done = len(self.steps)
        self._write()

    def follow(self, text: str) -> None:
        """Note a present text that no step has led to, so that it can be gone back to."""
        if not self.steps:
            return
        last = self.steps[self.done - 1].after if self.done else self.steps[0].before
        if last == version_of(text):
            return
        before = self.text(last)
        if before is None:  # its texts are gone: nothing can be taken back
            self.steps, self.done = [], 0
        else:
            self.add(before, text, "outside", {}, "")

    def _forget(self, version: str) -> None:
        if not any(version in (step.before, step.after) for step in self.steps[-_STEPS:]):
            (self._folder / f"{version}.toml").unlink(missing_ok=True)

    @property
    def undoable(self) -> FileChange | None:
        """The step that undo takes back."""
        return self.steps[self.done - 1] if self.done else None

    @property
    def redoable(self) -> FileChange | None:
        """The step that is done again."""
        return self.steps[self.done] if self.done < len(self.steps) else None

    @property
    def position(self) -> str:
        """Where undo and redo stand, by the times of their steps: another one as soon as there are other steps."""
        return "/".join(str(step.time) if step else "" for step in (self.undoable, self.redoable))

    def next(self, by: int) -> FileChange | None:
        """The step that undo (-1) or redo (+1) is of."""
        return self.undoable if by < 0 else self.redoable

    def strike(self, step: FileChange) -> None:
        """Take a step out of all: it cannot be done any more."""
        if step not in self.steps:
            return
        place = self.steps.index(step)
        del self.steps[place]
        self.done -= place < self.done
        self._write()

    def finish(self, step: FileChange, by: int, deed: dict[str, str]) -> None:
        """A step was taken back or done again (+1), and is a deed from now on.

        Others may have come meanwhile: below them it is taken out of all, and what was done again is the last of them.
        """
        if step == self.next(by):
            self.move(by, deed)
        elif by < 0:
            self.strike(step)
        else:
            self.steps = [*self.steps[: self.done], replace(step, deed=deed)]
            self.move(+1)

    def move(self, by: int, deed: dict[str, str] | None = None) -> None:
        """So many steps more or less are done; ``deed`` is what the step between them is from now on."""
        if deed is not None:
            place = self.done - 1 if by < 0 else self.done
            self.steps[place] = replace(self.steps[place], deed=deed)
        self.done = min(len(self.steps), max(0, self.done + by))
        self._write()


def version_of(text: str) -> str:
    """The version of a text: the begin of its SHA-256."""
    return hashlib.sha256(text.encode()).hexdigest()[:16]
