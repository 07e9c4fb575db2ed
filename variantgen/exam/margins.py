"""The tolerance of each answer: what a careful hand calculation with three significant digits needs, and no mistake.

The tolerance of an answer is the exam's ``floor`` or, where rounding in a worked solution leads further from the exact
answer (:mod:`variantgen.methods.rounding`), that much. A variant that would need more than the ``ceiling`` punishes
rounding, and one on which a plausible mistake (:mod:`variantgen.variants.mistakes`) goes unnoticed in every answer that
it touches lets a wrong way pass: neither is drawn. Where a mistake is seen in some answers only, the key says which of
the others do not show it.
"""

from __future__ import annotations

from collections.abc import Callable, Mapping, Sequence
from dataclasses import dataclass, field

import numpy as np
from numpy.typing import NDArray

from variantgen.errors import InputError
from variantgen.exam.tolerance import Tolerance
from variantgen.families.family import Form, frame
from variantgen.families.quantities import Quantity
from variantgen.mechanism.motion import Motion
from variantgen.mechanism.rows import Frame
from variantgen.methods.rounding import HandCalculation
from variantgen.variants.attempts import FormDrawing, Tally
from variantgen.variants.mistakes import distances, wrong_answers
from variantgen.variants.screening import Values, sensitivity
from variantgen.variants.seeding import Stream
from variantgen.variants.variant import Variant, columns

Table = NDArray[np.float64]
Marks = tuple[tuple[str, ...], ...]  # by answer, the mistakes that go unnoticed in it

# Where no method leads to an answer: three standard deviations of data rounded to three digits (0.13 % each), by the
# sensitivity of the answers to the data.
_OF_DATA = 0.004
_STEP = 0.001  # to which a tolerance above the floor is rounded up


@dataclass
class Margins:
    """The tolerances of answers, and the screens that follow from them.

    What has been found for a variant is kept.
    """

    tolerance: Tolerance = Tolerance()
    _found: dict[tuple[object, ...], Table] = field(default_factory=dict)
    _marks: dict[tuple[object, ...], Marks] = field(default_factory=dict)

    def __call__(
        self, form: Form, parameters: Values, on_paper: Frame, asked: Sequence[Quantity], motion: Motion
    ) -> Screened:
        """The screens of a batch of attempts at a form; see :class:`variantgen.variants.attempts.Judging`."""
        wrong = _distances(form, parameters, on_paper, asked, motion) if self.tolerance.mistakes else {}
        return Screened(self, asked, motion, wrong)

    def unnoticed(
        self, variants: Sequence[Variant], asked: Sequence[Quantity], motion: Motion, places: Sequence[int]
    ) -> list[Marks]:
        """By variant and answer the mistakes that change the answer by less than its tolerance.

        ``places`` are the indices of the variants, which share one form, in the batch ``motion``.
        """
        keys = [_key(variant, asked) for variant in variants]
        new = [i for i, key in enumerate(keys) if key not in self._marks]
        if new:
            chosen, own = [variants[i] for i in new], motion.take(np.array([places[i] for i in new]))
            on_paper = frame([v.sense for v in chosen], [v.turns for v in chosen])
            wrong = _distances(chosen[0].form, columns(chosen), on_paper, asked, own)
            self.mark(chosen, asked, wrong, self.tolerances(chosen, asked, own, range(len(new))))
        return [self._marks[key] for key in keys]

    def mark(
        self, variants: Sequence[Variant], asked: Sequence[Quantity], wrong: Mapping[str, Table], tolerances: Table
    ) -> None:
        """Keep which mistakes go unnoticed in the answers of variants; distances and tolerances in their order."""
        found: list[list[list[str]]] = [[[] for _ in asked] for _ in variants]
        for name, distance in wrong.items():
            for answer, place in np.argwhere(distance <= tolerances).tolist():
                found[place][answer].append(name)
        for variant, own in zip(variants, found, strict=True):
            self._marks[_key(variant, asked)] = tuple(tuple(names) for names in own)

    def tolerances(
        self, variants: Sequence[Variant], asked: Sequence[Quantity], motion: Motion, places: Sequence[int]
    ) -> Table:
        """Relative tolerances of the answers (for an angle in radians), shape (answers, N).

        ``places`` are the indices of the variants, which share one form, in the batch ``motion``. An answer of zero or
        infinity has the floor.
        """
        keys = [_key(variant, asked) for variant in variants]
        new = [i for i, key in enumerate(keys) if key not in self._found]
        if new:
            table = self._new_tolerances([variants[i] for i in new], asked, motion, [places[i] for i in new])
            self._found.update((keys[i], column) for i, column in zip(new, table.T, strict=True))
        return np.stack([self._found[key] for key in keys], axis=1)

    def _new_tolerances(
        self, variants: Sequence[Variant], asked: Sequence[Quantity], motion: Motion, places: Sequence[int]
    ) -> Table:
        errors = _calculation(variants[0], asked).errors(variants, motion, places)
        chosen = np.array(places, dtype=int)
        found = []
        for quantity, error in zip(asked, errors, strict=True):
            if quantity.is_angle:
                relative = np.radians(error)
            else:
                unit = quantity.unit(variants[0].family.length_unit)
                value = np.abs(unit.from_si(quantity.value(motion)[chosen]))
                usual = (value > 0) & np.isfinite(value)
                relative = np.where(usual, error / np.where(usual, value, 1.0), 0.0)
            found.append(relative)
        table = np.array(found)
        if np.any(~np.isfinite(table)):
            table = np.where(np.isfinite(table), table, _OF_DATA * self._gain(variants, asked, motion.take(chosen)))
        steps = np.ceil(table / _STEP - 1e-6) * _STEP
        return np.asarray(np.where(table > self.tolerance.floor, steps, self.tolerance.floor))

    def _gain(self, variants: Sequence[Variant], asked: Sequence[Quantity], motion: Motion) -> Table:
        on_paper = frame([v.sense for v in variants], [v.turns for v in variants])
        return sensitivity(variants[0].form, columns(variants), on_paper, asked, motion)


