"""From an exam and a roster to sheets: who gets which variant of which family, and what is right."""

from __future__ import annotations

from collections.abc import Iterable, Mapping, Sequence
from dataclasses import dataclass

from variantgen.exam.blueprint import Exam
from variantgen.exam.ceiling import within
from variantgen.exam.confirm import confirm
from variantgen.exam.margins import Margins
from variantgen.exam.roster import Student
from variantgen.exam.sheets import Item, Sheet, answers_of, solve_all, variant_codes
from variantgen.exam.tolerance import Tolerance, places_by_tolerance
from variantgen.families.asking import read_ask
from variantgen.variants.distinct import More, Settled, TooFewError, settle
from variantgen.variants.draw import Drawing, check_room, drawn, too_few
from variantgen.variants.likeness import Traits, traits
from variantgen.variants.seeding import digest
from variantgen.variants.variant import Variant


@dataclass(frozen=True)
class Wish:
    """A problem of a student, by its place in the exam, and the attempts of the draw that are behind it."""

    student: Student
    place: int
    used: int = 0


@dataclass(frozen=True)
class Assembly:
    """The sheets in the order of the roster.

    ``redrawn`` are ids of students who had to draw again to be distinct, ``alike`` says of problems (``problem[2]:
    ladder``) how many sheets have nearly the data of another in their group.
    """

    sheets: tuple[Sheet, ...]
    redrawn: tuple[str, ...]
    alike: Mapping[str, int]


@dataclass(frozen=True)
class Standing:
    """A sheet that is handed out already: new ones are kept apart from it. It has a variant for every problem."""

    student: Student
    code: str
    variants: tuple[Variant, ...]


class Drawer:
    """Draws, solves and verifies problems of an exam. What follows from the exam alone is worked out once."""

    def __init__(self, exam: Exam) -> None:
        self.exam = exam
        self._tolerances = [exam.tolerance_of(task) for task in exam.tasks]
        self._margins = {tolerance: Margins(tolerance) for tolerance in self._tolerances}
        self._drawings = [
            [Drawing(f, task.ask, where=f"problem[{task.number}]", judge=self._margins[own]) for f in task.families]
            for task, own in zip(exam.tasks, self._tolerances, strict=True)
        ]

    def drawing(self, wish: Wish) -> Drawing:
        """From what a problem is drawn: one of the families of its task."""
        task = self.exam.tasks[wish.place]
        number = int.from_bytes(digest("pool", self.exam.seed, wish.student.id, task.number), "big")
        return self._drawings[wish.place][number % len(task.families)]

    def priority(self, wish: Wish) -> bytes:
        """Who keeps a variant that two would get: the smaller one."""
        return digest("priority", *self._key(wish))

    def variants(self, wishes: Sequence[Wish]) -> list[Variant]:
        """The next valid variant of each wish. Raises InputError where the ranges of a problem leave none."""
        found = self._drawn(wishes, [wish.used for wish in wishes])
        marked = places_by_tolerance(self._tolerances[wish.place] for wish in wishes)
        for tolerance, places in marked.items():
            kept = self._within(tolerance, [wishes[i] for i in places], [found[i] for i in places])
            for i, variant in zip(places, kept, strict=True):
                found[i] = variant
        return found

    def _within(self, tolerance: Tolerance, wishes: Sequence[Wish], first: list[Variant]) -> list[Variant]:
        """The first variants of some wishes, or later ones where these need more than the ceiling of the tolerance."""
        if tolerance.ceiling is None:
            return first
        return within(
            tolerance.ceiling,
            self._margins[tolerance],
            first,
            lambda i, variant: self.drawing(wishes[i]).asked[variant.form.name],
            [self.exam.tasks[wish.place].number for wish in wishes],
            lambda owners, used: self._drawn([wishes[i] for i in owners], used),
        )

    def cut(self, wishes: Sequence[Wish], variants: Sequence[Variant]) -> int:
        """How many of the wishes would have another variant if the exam set no ceiling to tolerances."""
        if all(tolerance.ceiling is None for tolerance in self._tolerances):
            return 0
        first = self._drawn(wishes, [wish.used for wish in wishes])
        return sum(one.attempt != other.attempt for one, other in zip(first, variants, strict=True))

    def _drawn(self, wishes: Sequence[Wish], used: Sequence[int]) -> list[Variant]:
        drawings, keys = [self.drawing(wish) for wish in wishes], [self._key(wish) for wish in wishes]
        return drawn(drawings, keys, used)

    def items(self, wishes: Sequence[Wish], variants: Sequence[Variant]) -> list[Item]:
        """The problems with their answers. Raises VerificationError if a method disagrees with the solver."""
        tasks = [self.exam.tasks[wish.place] for wish in wishes]
        asked = [read_ask(variant.form, task.ask) for variant, task in zip(variants, tasks, strict=True)]
        solved = solve_all(variants, asked)
        confirm(variants, asked, solved, [self._key(wish) for wish in wishes])
        answers = answers_of(variants, asked, solved, self._margins, [self._tolerances[w.place] for w in wishes])
        self.forget()
        return [Item(*found) for found in zip(tasks, variants, answers, strict=True)]

    def forget(self) -> None:
        """Forget what is known of variants that were drawn."""
        for margins in self._margins.values():
            margins.forget()

    def traits(self, wishes: Sequence[Wish], variants: Sequence[Variant]) -> Traits:
        """What is compared of drawn variants."""
        asked = [self.drawing(wish).asked[v.form.name] for wish, v in zip(wishes, variants, strict=True)]
        return traits(variants, asked, [wish.student.group for wish in wishes])

    def _key(self, wish: Wish) -> tuple[object, ...]:
        return self.exam.seed, wish.student.id, self.exam.tasks[wish.place].number


