"""Text from outside that can stand on paper as it is: no characters that control something or cannot be seen.

Names may be in any script. Refused are control characters, line and paragraph separators, characters that change the
direction of what stands around them or are invisible, and code points that are no known characters.
"""

from __future__ import annotations

import unicodedata

from variantgen.errors import Problem

MOST = 20_000  # characters of one text
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


def problems(text: str, what: str, key: str) -> list[Problem]:
    """What keeps a text from standing on paper; ``what`` is it (``the name``), ``key`` where."""
    found = []
    for letter in dict.fromkeys(text):
        kind = _KINDS.get(unicodedata.category(letter))
        if kind and letter not in _JOINERS:
            value = f"U+{ord(letter):04X} {unicodedata.name(letter, '')}".strip()
            remedy = "remove it: type the text anew instead of pasting it"
            found.append(Problem(f"{what} holds {kind}", key=key, value=value, remedy=remedy))
    if len(text) > MOST:
        found.append(Problem(f"{what} has {len(text)} characters", key=key, remedy=f"at most {MOST}"))
    return found
