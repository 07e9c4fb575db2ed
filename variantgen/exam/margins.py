"""The tolerance of each answer: what a careful hand calculation with three significant digits needs, and no mistake.

The tolerance of an answer is the exam's ``floor`` or, where rounding in a worked solution leads further from the exact
answer (:mod:`variantgen.methods.rounding`), that much. A variant that would need more than the ``ceiling`` punishes
rounding, and one on which a plausible mistake (:mod:`variantgen.variants.mistakes`) leads to an answer within the
tolerance lets a wrong way pass: neither is drawn.
"""

from __future__ import annotations

from collections.abc import Callable, Sequence
from dataclasses import dataclass, field

import numpy as np
from numpy.typing import NDArray

from variantgen.errors import InputError
from variantgen.exam.tolerance import Tolerance
from variantgen.families.family import Form, frame
from variantgen.families.quantities import Quantity
from variantgen.mechanism.motion import Motion
from variantgen.methods.rounding import HandCalculation
from variantgen.variants.attempts import FormDrawing, Tally, VerificationError
from variantgen.variants.mistakes import distances, wrong_answers
from variantgen.variants.screening import sensitivity
from variantgen.variants.seeding import Stream
from variantgen.variants.variant import Variant, columns

Table = NDArray[np.float64]

# Where no method leads to an answer: three standard deviations of data rounded to three digits (0.13 % each), by the
# sensitivity of the answers to the data.
_OF_DATA = 0.004
_STEP = 0.001  # to which a tolerance above the floor is rounded up


@dataclass
class Margins:
    """The tolerances of answers, and the screens that follow from them.

    What is known of the solutions of a form, and what has been found for a variant, is kept.
    """

    tolerance: Tolerance = Tolerance()
    _found: dict[tuple[object, ...], Table] = field(default_factory=dict)
    _known: dict[tuple[int, tuple[Quantity, ...]], tuple[Form, HandCalculation]] = field(default_factory=dict)

    def __call__(
        self, variants: Sequence[Variant], asked: Sequence[Quantity], motion: Motion
    ) -> dict[str, NDArray[np.bool_]]:
        """Flags by screen, shape (N,), for variants of one form and their motion (in the same order)."""
        least = np.full((len(asked), len(variants)), np.inf)
        if self.tolerance.mistakes:
            least = _least_distances(variants, asked, motion)
        # What a mistake rules out at the floor already need not be worked out.
        chosen = np.flatnonzero(np.all(least > self.tolerance.floor, axis=0)).tolist()
        needed = np.full(least.shape, self.tolerance.floor)
        if chosen:
            needed[:, chosen] = self.tolerances([variants[i] for i in chosen], asked, motion, chosen)
        return {
            "plausible mistakes outside the tolerance": np.all(least > needed, axis=0),
            "rounding by hand within the ceiling": np.all(needed <= self.tolerance.ceiling * (1 + 1e-9), axis=0),
        }

    def tolerances(
        self, variants: Sequence[Variant], asked: Sequence[Quantity], motion: Motion, places: Sequence[int]
    ) -> Table:
        """Relative tolerances of the answers (for an angle in radians), shape (answers, N).

        ``places`` are the indices of the variants, which share one form, in the batch ``motion``. An answer of zero or
        infinity has the floor.
        """
        keys = [(variant.identity, variant.sense, variant.turns, tuple(asked)) for variant in variants]
        new = [i for i, key in enumerate(keys) if key not in self._found]
        if new:
            table = self._new_tolerances([variants[i] for i in new], asked, motion, [places[i] for i in new])
            self._found.update((keys[i], column) for i, column in zip(new, table.T, strict=True))
        return np.stack([self._found[key] for key in keys], axis=1)

    def _new_tolerances(
        self, variants: Sequence[Variant], asked: Sequence[Quantity], motion: Motion, places: Sequence[int]
    ) -> Table:
        errors = self._calculation(variants[0], asked).errors(variants, motion, places)
        chosen = np.array(places, dtype=int)
        found = []
        for quantity, error in zip(asked, errors, strict=True):
            if quantity.is_angle:
                relative = np.radians(error)
            else:
                unit = quantity.unit(variants[0].family.length_unit)
                value = np.abs(np.array([unit.from_si(float(x)) for x in quantity.value(motion)[chosen]]))
                usual = (value > 0) & np.isfinite(value)
                relative = np.where(usual, error / np.where(usual, value, 1.0), 0.0)
            found.append(relative)
        table = np.array(found)
        if np.any(~np.isfinite(table)):
            table = np.where(np.isfinite(table), table, _OF_DATA * self._gain(variants, asked, motion.take(chosen)))
        steps = np.ceil(table / _STEP - 1e-6) * _STEP
        return np.asarray(np.where(table > self.tolerance.floor, steps, self.tolerance.floor))

    def _calculation(self, variant: Variant, asked: Sequence[Quantity]) -> HandCalculation:
        key = (id(variant.form), tuple(asked))
        if key not in self._known:
            calculation = HandCalculation(variant.form, asked, _models(variant, asked))
            self._known[key] = variant.form, calculation  # the form is kept, so that its id stays its own
        return self._known[key][1]

    def _gain(self, variants: Sequence[Variant], asked: Sequence[Quantity], motion: Motion) -> Table:
        on_paper = frame([v.sense for v in variants], [v.turns for v in variants])
        return sensitivity(variants[0].form, columns(variants), on_paper, asked, motion)


def _least_distances(variants: Sequence[Variant], asked: Sequence[Quantity], motion: Motion) -> Table:
    """The least relative distance of each answer from a wrong one, shape (answers, N)."""
    right = np.array([quantity.value(motion) for quantity in asked], dtype=float)
    form, on_paper = variants[0].form, frame([v.sense for v in variants], [v.turns for v in variants])
    wrong = wrong_answers(form, columns(variants), on_paper, asked, motion)
    found = [distances(right, values, asked) for values in wrong.values()]
    return np.asarray(np.min(found, axis=0)) if found else np.full(right.shape, np.inf)


def _models(variant: Variant, asked: Sequence[Quantity]) -> Callable[[int], list[Variant]]:
    """A draw of so many variants of the form, always the same ones; none where the form has but one or none."""

    def drawn(count: int) -> list[Variant]:
        if variant.form.grid_size == 1:
            return []
        drawing = FormDrawing(variant.family, variant.form, asked, Tally(), variant.family.name)
        streams = [Stream("model", number, variant.family.name) for number in range(count)]
        try:
            return drawing.run(streams, [0] * count)
        except (InputError, VerificationError):  # the draw of the students' variants says it, with their keys
            return []

    return drawn
