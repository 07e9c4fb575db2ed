"""Tables for the terminal: columns of equal width."""

from __future__ import annotations

from collections.abc import Iterator, Sequence

_GAP = "  "


def in_columns(rows: Sequence[Sequence[str]], numbers: bool = False) -> Iterator[str]:
    """The rows as lines; all columns but the first end at the same place if they hold ``numbers``."""
    widths = [max(len(row[k]) for row in rows if k < len(row)) for k in range(max(map(len, rows), default=0))]
    for row in rows:
        cells = [
            cell.rjust(width) if numbers and k else cell.ljust(width)
            for k, (cell, width) in enumerate(zip(row, widths, strict=False))
        ]
        yield _GAP.join(cells).rstrip()
