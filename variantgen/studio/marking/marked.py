"""The marks of a build, computed again as soon as something that they are made from has changed."""

from __future__ import annotations

import threading
from collections.abc import Callable, Generator
from pathlib import Path
from typing import TypeAlias

from msgspec import Struct
from msgspec.structs import replace

from variantgen.errors import InputError, Problem, VariantgenError
from variantgen.exam.manifest import read_manifest
from variantgen.exam.sections.marking_policy import MarkingPolicy, read_policy_file
from variantgen.families.reading.folders import family_folders
from variantgen.finished.restore import Finished, restore_unchanged
from variantgen.marking.answer_tables import ReadAnswers, read_answers
from variantgen.marking.drawn import as_drawn
from variantgen.marking.form_words import FormWords
from variantgen.marking.key import Key
from variantgen.marking.marks import Marked, mark
from variantgen.marking.scan.collecting import LostPage, Question, Scans, SeenPage, collect
from variantgen.marking.scan.copies import ScannedAnswer
from variantgen.marking.scan.excerpts import page_png
from variantgen.marking.scan.joining import join
from variantgen.marking.scan.pictures import ScanImage, is_picture, page_count, pictures
from variantgen.marking.worth import worth_of
from variantgen.studio.marking.folder import MarkingFolder
from variantgen.studio.workspace import Workspace

Tell: TypeAlias = Callable[[str, int, int], None]
_PDFIUM = threading.Lock()  # the library that opens scans is for one thread at a time: held for a page, never a file


class _StoppedError(Exception):
    """Scans are to be read no further."""


class MarkedClass(Struct, frozen=True):
    """The marks of a class, with what they were made from; ``doubtful`` are readings that nobody has decided.

    ``pages`` are those of scans whose student is known, by the place of the student, ``lost`` those that could not be
    read, ``faults`` the reasons why files could not, by their names in the folder of the marking.
    """

    finished: Finished
    read: ReadAnswers
    policy: MarkingPolicy
    marked: Marked
    scanned: dict[Question, ScannedAnswer]
    doubtful: dict[Question, ScannedAnswer]
    pages: dict[int, list[SeenPage]]
    lost: list[LostPage]
    faults: dict[str, VariantgenError]

    @property
    def key(self) -> Key:
        """What is right."""
        return Key(self.finished.record, self.policy.tolerance)

    def place(self, code: str) -> int:
        """The place of a student by the code of the sheet. Raises KeyError."""
        return {sheet.code: place for place, sheet in enumerate(self.finished.record.sheets)}[code]

    def by_policy(self, policy: MarkingPolicy) -> Marked:
        """The marks by other rules."""
        return mark(self.finished, self.read, policy)


