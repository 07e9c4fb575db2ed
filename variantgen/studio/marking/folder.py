"""What a marking is made from, in ``marks/BUILD``: files that the command ``variantgen mark`` reads in the same order.

==============  ==================================================================
``review.csv``  what a person has read on scans where the program has doubts
``typed.csv``   answers that were typed in
``answers-N``   tables and scans as they were brought, numbered
``policy.toml`` what answers are worth, where it differs from the exam
``result/``     what the command has written; readings typed into its ``review.csv`` count
``bin/``        files that were removed or replaced
==============  ==================================================================

Another program may write ``typed.csv`` and ``review.csv`` in any way that a table of answers can have. The studio never
rewrites such a file: it becomes ``typed-1.csv``, say, which counts right behind the new ``typed.csv``.

The names that files came with are only shown; they are kept in ``.studio/marks``.
"""

from __future__ import annotations

import csv
import hashlib
import io
import json
import re
import threading
from collections.abc import Collection, Mapping
from pathlib import Path

from variantgen.errors import InputError, Problem
from variantgen.exam.sections.marking_policy import MarkingPolicy
from variantgen.marking.typed_number import read_number
from variantgen.outputs.files.records import safe_cell
from variantgen.studio.building.builds import FinishedBuild
from variantgen.studio.workspace import Workspace, write_whole

Asked = tuple[str, int, str]  # the code of the sheet, the number of the problem, the name of the quantity

TYPED, REVIEW, POLICY, RESULT, BIN = "typed.csv", "review.csv", "policy.toml", "result", "bin"
FILES = 40  # that may be brought
_NUMBERED = re.compile(r"(?:answers|typed|review)-(\d{1,6})\.(?:xlsx|csv|pdf|png|jpg|tif)", re.ASCII)
_KEPT = re.compile(r"(\d{1,6})-(\w[\w.-]*)", re.ASCII)  # in the bin: a number, the name before
_HEADS = {TYPED: "answer", REVIEW: "reading"}
_BEGINNINGS = (
    (b"PK\x03\x04", "xlsx"), (b"%PDF", "pdf"), (b"\x89PNG", "png"), (b"\xff\xd8\xff", "jpg"), (b"II*\0", "tif"),
    (b"MM\0*", "tif"),
)  # fmt: skip


