"""A batch of attempts at a form, the screens that it passes, and the count of what they reject."""

from __future__ import annotations

from collections import Counter
from collections.abc import Callable, Mapping, Sequence
from typing import Protocol, TypeAlias

import numpy as np
from msgspec import Struct, field
from numpy.typing import NDArray

from variantgen.errors import Problem
from variantgen.families.family import Form
from variantgen.families.parameters.draw_rules import Screens
from variantgen.families.quantities import Quantity
from variantgen.mechanism.motion import Motion
from variantgen.mechanism.rows import Frame
from variantgen.variants.screening import Values
from variantgen.variants.variant import Variant

_FIXED = (
    "all its numbers are fixed, so no other draw can pass: change one of them, or loosen what [screens] of the family"
    " demands"
)

Flags: TypeAlias = Mapping[str, NDArray[np.bool_]]  # by screen, shape (N,)


class Screening(Protocol):
    """Screens in two stages: cheap ones on the whole batch of attempts, expensive ones on the survivors."""

    def of_all(self) -> Flags:
        """The cheap screens, by name, for all attempts of the batch, shape (N,) each."""
        ...

    def of_survivors(self, variants: Sequence[Variant], places: Sequence[int]) -> Flags:
        """The expensive screens, by name, for the variants at these places of the batch, shape (len(places),) each."""
        ...


# Screening of attempts at a form: SI values of their parameters, how they lie on paper, what is asked, their motion.
MakeScreening: TypeAlias = Callable[[Form, Values, Frame, Sequence[Quantity], Motion], Screening]


class RejectionCounts(Struct):
    """The number of attempts, and of those that each screen was the first to reject."""

    attempts: int = 0
    rejected: Counter[str] = field(default_factory=Counter)

    def report(self) -> str:
        """The screens that rejected most, in words."""
        parts = [f"{name}: {count}" for name, count in self.rejected.most_common(4) if count]
        return f"of {self.attempts} draws rejected by " + "; ".join(parts)


class Attempts(Struct, frozen=True):
    """A batch of attempts: grid indices per parameter, pose, which student each belongs to; its motion if solved."""

    index: dict[str, NDArray[np.int64]]
    pose: NDArray[np.int64]
    owner: NDArray[np.int64]
    number: NDArray[np.int64]
    motion: Motion | None = None

    def take(self, chosen: NDArray[np.int64]) -> Attempts:
        """The attempts at the given indices, an array of shape (K,) or a mask of shape (N,)."""
        return Attempts(
            {name: i[chosen] for name, i in self.index.items()},
            self.pose[chosen],
            self.owner[chosen],
            self.number[chosen],
            self.motion.take(chosen) if self.motion is not None else None,
        )


def starts(owner: NDArray[np.int64]) -> NDArray[np.int64]:
    """Indices at which the attempts of each owner begin, shape (owners,); attempts are in the order of their owners."""
    return np.flatnonzero(np.concatenate(([True], owner[1:] != owner[:-1])))


def joined(parts: Sequence[Attempts]) -> Attempts:
    """Attempts of one form after each other, without their motion."""
    return Attempts(
        {name: np.concatenate([part.index[name] for part in parts]) for name in parts[0].index},
        np.concatenate([part.pose for part in parts]),
        np.concatenate([part.owner for part in parts]),
        np.concatenate([part.number for part in parts]),
    )


def no_valid_variant(form: Form, tally: RejectionCounts, where: str) -> Problem:
    """What to say where all draws of a form fail: which screens rejected them, and what to loosen."""
    narrow = [name for name, p in form.parameters.items() if p.given and len(p.printed) <= 2]
    given = [name for name, p in form.parameters.items() if p.given]
    which = ", ".join(narrow or given)
    remedy = f"widen the range of one of: {which}" if given else _FIXED
    remedy += ", ask for less, or leave nice out" if form.friendly or form.ties is not None else ""
    if form.screens.ceiling < Screens().ceiling:
        remedy += f", or raise the ceiling of its screens ({form.screens.ceiling:g})"
    message = "no valid variant found: " + tally.report()
    return Problem(message, key=f"{where}{'/' + form.name if form.name else ''}", remedy=remedy)