def wishes_of(exam: Exam, students: Iterable[Student]) -> list[Wish]:
    """All problems of some students, student by student."""
    return [Wish(student, place) for student in students for place in range(len(exam.tasks))]


def keep_apart(
    drawer: Drawer, wishes: Sequence[Wish], first: Traits, more: More, standing: Sequence[Standing] = ()
) -> Settled:
    """Who has to draw again; ``more`` draws. Raises InputError where there are too few variants."""
    if not wishes:
        return Settled({}, ())
    kept = _standing_traits(drawer.exam, standing)
    try:
        return settle(
            Traits.joined([first, *kept]), lambda i: drawer.priority(wishes[i]), more, sum(len(own) for own in kept)
        )
    except TooFewError as error:
        others = (Wish(sheet.student, place) for place in range(len(drawer.exam.tasks)) for sheet in standing)
        raise too_few(error, [drawer.drawing(wish) for wish in (*wishes, *others)]) from None


def _standing_traits(exam: Exam, standing: Sequence[Standing]) -> list[Traits]:
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


def alike_of(drawer: Drawer, wishes: Sequence[Wish], alike: Iterable[int]) -> dict[str, int]:
    """How many sheets have nearly the data of another, by problem and family."""
    found: dict[str, int] = {}
    for i in alike:
        where = drawer.drawing(wishes[i]).where
        found[where] = found.get(where, 0) + 1
    return dict(sorted(found.items()))


def assemble(exam: Exam, students: Sequence[Student]) -> Assembly:
    """Draw, solve and verify everything in this process."""
    drawer, wishes = Drawer(exam), wishes_of(exam, students)
    check_room([drawer.drawing(wish) for wish in wishes])
    variants = drawer.variants(wishes)

    def more(owners: Sequence[int], used: Sequence[int]) -> Traits:
        again = [Wish(wishes[i].student, wishes[i].place, done) for i, done in zip(owners, used, strict=True)]
        return drawer.traits(again, drawer.variants(again))

    settled = keep_apart(drawer, wishes, drawer.traits(wishes, variants), more)
    again = again_of(wishes, settled)
    for i, variant in zip(again, drawer.variants(list(again.values())), strict=True):
        variants[i] = variant
    codes = variant_codes(exam.seed, students)
    items, count = drawer.items(wishes, variants), len(exam.tasks)
    own = [tuple(items[i : i + count]) for i in range(0, len(items), count)]
    sheets = tuple(Sheet(*found) for found in zip(students, codes, own, strict=True))
    return Assembly(sheets, redrawn_of(wishes, settled), alike_of(drawer, wishes, settled.alike))


def again_of(wishes: Sequence[Wish], settled: Settled) -> dict[int, Wish]:
    """The wishes, by their places, whose next draw is not their first one."""
    return {i: Wish(wishes[i].student, wishes[i].place, attempt - 1) for i, attempt in settled.again.items()}


def redrawn_of(wishes: Sequence[Wish], settled: Settled) -> tuple[str, ...]:
    """The ids of students who had to draw again."""
    return tuple(dict.fromkeys(wishes[i].student.id for i in settled.again))
