"""The outputs of a build, one module per format, found by their names (``--format``, or ``formats`` in an exam file).

A module has

- ``HELP``, a line on what it makes; ``FILES``, the names or patterns of its files, which ``--force`` may replace;
- ``TARGETS``, a regular expression that the targets of all its pieces match, and nothing else;
- ``read_options(table)``, which reads the table of its name in an exam file (mistakes are noted in the table);
- ``check(exam, students)``: raises ToolMissingError or InputError before any work is done;
- ``make(part)``: what can be made of the content of a few students, as pieces;
- ``SUMMARIES``: pairs of a number of parts and a function that makes pieces of an overview of them, like a key;
- ``finish(whole)``: puts the pieces of all students together in the output folder;
- ``write_key``: a function that writes only those of its files that show tolerances, from the pieces of ``SUMMARIES``;
  None where all files do.

A module that makes several formats has them in ``FORMATS``, by their names, instead (``qti``).

``make`` and the functions of ``SUMMARIES`` run in any process; ``finish`` runs once, in the main one, and may have
others help it.
"""

from __future__ import annotations

import importlib
import re
from collections.abc import Callable, Iterable, Iterator, Sequence
from functools import partial
from pathlib import Path
from typing import Any, Protocol, cast

from msgspec import Struct, field

from variantgen.errors import InputError, Problem, nearest
from variantgen.exam import exam_file
from variantgen.exam.content import Content
from variantgen.exam.exam import Exam
from variantgen.exam.roster import Student
from variantgen.exam.sheets import Sheet
from variantgen.outputs.files.records import RECORDS
from variantgen.outputs.files.student_groups import GroupFiles, both_halves, by_group
from variantgen.outputs.run import Run
from variantgen.outputs.typst.typesetter import Typesetter
from variantgen.resources import module_names
from variantgen.tables import Table

_SEVERAL = {"qti": ("qti21", "qti30")}  # modules that make more formats than one
_MODULES = {name: module for module in module_names(__path__) for name in _SEVERAL.get(module, (module,))}
FORMATS = tuple(sorted(_MODULES))
COMMON = ("key.csv", "manifest.json")  # files of every build

# The engine remembers the layouts of its last documents. Five problems with all answers, the engine alone on sheets and
# key: parts of 16, 24, 40 sheets take 17.1, 16.8, 15.7 ms a student and 254, 305, 333 MB; parts of 8 take 20 % more
# than those of 16. The size does not depend on the number of processes: the same parts give the same bytes.
STUDENTS_PER_PART = 16
PARTS_PER_OVERVIEW = 3
STUDENTS_PER_OVERVIEW = STUDENTS_PER_PART * PARTS_PER_OVERVIEW


class Fragment(Struct, frozen=True):
    """Content made of a part of the students, the output that it belongs to, and the ending of its file's name."""

    target: str
    content: bytes
    ending: str = ""


class Chunk(Struct, frozen=True):
    """A few students of an exam; ``first`` says whether it is the first part.

    ``beginning`` are the groups whose first student is in it.
    """

    content: Content
    first: bool
    engine: Typesetter
    beginning: frozenset[str] = frozenset()

    @property
    def exam(self) -> Exam:
        """The exam."""
        return self.content.exam

    @property
    def sheets(self) -> tuple[Sheet, ...]:
        """The sheets of these students."""
        return self.content.sheets

    def key_parts(self, grouped: bool) -> list[tuple[Sequence[Sheet], bool]]:
        """These students, or those of each of their groups, and whether the document of a key begins with them."""
        if grouped:
            return [(own, group in self.beginning) for group, own in by_group(self.sheets).items()]
        return [(self.sheets, self.first)]


