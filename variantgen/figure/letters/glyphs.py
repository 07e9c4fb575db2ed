"""The letters of figures: widths, bounds and outlines of the glyphs that the typesetting engine uses.

The table (``glyphs.json``) is made by :mod:`variantgen.outputs.typst.glyph_table` from New Computer Modern Math and New
Computer Modern (GUST Font License). Lengths are in thousandths of the size of the lettering, y up. Formula letters of
an index are cut for their size and stand in the table at that size; words of an index are the upright letters, smaller.
"""

from __future__ import annotations

import json
import re
from functools import cache
from pathlib import Path
from typing import Any

from msgspec import Struct

TABLE = Path(__file__).with_name("glyphs.json")
STRETCHED = "s"  # kind of a sign in one of its sizes
KERNING = "kerning"  # key of the pairs of letters, by how much they are moved apart
_UNIT = 1e-3
_STEP = re.compile(r"([mlcz])([^mlcz]*)")
_NUMBER = re.compile(r"-?\d+")


class Glyph(Struct, frozen=True):
    """One letter (em): ``width`` with its slant, ``index_at`` where an index begins, ``path`` in SVG terms.

    In a word the next letter begins at ``advance``.

    ``bottom`` and ``top`` bound the ink above the baseline. The path is to be drawn ``scale`` times its size; all else
    is at its true size.
    """

    name: str
    width: float
    index_at: float
    advance: float
    bottom: float
    top: float
    path: str
    scale: float = 1.0

    @property
    def steps(self) -> list[tuple[str, tuple[complex, ...]]]:
        """The outline as steps M, L, C, Z with their points (em)."""
        return [(kind, tuple(self.scale * point for point in points)) for kind, points in outline(self.path)]


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
def _rows() -> dict[str, str]:
    """The lines of the table by their keys; read as JSON one by one, as they are asked for."""
    lines = TABLE.read_text("utf-8").splitlines()[1:-1]
    return dict(line.removeprefix('"').split('":', 1) for line in lines)


def _row(key: str) -> Any:
    return json.loads(_rows()[key].removesuffix(","))


def has_glyph(name: str) -> bool:
    """Whether the table has a glyph."""
    return name in _rows()


def glyph_names(kind: str) -> list[str]:
    """All glyphs of a kind."""
    return [name for name in _rows() if name[1] == kind]


@cache
def glyph(name: str, scale: float = 1.0) -> Glyph:
    """A glyph by name: level (0, 1, 2), ``i`` (of a formula) or ``u`` (of a word), the letter. KeyError if missing.

    Signs that grow with what they stand beside have the number of their size and ``s``.
    """
    *lengths, path = _row(name)
    width, index_at, advance, bottom, top = (scale * _UNIT * float(x) for x in lengths)
    return Glyph(name, width, index_at, advance, bottom, top, str(path), scale)


@cache
def _kerning() -> dict[str, float]:
    pairs: dict[str, str] = _row(KERNING)
    return {pair: _UNIT * int(gap) for gap, all_pairs in pairs.items() for pair in all_pairs.split()}


def kerning(before: str, after: str) -> float:
    """What the distance of two letters of a word differs by (em, for letters of full size)."""
    return _kerning().get(before + after, 0.0)
