"""Letters at their places in a line, as ``common.typ`` sets them: fragments, one after the other.

A fragment is a string (letters of full size on the line), a number (a space, em), letters that are raised or smaller,
a sign that grows or a bar, which take no room, or the markup of a formula that is left to the engine. The fewer there
are, the less the engine has to do: letters of one style are one fragment, also across spaces that the font has. Two
thirds of those of a document come again in it: each is made once, and named by its number.
"""

from __future__ import annotations

from collections.abc import Iterable, Sequence
from functools import cache, lru_cache
from typing import Any, cast

from variantgen.figure.letters.glyphs import STRETCHED, glyph, glyph_names
from variantgen.figure.letters.letter_run import SCALE, Letters, PlacedLetters, follows
from variantgen.figure.letters.lettering import Lettering

_DIGITS = 4
# Spaces of the font of formulas: widths in em, which the font has in thousandths.
_SPACES = {0.1667: "\N{SIX-PER-EM SPACE}", 0.2222: "\N{MEDIUM MATHEMATICAL SPACE}", 0.25: "\N{FOUR-PER-EM SPACE}"}
# Letters as the alphabet of formulas has them.
_ITALIC = {
    ord(first) + n: chr(italic + n)
    for first, italic in (("A", 0x1D434), ("a", 0x1D44E), ("α", 0x1D6FC))
    for n in range(26)
} | {ord("h"): "\N{PLANCK CONSTANT}"}
FULL = (0.0, 1.0, 0)  # letters of full size on the line

# How far up (em), size, the level that letters are cut for.
Style = tuple[float, float, int]
Text = tuple[float, float, int, str]
# How far up, name of a sign or width of a bar.
Mark = tuple[float, str | float]
# How far right of the start of a line, how far up, name of a sign or width of a bar.
PlacedMark = tuple[float, float, str | float]
Fragment = str | float | Text | Mark | tuple[str]


class LetterLine:
    """Fragments in the order in which they are set."""

    def __init__(self) -> None:
        self._found: list[Fragment] = []
        self._gap = 0.0
        self._style: Style | None = None  # of the letters at the end

    def space(self, width: float) -> None:
        """Go on farther right, or farther left."""
        self._gap += width

    def letters(self, style: Style, text: str) -> None:
        """Set letters."""
        gap = self._take_gap()
        between = _between(gap, style) if style == self._style else None
        if between is not None:
            text = _text(self._found.pop()) + between + text
        elif gap:
            self._found.append(gap)
        self._found.append(text if style == FULL else (*style, text))
        self._style = style

    def put(self, mark: Mark | tuple[str]) -> None:
        """Set a sign or a bar, or the markup of a formula."""
        if gap := self._take_gap():
            self._found.append(gap)
        self._found.append(mark)
        self._style = None

    def extend(self, fragments: Sequence[Fragment], up: float = 0.0) -> None:
        """Set fragments, raised by some height."""
        for number, fragment in enumerate(fragments, start=1):
            if isinstance(fragment, str):
                self.letters((up, 1.0, 0), fragment)
            elif isinstance(fragment, float):
                self.space(fragment)
                continue
            elif len(fragment) == 4:
                self.letters((rounded(fragment[0] + up), fragment[1], fragment[2]), fragment[3])
            elif len(fragment) == 2:
                self.put((rounded(fragment[0] + up), fragment[1]))
            else:
                self.put(fragment)
            if not up and number < len(fragments):  # the others follow each other as they are
                self._found += fragments[number:]
                self._style = _style(fragments[-1])
                break

    def found(self) -> tuple[Fragment, ...]:
        """The fragments; spaces at the end are left out."""
        return tuple(self._found)

    def _take_gap(self) -> float:
        gap, self._gap = self._gap, 0.0
        return rounded(gap) if gap else gap


class FragmentTable:
    """The fragments of a document, each of which the engine makes once: lines have their numbers."""

    def __init__(self) -> None:
        self._numbers: dict[Fragment, int] = {}

    def numbers(self, line: Iterable[Fragment]) -> list[int]:
        """The numbers of the fragments of a line."""
        known = self._numbers
        return [known.setdefault(fragment, len(known)) for fragment in line]

    def lines(self) -> list[tuple[Fragment]]:
        """The fragments in the order of their numbers, each as a line of its own."""
        return [(fragment,) for fragment in self._numbers]


def _between(gap: float, style: Style) -> str | None:
    """What stands for a space between letters of one style, if they can be one fragment."""
    if not gap:
        return ""
    return _SPACES.get(gap) if style[1:] == FULL[1:] else None


def _text(fragment: Fragment) -> str:
    return fragment if isinstance(fragment, str) else cast(Text, fragment)[3]


def _style(fragment: Fragment) -> Style | None:
    if isinstance(fragment, str):
        return FULL
    return fragment[:3] if isinstance(fragment, tuple) and len(fragment) == 4 else None


def fragments_of(lettering: Lettering, marks: list[PlacedMark] | None = None) -> tuple[tuple[Fragment, ...], float]:
    """The letters and bars of a formula, and where the last of them ends.

    Letters after each other are one fragment, which the engine spaces itself. Signs that grow and bars become
    ``marks``, if those are wanted apart.
    """
    line = LetterLine()
    end = 0.0
    for word in _words(lettering.letters):
        (first, start), (last, at) = word[0], word[-1]
        stretched = first.glyphs[0].name[1] == STRETCHED
        if stretched and marks is not None:
            marks.append((start.real, start.imag, first.glyphs[0].name))
            continue
        line.space(start.real - end)
        if stretched:
            line.put((rounded(start.imag), first.glyphs[0].name))
            end = start.real
        else:
            size, level, text = _written(first)
            text += "".join([_written(more)[2] for more, _ in word[1:]])
            line.letters((rounded(start.imag), size, level), text)
            end = at.real + last.end
    for bar in lettering.bars:
        if marks is not None:
            marks.append((bar.at.real, bar.at.imag, bar.width))
            continue
        line.space(bar.at.real - end)
        line.put((rounded(bar.at.imag), rounded(bar.width)))
        end = bar.at.real
    return line.found(), end


def _words(row: Sequence[PlacedLetters]) -> list[list[PlacedLetters]]:
    """Letters that follow each other, together."""
    found: list[list[PlacedLetters]] = []
    for placed in row:
        if found and _goes_on(found[-1][-1], placed):
            found[-1].append(placed)
        else:
            found.append([placed])
    return found


def _goes_on(before: PlacedLetters, after: PlacedLetters) -> bool:
    (one, here), (other, there) = before, after
    return follows(one.glyphs[-1], other.glyphs[0], there - here - one.places[-1])


@lru_cache(maxsize=10_000)
def _written(letters: Letters) -> tuple[float, int, str]:
    """Their size, the level that they are cut for, and the letters as the font has them."""
    first = letters.glyphs[0]
    text = "".join([glyph.name[2:] for glyph in letters.glyphs])
    if first.name[1] == "u":
        return first.scale, 0, text
    level = int(first.name[0])
    return SCALE[level], level, italic(text)


def rounded(length: float) -> float:
    """A length as templates get it."""
    return round(length, _DIGITS)


def italic(letters: str) -> str:
    """Letters as the alphabet of formulas has them."""
    return letters.translate(_ITALIC)


@cache
def signs() -> dict[str, list[list[Any]]]:
    """The signs that grow by their names: steps of the outline, kind and places (em), y down."""
    return {
        name: [
            [kind, *([rounded(point.real), rounded(-point.imag)] for point in points)]
            for kind, points in glyph(name).steps
        ]
        for name in glyph_names(STRETCHED)
    }
