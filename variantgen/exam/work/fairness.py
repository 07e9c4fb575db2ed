"""Variants that are equally hard: the work of everyone's variant lies in a band that the form alone decides.

The band is found once for a form, from a fixed sample of its variants: of all bands of the width that the exam wants
the one with the most variants of the sample, in calculations
(:class:`variantgen.methods.hand.work.Work`), in negative numbers and in obtuse angles. A draw outside it is refused
like one that another screen refuses, so that the variant of a student depends on no other student and on no other
problem. Where the band would leave too few variants it is made wider, and in the end there is none.

The work is that of the natural solution of what a draw is examined on (:mod:`variantgen.variants.examined`), so that
neither single questions nor wished methods change anybody's data.
"""

from __future__ import annotations

from collections import Counter
from collections.abc import Mapping, Sequence
from itertools import product
from typing import Any

import numpy as np
from msgspec import Struct, field
from numpy.typing import NDArray

from variantgen.errors import InputError, Problem
from variantgen.exam.answer_tolerances import AnswerTolerances, ToleranceScreening
from variantgen.exam.work.kept_work import Sizes, WorkSample
from variantgen.exam.work.wanted_work import LEVELS, MOST, Span
from variantgen.exam.work.work_samples import variant_answers, variant_work, work_sample
from variantgen.families.family import Family, Form
from variantgen.families.quantities import Quantity, motion_order
from variantgen.mechanism.motion import Motion
from variantgen.mechanism.rows import Frame
from variantgen.methods.hand.work import Work, work_of
from variantgen.variants.draw import FamilySampler
from variantgen.variants.printed_data import max_distinct_problems
from variantgen.variants.screening import Values
from variantgen.variants.variant import Variant, solve_variants

ROOM = 1000  # distinct variants that a band leaves at least
_SHARE = 0.2  # of the draws that a band leaves at least: the others are in vain
_SPREAD = 2  # by which negative numbers, and obtuse angles, may differ in a band
ANY_WIDTH = 1000.0  # where the work of a problem is bounded, but need not be equal
_LISTED = 8  # members of a pool that are named
_UNEVEN = 1.25  # members of a pool are comparable as long as one takes at most so many times the work of another
_WIDTHS = (1.0, 2.0, 4.0, 8.0)  # times the wanted width, which are tried one after the other


class Band(Struct, frozen=True):
    """The work that variants of a form may take, and what is known of the form from the sample.

    ``room`` is the estimated number of distinct variants in the band, ``of`` that of all valid ones of the form;
    ``share`` is the part of the sample inside. ``widened`` tells that the wanted width left too few.
    ``calculations`` is None where there is no band: all variants stay, because they are too few or because no solution
    leads to what is asked.
    """

    calculations: Span | None
    negatives: Span
    obtuse: Span
    median: float
    share: float
    room: int
    of: int
    widened: bool

    def record(self) -> dict[str, Any]:
        """What the manifest says of it, in whole numbers."""
        spans = {"calculations": self.calculations, "negatives": self.negatives, "obtuse": self.obtuse}
        own = {name: None if self.calculations is None or span is None else list(span) for name, span in spans.items()}
        return {**own, "percent_of_draws": round(100 * self.share), "variants": self.room, "of": self.of}

    @property
    def usual(self) -> float:
        """The calculations of a usual variant."""
        return self.median if self.calculations is None else 0.5 * sum(self.calculations)

    def __contains__(self, work: Work | None) -> bool:
        if self.calculations is None or work is None:  # without a solution a variant is judged by its confirmation
            return True
        spans = self.calculations, self.negatives, self.obtuse
        return all(low <= number <= high for (low, high), number in zip(spans, work.sizes, strict=True))


