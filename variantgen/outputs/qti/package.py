"""Packages: archives with files made in parts, put together without holding them, the same bytes every time.

A piece is an archive of the files of a few students with an index, which says what they are.
"""

from __future__ import annotations

import io
import json
import zipfile
from collections.abc import Iterable, Iterator, Mapping
from contextlib import contextmanager
from pathlib import Path
from typing import Any

from variantgen.outputs.qti.outline import Outline

MANIFEST = "imsmanifest.xml"
_INDEX = "index.json"
_PACKED = (".png",)  # are compressed as they are
_DATE = (1980, 1, 1, 0, 0, 0)  # the first that an archive can have
_UNIX = 3


def pack(files: Mapping[str, bytes], index: Any) -> bytes:
    """A piece: files by name, and what is to be known of them when all pieces are put together."""
    out = io.BytesIO()
    with zipfile.ZipFile(out, "w") as archive:
        archive.writestr(_entry(_INDEX), json.dumps(index))
        for name, content in files.items():
            archive.writestr(_entry(name), content, compresslevel=1)  # for a short time
    return out.getvalue()


def indexes(pieces: Iterable[Path]) -> Iterator[Any]:
    """The index of each piece."""
    for path in pieces:
        with zipfile.ZipFile(path) as archive:
            yield json.loads(archive.read(_INDEX))


def names(pieces: Iterable[Path], folder: str = "") -> Iterator[str]:
    """The names of the files of all pieces that begin so, each once."""
    seen: set[str] = set()
    for path in pieces:
        with zipfile.ZipFile(path) as archive:
            found = [name for name in archive.namelist() if name.startswith(folder) and name != _INDEX]
        yield from (name for name in found if name not in seen)
        seen.update(found)


def contents(pieces: Iterable[Path], folder: str = "") -> Iterator[tuple[str, bytes]]:
    """The files of all pieces whose names begin so, each name once."""
    seen: set[str] = {_INDEX}
    for path in pieces:
        with zipfile.ZipFile(path) as archive:
            for name in archive.namelist():
                if name.startswith(folder) and name not in seen:
                    seen.add(name)
                    yield name, archive.read(name)


class Package:
    """An archive that is being written."""

    def __init__(self, archive: zipfile.ZipFile) -> None:
        self._archive = archive

    @contextmanager
    def outline(self, name: str) -> Iterator[Outline]:
        """A document of XML of any length."""
        with self._archive.open(_entry(name), "w", force_zip64=True) as file:
            outline = Outline(file)
            yield outline
            outline.close()

    def add(self, name: str, content: bytes) -> None:
        """A file."""
        self._archive.writestr(_entry(name), content)


@contextmanager
def package(path: Path) -> Iterator[Package]:
    """A package in a file."""
    with zipfile.ZipFile(path, "w") as archive:
        yield Package(archive)


def _entry(name: str) -> zipfile.ZipInfo:
    """A file of an archive, the same on every system and at any time."""
    entry = zipfile.ZipInfo(name, _DATE)
    entry.create_system = _UNIX
    entry.external_attr = 0o644 << 16
    entry.compress_type = zipfile.ZIP_STORED if name.endswith(_PACKED) else zipfile.ZIP_DEFLATED
    return entry
