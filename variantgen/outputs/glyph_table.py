"""Makes the table of glyphs from the fonts of the typesetting engine: ``python -m variantgen.outputs.glyph_table``.

The engine sets each letter at each size (formula, index, index of an index) with a script beside it; from its SVG come
the outlines, from where it puts the scripts the widths. The table is committed; a test compares it with the engine.
The fonts are New Computer Modern Math and New Computer Modern (GUST Font License).
"""

from __future__ import annotations

import json
import re
import sys
from collections.abc import Sequence

import numpy as np

from variantgen.figure.glyphs import TABLE, outline
from variantgen.outputs.typesetter import Typesetter, typesetter
from variantgen.wording.formula import GREEK

_LETTERS = "ABCDEFGHIJKLMNOPQRSTUVWXYZabcdefghijklmnopqrstuvwxyz"
_CYRILLIC = "АБВГДЕЖЗИЙКЛМНОПРСТУФХЦЧШЩЪЫЬЭЮЯЁабвгдежзийклмнопрстуфхцчшщъыьэюяё"
_MARKS = "0123456789.,+−/°'()=:;·× "
_SIZE = 100  # pt
_SIZES = ("{}", "script({})", "sscript({})")
_PLACE = re.compile(r'<g transform="matrix\(1 0 0 -1 (-?[\d.]+) (-?[\d.]+)\)"><use xlink:href="#(\w+)"')
_SYMBOL = re.compile(r'<symbol id="(\w+)"[^>]*><path d="([^"]*)"')
_TOKEN = re.compile(r"[A-Za-z]|-?[\d.]+")
_COUNT = {"m": 2, "l": 2, "h": 1, "v": 1, "c": 6}  # numbers per step
_HEAD = """#import "common.typ": document-style
#set page(width: 600pt, height: 300pt, margin: 0pt)
#show: document-style.with("ru")
#set text(size: 100pt)
#let put(body) = { place(top + left, dx: 100pt, dy: 100pt, body); pagebreak(weak: true) }
"""


def wanted() -> list[tuple[str, str, str]]:
    """Name in the table, Typst markup and kind of every letter."""
    italic = [(letter, letter) for letter in _LETTERS] + [(sign, name) for name, sign in GREEK.items()]
    upright = [(letter, f'"{letter}"') for letter in _LETTERS + _CYRILLIC + _MARKS.replace(" ", "")]
    digits = [(digit, digit) for digit in "0123456789"]
    found = [(f"i{letter}", markup, "all") for letter, markup in italic]
    found += [(f"i{digit}", markup, "all") for digit, markup in digits]
    return found + [(f"u{letter}", markup, "two") for letter, markup in upright]


def measure(engine: Typesetter, letters: Sequence[str]) -> list[list[object]]:
    """Width, place of an index, bounds and outline of each letter (1/1000 of the size of the lettering)."""
    body = "".join(f"#put(${x}$)\n#put(${x}_(1)$)\n#put(${x}^(1)$)\n" for x in letters)
    (engine.root / "glyphs.typ").write_text(_HEAD + body, "utf-8")
    pages = [page.decode() for page in engine.compile("glyphs.typ", {}, "svg")]
    found: list[list[object]] = []
    for alone, with_index, with_power in zip(pages[0::3], pages[1::3], pages[2::3], strict=True):
        glyph = _PLACE.search(alone)
        assert glyph is not None
        path = _scaled(dict(_SYMBOL.findall(alone))[glyph[3]])
        index, power = (float(_PLACE.findall(page)[1][0]) - 100 for page in (with_index, with_power))
        low, high = (round(1000 * height) for height in _bounds(path))
        found.append([_thousandths(power), _thousandths(index), low, high, path])
    return found


def _bounds(path: str) -> tuple[float, float]:
    """Lowest and highest point of an outline (em), at the true extremes of its curves."""
    heights: list[float] = [0.0] if not path else []
    here = 0.0
    for command, points in outline(path):
        y = [here, *(p.imag for p in points)]
        heights += y[1:] if command != "C" else [y[3]]
        if command == "C":
            a, b, c = y[3] - 3 * y[2] + 3 * y[1] - y[0], 2 * (y[2] - 2 * y[1] + y[0]), y[1] - y[0]
            for t in np.roots([a, b, c] if abs(a) > 1e-12 else [b, c]) if abs(a) + abs(b) > 1e-12 else []:
                if abs(t.imag) < 1e-9 and 0 < t.real < 1:
                    s = float(t.real)
                    heights.append(
                        (1 - s) ** 3 * y[0] + 3 * (1 - s) ** 2 * s * y[1] + 3 * (1 - s) * s**2 * y[2] + s**3 * y[3]
                    )
        if points:
            here = y[-1]
    return min(heights), max(heights)


def _thousandths(value: float) -> int:
    return round(10 * value)


def _scaled(path: str) -> str:
    """A path in whole thousandths, relative; absolute places are rounded, so that nothing drifts."""
    found: list[str] = []
    pen = start = 0j  # where the engine's path is, and its last beginning
    at = begun = (0, 0)  # the same, rounded
    tokens, i, command = _TOKEN.findall(path), 0, ""
    while i < len(tokens):
        if tokens[i].isalpha():
            command, i = tokens[i], i + 1
            if command in "Zz":
                found.append("z")
                pen, at = start, begun
                continue
        count = _COUNT[command.lower()]
        values, i = [float(token) for token in tokens[i : i + count]], i + count
        points = _points(command, values, pen)
        pen = points[-1]
        rounded = [(_thousandths(z.real), _thousandths(z.imag)) for z in points]
        kind = {"h": "l", "v": "l"}.get(command.lower(), command.lower())
        if kind == "m" and found and found[-1].startswith("m"):
            at = _before(at, found.pop())
        found.append(kind + " ".join(f"{x - at[0]} {y - at[1]}" for x, y in rounded).replace(" -", "-"))
        at = rounded[-1]
        if kind == "m":
            start, begun = pen, at
            command = "l" if command == "m" else "L"
    return "".join(found)


def _before(at: tuple[int, int], step: str) -> tuple[int, int]:
    """Where the pen was before a step that is dropped."""
    x, y = (int(number) for number in re.findall(r"-?\d+", step))
    return at[0] - x, at[1] - y


def _points(command: str, values: Sequence[float], pen: complex) -> list[complex]:
    """The places that one step of a path names."""
    origin = pen if command.islower() else 0j
    if command in "hH":
        return [complex(origin.real + values[0], pen.imag)]
    if command in "vV":
        return [complex(pen.real, origin.imag + values[0])]
    return [origin + complex(x, y) for x, y in zip(values[0::2], values[1::2], strict=True)]


def table() -> dict[str, list[object]]:
    """Every glyph, measured anew."""
    found: dict[str, list[object]] = {}
    with typesetter() as engine:
        for level, size in enumerate(_SIZES):
            letters = [(name, size.format(x)) for name, x, kind in wanted() if level < 2 or kind == "all"]
            for (name, _), data in zip(letters, measure(engine, [x for _, x in letters]), strict=True):
                found[f"{level}{name}"] = data
    return found


def main() -> int:
    """Write the table."""
    glyphs = table()
    rows = [
        f"{json.dumps(name, ensure_ascii=False)}:{json.dumps(row, separators=(',', ':'))}"
        for name, row in glyphs.items()
    ]
    TABLE.write_text("{\n" + ",\n".join(rows) + "\n}\n", "utf-8")
    print(f"{len(glyphs)} glyphs, {TABLE.stat().st_size} bytes", file=sys.stderr)
    return 0


if __name__ == "__main__":
    sys.exit(main())
