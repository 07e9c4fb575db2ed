"""What all pages of a running studio share: its folder, its documents, its events, its work in the background."""

from __future__ import annotations

import asyncio
import threading
from collections.abc import Callable
from concurrent.futures import ThreadPoolExecutor
from functools import cached_property
from pathlib import Path
from typing import TYPE_CHECKING, TypeVar

from msgspec import Struct, field

from variantgen.errors import InputError, Problem
from variantgen.studio.building.builds import Builds, FinishedBuild
from variantgen.studio.building.preview import Previews
from variantgen.studio.documents.document import Document
from variantgen.studio.events import Events
from variantgen.studio.workspace import Workspace

if TYPE_CHECKING:
    from variantgen.studio.marking.folder import MarkingFolder
    from variantgen.studio.marking.marked import MarkedBuild
    from variantgen.studio.roster.table import ClassTables

T = TypeVar("T")
_WATCH_SECONDS = 1.0


class UnknownKeyError(InputError):
    """An address names nothing that was found in the folder."""

    def __init__(self, key: str) -> None:
        super().__init__(Problem("there is nothing of this name", value=key))


class Studio(Struct, dict=True):
    """A running studio.

    Figures are drawn by one thread and sheets by another, so that a slider does not wait for a page; both take their
    turns with the server, which only reads and writes.
    """

    workspace: Workspace
    events: Events = field(default_factory=Events)
    figures: ThreadPoolExecutor = field(default_factory=lambda: ThreadPoolExecutor(1, "figures"))
    sheets: ThreadPoolExecutor = field(default_factory=lambda: ThreadPoolExecutor(1, "sheets"))
    previews: Previews = field(default_factory=Previews)
    _markings: dict[Path, tuple[MarkingFolder, MarkedBuild]] = field(default_factory=dict)
    _documents: dict[Path, Document] = field(default_factory=dict)
    _lock: threading.Lock = field(default_factory=threading.Lock)

    def __post_init__(self) -> None:
        self.builds = Builds(self.workspace, self.events)

    def document(self, key: str) -> Document:
        """The exam of a key. Raises UnknownKeyError."""
        path = self.workspace.exams().get(key)
        if path is None:
            raise UnknownKeyError(key)
        with self._lock:
            if path not in self._documents:
                journal = self.workspace.state("journals", key)
                self._documents[path] = Document(key, path, self.workspace.folder, journal)
            return self._documents[path]

    @cached_property
    def class_tables(self) -> ClassTables:
        """The table of a class that was brought to the page Roster."""
        from variantgen.studio.roster.table import ClassTables

        return ClassTables(self.workspace)

    def marking(self, build: FinishedBuild) -> tuple[MarkingFolder, MarkedBuild]:
        """What the marking of a build is made from, and its marks. Raises InputError for links."""
        from variantgen.studio.marking.folder import MarkingFolder
        from variantgen.studio.marking.marked import MarkedBuild

        with self._lock:
            if build.folder not in self._markings:
                folder = MarkingFolder(self.workspace, build)
                self._markings[build.folder] = folder, MarkedBuild(self.workspace, folder, self._reading(build))
            return self._markings[build.folder]

    def _reading(self, build: FinishedBuild) -> Callable[[str, int, int], None]:
        """Tell the windows how far the scans of a build are read."""
        return lambda file, done, total: self.events.tell("scan", build=build.key, file=file, done=done, total=total)

    async def draw(self, work: Callable[[], T]) -> T:
        """Do work on the thread of figures."""
        return await asyncio.get_running_loop().run_in_executor(self.figures, work)

    async def typeset(self, work: Callable[[], T]) -> T:
        """Do work on the thread of sheets."""
        return await asyncio.get_running_loop().run_in_executor(self.sheets, work)

    async def watch(self) -> None:
        """Look every second, while a window is open, whether an editor has changed an exam."""
        while True:
            await asyncio.sleep(_WATCH_SECONDS)
            if self.events.listening:
                await asyncio.to_thread(self.look)

    def look(self) -> None:
        """Tell the windows of exams that others have changed."""
        for document in list(self._documents.values()):
            try:
                changed = document.refresh()
            except InputError:
                self._documents.pop(document.path, None)
                continue
            if changed:
                self.tell_changed(document, "")

    def note(self, document: Document, words: str, about: dict[str, str], deed: dict[str, str], window: str) -> None:
        """Note what a window has done to another file than that of an exam, as a step of its undo; tell all."""
        document.note(words, about, deed)
        self.tell_changed(document, window)

    def tell_changed(self, document: Document, window: str) -> None:
        """Tell the windows that an exam has another version or another last step, and which window has made it."""
        self.events.tell("doc", exam=document.key, version=document.state().version, window=window)

    def close(self) -> None:
        """Let windows and threads go."""
        self.events.end()
        for pool in (self.figures, self.sheets):
            pool.shutdown(wait=True, cancel_futures=True)
        self.builds.close()
        self.previews.close()
