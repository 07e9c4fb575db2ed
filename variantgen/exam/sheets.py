"""Sheets: the problems of a student, with the answers in printed units and their tolerances."""

from __future__ import annotations

import re
from collections.abc import Collection, Mapping, Sequence
from decimal import Decimal
from typing import TYPE_CHECKING

from msgspec import Struct
from msgspec.structs import replace

from variantgen.exam.answer_tolerances import AnswerTolerances
from variantgen.exam.sections.tolerance import Tolerance, places_by_tolerance
from variantgen.families.asking import Ask, read_ask
from variantgen.families.parameters.units import Unit
from variantgen.families.quantities import Quantity, motion_order, recorded
from variantgen.mechanism.motion import Field, Motion
from variantgen.mechanism.solving.closed_form import square_fractions
from variantgen.methods.hand.confirmation import confirm_answers
from variantgen.variants.seeding import digest
from variantgen.variants.variant import Variant, solve_variants

if TYPE_CHECKING:
    from variantgen.exam.exam import ExamProblem
    from variantgen.exam.roster import Student
    from variantgen.methods.hand.work import Work
    from variantgen.wording.formula import Surd

_CODE_LETTERS = "23456789ACDEFGHJKLMNPQRTUVWXYZ"


class Answer(Struct, frozen=True):
    """An answer in its printed unit, with the absolute tolerance in the same unit.

    ``relative_tolerance`` is that of an angle in radians, of a sense zero; ``unnoticed`` names the plausible mistakes
    that change the answer by less.
    ``surd`` is the same value in closed form, where it is a simple root or fraction.
    """

    quantity: Quantity
    unit: Unit
    value: float
    tolerance: float
    relative_tolerance: float = 0.0
    surd: Surd | None = None
    unnoticed: tuple[str, ...] = ()

    def __repr__(self) -> str:
        return f"<Answer {self.quantity.name} = {self.value:.6g} ± {self.tolerance:g} {self.unit.name}>"

    @property
    def accepted_intervals(self) -> tuple[tuple[float, float], ...]:
        """The intervals, ends included, in which an answer counts as right."""
        return tuple((float(low), float(high)) for low, high in self.exact_intervals)

    @property
    def exact_intervals(self) -> tuple[tuple[Decimal, Decimal], ...]:
        """The intervals in which an answer counts as right, first that around the answer.

        A direction near ±180° has two: an angle of −179.9° is as good as 180.1°. The ends are the sums of the decimal
        numbers, so that an answer that is typed as it stands at an end is inside.
        """
        value, tolerance = Decimal(repr(self.value)), Decimal(repr(self.tolerance))
        low, high = value - tolerance, value + tolerance
        if self.quantity.is_direction and (low < -180 or high > 180):
            turn = 360 if low < -180 else -360
            return (low, high), (low + turn, high + turn)
        return ((low, high),)


class Item(Struct, frozen=True):
    """One problem of one student; ``work`` is that of its variant, where the exam wants fair ones."""

    task: ExamProblem
    variant: Variant
    answers: tuple[Answer, ...]
    work: Work | None = None

    @property
    def asked(self) -> list[Quantity]:
        """The asked quantities in order."""
        return [answer.quantity for answer in self.answers]


class Sheet(Struct, frozen=True):
    """All problems of one student; ``code`` names the variant on paper."""

    student: Student
    code: str
    items: Sequence[Item]


def variant_codes(seed: str, students: Sequence[Student], taken: Collection[str] = ()) -> list[str]:
    """A short code like ``7Q4-K2M`` for the sheet of each student, no two the same, and none that is ``taken``.

    Where two students would have the same code, one of them gets another three letters; the ids decide which.
    """
    numbers = [int.from_bytes(digest("code", seed, student.id), "big") for student in students]
    found = [_code(number, 2) for number in numbers]
    for length in range(3, 10):
        holders = dict.fromkeys(taken, -1)
        for i in sorted(range(len(students)), key=lambda i: numbers[i]):
            if holders.setdefault(found[i], i) != i:
                found[i] = _code(numbers[i], length)
        if len(holders) == len(students) + len(set(taken)):
            break
    return found


def is_code(text: str) -> bool:
    """Whether a text is a code as sheets have it: asked of what was read from a file, before others are named by it."""
    return re.fullmatch(rf"[{_CODE_LETTERS}]{{3}}(-[{_CODE_LETTERS}]{{3}}){{1,8}}", text) is not None


def _code(number: int, groups: int) -> str:
    """Groups of three letters from a number."""
    letters = []
    for _ in range(3 * groups):
        number, k = divmod(number, len(_CODE_LETTERS))
        letters.append(_CODE_LETTERS[k])
    return "-".join("".join(letters[i : i + 3]) for i in range(0, len(letters), 3))


def solve_all(
    variants: Sequence[Variant], asked: Sequence[Sequence[Quantity]], positions_only: bool = False
) -> list[tuple[Motion, int]]:
    """For each variant the batch motion it was solved in and its place there; variants of one form share a batch."""
    groups: dict[tuple[int, int], list[int]] = {}
    for i, variant in enumerate(variants):
        order = 0 if positions_only else motion_order(asked[i])
        groups.setdefault((id(variant.form), order), []).append(i)
    found: dict[int, tuple[Motion, int]] = {}
    for (_, order), members in groups.items():
        motion = solve_variants([variants[i] for i in members], order)
        found.update((i, (motion, place)) for place, i in enumerate(members))
    return [found[i] for i in range(len(variants))]


def _tolerance(quantity: Quantity, unit: Unit, value: float, relative_tolerance: float) -> float:
    """Absolute tolerance in the printed unit: of an angle the like part of a radian."""
    return float(f"{relative_tolerance * (unit.from_si(1.0) if quantity.is_angle else abs(value)):.3g}")


