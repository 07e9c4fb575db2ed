"""Equality and near-equality of variants, by printed data.

Two variants are the same problem if their sheets print the same text and numbers and their keys the same answers. How
the figure lies on paper (its mirror image, its turn, what is drawn but not printed) makes another problem only where it
makes another answer.

Two variants are nearly the same if their sheets print the same words, every number of one differs from that of the
other by at most :data:`CLOSE` of it, every angle by at most :data:`CLOSE_ANGLE`, and the answers are of about the same
size (:data:`CLOSE_ANSWER` times at most): whoever sits beside could copy them with a small correction.
"""

from __future__ import annotations

from collections.abc import Sequence
from math import log

import numpy as np
from msgspec import Struct
from numpy.typing import NDArray

from variantgen.families.quantities import Quantity, motion_order
from variantgen.mechanism.motion import Motion
from variantgen.variants.examined import examined
from variantgen.variants.printed_data import given_names
from variantgen.variants.seeding import digest
from variantgen.variants.variant import Variant, is_speeding_up, parameter_arrays, solve_variants

CLOSE = 0.03
CLOSE_ANGLE = 2.0  # degrees
# Answers change by at most ten times as much as the data (the screen of their sensitivity): if one is more than twice
# the other, that has another cause, such as another branch of the mechanism.
CLOSE_ANSWER = 2.0
# Equal answers differ by rounding. They are compared as whole numbers of small steps; the shift keeps the ends of steps
# away from the short numbers that answers often are.
_STEPS, _SHIFT = 1e6, 0.3719
_NOTHING = 1e-9  # SI: what is smaller is zero but for rounding


class Traits(Struct, frozen=True):
    """The data by which N variants are compared.

    ``identity`` is equal for equal problems, ``room`` for those that may be nearly the same, shape (N,) each (hashes of
    64 bits: among a million variants two others meet with a probability of 3e-8, and then one is drawn again in vain).
    Variants of one room are nearly the same if their ``place``, shape (N, D), differs by at most 1 in every coordinate.
    ``attempt`` is that of the draw, shape (N,).
    """

    identity: NDArray[np.uint64]
    room: NDArray[np.uint64]
    place: NDArray[np.float32]
    attempt: NDArray[np.int64]

    def __len__(self) -> int:
        return int(self.identity.size)

    def take(self, chosen: NDArray[np.intp]) -> Traits:
        """The traits at the given indices, shape (K,)."""
        return Traits(self.identity[chosen], self.room[chosen], self.place[chosen], self.attempt[chosen])

    @staticmethod
    def joined(parts: Sequence[Traits]) -> Traits:
        """The traits of several batches, one after the other."""
        width = max(part.place.shape[1] for part in parts)
        places = [np.pad(part.place, ((0, 0), (0, width - part.place.shape[1]))) for part in parts]
        return Traits(
            np.concatenate([part.identity for part in parts]),
            np.concatenate([part.room for part in parts]),
            np.concatenate(places),
            np.concatenate([part.attempt for part in parts]),
        )


def traits(variants: Sequence[Variant], asked: Sequence[Sequence[Quantity]], groups: Sequence[str]) -> Traits:
    """The traits of variants: only what their sheets print counts, only those of one group can be nearly the same."""
    batches: dict[tuple[int, tuple[Quantity, ...]], list[int]] = {}
    for i, (variant, quantities) in enumerate(zip(variants, asked, strict=True)):
        batches.setdefault((id(variant.form), tuple(quantities)), []).append(i)
    identities, rooms, places = [0] * len(variants), [0] * len(variants), [list[float]()] * len(variants)
    for (_, questions), members in batches.items():
        own = [variants[i] for i in members]
        looked_at = examined(own[0].form, questions)
        motion = solve_variants(own, motion_order((*questions, *looked_at)))
        answers, sizes = _answers(questions, motion), _sizes(looked_at, motion)
        words = _words(own, questions)
        for k, i in enumerate(members):
            names = given_names(own[k], questions)
            alike, place = _place(own[k], names)
            identities[i] = _number("identity", *alike, *words[k], *_printed(own[k], names), *answers[k])
            rooms[i] = _number("room", groups[i], *alike, *names, *words[k])
            places[i] = place + sizes[k]
    width = max(map(len, places), default=0)
    return Traits(
        np.array(identities, dtype=np.uint64),
        np.array(rooms, dtype=np.uint64),
        np.array([place + [0.0] * (width - len(place)) for place in places], dtype=np.float32).reshape(-1, width),
        np.array([variant.attempt for variant in variants], dtype=np.int64),
    )


