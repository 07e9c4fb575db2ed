"""The laws of time of a form: functions that give values at the instant and, as ``x_dot`` and ``x_ddot``, derivatives.

A law may use other laws, whichever stands first in the file.
"""

from __future__ import annotations

from collections.abc import Callable, Iterator, Mapping
from decimal import Decimal
from typing import Any, Protocol

import numpy as np

from variantgen.errors import InputError, Problem
from variantgen.families.course import Interval
from variantgen.families.family import Form
from variantgen.families.parameters.dimensions import Dimension
from variantgen.families.parameters.expressions import FamilyExpression
from variantgen.families.parameters.laws import Law, PlainLaws, fed_measures, split_law
from variantgen.families.parameters.units import Unit
from variantgen.tables import Table

_OWN = ("time", "interval", "instant")  # keys of the table that are no laws
_Stated = tuple[FamilyExpression, Unit | None]  # a law as it is written, and the unit beside it


class Definitions(Protocol):
    """What is known of a form before its laws are read, to which these are added."""

    dimensions: dict[str, Dimension]
    derived: dict[str, FamilyExpression]

    def parsed(self, table: Table, name: str, value: Any) -> FamilyExpression | None:
        """The expression of a key; None for a wrong one, which is noted."""
        ...

    def known_names(self, expression: FamilyExpression) -> None:
        """Raise InputError for an expression with an unknown name."""
        ...

    def define(self, name: str, expression: FamilyExpression, dimension: Dimension | None = None) -> Dimension:
        """Make a name known. Raises InputError."""
        ...


def read_laws(form: Definitions, table: Table, scene: Mapping[str, Any], length: str) -> dict[str, Law]:
    """The laws by name; their values and derivatives become derived quantities of the form.

    ``scene`` is the file, which tells what each law feeds, ``length`` its unit of length. Mistakes are noted.
    """
    if not table.data:
        return {}
    time = table.need("time", str, "t", "the name of the parameter that is the instant")
    if form.dimensions.get(time) != (0, 1):
        table.problem("expected the name of a parameter that is a time", "time", time, 'give it the unit "s"')
        return {}
    table.expect(*_OWN)
    # What depends on the time through other names is written out, so that it is differentiated too.
    moving: dict[str, FamilyExpression] = {}
    for name, expression in form.derived.items():
        whole = expression.inlined(moving)
        if time in whole.names:
            moving[name] = whole
    plain = PlainLaws(time, fed_measures(scene), length)
    found: dict[str, Law] = {}
    for name, (written, named) in _in_order(dict(_stated(form, table))):
        with table.collecting(name):
            form.known_names(written)
            stated = plain.measured(name, written, named, form.dimensions)
            law = (stated.law if stated else written).inlined(moving)
            if time in law.names:
                moving[name] = law
            dimension = form.define(name, law, stated.dimension if stated else None)
            found[name] = Law(stated.unit if stated else "", dimension == (1, 0))
            for i, suffix in enumerate(("_dot", "_ddot"), start=1):
                law = law.derivative(time)
                form.define(name + suffix, law, (dimension[0], dimension[1] - i))
    table.finish()
    return found


def _stated(form: Definitions, table: Table) -> Iterator[tuple[str, _Stated]]:
    """The laws as they are written."""
    for name in [name for name in table.data if name not in _OWN]:
        table.expect(name)
        text, named = split_law(table, name)
        law = form.parsed(table, name, text)
        if law is not None:
            yield name, (law, named)


def _in_order(laws: dict[str, _Stated]) -> Iterator[tuple[str, _Stated]]:
    """Each law after those that it uses; of laws that use each other in a circle the first as it stands."""
    while laws:
        free = (name for name, (law, _) in laws.items() if not law.names & (laws.keys() - {name}))
        name = next(free, next(iter(laws)))
        yield name, laws.pop(name)


def read_interval(table: Table, quantity: Callable[[str, Any], FamilyExpression]) -> Interval | None:
    """The interval of time of the table of laws, ``[0, 3]`` in seconds or with names of times; mistakes are noted."""
    ends = table.data.get("interval")
    if ends is None:
        return None
    right = isinstance(ends, list) and len(ends) == 2
    if not right or any(isinstance(end, bool) or not isinstance(end, int | Decimal | str) for end in ends):
        table.problem("expected its beginning and its end", "interval", ends, 'like [0, 3] in seconds, or [0, "t"]')
        return None
    found: list[FamilyExpression] = []
    for end in ends:
        with table.collecting("interval"):
            found.append(quantity("time", end))
    return Interval(table.data["time"], *found) if len(found) == 2 else None


def check_interval(form: Form) -> None:
    """Raise InputError for an interval that ends before it begins, and for drivers whose motion in it nothing tells."""
    assert form.interval is not None and form.sample.course is not None, "there is an interval"
    problems: list[Problem] = []
    if not np.all(np.less(form.sample.course.start, form.sample.course.end)):
        stated = f"{form.interval.start.text}, {form.interval.end.text}"
        problems.append(Problem("ends before it begins", key="laws.interval", value=stated))
    rates = {f"{law}{dots}" for law in form.laws for dots in ("_dot", "_ddot")}
    for i, template in enumerate(form.drivers, start=1):
        if not template.names & rates:
            said = "its rates are those of an instant, and the laws state an interval of time"
            remedy = "state its motion by a law of time too"
            problems.append(Problem(said, key=f"drivers[{i}]", remedy=remedy))
    if problems:
        raise InputError(problems)
