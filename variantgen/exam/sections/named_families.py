"""Which families a problem of an exam is drawn from: one, several, or composed ones."""

from __future__ import annotations

import re
from collections.abc import Callable, Mapping, Sequence
from contextvars import ContextVar
from pathlib import Path

from variantgen.families.reading.files import is_file_of_family
from variantgen.tables import Table

# Who is told what is being composed, which takes its time; usually nobody.
composing: ContextVar[Callable[[str], object]] = ContextVar("composing", default=str)
_WAYS = ("family", "families", "compose")


def read_names(table: Table, folders: Sequence[Path], composed: bool = True) -> tuple[str, ...]:
    """The names or paths of the families of a problem; mistakes are noted in the table.

    Not ``composed``: a pool that is not there yet is not made, and has no names.
    """
    table.expect(*_WAYS)
    given = [key for key in _WAYS if key in table.data]
    if len(given) > 1:
        table.problem(f"both {given[0]} and {given[1]} are given", given[1], remedy="keep one of them")
        return ()
    if given == ["compose"]:
        from variantgen.exam.composed_pools import read_composed  # figures and methods, which no other exam needs here

        return read_composed(table.table("compose"), folders, composed, composing.get())
    names = table.strings("families") if given == ["families"] else (table.take("family", str, ""),)
    if not given or not names:
        table.problem("missing, expected the name of a family", "family")
    return names


def read_recorded(table: Table) -> dict[str, Mapping[str, str]]:
    """The files of composed families in a manifest; their names lead to no other folder."""
    found: dict[str, Mapping[str, str]] = {}
    for name in table.data:
        files = table.table(name)
        found[name] = {file: files.take(file, str, "") for file in files.data}
        if not re.fullmatch(r"\w+", name) or not all(map(is_file_of_family, files.data)):
            table.problem("expected the name of a family with its files", name, ", ".join(files.data))
    return found
