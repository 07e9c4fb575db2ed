"""A finished exam from its manifest: the exam, and every student's variants as they were handed out."""

from __future__ import annotations

import hashlib
from collections.abc import Callable, Iterable, Iterator, Mapping, Sequence
from decimal import Decimal, InvalidOperation
from functools import cached_property, lru_cache
from pathlib import Path

from msgspec import Struct
from msgspec.structs import replace

from variantgen.errors import InputError, Problem
from variantgen.exam.exam import Exam, ExamProblem, with_floors
from variantgen.exam.manifest import Manifest, RecordedProblem, RecordedSheet
from variantgen.exam.sections.solutions import NONE, Solutions
from variantgen.exam.sheets import Item, Sheet, answer_variants
from variantgen.families.parameters.parameter import Parameter
from variantgen.outputs.formats import parse_exam
from variantgen.variants.variant import Variant

_KEPT = 1000  # students whose variants are kept


class Finished(Struct, frozen=True, dict=True):
    """A finished exam. ``differences`` say what it was made with and is not as it was then."""

    record: Manifest
    exam: Exam
    differences: tuple[str, ...]

    def variants(self, sheets: Iterable[RecordedSheet]) -> Iterator[list[Variant]]:
        """The variants of each of some sheets. Raises InputError with every problem found, after the last of them.

        Those of a whole class are never in memory together, unless somebody keeps them.
        """
        problems: list[Problem] = []
        for sheet in sheets:
            found = [_variant(self.exam, problem, where, problems) for where, problem in _placed(sheet)]
            yield [variant for variant in found if variant is not None]
        if problems:
            raise InputError(problem.located(str(self.record.path)) for problem in problems)

    def variant(self, place: int, number: int) -> Variant:
        """The variant of a student, by the place of the student and the number of the problem. Raises InputError."""
        return self._variants_of(place)[number]

    @cached_property
    def _variants_of(self) -> Callable[[int], dict[int, Variant]]:
        """The variants of a student by number; of some students they are kept, for they are asked for many times."""

        def of(place: int) -> dict[int, Variant]:
            sheet = self.record.sheets[place]
            (own,) = self.variants([sheet])
            return dict(zip((problem.number for problem in sheet.problems), own, strict=True))

        return lru_cache(maxsize=_KEPT)(of)

    def sheets(self, places: Sequence[int], marked: bool = False) -> tuple[Sheet, ...]:
        """The sheets of some students, by their places, with answers computed anew.

        ``marked``: with the mistakes that go unnoticed in answers, which only a key shows.
        """
        chosen = [self.record.sheets[i] for i in places]
        recorded = [sheet.problems for sheet in chosen]
        restored = list(self.variants(chosen))
        tasks = [[_task(self.exam, problem) for problem in problems] for problems in recorded]
        flat = [variant for own in restored for variant in own]
        every = [task for own in tasks for task in own]
        tolerances = [self.exam.tolerance_of(task) for task in every]
        answers = iter(answer_variants(flat, [task.ask for task in every], tolerances, marked))
        return tuple(
            Sheet(
                sheet.student,
                sheet.code,
                tuple(
                    Item(task, variant, next(answers), problem.work)
                    for task, variant, problem in zip(own, variants, problems, strict=True)
                ),
            )
            for sheet, problems, variants, own in zip(chosen, recorded, restored, tasks, strict=True)
        )


def restore(record: Manifest, folders: tuple[Path, ...]) -> Finished:
    """The exam of a manifest; ``folders`` hold the instructor's own families. Raises InputError."""
    if hashlib.sha256(record.exam_text.encode()).hexdigest()[:16] != record.exam_hash:
        remedy = "the manifest has been changed since the build; restore it from a copy"
        raise InputError(
            Problem("the exam file does not have its hash", file=str(record.path), key="exam.text", remedy=remedy)
        )
    if record.composed:
        from variantgen.exam.composed_pools import folder_of  # figures and methods, which no other exam needs here

        folders = (*folders, folder_of(record.composed))
    exam = parse_exam(record.exam_text, record.path.with_name("exam.toml"), folders)
    options: Mapping[str, str] = record.solutions or {"depth": NONE}
    known = {name: value for name, value in options.items() if name in Solutions.__struct_fields__}
    exam = replace(
        exam,
        seed=record.seed,
        solutions=Solutions(**known, true_scale=exam.solutions.true_scale),
        formats=record.formats or exam.formats,
        tolerance=record.tolerance,
    )
    exam = with_floors(exam, record.floors)
    return Finished(record, exam, tuple(record.differences(exam)))


def restore_unchanged(record: Manifest, folders: tuple[Path, ...]) -> Finished:
    """The exam of a manifest by which marks are given or a key is written, see :func:`restore`.

    Raises InputError too if the entries of its students are not as they were built: a wrong answer could not be told
    from the right one.
    """
    if record.students_changed:
        what = "the students have been changed since the build"
        remedy = "variantgen verify  says more; restore it from a copy, or build the exam again"
        raise InputError(Problem(what, file=str(record.path), key="students", remedy=remedy))
    return restore(record, folders)


def _placed(sheet: RecordedSheet) -> list[tuple[str, RecordedProblem]]:
    """Problems with words that say whose they are."""
    return [(f"student {sheet.student.id}, problem {problem.number}", problem) for problem in sheet.problems]


def _task(exam: Exam, problem: RecordedProblem) -> ExamProblem:
    return next(task for task in exam.tasks if task.number == problem.number)


def _variant(exam: Exam, problem: RecordedProblem, where: str, problems: list[Problem]) -> Variant | None:
    """The variant of a record; what does not belong to the exam is noted."""
    task = next((task for task in exam.tasks if task.number == problem.number), None)
    family = next((f for f in task.families if f.name == problem.family), None) if task else None
    form = family.forms.get(problem.form) if family else None
    if family is None or form is None:
        value = f"{problem.family} {problem.form}".strip()
        problems.append(Problem("the exam has no such problem, family or form", key=where, value=value))
        return None
    printed: dict[str, Decimal] = {}
    for name, parameter in form.parameters.items():
        found = _printed(parameter, *problem.parameters.get(name, ("", "")))
        if found is None:
            problems.append(Problem("no such value of the parameter", key=where, value=_told(name, problem)))
        else:
            printed[name] = found
    for name in sorted(problem.parameters.keys() - form.parameters.keys()):
        problems.append(Problem("no such parameter", key=where, value=_told(name, problem)))
    if len(printed) < len(form.parameters):
        return None
    return Variant(family, form, printed, -1 if problem.mirrored else 1, problem.quarter_turns, problem.attempt)


def _told(name: str, problem: RecordedProblem) -> str:
    return f"{name} = {' '.join(problem.parameters[name])}" if name in problem.parameters else f"{name} is missing"


def _printed(parameter: Parameter, text: str, unit: str) -> Decimal | None:
    """The printed value of a parameter, of a choice the number behind the word; None if it cannot be."""
    if unit != (parameter.unit.name if parameter.unit else ""):
        return None
    if parameter.unit is None:
        return parameter.printed[parameter.words.index(text)] if text in parameter.words else None
    try:
        value = Decimal(text)
    except InvalidOperation:
        return None
    return value if value.is_finite() and value in parameter.printed else None
