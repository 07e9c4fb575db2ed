"""JSON that is too large to be in memory whole: an object of which one long list is read item by item."""

from __future__ import annotations

import json
import math
from collections.abc import Iterator
from decimal import Decimal
from typing import Any, TextIO


def _finite(text: str) -> Decimal:
    """A number with a decimal point as it is written. Raises ValueError for NaN, Infinity and what overflows."""
    number = Decimal(text)
    if not math.isfinite(float(number)):
        raise ValueError(f"{text} is no finite number")
    return number


_DECODER = json.JSONDecoder(parse_float=_finite, parse_constant=_finite)
_CHUNK = 1 << 20  # characters that are read at a time
_LARGEST = 2_000_000_000  # characters of one value
_BLANK = " \t\n\r"
_BEHIND = frozenset(_BLANK + ",:]}")  # a value


def entries(file: TextIO, listed: str) -> Iterator[tuple[str, int, Any]]:
    """The entries of the object in a file: key, 0 and value.

    The value of the key ``listed`` comes item by item, with the number of each from 1 on; if it is no list or has no
    items, it comes as others do. Raises ValueError where the text is no JSON object, has a key twice or a number that
    is not finite, or a value is too long for any memory; OSError.
    """
    text = _Text(file)
    known: set[str] = set()
    text.expect("{")
    if text.following() != "}":
        while True:
            key = text.value()
            if not isinstance(key, str):
                raise ValueError(f"expected a name and not {key}")
            if key in known:
                raise ValueError(f"the key {key} is there twice")
            known.add(key)
            text.expect(":")
            if key == listed and text.following() == "[":
                yield from ((key, number, value) for number, value in enumerate(_items(text), start=1))
            else:
                yield key, 0, text.value()
            if text.following() != ",":
                break
            text.expect(",")
    text.expect("}")
    if text.following():
        raise ValueError("there is more behind its end")


def _items(text: _Text) -> Iterator[Any]:
    """The items of a list."""
    text.expect("[")
    if text.following() != "]":
        yield text.value()
        while text.following() == ",":
            text.expect(",")
            yield text.value()
    text.expect("]")


class _Text:
    """The text of a file, in memory from where it is being read."""

    def __init__(self, file: TextIO) -> None:
        self._file, self._text, self._place = file, "", 0

    def following(self) -> str:
        """The next character that is not blank; none at the end."""
        while True:
            while self._place < len(self._text) and self._text[self._place] in _BLANK:
                self._place += 1
            if self._place < len(self._text) or not self._read_on():
                return self._text[self._place : self._place + 1]

    def expect(self, mark: str) -> None:
        """Go on behind a mark. Raises ValueError if something else comes."""
        found = self.following()
        if found != mark:
            raise ValueError(f"expected {mark} and not {found or 'its end'}")
        self._place += 1

    def value(self) -> Any:
        """The next value. Raises ValueError."""
        self.following()
        while True:
            try:
                found, end = _DECODER.raw_decode(self._text, self._place)
            except ValueError:
                if not self._read_on():
                    raise
            else:
                # A number may go on behind what is here, be it at a point.
                if self._text[end : end + 1] in _BEHIND or not self._read_on():
                    self._place = end
                    return found

    def _read_on(self) -> bool:
        """Read as much again as is left; whether there was something. Raises ValueError for a value without an end."""
        left = self._text[self._place :]
        if len(left) > _LARGEST:
            raise ValueError("a value is too long")
        more = self._file.read(max(_CHUNK, len(left)))
        self._text, self._place = left + more, 0
        return bool(more)
