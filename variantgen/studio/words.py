"""The words of the pages, ``assets/words/<language>.toml``: by page and key, the same keys in every language."""

from __future__ import annotations

import tomllib
from collections.abc import Mapping
from functools import cache
from pathlib import Path

from variantgen.wording.plurals import plural_category

ASSETS = Path(__file__).parent / "assets"
LANGUAGES = ("en", "ru")


class PageWords:
    """The words of one language."""

    def __init__(self, language: str) -> None:
        self.language = language
        text = (ASSETS / "words" / f"{language}.toml").read_text("utf-8")
        self._tables: Mapping[str, Mapping[str, str]] = tomllib.loads(text)

    def of(self, page: str) -> Mapping[str, str]:
        """The words of a page, by key."""
        return self._tables[page]

    def counted(self, number: int, what: str) -> str:
        """So many of something: ``5 problems``, ``5 задач``; numbers of four digits and more are grouped."""
        category = plural_category(self._tables["plural_rules"], number)
        return f"{self.number(number)}\N{NO-BREAK SPACE}{self._tables['plurals'][f'{what}.{category}']}"

    def number(self, value: int) -> str:
        """A whole number, in groups of three digits."""
        mark = "\N{NO-BREAK SPACE}" if self.language == "ru" else ","
        return f"{value:,}".replace(",", mark) if abs(value) >= 10_000 else str(value)


@cache
def page_words(language: str) -> PageWords:
    """The words of a language; of one that there is not those in English."""
    return PageWords(language if language in LANGUAGES else "en")
