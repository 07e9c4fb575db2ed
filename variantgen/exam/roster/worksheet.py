"""A table of a class list as it stands in its file."""

from __future__ import annotations

from collections.abc import Sequence

from msgspec import Struct

Row = tuple[int, Sequence[str]]  # its number in the file, its cells


class Worksheet(Struct, frozen=True):
    """A table with the rows that are not empty; ``title`` is that of a worksheet.

    ``computed`` are the cells with formulas, by the number of the row and the place in it, where these were asked for.
    """

    rows: tuple[Row, ...]
    title: str = ""
    computed: frozenset[tuple[int, int]] = frozenset()
