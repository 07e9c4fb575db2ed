"""The finished parts of a build that is not finished, in a hidden folder beside the output: one can go on from there.

    .NAME.unfinished/
        plan.json           what is being built; a build goes on only from parts of the very same plan
        drawn/0000200-3     the fourth problem of the students from 200 on, as it was drawn first
        changed/0000012-3   that of a part (12 * 8 students on) in which somebody had to draw again
        settled.json        who had to draw again; all changed problems are there
        made/0000012*       pieces of the outputs; whole as soon as 0000012.json, their list, is there

Every file has its name only when it is whole.
"""

from __future__ import annotations

import hashlib
import json
import os
import shutil
from collections.abc import Iterator, Mapping, Sequence
from contextlib import contextmanager
from dataclasses import dataclass
from functools import lru_cache
from pathlib import Path
from typing import Any

from variantgen.builder.jobs import STUDENTS_PER_DRAW, Made
from variantgen.errors import InputError, Problem, VariantgenError
from variantgen.outputs.formats import STUDENTS_PER_PART

_PLAN, _SETTLED, _LOCK = "plan.json", "settled.json", "lock"


@dataclass(frozen=True)
class MadePart:
    """The pieces of a part: (format, target, file), and the families in it without worked solutions."""

    pieces: tuple[tuple[str, str, Path], ...]
    unexplained: tuple[str, ...]


def unfinished_folder(target: Path) -> Path:
    """Where the parts of an output are until it is finished."""
    target = target.resolve()
    return target.with_name(f".{target.name}.unfinished")


@contextmanager
def unfinished(target: Path, plan: Mapping[str, str], resume: bool) -> Iterator[Unfinished]:
    """The parts of a build, those of an earlier try too if it shall go on from them.

    They are removed when the block ends without an error, or with one that would come again (wrong input, say), and
    kept when it is interrupted. Raises InputError if another process is building the same output, or if there are
    parts of another plan to go on from.
    """
    folder, parts = unfinished_folder(target), None
    try:
        with _lock(folder, target):
            if resume:
                _compare(folder, plan)
            else:
                _empty(folder)
            parts = Unfinished(folder)
            parts.begin(plan)
            yield parts
    except VariantgenError as error:
        if parts and not error.may_pass:
            shutil.rmtree(folder, ignore_errors=True)
        raise
    except BaseException:
        if not any((folder / "drawn").glob("*")):
            shutil.rmtree(folder, ignore_errors=True)
        raise
    shutil.rmtree(folder, ignore_errors=True)


@contextmanager
def _lock(folder: Path, target: Path) -> Iterator[None]:
    """The folder for this process alone, where the system has locks that end with a process."""
    try:
        folder.mkdir(exist_ok=True)
    except OSError as error:
        raise InputError(Problem(f"cannot be made: {error.strerror}", key="--out", value=str(target))) from None
    with (folder / _LOCK).open("w") as file:
        try:
            import fcntl

            fcntl.flock(file, fcntl.LOCK_EX | fcntl.LOCK_NB)
        except ImportError:
            pass
        except OSError:
            remedy = "wait until it is done, or choose another folder"
            raise InputError(
                Problem("another build is making this folder now", key="--out", value=str(target), remedy=remedy)
            ) from None
        yield


def _empty(folder: Path) -> None:
    for path in folder.iterdir():
        if path.is_dir():
            shutil.rmtree(path)
        elif path.name != _LOCK:
            path.unlink()


def _compare(folder: Path, plan: Mapping[str, str]) -> None:
    """Raise InputError if the folder has parts of another plan."""
    try:
        before = json.loads((folder / _PLAN).read_text("utf-8"))
    except FileNotFoundError:
        return
    except ValueError:
        before = {}
    other = [name for name, value in plan.items() if before.get(name) != value]
    if other:
        raise InputError(
            Problem(
                f"the build that was interrupted had another {' and another '.join(other)}",
                key="--resume",
                value=str(folder),
                remedy="give it what it had, or leave --resume out to begin anew",
            )
        )


