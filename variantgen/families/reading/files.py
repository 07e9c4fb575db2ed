"""The files of a family: ``family.toml``, ``cases.toml`` and a statement for each language, and nothing else.

What else lies in the folder is not read, does not travel to workers and has no part in the hash. Links are refused:
what they lead to is not of the family.
"""

from __future__ import annotations

import hashlib
import os
from fnmatch import fnmatchcase
from pathlib import Path

from variantgen.errors import InputError, Problem
from variantgen.limits import FAMILY_FILES, TOML_BYTES
from variantgen.tables import read_limited

FAMILY = "family.toml"
CASES = "cases.toml"
_KNOWN = (FAMILY, CASES, "statement.*.j2")


def is_file_of_family(name: str) -> bool:
    """Whether a file of this name in the folder of a family is one of its files."""
    return Path(name).name == name and any(fnmatchcase(name, known) for known in _KNOWN)


def check_files(folder: Path) -> list[Path]:
    """The files of a family, sorted by name. Raises InputError for links and for what is no file."""
    with os.scandir(folder) as entries:
        names = sorted(entry.name for entry in entries if is_file_of_family(entry.name))
    if len(names) > FAMILY_FILES:
        remedy = "leave out statements of languages that nobody uses"
        message = f"expected at most {FAMILY_FILES} files of a family"
        raise InputError(Problem(message, file=str(folder), value=str(len(names)), remedy=remedy))
    found = [folder / name for name in names]
    if problems := [problem for path in found if (problem := _problem(path))]:
        raise InputError(problems)
    return found


def _problem(path: Path) -> Problem | None:
    """What is wrong with a file before it is opened."""
    if path.is_symlink():
        return Problem("a file of a family may not be a link", file=str(path), remedy="copy the file to this place")
    if not path.is_file():
        return Problem("expected a file", file=str(path), remedy="remove what lies there under this name")
    return None


def family_files(folder: Path) -> dict[str, bytes]:
    """The content of the files of a family by name. Raises InputError."""
    return {path.name: read_limited(path, TOML_BYTES) for path in check_files(folder)}


def family_hash(folder: Path) -> str:
    """Hash (16 hex digits) of the names and bytes of the files of a family. Raises InputError."""
    digest = hashlib.sha256()
    for name, content in family_files(folder).items():
        digest.update(name.encode() + b"\0")
        digest.update(hashlib.sha256(content).digest())
    return digest.hexdigest()[:16]
