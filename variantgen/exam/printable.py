"""Text from outside that can stand on paper as it is: no characters that control something or cannot be seen.

Names may be in any script; :mod:`variantgen.letters` has the table of what is refused.
"""

from __future__ import annotations

from variantgen.errors import Problem
from variantgen.letters import named, unseen

MOST = 20_000  # characters of one text


def problems(text: str, what: str, key: str, allowed: str = "") -> list[Problem]:
    """The problems of a text that cannot be printed as it is; ``what`` names it (``the name``), ``key`` its place.

    ``allowed`` are characters that may stand there all the same, as ends of lines.
    """
    remedy = "remove it: type the text anew instead of pasting it"
    found = [
        Problem(f"{what} holds {kind}", key=key, value=named(letter), remedy=remedy)
        for letter, kind in unseen(text, allowed).items()
    ]
    if len(text) > MOST:
        found.append(Problem(f"{what} has {len(text)} characters", key=key, remedy=f"at most {MOST}"))
    return found
