"""When two variants are the same problem, and when they are nearly the same: what tells of it, as arrays.

Two variants are nearly the same if they belong to one form, the same words are chosen, and every number that a sheet
tells of one differs from that of the other by at most :data:`CLOSE` of it, every angle by at most :data:`CLOSE_ANGLE`:
whoever sits beside could copy the answers with a small correction.
"""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import dataclass
from math import log

import numpy as np
from numpy.typing import NDArray

from variantgen.families.quantities import Quantity
from variantgen.variants.needed import told_names
from variantgen.variants.seeding import digest
from variantgen.variants.variant import Variant

CLOSE = 0.03
CLOSE_ANGLE = 2.0  # degrees


@dataclass(frozen=True)
class Traits:
    """What is compared of N variants.

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
        """Those at the given places."""
        return Traits(self.identity[chosen], self.room[chosen], self.place[chosen], self.attempt[chosen])

    @staticmethod
    def joined(parts: Sequence[Traits]) -> Traits:
        """Those of several batches, one after the other."""
        width = max(part.place.shape[1] for part in parts)
        places = [np.pad(part.place, ((0, 0), (0, width - part.place.shape[1]))) for part in parts]
        return Traits(
            np.concatenate([part.identity for part in parts]),
            np.concatenate([part.room for part in parts]),
            np.concatenate(places),
            np.concatenate([part.attempt for part in parts]),
        )


def traits(variants: Sequence[Variant], asked: Sequence[Sequence[Quantity]], groups: Sequence[str]) -> Traits:
    """The traits of variants: only what their sheets tell counts, only those of one group can be nearly the same."""
    identities, rooms, places = [], [], []
    for variant, quantities, group in zip(variants, asked, groups, strict=True):
        told = told_names(variant, quantities)
        alike, place = _place(variant, told)
        values = [(name, str(variant.printed[name])) for name in sorted(told)]
        identities.append(_number("identity", *alike[:2], *values))
        rooms.append(_number("room", group, *alike))
        places.append(place)
    width = max(map(len, places), default=0)
    return Traits(
        np.array(identities, dtype=np.uint64),
        np.array(rooms, dtype=np.uint64),
        np.array([place + [0.0] * (width - len(place)) for place in places], dtype=np.float32).reshape(-1, width),
        np.array([variant.attempt for variant in variants], dtype=np.int64),
    )


def _number(*parts: object) -> int:
    return int.from_bytes(digest(*parts)[:8], "big")


def _place(variant: Variant, told: Sequence[str]) -> tuple[list[str], list[float]]:
    """What must be equal, and coordinates in which a difference of 1 is the largest of nearly the same data."""
    alike, place = [variant.family.name, variant.form.name, *told], []
    for name in told:
        unit, value = variant.form.parameters[name].unit, variant.printed[name]
        if unit is None:
            alike.append(str(value))
        elif unit.measures == "angle":
            # Angles are compared by their difference: 2 and 4 degrees are no further from each other than 62 and 64.
            place.append(float(np.degrees(variant.si(name))) / CLOSE_ANGLE)
        else:
            alike.append(str(value.compare(0)))
            place.append(log(abs(value)) / log(1 + CLOSE) if value else 0.0)
    return alike, place
