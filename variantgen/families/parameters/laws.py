"""Laws of time written with plain numbers, as books do: ``s = "t^2 + t"`` in centimetres and seconds.

Such a law needs a measure. It is that of what the law feeds (``v = "s_dot"`` of a point: a length, in the unit of
length of the file), or that of the unit that is written beside it: ``s = { law = "t^2 + t", unit = "mm" }``.
"""

from __future__ import annotations

from collections.abc import Iterator, Mapping
from typing import Any, NamedTuple

from variantgen.algebra.expression import Constant, Expression, Times, Variable
from variantgen.errors import InputError, Problem
from variantgen.families.parameters.dimensions import Dimension
from variantgen.families.parameters.expressions import FamilyExpression
from variantgen.families.parameters.rate_law import Integrated, RateLaw
from variantgen.families.parameters.units import UNITS, Unit, unit
from variantgen.mechanism.component import DIMENSIONS, discover, field_specs
from variantgen.tables import Table

_MEASURES = {(1, 0): "length", (0, 0): "angle"}
_SECTIONS = {"points": "constructions", "joints": "joints", "drivers": "drivers", "conditions": "conditions"}


class Law(NamedTuple):
    """A law of time: the unit of its plain numbers, empty where its parts have their own; a length or an angle.

    One that is given by its velocity or acceleration has that as its ``rate``, and how it is ``integrated``.
    """

    plain_unit: str
    is_length: bool
    rate: RateLaw | None = None
    integrated: Integrated | None = None

    def rate_measure(self, order: int) -> str:
        """What it measures itself (order 0), its velocity (1), its acceleration (2)."""
        if self.is_length:
            return ("length", "velocity", "acceleration")[order]
        return ("angle", "angular velocity", "angular acceleration")[order]


class MeasuredLaw(NamedTuple):
    """A law of plain numbers in SI, with what it measures and the unit of its numbers."""

    law: FamilyExpression
    dimension: Dimension
    unit: str


def split_law(table: Table, name: str) -> tuple[Any, Unit | None]:
    """The text of a law, and the unit written beside it; a wrong unit is noted in the table."""
    value = table.data[name]
    if not isinstance(value, dict):
        return value, None
    inner = table.table(name)
    text, named = (
        inner.need("law", str, "0", "an expression of the time in quotes"),
        inner.need("unit", str, "m", "a unit"),
    )
    inner.finish()
    found: list[Unit] = []
    with inner.collecting("unit"):
        found.append(_of_law(named))
    return text, found[0] if found else None


def _of_law(named: str) -> Unit:
    """The unit of a law. Raises InputError for one that is not of length or angle."""
    found = unit(named)
    if found.dimension not in _MEASURES:
        known = [other.name for other in UNITS.values() if other.dimension in _MEASURES and other.name != "1"]
        problem = Problem("expected a unit of length or angle", value=named, remedy="one of " + ", ".join(known))
        raise InputError(problem)
    return found


class PlainLaws:
    """The laws of plain numbers of one form: those that have been read, by which another one may be written.

    ``time`` is the instant, ``fed`` the measures of what laws feed, ``length`` the unit of length of the file.
    """

    def __init__(self, time: str, fed: Mapping[str, str], length: str) -> None:
        self._time, self._fed, self._length = time, fed, length
        self._plain: dict[str, FamilyExpression] = {}

    def know(self, name: str, number: FamilyExpression) -> None:
        """Let laws name another one, or a place, by its plain number."""
        self._plain[name] = number

    def measured(
        self, name: str, law: FamilyExpression, named: Unit | None, dimensions: Mapping[str, Dimension]
    ) -> MeasuredLaw | None:
        """The law with its measure, where its numbers are plain; None where its parts have measures of their own.

        ``named`` is the unit beside it. In ``y = "x^2 / 60"`` another law stands for its plain number. Raises
        InputError where neither the unit nor what the law feeds tells the measure.
        """
        fed = self._fed.get(name)
        plain = law.names <= {self._time, *self._plain}
        if named is None and (not plain or self._fits(law, fed, dimensions)):
            return None
        if not plain:
            remedy = "a law with a unit is made of numbers, the time and laws like it; leave the unit out"
            raise InputError(Problem("uses parameters, which have units of their own", value=law.text, remedy=remedy))
        measure = named or UNITS[self._length if fed == "length" else "rad"]
        self._plain[name] = law.inlined(self._plain)
        return MeasuredLaw(
            FamilyExpression(law.text, _times(self._plain[name].tree, measure)),
            measure.dimension,
            named.name if named else self._length if fed == "length" else "rad",
        )

    def _fits(self, law: FamilyExpression, fed: str | None, dimensions: Mapping[str, Dimension]) -> bool:
        """Whether a law without a unit measures what it feeds as it stands. Raises InputError where nothing tells."""
        try:
            own = law.dimension(dimensions)
        except InputError:
            if fed is not None:
                return False
            said = "plain numbers and a time without a measure"
            remedy = f'write the unit beside it: {{ law = "{law.text}", unit = "{self._length}" }} (or "rad", "deg")'
            raise InputError(Problem(said, value=law.text, remedy=remedy)) from None
        return own is None or fed is None or own == DIMENSIONS[fed]


def _times(tree: Expression, measure: Unit) -> Expression:
    """Numbers in a unit as SI; a unit of length stays visible to solutions."""
    if measure.measures == "length":
        return Times((tree, Variable("inch" if measure.name == "in" else measure.name)))
    return tree if measure.size == 1.0 else Times((tree, Constant(measure.size)))


def fed_measures(data: Mapping[str, Any]) -> dict[str, str]:
    """What laws feed: by name the measure that a field with the law or a derivative of it gives the law."""
    found: dict[str, str] = {}
    for section, package in _SECTIONS.items():
        kinds = discover(f"variantgen.mechanism.{package}")
        for kind, fields in _components(data.get(section)):
            specs = {spec.name: spec.dimension for spec in field_specs(kinds[kind])} if kind in kinds else {}
            for name, value in fields.items():
                if not isinstance(value, str) or not specs.get(name):
                    continue
                base, order = _base(value.strip())
                wanted = DIMENSIONS[specs[name]]
                measure = _MEASURES.get((wanted[0], wanted[1] + order))
                if measure and specs[name] != "number":
                    found.setdefault(base, measure)
    return found


def _base(text: str) -> tuple[str, int]:
    """The law behind a name, and which derivative of it is meant."""
    for suffix, order in (("_ddot", 2), ("_dot", 1)):
        if text.endswith(suffix):
            return text.removesuffix(suffix).removeprefix("-"), order
    return text.removeprefix("-"), 0


def _components(section: Any) -> Iterator[tuple[str, Mapping[str, Any]]]:
    """The kinds and fields of a list or table of components, whatever else is wrong with it."""
    items = section.values() if isinstance(section, dict) else section if isinstance(section, list) else ()
    for item in items:
        if isinstance(item, dict):
            yield from ((kind, fields) for kind, fields in item.items() if isinstance(fields, dict))
