"""The students of a class table, and the questions that only the instructor can answer.

=============  ==================================================================  =======================
question       is asked of                                                         answers
=============  ==================================================================  =======================
``twice``      a row whose id an earlier row has                                   ``one``, ``two`` people
``no_id``      a row without an id                                                 ``named``, ``skip``
``no_name``    a row without a name                                                ``skip``
``unseen``     a row with characters that cannot be printed                        ``clean``, ``skip``
``same``       an id that the last build does not have, of somebody whom it knows  ``same``, ``new``
=============  ==================================================================  =======================
"""

from __future__ import annotations

import csv
import io
from collections.abc import Iterator, Mapping, Sequence
from difflib import SequenceMatcher

from msgspec import Struct, field
from msgspec.structs import replace

from variantgen.exam import printable
from variantgen.exam.roster import Student
from variantgen.exam.roster.columns import Columns
from variantgen.exam.roster.reading import name_and_group
from variantgen.exam.student_order import base
from variantgen.letters import unseen
from variantgen.studio.roster.table import ClassTable, Tab

ANSWERS: Mapping[str, tuple[str, ...]] = {
    "twice": ("one", "two"),
    "no_id": ("named", "skip"),
    "no_name": ("skip",),
    "unseen": ("clean", "skip"),
    "same": ("same", "new"),
}
_ALIKE = 0.85  # of two names, from which on they may be the same misspelt


class RowQuestion(Struct, frozen=True):
    """What is asked of a row (by its tab and number) or of an id; ``key`` is that of its answer."""

    key: str
    kind: str
    text: str
    row: tuple[int, int] = (-1, -1)
    before: Student | None = None
    now: Student | None = None


class ClassReading(Struct, frozen=True):
    """The students of a table, what is asked, the rows that are left out, the tabs without a column for names."""

    students: tuple[Student, ...]
    questions: tuple[RowQuestion, ...]
    left: frozenset[tuple[int, int]]
    nameless: tuple[int, ...]
    groups: Mapping[str, int] = field(default_factory=dict)

    @property
    def is_ready(self) -> bool:
        """Whether it can be used as it is."""
        return bool(self.students) and not self.questions and not self.nameless


def read_students(table: ClassTable, before: Sequence[Student] = ()) -> ClassReading:
    """The students of a table; ``before`` are those of the last build, whose ids are kept."""
    used = [(place, tab) for place, tab in enumerate(table.tabs) if tab.used]
    nameless = tuple(place for place, tab in used if not {"name", "surname", "first"} & set(tab.kinds))
    reading = _Reading(table.answers)
    for place, tab in used:
        if place not in nameless:
            reading.read(place, tab, len(used) > 1)
    reading.keep_ids(before)
    groups: dict[str, int] = {}
    for student in reading.students:
        groups[student.group] = groups.get(student.group, 0) + 1
    return ClassReading(tuple(reading.students), tuple(reading.questions), frozenset(reading.left), nameless, groups)


def roster_csv(students: Sequence[Student]) -> str:
    """The class list as a build reads it."""
    out = io.StringIO()
    writer = csv.writer(out, lineterminator="\n")
    writer.writerow(("id", "name", "group"))
    writer.writerows((student.id, student.name, student.group) for student in students)
    return out.getvalue()


class _Reading:
    def __init__(self, answers: Mapping[str, str]) -> None:
        self._answers = answers
        self._seen: set[str] = set()
        self.students: list[Student] = []
        self.questions: list[RowQuestion] = []
        self.left: set[tuple[int, int]] = set()

    def read(self, place: int, tab: Tab, several: bool) -> None:
        """The students of a worksheet."""
        columns = Columns({kind: column for column, kind in enumerate(tab.kinds) if kind}, 0, (), ())
        for number, cells in tab.rows[tab.begin :]:
            row = place, number
            found = {kind: cells[column] for kind, column in columns.places.items() if column < len(cells)}
            group = found.get("group", "") if "group" in tab.kinds or not several else tab.title
            student = Student(found.get("id", ""), columns.name(cells), group)
            if not student.name and not student.id:
                self.left.add(row)
                continue
            kept = self._mended(row, student, "id" in tab.kinds)
            if kept is None:
                self.left.add(row)
            else:
                self._seen.add(kept.id)
                self.students.append(kept)

    def _mended(self, row: tuple[int, int], student: Student, with_id: bool) -> Student | None:
        """A student as the answers have it; None for one who is left out. What is not answered is asked."""
        if any(printable.problems(text, "", "") for text in (student.id, student.name, student.group)):
            letters = "".join(unseen(student.id + student.name + student.group, ""))
            answer = self._answer("unseen", row, ", ".join(f"U+{ord(letter):04X}" for letter in letters))
            if answer == "skip":
                return None
            student = Student(*(_clean(text) for text in (student.id, student.name, student.group)))
        if not student.name:
            self._answer("no_name", row, student.id)
            return None
        if not with_id:
            student = replace(student, id=name_and_group(student))
        elif not student.id:
            if self._answer("no_id", row, student.name) == "skip":
                return None
            student = replace(student, id=name_and_group(student))
        if student.id in self._seen:
            if self._answer("twice", row, student.id) != "two":
                return None
            own = student.id
            number = 2
            while (student := replace(student, id=f"{own} [{number}]")).id in self._seen:
                number += 1
        return student

    def _answer(self, kind: str, row: tuple[int, int], text: str) -> str:
        """The answer to a question of a row; it is asked where there is none."""
        key = f"row:{row[0]}:{row[1]}:{kind}"
        answer = self._answers.get(key, "")
        if answer not in ANSWERS[kind]:
            self.questions.append(RowQuestion(key, kind, text, row))
            return ""
        return answer

    def keep_ids(self, before: Sequence[Student]) -> None:
        """Give students the ids that they had in the last build, where it is said that they are the same."""
        known = {student.id: student for student in before}
        gone = {own: student for own, student in known.items() if own not in self._seen}
        if not gone:
            return
        new = [place for place, student in enumerate(self.students) if student.id not in known]
        for place, old in _pairs([(place, self.students[place]) for place in new], list(gone.values())):
            now, key = self.students[place], f"id:{self.students[place].id}"
            answer = self._answers.get(key, "")
            if answer == "same":
                self.students[place] = replace(now, id=old.id)
            elif answer != "new":
                self.questions.append(RowQuestion(key, "same", now.id, before=old, now=now))


def _pairs(new: Sequence[tuple[int, Student]], gone: Sequence[Student]) -> Iterator[tuple[int, Student]]:
    """Who of the new ones may be one of those who are gone: by the same name, else by a close one in the group."""
    left = list(gone)
    open_ = list(new)
    for alike in (_is_named_the_same, _is_named_alike):
        for place, student in list(open_):
            found = [old for old in left if alike(student, old)]
            if len(found) == 1:
                left.remove(found[0])
                open_.remove((place, student))
                yield place, found[0]


def _is_named_the_same(one: Student, other: Student) -> bool:
    return bool(one.name) and sorted(base(one.name).split()) == sorted(base(other.name).split())


def _is_named_alike(one: Student, other: Student) -> bool:
    if not one.name or not other.name or one.group != other.group:
        return False
    return SequenceMatcher(None, base(one.name), base(other.name)).ratio() >= _ALIKE


def _clean(text: str) -> str:
    """A text without what cannot be printed."""
    wrong = unseen(text, "")
    return " ".join("".join(" " if letter in wrong else letter for letter in text).split())[: printable.MOST]
