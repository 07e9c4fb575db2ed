"""The modules of a QR code (ISO/IEC 18004) for a short text in capitals: versions 1 to 4, level M, mask 3.

Its bits, eight to a codeword: the mode, the number of letters, two letters in 11 bits each, filling. Each block of
codewords gets k more that correct errors: the remainder of ``d(x) x^k`` by ``(x - 1)(x - 2)(x - 4)...`` of degree k
over the field of 256 elements, with 2 for the root of ``x^8 + x^4 + x^3 + x^2 + 1``. The codewords of all blocks in
turn fill what patterns and format leave of the square, two columns at a time, upwards and downwards, from the right.

Any of the eight masks can be read. To find the one that looks least like a pattern takes eight times as long. segno, a
library for all codes, loads Python's networking at every start (20 ms) and takes four times as long for a code.
"""

from __future__ import annotations

from collections.abc import Iterator, Sequence
from functools import cache
from itertools import chain

from msgspec import Struct

LETTERS = "0123456789ABCDEFGHIJKLMNOPQRSTUVWXYZ $%*+-./:"  # their numbers in this order
_LETTERS_MODE = 0b0010
_FILLING = (0xEC, 0x11)
_FIELD, _FORMAT, _FORMAT_MASK = 0x11D, 0x537, 0x5412
_LEVEL_AND_MASK = 0b00011  # level M, mask 3
_BLOCKS = {1: (1, 16, 10), 2: (1, 28, 16), 3: (1, 44, 26), 4: (2, 32, 18)}  # blocks, data, error correction of each
_FINDER = ("1111111", "1000001", "1011101", "1011101", "1011101", "1000001", "1111111")
_ALIGNMENT = ("11111", "10001", "10101", "10001", "11111")


def modules(text: str) -> tuple[bytes, ...]:
    """The rows from the top without the white around them, a byte for every module, 1 if it is dark.

    The smallest version that holds the text: 20, 38, 61, 90 letters. Raises ValueError for others than LETTERS and for
    a text that is too long.
    """
    bits = _bits(text)
    fitting = [version for version, (blocks, size, _) in _BLOCKS.items() if len(bits) <= 8 * blocks * size]
    if not fitting:
        raise ValueError("the text is too long")
    blocks, size, correction = _BLOCKS[fitting[0]]
    words = _filled(bits, blocks * size)
    parts = [words[start : start + size] for start in range(0, len(words), size)]
    sent = [*_in_turn(parts), *_in_turn([_correction(part, correction) for part in parts])]
    square = _square(fitting[0])
    rows = [bytearray(row) for row in square.rows]
    stream = [word >> place & 1 for word in sent for place in range(7, -1, -1)]
    stream += [0] * (len(square.free) - len(stream))  # up to seven modules are left over
    for (y, x), bit in zip(square.free, stream, strict=True):
        rows[y][x] = bit ^ ((y + x) % 3 == 0)
    return tuple(map(bytes, rows))


def _bits(text: str) -> str:
    numbers = [LETTERS.index(letter) for letter in text]
    found = [f"{_LETTERS_MODE:04b}{len(text):09b}"]
    for first, second in zip(numbers[::2], numbers[1::2], strict=False):
        found.append(f"{45 * first + second:011b}")
    if len(numbers) % 2:
        found.append(f"{numbers[-1]:06b}")
    return "".join(found)


def _filled(bits: str, size: int) -> list[int]:
    """The codewords of data: zeros to the end of a codeword, at most four of them needed, then the filling."""
    bits += "0" * min(4, 8 * size - len(bits))
    bits += "0" * (-len(bits) % 8)
    words = [int(bits[start : start + 8], 2) for start in range(0, len(bits), 8)]
    return words + [_FILLING[place % 2] for place in range(size - len(words))]


def _in_turn(parts: Sequence[Sequence[int]]) -> Iterator[int]:
    return chain.from_iterable(zip(*parts, strict=True))


@cache
def _powers() -> tuple[list[int], dict[int, int]]:
    """The powers of 2 in the field, and the exponent of each element but zero."""
    powers = [1]
    while len(powers) < 255:
        twice = powers[-1] << 1
        powers.append(twice ^ _FIELD if twice > 0xFF else twice)
    return powers, {power: exponent for exponent, power in enumerate(powers)}


@cache
def _divisor(degree: int) -> list[int]:
    """The exponents of the coefficients of the divisor below the first, which is one."""
    powers, exponents = _powers()
    found = [1]
    for root in range(degree):
        shifted = [powers[(exponents[factor] + root) % 255] if factor else 0 for factor in found]
        found = [a ^ b for a, b in zip([*found, 0], [0, *shifted], strict=True)]
    return [exponents[factor] for factor in found[1:]]


def _correction(data: Sequence[int], degree: int) -> list[int]:
    """The codewords of error correction of a block."""
    (powers, exponents), divisor = _powers(), _divisor(degree)
    left = [*data, *[0] * degree]
    for place in range(len(data)):
        if left[place]:
            exponent = exponents[left[place]]
            for number, other in enumerate(divisor, start=place + 1):
                left[number] ^= powers[(exponent + other) % 255]
    return left[len(data) :]


class _Square(Struct, frozen=True):
    """A square with its patterns and its format, and the places (row, column) of its bits, in their order."""

    rows: tuple[bytes, ...]
    free: tuple[tuple[int, int], ...]


@cache
def _square(version: int) -> _Square:
    size = 17 + 4 * version
    known: dict[tuple[int, int], int] = {}

    def put(pattern: Sequence[str], top: int, left: int) -> None:
        known.update({(top + y, left + x): int(dark) for y, row in enumerate(pattern) for x, dark in enumerate(row)})

    for place in range(size):
        known[6, place] = known[place, 6] = 1 - place % 2
    for top, left in ((0, 0), (0, size - 7), (size - 7, 0)):
        around = [(y, x) for y in range(top - 1, top + 8) for x in range(left - 1, left + 8)]
        known.update({(y, x): 0 for y, x in around if 0 <= y < size and 0 <= x < size})
        put(_FINDER, top, left)
    if version > 1:
        put(_ALIGNMENT, size - 9, size - 9)
    for number, bit in enumerate(f"{_format():015b}"):
        # Twice: round the finder pattern at the top on the left, and beside the others.
        known[(8, (0, 1, 2, 3, 4, 5, 7, 8)[number]) if number < 8 else ((7, 5, 4, 3, 2, 1, 0)[number - 8], 8)] = int(
            bit
        )
        known[(size - 1 - number, 8) if number < 7 else (8, size - 15 + number)] = int(bit)
    known[size - 8, 8] = 1
    free = [place for place in _way(size) if place not in known]
    return _Square(tuple(bytes(known.get((y, x), 0) for x in range(size)) for y in range(size)), tuple(free))


def _format() -> int:
    """Level and mask with the ten bits that correct them."""
    left = _LEVEL_AND_MASK << 10
    for place in range(14, 9, -1):
        if left >> place & 1:
            left ^= _FORMAT << (place - 10)
    return (_LEVEL_AND_MASK << 10 | left) ^ _FORMAT_MASK


def _way(size: int) -> Iterator[tuple[int, int]]:
    """All places of a square in the order of the bits; the column with the dashes is left out."""
    columns = [*range(size - 1, 6, -2), 5, 3, 1]
    for number, right in enumerate(columns):
        rows = range(size) if number % 2 else range(size - 1, -1, -1)
        yield from ((y, x) for y in rows for x in (right, right - 1))
