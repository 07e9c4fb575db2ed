"""From an exam and a roster to sheets: who gets which variant of which family, and what is right."""

from __future__ import annotations

from collections.abc import Iterable, Sequence

from msgspec import Struct

from variantgen.exam.answer_tolerances import AnswerTolerances
from variantgen.exam.ceiling import within
from variantgen.exam.exam import Exam
from variantgen.exam.roster import Student
from variantgen.exam.sections.tolerance import Tolerance, places_by_tolerance
from variantgen.exam.sheets import Item, answers_of, solve_all
from variantgen.exam.work.fairness import ANY_WIDTH, Band, FairDraws, with_work
from variantgen.families.asking import read_ask
from variantgen.methods.hand.confirmation import UnconfirmedError
from variantgen.methods.hand.work import Work
from variantgen.variants.attempts import VerificationError
from variantgen.variants.distinct import DistinctDraws, More, TooFewError, assign_distinct
from variantgen.variants.draw import FamilySampler, next_draws, too_few
from variantgen.variants.seeding import digest
from variantgen.variants.similarity import Traits, traits
from variantgen.variants.variant import Variant


class DrawRequest(Struct, frozen=True):
    """A problem of a student, by its place in the exam, and the attempts of the draw that are behind it."""

    student: Student
    place: int
    used: int = 0


class HandedOutSheet(Struct, frozen=True):
    """A sheet that is handed out already: new ones are kept apart from it. It has a variant for every problem."""

    student: Student
    code: str
    variants: tuple[Variant, ...]


class ProblemSampler:
    """Draws, solves and verifies problems of an exam. What follows from the exam alone is worked out once."""

    def __init__(self, exam: Exam) -> None:
        self.exam = exam
        self._tolerances = [exam.tolerance_of(task) for task in exam.tasks]
        self._margins = {tolerance: AnswerTolerances(tolerance) for tolerance in self._tolerances}
        self._fair = [
            None
            if exam.fair is None and task.work is None
            else FairDraws(ANY_WIDTH if exam.fair is None else exam.fair, self._margins[own], task.work)
            for task, own in zip(exam.tasks, self._tolerances, strict=True)
        ]
        self._drawings = [
            [
                FamilySampler(f, task.ask, where=f"problem[{task.number}]", screening=fair or self._margins[own])
                for f in task.families
            ]
            for task, own, fair in zip(exam.tasks, self._tolerances, self._fair, strict=True)
        ]
        for place, (task, fair) in enumerate(zip(exam.tasks, self._fair, strict=True)):
            if fair is not None and task.work is not None:
                self._drawings[place] = with_work(self._drawings[place], fair, f"problem[{task.number}]", task.work)

    def bands(self) -> dict[tuple[int, str, str], Band]:
        """The bands of work by problem, family and form; none where the exam wants no fair variants."""
        return {
            (task.number, drawing.family.name, form.name): fair.band(drawing.family, form, drawing.examined[form.name])
            for task, fair, drawings in zip(self.exam.tasks, self._fair, self._drawings, strict=True)
            if fair is not None
            for drawing in drawings
            for form in drawing.forms
        }

    def drawing(self, request: DrawRequest) -> FamilySampler:
        """From what a problem is drawn: one of the families of its task."""
        task, drawings = self.exam.tasks[request.place], self._drawings[request.place]
        number = int.from_bytes(digest("pool", self.exam.seed, request.student.id, task.number), "big")
        return drawings[number % len(drawings)]

    def priority(self, request: DrawRequest) -> bytes:
        """Who keeps a variant that two would get: the smaller one."""
        return digest("priority", *self._key(request))

    def variants(self, requests: Sequence[DrawRequest]) -> list[Variant]:
        """The next valid variant of each request. Raises InputError where the ranges of a problem leave none."""
        found = self._drawn(requests, [request.used for request in requests])
        marked = places_by_tolerance(self._tolerances[request.place] for request in requests)
        for tolerance, places in marked.items():
            kept = self._within(tolerance, [requests[i] for i in places], [found[i] for i in places])
            for i, variant in zip(places, kept, strict=True):
                found[i] = variant
        return found

    def _within(self, tolerance: Tolerance, requests: Sequence[DrawRequest], first: list[Variant]) -> list[Variant]:
        """The first variants of some requests, or later ones where these need more than the exam's ceiling."""
        if tolerance.ceiling is None:
            return first
        return within(
            tolerance.ceiling,
            self._margins[tolerance],
            first,
            lambda i, variant: self.drawing(requests[i]).asked[variant.form.name],
            [self.exam.tasks[request.place].number for request in requests],
            lambda owners, used: self._drawn([requests[i] for i in owners], used),
        )

    def cut(self, requests: Sequence[DrawRequest], variants: Sequence[Variant]) -> int:
        """The number of requests that would have another variant without the exam's ceiling of tolerances."""
        if all(tolerance.ceiling is None for tolerance in self._tolerances):
            return 0
        first = self._drawn(requests, [request.used for request in requests])
        return sum(one.attempt != other.attempt for one, other in zip(first, variants, strict=True))

    def _drawn(self, requests: Sequence[DrawRequest], used: Sequence[int]) -> list[Variant]:
        drawings, keys = [self.drawing(request) for request in requests], [self._key(request) for request in requests]
        return next_draws(drawings, keys, used)

    def items(self, requests: Sequence[DrawRequest], variants: Sequence[Variant]) -> list[Item]:
        """The problems with their answers. Raises VerificationError for one to which its steps do not lead."""
        tasks = [self.exam.tasks[request.place] for request in requests]
        asked = [read_ask(variant.form, task.ask) for variant, task in zip(variants, tasks, strict=True)]
        solved = solve_all(variants, asked)
        try:
            answers = answers_of(variants, asked, solved, self._margins, [self._tolerances[w.place] for w in requests])
        except UnconfirmedError as error:
            request = next(request for request, own in zip(requests, variants, strict=True) if own is error.variant)
            key = ", ".join(map(str, self._key(request)))
            raise VerificationError(f"{error} (seed, student, problem: {key})") from error
        works = [self._work(request, variant) for request, variant in zip(requests, variants, strict=True)]
        self.forget()
        return [Item(*found) for found in zip(tasks, variants, answers, works, strict=True)]

    def _work(self, request: DrawRequest, variant: Variant) -> Work | None:
        """The work of a variant, where the exam wants fair ones."""
        fair = self._fair[request.place]
        return fair.work(variant, self.drawing(request).examined[variant.form.name]) if fair else None

    def forget(self) -> None:
        """Forget what is known of variants that were drawn."""
        for answer_tolerances in self._margins.values():
            answer_tolerances.forget()
        for fair in self._fair:
            if fair is not None:
                fair.forget()

    def traits(self, requests: Sequence[DrawRequest], variants: Sequence[Variant]) -> Traits:
        """The traits of drawn variants, by which equal and nearly equal ones are found."""
        asked = [self.drawing(request).asked[v.form.name] for request, v in zip(requests, variants, strict=True)]
        return traits(variants, asked, [request.student.group for request in requests])

    def _key(self, request: DrawRequest) -> tuple[object, ...]:
        return self.exam.seed, request.student.id, self.exam.tasks[request.place].number


