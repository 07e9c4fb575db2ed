"""What the answers of finished sheets would be by the mistakes that students make, and by other parts of a vector."""

from __future__ import annotations

from collections import defaultdict
from collections.abc import Iterable, Mapping, Sequence

import numpy as np
from msgspec.structs import replace

from variantgen.families.parameters.draw_rules import frame
from variantgen.families.quantities import Quantity, motion_order, split_name
from variantgen.finished.restore import Finished
from variantgen.marking.diagnosis.sliding_mistakes import sliding_mistakes
from variantgen.mechanism.motion import Motion
from variantgen.variants.distractors import wrong_answers
from variantgen.variants.variant import Variant, parameter_arrays, solve_variants

_PARTS = ("", "x", "y")

# By quantity the results of mistakes, and other parts of the same vector, in the unit of the answer.
OfProblem = tuple[Mapping[str, Mapping[str, float]], Mapping[str, Mapping[str, float]]]


def mistakes_of(finished: Finished, wanted: Iterable[tuple[int, int]]) -> dict[tuple[int, int], OfProblem]:
    """Results of mistakes for problems, by the places of students and the numbers of problems.

    Variants of one form that are asked for the same are computed as one batch. Raises InputError as restoring does.
    """
    groups: dict[tuple[str, str, tuple[str, ...]], list[tuple[int, int, Variant]]] = defaultdict(list)
    for place, number in wanted:
        variant = finished.variant(place, number)
        problem = next(problem for problem in finished.record.sheets[place].problems if problem.number == number)
        asked = tuple(answer.quantity for answer in problem.answers)
        groups[variant.family.name, variant.form.name, asked].append((place, number, variant))
    found: dict[tuple[int, int], OfProblem] = {}
    for (_, _, names), members in groups.items():
        own = of_batch([variant for _, _, variant in members], [split_name(name) for name in names])
        found |= {(place, number): item for (place, number, _), item in zip(members, own, strict=True)}
    return found


def of_batch(variants: Sequence[Variant], asked: Sequence[Quantity]) -> list[OfProblem]:
    """The results for variants of one form, in their order."""
    form = variants[0].form
    length = variants[0].family.length_unit
    motion = solve_variants(variants, motion_order(asked))
    on_paper = frame([v.sense for v in variants], [v.turns for v in variants])
    wrong = wrong_answers(form, parameter_arrays(variants), on_paper, asked, motion)
    wrong |= sliding_mistakes(form, asked, motion)
    units = [quantity.unit(length) for quantity in asked]
    parts = [_parts(quantity, motion) for quantity in asked]
    found: list[OfProblem] = []
    for i in range(len(variants)):
        mistakes = {
            quantity.name: {
                name: float(unit.from_si(values[row, i]))
                for name, values in wrong.items()
                if np.isfinite(values[row, i])
            }
            for row, (quantity, unit) in enumerate(zip(asked, units, strict=True))
        }
        others = {
            quantity.name: {name: float(unit.from_si(values[i])) for name, values in own.items()}
            for quantity, unit, own in zip(asked, units, parts, strict=True)
        }
        found.append((mistakes, others))
    return found


def _parts(quantity: Quantity, motion: Motion) -> dict[str, np.ndarray[tuple[int], np.dtype[np.float64]]]:
    """Magnitude and components of the vector of which something is asked, but for what is asked."""
    if not quantity.is_vector or quantity.is_angle:
        return {}
    others = [replace(quantity, component=part) for part in _PARTS if part != quantity.component]
    return {other.name: other.value(motion) for other in others}