class MarkedBuild:
    """The marks of one build; the last ones are kept, scans are read once.

    While they are, ``tell`` gets the name of each file, how many of its pages have been read, how many it has; and it
    can be stopped: ``stopping`` is set until who asked for it has put the files away.
    """

    def __init__(self, workspace: Workspace, folder: MarkingFolder, tell: Tell) -> None:
        self._workspace, self._folder, self._tell = workspace, folder, tell
        self._lock, self.stopping = threading.Lock(), threading.Event()
        self._known: tuple[tuple[object, ...], MarkedClass] | None = None
        self._restored: tuple[int, Finished] | None = None
        self._scans: tuple[tuple[object, ...], Scans] | None = None
        self._read: set[tuple[str, int]] = set()  # the files that were read to the end, by whatever rules

    def current(self) -> MarkedClass:
        """The marks of what is there now. Raises InputError where the build cannot be read, or scans no longer are."""
        with self._lock:
            version = self._folder.version()
            if self._known is None or self._known[0] != version:
                try:
                    self._known = version, self._computed()
                except _StoppedError:
                    raise InputError(Problem("the scans are no longer read: that was stopped")) from None
            return self._known[1]

    def picture(self, page: SeenPage) -> bytes:
        """A page of a scan (PNG), opened for this. Raises InputError where it is no longer there."""
        with _PDFIUM:
            found = list(pictures(page.path, page.within)) if page.path in self._folder.every() else []
        grey = found[0].grey if found else None
        if grey is None:
            raise InputError(Problem("there is no such page", value=page.where, remedy="load the page again"))
        return page_png(grey, page.placed)

    def stop(self, done: Callable[[str, str], None]) -> int:
        """Stop reading scans; files that were never read to the end go into the bin: how many those are.

        ``done`` is told the name of each and that in the bin before another window may change the files.
        """
        self.stopping.set()
        try:
            with self._lock:  # from here on nothing is read to the end until ``stopping`` is cleared
                read = frozenset(self._read)
            with self._folder.lock:
                unread = [path for path in self._folder.every() if is_picture(path) and _stamp(path) not in read]
                for path in unread:
                    done(path.name, self._folder.remove(path.name))
            return len(unread)
        finally:
            self.stopping.clear()

    def _computed(self) -> MarkedClass:
        finished = self._finished()
        policy_file, faults = self._folder.policy(), dict[str, VariantgenError]()
        policy = finished.exam.marking
        if policy_file is not None:
            try:
                own_rules = read_policy_file(policy_file, Key(finished.record).asked)
                worth_of(finished, Key(finished.record), own_rules)
                policy = own_rules
            except InputError as error:
                faults[policy_file.name] = error
        read = ReadAnswers((), ())
        scans: list[Path] = []
        for path in self._folder.every():
            if is_picture(path):
                scans.append(path)
                continue
            try:
                own = read_answers([path], FormWords.of(finished.exam))
            except InputError as error:
                faults[path.relative_to(self._folder.path).as_posix()] = error
                continue
            read = ReadAnswers(
                (*read.answers, *own.answers),
                (*read.not_matched, *own.not_matched),
                (*read.corrections, *own.corrections),
            )
        finished, read = as_drawn(finished, read)
        scanned: dict[Question, ScannedAnswer] = {}
        doubtful: dict[Question, ScannedAnswer] = {}
        pages: dict[int, list[SeenPage]] = {}
        lost: list[LostPage] = []
        if scans:
            try:
                joined = join(finished, read, scans, policy, collected=self._collected(scans, finished, policy))
            except VariantgenError as error:
                faults[scans[0].name] = error
            else:
                read, scanned = joined.answers, dict(joined.scans.answers)
                pages, lost = joined.scans.pages, joined.scans.lost
                doubtful = {asked: one for asked, one in joined.scans.doubtful.items() if asked not in joined.typed}
        marked = mark(finished, read, policy)
        return MarkedClass(finished, read, policy, marked, scanned, doubtful, pages, lost, faults)

    def _finished(self) -> Finished:
        """The build; it is restored once."""
        changed = (self._folder.build.folder / "manifest.json").stat().st_mtime_ns
        if self._restored is None or self._restored[0] != changed:
            record = read_manifest(self._folder.build.folder)
            self._restored = changed, restore_unchanged(record, family_folders((self._workspace.folder,)))
        return self._restored[1]

    def _collected(self, scans: list[Path], finished: Finished, policy: MarkingPolicy) -> Scans:
        """What the scans say; they are read once, whatever is typed."""
        version = (policy.tolerance, *map(_stamp, scans))
        if self._scans is None or self._scans[0] != version:
            names = self._folder.names()

            def tell(path: Path, done: int) -> None:
                if self.stopping.is_set():
                    raise _StoppedError
                self._tell(names.get(path.name, path.name), done, pages[path][0])
                if done == pages[path][0]:
                    self._read.add(pages[path][1])

            with _PDFIUM:
                pages = {path: (page_count(path), _stamp(path)) for path in scans}
            self._scans = version, collect(scans, Key(finished.record, policy.tolerance), tell=tell, opened=_opened)
        return replace(self._scans[1], answers=dict(self._scans[1].answers))


def _opened(path: Path) -> Generator[ScanImage]:
    """The pages of a scan; between them others may open theirs."""
    found = pictures(path)
    try:
        while True:
            with _PDFIUM:
                picture = next(found, None)
            if picture is None:
                return
            yield picture
    finally:
        with _PDFIUM:
            found.close()


def _stamp(path: Path) -> tuple[str, int]:
    return path.name, path.stat().st_mtime_ns
