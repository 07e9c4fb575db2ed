"""Whether a path still means the same table of a list after others have changed the file."""

from __future__ import annotations

from typing import Any

from variantgen.studio.documents.edits import value_at
from variantgen.studio.documents.toml_lines import Path


def same_place(then: Any, now: Any, path: Path) -> bool:
    """Whether a path through a list means the same table in both contents: it is equal, or none has changed place."""
    place = next((i for i, part in enumerate(path) if isinstance(part, int)), None)
    if place is None:
        return True
    old, new = value_at(then, path[:place]), value_at(now, path[:place])
    table = path[: place + 1]
    if value_at(then, table) == value_at(now, table):
        return True
    if not (isinstance(old, list) and isinstance(new, list) and len(old) == len(new)):
        return False
    changed = [(before, after) for before, after in zip(old, new, strict=True) if before != after]
    afterwards = [after for _, after in changed]
    return all(_kind(before) == _kind(after) and before not in afterwards for before, after in changed)


def through_list(path: Path) -> bool:
    """Whether a path goes through a list."""
    return any(isinstance(part, int) for part in path)


def _kind(table: Any) -> Any:
    """What a problem draws from, by which it is known."""
    return (table.get("family"), table.get("families")) if isinstance(table, dict) else None
