"""Files that somebody has worked in since they were made: they are kept whatever replaces the output.

A manifest has the hashes of all files of its output. What has another one, or none, is somebody's work, and is moved
into a folder of its own: ``edited/1``, ``edited/2``, ... inside the output.
"""

from __future__ import annotations

import hashlib
import json
import os
import shutil
import zipfile
import zlib
from collections.abc import Collection, Iterator, Mapping
from pathlib import Path, PurePosixPath

from variantgen.exam.manifest import NAME
from variantgen.tables import read_limited

EDITED = "edited"
_MEANT = (".xlsx", ".tex")  # endings of files that are there to be edited
_MAX_BYTES = 2_000_000_000
_SHOWN = 5  # names in a message


def file_hash(path: Path) -> str:
    """SHA-256 of a file."""
    with path.open("rb") as file:
        return hashlib.file_digest(file, "sha256").hexdigest()


def keep_edited(old: Path, new: Path, names: Collection[str] | None = None) -> str:
    """Move what was edited in the output ``old`` into a new folder ``edited/N`` of the output ``new``.

    The manifest, which says what the files belong to, is copied there too. ``old`` and ``new`` may be one folder of
    which only some files, by their ``names``, are about to be replaced; else what was kept in ``old`` before goes
    along. Nothing is ever moved onto something else. Returns a message for the user, empty if nothing was edited.
    """
    if old != new and _is_folder(old / EDITED):
        for kept in sorted((old / EDITED).iterdir(), key=lambda path: (len(path.name), path.name)):
            kept.rename(_free(new / EDITED))
    changed = [name for name in changed_files(old) if names is None or name in names]
    if not changed:
        return ""
    folder = _free(new / EDITED)
    folder.mkdir()
    if (old / NAME).is_file() and NAME not in changed:
        shutil.copyfile(old / NAME, folder / NAME)
    for name in changed:
        (folder / name).parent.mkdir(parents=True, exist_ok=True)
        (old / name).rename(folder / name)
    more = f" and {len(changed) - _SHOWN} more" if len(changed) > _SHOWN else ""
    return f"changed since they were made, and kept in {folder}: {', '.join(changed[:_SHOWN])}{more}"


def changed_files(folder: Path) -> list[str]:
    """The files of an output that are not as its manifest has them, by their paths; all if there is no manifest."""
    recorded = recorded_hashes(folder)
    return [
        name for name in _names(folder) if not (name == NAME and recorded) and not _is(folder / name, recorded, name)
    ]


def recorded_hashes(folder: Path) -> Mapping[str, str]:
    """What the manifest of an output has of its files; nothing if it cannot be read."""
    if not (folder / NAME).is_file():  # a pipe would have no end
        return {}
    try:
        content = read_limited(folder / NAME, _MAX_BYTES)
        head, students, _ = content.partition(b'\n "students": [')  # no string has an end of line in it
        found = json.loads(head + students + b"]}" if students else content)["files"]
    except (OSError, ValueError, LookupError, TypeError, RecursionError):
        return {}
    return found if isinstance(found, dict) else {}


def is_meant(folder: Path, name: str, changed: Collection[str]) -> bool:
    """Whether a file that was changed is there to be edited, and still is what its name says.

    That are workbooks, LaTeX sources, and PDFs that were made again of such a source.
    """
    if name.endswith(".xlsx"):
        return _is_workbook(folder / name)
    source = PurePosixPath(name).with_suffix(".tex").as_posix()
    return name.endswith(_MEANT) or (name.endswith(".pdf") and source in changed)


def _is_workbook(path: Path) -> bool:
    try:
        with zipfile.ZipFile(path) as file:
            return file.testzip() is None and "[Content_Types].xml" in file.namelist()
    except (OSError, zipfile.BadZipFile, zlib.error, ValueError, NotImplementedError, RuntimeError, EOFError):
        return False


def _names(folder: Path) -> Iterator[str]:
    """All that is below a folder and no folder, but for what was kept before; links are not followed."""
    for top, folders, files in os.walk(folder):
        if Path(top) == folder and EDITED in folders:
            folders.remove(EDITED)
        links = [name for name in folders if (Path(top) / name).is_symlink()]
        yield from sorted((Path(top) / name).relative_to(folder).as_posix() for name in (*files, *links))


def _is(path: Path, recorded: Mapping[str, str], name: str) -> bool:
    """Whether a file is as it was recorded; one that cannot be read is not."""
    try:
        return name in recorded and path.is_file() and file_hash(path) == recorded[name]
    except OSError:
        return False


def _is_folder(path: Path) -> bool:
    return path.is_dir() and not path.is_symlink()


def _free(folder: Path) -> Path:
    """The first name 1, 2, ... in a folder that is not taken; the folder is made."""
    folder.mkdir(exist_ok=True)
    number = 1
    while os.path.lexists(folder / str(number)):
        number += 1
    return folder / str(number)
