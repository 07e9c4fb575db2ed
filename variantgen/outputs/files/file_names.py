"""Names of files for students and groups: safe on every system, and never two the same."""

from __future__ import annotations

import re
import unicodedata
from collections.abc import Sequence

from variantgen.exam.sheets import Sheet

NAMINGS = ("code", "id", "name")

# Names that Windows keeps for its devices, whatever the ending is.
WINDOWS_DEVICES = ("con", "prn", "aux", "nul", *(f"{port}{digit}" for port in ("com", "lpt") for digit in range(1, 10)))
_LONGEST = 80  # bytes before the code; systems allow 255 for the whole name


def file_stem(sheet: Sheet, naming: str) -> str:
    """The name of the file of a sheet without its ending: ``7Q4-K2M``, or ``Ivanov-Ivan-7Q4-K2M``.

    ``naming`` is one of ``NAMINGS``: what of the student stands before the code.
    What is no letter, digit, dash or underscore becomes a dash. The code, which no two sheets share, is always the
    end: so names differ, and none is one that Windows keeps for its devices.
    """
    text = {"code": "", "id": sheet.student.id, "name": sheet.student.name}[naming]
    short = _plain(text)
    return f"{short}-{sheet.code}" if short else sheet.code


def file_names(texts: Sequence[str]) -> list[str]:
    """A name of a file without its ending for each text, no two the same in large or small letters."""
    found: list[str] = []
    taken = set(WINDOWS_DEVICES)
    for text in texts:
        short = _plain(text) or "-"
        name, number = short, 1
        while name.casefold() in taken:
            number += 1
            name = f"{short}-{number}"
        taken.add(name.casefold())
        found.append(name)
    return found


def _plain(text: str) -> str:
    """A text with dashes for what is no letter, digit, dash or underscore, shortened."""
    kept = "".join(letter if _is_plain(letter) else "-" for letter in unicodedata.normalize("NFC", text))
    return re.sub("-+", "-", kept).strip("-_").encode()[:_LONGEST].decode(errors="ignore").rstrip("-_")


def _is_plain(letter: str) -> bool:
    return letter in "-_" or unicodedata.category(letter) in {"Lu", "Ll", "Lt", "Lm", "Lo", "Nd"}
