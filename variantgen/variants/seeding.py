"""Random numbers that depend on names alone.

A variant depends on (seed, student id, problem number, family) and on nothing else. These are hashed to the key of a
Philox counter generator, and only its raw 64-bit words are used: numpy promises them for ever, while the higher
methods of its generators may change between versions.
"""

from __future__ import annotations

import hashlib

import numpy as np
from numpy.typing import NDArray


def digest(*parts: object) -> bytes:
    """16 bytes that depend on the parts (their text) and on their order, the same on every machine."""
    text = "\x1f".join(f"{len(str(part))}:{part}" for part in parts)
    return hashlib.blake2b(text.encode("utf-8", "surrogatepass"), digest_size=16).digest()


class Stream:
    """A stream of raw random words of one (seed, student, problem, family), its ``parts``."""

    def __init__(self, *parts: object) -> None:
        self.parts = parts
        self._bits = np.random.Philox(key=int.from_bytes(digest(*parts), "big"))

    def words(self, count: int) -> NDArray[np.uint64]:
        """The next words, shape (count,)."""
        return np.asarray(self._bits.random_raw(count), dtype=np.uint64)


def index_below(words: NDArray[np.uint64], size: int) -> NDArray[np.int64]:
    """Integers uniform on 0 .. size-1 from random words, of the shape of the words (bias below size / 2^32)."""
    high = words >> np.uint64(32)
    return ((high * np.uint64(size)) >> np.uint64(32)).astype(np.int64)
