"""The tolerance of each answer: what a careful hand calculation with three significant digits needs, and no mistake.

The tolerance of an answer is the exam's ``floor`` or, where rounding in a worked solution leads further from the exact
answer (:mod:`variantgen.methods.hand.rounding`), that much. Where a mistake is seen in some answers only, the key says
which of the others do not show it.

A variant on which rounding leads further than the ``ceiling`` of the screens of its family punishes rounding, and one
on which a plausible mistake (:mod:`variantgen.variants.distractors`) goes unnoticed in every answer that it touches
lets a wrong way pass: neither is drawn. These screens know nothing of the exam's marking: with another floor the same
variants are drawn.
"""

from __future__ import annotations

from collections.abc import Callable, Sequence
from typing import TYPE_CHECKING

import numpy as np
from msgspec import Struct, field
from numpy.typing import NDArray

from variantgen.errors import InputError
from variantgen.exam.sections.tolerance import Tolerance
from variantgen.families.family import Form
from variantgen.families.parameters.draw_rules import frame
from variantgen.families.quantities import Quantity
from variantgen.mechanism.motion import Motion
from variantgen.mechanism.rows import Frame
from variantgen.variants.attempts import FormSampler
from variantgen.variants.batch import RejectionCounts
from variantgen.variants.distractors import distances, wrong_answers
from variantgen.variants.screening import Values, sensitivity
from variantgen.variants.seeding import Stream
from variantgen.variants.variant import Variant, parameter_arrays

# What works out solutions is loaded when one is needed: many variants are drawn without any.
if TYPE_CHECKING:
    from variantgen.methods.hand.rounding import HandCalculation

Array = NDArray[np.float64]
Marks = tuple[tuple[str, ...], ...]  # by answer, the mistakes that go unnoticed in it

# Where no method leads to an answer: three standard deviations of data rounded to three digits (0.13 % each), by the
# sensitivity of the answers to the data.
_OF_DATA = 0.004
_STEP = 0.001  # to which a tolerance above the floor is rounded up
_USUAL = Tolerance()


class AnswerTolerances(Struct):
    """The tolerances of answers by an exam's ``tolerance``, and the screens of draws.

    What has been found for a variant that passed the screens is kept until :meth:`forget`.
    """

    tolerance: Tolerance = _USUAL
    _errors: dict[tuple[object, ...], Array] = field(default_factory=dict)
    _marks: dict[tuple[object, ...], Marks] = field(default_factory=dict)
    _answers: dict[tuple[object, ...], Sequence[float]] = field(default_factory=dict)

    def __call__(
        self, form: Form, parameters: Values, on_paper: Frame, asked: Sequence[Quantity], motion: Motion
    ) -> ToleranceScreening:
        """The screens of a batch of attempts at a form; see :class:`variantgen.variants.batch.Screening`."""
        wrong = _WrongAnswers((), np.empty((0, len(asked), motion.size)))
        if self.tolerance.mistakes:
            wrong = _wrong(form, parameters, on_paper, asked, motion)
        return ToleranceScreening(self, form, asked, motion, wrong)

    def unnoticed(
        self, variants: Sequence[Variant], asked: Sequence[Quantity], motion: Motion, places: Sequence[int]
    ) -> list[Marks]:
        """By variant and answer the mistakes that change the answer by less than its tolerance.

        ``places`` are the indices of the variants, which share one form, in the batch ``motion``.
        """
        keys = _keys(variants, asked)
        new = [i for i, key in enumerate(keys) if key not in self._marks]
        if new:
            chosen, own = [variants[i] for i in new], motion.take(np.array([places[i] for i in new]))
            on_paper = frame([v.sense for v in chosen], [v.turns for v in chosen])
            wrong = _wrong(chosen[0].form, parameter_arrays(chosen), on_paper, asked, own)
            needed = self.tolerances(chosen, asked, own, range(len(new)))
            self._marks.update(zip((keys[i] for i in new), wrong.within(needed), strict=True))
        return [self._marks[key] for key in keys]

    def keep(self, variants: Sequence[Variant], asked: Sequence[Quantity], errors: Array, wrong: _WrongAnswers) -> None:
        """Keep what the screens have found of variants that passed them: ``errors`` of shape (answers, N)."""
        keys = _keys(variants, asked)
        self._errors.update(zip(keys, errors.T, strict=True))
        if wrong.names:
            self._marks.update(zip(keys, wrong.within(_at_least(errors, self.tolerance.floor)), strict=True))

    def keep_answers(self, variant: Variant, asked: Sequence[Quantity], answers: Sequence[float]) -> None:
        """Keep to which answers (printed units) the steps of a solution lead, found when the work was counted."""
        self._answers[_keys([variant], asked)[0]] = answers

    def worked_out(self, variants: Sequence[Variant], asked: Sequence[Quantity]) -> Array:
        """The answers to which the steps of solutions lead, shape (answers, N); no number where that is not known."""
        unknown = [np.nan] * len(asked)
        return np.array([self._answers.get(key, unknown) for key in _keys(variants, asked)]).T

    def tolerances(
        self, variants: Sequence[Variant], asked: Sequence[Quantity], motion: Motion, places: Sequence[int]
    ) -> Array:
        """Relative tolerances of the answers (for an angle in radians), shape (answers, N).

        ``places`` are the indices of the variants, which share one form, in the batch ``motion``. An answer of zero or
        infinity has the floor.
        """
        keys = _keys(variants, asked)
        new = [i for i, key in enumerate(keys) if key not in self._errors]
        if new:
            table = hand_errors([variants[i] for i in new], asked, motion, [places[i] for i in new])
            # Steps of another variant may be a poor way for this one: its screens knew other answers, or none.
            for column in np.flatnonzero(np.any(table > variants[0].form.screens.ceiling, axis=0)).tolist():
                i = new[column]
                steps = [quantity for quantity in asked if not quantity.is_extreme]
                rows = [not quantity.is_extreme for quantity in asked]
                own = _calculation(variants[i], steps).own_errors(variants[i], motion, places[i])
                by_own = _relative(own[:, None], [variants[i]], steps, motion, [places[i]])
                table[rows, column] = np.minimum(table[rows, column], by_own[:, 0])
            self._errors.update((keys[i], column) for i, column in zip(new, table.T, strict=True))
        return _at_least(np.stack([self._errors[key] for key in keys], axis=1), self.tolerance.floor)

    def forget(self) -> None:
        """Forget what was found for variants, once their answers are known; what is known of forms is kept."""
        self._errors.clear()
        self._answers.clear()
        self._marks.clear()


