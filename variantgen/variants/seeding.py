"""Random numbers that depend on names alone.

A variant depends on (seed, student id, problem number, family) and on nothing else. These are hashed to the key of a
counter generator, Philox4x64-10 (Salmon, Moraes, Dror, Shaw: Parallel random numbers: as easy as 1, 2, 3; 2011), of
which only the 64-bit words are used: numpy promises for ever those of its own one, while its higher methods may change.

Few words are worked out here, those of many streams together: numpy's generators take longer to load than all that a
command for one variant draws. Many words of a stream are taken from numpy, which is thirty times as fast for them.

A block of four words from the counter n and the key (k, l), in ten rounds: of (n, 0, 0, 0) = (a, b, c, d) becomes
(high(C c) ^ b ^ k, low(C c), high(A a) ^ d ^ l, low(A a)), with the halves of products of 128 bits, then k and l grow
by constants.
"""

from __future__ import annotations

import hashlib
from collections.abc import Sequence

import numpy as np
from numpy.typing import NDArray

Words = NDArray[np.uint64]

_ROUNDS, _IN_BLOCK = 10, 4
_MANY = 16_384  # words of one stream, which take a millisecond here
_HALF, _LOW = np.uint64(32), np.uint64(0xFFFF_FFFF)
# Of a and c, of k and l.
_FACTORS: Words = np.array([0xD2E7470EE14C6C93, 0xCA5A826395121157], dtype=np.uint64).reshape(2, 1, 1)
_GROWTH: Words = np.array([0x9E3779B97F4A7C15, 0xBB67AE8584CAA73B], dtype=np.uint64).reshape(2, 1, 1)
_LOW_FACTORS, _HIGH_FACTORS = _FACTORS & _LOW, _FACTORS >> _HALF


def digest(*parts: object) -> bytes:
    """16 bytes that depend on the parts (their text) and on their order, the same on every machine."""
    text = "\x1f".join(f"{len(str(part))}:{part}" for part in parts)
    return hashlib.blake2b(text.encode("utf-8", "surrogatepass"), digest_size=16).digest()


class Stream:
    """A stream of raw random words of one (seed, student, problem, family), its ``parts``."""

    def __init__(self, *parts: object) -> None:
        self.parts = parts
        self.key = np.frombuffer(digest(*parts), dtype=">u8")[::-1]
        self.place = 0  # of the next word

    def words(self, count: int) -> Words:
        """The next words, shape (count,)."""
        found: Words = next_words([self], count)[0]
        return found

    def skip(self, count: int) -> None:
        """Leave out words."""
        self.place += count


def next_words(streams: Sequence[Stream], count: int) -> Words:
    """The next words of each of some streams, shape (streams, count)."""
    places = [stream.place for stream in streams]
    for stream in streams:
        stream.skip(count)
    if count >= _MANY:
        return np.stack([_by_numpy(*of, count) for of in zip(streams, places, strict=True)])
    blocks = (count + 2 * _IN_BLOCK - 2) // _IN_BLOCK  # enough wherever in a block a stream stands
    first: Words = np.array([place // _IN_BLOCK for place in places], dtype=np.uint64).reshape(-1, 1)
    counters = np.asarray(first + np.arange(1, blocks + 1, dtype=np.uint64), dtype=np.uint64)
    keys: Words = np.array([stream.key for stream in streams], dtype=np.uint64).reshape(-1, 2).T[:, :, None]
    begins = [place % _IN_BLOCK for place in places]
    rows = zip(_philox(counters, keys), begins, strict=True)
    return np.array([row[begin : begin + count] for row, begin in rows], dtype=np.uint64).reshape(len(streams), count)


def _by_numpy(stream: Stream, place: int, count: int) -> Words:
    """Words of a stream from a place on, shape (count,)."""
    bits = np.random.Philox(key=stream.key.astype(np.uint64), counter=place // _IN_BLOCK)
    bits.random_raw(place % _IN_BLOCK)
    return np.asarray(bits.random_raw(count), dtype=np.uint64)


def _philox(counters: Words, keys: Words) -> Words:
    """The blocks of counters, shape (N, blocks), and keys, shape (2, N, 1); shape (N, 4 blocks)."""
    # Outer: a and c. Inner: b and d. The products of halves never pass 64 bits; whole products keep their low halves.
    outer = np.zeros((2, *counters.shape), dtype=np.uint64)
    outer[0], inner = counters, np.zeros_like(outer)
    for _ in range(_ROUNDS):
        low, high = outer & _LOW, outer >> _HALF
        middle = high * _LOW_FACTORS + (low * _LOW_FACTORS >> _HALF)
        other = low * _HIGH_FACTORS + (middle & _LOW)
        upper = high * _HIGH_FACTORS + (middle >> _HALF) + (other >> _HALF)
        outer, inner = upper[::-1] ^ inner ^ keys, (outer * _FACTORS)[::-1]
        keys = keys + _GROWTH
    blocks: Words = np.stack([outer[0], inner[0], outer[1], inner[1]], axis=-1)
    return blocks.reshape(len(counters), _IN_BLOCK * counters.shape[1])


def index_below(words: Words, size: int) -> NDArray[np.int64]:
    """Integers uniform on 0 .. size-1 from random words, of the shape of the words (bias below size / 2^32)."""
    high = words >> np.uint64(32)
    return ((high * np.uint64(size)) >> np.uint64(32)).astype(np.int64)
