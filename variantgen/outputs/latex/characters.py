"""Which characters a document of LaTeX can print.

pdfLaTeX has fonts of 256 characters: those of the encoding T1 for Latin letters, of T2A for Cyrillic ones, and a few
signs beside both. LuaLaTeX prints what its font has, which only a run can tell; it is not set up for writing from right
to left.
"""

from __future__ import annotations

import unicodedata
from collections.abc import Iterable
from typing import Literal

from msgspec import Struct

Engine = Literal["pdflatex", "lualatex"]

ASCII = frozenset(map(chr, range(0x20, 0x7F)))
SIGNS = frozenset(
    "¡¢£¤¥¦§¨©ª«¬®¯°±²³´µ¶·¸¹º»¼½¾¿×÷†‡•…‰€№™−–—‘’“”„\N{NO-BREAK SPACE}\N{NARROW NO-BREAK SPACE}\N{THIN SPACE}"
)
# Signs that are set as formulas.
MATH = {
    "∠": r"\angle", "≈": r"\approx", "≤": r"\leq", "≥": r"\geq", "≠": r"\neq", "→": r"\to", "∞": r"\infty",
    "∥": r"\parallel", "⟂": r"\perp", "′": "'", "√": r"\surd", "Δ": r"\Delta", "Σ": r"\Sigma", "Ω": r"\Omega",
    "α": r"\alpha", "β": r"\beta", "γ": r"\gamma", "δ": r"\delta", "ε": r"\varepsilon", "θ": r"\theta",
    "λ": r"\lambda", "μ": r"\mu", "ν": r"\nu", "π": r"\pi", "ρ": r"\rho", "σ": r"\sigma", "τ": r"\tau",
    "φ": r"\varphi", "ψ": r"\psi", "ω": r"\omega",
}  # fmt: skip
# Invisible characters that change nothing on paper: a soft hyphen, blanks of no width, the mark of the byte order.
SILENT = "\N{SOFT HYPHEN}\N{ZERO WIDTH SPACE}\N{WORD JOINER}\N{ZERO WIDTH NO-BREAK SPACE}"
_T1 = (
    "00C0-00D6 00D8-00F6 00F8-0125 0128-0137 0139-013E 0141-0148 014A-0165 0168-017E 01CD-01D4 01E6-01EB 01F4-01F5"
    " 0218-021B 0232-0233 1E02-1E03 1E1E-1E1F 1EF2-1EF3 201A 2039-203A"
)
_T2A = "0400-045F 0490-0493 0496-049D 04A0-04A5 04AA-04AB 04AE-04B3 04B6-04BB 04C0 04D0-04D3 04D6-04D9 04E8-04E9"


def _listed(ranges: str) -> frozenset[str]:
    """The characters of ranges of code points."""
    ends = [part.split("-") for part in ranges.split()]
    return frozenset(chr(code) for part in ends for code in range(int(part[0], 16), int(part[-1], 16) + 1))


LATIN, CYRILLIC = _listed(_T1), _listed(_T2A)
_KNOWN = ASCII | SIGNS | LATIN | CYRILLIC | MATH.keys()


class Alphabet(Struct, frozen=True):
    """The letters that a document prints only inside the ``command``."""

    engine: Engine
    other: frozenset[str] = frozenset()
    command: str = ""


_ALPHABETS = {
    True: Alphabet("pdflatex", LATIN, "inlatin"),
    False: Alphabet("pdflatex", CYRILLIC, "incyrillic"),
}


def alphabet(language: str, engine: Engine) -> Alphabet:
    """The alphabet of a document in a language."""
    return Alphabet("lualatex") if engine == "lualatex" else _ALPHABETS[is_cyrillic_language(language)]


def is_cyrillic_language(language: str) -> bool:
    """Whether documents in a language are printed in Cyrillic letters."""
    from variantgen.wording.language import load_language

    return any(letter in CYRILLIC for letter in load_language(language).words("sheet")["problem"])


def cleaned(text: str) -> str:
    """Text as it is printed: letters with their accents as one character, blanks alike, nothing invisible."""
    composed = unicodedata.normalize("NFC", text)
    kept = "".join(_blank(letter) for letter in composed if letter not in SILENT)
    return " ".join(kept.split(" ")) if "  " not in kept else " ".join(part for part in kept.split(" ") if part)


def _blank(letter: str) -> str:
    """A blank for every kind of blank that may be as wide as any other."""
    return " " if letter.isspace() and letter not in SIGNS else letter


def unprintable(text: str, engine: Engine) -> list[str]:
    """The characters of a text that a document cannot print, each once."""
    strange = [letter for letter in dict.fromkeys(cleaned(text)) if letter not in _KNOWN]
    return strange if engine == "pdflatex" else [letter for letter in strange if not _for_a_font(letter)]


def _for_a_font(letter: str) -> bool:
    """Whether a character is one that a font may have, and that is written from left to right."""
    return not unicodedata.category(letter).startswith("C") and not is_right_to_left(letter)


def is_right_to_left(letter: str) -> bool:
    """Whether a character is written from right to left."""
    return unicodedata.bidirectional(letter) in {"R", "AL", "AN"}


def named(letters: Iterable[str]) -> str:
    """Characters with their code points, for a message."""
    found = list(letters)
    named = [f"{letter} (U+{ord(letter):04X})" if letter.isprintable() else f"U+{ord(letter):04X}" for letter in found]
    return ", ".join(named[:8]) + (f" and {len(named) - 8} more" if len(named) > 8 else "")
