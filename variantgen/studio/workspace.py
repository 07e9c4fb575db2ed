"""The folder of the studio: which exams lie in it, and where its own things are.

Addresses have keys of files that were found here, never parts of paths. Nothing is followed out of the folder: what is
a symbolic link is left alone.
"""

from __future__ import annotations

import hashlib
import os
import re
import tempfile
import tomllib
from collections.abc import Callable
from pathlib import Path

from msgspec import Struct

from variantgen.errors import InputError, Problem
from variantgen.limits import TOML_BYTES
from variantgen.tables import read_limited, read_text

STATE = ".studio"
ROSTER = "roster.csv"
BUILDS = "builds"
MANIFEST = "manifest.json"
USUAL_CLASS = 30  # numbered variants where there is no roster
# Words that begin the addresses of other things than exams.
_TAKEN = frozenset(
    ("static", "figure", "events", "author", "play", "motion", "exams", "language", "stars", "example", "families")
) | {BUILDS}
_KEY = re.compile(r"[A-Za-z0-9][A-Za-z0-9_-]{0,39}")
_NAME = re.compile(r"[^\W_][\w ()-]{0,59}", re.UNICODE)
_PROBLEM = re.compile(r"^\s*\[\[\s*problem\s*\]\]", re.MULTILINE)


class Workspace(Struct, frozen=True):
    """A folder with exams, which lie beside families, rosters and builds."""

    folder: Path

    def __post_init__(self) -> None:
        if not self.folder.is_dir():
            raise InputError(Problem("is no folder", file=str(self.folder), remedy="make it, or choose another one"))
        if (self.folder / STATE).is_symlink():
            raise InputError(Problem("is a link", file=str(self.folder / STATE), remedy="remove it"))

    def exams(self) -> dict[str, Path]:
        """The exam files by their keys, in the order of their names."""
        found: dict[str, Path] = {}
        for path in sorted(self.folder.glob("*.toml")):
            if is_own(path, self.folder) and _is_exam(path):
                found[_key(path.stem, found)] = path
        return found

    def roster(self) -> Path | None:
        """The class list, if there is one. Raises InputError for a link."""
        path = self.folder / ROSTER
        if path.is_symlink():
            raise InputError(Problem("is a link", file=str(path), remedy="put the file itself here"))
        return path if path.is_file() else None

    def unreadable(self) -> dict[str, str]:
        """The TOML files that cannot be read, by their names, with the reason."""
        found = {}
        for path in sorted(self.folder.glob("*.toml")):
            try:
                if is_own(path, self.folder):
                    read_text(path)
            except InputError as error:
                found[path.name] = error.problems[0].message
        return found

    def families_option(self) -> list[str]:
        """What tells commands on builds where the families of the folder are; nothing where it has none."""
        return ["--families", str(self.folder)] if any(self.folder.glob("*/family.toml")) else []

    def state(self, *parts: str) -> Path:
        """A place for what the studio itself keeps; its folder is made. Parts are keys and names of the program.

        Raises InputError where a part of it is a link.
        """
        path = self.folder / STATE
        for part in parts:
            path.mkdir(exist_ok=True)
            path = path / part
            if path.is_symlink() or path.parent.is_symlink():
                raise InputError(Problem("is a link", file=str(path), remedy="remove it"))
        return path

    def new_exam_path(self, title: str) -> Path:
        """Where an exam of a title can be put: a name that no file has yet. Raises InputError."""
        name = "-".join(title.split())[:60] or "exam"
        if not _NAME.fullmatch(name):
            name = "".join(letter for letter in name if letter.isalnum() or letter in "-_ ") or "exam"
            name = name.lstrip("-_ ") or "exam"
        for number in range(1, 1000):
            path = self.folder / f"{name if number == 1 else f'{name}-{number}'}.toml"
            if not path.exists() and not path.is_symlink():
                return path
        raise InputError(Problem("there are too many exams of this name", value=title, remedy="choose another name"))


def is_own(path: Path, folder: Path) -> bool:
    """Whether a path is a file that lies in a folder, not a link to somewhere else, nor below one."""
    return path.is_file() and path.resolve() == folder.resolve() / path.relative_to(folder)


def write_whole(path: Path, content: str | bytes, compare: Callable[[], None] = lambda: None) -> None:
    """Write a file so that it is there whole or as it was: a temporary file beside it takes its place.

    ``compare`` is called last and may raise where the file must not be replaced after all.
    """
    data = content.encode() if isinstance(content, str) else content
    handle, name = tempfile.mkstemp(dir=path.parent, prefix=f".{path.name}.", suffix=".part")
    try:
        with os.fdopen(handle, "wb") as file:
            file.write(data)
            file.flush()
            os.fsync(file.fileno())
        if path.exists():
            Path(name).chmod(path.stat().st_mode & 0o777)
        else:
            Path(name).chmod(0o644 & ~_umask())
        compare()
        os.replace(name, path)  # noqa: PTH105  # as in the other places that write whole files
    except BaseException:
        Path(name).unlink(missing_ok=True)
        raise


def _umask() -> int:
    mask = os.umask(0)
    os.umask(mask)
    return mask


def _is_exam(path: Path) -> bool:
    """Whether a TOML file is an exam, be it one with mistakes, and no family or scene."""
    try:
        text = read_limited(path, TOML_BYTES).decode("utf-8-sig")
    except (InputError, OSError, UnicodeDecodeError):
        return False
    try:
        content = tomllib.loads(text)
    except (tomllib.TOMLDecodeError, RecursionError, ValueError):
        return _PROBLEM.search(text) is not None
    return isinstance(content.get("problem"), list) or {"title", "language"} <= content.keys()


def _key(stem: str, taken: dict[str, Path]) -> str:
    """The key of a file: its name if an address can have that, else a hash of it."""
    if _KEY.fullmatch(stem) and stem not in _TAKEN and stem not in taken:
        return stem
    return "exam-" + hashlib.sha256(stem.encode()).hexdigest()[:8]
