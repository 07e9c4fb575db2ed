"""The class list of the folder as the studio writes it: no list is ever lost, and what was written can be taken back.

``.studio/roster/lists`` holds every list that was replaced or written, named by its SHA-256.
"""

from __future__ import annotations

import hashlib
import re

from variantgen.errors import InputError, Problem
from variantgen.studio.documents.document import ChangedSinceError
from variantgen.studio.workspace import ROSTER, STATE, Workspace, write_whole

_HASH = re.compile(r"[0-9a-f]{64}")
_CHANGED = Problem(
    "the class list was changed since",
    remedy=f"it stays as it is; earlier lists are in {STATE}/roster/lists",
)


def write_list(workspace: Workspace, text: str) -> tuple[str, str]:
    """Write the class list; the SHA-256 of the one before ('' for none) and of this one.

    Raises InputError where it changes meanwhile.
    """
    content, before = text.encode(), _now(workspace)
    step = _kept(workspace, before), _kept(workspace, content)

    def compare() -> None:
        if _now(workspace) != before:
            raise InputError(_CHANGED)

    write_whole(workspace.folder / ROSTER, content, compare)
    return step


def exchange(workspace: Workspace, old: str, new: str) -> None:
    """Put one list in the place of another, both by their SHA-256, '' for none.

    Raises ChangedSinceError where the old one is not what is there now, or the new one is no longer kept.
    """

    def compare() -> None:
        if _hash(_now(workspace)) != old:
            raise ChangedSinceError(_CHANGED)

    compare()
    _kept(workspace, _now(workspace))  # its copy may have been removed
    path = workspace.folder / ROSTER
    if new:
        write_whole(path, _list(workspace, new), compare)
    else:
        compare()
        path.unlink(missing_ok=True)


def _now(workspace: Workspace) -> bytes | None:
    path = workspace.roster()
    return path.read_bytes() if path else None


def _hash(content: bytes | None) -> str:
    return "" if content is None else hashlib.sha256(content).hexdigest()


def _kept(workspace: Workspace, content: bytes | None) -> str:
    """The SHA-256 of a list, which is kept by it; '' for none."""
    name = _hash(content)
    if content is not None:
        write_whole(workspace.state("roster", "lists", f"{name}.csv"), content)
    return name


def _list(workspace: Workspace, name: str) -> bytes:
    if not _HASH.fullmatch(name) or not (path := workspace.state("roster", "lists", f"{name}.csv")).is_file():
        raise ChangedSinceError(Problem("is no longer there", file=ROSTER))
    return path.read_bytes()