class FairDraws(Struct):
    """The screens of draws by the tolerance of an exam, and with them the band of each form; see
    :class:`variantgen.variants.batch.MakeScreening`.

    ``wanted`` bounds the calculations of all forms alike. The work of variants that passed is kept until
    :meth:`forget`.
    """

    width: float
    answer_tolerances: AnswerTolerances
    wanted: Span | None = None
    _works: dict[tuple[object, ...], Work | None] = field(default_factory=dict)

    def __call__(
        self, form: Form, parameters: Values, on_paper: Frame, asked: Sequence[Quantity], motion: Motion
    ) -> _FairScreening:
        """The screens of a batch of attempts at a form."""
        return _FairScreening(self, self.answer_tolerances(form, parameters, on_paper, asked, motion))

    def band(self, family: Family, form: Form, asked: Sequence[Quantity]) -> Band:
        """The band of a form for what its draws are examined on; the form remembers it."""
        key = ("sample", family.name, tuple(asked), self.answer_tolerances.tolerance.mistakes)
        if key not in form.remembered:
            form.remembered[key] = work_sample(family, form, asked, self.answer_tolerances)
        sample: WorkSample = form.remembered[key]
        own = ("band", *key, self.width, self.wanted)
        if own not in form.remembered:
            of = round(sample.valid * max_distinct_problems(form, asked))
            form.remembered[own] = band_of(sample, self.width, of, self.wanted)
        found: Band = form.remembered[own]
        return found

    def keep(self, variant: Variant, work: Work | None) -> None:
        """Keep what the work of a variant was found to be."""
        self._works[_key(variant)] = work

    def work(self, variant: Variant, asked: Sequence[Quantity]) -> Work | None:
        """The work of a variant that was drawn for what is examined."""
        key = _key(variant)
        if key not in self._works:
            self._works[key] = variant_work(variant, solve_variants([variant], motion_order(asked)), 0, asked)
        return self._works[key]

    def forget(self) -> None:
        """Forget the work of variants; bands are kept."""
        self._works.clear()


def _key(variant: Variant) -> tuple[object, ...]:
    return (variant.form, *map(variant.printed.get, variant.form.parameters), variant.sense, variant.turns)


class _FairScreening(Struct, frozen=True):
    """A batch of attempts at a form: the screens of its tolerances, then the band."""

    fair: FairDraws
    inner: ToleranceScreening

    def of_all(self) -> dict[str, NDArray[np.bool_]]:
        """The cheap screens."""
        return self.inner.of_all()

    def of_survivors(self, variants: Sequence[Variant], places: Sequence[int]) -> dict[str, NDArray[np.bool_]]:
        """The screens of hand calculation, and that of the band for those that pass them."""
        screens = self.inner.of_survivors(variants, places)
        alive = np.all(list(screens.values()), axis=0)
        fair = alive.copy()
        for i in np.flatnonzero(alive).tolist():
            band = self.fair.band(variants[i].family, self.inner.form, self.inner.asked)
            if band.calculations is None:
                continue
            found = variant_answers(variants[i], self.inner.motion, places[i], self.inner.asked)
            work = None if found is None else work_of(found.values())
            fair[i] = work in band
            if fair[i]:
                self.fair.keep(variants[i], work)
                if found is not None:
                    answers = [value.exact for value in found.values()]
                    self.fair.answer_tolerances.keep_answers(variants[i], self.inner.asked, answers)
        return {**screens, "work as usual for the problem": fair}


def band_of(sample: WorkSample, width: float, of: int, wanted: Span | None = None) -> Band:
    """The narrowest band, of the wanted width or of a multiple, that leaves enough room of ``of`` variants.

    Where calculations are ``wanted`` to lie between two numbers, so does the band.
    """
    works, median = sample.works, sample.median
    for times in _WIDTHS:
        found = _fullest(works, times * width, median, wanted or (0, MOST))
        if found is None:
            break
        inside, spans = found
        share = inside / works.total()
        if share * of >= ROOM and share >= _SHARE:
            return Band(*spans, median, share, round(share * of), of, widened=times > 1.0)
    return Band(None, (0, 0), (0, 0), median, 1.0, of, of, widened=True)


