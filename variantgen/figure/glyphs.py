"""The letters of figures: widths, bounds and outlines of the glyphs that the typesetting engine uses.

The table (``glyphs.json``) is made by :mod:`variantgen.outputs.glyph_table` from New Computer Modern Math and New
Computer Modern (GUST Font License). Lengths are in thousandths of the size of the lettering, y up; a glyph of an index
has its true (smaller) size.
"""

from __future__ import annotations

import json
import re
from dataclasses import dataclass
from functools import cache
from pathlib import Path

TABLE = Path(__file__).with_name("glyphs.json")
_UNIT = 1e-3
_STEP = re.compile(r"([mlcz])([^mlcz]*)")
_NUMBER = re.compile(r"-?\d+")


@dataclass(frozen=True)
class Glyph:
    """One letter at one size (em): ``width`` with its slant, ``index_at`` where an index begins, ``path`` in SVG terms.

    ``bottom`` and ``top`` bound the ink above the baseline.
    """

    name: str
    width: float
    index_at: float
    bottom: float
    top: float
    path: str

    @property
    def steps(self) -> list[tuple[str, tuple[complex, ...]]]:
        """The outline as steps M, L, C, Z with their points (em)."""
        return outline(self.path)


def outline(path: str) -> list[tuple[str, tuple[complex, ...]]]:
    """A path of the table as absolute steps (em)."""
    found: list[tuple[str, tuple[complex, ...]]] = []
    pen = start = 0j
    for command, text in _STEP.findall(path):
        values = [_UNIT * int(number) for number in _NUMBER.findall(text)]
        points = tuple(pen + complex(x, y) for x, y in zip(values[0::2], values[1::2], strict=True))
        found.append((command.upper(), points))
        pen = points[-1] if points else start
        start = pen if command == "m" else start
    return found


@cache
def _table() -> dict[str, list[float | str]]:
    return dict(json.loads(TABLE.read_text("utf-8")))


def has_glyph(name: str) -> bool:
    """Whether the table has a glyph."""
    return name in _table()


@cache
def glyph(name: str) -> Glyph:
    """A glyph by name: level (0, 1, 2), ``i`` or ``u`` for italic or upright, the letter. KeyError if there is none."""
    width, index_at, bottom, top, path = _table()[name]
    found = [_UNIT * float(x) for x in (width, index_at, bottom, top)]
    return Glyph(name, found[0], found[1], found[2], found[3], str(path))
