"""Choices that depend on names alone, on every machine (see :mod:`variantgen.variants.seeding`)."""

from __future__ import annotations

from collections.abc import Sequence
from typing import TypeVar

from variantgen.variants.seeding import Stream, index_below

Item = TypeVar("Item")
_AT_ONCE = 64


class Chance:
    """A stream of choices of one seed, its ``parts``."""

    def __init__(self, *parts: object) -> None:
        self._stream, self._words = Stream(*parts), Stream(*parts).words(0)

    def below(self, size: int) -> int:
        """A whole number from 0 to ``size - 1``."""
        if not self._words.size:
            self._words = self._stream.words(_AT_ONCE)
        word, self._words = self._words[:1], self._words[1:]
        return int(index_below(word, size)[0])

    def choice(self, items: Sequence[Item]) -> Item:
        """One of the items."""
        return items[self.below(len(items))]

    def random(self) -> float:
        """A number from 0 to below 1, in steps of a thousandth."""
        return self.below(1000) / 1000

    def uniform(self, low: float, high: float) -> float:
        """A number between two others."""
        return low + (high - low) * self.random()