@dataclass(frozen=True)
class Screened:
    """A batch of attempts with the distances of its answers from those by mistakes, shape (answers, N)."""

    margins: Margins
    asked: Sequence[Quantity]
    motion: Motion
    wrong: Mapping[str, Table]

    def screens(self) -> dict[str, NDArray[np.bool_]]:
        """What a mistake rules out at the floor already need not be worked out."""
        return {_MISTAKES: _is_seen(self.wrong, self._floor(self.motion.size))}

    def judge(self, variants: Sequence[Variant], places: Sequence[int]) -> dict[str, NDArray[np.bool_]]:
        """Whether tolerances are within the ceiling and tell the mistakes; the tolerances are kept."""
        needed = self.margins.tolerances(variants, self.asked, self.motion, places)
        chosen = list(places)
        wrong = {name: distance[:, chosen] for name, distance in self.wrong.items()}
        if self.wrong:
            self.margins.mark(variants, self.asked, wrong, needed)
        ceiling = self.margins.tolerance.ceiling * (1 + 1e-9)
        return {
            _MISTAKES: _is_seen(wrong, needed),
            "rounding by hand within the ceiling": np.all(needed <= ceiling, axis=0),
        }

    def _floor(self, count: int) -> Table:
        return np.full((len(self.asked), count), self.margins.tolerance.floor)


_MISTAKES = "plausible mistakes outside the tolerance"


def _key(variant: Variant, asked: Sequence[Quantity]) -> tuple[object, ...]:
    """What the tolerances of a variant depend on."""
    return variant.identity, variant.sense, variant.turns, tuple(asked)


def _calculation(variant: Variant, asked: Sequence[Quantity]) -> HandCalculation:
    """Calculations by hand of variants of a form, which remembers what is known of their steps."""
    key = (HandCalculation, variant.family.name, tuple(asked))
    known = variant.form.remembered
    if key not in known:
        known[key] = HandCalculation(variant.form, asked, _models(variant, asked))
    found: HandCalculation = known[key]
    return found


def _is_seen(wrong: Mapping[str, Table], tolerances: Table) -> NDArray[np.bool_]:
    """Whether every mistake that touches an answer leads beyond the tolerance in one of them, shape (N,)."""
    found = np.ones(tolerances.shape[1], dtype=bool)
    for distance in wrong.values():
        touched = np.isfinite(distance)
        found &= ~np.any(touched, axis=0) | np.any(touched & (distance > tolerances), axis=0)
    return found


def _distances(
    form: Form, parameters: Values, on_paper: Frame, asked: Sequence[Quantity], motion: Motion
) -> dict[str, Table]:
    """By mistake the relative distance of each answer from the wrong one, shape (answers, N)."""
    right = np.array([quantity.value(motion) for quantity in asked], dtype=float)
    wrong = wrong_answers(form, parameters, on_paper, asked, motion)
    return {name: distances(right, values, asked) for name, values in wrong.items()}


def _models(variant: Variant, asked: Sequence[Quantity]) -> Callable[[int], list[Variant]]:
    """A draw of so many variants of the form, always the same ones; none where the form has but one or none."""

    def drawn(count: int) -> list[Variant]:
        if variant.form.grid_size == 1:
            return []
        drawing = FormDrawing(variant.family, variant.form, asked, Tally(), variant.family.name)
        streams = [Stream("model", number, variant.family.name) for number in range(count)]
        try:
            return drawing.first(streams, [0] * count)
        except InputError:  # the draw of the students' variants says it, with their keys
            return []

    return drawn
