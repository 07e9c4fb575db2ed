"""How the letters of a formula stand, as the typesetting engine sets them: places of glyphs, width, ink.

The rules are those of the OpenType math table with the constants of New Computer Modern Math: an index is lowered, an
upper index raised, both moved apart until a gap is left between them; some space follows. Lengths in em, the size of
the lettering of the figure.
"""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import dataclass
from functools import lru_cache

from variantgen.figure.drawing import LETTER, Label
from variantgen.figure.glyphs import Glyph, glyph, has_glyph, kerning
from variantgen.wording.formula import (
    GREEK,
    Equation,
    Formula,
    FormulaList,
    Index,
    Measured,
    Number,
    Quotient,
    Symbol,
    SymbolProperty,
    UnitText,
    letters,
)

_INDEX_DOWN, _POWER_UP, _POWER_UP_IN_INDEX, _LEAST_GAP, _AFTER = 0.247, 0.363, 0.289, 0.16, 0.056
_POWER_BOTTOM = 0.344  # a power over an index is raised alone until its ink is as high
_THIN, _AROUND_EQUALS, _WORD_SPACE = 1 / 6, 5 / 18, 0.331
INDEX = 0.7  # size of an index in that of its letter
_SCALE = (1.0, INDEX, 0.5)  # of the sizes of formula, index, index of an index
_UNKNOWN = "0u°"  # stands for a letter that the table does not have


@dataclass(frozen=True)
class PlacedGlyph:
    """A glyph with the place of its origin (em, baseline of the formula at 0)."""

    glyph: Glyph
    at: complex


@dataclass(frozen=True)
class Lettering:
    """A set formula: its glyphs, its width, and the bounds of its ink above the baseline (em)."""

    glyphs: tuple[PlacedGlyph, ...]
    width: float
    bottom: float
    top: float


@lru_cache(maxsize=10_000)
def typeset(formula: Formula) -> Lettering:
    """The lettering of a formula. Raises TypeError for a kind that stands in texts only, like a sum."""
    run = _Run()
    _set(run, formula)
    bottom = min((p.at.imag + p.glyph.bottom for p in run.glyphs), default=0.0)
    top = max((p.at.imag + p.glyph.top for p in run.glyphs), default=0.0)
    return Lettering(tuple(run.glyphs), run.x, bottom, top)


def letters_of(label: Label) -> list[tuple[Glyph, complex]]:
    """The glyphs of a label with where their origins are on the paper (u); ``label.at`` is the middle of the ink."""
    found = typeset(label.formula)
    origin = label.at - LETTER * complex(0.5 * found.width, 0.5 * (found.top + found.bottom))
    return [(placed.glyph, origin + LETTER * placed.at) for placed in found.glyphs]


class _Run:
    """Letters in a row; ``x`` is where the next one begins."""

    def __init__(self) -> None:
        self.glyphs: list[PlacedGlyph] = []
        self.x = 0.0
        self.index_x = 0.0

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
            self.x += _SCALE[level] * kerning(before, letter)
            if letter == " ":
                self.x += _WORD_SPACE * _SCALE[level]
            else:
                self._put(_upright(letter, level))

    def _put(self, letter: Glyph) -> None:
        self.glyphs.append(PlacedGlyph(letter, complex(self.x, 0.0)))
        self.index_x = self.x + letter.index_at
        self.x += letter.width

    def attach(self, index: _Run, power: _Run, level: int) -> None:
        """Set what stands below and above to the right of the letters so far."""
        scale = _SCALE[level]
        raised = _POWER_UP_IN_INDEX if level else _POWER_UP
        down, up = _INDEX_DOWN * scale if index.glyphs else 0.0, raised * scale if power.glyphs else 0.0
        if index.glyphs and power.glyphs:
            highest = max(p.at.imag + p.glyph.top for p in index.glyphs) - down
            lowest = up + min(p.at.imag + p.glyph.bottom for p in power.glyphs)
            apart = max(0.0, _LEAST_GAP * scale - (lowest - highest))
            alone = min(max(0.0, _POWER_BOTTOM * scale - lowest), apart)
            down, up = down + 0.5 * (apart - alone), up + 0.5 * (apart + alone)
        end = self.x
        for run, x, y in ((index, self.index_x, -down), (power, self.x, up)):
            if run.glyphs:
                self.glyphs += [PlacedGlyph(p.glyph, p.at + complex(x, y)) for p in run.glyphs]
                end = max(end, x + run.x + _AFTER * scale)
        self.x = self.index_x = end