class MarkingFolder:
    """The files of one marking. Its methods raise InputError for links and for what cannot be read."""

    def __init__(self, workspace: Workspace, build: FinishedBuild) -> None:
        self._workspace, self.build = workspace, build
        self.lock = threading.RLock()  # of whoever changes a file by what it says
        self.path = workspace.folder / "marks" / build.folder.name
        self._refuse_links()

    def _refuse_links(self) -> None:
        """Raise InputError where a folder of the marking has become a link."""
        for place in (self.path.parent, self.path, self.path / RESULT, self.path / BIN):
            if place.is_symlink():
                raise InputError(Problem("is a link", file=str(place), remedy="remove it"))

    def brought(self) -> list[Path]:
        """The files with answers that were brought or set aside, in the order in which they count."""
        return [*self._aside(REVIEW), *self._aside(TYPED), *self._numbered("answers")]

    def every(self) -> list[Path]:
        """All files with answers in the order in which they count: of two answers to one question the first stands."""
        self._refuse_links()
        own = [path for name in (REVIEW, TYPED) for path in (*self._own(name), *self._aside(name))]
        return [*own, *self._numbered("answers"), *self._own(f"{RESULT}/{REVIEW}")]

    def policy(self) -> Path | None:
        """The file with the rules; None without one."""
        return next(iter(self._own(POLICY)), None)

    def result(self) -> list[Path]:
        """The files that the command has written."""
        return [path for path in sorted((self.path / RESULT).glob("*")) if path.is_file() and not path.is_symlink()]

    def version(self) -> tuple[object, ...]:
        """What differs as soon as one of the files does."""
        paths = [self.build.folder / "manifest.json", *self.every(), *self._own(POLICY)]
        return tuple(_stamp(path) for path in paths)

    def next_path(self, beginning: bytes) -> Path:
        """Where a file that begins so is to be put. Raises InputError where there are too many."""
        self._refuse_links()
        if len(self.brought()) >= FILES:
            raise InputError(Problem("there are too many files", remedy="remove some, or join them"))
        kind = next((kind for start, kind in _BEGINNINGS if beginning.startswith(start)), "csv")
        self.path.mkdir(parents=True, exist_ok=True)
        return self.path / f"answers-{self._next('answers')}.{kind}"

    def names(self) -> dict[str, str]:
        """The names that files came with, by those that they have here."""
        try:
            found = json.loads(self._names.read_text("utf-8"))
        except (OSError, ValueError, RecursionError):
            return {}
        return {str(key): str(text) for key, text in found.items()} if isinstance(found, dict) else {}

    def name(self, path: Path, given: str) -> None:
        """Note the name that a file came with."""
        write_whole(self._names, json.dumps({**self.names(), path.name: given[:200]}, ensure_ascii=False))

    def remove(self, name: str) -> str:
        """Put a file into the bin, and return its name there. Raises InputError for what is no file of a marking."""
        self._refuse_links()
        with self.lock:
            path = self._file(name)
            if path is None:
                raise InputError(Problem("there is no such file", value=name[:40]))
            home = self.path / BIN
            home.mkdir(exist_ok=True)
            number = 1 + max((int(kept[1]) for old in home.iterdir() if (kept := _KEPT.fullmatch(old.name))), default=0)
            path.rename(home / f"{number}-{name}")
            return f"{number}-{name}"

    def digest(self, name: str) -> str:
        """The SHA-256 of a file of the marking; '' where there is none, or only the head of a table of the studio."""
        path = self._file(name)
        if path is None or (name in _HEADS and path.read_bytes() == _table(name, {}).encode()):
            return ""
        with path.open("rb") as file:
            return hashlib.file_digest(file, "sha256").hexdigest()

    def _file(self, name: str) -> Path | None:
        own = [path for known in (TYPED, REVIEW, POLICY) for path in self._own(known)]
        return next((path for path in (*self.brought(), *own) if path.name == name), None)

    def binned(self) -> list[tuple[str, str]]:
        """The files in the bin, the newest first: their names there and those that they had before."""
        names = self.names()
        found = [match for path in self._own(f"{BIN}/*") if (match := _KEPT.fullmatch(path.name))]
        found.sort(key=lambda match: -int(match[1]))
        return [(match[0], names.get(match[2], match[2])) for match in found]

    def restore(self, kept: str) -> str:
        """Take a file out of the bin; what has its place goes there: its name there, or ''.

        Raises InputError for another name.
        """
        found, path = _KEPT.fullmatch(kept), self.path / BIN / kept
        self._refuse_links()
        with self.lock:
            if found is None or not path.is_file() or path.is_symlink():
                raise InputError(Problem("there is no such file", value=kept[:40]))
            other = self.remove(found[2]) if self._own(found[2]) else ""
            path.rename(self.path / found[2])
            return other

    def written(self, name: str, asked: Collection[Asked]) -> dict[Asked, str]:
        """What the studio has written into ``typed.csv`` or ``review.csv``, by question; ``asked`` are all of them.

        A file that another program has written is set aside: it is read as tables are, and nothing of it is lost.
        """
        for path in self._own(name):
            content = path.read_bytes()
            entries = _entries(content)
            if content == _table(name, entries).encode() and all(question in asked for question in entries):
                return entries
            stem = path.stem
            other = self.path / f"{stem}-{self._next(stem)}.csv"
            path.rename(other)
            self.name(other, name)
        return {}

    def write(self, name: str, entries: Mapping[Asked, str]) -> None:
        """Write ``typed.csv`` or ``review.csv``."""
        self._refuse_links()
        self.path.mkdir(parents=True, exist_ok=True)
        write_whole(self.path / name, _table(name, entries))

    def forget(self, asked: Asked, typed: str) -> str:
        """Empty a reading in the ``review.csv`` that the command has written, if it is ``typed`` or that is ''.

        The command repeats what was typed before, so that it would stand for ever. Returns the reading; '' for none.
        """
        for path in self._own(f"{RESULT}/{REVIEW}"):
            try:
                text = path.read_bytes().decode("utf-8-sig")
                mark = ";" if ";" in text.partition("\n")[0] else ","
                head, *rows = csv.reader(io.StringIO(text, newline=""), delimiter=mark)
                columns = [head.index(name) for name in ("student", "problem", "quantity", "reading")]
            except (ValueError, csv.Error):
                continue  # whoever has written it takes it out
            own = [row for row in rows if len(row) == len(head) and [row[n] for n in columns[:3]] == [*map(str, asked)]]
            said = {row[columns[3]].removeprefix("'") for row in own} - {""}
            if len(said) == 1 and (not typed or said == {typed}):
                for row in own:
                    row[columns[3]] = ""
                out = io.StringIO()
                csv.writer(out, delimiter=mark, lineterminator="\r\n").writerows([head, *rows])
                write_whole(path, out.getvalue().encode("utf-8-sig"))
                return said.pop()
        return ""

    def write_policy(self, policy: MarkingPolicy) -> str:
        """Write the rules; returns the name in the bin of those that they replace, '' where there were none."""
        self._refuse_links()
        self.path.mkdir(parents=True, exist_ok=True)
        kept = self.remove(POLICY) if self._own(POLICY) else ""
        write_whole(self.path / POLICY, policy_text(policy))
        return kept

    @property
    def _names(self) -> Path:
        return self._workspace.state("marks", f"{self.build.key}.json")

    def _own(self, pattern: str) -> list[Path]:
        return [path for path in self.path.glob(pattern) if path.is_file() and not path.is_symlink()]

    def _numbered(self, stem: str) -> list[Path]:
        """The files ``stem-1``, ``stem-2``, ... in the order of their numbers."""
        found = [(int(match[1]), path) for path in self._own(f"{stem}-*") if (match := _NUMBERED.fullmatch(path.name))]
        return [path for _, path in sorted(found)]

    def _aside(self, name: str) -> list[Path]:
        """What was set aside of ``typed.csv`` or ``review.csv``, the newest first."""
        return self._numbered(Path(name).stem)[::-1]

    def _next(self, stem: str) -> int:
        """A number that no such file has or, in the bin, has had."""
        names = [path.name for path in self._own(f"{stem}-*")]
        names += [path.name.partition("-")[2] for path in self._own(f"{BIN}/*-{stem}-*")]
        return 1 + max((int(match[1]) for name in names if (match := _NUMBERED.fullmatch(name))), default=0)


