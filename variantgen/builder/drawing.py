"""The first stages of a build: all problems are drawn, and those that are not distinct are drawn again."""

from __future__ import annotations

from collections.abc import Callable, Sequence
from dataclasses import replace
from typing import Any

from variantgen.builder.carried import Carried
from variantgen.builder.jobs import STUDENTS_PER_DRAW, WISHES_PER_DRAW, Draw, DrawMore, Redraw
from variantgen.builder.unfinished import Unfinished
from variantgen.builder.workers import Workers
from variantgen.exam.assembly import Drawer, Wish, again_of, alike_of, keep_apart, redrawn_of, traits_of
from variantgen.exam.blueprint import Exam
from variantgen.exam.packing import pack, unpack_items, unpack_sheets
from variantgen.exam.roster import Student
from variantgen.exam.sheets import Item, variant_codes
from variantgen.outputs.formats import STUDENTS_PER_PART
from variantgen.variants.draw import check_room
from variantgen.variants.likeness import Traits

Progress = Callable[[str, int, int], None]


def draw_all(
    exam: Exam,
    students: Sequence[Student],
    carried: Carried,
    parts: Unfinished,
    workers: Workers,
    progress: Progress,
) -> None:
    """Draw everything that was not drawn before. Raises InputError where a problem leaves too few valid variants."""
    if parts.is_settled:
        return
    wishes, drawer = _Wishes(exam, students), Drawer(exam, carried.seed)
    check_room([drawer.drawing(wish) for wish in wishes])
    first = _first(exam, students, carried, parts, workers, progress)

    def more(owners: Sequence[int], used: Sequence[int]) -> Traits:
        again = [replace(wishes[i], used=done) for i, done in zip(owners, used, strict=True)]
        jobs = ((k, DrawMore(tuple(again[k : k + WISHES_PER_DRAW]))) for k in range(0, len(again), WISHES_PER_DRAW))
        found = dict(workers.run(carried, jobs))
        return Traits.joined([found[k] for k in sorted(found)])

    settled = keep_apart(drawer, wishes, first, more)
    again = again_of(wishes, settled)
    _change(exam, again, carried, parts, workers)
    parts.settle(redrawn_of(wishes, settled), alike_of(drawer, wishes, settled.alike))


class _Wishes(Sequence[Wish]):
    """The problems of all students, student by student, made when they are asked for."""

    def __init__(self, exam: Exam, students: Sequence[Student]) -> None:
        self._students, self._problems = students, len(exam.tasks)

    def __len__(self) -> int:
        return len(self._students) * self._problems

    def __getitem__(self, place: Any) -> Any:
        """The wish at a place."""
        student, problem = divmod(place, self._problems)
        return Wish(self._students[student], problem)


def _first(
    exam: Exam,
    students: Sequence[Student],
    carried: Carried,
    parts: Unfinished,
    workers: Workers,
    progress: Progress,
) -> Traits:
    """The first draw of everybody."""
    codes = variant_codes(carried.seed, students)
    found: dict[int, Traits] = {}
    progress("drawing variants", 0, len(students))
    todo: list[tuple[int, Draw]] = []
    for start in range(0, len(students), STUDENTS_PER_DRAW):
        chosen = slice(start, start + STUDENTS_PER_DRAW)
        own = range(start // STUDENTS_PER_PART, -(-min(chosen.stop, len(students)) // STUDENTS_PER_PART))
        if all(parts.has_drawn(part) for part in own):
            found[start] = _kept(exam, parts, own)
        else:
            todo.append((start, Draw(tuple(zip(students[chosen], codes[chosen], strict=True)))))
    done = len(students) - sum(len(job.students) for _, job in todo)
    for start, drawn in workers.run(carried, todo):
        for part, content in enumerate(drawn.parts, start=start // STUDENTS_PER_PART):
            parts.put_drawn(part, content)
        found[start] = drawn.traits
        done += min(STUDENTS_PER_DRAW, len(students) - start)
        progress("drawing variants", done, len(students))
    return Traits.joined([found[start] for start in sorted(found)])


def _kept(exam: Exam, parts: Unfinished, own: range) -> Traits:
    """What is compared of parts that were drawn before."""
    sheets = [sheet for part in own for sheet in unpack_sheets(exam, parts.first(part))]
    wishes = [Wish(sheet.student, place) for sheet in sheets for place in range(len(exam.tasks))]
    return traits_of(wishes, [item.variant for sheet in sheets for item in sheet.items])


def _change(exam: Exam, again: dict[int, Wish], carried: Carried, parts: Unfinished, workers: Workers) -> None:
    """Put the next draws in the place of others."""
    places = list(again)
    jobs = (
        (k, Redraw(tuple(again[i] for i in places[k : k + WISHES_PER_DRAW])))
        for k in range(0, len(places), WISHES_PER_DRAW)
    )
    items: dict[int, Item] = {}
    for k, packed in workers.run(carried, jobs):
        items.update(zip(places[k : k + WISHES_PER_DRAW], unpack_items(exam, packed), strict=True))
    per_part = STUDENTS_PER_PART * len(exam.tasks)
    for part in sorted({i // per_part for i in items}):
        sheets = unpack_sheets(exam, parts.first(part))
        own = range(part * per_part, part * per_part + sum(len(sheet.items) for sheet in sheets))
        flat = [item for sheet in sheets for item in sheet.items]
        flat = [items.get(i, item) for i, item in zip(own, flat, strict=True)]
        count = len(exam.tasks)
        changed = [replace(s, items=tuple(flat[k * count : (k + 1) * count])) for k, s in enumerate(sheets)]
        parts.put_changed(part, pack(exam, changed))
