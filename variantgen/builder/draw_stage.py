"""The first stages of a build: all problems are drawn, and those that are not distinct are drawn again."""

from __future__ import annotations

from collections.abc import Callable, Iterator, Mapping, Sequence
from typing import Any

import numpy as np
from msgspec.structs import replace

from variantgen.builder.build_spec import BuildSpec
from variantgen.builder.jobs import CompareJob, DrawJob
from variantgen.builder.kept import STUDENTS_PER_DRAW
from variantgen.builder.unfinished import Unfinished
from variantgen.builder.workers import Workers, run_and_keep
from variantgen.exam.allocation import (
    DrawRequest,
    HandedOutSheet,
    ProblemSampler,
    near_duplicates_of,
    next_draws_of,
    redrawn_of,
    resolve_duplicates,
)
from variantgen.exam.exam import Exam
from variantgen.exam.packing import pack, unpack
from variantgen.exam.roster import Student
from variantgen.exam.sheets import Item
from variantgen.outputs.formats import STUDENTS_PER_PART
from variantgen.variants.draw import check_room
from variantgen.variants.similarity import Traits

Progress = Callable[[str, int, int], None]


def draw_all(
    exam: Exam,
    students: Sequence[Student],
    spec: BuildSpec,
    parts: Unfinished,
    workers: Workers,
    progress: Progress,
    standing: Sequence[HandedOutSheet] = (),
) -> None:
    """Draw everything that was not drawn before, apart from what is ``standing``.

    Raises InputError where a problem leaves too few valid variants.
    """
    requests, drawer = _AllRequests(exam, students), ProblemSampler(exam)
    if parts.has_drawn_all([(start, problem) for start, problem, _ in requests.batches()]):
        return
    check_room([drawer.drawing(request) for request in requests])
    drawer.bands()  # before there are processes: these begin with what is known in this one
    first, cut = _first(drawer, requests, spec, parts, workers, progress)

    def more(owners: Sequence[int], used: Sequence[int]) -> Traits:
        again = [replace(requests[i], used=done) for i, done in zip(owners, used, strict=True)]
        found = dict(workers.run(spec, ((k, CompareJob(chosen)) for k, chosen in _batches(again))))
        return Traits.joined([found[k] for k in sorted(found)])

    drawn_marks = resolve_duplicates(drawer, requests, first, more, standing)
    _change(exam, next_draws_of(requests, drawn_marks), spec, parts, workers)
    parts.mark_drawn(redrawn_of(requests, drawn_marks), near_duplicates_of(drawer, requests, drawn_marks.alike), cut)


class _AllRequests(Sequence[DrawRequest]):
    """The problems of all students, student by student, made when they are asked for."""

    def __init__(self, exam: Exam, students: Sequence[Student]) -> None:
        self.students, self.problems = students, len(exam.tasks)

    def __len__(self) -> int:
        return len(self.students) * self.problems

    def __getitem__(self, place: Any) -> Any:
        """The request at a place."""
        student, problem = divmod(place, self.problems)
        return DrawRequest(self.students[student], problem)

    def batches(self) -> Iterator[tuple[int, int, list[int]]]:
        """What is drawn together, one problem of many students: the first student, the problem, places of requests."""
        count = len(self.students)
        for start in range(0, count, STUDENTS_PER_DRAW):
            for problem in range(self.problems):
                own = range(start, min(start + STUDENTS_PER_DRAW, count))
                yield start, problem, [student * self.problems + problem for student in own]


def _first(
    drawer: ProblemSampler,
    requests: _AllRequests,
    spec: BuildSpec,
    parts: Unfinished,
    workers: Workers,
    progress: Progress,
) -> tuple[Traits, int]:
    """Traits of the first draws of all requests, in order, and how many of them the exam's ceiling changed."""
    found: list[Traits] = []
    cut = 0
    order: list[int] = []
    todo: dict[tuple[int, int], list[int]] = {}
    for start, problem, places in requests.batches():
        if parts.has_drawn(start, problem):
            kept, changed = _kept(drawer, parts, start, problem, [requests[i] for i in places])
            found.append(kept)
            cut += changed
            order += places
        else:
            todo[start, problem] = places
    progress("drawing variants", len(order) // requests.problems, len(requests.students))
    jobs = ((place, DrawJob(tuple(requests[i] for i in places))) for place, places in todo.items())
    for place, compared in run_and_keep(workers, spec, parts.kept, jobs):
        found.append(compared.traits)
        cut += compared.cut
        order += todo[place]
        progress("drawing variants", len(order) // requests.problems, len(requests.students))
    return Traits.joined(found).take(np.argsort(np.array(order))), cut


def _kept(
    drawer: ProblemSampler, parts: Unfinished, start: int, problem: int, requests: Sequence[DrawRequest]
) -> tuple[Traits, int]:
    """What is compared of a problem that was drawn before, and how many the exam's ceiling has changed."""
    chosen = range(start // STUDENTS_PER_PART, -(-(start + len(requests)) // STUDENTS_PER_PART))
    items = [item for part in chosen for item in unpack(drawer.exam, parts.first(part, problem))]
    variants = [item.variant for item in items]
    return drawer.traits(requests, variants), drawer.cut(requests, variants)


def _change(exam: Exam, again: Mapping[int, DrawRequest], spec: BuildSpec, parts: Unfinished, workers: Workers) -> None:
    """Put the next draws of requests, by their places, in the place of the first ones."""
    places, items = list(again), list[Item]()
    drawn = dict(workers.run(spec, ((k, DrawJob(chosen)) for k, chosen in _batches(list(again.values())))))
    for k in sorted(drawn):
        items += [item for part in drawn[k].parts for item in unpack(exam, part)]
    changes: dict[tuple[int, int], dict[int, Item]] = {}
    for place, item in zip(places, items, strict=True):
        student, problem = divmod(place, len(exam.tasks))
        part, inside = divmod(student, STUDENTS_PER_PART)
        changes.setdefault((part, problem), {})[inside] = item
    for (part, problem), own in changes.items():
        first = unpack(exam, parts.first(part, problem))
        parts.put_changed(part, problem, pack(exam, [own.get(i, item) for i, item in enumerate(first)]))


def _batches(requests: Sequence[DrawRequest]) -> Iterator[tuple[int, tuple[DrawRequest, ...]]]:
    """What is drawn together of some requests, with the place of the first one."""
    return ((k, tuple(requests[k : k + STUDENTS_PER_DRAW])) for k in range(0, len(requests), STUDENTS_PER_DRAW))
