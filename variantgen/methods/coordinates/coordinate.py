"""The parts of a mechanism in coordinates: what changes with time, and relations of positions."""

from __future__ import annotations

from msgspec import Struct, field

from variantgen.algebra.expression import Value
from variantgen.algebra.normal_form import Maybe
from variantgen.methods.steps.step import Fact


class Coordinate(Struct, eq=False):
    """Something that changes: its value now, its first and second derivative; ``given`` if a driver prescribes it."""

    place: Value
    speed: Value
    acceleration: Value
    given: bool = False


class PositionEquation(Struct, frozen=True, eq=False):
    """A relation of positions, ``left = right``; ``key`` and ``facts`` say what keeps it."""

    key: str
    left: Maybe
    right: Maybe
    facts: dict[str, Fact] = field(default_factory=dict)
