"""What a form says of its draws: screens, values that go together, hand-friendly grids, poses on paper."""

from __future__ import annotations

from collections.abc import Mapping
from decimal import Decimal
from typing import Any

import numpy as np
from msgspec import Struct, field
from numpy.typing import NDArray

from variantgen.families.parameters.expressions import FamilyExpression
from variantgen.families.parameters.parameter import Parameter
from variantgen.mechanism.arithmetic import Real
from variantgen.mechanism.rows import Frame


class Comparison(Struct, frozen=True):
    """``left < right`` (strict) or ``left <= right``, as written in ``text``."""

    text: str
    left: FamilyExpression
    right: FamilyExpression
    strict: bool

    def holds(self, values: Mapping[str, Real]) -> Any:
        """Whether it holds, per variant."""
        left, right = self.left.value(values), self.right.value(values)
        return np.less(left, right) if self.strict else np.less_equal(left, right)


class Screens(Struct, frozen=True):
    """What a variant must meet. Angles in rad, the others relative to the size or rates of the mechanism.

    ``transmission``: distance from dead points (see Motion.transmission); ``spacing``: smallest distance of two
    hinges, of a hinge from a foreign link in proportion; ``aspect``: largest ratio of the sides; ``slant``: how far
    links that are not horizontal or vertical are from it, so that nobody takes them for it;
    ``inside``: (point, end, end) triples, the point well between the ends; ``require``: comparisons of parameters;
    ``trivial``: smallest size of an answer; ``sensitivity``: largest relative change of an answer per relative
    change of the data; ``ceiling``: the largest relative error that a careful hand calculation may lead to;
    ``mistakes``: how far a plausible mistake must lead from the right answer, relative, to be noticed.
    """

    transmission: float = float(np.radians(30))
    spacing: float = 0.11
    aspect: float = 4.0
    slant: float = 0.0
    trivial: float = 0.04
    sensitivity: float = 10.0
    ceiling: float = 0.03
    mistakes: float = 0.01
    inside: tuple[tuple[str, str, str], ...] = ()
    require: tuple[Comparison, ...] = ()


class TiedValues(Struct, frozen=True):
    """Values of some parameters that go together: one of the ``rows`` is drawn, each with a printed value per name."""

    names: tuple[str, ...]
    rows: tuple[tuple[Decimal, ...], ...]

    def within(self, parameters: Mapping[str, Parameter]) -> TiedValues:
        """The rows that lie on the grids of the parameters."""
        grids = [parameters[name].printed for name in self.names]
        return TiedValues(self.names, tuple(r for r in self.rows if all(v in g for v, g in zip(r, grids, strict=True))))

    def places(self, parameters: Mapping[str, Parameter]) -> dict[str, NDArray[np.int64]]:
        """Per name the places of the values of the rows on its grid, shape (R,)."""
        return {
            name: np.array([parameters[name].printed.index(row[k]) for row in self.rows], dtype=np.int64)
            for k, name in enumerate(self.names)
        }


class HandFriendly(Struct, frozen=True):
    """How hand-friendly variants are drawn: grids in place of those of the form, rows of values that go together.

    ``require``: further comparisons; ``possible``: whether there are such variants at all; ``answers``: whether the
    answers, too, must be short decimals or simple roots.
    """

    parameters: Mapping[str, Parameter] = field(default_factory=dict)
    ties: TiedValues | None = None
    require: tuple[Comparison, ...] = ()
    possible: bool = True
    answers: bool = True


class Pose(Struct, frozen=True):
    """How a scene may be laid on paper: reflected, turned by quarter turns."""

    mirror: bool = True
    quarter_turns: tuple[int, ...] = (0,)

    def frames(self) -> list[tuple[int, int]]:
        """All (sense, quarter turns) pairs."""
        return [(sense, turn) for sense in ((1, -1) if self.mirror else (1,)) for turn in self.quarter_turns]


def frame(sense: Any, quarter_turns: Any) -> Frame:
    """The frame of a pose; exact at all quarter turns. Scalars or arrays."""
    turns = np.array([1.0, 1.0j, -1.0, -1.0j])[np.asarray(quarter_turns) % 4]
    return Frame(turns, np.asarray(sense, dtype=float))
