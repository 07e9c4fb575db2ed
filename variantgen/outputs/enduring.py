"""A file for writers that do not survive an error: the first one is kept and raised when the writer has ended.

The library that writes joined PDFs ends the whole process if writing fails at its last step, on a full disk say.
"""

from __future__ import annotations

import io
from collections.abc import Iterator
from contextlib import contextmanager
from pathlib import Path
from typing import Any


@contextmanager
def enduring(path: Path) -> Iterator[io.RawIOBase]:
    """A file to be written inside the block. Raises OSError after the block if not all could be written."""
    with path.open("wb") as file:
        sink = _Enduring(file)
        yield sink
        if sink.error is None:
            sink.attempt(file.flush)
        if sink.error is not None:
            # What is still held back cannot be written either, and closing must not try and raise.
            sink.attempt(file.raw.close)
            raise sink.error


class _Enduring(io.RawIOBase):
    """Takes everything; after an error it lets what is written fall."""

    def __init__(self, file: Any) -> None:
        self._file = file
        self.error: OSError | None = None

    def attempt(self, action: Any) -> None:
        """Do something with the file and note an error."""
        try:
            action()
        except OSError as error:
            self.error = error

    def writable(self) -> bool:
        """It can be written to."""
        return True

    def write(self, data: Any) -> int:
        """Write, or let fall after an error."""
        size = len(data)
        if self.error is None:
            self.attempt(lambda: self._file.write(data))
        return size