def _fullest(
    works: Counter[Sizes], width: float, median: float, wanted: Span
) -> tuple[int, tuple[Span, Span, Span]] | None:
    """The number of works in the band with the most of them, and its spans; of several bands that nearest the
    median.
    """
    if not works:
        return None
    rows, counts = np.array([*works]), np.array([*works.values()])
    starts = np.array([*product(*(sorted(set(column)) for column in rows.T.tolist()))])
    ends = starts + _SPREAD
    ends[:, 0] = np.minimum(np.floor(starts[:, 0] * (1.0 + width) + 1e-9), wanted[1])
    starts[:, 0] = np.maximum(starts[:, 0], wanted[0])
    is_inside = np.all((rows >= starts[:, None]) & (rows <= ends[:, None]), axis=2)
    inside = is_inside @ counts

    def rank(place: int) -> tuple[float, ...]:
        own = rows[is_inside[place], 0]
        return -abs(0.5 * (int(own.min()) + int(own.max())) - median), *(-starts[place, 1:]).tolist()

    most = int(inside.max())
    if not most:
        return None
    best = max(np.flatnonzero(inside == most).tolist(), key=rank)
    # What the sample happens not to have of a span is as good; its least calculations are those of a variant.
    calculations, negatives, obtuse = zip(starts[best].tolist(), ends[best].tolist(), strict=True)
    return most, (calculations, negatives, obtuse)


def with_work(drawings: Sequence[FamilySampler], fair: FairDraws, where: str, wanted: Span) -> list[FamilySampler]:
    """The drawings of a problem with those of their forms that have enough variants of the wanted work.

    Raises InputError where none has.
    """
    found, known = [], []
    for drawing in drawings:
        kept = []
        for form in drawing.forms:
            band = fair.band(drawing.family, form, drawing.examined[form.name])
            known.append(f"{drawing.family.name} {form.name}".strip() + f" {band.median:g}")
            if band.calculations is not None:
                kept.append(form)
        if kept:
            drawing.forms = kept
            found.append(drawing)
    if found:
        return found
    level = next((name for name, span in LEVELS.items() if span == wanted), "")
    bounds = f"{wanted[0]} to {wanted[1]}" if wanted[1] < MOST else f"{wanted[0]} or more"
    raise InputError(
        Problem(
            f"no form has enough variants of {bounds} calculations",
            key=f"{where}.{'level' if level else 'work'}",
            value=level,
            remedy="usual variants take: " + ", ".join(known) + "; variantgen list tells those of other families",
        )
    )


def uneven_pools(bands: Mapping[tuple[int, str, str], Band]) -> list[str]:
    """What an instructor should know of problems whose families and forms are not comparable in work."""
    members: dict[int, list[tuple[float, str]]] = {}
    for (number, family, form), band in bands.items():
        members.setdefault(number, []).append((band.usual, f"{family} {form}".strip()))
    found = []
    for number, own in members.items():
        least, most = min(own), max(own)
        if most[0] > _UNEVEN * least[0]:
            listed = ", ".join(f"{name} {middle:g}" for middle, name in sorted(own)[:_LISTED])
            more = f" and {len(own) - _LISTED} more, up to {most[0]:g}" if len(own) > _LISTED else ""
            found.append(
                f"problem[{number}]: its variants are not comparable in work (calculations): {listed}{more};"
                " form, level or work chooses comparable ones"
            )
    return found


def shortages(bands: Mapping[tuple[int, str, str], Band]) -> list[str]:
    """What an instructor should know of problems without room for fair variants, by problem, family and form."""
    found = []
    for (number, family, form), band in bands.items():
        where = f"problem[{number}]: {family}{f' {form}' if form else ''}"
        if band.calculations is None:
            found.append(f"{where}: some {band.of} variants, too few to choose equally hard ones")
        elif band.widened:
            low, high = band.calculations
            found.append(f"{where}: variants of {low} to {high} calculations, as narrower leaves too few of {band.of}")
    return found
