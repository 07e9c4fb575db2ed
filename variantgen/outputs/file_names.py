"""Names of files for students: safe on every system, and never two the same."""

from __future__ import annotations

import re
import unicodedata

from variantgen.exam.sheets import Sheet

NAMINGS = ("code", "id", "name")

_LONGEST = 80  # bytes before the code; systems allow 255 for the whole name


def file_stem(sheet: Sheet, naming: str) -> str:
    """The name of the file of a sheet without its ending: ``7Q4-K2M``, or ``Ivanov-Ivan-7Q4-K2M``.

    ``naming`` is one of ``NAMINGS``: what of the student stands before the code.
    What is no letter, digit, dash or underscore becomes a dash. The code, which no two sheets share, is always the
    end: so names differ, and none is one that Windows keeps for its devices.
    """
    text = {"code": "", "id": sheet.student.id, "name": sheet.student.name}[naming]
    short = plain_part(text)
    return f"{short}-{sheet.code}" if short else sheet.code


def plain_part(text: str) -> str:
    """A text as part of a name of a file: letters and digits, with dashes between; perhaps nothing."""
    kept = "".join(letter if _is_plain(letter) else "-" for letter in unicodedata.normalize("NFC", text))
    return re.sub("-+", "-", kept).strip("-_").encode()[:_LONGEST].decode(errors="ignore").rstrip("-_")


def _is_plain(letter: str) -> bool:
    return letter in "-_" or unicodedata.category(letter) in {"Lu", "Ll", "Lt", "Lm", "Lo", "Nd"}
