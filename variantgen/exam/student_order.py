"""In which order students stand: by group and name, as a reader of the language looks for them.

Letters stand as in the alphabet of the language; those that it does not have stand where they would without their
accent (ё with е, ö with o). Case makes no difference, numbers count as numbers (group 9 before group 10), a dash is a
space. The order changes no sheet: what a student gets depends on the id alone.
"""

from __future__ import annotations

import re
import unicodedata
from collections.abc import Iterable, Sequence

from variantgen.exam.roster import Student

NAME, ROSTER = SORTS = ("name", "roster")

# Letters that no accent is taken from, by those they stand with.
_PLAIN = str.maketrans({"ё": "е", "ø": "o", "ł": "l", "đ": "d", "ð": "d", "ı": "i", "æ": "ae", "œ": "oe", "þ": "th"})
_PIECE = re.compile(r"\d+|\w")

Place = tuple[tuple[int, int, str], ...]


def collated(text: str, alphabet: str = "") -> tuple[Place, str]:
    """By what a text is sorted: its letters and its numbers; among equal ones the text itself."""
    # The letters of the alphabet change places with each other, so that they stand in its order among all others.
    letters = base(text, alphabet).translate(str.maketrans(alphabet, "".join(sorted(alphabet))))
    words = (tuple(map(_piece, _PIECE.findall(word))) for word in re.split(r"[\s\-\u2010-\u2015]+", letters))
    place = (piece for word in words if word for piece in ((0, 0, ""), *word))  # a space stands before every letter
    return tuple(place), text


def base(text: str, alphabet: str = "") -> str:
    """A text in small letters without accents; those of the alphabet stay, and й and the like in Cyrillic."""
    letters = unicodedata.normalize("NFC", text.casefold())
    return "".join(letter if letter in alphabet else _base_letter(letter.translate(_PLAIN)) for letter in letters)


def in_order(students: Sequence[Student], sort: str = NAME, alphabet: str = "") -> list[Student]:
    """The students by group, name and id, or as they stand in the roster."""
    if sort == ROSTER:
        return list(students)
    return sorted(students, key=lambda s: tuple(collated(text, alphabet) for text in (s.group, s.name, s.id)))


def natural(ids: Iterable[str]) -> list[str]:
    """Ids in order, 9 before 10."""
    return sorted(ids, key=collated)


def _base_letter(letter: str) -> str:
    """A Latin or Greek letter without its accents."""
    if letter < "\u00c0" or "\u0400" <= letter <= "\u052f":
        return letter
    found = unicodedata.normalize("NFD", letter)
    return found[0] if len(found) > 1 and all(unicodedata.combining(mark) for mark in found[1:]) else letter


def _piece(piece: str) -> tuple[int, int, str]:
    return (1, int(piece), "") if piece.isdecimal() and len(piece) < 1000 else (2, 0, piece)
