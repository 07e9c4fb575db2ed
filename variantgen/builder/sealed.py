"""Files of parts: written whole, and read only if they are as they were written.

A sealed file begins with a line that is a digest of a key, the name of the file and the rest of it.
"""

from __future__ import annotations

import hashlib
import hmac
import os
from pathlib import Path
from typing import Any

from variantgen.builder.folder_lock import NEW
from variantgen.errors import VariantgenError

_LARGEST = 1 << 28  # bytes of a sealed file, a hundred times what they have
# Systems without one of these have no links, or no ends of lines of their own.
_CAREFULLY = getattr(os, "O_NOFOLLOW", 0) | getattr(os, "O_BINARY", 0) | getattr(os, "O_CLOEXEC", 0)


class DamagedError(VariantgenError):
    """A part is not there as it was written."""

    may_pass = True


def write(folder: Path, name: str, content: bytes, key: bytes | None = None) -> None:
    """Write a file, sealed if there is a key; it has its name when all of it is written, and if sealed on the disk.

    To wait for the disk takes some milliseconds: there are few sealed files, and what others have lost is seen.
    """
    path = folder / name
    new = path.with_name(f"{path.name}{NEW}")
    with open(new, "wb", opener=_opened) as file:
        if key is not None:
            file.write(_seal(name, content, key))
        file.write(content)
        if key is not None:
            file.flush()
            os.fsync(file.fileno())
    os.replace(new, path)  # noqa: PTH105  (Path.replace does the same and is slower)


def read(folder: Path, name: str, key: bytes) -> bytes:
    """The content of a sealed file. Raises DamagedError if it is not as it was written."""
    try:
        with open(folder / name, "rb", opener=_opened) as file:
            seal, content = file.readline(200), file.read(_LARGEST)
    except OSError as error:
        raise DamagedError(f"a part of the build cannot be read ({name}): {error.strerror}") from None
    if not hmac.compare_digest(seal, _seal(name, content, key)):
        raise DamagedError(f"a part of the build is damaged ({name}); --resume makes it again")
    return content


def digest(content: bytes) -> str:
    """A digest of the content of a file that is not sealed."""
    return hashlib.blake2b(content, digest_size=16).hexdigest()


def digest_of(path: Path) -> str:
    """A digest of a file on the disk. Raises OSError if it cannot be read, or is a link."""
    with open(path, "rb", opener=_opened) as file:
        return hashlib.file_digest(file, _hash).hexdigest()


def _hash() -> Any:
    return hashlib.blake2b(digest_size=16)


def _opened(path: str, flags: int) -> int:
    """Open a file of this user alone, and not through a link."""
    return os.open(path, flags | _CAREFULLY, 0o600)


def _seal(name: str, content: bytes, key: bytes) -> bytes:
    """The first line of a file."""
    made = hashlib.blake2b(f"{name}\n".encode(), key=key, digest_size=16)
    made.update(content)
    return f"{made.hexdigest()}\n".encode()
