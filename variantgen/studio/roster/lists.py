"""The class list of the folder as the studio writes it: no list is ever lost, and the last step can be taken back.

``.studio/roster/lists`` holds every list that was replaced or written, named by its SHA-256; ``steps.json`` the steps,
each as the list before ('' where there was none) and the one that was written.
"""

from __future__ import annotations

import hashlib
import json
import re

from variantgen.errors import InputError, Problem
from variantgen.studio.workspace import ROSTER, STATE, Workspace, write_whole

_HASH = re.compile(r"[0-9a-f]{64}|")
_CHANGED = Problem(
    "the class list was changed since",
    remedy=f"it stays as it is; earlier lists are in {STATE}/roster/lists",
)


def write_list(workspace: Workspace, text: str) -> str:
    """Write the class list; its SHA-256, by which it is taken back. Raises InputError where it changes meanwhile."""
    content, before = text.encode(), _now(workspace)
    step = [_kept(workspace, before), _kept(workspace, content)]

    def compare() -> None:
        if _now(workspace) != before:
            raise InputError(_CHANGED)

    write_whole(workspace.folder / ROSTER, content, compare)
    if before != content:
        _note(workspace, [*_steps(workspace), step])
    return step[1]


def take_back(workspace: Workspace, written: str) -> None:
    """Let the class list be as it was before the studio wrote the list of a SHA-256.

    Raises InputError where that is not what is there now, or not the last one that the studio wrote.
    """
    steps = _steps(workspace)
    if not steps or steps[-1][1] != written or _hash(_now(workspace)) != written:
        raise InputError(_CHANGED)
    before, path = steps[-1][0], workspace.folder / ROSTER
    if before:
        write_whole(path, _list(workspace, before))
    else:
        path.unlink()
    _note(workspace, steps[:-1])


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
    path = workspace.state("roster", "lists", f"{name}.csv")
    if not path.is_file():
        raise InputError(Problem("is no longer there", file=str(path)))
    return path.read_bytes()


def _steps(workspace: Workspace) -> list[list[str]]:
    """The steps that can be taken back; none where they cannot be read."""
    try:
        found = json.loads(workspace.state("roster", "steps.json").read_text("utf-8"))
    except (OSError, ValueError, RecursionError):
        return []
    steps = found if isinstance(found, list) else []
    return [
        step
        for step in steps
        if isinstance(step, list)
        and len(step) == 2
        and all(isinstance(own, str) and _HASH.fullmatch(own) for own in step)
    ]


def _note(workspace: Workspace, steps: list[list[str]]) -> None:
    write_whole(workspace.state("roster", "steps.json"), json.dumps(steps))