def _at_least(errors: Array, floor: float) -> Array:
    """The tolerances for relative errors of a hand calculation: the floor, or the errors rounded up."""
    steps = np.ceil(errors / _STEP - 1e-6) * _STEP
    return np.asarray(np.where(errors > floor, steps, floor))


def hand_errors(variants: Sequence[Variant], asked: Sequence[Quantity], motion: Motion, places: Sequence[int]) -> Array:
    """The relative errors of the answers (of an angle in radians) by a hand calculation, shape (answers, N)."""
    table = np.full((len(asked), len(variants)), np.nan)
    calculated = [not quantity.is_extreme for quantity in asked]
    steps = [quantity for quantity in asked if not quantity.is_extreme]
    if steps:
        errors = _calculation(variants[0], steps).errors(variants, motion, places)
        table[calculated] = _relative(errors, variants, steps, motion, places)
    for own in (steps, [quantity for quantity in asked if quantity.is_extreme]):
        rows = np.array([quantity in own for quantity in asked])
        if np.any(~np.isfinite(table[rows])):
            whole = list(places) == list(range(motion.size))
            found = _sensitivity(variants, own, motion if whole else motion.take(np.array(places, dtype=int)))
            # no number where a change of data leads nowhere
            by_data = np.where(np.isfinite(found), _OF_DATA * found, 0.0)
            table[rows] = np.where(np.isfinite(table[rows]), table[rows], by_data)
    return table


def _relative(
    errors: Array, variants: Sequence[Variant], asked: Sequence[Quantity], motion: Motion, places: Sequence[int]
) -> Array:
    """Errors in printed units as relative ones (of an angle in radians), shape (answers, N)."""
    chosen = np.array(places, dtype=int)
    found = []
    for quantity, error in zip(asked, errors, strict=True):
        if quantity.is_angle:
            relative = np.radians(error)
        else:
            unit = quantity.own_unit(variants[0].family.length_unit)
            value = np.abs(unit.from_si(quantity.value(motion)[chosen]))
            usual = (value > 0) & np.isfinite(value)
            relative = np.where(usual, error / np.where(usual, value, 1.0), 0.0)
        found.append(relative)
    return np.array(found)


def _sensitivity(variants: Sequence[Variant], asked: Sequence[Quantity], motion: Motion) -> Array:
    on_paper = frame([v.sense for v in variants], [v.turns for v in variants])
    return sensitivity(variants[0].form, parameter_arrays(variants), on_paper, asked, motion)


