"""What a marking is made from, in ``marks/BUILD``: files that the command ``variantgen mark`` reads in the same order.

==============  ==================================================================
``review.csv``  what a person has read on scans where the program has doubts
``typed.csv``   answers that were typed in
``answers-N``   tables and scans as they were brought, numbered
``policy.toml`` what answers are worth, where it differs from the exam
``result/``     what the command has written
==============  ==================================================================

The names that files came with are only shown; they are kept in ``.studio/marks``.
"""

from __future__ import annotations

import csv
import io
import json
import re
import threading
from collections.abc import Mapping
from pathlib import Path

from variantgen.errors import InputError, Problem
from variantgen.exam.marking_policy import MarkingPolicy
from variantgen.marking.typed_number import read_number
from variantgen.outputs.files.records import safe_cell
from variantgen.studio.builds import FinishedBuild
from variantgen.studio.workspace import Workspace, write_whole

Asked = tuple[str, int, str]  # the code of the sheet, the number of the problem, the name of the quantity

TYPED, REVIEW, POLICY, RESULT = "typed.csv", "review.csv", "policy.toml", "result"
FILES = 40  # that may be brought
_ANSWERS = re.compile(r"answers-(\d{1,3})\.(xlsx|csv|pdf|png|jpg|tif)")
_HEADS = {TYPED: "answer", REVIEW: "reading"}
_BEGINNINGS = (
    (b"PK\x03\x04", "xlsx"), (b"%PDF", "pdf"), (b"\x89PNG", "png"), (b"\xff\xd8\xff", "jpg"), (b"II*\0", "tif"),
    (b"MM\0*", "tif"),
)  # fmt: skip


class MarkingFolder:
    """The files of one marking. Its methods raise InputError for links and for what cannot be read."""

    def __init__(self, workspace: Workspace, build: FinishedBuild) -> None:
        self._workspace, self.build = workspace, build
        self.lock = threading.Lock()  # of whoever changes a file by what it says
        self.path = workspace.folder / "marks" / build.folder.name
        for place in (self.path.parent, self.path, self.path / RESULT):
            if place.is_symlink():
                raise InputError(Problem("is a link", file=str(place), remedy="remove it"))

    def brought(self) -> list[Path]:
        """The files with answers that were brought, in the order in which they came."""
        found = [(int(match[1]), path) for path in self._own("answers-*") if (match := _ANSWERS.fullmatch(path.name))]
        return [path for _, path in sorted(found)]

    def every(self) -> list[Path]:
        """All files with answers in the order in which they count: of two answers to one question the first stands."""
        return [*(path for name in (REVIEW, TYPED) for path in self._own(name)), *self.brought()]

    def policy(self) -> Path | None:
        """The file with the rules; None without one."""
        return next(iter(self._own(POLICY)), None)

    def result(self) -> list[Path]:
        """The files that the command has written."""
        return [path for path in sorted((self.path / RESULT).glob("*")) if path.is_file() and not path.is_symlink()]

    def version(self) -> tuple[object, ...]:
        """What differs as soon as one of the files does."""
        paths = [self.build.folder / "manifest.json", *self.every(), *self._own(POLICY)]
        return tuple((path.name, path.stat().st_mtime_ns, path.stat().st_size) for path in paths)

    def next_path(self, beginning: bytes) -> Path:
        """Where a file that begins so is to be put. Raises InputError where there are too many."""
        known = self.brought()
        if len(known) >= FILES:
            raise InputError(Problem("there are too many files", remedy="remove some, or join them"))
        number = 1 + max((int(m[1]) for path in known if (m := _ANSWERS.fullmatch(path.name))), default=0)
        kind = next((kind for start, kind in _BEGINNINGS if beginning.startswith(start)), "csv")
        self.path.mkdir(parents=True, exist_ok=True)
        return self.path / f"answers-{number}.{kind}"

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

    def remove(self, name: str) -> None:
        """Take a file that was brought away. Raises InputError for another name."""
        path = next((path for path in self.brought() if path.name == name), None)
        if path is None:
            raise InputError(Problem("there is no such file", value=name[:40]))
        path.unlink()

    def written(self, name: str) -> dict[Asked, str]:
        """What ``typed.csv`` or ``review.csv`` says, by question."""
        found: dict[Asked, str] = {}
        for path in self._own(name):
            rows = csv.DictReader(io.StringIO(path.read_text("utf-8-sig"), newline=""))
            for row in rows:
                number, text = str(row.get("problem") or ""), str(row.get(_HEADS[name]) or "")
                if number.isascii() and number.isdigit() and len(number) < 4:
                    found[str(row.get("student")), int(number), str(row.get("quantity"))] = text.removeprefix("'")
        return found

    def write(self, name: str, entries: Mapping[Asked, str]) -> None:
        """Write ``typed.csv`` or ``review.csv``."""
        self.path.mkdir(parents=True, exist_ok=True)
        out = io.StringIO()
        writer = csv.writer(out, lineterminator="\n")
        writer.writerow(("student", "problem", "quantity", _HEADS[name]))
        writer.writerows((*asked, _cell(text)) for asked, text in entries.items() if text)
        write_whole(self.path / name, out.getvalue())

    def write_policy(self, policy: MarkingPolicy) -> None:
        """Write the rules."""
        self.path.mkdir(parents=True, exist_ok=True)
        write_whole(self.path / POLICY, policy_text(policy))

    @property
    def _names(self) -> Path:
        return self._workspace.state("marks", f"{self.build.key}.json")

    def _own(self, pattern: str) -> list[Path]:
        return [path for path in self.path.glob(pattern) if path.is_file() and not path.is_symlink()]


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
