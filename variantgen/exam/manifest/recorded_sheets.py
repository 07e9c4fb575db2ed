"""The sheets of students as the manifest has them."""

from __future__ import annotations

import pickle
import zlib
from collections.abc import Iterator, Mapping, Sequence
from typing import Any

from msgspec import Struct

from variantgen.exam import printable
from variantgen.exam.roster import Student
from variantgen.exam.sheets import is_code
from variantgen.methods.hand.work import Work
from variantgen.tables import Table


class RecordedAnswer(Struct, frozen=True):
    """An answer of the key: the name of its quantity, value and tolerance in the unit of that name."""

    quantity: str
    value: float
    unit: str
    tolerance: float


class RecordedProblem(Struct, frozen=True):
    """A variant as it was handed out; ``parameters`` are printed values with their units, or words with none."""

    number: int
    family: str
    form: str
    parameters: Mapping[str, tuple[str, str]]
    mirrored: bool
    quarter_turns: int
    attempt: int
    answers: tuple[RecordedAnswer, ...]
    work: Work | None = None

    @property
    def problem_type(self) -> str:
        """The family with its form: ``four_bar crank``."""
        return f"{self.family} {self.form}".strip()


class RecordedSheet(Struct, frozen=True):
    """The sheet of a student as it is recorded."""

    student: Student
    code: str
    problems: Sequence[RecordedProblem]


class PackedProblems(Sequence[RecordedProblem]):
    """Problems that take a tenth of their memory, so that those of a million students are in memory together.

    Reading one problem unpacks all: to go through them in turn is best.
    """

    def __init__(self, problems: tuple[RecordedProblem, ...]) -> None:
        self._packed = zlib.compress(pickle.dumps(problems), 1)

    def __len__(self) -> int:
        return len(self._problems())

    def __getitem__(self, place: Any) -> Any:
        """The problem at a place, or those of a slice."""
        return self._problems()[place]

    def __iter__(self) -> Iterator[RecordedProblem]:
        return iter(self._problems())

    def _problems(self) -> tuple[RecordedProblem, ...]:
        found: tuple[RecordedProblem, ...] = pickle.loads(zlib.decompress(self._packed))  # noqa: S301  (packed here)
        return found


def read_sheet(table: Table) -> RecordedSheet:
    """The sheet of an entry of the manifest; what is wrong with it is noted in the table."""
    student = Student(*(_name(table, key) for key in ("id", "name", "group")))
    problems = tuple(_problem(problem) for problem in table.tables("problems"))
    code = table.need("code", str, "")
    if not is_code(code):
        table.problem("expected the code of a sheet, like 7Q4-K2M: files are named by it", "code", code)
    table.finish()
    return RecordedSheet(student, code, PackedProblems(problems))


def _name(table: Table, key: str) -> str:
    """A name as class lists have it: nothing in it that cannot be seen."""
    text = table.need(key, str, "")
    table.problems += printable.problems(text, f"the {key}", table.key(key))
    return text


def _problem(table: Table) -> RecordedProblem:
    pose = table.table("pose")
    parameters = table.table("parameters")
    turns = pose.need("quarter_turns", int, 0)
    if turns not in range(4):
        pose.problem("expected 0 to 3", "quarter_turns", turns)
    attempt = table.need("attempt", int, 1)
    if attempt < 1:
        table.problem("expected 1 or more", "attempt", attempt)
    found = RecordedProblem(
        table.need("problem", int, 0),
        table.need("family", str, ""),
        table.need("form", str, ""),
        {name: _value(parameters.table(name)) for name in parameters.data},
        pose.need("mirrored", bool, False),
        turns,
        attempt,
        tuple(_answer(answer) for answer in table.tables("answers")),
        _work(table.table("work")),
    )
    table.expect("nice", "methods")
    table.finish()
    pose.finish()
    return found


def _value(table: Table) -> tuple[str, str]:
    found = table.need("value", str, ""), table.take("unit", str, "")
    table.finish()
    return found


def _answer(table: Table) -> RecordedAnswer:
    found = RecordedAnswer(
        table.need("quantity", str, ""),
        float(table.number("value", 0)),
        table.need("unit", str, ""),
        float(table.number("tolerance", 0)),
    )
    table.expect("relative_tolerance", "unnoticed")
    table.finish()
    return found


def _work(table: Table) -> Work | None:
    """The work of a variant; None where it is not recorded."""
    if not table.data:
        return None
    found = Work(*(table.need(name, int, 0) for name in Work.__struct_fields__))
    table.finish()
    return found
