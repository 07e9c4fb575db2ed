"""Letters of a formula in a row, with what stands below and above them, as the typesetting engine sets them.

The constants are those of the OpenType math table of New Computer Modern Math. Lengths in em.
"""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import dataclass

from variantgen.figure.glyphs import Glyph, glyph, has_glyph, kerning
from variantgen.wording.formula import GREEK, Index, letters

_INDEX_DOWN, _POWER_UP, _POWER_UP_CRAMPED, _LEAST_GAP, _AFTER = 0.247, 0.363, 0.289, 0.16, 0.056
_POWER_DROP = 0.25  # how much lower the baseline of a power is than the top of parentheses
_POWER_BOTTOM = 0.344  # a power over an index is raised alone until its ink is as high
WORD_SPACE = 0.331
INDEX = 0.7  # size of an index in that of its letter
SCALE = (1.0, INDEX, 0.5)  # of the sizes of formula, index, index of an index
_UNKNOWN = "0u°"  # stands for a letter that the table does not have


@dataclass(frozen=True)
class PlacedGlyph:
    """A glyph with the place of its origin (em, baseline of the formula at 0)."""

    glyph: Glyph
    at: complex


@dataclass(frozen=True)
class Bar:
    """A line to the right: of a fraction, or above what stands under a root. ``at`` is the middle of its start (em)."""

    at: complex
    width: float


THICKNESS = 0.048  # of bars


class Run:
    """Letters in a row; ``x`` is where the next one begins.

    ``display`` says that fractions of full size may be among them, ``tall`` that roots and tall parentheses may, as in
    parts of such fractions, ``cramped`` that powers are raised less, as below the bar of a fraction.
    """

    def __init__(self, display: bool = False, cramped: bool = False, tall: bool = False) -> None:
        self.glyphs: list[PlacedGlyph] = []
        self.bars: list[Bar] = []
        self.x = 0.0
        self.index_x = 0.0
        self.display = display
        self.tall = tall or display
        self.cramped = cramped
        self._highest = 0.0

    @property
    def bottom(self) -> float:
        """The lowest ink."""
        return min(
            [p.at.imag + p.glyph.bottom for p in self.glyphs] + [b.at.imag - THICKNESS / 2 for b in self.bars],
            default=0.0,
        )

    @property
    def top(self) -> float:
        """The highest ink, and the room that a root has above it."""
        tops = [p.at.imag + p.glyph.top for p in self.glyphs] + [b.at.imag + THICKNESS / 2 for b in self.bars]
        return max([*tops, self._highest] if self._highest else tops, default=0.0)

    def take_room(self, top: float) -> None:
        """Take room up to a height."""
        self._highest = max(self._highest, top)

    def put(self, other: Run, at: complex) -> None:
        """Set what another run consists of at a place; the row does not grow."""
        self.glyphs += [PlacedGlyph(p.glyph, p.at + at) for p in other.glyphs]
        self.bars += [Bar(b.at + at, b.width) for b in other.bars]
        if other._highest:
            self.take_room(other._highest + at.imag)

    def append(self, other: Run) -> None:
        """Set another run after the letters so far."""
        self.put(other, complex(self.x, 0.0))
        self.x += other.x
        self.index_x = self.x

    def add(self, letter: str, level: int) -> None:
        """Set one letter of a formula (italic, Greek, a digit, a mark) at a level."""
        found = next((n for n in (f"{level}i{letter}", f"0i{letter}") if has_glyph(n)), "")
        self._put(glyph(found) if found else _upright(letter, level))

    def words(self, text: str, level: int = 0) -> None:
        """Set upright text. The engine takes a number of nothing but digits and points for a formula."""
        if all(letter in "0123456789." for letter in text):
            for letter in text:
                self.add(letter, level)
            return
        for before, letter in zip(" " + text, text, strict=False):
            self.x += SCALE[level] * kerning(before, letter)
            if letter == " ":
                self.x += WORD_SPACE * SCALE[level]
            else:
                self._put(_upright(letter, level))

    def _put(self, letter: Glyph) -> None:
        self.glyphs.append(PlacedGlyph(letter, complex(self.x, 0.0)))
        self.index_x = self.x + letter.index_at
        self.x += letter.width

    def mark(self, right: float) -> None:
        """Set the arrow of a vector: a mark to the left of where it begins."""
        self.glyphs.append(
            PlacedGlyph(Glyph("0u\N{COMBINING RIGHT ARROW ABOVE}", 0.0, 0.0, 0.0, 0.5, 0.714, ""), complex(right, 0.0))
        )

    def attach(self, index: Run, power: Run, level: int, top: float = 0.0) -> None:
        """Set what stands below and above to the right of the letters so far; ``top`` is that of parentheses before."""
        scale = SCALE[level]
        raised = _POWER_UP_CRAMPED if level or self.cramped else _POWER_UP
        down = _INDEX_DOWN * scale if index.glyphs else 0.0
        up = max(raised * scale, top - _POWER_DROP) if power.glyphs else 0.0
        if index.glyphs and power.glyphs:
            highest = max(p.at.imag + p.glyph.top for p in index.glyphs) - down
            lowest = up + min(p.at.imag + p.glyph.bottom for p in power.glyphs)
            apart = max(0.0, _LEAST_GAP * scale - (lowest - highest))
            alone = min(max(0.0, _POWER_BOTTOM * scale - lowest), apart)
            down, up = down + 0.5 * (apart - alone), up + 0.5 * (apart + alone)
        end = self.x
        for run, x, y in ((index, self.index_x, -down), (power, self.x, up)):
            if run.glyphs:
                self.put(run, complex(x, y))
                end = max(end, x + run.x + _AFTER * scale)
        self.x = self.index_x = end


def _upright(letter: str, level: int) -> Glyph:
    """A letter of a word: not cut for its size, but made smaller."""
    name = f"0u{letter}"
    return glyph(name if has_glyph(name) else _UNKNOWN, SCALE[level])


def set_name(run: Run, name: str, level: int) -> None:
    """Set letters of points with their numbers, a Greek letter, or digits."""
    if name in GREEK:
        run.add(GREEK[name], level)
    elif name.isdecimal():
        for digit in name:
            run.add(digit, level)
    else:
        for letter, number in letters(name):
            if letter == "′":
                run.attach(Run(), _prime(level + 1), level)
                continue
            run.add(letter, level)
            if number:
                run.attach(digits(number, level + 1), Run(), level)


def _prime(level: int) -> Run:
    run = Run()
    run.add("′", min(level, 2))
    return run


def digits(number: str, level: int) -> Run:
    """The digits of a number in a row of their own."""
    run = Run()
    set_name(run, number, min(level, 2))
    return run


def script(parts: Sequence[Index], level: int) -> Run:
    """What stands below or above a letter in a row of its own: letters of points and words."""
    run = Run()
    for i, part in enumerate(parts):
        if i and (part.upright or parts[i - 1].upright):
            run.x += WORD_SPACE * SCALE[level]
        if part.upright:
            run.words(part.text, level)
        else:
            set_name(run, part.text, level)
    return run
