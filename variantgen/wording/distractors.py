"""The plausible mistakes that an answer may not show, in a language (table ``[mistakes]`` of its words)."""

from __future__ import annotations

import re
from collections.abc import Mapping

from variantgen.wording.formula import to_plain
from variantgen.wording.language import Language

_NAME = "{}"  # a link, point or parameter in the names of mistakes
_OF = " of {}"  # left out where the only link has no name


def mistake_text(mistake: str, language: Language, symbols: Mapping[str, str]) -> str:
    """A mistake by its name (see :mod:`variantgen.variants.distractors`); ``symbols`` are those of the form.

    A mistake that the language has no words for is given by its name. A link whose symbol is empty is the only one.
    """
    words = language.words("mistakes")
    for pattern in words:
        found = _matcher(pattern).fullmatch(mistake)
        if found:
            if any(symbols.get(name) == "" for name in found.groups()):
                return words[pattern.replace(_OF, "")]
            names = (to_plain(language.symbol(name, symbols)) for name in found.groups())
            return words[pattern].format(*names)
    return mistake


def _matcher(pattern: str) -> re.Pattern[str]:
    """What finds the name in a mistake."""
    return re.compile(r"(\w+)".join(re.escape(part) for part in pattern.split(_NAME)))
