"""Rows of formulas as source text: in one piece, whose height is measured, or line by line at their places.

In a line everything that is no letter is a box, which is as much work for the engine as a paragraph. In rows of which
all is known (:meth:`variantgen.outputs.typst.formula_lines.Row.known_height`) bars and signs have places of their own.
"""

from __future__ import annotations

from collections.abc import Iterable, Iterator

from variantgen.outputs.typst.formula_lines import CAPITALS, LEADING, Line, Row
from variantgen.outputs.typst.fragments import PlacedMark
from variantgen.outputs.typst.source import TypstSource, length, string


def placed_lines(source: TypstSource, row: Row) -> Iterator[tuple[str, str, float, float]]:
    """The lines of a row that is known: how it is set, what it is, how far it is from the left and from the top (em).

    These are the letters of a line, its bars and each of its signs that grow.
    """
    y = 0.0
    for line in row.lines:
        scale, baseline = round(line.scale, 3), y + line.baseline
        letters, marks = line.apart()
        yield "line", _sized(scale, source.line(letters)), line.indent, baseline - scale * CAPITALS
        if bars := [mark for mark in marks if not isinstance(mark[2], str)]:
            yield "mark", _sized(scale, _bars(bars)), line.indent, baseline
        for right, up, what in marks:
            if isinstance(what, str):
                sign = source.name(_sized(scale, f"sign({string(what)})"))
                yield "mark", sign, line.indent + scale * right, baseline - scale * up
        y += line.high + LEADING


def row_source(source: TypstSource, row: Row) -> str:
    """A row of formulas in its lines, whose height is measured."""
    return f"row({{{';linebreak();'.join([_line_source(source, line) for line in row.lines])}}})"


def _line_source(source: TypstSource, line: Line) -> str:
    scale = round(line.scale, 3)
    parts = [source.name(f"h({line.indent!r}*em)")]
    if line.top > 0:  # what is taller than a line has the room of its ink
        high, down = length((line.top - line.bottom) * scale), length(-line.bottom * scale)
        parts.append(source.name(f"box(width:0em,height:{high},baseline:{down})"))
    made = source.line(line.fragments(source.letters))
    parts.append(made if scale == 1 else f"text(size:{length(scale)},{{{made}}})")
    return ";".join(parts)


def _sized(scale: float, content: str) -> str:
    """Content with letters and lengths in some proportion."""
    return f"{{{content}}}" if scale == 1 else f"text(size:{length(scale)},{{{content}}})"


def _bars(bars: Iterable[PlacedMark]) -> str:
    steps = [
        f"curve.move(({length(right)},{length(-up)})),curve.line(({length(right + wide)},{length(-up)}))"
        for right, up, wide in bars
        if not isinstance(wide, str)
    ]
    return f"curve(stroke:bar,{','.join(steps)})"
