"""Makes the table of glyphs from the fonts of the engine: ``python -m variantgen.outputs.typst.glyph_table``.

The engine sets each letter at the sizes it occurs in (formula, index, index of an index) with a script beside it; from
its SVG come the outlines, from where it puts the scripts the widths, from letters in a line of text where the next one
begins. Letters of words have no size of their own; their widths and kerning come from what stands beside them. The
table is committed; a test compares it with the engine.
The fonts are New Computer Modern Math and New Computer Modern (GUST Font License).
"""

from __future__ import annotations

import json
import re
import sys
from collections.abc import Sequence
from typing import Any

import numpy as np

from variantgen.figure.letters.glyphs import KERNING, STRETCHED, TABLE, outline
from variantgen.figure.letters.tall_letters import ROOT
from variantgen.outputs.typst.fragments import italic
from variantgen.outputs.typst.typesetter import Typesetter, typesetter
from variantgen.wording.formula import GREEK

_LETTERS = "ABCDEFGHIJKLMNOPQRSTUVWXYZabcdefghijklmnopqrstuvwxyz"
_CYRILLIC = "АБВГДЕЖЗИЙКЛМНОПРСТУФХЦЧШЩЪЫЬЭЮЯЁабвгдежзийклмнопрстуфхцчшщъыьэюяё"
_DIGITS = "0123456789"
_MARKS = _DIGITS + ".,+−/°'()=:;·⋅×-"  # as in words
_SIGNS = {".": ".", ",": ",", "|": "bar.v", "(": "paren.l", ")": "paren.r", "∠": "angle"}  # as in formulas
_LINES = {"∥": 'class("normal", parallel)', "⟂": 'class("normal", perp)'}  # along and across a line, in an index too
_SIZES = ("{}", "script({})", "sscript({})")
_START = 100.0  # where letters begin on a page, pt
_GROUP = re.compile(r'<g transform="matrix\(1 0 0 -1 (-?[\d.]+) -?[\d.]+\)">(.*?)</g>')
_USE = re.compile(r'<use xlink:href="#(\w+)" x="([^"]*)"')
_BAR = re.compile(r'stroke-width="[\d.]+"[^>]* transform="translate\((-?[\d.]+) ')  # of a root
_SYMBOL = re.compile(r'<symbol id="(\w+)"[^>]*><path d="([^"]*)"')
_TOKEN = re.compile(r"[A-Za-z]|-?[\d.]+")
_COUNT = {"m": 2, "l": 2, "h": 1, "v": 1, "c": 6}  # numbers per step
_HEAD = """#import "common.typ": document-style
#set page(width: 600pt, height: 300pt, margin: 0pt)
#show: document-style.with("ru")
#set text(size: 100pt)
#let put(body) = { place(top + left, dx: 100pt, dy: 100pt, body); pagebreak(weak: true) }
"""
_KERNING = """
#let width(text) = measure(math.equation(text)).width / 1pt
#context {
  let letters = sys.inputs.data.clusters()
  let alone = letters.map(width)
  let pairs = ()
  for (i, a) in letters.enumerate() {
    for (j, b) in letters.enumerate() { pairs.push((a + b, width(a + b) - alone.at(i) - alone.at(j))) }
  }
  [#metadata(pairs) <found>]
}
"""
_ADVANCES = """#import "common.typ": math-style, set-lines
#context {
  let (letters, level) = json(bytes(sys.inputs.data))
  let size = (1, 0.7, 0.5).at(level)
  let lines = set-lines(letters.codepoints().map(letter => ((0, size, level, letter),)))
  [#metadata(lines.map(line => measure(text(..math-style, line)).width / 1pt)) <found>]
}
"""


def wanted(level: int) -> list[tuple[str, str]]:
    """Name and Typst markup of every letter of formulas that occurs at a level."""
    letters = {letter: letter for letter in _LETTERS} | {sign: name for name, sign in GREEK.items()}
    digits = {digit: digit for digit in _DIGITS}
    found = {
        0: letters | digits | _SIGNS | _LINES,
        1: letters | digits | {".": ".", "/": r"\/"} | _LINES,
        2: digits | {"′": "prime"},
    }[level]
    return [(f"{level}i{letter}", _SIZES[level].format(markup)) for letter, markup in found.items()]


def measure(engine: Typesetter, letters: Sequence[str]) -> list[list[object]]:
    """Width, place of an index, bounds and outline of each letter of formulas (1/1000 of the size of the lettering)."""
    body = "".join(f"#put(${x}$)\n#put(${x}_(1)$)\n#put(${x}^(1)$)\n" for x in letters)
    pages = _pages(engine, body)
    found: list[list[object]] = []
    for alone, with_index, with_power in zip(pages[0::3], pages[1::3], pages[2::3], strict=True):
        index, power = (_thousandths(_places(page)[1][1]) for page in (with_index, with_power))
        found.append([power, index, *_shape(alone)])
    return found