class Unfinished:
    """The folder of the parts."""

    def __init__(self, folder: Path) -> None:
        self.folder = folder
        self._framed = lru_cache(maxsize=8)(self._read_framed)

    def begin(self, plan: Mapping[str, str]) -> None:
        """Make what is not there yet."""
        for name in ("drawn", "changed", "made"):
            (self.folder / name).mkdir(exist_ok=True)
        if not self.is_settled:
            for path in (self.folder / "changed").iterdir():
                path.unlink()
        self._write(_PLAN, json.dumps(plan).encode())

    @property
    def is_settled(self) -> bool:
        """Whether nobody has to draw again."""
        return (self.folder / _SETTLED).exists()

    def settle(self, redrawn: Sequence[str], alike: Mapping[str, int], cut: int) -> None:
        """Note who had to draw again, how many sheets have data like others, and how many problems the exam's ceiling
        of tolerances has changed; all changed parts are there.
        """
        self._write(_SETTLED, json.dumps({"redrawn": list(redrawn), "alike": dict(alike), "cut": cut}).encode())

    def settled(self) -> tuple[tuple[str, ...], dict[str, int], int]:
        """What was noted."""
        found = json.loads((self.folder / _SETTLED).read_text("utf-8"))
        return tuple(found["redrawn"]), found["alike"], found["cut"]

    def has_drawn(self, start: int, problem: int) -> bool:
        """Whether a problem was drawn for the students from ``start`` on."""
        return (self.folder / _drawn(start, problem)).exists()

    def put_drawn(self, start: int, problem: int, parts: Sequence[bytes]) -> None:
        """Keep a problem as it was drawn first, by parts of the students."""
        self._write(_drawn(start, problem), b"".join(len(part).to_bytes(4, "big") + part for part in parts))

    def put_changed(self, part: int, problem: int, content: bytes) -> None:
        """Keep a problem of a part in which somebody drew again."""
        self._write(_changed(part, problem), content)

    def problem(self, part: int, problem: int) -> bytes:
        """A packed problem of a part as it is now."""
        changed = self.folder / _changed(part, problem)
        return changed.read_bytes() if changed.exists() else self.first(part, problem)

    def first(self, part: int, problem: int) -> bytes:
        """A packed problem of a part as it was drawn first."""
        inside = part * STUDENTS_PER_PART % STUDENTS_PER_DRAW
        return self._framed(part * STUDENTS_PER_PART - inside, problem)[inside // STUDENTS_PER_PART]

    def _read_framed(self, start: int, problem: int) -> list[bytes]:
        """A problem of the students from ``start`` on by parts."""
        content = (self.folder / _drawn(start, problem)).read_bytes()
        parts, place = [], 0
        while place < len(content):
            end = place + 4 + int.from_bytes(content[place : place + 4], "big")
            parts.append(content[place + 4 : end])
            place = end
        return parts

    def has_made(self, number: int) -> bool:
        """Whether the pieces of a part are there, as they were written."""
        try:
            files = {name: digest for *_, name, digest in self._listed(number)["pieces"]}
            return all(_digest((self.folder / "made" / name).read_bytes()) == files[name] for name in files)
        except (OSError, ValueError, KeyError, TypeError):
            return False

    def put_made(self, number: int, made: Made) -> None:
        """Keep the pieces of a part."""
        listed = []
        for k, (output, piece) in enumerate(made.pieces):
            name = f"{number:07}-{k:03}{piece.ending}"
            self._write(f"made/{name}", piece.content)
            listed.append([output, piece.target, name, _digest(piece.content)])
        told = {"pieces": listed, "unexplained": made.unexplained}
        self._write(f"made/{number:07}.json", json.dumps(told).encode())

    def made(self, number: int) -> MadePart:
        """The pieces of a part."""
        listed = self._listed(number)
        pieces = tuple((output, target, self.folder / "made" / name) for output, target, name, _ in listed["pieces"])
        return MadePart(pieces, tuple(listed["unexplained"]))

    def _listed(self, number: int) -> Any:
        return json.loads((self.folder / f"made/{number:07}.json").read_text("utf-8"))

    def _write(self, name: str, content: bytes) -> None:
        path = self.folder / name
        new = path.with_name(f"{path.name}.new")
        new.write_bytes(content)
        os.replace(new, path)  # noqa: PTH105  (Path.replace does the same and is slower)


def _digest(content: bytes) -> str:
    return hashlib.blake2b(content, digest_size=16).hexdigest()


def _drawn(start: int, problem: int) -> str:
    return f"drawn/{start:07}-{problem}"


def _changed(part: int, problem: int) -> str:
    return f"changed/{part:07}-{problem}"
