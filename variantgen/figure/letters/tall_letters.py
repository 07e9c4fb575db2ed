"""Fractions of full size, roots and tall parentheses, as the typesetting engine sets them in a line of their own.

The rules are those of the OpenType math table (TeX's rules 11, 15 and 19) with the constants of New Computer Modern
Math. Signs are drawn in the sizes that the font has; what is taller than the largest raises TypeError, because the font
builds it from parts. Lengths in em.
"""

from __future__ import annotations

from functools import cache

from variantgen.figure.letters.glyphs import STRETCHED, Glyph, glyph, has_glyph
from variantgen.figure.letters.letter_run import THICKNESS, Bar, Run

AXIS = 0.25
_NUMERATOR_UP, _DENOMINATOR_DOWN, _FRACTION_GAP, _FRACTION_AROUND = 0.677, 0.686, 0.12, 0.1
_ROOT_GAP, _ROOT_GAP_IN_FRACTION, _ROOT_ABOVE = 0.148, 0.05, 0.04
_SHORT = 0.1  # parentheses may be so much lower than what they enclose
ROOT = "\N{SQUARE ROOT}"


def fraction(above: Run, below: Run) -> Run:
    """Numerator and denominator, the narrower one centred, and the bar between them on the axis."""
    made = Run(display=True)
    line = max(above.x, below.x)
    up = max(_NUMERATOR_UP, AXIS + THICKNESS / 2 + _FRACTION_GAP - above.bottom)
    down = max(_DENOMINATOR_DOWN, below.top + _FRACTION_GAP - AXIS + THICKNESS / 2)
    made.put(above, complex(_FRACTION_AROUND + (line - above.x) / 2, up))
    made.put(below, complex(_FRACTION_AROUND + (line - below.x) / 2, -down))
    made.bars.append(Bar(complex(_FRACTION_AROUND, AXIS), line))
    made.x = line + 2 * _FRACTION_AROUND
    return made


def root(radicand: Run) -> Run:
    """The sign, as large as it has to be, and a bar over the radicand."""
    made = Run(display=True)
    height = radicand.top - radicand.bottom
    least = _ROOT_GAP if radicand.display else _ROOT_GAP_IN_FRACTION
    sign = _sign(ROOT, height + THICKNESS + least)
    gap = max(least, (sign.top - sign.bottom - THICKNESS - height + least) / 2)
    top = radicand.top + gap + THICKNESS
    made.sign(sign, up=top - sign.top)
    made.bars.append(Bar(complex(sign.width, top - THICKNESS / 2), radicand.x))
    made.put(radicand, complex(sign.width, 0.0))
    made.take_room(top + _ROOT_ABOVE)
    made.x = sign.width + radicand.x
    return made


def enclosed(content: Run, opening: str, closing: str) -> Run:
    """Content between parentheses or bars that are as tall as it needs."""
    made = Run(display=True)
    height = 2 * max(content.top - AXIS, AXIS - content.bottom)
    for part in (opening, None, closing):
        if part is None:
            made.append(content)
            continue
        sign = _sign(part, height - _SHORT)
        made.sign(sign)
        made.x += sign.width
    return made


def _sign(letter: str, height: float) -> Glyph:
    """The smallest sign of at least some height. Raises TypeError where the font has none."""
    for sign in _signs(letter):
        if sign.top - sign.bottom >= height:
            return sign
    raise TypeError(f"no {letter} is {height:.2f} em high")


@cache
def _signs(letter: str) -> list[Glyph]:
    """A sign in its sizes; parentheses of the height of a line are letters."""
    names = [f"0i{letter}"] if has_glyph(f"0i{letter}") else []
    number = len(names)
    while has_glyph(name := f"{number}{STRETCHED}{letter}"):
        names.append(name)
        number += 1
    return [glyph(name) for name in names]