_MISTAKES = "plausible mistakes outside the tolerance"


class _WrongAnswers(Struct, frozen=True):
    """By mistake how far each answer is from the wrong one, shape (mistakes, answers, N)."""

    names: tuple[str, ...]
    distances: Array

    def at(self, places: list[int]) -> _WrongAnswers:
        """Of some variants."""
        return _WrongAnswers(self.names, self.distances[..., places])

    def seen(self, tolerances: Array | float) -> NDArray[np.bool_]:
        """Whether every mistake that touches an answer leads beyond the tolerance in one of them, shape (N,)."""
        touched = np.isfinite(self.distances)
        shown = touched & (self.distances > tolerances)
        return np.asarray(np.all(~np.any(touched, axis=1) | np.any(shown, axis=1), axis=0))

    def within(self, tolerances: Array) -> list[Marks]:
        """By variant and answer the mistakes that change the answer by less than its tolerance."""
        count, size = tolerances.shape
        found: list[list[list[str]]] = [[[] for _ in range(count)] for _ in range(size)]
        for mistake, answer, place in np.argwhere(self.distances <= tolerances).tolist():
            found[place][answer].append(self.names[mistake])
        return [tuple(tuple(names) for names in own) for own in found]


class ToleranceScreening(Struct, frozen=True):
    """A batch of attempts at a form with what mistakes make of their answers."""

    answer_tolerances: AnswerTolerances
    form: Form
    asked: Sequence[Quantity]
    motion: Motion
    wrong: _WrongAnswers

    def of_all(self) -> dict[str, NDArray[np.bool_]]:
        """The screen of plausible mistakes, shape (N,): which variants show each of them."""
        return {_MISTAKES: self.wrong.seen(self.form.screens.mistakes)}

    def of_survivors(self, variants: Sequence[Variant], places: Sequence[int]) -> dict[str, NDArray[np.bool_]]:
        """The screens of hand calculation for the variants at these indices, shape (len(places),) each.

        They keep within the ceiling and still show the mistakes; what is found for those that pass is kept.
        """
        chosen, screens = list(places), self.form.screens
        errors, wrong = hand_errors(variants, self.asked, self.motion, chosen), self.wrong.at(chosen)
        needed = _at_least(errors, _USUAL.floor)
        seen = wrong.seen(np.maximum(needed, screens.mistakes))
        within = np.all(needed <= screens.ceiling * (1 + 1e-9), axis=0)
        good = np.flatnonzero(seen & within).tolist()
        if good:
            self.answer_tolerances.keep([variants[i] for i in good], self.asked, errors[:, good], wrong.at(good))
        return {_MISTAKES: seen, "rounding by hand within the ceiling": within}


def _keys(variants: Sequence[Variant], asked: Sequence[Quantity]) -> list[tuple[object, ...]]:
    """What the tolerances of variants depend on; a form stands for itself."""
    names = tuple([quantity.name for quantity in asked])
    return [(v.form, *map(v.printed.get, v.form.parameters), v.sense, v.turns, names) for v in variants]


def _calculation(variant: Variant, asked: Sequence[Quantity]) -> HandCalculation:
    """Calculations by hand of variants of a form, which remembers what is known of their steps."""
    from variantgen.methods.hand.rounding import HandCalculation

    key = ("by hand", variant.family.name, tuple(asked))
    known = variant.form.remembered
    if key not in known:
        known[key] = HandCalculation(variant.form, asked, _models(variant, asked))
    found: HandCalculation = known[key]
    return found


def _wrong(form: Form, parameters: Values, on_paper: Frame, asked: Sequence[Quantity], motion: Motion) -> _WrongAnswers:
    right = np.array([quantity.value(motion) for quantity in asked], dtype=float)
    wrong = wrong_answers(form, parameters, on_paper, asked, motion)
    answers = np.array(list(wrong.values())).reshape(len(wrong), *right.shape)
    return _WrongAnswers(tuple(wrong), distances(right, answers, asked))


def _models(variant: Variant, asked: Sequence[Quantity]) -> Callable[[int], list[Variant]]:
    """A draw of so many variants of the form, always the same ones; none where the form has but one or none."""

    def drawn(count: int) -> list[Variant]:
        if variant.form.grid_size == 1:
            return []
        drawing = FormSampler(variant.family, variant.form, asked, RejectionCounts(), variant.family.name)
        streams = [Stream("model", number, variant.family.name) for number in range(count)]
        try:
            return drawing.first(streams, [0] * count)
        except InputError:  # the draw of the students' variants says it, with their keys
            return []

    return drawn
