"""Letters of a formula in a row, with what stands below and above them, as the typesetting engine sets them.

The constants are those of the OpenType math table of New Computer Modern Math. Lengths in em.
"""

from __future__ import annotations

from collections.abc import Iterator, Sequence
from functools import cache, lru_cache
from typing import NamedTuple

from msgspec import Struct
from msgspec.structs import replace

from variantgen.figure.letters.glyphs import STRETCHED, Glyph, glyph, has_glyph, kerning
from variantgen.wording.formula import GREEK, Index, letters

_INDEX_DOWN, _POWER_UP, _POWER_UP_CRAMPED, _LEAST_GAP, _AFTER = 0.247, 0.363, 0.289, 0.16, 0.056
_POWER_DROP = 0.25  # how much lower the baseline of a power is than the top of parentheses
_POWER_BOTTOM = 0.344  # a power over an index is raised alone until its ink is as high
WORD_SPACE = 0.331
INDEX = 0.7  # size of an index in that of its letter
SCALE = (1.0, INDEX, 0.5)  # of the sizes of formula, index, index of an index
_NEAR = 1e-9  # what rounding leaves
UNKNOWN = "0u"  # the name of what stands for a letter that the table does not have: a degree sign


class Letters(Struct, frozen=True, eq=False):
    """Letters of one style that follow each other as the engine spaces them: glyphs and places from the first one.

    Made once and set in many formulas.
    """

    glyphs: tuple[Glyph, ...]
    places: tuple[float, ...]
    bottom: float
    top: float

    @property
    def end(self) -> float:
        """Where the next letter would follow."""
        return self.places[-1] + self.glyphs[-1].advance


class PlacedLetters(NamedTuple):
    """Letters with the place of the origin of the first one (em, baseline of the formula at 0)."""

    letters: Letters
    at: complex


class PlacedGlyph(NamedTuple):
    """A glyph with the place of its origin (em, baseline of the formula at 0)."""

    glyph: Glyph
    at: complex


class Bar(NamedTuple):
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
        self.letters: list[PlacedLetters] = []
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
        bars = [at.imag - THICKNESS / 2 for at, _ in self.bars]
        return min([at.imag + letters.bottom for letters, at in self.letters] + bars, default=0.0)

    @property
    def top(self) -> float:
        """The highest ink, and the room that a root has above it."""
        bars = [at.imag + THICKNESS / 2 for at, _ in self.bars]
        tops = [at.imag + letters.top for letters, at in self.letters] + bars
        return max([*tops, self._highest] if self._highest else tops, default=0.0)

    def take_room(self, top: float) -> None:
        """Take room up to a height."""
        self._highest = max(self._highest, top)

    def put(self, other: Run, at: complex) -> None:
        """Set what another run consists of at a place; the row does not grow."""
        self.letters += [PlacedLetters(letters, own + at) for letters, own in other.letters]
        self.bars += [Bar(own + at, width) for own, width in other.bars]
        if other._highest:
            self.take_room(other._highest + at.imag)

    def append(self, other: Run) -> None:
        """Set another run after the letters so far."""
        self.put(other, complex(self.x, 0.0))
        self.x += other.x
        self.index_x = self.x

    def add(self, letter: str, level: int) -> None:
        """Set one letter of a formula (italic, Greek, a digit, a mark) at a level."""
        found = _formula_letter(letter, level)
        self.sign(found)
        self.index_x = self.x + found.index_at
        self.x += found.width

    def words(self, text: str, level: int = 0) -> None:
        """Set upright text."""
        words, index_x, width = _words(text, level)
        self.letters += [PlacedLetters(letters, complex(self.x + x, 0.0)) for letters, x in words]
        self.index_x = self.x + index_x
        self.x += width

    def mark(self, right: float) -> None:
        """Set the arrow of a vector: a mark to the left of where it begins."""
        self.letters.append(PlacedLetters(_alone(_ARROW), complex(right, 0.0)))

    def sign(self, glyph: Glyph, up: float = 0.0) -> None:
        """Set one sign; the row does not grow."""
        self.letters.append(PlacedLetters(_alone(glyph), complex(self.x, up)))

    def attach(self, index: Run, power: Run, level: int, top: float = 0.0) -> None:
        """Set what stands below and above to the right of the letters so far; ``top`` is that of parentheses before."""
        scale = SCALE[level]
        raised = _POWER_UP_CRAMPED if level or self.cramped else _POWER_UP
        down = _INDEX_DOWN * scale if index.letters else 0.0
        up = max(raised * scale, top - _POWER_DROP) if power.letters else 0.0
        if index.letters and power.letters:
            highest = max(at.imag + letters.top for letters, at in index.letters) - down
            lowest = up + min(at.imag + letters.bottom for letters, at in power.letters)
            apart = max(0.0, _LEAST_GAP * scale - (lowest - highest))
            alone = min(max(0.0, _POWER_BOTTOM * scale - lowest), apart)
            down, up = down + 0.5 * (apart - alone), up + 0.5 * (apart + alone)
        end = self.x
        for run, x, y in ((index, self.index_x, -down), (power, self.x, up)):
            if run.letters:
                self.put(run, complex(x, y))
                end = max(end, x + run.x + _AFTER * scale)
        self.x = self.index_x = end


