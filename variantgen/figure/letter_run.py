"""Letters of a formula in a row, with what stands below and above them, as the typesetting engine sets them.

The constants are those of the OpenType math table of New Computer Modern Math. Lengths in em.
"""

from __future__ import annotations

from dataclasses import dataclass

from variantgen.figure.glyphs import Glyph, glyph, has_glyph, kerning

_INDEX_DOWN, _POWER_UP, _POWER_UP_IN_INDEX, _LEAST_GAP, _AFTER = 0.247, 0.363, 0.289, 0.16, 0.056
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


class Run:
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

    def attach(self, index: Run, power: Run, level: int) -> None:
        """Set what stands below and above to the right of the letters so far."""
        scale = SCALE[level]
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
    return glyph(name if has_glyph(name) else _UNKNOWN, SCALE[level])