def _stamp(path: Path) -> tuple[object, ...]:
    """What differs as soon as a file does; one may be taken away meanwhile, as where marks are written again."""
    try:
        found = path.stat()
    except FileNotFoundError:
        return (path.name,)
    return path.name, found.st_mtime_ns, found.st_size


def _entries(content: bytes) -> dict[Asked, str]:
    """The answers of a file that the studio has written, by question; of another one whatever is alike."""
    try:
        rows = [row for row in csv.reader(io.StringIO(content.decode(), newline="")) if len(row) == 4]
    except (UnicodeDecodeError, csv.Error):
        return {}
    return {
        (student, int(number), quantity): text.removeprefix("'")
        for student, number, quantity, text in rows
        if number.isascii() and number.isdigit() and len(number) < 4
    }


def _table(name: str, entries: Mapping[Asked, str]) -> str:
    """The text of ``typed.csv`` or ``review.csv``."""
    out = io.StringIO()
    writer = csv.writer(out, lineterminator="\n")
    writer.writerow(("student", "problem", "quantity", _HEADS[name]))
    writer.writerows((*asked, _cell(text)) for asked, text in entries.items() if text)
    return out.getvalue()


def policy_text(policy: MarkingPolicy) -> str:
    """Rules as their file says them."""
    tables: dict[str, dict[str, str]] = {}
    lines = []
    for key, value in policy.entries():
        table, _, name = key.partition(".")
        if name:
            tables.setdefault(table, {})[name] = f"{value}"
        elif isinstance(value, str):
            lines.append(f"{key} = {json.dumps(value.split(', '))}")
        else:
            lines.append(f"{key} = {value}")
    for table, own in tables.items():
        inner = ", ".join(f"{json.dumps(name, ensure_ascii=False)} = {value}" for name, value in own.items())
        lines.append(f"{table} = {{ {inner} }}")
    return "\n".join(lines) + "\n"


def _cell(text: str) -> str:
    """A text that no spreadsheet runs; a number, be it negative, stays one."""
    return text if read_number(text) or text in ("-", "+") else str(safe_cell(text))
