"""One exam file: its state, its mistakes, its changes by the studio and by others."""

from __future__ import annotations

import contextlib
import threading
from pathlib import Path
from typing import TYPE_CHECKING, Any

from msgspec import Struct

from variantgen.errors import InputError, Problem, VariantgenError
from variantgen.limits import TOML_BYTES
from variantgen.studio.documents.edits import Operation, apply, value_at
from variantgen.studio.documents.identity import same_place, through_list
from variantgen.studio.documents.journal import FileChange, Journal, version_of
from variantgen.studio.documents.mistakes import Mistake, is_empty, located
from variantgen.studio.documents.toml_lines import written_path
from variantgen.studio.workspace import is_own, write_whole
from variantgen.tables import parse_toml, read_text

if TYPE_CHECKING:
    from collections.abc import Callable, Sequence

    from variantgen.exam.exam import Exam


_BYTE_ORDER_MARK = b"\xef\xbb\xbf"


class ConflictError(VariantgenError):
    """The key was changed in the meantime: ``mine`` is what was to be written, ``theirs`` what is there now.

    ``moved``: the path may mean something else by now, because the list that it goes through has another order.
    """

    def __init__(self, path: str, mine: Any, theirs: Any, moved: bool = False) -> None:
        self.path, self.mine, self.theirs, self.moved = path, mine, theirs, moved
        super().__init__(f"{path} was changed in the meantime")


class RefusedError(VariantgenError):
    """The change would bring mistakes into the file; it was not made."""

    def __init__(self, problems: Sequence[Mistake]) -> None:
        self.problems = tuple(problems)
        super().__init__("; ".join(problem.message for problem in problems))


class ChangedSinceError(InputError):
    """What a step has done is no longer there as it left it: the step can never be taken back, nor done again."""


class _OvertakenError(Exception):
    """Another program has saved the file while a change was made."""


class State(Struct, frozen=True):
    """The text of a file at a version, what it says, and what is wrong with it."""

    text: str
    version: str
    data: dict[str, Any]
    broken: str = ""


def _never(deed: dict[str, str], by: int) -> dict[str, str]:
    """For files of which nothing is done elsewhere."""
    raise InputError(Problem("is no longer there", value=str(deed), key=str(by)))


