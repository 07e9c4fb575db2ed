"""The parts of a build that are finished, as any process on the same disk reads and writes them.

The folder is described in :mod:`variantgen.builder.unfinished`, whose process says what is done with it.
"""

from __future__ import annotations

import json
import re
from collections.abc import Callable, Collection, Sequence
from pathlib import Path
from typing import Any

from msgspec import Struct

from variantgen.builder.folder_lock import CHANGED, DRAWN, MADE, PIECE
from variantgen.builder.sealed import DamagedError, digest, digest_of, read, write
from variantgen.outputs.formats import STUDENTS_PER_PART, Fragment, is_target

# Variants of one problem that are drawn together share the price of a batch. Always the same number, so that numbers do
# not depend, in their last bit, on how the work was split.
STUDENTS_PER_DRAW = 12 * STUDENTS_PER_PART


class StoredChunk(Struct, frozen=True):
    """The pieces of a part: (format, target, file), and the families in it without worked solutions."""

    pieces: tuple[tuple[str, str, Path], ...]
    unexplained: tuple[str, ...]


class KeptParts(Struct, frozen=True):
    """The finished parts of some outputs (names of formats, and of the records) in a folder, sealed by a key."""

    folder: Path
    key: bytes
    outputs: Collection[str]

    def put_drawn(self, start: int, problem: int, parts: Sequence[bytes]) -> None:
        """Keep a problem as it was drawn first, by parts of the students from ``start`` on."""
        framed = b"".join(len(part).to_bytes(4, "big") + part for part in parts)
        write(self.folder, _drawn(start, problem), framed, self.key)

    def drawn(self, start: int, problem: int) -> list[bytes]:
        """A problem of the students from ``start`` on by parts. Raises DamagedError if it is not there."""
        content = read(self.folder, _drawn(start, problem), self.key)
        parts, place = [], 0
        while place < len(content):
            end = place + 4 + int.from_bytes(content[place : place + 4], "big")
            parts.append(content[place + 4 : end])
            place = end
        return parts

    def put_changed(self, part: int, problem: int, content: bytes) -> None:
        """Keep a problem of a part in which somebody drew again."""
        write(self.folder, _changed(part, problem), content, self.key)

    def changed(self, part: int, problem: int) -> bytes:
        """A problem of a part in which somebody drew again. Raises DamagedError if it is not there."""
        return read(self.folder, _changed(part, problem), self.key)

    def put_made(self, number: int, pieces: Sequence[tuple[str, Fragment]], unexplained: Sequence[str]) -> None:
        """Keep the pieces of a part by format."""
        listed = []
        for k, (output, piece) in enumerate(pieces):
            name = f"{number:07}-{k:03}{piece.ending}"
            write(self.folder, f"{MADE}/{name}", piece.content)
            listed.append([output, piece.target, name, digest(piece.content)])
        record = {"pieces": listed, "unexplained": list(unexplained)}
        write(self.folder, f"{MADE}/{number:07}.json", json.dumps(record).encode(), self.key)

    def has_made(self, number: int) -> bool:
        """Whether the pieces of a part are there, as they were written."""
        try:
            files = {name: digest for *_, name, digest in self._listed(number)["pieces"]}
            return all(digest_of(self.folder / MADE / name) == digest for name, digest in files.items())
        except (OSError, DamagedError):
            return False

    def made(self, number: int) -> StoredChunk:
        """The pieces of a part."""
        listed = self._listed(number)
        pieces = tuple((output, target, self.folder / MADE / name) for output, target, name, _ in listed["pieces"])
        return StoredChunk(pieces, tuple(listed["unexplained"]))

    def _listed(self, number: int) -> dict[str, Any]:
        """The list of the pieces of a part: with names as they are made here, and targets of the formats alone."""
        name = f"{MADE}/{number:07}.json"
        own = re.compile(rf"(?={number:07}-){PIECE}")
        return checked(
            read(self.folder, name, self.key),
            lambda found: (
                all(
                    own.fullmatch(file) and output in self.outputs and is_target(output, target)
                    for output, target, file, _ in found["pieces"]
                )
                and all(isinstance(family, str) for family in found["unexplained"])
            ),
            name,
        )


def checked(content: bytes, is_right: Callable[[dict[str, Any]], bool], name: str) -> dict[str, Any]:
    """What was read, if it is a table as it is written there. Raises DamagedError."""
    try:
        found = json.loads(content)
        if isinstance(found, dict) and is_right(found):
            return found
    except (LookupError, TypeError, ValueError, AttributeError, RecursionError):
        pass
    raise DamagedError(f"a part of the build is none of its own ({name}); --resume makes it again")


class KeptProblem(Struct, frozen=True):
    """A packed problem of a part where it is kept: as it was drawn first, or ``changed``."""

    kept: KeptParts
    part: int
    problem: int
    changed: bool

    def read(self) -> bytes:
        """The problem. Raises DamagedError if it is not there."""
        if self.changed:
            return self.kept.changed(self.part, self.problem)
        start, inside = among_drawn(self.part)
        return self.kept.drawn(start, self.problem)[inside]


def among_drawn(part: int) -> tuple[int, int]:
    """The first of the students who are drawn together with those of a part, and the place of the part among theirs."""
    inside = part * STUDENTS_PER_PART % STUDENTS_PER_DRAW
    return part * STUDENTS_PER_PART - inside, inside // STUDENTS_PER_PART


def _drawn(start: int, problem: int) -> str:
    return f"{DRAWN}/{start:07}-{problem}"


def _changed(part: int, problem: int) -> str:
    return f"{CHANGED}/{part:07}-{problem}"
