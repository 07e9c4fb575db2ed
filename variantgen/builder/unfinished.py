"""The finished parts of a build that is not finished, in a hidden folder beside the output: one can go on from there.

    .NAME.unfinished/
        plan.json           what is being built; a build goes on only from parts of the very same plan
        drawn/0000200-3     the fourth problem of the students from 200 on, as it was drawn first
        changed/0000012-3   that of a part (12 * 8 students on) in which somebody had to draw again
        settled.json        who had to draw again, and which problems of parts are changed
        made/0000012*       pieces of the outputs; whole as soon as 0000012.json, their list, is there

Problems and pieces are written by the process that has made them, if it has this disk. Every file has its name only
when it is whole. All but the pieces begin with a line that is a digest of the plan, the name of the file and the rest
of it; the list of pieces has their digests. What is damaged, or of another plan, is as if it were not there.
"""

from __future__ import annotations

import hashlib
import json
from collections.abc import Collection, Iterator, Mapping, Sequence
from contextlib import contextmanager
from functools import lru_cache
from pathlib import Path
from typing import Any

from variantgen.builder.folder_lock import (
    CHANGED,
    DRAWN,
    DRAWN_MARKS,
    FOLDERS,
    NEW,
    PLAN,
    empty,
    locked_folder,
)
from variantgen.builder.kept import KeptParts, KeptProblem, among_drawn, checked
from variantgen.builder.sealed import DamagedError, read, write
from variantgen.errors import InputError, Problem, VariantgenError

_NO_KEY = b""  # of the plan itself


def unfinished_folder(target: Path) -> Path:
    """The hidden folder of the parts of an output that is not finished."""
    target = target.resolve()
    return target.with_name(f".{target.name}.unfinished")


@contextmanager
def unfinished(target: Path, plan: Mapping[str, str], resume: bool, outputs: Collection[str]) -> Iterator[Unfinished]:
    """The parts of a build of some outputs, those of an earlier try too if it shall go on from them.

    They are removed when the block ends without an error, or with one that would come again (wrong input, say), and
    kept when it is interrupted. Raises InputError if another process is building the same output, if there are
    parts of another plan to go on from, or if what is there are no parts.
    """
    folder = unfinished_folder(target)
    with locked_folder(folder, target):
        parts = Unfinished(folder, plan, outputs)
        if resume:
            parts.check_plan(folder)
        else:
            empty(folder)
        try:
            parts.begin()
            yield parts
        except VariantgenError as error:
            if not error.may_pass:
                empty(folder)
            raise
        except BaseException:
            if not any((folder / DRAWN).glob("*")):
                empty(folder)
            raise
        empty(folder)


class Unfinished:
    """The folder of the parts of a plan; ``outputs`` are the names of its formats, and of the records.

    ``kept`` is what other processes may read and write of it.
    """

    def __init__(self, folder: Path, plan: Mapping[str, str], outputs: Collection[str]) -> None:
        self.folder = folder
        self._plan = dict(plan)
        self._key = hashlib.blake2b(json.dumps(self._plan, sort_keys=True).encode(), digest_size=32).digest()
        self.kept = KeptParts(folder, self._key, tuple(outputs))
        self._changed: set[tuple[int, int]] = set()
        self._framed = lru_cache(maxsize=8)(self.kept.drawn)

    def check_plan(self, folder: Path) -> None:
        """Raise InputError if the parts that are there are those of another plan.

        Where the plan is damaged, each part still tells whether it is of this one.
        """
        try:
            before = checked(read(self.folder, PLAN, _NO_KEY), lambda found: True, PLAN)
        except DamagedError:
            return
        other = [name for name, value in self._plan.items() if before.get(name) != value]
        if other:
            raise InputError(
                Problem(
                    f"the build that was interrupted had another {' and another '.join(other)}",
                    key="--resume",
                    value=str(folder),
                    remedy="give it what it had, or leave --resume out to begin anew",
                )
            )

    def begin(self) -> None:
        """Make what is not there yet."""
        write(self.folder, PLAN, json.dumps(self._plan).encode(), _NO_KEY)
        for name in FOLDERS:
            (self.folder / name).mkdir(exist_ok=True)
            for path in (self.folder / name).glob(f"*{NEW}"):
                path.unlink()

    def has_drawn_all(self, drawn: Collection[tuple[int, int]]) -> bool:
        """Whether nobody has to draw again, and all that was drawn is there: problems of the students from a start on.

        If not, what was changed is forgotten: it follows from the first draws.
        """
        try:
            self._changed = {(part, problem) for part, problem in self._read_marks()["changed"]}
            for part, problem in self._changed:
                self.problem(part, problem)
        except DamagedError:
            whole = False
        else:
            whole = all(self.has_drawn(start, problem) for start, problem in drawn)
        if not whole:
            self._changed.clear()
            (self.folder / DRAWN_MARKS).unlink(missing_ok=True)
            for path in (self.folder / CHANGED).iterdir():
                path.unlink()
        return whole

    def mark_drawn(self, redrawn: Sequence[str], alike: Mapping[str, int], cut: int) -> None:
        """Note who had to draw again, how many sheets have data like others, and how many problems the exam's ceiling
        of tolerances has changed; all changed parts are there.
        """
        record = {"redrawn": list(redrawn), "alike": dict(alike), "cut": cut, "changed": sorted(self._changed)}
        write(self.folder, DRAWN_MARKS, json.dumps(record).encode(), self._key)

    def drawn_marks(self) -> tuple[tuple[str, ...], dict[str, int], int]:
        """The marks that :meth:`mark_drawn` has written."""
        found = self._read_marks()
        return tuple(found["redrawn"]), found["alike"], found["cut"]

    def _read_marks(self) -> dict[str, Any]:
        return checked(
            read(self.folder, DRAWN_MARKS, self._key),
            lambda found: (
                all(isinstance(one, str) for one in found["redrawn"])
                and all(isinstance(number, int) for number in (*found["alike"].values(), found["cut"]))
                and all(isinstance(number, int) for place in found["changed"] for number in place)
            ),
            DRAWN_MARKS,
        )

    def has_drawn(self, start: int, problem: int) -> bool:
        """Whether a problem was drawn for the students from ``start`` on."""
        try:
            self._framed(start, problem)
        except DamagedError:
            return False
        return True

    def put_changed(self, part: int, problem: int, content: bytes) -> None:
        """Keep a problem of a part in which somebody drew again."""
        self.kept.put_changed(part, problem, content)
        self._changed.add((part, problem))

    def problem(self, part: int, problem: int) -> bytes:
        """A packed problem of a part as it is now."""
        if (part, problem) in self._changed:
            return self.kept.changed(part, problem)
        return self.first(part, problem)

    def kept_problem(self, part: int, problem: int) -> KeptProblem:
        """Where a packed problem of a part is."""
        return KeptProblem(self.kept, part, problem, (part, problem) in self._changed)

    def first(self, part: int, problem: int) -> bytes:
        """A packed problem of a part as it was drawn first."""
        start, inside = among_drawn(part)
        return self._framed(start, problem)[inside]