class Document:
    """An exam file that is changed from several windows and by editors.

    Its methods may be called from any thread. Ends of lines and a mark of byte order stay as the file has them.
    """

    def __init__(self, key: str, path: Path, folder: Path, journal: Path) -> None:
        self.key, self.path, self._folder = key, path, folder
        self._lock, self._moving = threading.RLock(), False
        self.journal = Journal(journal)
        self._seen: tuple[int, int] = (0, 0)
        self._state = self._read()
        self.journal.follow(self._state.text)  # it may have been changed while no studio ran

    def _read(self) -> State:
        """The file as it is now. Raises InputError."""
        if not is_own(self.path, self._folder):
            raise InputError(Problem("is no longer there", file=self.path.name))
        status = self.path.stat()
        self._seen = (status.st_mtime_ns, status.st_size)
        text = read_text(self.path)
        with self.path.open("rb") as file:
            begin = _BYTE_ORDER_MARK if file.read(3) == _BYTE_ORDER_MARK else b""
        returns = "\r\n" in text and text.count("\r\n") == text.count("\n")
        self._style = begin, "\r\n" if returns else "\n"
        return _state(text.replace("\r\n", "\n") if returns else text, self.path)

    def state(self) -> State:
        """The present state; a change by an editor is a step of the journal."""
        with self._lock:
            self.refresh()
            return self._state

    def refresh(self) -> bool:
        """Look at the file; whether another has changed it. Raises InputError where it is gone."""
        with self._lock:
            try:
                status = self.path.stat()
            except OSError:
                raise InputError(Problem("is no longer there", file=self.path.name)) from None
            if (status.st_mtime_ns, status.st_size) == self._seen:
                return False
            before, self._state = self._state, self._read()
            if before.version == self._state.version:
                return False
            self.journal.add(before.text, self._state.text, "outside", {}, "")
            return True

    def exam(self) -> Exam:
        """The checked exam. Raises InputError with every mistake."""
        found = self._checked(self.state().text)  # families may have changed, too; what is read of them is kept
        if isinstance(found, InputError):
            raise found
        return found

    def _checked(self, text: str) -> Exam | InputError:
        from variantgen.families.reading.folders import family_folders
        from variantgen.outputs.formats import parse_exam

        try:
            return parse_exam(text, self.path, family_folders((), beside=self.path))
        except InputError as error:
            return error

    def mistakes(self) -> list[Mistake]:
        """What is wrong with the file, at its lines."""
        try:
            self.exam()
        except InputError as error:
            return located(error.problems, self.state().text, self.path)
        return []

    def check(self, text: str) -> list[Mistake]:
        """What would be wrong with another text of the file."""
        found = self._checked(text)
        return located(found.problems, text, self.path) if isinstance(found, InputError) else []

    def edit(self, operations: Sequence[Operation], version: str, window: str = "", about: str = "") -> bool:
        """Change the file by operations that were made on a version of it; whether others have changed it since.

        Raises ConflictError, RefusedError, or InputError for operations that do not fit.
        """
        with self._lock:
            while True:
                self.refresh()
                if self._state.broken:
                    raise InputError(Problem(self._state.broken, file=self.path.name, remedy="correct the text first"))
                self._compare(operations, version)
                merged = version != self._state.version
                with contextlib.suppress(_OvertakenError):
                    self._put(apply(self._state.text, operations), *_described(operations, about), window)
                    return merged

    def replace(self, text: str, version: str, window: str = "") -> State:
        """Put another text into the file. Raises ConflictError, or RefusedError for a text with new mistakes."""
        with self._lock:
            while True:
                self.refresh()
                if version != self._state.version:
                    raise ConflictError("", text, self._state.text)
                with contextlib.suppress(_OvertakenError):
                    return self._put(text, "text", {}, window)

    def _put(self, text: str, words: str, about: dict[str, str], window: str) -> State:
        """Write a new text, unless it has mistakes that the file has not."""
        if text == self._state.text:
            return self._state
        if len(text.encode()) > TOML_BYTES:
            message = f"would be larger than {TOML_BYTES // 1000} kB"
            raise InputError(Problem(message, file=self.path.name, remedy="shorten its texts"))
        known = {(m.key, m.message) for m in self.mistakes()}
        new = [m for m in self.check(text) if (m.key, m.message) not in known and not is_empty(m)]
        if new:
            raise RefusedError(new)
        before = self._state.text
        self._write(text)
        self.journal.add(before, text, words, about, window)
        return self._state

    def _write(self, text: str) -> None:
        """Write a new text in place of the present one. Raises _OvertakenError where the file is not as it was."""
        if self.path.is_symlink():
            raise InputError(Problem("is a link", file=self.path.name))

        def compare() -> None:
            if self._read().text != self._state.text:
                self._seen = (0, 0)
                raise _OvertakenError

        begin, end = self._style
        write_whole(self.path, begin + text.replace("\n", end).encode(), compare)
        status = self.path.stat()
        self._seen = (status.st_mtime_ns, status.st_size)
        self._state = _state(text, self.path)

    def _compare(self, operations: Sequence[Operation], version: str) -> None:
        """Raise ConflictError where a key of the operations is no longer as it was in the version."""
        if version == self._state.version:
            return
        text = self.journal.text(version)
        then = _state(text, self.path).data if text is not None else None
        for operation in operations:
            path = operation.touched
            now = value_at(self._state.data, path)
            if then is not None and not same_place(then, self._state.data, path):
                raise ConflictError(written_path(operation.path), operation.value, now, moved=True)
            if then is None or value_at(then, path) != now:
                raise ConflictError(
                    written_path(operation.path), operation.value, now, then is None and through_list(path)
                )

    def note(self, words: str, about: dict[str, str], deed: dict[str, str]) -> None:
        """Note what was done elsewhere, so that it can be taken back in its turn."""
        with self._lock:
            self.refresh()
            self.journal.add(self._state.text, self._state.text, words, about, "", deed)

    def undo(
        self,
        by: int = -1,
        version: str | None = None,
        change: Callable[[dict[str, str], int], dict[str, str]] = _never,
        position: str | None = None,
    ) -> FileChange | None:
        """Take the last step back (or do it again, +1); what it was, or None if there is none.

        What was done elsewhere is ``change``d by who knows how, and may be another deed after that. It may take
        long, as where scans are read, so that it is done outside the lock. Raises ConflictError where the file has
        another version, or the journal another position, than was seen; InputError where the step cannot be taken back
        now: it is struck out for ChangedSinceError only.
        """
        with self._lock:
            self._seen = (0, 0)  # what was saved within the same tick of the clock counts, too
            self.refresh()
            if version not in (None, self._state.version) or position not in (None, self.journal.position):
                raise ConflictError("", None, None, moved=True)
            if self._moving:
                raise InputError(Problem("another step is being taken back", remedy="wait until that is done"))
            step = self.journal.next(by)
            if step is None:
                return None
            if not step.deed:
                return self._retrace(step, by)
            self._moving = True
        try:
            deed = change(step.deed, by)
        except ChangedSinceError:
            with self._lock:
                if self.journal.next(by) == step:  # else the later steps are to be taken back first
                    self.journal.strike(step)
            raise
        else:
            with self._lock:
                self.journal.finish(step, by, deed)
            return step
        finally:
            self._moving = False

    def _retrace(self, step: FileChange, by: int) -> FileChange | None:
        """Write the text from which a step came (or to which, +1); None if it is not kept."""
        text = self.journal.text(step.before if by < 0 else step.after)
        if text is None:
            return None
        try:
            self._write(text)
        except _OvertakenError:
            raise ConflictError("", None, None, moved=True) from None
        self.journal.move(by)
        return step


def _state(text: str, path: Path) -> State:
    try:
        return State(text, version_of(text), parse_toml(text, path))
    except InputError as error:
        return State(text, version_of(text), {}, error.problems[0].message)


def _described(operations: Sequence[Operation], about: str) -> tuple[str, dict[str, str]]:
    """The key of the words for an edit, and what they name."""
    first = operations[0]
    numbers = [part for part in first.path if isinstance(part, int)]
    number = str((numbers[0] if numbers else first.at) + 1)
    if first.path[0] == "problem" and first.op in ("insert", "remove", "move"):
        return first.op, {"number": number}
    keys = [str(part) for part in first.path if isinstance(part, str) and part != "problem"]
    words = "changed_in_problem" if first.path[0] == "problem" else "changed"
    return words, {"number": number, "what": about or ".".join(keys)}