class WholeExam(Struct, frozen=True):
    """All students of an exam, the pieces of a format by target in the order of the students, the output folder.

    Where files are made for groups, a part has for each of its groups a piece, in the order of their names
    (:mod:`variantgen.outputs.files.student_groups`).

    ``finish`` may add ``notes``, which are messages for the user of the program, and to ``pages``: how many students
    have so many pages, by document. By ``run`` it may have work on files done by other processes.
    """

    exam: Exam
    sheets: Sequence[Sheet]
    folder: Path
    engine: Typesetter
    pieces: dict[str, list[Path]] = field(default_factory=dict)
    notes: list[str] = field(default_factory=list)
    pages: dict[str, dict[int, int]] = field(default_factory=dict)
    run: Run = map

    def of_groups(self, target: str, groups: GroupFiles) -> dict[str, list[Path]]:
        """The pieces of each group, of sheets, of solutions or of a key by student and by problem."""
        pieces = self.pieces[target]
        if target == "key":
            return both_halves(pieces, groups, STUDENTS_PER_OVERVIEW)
        return groups.of_students(pieces) if target == "solutions" else groups.of_parts(pieces, STUDENTS_PER_PART)


class Format(Protocol):
    """A module of this package, or one of the ``FORMATS`` of a module that makes several."""

    HELP: str
    FILES: tuple[str, ...]
    TARGETS: str
    SUMMARIES: tuple[tuple[int, Callable[[Chunk], Iterable[Fragment]]], ...]
    write_key: Callable[[WholeExam], None] | None

    def read_options(self, table: Table) -> Any:
        """The options of the format, of the table of its name in an exam file."""

    def check(self, exam: Exam, students: Sequence[Student]) -> None:
        """Raise ToolMissingError or InputError if the exam cannot be made for these students in this format."""

    def make(self, part: Chunk) -> Iterable[Fragment]:
        """Pieces of the documents of a few students."""

    def finish(self, whole: WholeExam) -> None:
        """The files in the output folder."""


def format_of(name: str) -> Format:
    """A format, loaded when it is asked for: to load all takes a fifth as long as to start a build."""
    module = importlib.import_module(f"{__name__}.{_MODULES[name]}")
    return cast(Format, module.FORMATS[name] if _MODULES[name] in _SEVERAL else module)


def chosen(names: Sequence[str], key: str = "formats") -> tuple[str, ...]:
    """Names of formats, each once, in the order of the alphabet. Raises InputError, which names the key."""
    if wrong := [name for name in names if name not in FORMATS]:
        raise InputError(
            Problem("unknown format", key=key, value=name, remedy=nearest(name, FORMATS)) for name in wrong
        )
    if not names:
        raise InputError(Problem("expected at least one format", key=key, remedy=nearest("", FORMATS)))
    return tuple(sorted(set(names)))


def is_target(name: object, target: object) -> bool:
    """Whether a format (or the records) makes pieces of a target; asked of what was read from a file."""
    if not (isinstance(name, str) and isinstance(target, str)):
        return False
    if name == RECORDS:
        return target in COMMON
    return name in FORMATS and re.fullmatch(format_of(name).TARGETS, target, re.DOTALL) is not None


def known_files(first: Sequence[str] = ()) -> Iterator[str]:
    """Names and patterns of all files that a build may have made, those of the formats named ``first`` before others.

    A format is loaded when its files are asked for.
    """
    yield from COMMON
    for name in dict.fromkeys((*first, *FORMATS)):
        yield from format_of(name).FILES


def read_exam(path: Path, folders: tuple[Path, ...] | None = None) -> Exam:
    """Read and check an exam file with the options of all formats. Raises InputError with every problem found."""
    return exam_file.read_exam(path, folders, chosen, _readers())


def parse_exam(text: str, path: Path, folders: tuple[Path, ...]) -> Exam:
    """The exam of the text of a file, as :func:`read_exam`; ``path`` is named in messages."""
    return exam_file.parse_exam(text, path, folders, chosen, _readers())


def _readers() -> dict[str, Callable[[Table], Any]]:
    return {name: partial(_read_options, name) for name in FORMATS}


def _read_options(name: str, table: Table) -> Any:
    return format_of(name).read_options(table)


def options(exam: Exam, name: str) -> Any:
    """The options of a format; those of an exam file without a table for it if none were read."""
    found = exam.options.get(name)
    return _read_options(name, Table({}, name, [])) if found is None else found