def _number(*parts: object) -> int:
    return int.from_bytes(digest(*parts)[:8], "big")


def _words(variants: Sequence[Variant], asked: Sequence[Quantity]) -> list[list[bool]]:
    """By variant of one form the words that differ on its sheets: whether each driver speeds up or slows down."""
    if motion_order(asked) == 1:
        return [[] for _ in variants]
    form = variants[0].form
    flags = [
        np.broadcast_to(flag, (len(variants),))
        for flag in is_speeding_up(form, form.values(parameter_arrays(variants)))
    ]
    return [[bool(flag[k]) for flag in flags] for k in range(len(variants))]


def _printed(variant: Variant, names: Sequence[str]) -> list[str]:
    """The numbers of a sheet by name: of a rate its magnitude, as the figure shows its sense."""
    parameters = variant.form.parameters
    values = [(name, variant.printed[name], parameters[name].is_rate) for name in sorted(names)]
    return [f"{name}={(abs(value) if unsigned else value).normalize()}" for name, value, unsigned in values]


def _answers(asked: Sequence[Quantity], motion: Motion) -> list[list[str]]:
    """By variant its answers, equal where they differ by rounding only."""
    table = []
    for quantity in asked:
        value = np.asarray(quantity.value(motion), dtype=float)
        if quantity.is_angle:
            steps = np.floor(np.degrees(value) * _STEPS / 100.0 + _SHIFT) % (3.6 * _STEPS)
        else:
            size = np.abs(value)
            usual = (size > _NOTHING) & np.isfinite(size)
            steps = np.where(usual, np.floor(np.log(np.where(usual, size, 1.0)) * _STEPS + _SHIFT), np.inf)
        names = zip(steps.tolist(), (value < -_NOTHING).tolist(), np.isinf(value).tolist(), strict=True)
        table.append([f"{'-' if below else ''}{'far' if far else step}" for step, below, far in names])
    return [list(row) for row in zip(*table, strict=True)]


def _sizes(looked_at: Sequence[Quantity], motion: Motion) -> list[list[float]]:
    """By variant coordinates in which a difference of 1 is the largest of answers of about the same size."""
    table = []
    for quantity in looked_at:
        size = np.abs(np.asarray(quantity.value(motion), dtype=float))
        usual = (size > _NOTHING) & np.isfinite(size) & (not quantity.is_angle)
        table.append(np.where(usual, np.log(np.where(usual, size, 1.0)) / log(CLOSE_ANSWER), 0.0).tolist())
    return [list(row) for row in zip(*table, strict=True)]


def _place(variant: Variant, names: Sequence[str]) -> tuple[list[str], list[float]]:
    """What must be equal, and coordinates in which a difference of 1 is the largest of nearly the same data."""
    alike, place = [variant.family.name, variant.form.name], []
    for name in names:
        parameter, value = variant.form.parameters[name], variant.printed[name]
        assert parameter.unit is not None, "a choice is not printed"
        if parameter.unit.measures == "angle":
            # Angles are compared by their difference: 2 and 4 degrees are no further from each other than 62 and 64.
            place.append(float(np.degrees(variant.si(name))) / CLOSE_ANGLE)
        else:
            alike.append("" if parameter.is_rate else str(value.compare(0)))
            place.append(log(abs(value)) / log(1 + CLOSE) if value else 0.0)
    return alike, place
