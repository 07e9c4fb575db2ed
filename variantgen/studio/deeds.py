"""What is done to other files than that of an exam, taken back and done again: the class list, answers, files of marks.

A deed is data in the journal of the exam. Where somebody else has changed since what it did, it is not taken back:
lists and files are known by their SHA-256, an answer by its text.
"""

from __future__ import annotations

from collections.abc import Callable
from typing import TYPE_CHECKING

from variantgen.errors import Problem
from variantgen.studio.documents.document import ChangedSinceError, Document
from variantgen.studio.studio import Studio, UnknownKeyError

if TYPE_CHECKING:
    from variantgen.studio.marking.folder import MarkingFolder
    from variantgen.studio.marking.marked import MarkedBuild

Deed = dict[str, str]


def change(studio: Studio, document: Document, deed: Deed, by: int) -> Deed:
    """Take a deed back (-1) or do it again (+1); returns what it is from now on.

    Raises ChangedSinceError where that can never be done, InputError where it cannot be done now.
    """
    kind = deed.get("kind", "")
    fields, work = _KINDS.get(kind, ((), None))
    if work is None or not deed.keys() >= set(fields):  # somebody has written into the journal
        raise ChangedSinceError(Problem("there is nothing of this name", value=kind))
    try:
        return work(studio, document, deed, by)
    except UnknownKeyError as error:  # as of a build that was removed
        raise ChangedSinceError(error.problems) from None


def _list(studio: Studio, _: Document, deed: Deed, by: int) -> Deed:
    from variantgen.studio.roster.lists import exchange

    with studio.class_tables.lock:
        exchange(studio.workspace, *_from_to(deed, by))
    return deed


def _answer(studio: Studio, document: Document, deed: Deed, by: int) -> Deed:
    from variantgen.studio.marking.changes import write_answer

    old, new = _from_to(deed, by)
    folder, marked = _marking(studio, document, deed)
    write_answer(folder, marked.current(), {**deed, "text": new}, expected=old)
    return deed


def _file(studio: Studio, document: Document, deed: Deed, _: int) -> Deed:
    folder, _marked = _marking(studio, document, deed)
    file, kept = deed["file"], deed["kept"]
    with folder.lock:
        now = folder.digest(file)
        is_there = kept in dict(folder.binned()) if kept else now != ""
        if not is_there or now != deed.get("digest", now):  # journals of earlier versions have none
            raise ChangedSinceError(Problem("was changed since", key=folder.names().get(file, file)))
        return of_file(folder, file, folder.restore(kept) if kept else folder.remove(file))


def of_file(folder: MarkingFolder, file: str, kept: str) -> Deed:
    """The deed by which a file of a marking lies in its place, or in the bin, or has replaced one there.

    ``kept`` is the name in the bin of what is to come back, '' where nothing is. Call it under ``folder.lock``.
    """
    return {"kind": "file", "build": folder.build.key, "file": file, "kept": kept, "digest": folder.digest(file)}


_KINDS: dict[str, tuple[tuple[str, ...], Callable[[Studio, Document, Deed, int], Deed]]] = {
    "list": (("before", "after"), _list),
    "answer": (("build", "code", "problem", "quantity", "before", "after"), _answer),
    "file": (("build", "file", "kept"), _file),
}  # the fields of each kind, and who takes it back


def _from_to(deed: Deed, by: int) -> tuple[str, str]:
    """What stands there now, and what is to stand there."""
    return (deed["after"], deed["before"]) if by < 0 else (deed["before"], deed["after"])


def _marking(studio: Studio, document: Document, deed: Deed) -> tuple[MarkingFolder, MarkedBuild]:
    build = studio.builds.finished(document.key).get(deed["build"])
    if build is None:
        raise UnknownKeyError(deed["build"])
    return studio.marking(build)