def resolve_duplicates(
    drawer: ProblemSampler,
    requests: Sequence[DrawRequest],
    first: Traits,
    more: More,
    standing: Sequence[HandedOutSheet] = (),
) -> DistinctDraws:
    """Who has to draw again; ``more`` draws. Raises InputError where there are too few variants."""
    if not requests:
        return DistinctDraws({}, ())
    kept = _standing_traits(drawer.exam, standing)
    try:
        return assign_distinct(
            Traits.joined([first, *kept]), lambda i: drawer.priority(requests[i]), more, sum(len(own) for own in kept)
        )
    except TooFewError as error:
        others = (DrawRequest(sheet.student, place) for place in range(len(drawer.exam.tasks)) for sheet in standing)
        raise too_few(error, [drawer.drawing(request) for request in (*requests, *others)]) from None


def _standing_traits(exam: Exam, standing: Sequence[HandedOutSheet]) -> list[Traits]:
    """What is compared of sheets that are handed out, by problems."""
    return [
        traits(
            [sheet.variants[place] for sheet in standing],
            [read_ask(sheet.variants[place].form, task.ask) for sheet in standing],
            [sheet.student.group for sheet in standing],
        )
        for place, task in enumerate(exam.tasks)
        if standing
    ]


def near_duplicates_of(drawer: ProblemSampler, requests: Sequence[DrawRequest], alike: Iterable[int]) -> dict[str, int]:
    """The number of sheets that have nearly the data of another, by problem and family."""
    found: dict[str, int] = {}
    for i in alike:
        where = drawer.drawing(requests[i]).where
        found[where] = found.get(where, 0) + 1
    return dict(sorted(found.items()))


def next_draws_of(requests: Sequence[DrawRequest], distinct_draws: DistinctDraws) -> dict[int, DrawRequest]:
    """The requests, by their places, whose next draw is not their first one."""
    return {
        i: DrawRequest(requests[i].student, requests[i].place, attempt - 1)
        for i, attempt in distinct_draws.again.items()
    }


def redrawn_of(requests: Sequence[DrawRequest], distinct_draws: DistinctDraws) -> tuple[str, ...]:
    """The ids of students who had to draw again."""
    return tuple(dict.fromkeys(requests[i].student.id for i in distinct_draws.again))
