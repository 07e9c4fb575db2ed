"""Characters that cannot be seen or that control something, and texts without them: one table for the whole program.

Refused in texts from outside (titles, names, statements) and spelled out on a terminal are control characters, line and
paragraph separators, characters that change the direction of what stands around them or are invisible, halves of
characters, those of private use and code points that are no known characters.
"""

from __future__ import annotations

import unicodedata

# Joiners belong to the spelling of some languages, and to emoji.
_JOINERS = "\N{ZERO WIDTH NON-JOINER}\N{ZERO WIDTH JOINER}"
_KINDS = {
    "Cc": "a control character",
    "Cf": "an invisible character",
    "Cs": "half of a character",
    "Co": "a character of private use",
    "Cn": "a code point that is no known character",
    "Zl": "a line separator",
    "Zp": "a paragraph separator",
}


def unseen(text: str, allowed: str = "") -> dict[str, str]:
    """Each character of a text that cannot be seen, with what it is; ``allowed`` are others that may stand there."""
    if text.isascii() and text.isprintable():
        return {}
    kinds = {letter: _KINDS.get(unicodedata.category(letter), "") for letter in dict.fromkeys(text)}
    return {letter: kind for letter, kind in kinds.items() if kind and letter not in _JOINERS + allowed}


def named(letter: str) -> str:
    """A character by its number and name: ``U+200B ZERO WIDTH SPACE``."""
    return f"U+{ord(letter):04X} {unicodedata.name(letter, '')}".strip()


def spelled_out(text: str) -> str:
    r"""A text of lines with what cannot be seen written as JSON does (``\u001b``): it controls no terminal.

    A JSON document stays the same document.
    """
    found = unseen(text, allowed="\n")
    return text.translate({ord(letter): _units(letter) for letter in found})


def _units(letter: str) -> str:
    """A character by its numbers in UTF-16."""
    code = letter.encode("utf-16-be", "surrogatepass").hex()
    return "".join(f"\\u{code[i : i + 4]}" for i in range(0, len(code), 4))