def stretched(engine: Typesetter, opening: str, closing: str) -> list[tuple[list[object], list[object]]]:
    """The sizes of two signs around something that grows, the smallest first, but for those put together from parts.

    The sign of a root is its own other side.
    """
    around = "sqrt({})" if opening == ROOT else f"lr({opening}{{}}{closing})"
    room = f"#box(width: {_START}pt, height: {{:.2f}}em, baseline: 50% - 0.25em)"
    pages = _pages(engine, "".join(f"#put(${around.format(room.format(0.05 * n))}$)\n" for n in range(1, 80)))
    found: dict[str, tuple[list[object], list[object]]] = {}
    for page in pages:
        (first, _), *others = _places(page)
        if len(others) > 1 or (opening == ROOT and others):
            break
        last, end = others[0] if others else (first, float(_BAR.findall(page)[0]) - _START)
        width = _thousandths(end - (_START if others else 0.0))
        lengths: list[object] = [width, width, width]
        found[first] = ([*lengths, *_shape(page, first)], [*lengths, *_shape(page, last)])
    return list(found.values())


def advances(engine: Typesetter, letters: str, level: int) -> list[int]:
    """Where the next letter begins in a line of text, as ``common.typ`` sets letters of a level."""
    found: list[float] = _asked(engine, _ADVANCES, json.dumps([letters, level]))
    return [_thousandths(width) for width in found]


def measure_upright(engine: Typesetter, letters: str) -> list[list[object]]:
    """The same of letters of words: each stands between two signs, which show its width without its slant."""
    pages = _pages(engine, "".join(f'#put($"={x}="$)\n' for x in letters))
    found: list[list[object]] = []
    for page in pages:
        places = sorted(_places(page), key=lambda place: place[1])
        width = _thousandths(places[2][1] - places[1][1])
        found.append([width, width, width, *_shape(page, places[1][0])])
    return found


def kerning(engine: Typesetter) -> dict[str, str]:
    """Pairs of letters of words by the thousandths of the size of the lettering that they are moved apart.

    Only the Cyrillic letters, which come from the text font, are kerned in formulas.
    """
    found: dict[int, list[str]] = {}
    for pair, gap in _asked(engine, _KERNING, _CYRILLIC):
        found.setdefault(_thousandths(gap), []).append(pair)
    return {str(gap): " ".join(pairs) for gap, pairs in sorted(found.items()) if gap}


def _asked(engine: Typesetter, template: str, data: str) -> Any:
    """What a template notes under ``found``."""
    import typst

    source = engine.root / "asked.typ"
    source.write_text(_HEAD + template, "utf-8")
    answer = typst.query(
        str(source), "<found>", field="value", one=True, root=str(engine.root), ignore_system_fonts=True,
        sys_inputs={"data": data},
    )  # fmt: skip
    return json.loads(answer)


def _pages(engine: Typesetter, body: str) -> list[str]:
    (engine.root / "glyphs.typ").write_text(_HEAD + body, "utf-8")
    return [page.decode() for page in engine.compile("glyphs.typ", {}, "svg")]


def _places(page: str) -> list[tuple[str, float]]:
    """Name and place (pt, from where the letters begin) of every glyph of a page of the engine."""
    return [
        (name, float(left) + float(right) - _START)
        for left, inner in _GROUP.findall(page.split("<defs", maxsplit=1)[0])
        for name, right in _USE.findall(inner)
    ]


def _shape(page: str, name: str = "") -> list[object]:
    """Bounds and outline of a glyph of a page: that of a name, or the first."""
    path = _scaled(dict(_SYMBOL.findall(page))[name or _places(page)[0][0]])
    return [*(round(1000 * height) for height in _bounds(path)), path]


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


def table() -> dict[str, object]:
    """Every glyph, measured anew."""
    found: dict[str, object] = {}
    with typesetter() as engine:
        for level in range(len(_SIZES)):
            letters = wanted(level)
            measured = measure(engine, [x for _, x in letters])
            steps = advances(engine, "".join(italic(name[2:]) for name, _ in letters), level)
            for (name, _), (width, index_at, *rest), step in zip(letters, measured, steps, strict=True):
                found[name] = [width, index_at, step, *rest]
        upright = _LETTERS + _CYRILLIC + _MARKS
        found.update(zip((f"0u{letter}" for letter in upright), measure_upright(engine, upright), strict=True))
        for signs in (ROOT + ROOT, "()", "||"):
            sizes = stretched(engine, *signs)
            for letter, rows in zip(signs, zip(*sizes, strict=True), strict=True):
                # Parentheses of the height of a line are letters.
                found.update((f"{n}{STRETCHED}{letter}", row) for n, row in enumerate(rows) if n or letter == ROOT)
        found[KERNING] = kerning(engine)
    return found


def main() -> int:
    """Write the table."""
    glyphs = table()
    rows = [
        f"{json.dumps(name, ensure_ascii=False)}:{json.dumps(row, ensure_ascii=False, separators=(',', ':'))}"
        for name, row in glyphs.items()
    ]
    TABLE.write_text("{\n" + ",\n".join(rows) + "\n}\n", "utf-8")
    print(f"{len(glyphs)} glyphs, {TABLE.stat().st_size} bytes", file=sys.stderr)
    return 0


if __name__ == "__main__":
    sys.exit(main())
