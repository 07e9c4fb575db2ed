"""What is right: the answers of a finished exam as its manifest records them, to be looked up for each student."""

from __future__ import annotations

from collections.abc import Mapping
from decimal import Decimal
from functools import cached_property

from msgspec import Struct

from variantgen.errors import InputError, Problem, nearest
from variantgen.exam.manifest import Manifest, RecordedProblem
from variantgen.exam.sheets import Answer
from variantgen.exam.student_order import base
from variantgen.families.parameters.units import unit
from variantgen.families.quantities import split_name

_DIRECTIONLESS = Decimal(10) ** 15  # degrees: so large a number has no digits left that tell a direction


class Key(Struct, frozen=True, dict=True):
    """The key of a class; ``widening`` multiplies all tolerances."""

    record: Manifest
    widening: Decimal = Decimal(1)

    @cached_property
    def _answers(self) -> dict[tuple[int, int], list[Answer]]:
        return {}

    @cached_property
    def places(self) -> Mapping[int, Mapping[int, RecordedProblem]]:
        """The problems of each student, by the place of the student and the number of the problem."""
        return {
            i: {problem.number: problem for problem in sheet.problems} for i, sheet in enumerate(self.record.sheets)
        }

    @cached_property
    def asked(self) -> Mapping[int, frozenset[str]]:
        """The names of what a problem asks of any student, by its number."""
        found: dict[int, set[str]] = {}
        for sheet in self.record.sheets:
            for problem in sheet.problems:
                found.setdefault(problem.number, set()).update(answer.quantity for answer in problem.answers)
        return {number: frozenset(names) for number, names in sorted(found.items())}

    def answers(self, place: int, problem: int) -> list[Answer]:
        """The answers of a student to a problem, in the order of the sheet."""
        known = self._answers.get((place, problem))
        if known is None:
            known = self._answers[place, problem] = [
                Answer(split_name(a.quantity), unit(a.unit), a.value, float(Decimal(repr(a.tolerance)) * self.widening))
                for a in self.places[place][problem].answers
            ]
        return known

    @cached_property
    def _students(self) -> Mapping[str, frozenset[int]]:
        """The places of students by all that names them wholly: id, code with and without its dash, QR text, name."""
        found: dict[str, set[int]] = {}
        for place, sheet in enumerate(self.record.sheets):
            code = sheet.code.casefold()
            words = {
                sheet.student.id,
                code,
                code.replace("-", ""),
                f"variantgen:1:{self.record.exam_id}:{code}".casefold(),
            }
            for word in (*words, base(sheet.student.name), _sorted(sheet.student.name)):
                if word:
                    found.setdefault(word, set()).add(place)
        return {word: frozenset(places) for word, places in found.items()}

    def _named(self, word: str) -> frozenset[int]:
        ways = (word, word.casefold(), base(word), _sorted(word))
        return next((self._students[way] for way in ways if way in self._students), frozenset())

    def without_unknown_name(self, who: tuple[str, ...]) -> tuple[str, ...]:
        """The id alone, of an id and a name of which only the id is known: platforms spell names in their own way."""
        known = [bool(self._named(" ".join(text.split()))) for text in who]
        return who[:1] if known == [True, False] else who

    def student(self, who: tuple[str, ...]) -> int:
        """The place of the one student whom all these words name wholly. Raises InputError."""
        each = []
        for text in who:
            word = " ".join(text.split())
            each.append(self._named(word))
            if not each[-1]:
                remedy = nearest(word, (key for key in self._students if not key.startswith("variantgen:")))
                remedy = remedy if remedy.startswith("did") else "give the code of the sheet, the id or the whole name"
                message = "the exam has no such student"
                if (
                    word.casefold().startswith("variantgen:")
                    and f":{self.record.exam_id}:".casefold() not in word.casefold()
                ):
                    message, remedy = "the sheet is of another exam", "mark it with the folder of that exam"
                raise InputError(Problem(message, value=text, remedy=remedy))
        found = frozenset.intersection(*each)
        if not found:
            remedy = "correct the code, the id or the name"
            raise InputError(Problem("the words of this row name different students", remedy=remedy))
        if len(found) > 1:
            raise InputError(Problem(f"{len(found)} students have this name or code", remedy="add the code or the id"))
        return next(iter(found))

    def quantity(self, place: int, problem: int, name: str | int) -> tuple[str, str]:
        """The name of an asked quantity as the key has it, and '' or why there is none; a number is its place."""
        own = self.places[place].get(problem)
        if own is None:
            return "", "the sheet has no such problem: its problems are " + ", ".join(map(str, self.places[place]))
        names = [answer.quantity for answer in own.answers]
        if isinstance(name, int):
            return (names[name], "") if name < len(names) else ("", "the problem asks this student for less")
        plain = "".join(name.split())
        if plain in names:
            return plain, ""
        alike = [known for known in names if known.casefold() == plain.casefold()]
        if len(alike) == 1:
            return alike[0], ""
        return "", f"the problem asks this student for {', '.join(names)}; {nearest(plain, names)}"


def _sorted(name: str) -> str:
    """A name by which it is known in whatever order its parts stand."""
    return " ".join(sorted(base(name).split()))


def is_right(answer: Answer, value: float) -> bool:
    """Whether a value in the unit of the key is within the tolerance of an answer, its ends included."""
    typed = Decimal(repr(value))
    if answer.quantity.is_direction:  # whole turns do not change it
        if abs(typed) >= _DIRECTIONLESS:
            return False
        gap = (typed - Decimal(repr(answer.value))) % 360
        return min(abs(gap), 360 - abs(gap)) <= Decimal(repr(answer.tolerance))
    return any(low <= typed <= high for low, high in answer.exact_intervals)


def scale(answer: Answer) -> float:
    """By what deviations from an answer are measured: its size, for an angle a radian."""
    return answer.unit.from_si(1.0) if answer.quantity.is_angle else abs(answer.value)