def answers_of(
    variants: Sequence[Variant],
    asked: Sequence[Sequence[Quantity]],
    solved: Sequence[tuple[Motion, int]],
    answer_tolerances: Mapping[Tolerance, AnswerTolerances],
    tolerances: Sequence[Tolerance],
) -> list[tuple[Answer, ...]]:
    """The answers of solved variants, with tolerances and the mistakes that go unnoticed in them.

    ``answer_tolerances`` has what is known for each tolerance, ``tolerances`` that of each variant.
    """
    found: dict[int, tuple[Answer, ...]] = {}
    for tolerance, places in places_by_tolerance(tolerances).items():
        own, known = _taken(places, variants, asked, solved), answer_tolerances[tolerance]
        found.update(zip(places, _with_mistakes(_answers(*own, known), *own, known), strict=True))
    return [found[i] for i in range(len(variants))]


def _with_mistakes(
    answers: Sequence[tuple[Answer, ...]],
    variants: Sequence[Variant],
    asked: Sequence[Sequence[Quantity]],
    solved: Sequence[tuple[Motion, int]],
    answer_tolerances: AnswerTolerances,
) -> list[tuple[Answer, ...]]:
    """The answers with the mistakes that go unnoticed in them."""
    found = list(answers)
    for (_, quantities), members in batches_of(asked, solved).items():
        motion, places = solved[members[0]][0], [solved[i][1] for i in members]
        every = answer_tolerances.unnoticed([variants[i] for i in members], quantities, motion, places)
        for i, own in zip(members, every, strict=True):
            if any(own):
                found[i] = tuple(replace(a, unnoticed=names) for a, names in zip(answers[i], own, strict=True))
    return found


def batches_of(
    asked: Sequence[Sequence[Quantity]], solved: Sequence[tuple[Motion, int]]
) -> dict[tuple[int, tuple[Quantity, ...]], list[int]]:
    """Indices of variants that share a batch and the questions."""
    groups: dict[tuple[int, tuple[Quantity, ...]], list[int]] = {}
    for i, quantities in enumerate(asked):
        groups.setdefault((id(solved[i][0]), tuple(quantities)), []).append(i)
    return groups


def answer_variants(
    variants: Sequence[Variant], asks: Sequence[Ask], tolerances: Sequence[Tolerance], marked: bool = False
) -> list[tuple[Answer, ...]]:
    """The answers of variants in printed units, with absolute tolerances and, ``marked``, unnoticed mistakes.

    Raises UnconfirmedError for one to which the steps of a solution do not lead.
    """
    asked = [read_ask(variant.form, ask) for variant, ask in zip(variants, asks, strict=True)]
    solved, found = solve_all(variants, asked), dict[int, tuple[Answer, ...]]()
    if marked:
        return answers_of(variants, asked, solved, {own: AnswerTolerances(own) for own in tolerances}, tolerances)
    for tolerance, places in places_by_tolerance(tolerances).items():
        own = _answers(*_taken(places, variants, asked, solved), AnswerTolerances(tolerance))
        found.update(zip(places, own, strict=True))
    return [found[i] for i in range(len(variants))]


def _taken(
    places: Sequence[int],
    variants: Sequence[Variant],
    asked: Sequence[Sequence[Quantity]],
    solved: Sequence[tuple[Motion, int]],
) -> tuple[list[Variant], list[Sequence[Quantity]], list[tuple[Motion, int]]]:
    """Some of the variants, with what is asked of them and where they are solved."""
    return [variants[i] for i in places], [asked[i] for i in places], [solved[i] for i in places]


def _answers(
    variants: Sequence[Variant],
    asked: Sequence[Sequence[Quantity]],
    solved: Sequence[tuple[Motion, int]],
    answer_tolerances: AnswerTolerances,
) -> list[tuple[Answer, ...]]:
    found: dict[int, tuple[Answer, ...]] = {}
    for (_, quantities), members in batches_of(asked, solved).items():
        motion, places = solved[members[0]][0], [solved[i][1] for i in members]
        own = [variants[i] for i in members]
        confirm_answers(own, quantities, motion, places, answer_tolerances.worked_out(own, quantities))
        # Before the tolerances, which begin with the same values: several may be of one turn of the crank, found once.
        numbers = [quantity.value(motion)[places] for quantity in quantities]
        needed = answer_tolerances.tolerances(own, quantities, motion, places)
        length = variants[members[0]].family.length_unit
        table = [
            _column(quantity, quantity.unit(length), computed, by_hand)
            for quantity, computed, by_hand in zip(quantities, numbers, needed, strict=True)
        ]
        found.update(zip(members, zip(*table, strict=True), strict=True))
    return [found[i] for i in range(len(variants))]


def _surd(number: float) -> Surd | None:
    """A number in closed form, where it has one that helps."""
    from variantgen.wording.surds import surd  # with all formulas, which the answers of few problems need

    return surd(number)


def _column(quantity: Quantity, unit: Unit, numbers: Field, needed: Field) -> list[Answer]:
    """The answers of several variants (in SI) to one question, each with its tolerance."""
    computed = unit.from_si(numbers)
    roots = square_fractions(computed)[0].tolist()  # zero where there is none
    found = []
    for number, root, relative_tolerance in zip(computed.tolist(), roots, needed.tolist(), strict=True):
        value = recorded(quantity, number)
        own = 0.0 if quantity.component == "sense" else relative_tolerance  # a sense is right or wrong
        exact = _surd(number) if root else None
        found.append(Answer(quantity, unit, value, _tolerance(quantity, unit, value, own), own, exact))
    return found