_ARROW = Glyph("0u\N{COMBINING RIGHT ARROW ABOVE}", 0.0, 0.0, 0.0, 0.5, 0.714, "")


@cache
def _alone(glyph: Glyph) -> Letters:
    return Letters((glyph,), (0.0,), glyph.bottom, glyph.top)


@lru_cache(maxsize=10_000)
def _words(text: str, level: int) -> tuple[tuple[tuple[Letters, float], ...], float, float]:
    """The letters of upright text with their places, where an index begins, the width.

    The engine takes a number of nothing but digits and points for a formula.
    """
    formula = all(letter in "0123456789." for letter in text)
    found: list[tuple[Glyph, float]] = []
    x = index_x = 0.0
    for before, letter in zip(" " + text, text, strict=False):
        x += SCALE[level] * kerning(before, letter)
        if letter == " " and not formula:
            x += WORD_SPACE * SCALE[level]
            continue
        placed = _formula_letter(letter, level) if formula else _upright(letter, level)
        found.append((placed, x))
        index_x = x + placed.index_at
        x += placed.width
    return tuple(_together(found)), index_x, x


def _together(row: Sequence[tuple[Glyph, float]]) -> Iterator[tuple[Letters, float]]:
    """Glyphs in a row as letters that follow each other, with their places."""
    start = 0
    for end in range(1, len(row) + 1):
        if end == len(row) or not follows(row[end - 1][0], row[end][0], row[end][1] - row[end - 1][1]):
            glyphs, places = zip(*row[start:end], strict=True)
            x, bottom, top = places[0], min(g.bottom for g in glyphs), max(g.top for g in glyphs)
            yield Letters(glyphs, tuple(place - x for place in places), bottom, top), x
            start = end


def follows(one: Glyph, other: Glyph, apart: complex) -> bool:
    """Whether a glyph stands where the engine would set it after another one, of the same style."""
    if one.scale != other.scale or one.name[:2] != other.name[:2] or one.name[1] == STRETCHED:
        return False
    gap = one.advance
    if one.name[1] == "u":
        gap += one.scale * kerning(one.name[2:], other.name[2:])
    return abs(gap - apart) < _NEAR


@cache
def _formula_letter(letter: str, level: int) -> Glyph:
    found = next((n for n in (f"{level}i{letter}", f"0i{letter}") if has_glyph(n)), "")
    return glyph(found) if found else _upright(letter, level)


@cache
def _upright(letter: str, level: int) -> Glyph:
    """A letter of a word: not cut for its size, but made smaller."""
    name = f"0u{letter}"
    return glyph(name, SCALE[level]) if has_glyph(name) else replace(glyph("0u°", SCALE[level]), name=UNKNOWN)


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