def _upright(letter: str, level: int) -> Glyph:
    """A letter of a word: not cut for its size, but made smaller."""
    name = f"0u{letter}"
    return glyph(name if has_glyph(name) else _UNKNOWN, _SCALE[level])


def _set(run: _Run, formula: Formula) -> None:
    match formula:
        case Symbol(base, index, upper, part):
            if part:
                run.add("(", 0)
            _set_name(run, base, 0)
            if index or upper:
                run.attach(_script(index, 1), _script(upper, 1), 0)
            if part:
                run.add(")", 0)
                run.attach(_script(part, 1), _Run(), 0)
        case Number(text):
            run.words(text)
        case UnitText(parts):
            for word, power in parts:
                run.words(word)
                if power != 1:
                    above = _Run()
                    above.words(str(power).replace("-", "\N{MINUS SIGN}"), 1)
                    run.attach(_Run(), above, 0)
        case Measured(number, unit):
            run.words(number.text)
            run.x += 0.0 if unit.tight or not unit.parts else _THIN
            _set(run, unit)
        case Equation(left, right):
            _set(run, left)
            run.x += _AROUND_EQUALS
            run.words("=")
            run.x += _AROUND_EQUALS
            _set(run, right)
        case FormulaList(items):
            for i, item in enumerate(items):
                if i:
                    run.words(",")
                    run.x += _THIN
                _set(run, item)
        case SymbolProperty(what, symbol):
            _set_about(run, what, symbol)
        case Quotient(above, below):
            _set(run, above)
            run.words("/")
            _set(run, below)
        case _:
            raise TypeError(f"figures have no letters for a formula of the kind {type(formula).__name__}")


def _set_about(run: _Run, what: str, symbol: Symbol) -> None:
    """``|v|``, ``∠(v, x)``, ``sgn v``."""
    match what:
        case "modulus":
            run.add("|", 0)
            _set(run, symbol)
            run.add("|", 0)
        case "angle":
            run.add("∠", 0)
            run.add("(", 0)
            _set(run, symbol)
            run.add(",", 0)
            run.x += _THIN
            run.add("x", 0)
            run.add(")", 0)
        case _:
            run.words("sgn")
            run.x += _THIN
            _set(run, symbol)


def _set_name(run: _Run, name: str, level: int) -> None:
    """Letters of points with their numbers, a Greek letter, or digits."""
    if name in GREEK:
        run.add(GREEK[name], level)
    elif name.isdecimal():
        for digit in name:
            run.add(digit, level)
    else:
        for letter, number in letters(name):
            if letter == "′":
                run.attach(_Run(), _prime(level + 1), level)
                continue
            run.add(letter, level)
            if number:
                run.attach(_digits(number, level + 1), _Run(), level)


def _prime(level: int) -> _Run:
    run = _Run()
    run.add("′", min(level, 2))
    return run


def _digits(number: str, level: int) -> _Run:
    run = _Run()
    _set_name(run, number, min(level, 2))
    return run


def _script(parts: Sequence[Index], level: int) -> _Run:
    run = _Run()
    for i, part in enumerate(parts):
        if i and (part.upright or parts[i - 1].upright):
            run.x += _WORD_SPACE * _SCALE[level]
        if part.upright:
            run.words(part.text, level)
        else:
            _set_name(run, part.text, level)
    return run
