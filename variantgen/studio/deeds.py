"""What is done to other files than that of an exam, taken back and done again: the class list, answers, files of marks.

A deed is data in the journal of the exam. Where somebody else has changed since what it did, it is not taken back.
"""

from __future__ import annotations

from typing import TYPE_CHECKING

from variantgen.errors import InputError, Problem
from variantgen.studio.documents.document import Document
from variantgen.studio.studio import Studio

if TYPE_CHECKING:
    from variantgen.studio.marking.folder import MarkingFolder
    from variantgen.studio.marking.marked import MarkedBuild


def change(studio: Studio, document: Document, deed: dict[str, str], by: int) -> dict[str, str]:
    """Take a deed back (-1) or do it again (+1); returns what it is from now on. Raises InputError."""
    try:
        return _changed(studio, document, deed, by)
    except KeyError:  # somebody has written into the journal
        raise InputError(Problem("there is nothing of this name", value=deed.get("kind", ""))) from None


def _changed(studio: Studio, document: Document, deed: dict[str, str], by: int) -> dict[str, str]:
    kind = deed["kind"]
    if kind == "list":
        from variantgen.studio.roster.lists import exchange

        old, new = (deed["after"], deed["before"]) if by < 0 else (deed["before"], deed["after"])
        exchange(studio.workspace, old, new)
        return deed
    folder, marked = _marking(studio, document, deed)
    if kind == "answer":
        from variantgen.studio.marking.changes import said

        old, new = (deed["after"], deed["before"]) if by < 0 else (deed["before"], deed["after"])
        said(folder, marked, {**deed, "text": new}, expected=old)
        return deed
    # A file of a marking lies in its place, or in the bin under the name that is kept.
    kept = folder.restore(deed["kept"]) if deed["kept"] else folder.remove(deed["file"])
    return {**deed, "kept": kept}


def _marking(studio: Studio, document: Document, deed: dict[str, str]) -> tuple[MarkingFolder, MarkedBuild]:
    build = studio.builds.finished(document.key).get(deed.get("build", ""))
    if build is None:
        raise InputError(Problem("there is nothing of this name", value=deed.get("build", "")))
    return studio.marking(build)
