"""The laws of time of a form: functions that give values at the instant and, as ``x_dot`` and ``x_ddot``, derivatives.

A law may use other laws, whichever stands first in the file.
"""

from __future__ import annotations

from collections.abc import Callable, Iterator, Mapping
from decimal import Decimal
from typing import Any

import numpy as np

from variantgen.algebra.expression import Raised, Ratio, SquareRoot, Times
from variantgen.algebra.values import walk
from variantgen.errors import InputError, Problem
from variantgen.families.course import Interval
from variantgen.families.family import Form
from variantgen.families.parameters.dimensions import Dimension
from variantgen.families.parameters.expressions import FamilyExpression
from variantgen.families.parameters.laws import Law, PlainLaws, fed_measures, split_law
from variantgen.families.parameters.parameter import Parameter
from variantgen.families.parameters.rate_law import RateLaw, starting_sign
from variantgen.families.parameters.solved_law import SolvedLaw
from variantgen.families.parameters.units import UNITS, Unit
from variantgen.families.reading.definitions import Definitions
from variantgen.families.reading.driven_laws import check_driven
from variantgen.families.reading.rate_reader import Quantity, RateReader, ReadRate, is_rate_law, rates_of
from variantgen.tables import Table

_NOTHING = 1e-9  # of the largest acceleration: a law that begins at rest with it never leaves its place
_BETWEEN = 64  # values of the variable between the start of a law and the instant
_OWN = ("time", "interval", "instant")  # keys of the table that are no laws
_Stated = tuple[FamilyExpression, Unit | None]  # a law as it is written, and the unit beside it


def read_laws(
    form: Definitions,
    table: Table,
    scene: Mapping[str, Any],
    length: str,
    quantity: Quantity,
    parameters: Mapping[str, Parameter],
) -> dict[str, Law]:
    """The laws by name; their values and derivatives become derived quantities of the form.

    ``scene`` is the file, which tells what each law feeds, ``length`` its unit of length, ``quantity`` reads a number
    or an expression of a dimension. Mistakes are noted.
    """
    if not table.data:
        return {}
    place = place_of(table.data, form.dimensions)
    if place and "instant" in table.data:
        remedy = f'leave one of both out; by the time {place} is a law and no parameter: time = "t"'
        table.problem(f"an instant cannot be found where the place {place} is given", "instant", "", remedy)
        return {}
    time = "" if place else table.need("time", str, "t", "the name of the parameter that is the instant")
    if time and form.dimensions.get(time) != (0, 1):
        table.problem("expected the name of a parameter that is a time", "time", time, 'give it the unit "s"')
        return {}
    table.expect(*_OWN)
    rates = RateReader(form, time, quantity, _sample(parameters, form.derived), length)
    reading = _Reading(form, table, time, place, PlainLaws(time or place, fed_measures(scene), length))
    reading.read_rates(rates)
    reading.read_formulas()
    table.finish()
    return reading.found


class _Reading:
    """The laws of a form one after the other: first those given by rates, then formulas, which may use those."""

    def __init__(self, form: Definitions, table: Table, time: str, place: str, plain: PlainLaws) -> None:
        self.found: dict[str, Law] = {}
        self._form, self._table, self._time, self._plain = form, table, time, plain
        self._alone: list[str] = [place] if place else []  # names that no formula of the time stands for
        # What depends on the time through other names is written out, so that it is differentiated too.
        self._moving: dict[str, FamilyExpression] = {}
        for name, expression in form.derived.items():
            whole = expression.inlined(self._moving)
            if (time or place) in whole.names:
                self._moving[name] = whole

    def read_rates(self, rates: RateReader) -> None:
        """The laws that are given by a velocity or an acceleration."""
        for name in [name for name, value in self._table.data.items() if is_rate_law(value)]:
            with self._table.collecting(name):
                if (read := rates.read(self._table, name)) is None:
                    continue
                self.found[name] = read.law
                if read.plain is not None:
                    self._plain.know(name, read.plain)
                _define(self._form, name, read, self._time)
                if read.place is None or isinstance(read.place, SolvedLaw):
                    self._alone.append(name)
                else:
                    self._moving[name] = read.place

    def read_formulas(self) -> None:
        """The laws that are formulas of the time, and their derivatives."""
        form, time = self._form, self._time
        others = {name: rate for name, rate in rates_of(self._alone).items() if name.name != time}
        for name, (written, named) in _in_order(dict(_stated(form, self._table))):
            with self._table.collecting(name):
                form.known_names(written)
                stated = self._plain.measured(name, written, named, form.dimensions)
                law = (stated.law if stated else written).inlined(self._moving)
                if time in law.names:
                    self._moving[name] = law
                dimension = form.define(name, law, stated.dimension if stated else None)
                self.found[name] = Law(stated.unit if stated else "", dimension == (1, 0))
                for i, suffix in enumerate(("_dot", "_ddot"), start=1):
                    law = law.derivative(time, others)
                    form.define(name + suffix, law, (dimension[0], dimension[1] - i))


def _sample(parameters: Mapping[str, Parameter], derived: Mapping[str, FamilyExpression]) -> dict[str, float]:
    """Values (SI) from the middle of the parameters, with what is derived of them."""
    found = {name: float(p.si[len(p.si) // 2]) for name, p in parameters.items()}
    for name, expression in derived.items():
        found[name] = float(expression.value(found))
    return found


def place_of(data: Mapping[str, Any], dimensions: Mapping[str, Dimension]) -> str:
    """The parameter that is the place where the motion is looked at, if laws state no time; "" without one."""
    if "time" in data:
        return ""
    return next((name for name, value in data.items() if is_rate_law(value) and name in dimensions), "")


def _define(form: Definitions, name: str, read: ReadRate, time: str) -> None:
    """Make the place, the velocity and the acceleration of a law by its rate known."""
    length = 1 if read.law.is_length else 0
    if read.place is not None:
        form.define(name, read.place, (length, 0))
    velocity = read.velocity
    if velocity is None:
        assert read.place is not None, "a law without a velocity has a place"
        velocity = read.place.derivative(time)
    form.define(f"{name}_dot", velocity, (length, -1))
    form.define(f"{name}_ddot", read.acceleration or velocity.derivative(time, rates_of([name])), (length, -2))


def _stated(form: Definitions, table: Table) -> Iterator[tuple[str, _Stated]]:
    """The laws as they are written."""
    for name in [name for name, value in table.data.items() if name not in _OWN and not is_rate_law(value)]:
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


def read_interval(
    table: Table, quantity: Callable[[str, Any], FamilyExpression], dimensions: Mapping[str, Dimension]
) -> Interval | None:
    """The interval of the table of laws; mistakes are noted.

    Of time, ``[0, 3]`` in seconds or with names of times, or where laws state a place, of that: ``["30 deg", "phi"]``.
    """
    ends = table.data.get("interval")
    if ends is None:
        return None
    place = place_of(table.data, dimensions)
    measure = ("length" if dimensions[place][0] else "angle") if place else "time"
    example = "the first and the last place" if place else 'like [0, 3] in seconds, or [0, "t"]'
    right = isinstance(ends, list) and len(ends) == 2
    if not right or any(isinstance(end, bool) or not isinstance(end, int | Decimal | str) for end in ends):
        table.problem("expected its beginning and its end", "interval", ends, example)
        return None
    found: list[FamilyExpression] = []
    for end in ends:
        with table.collecting("interval"):
            found.append(quantity(measure, end))
    if len(found) < len(ends):
        return None
    first, last = found
    return Interval(place or table.data["time"], first, last, bool(place))


def check_motion(form: Form, laws: Mapping[str, Any]) -> None:
    """Raise InputError for laws that do not come to the instant, drivers against them, and a wrong interval.

    ``laws`` is the table of the file.
    """
    if form.laws:
        _check_laws(form)
        dimensions = {name: p.unit.dimension if p.unit else (0, 0) for name, p in form.parameters.items()}
        check_driven(form, laws.get("time") or place_of(laws, dimensions))
    if form.interval:
        _check_interval(form)


def _check_interval(form: Form) -> None:
    """Raise InputError for an interval that ends before it begins, and for drivers whose motion in it nothing tells."""
    assert form.interval is not None and form.sample.course is not None, "there is an interval"
    problems: list[Problem] = []
    stated = f"{form.interval.start.text}, {form.interval.end.text}"
    if form.interval.is_of_place:
        if not np.all(np.isfinite(form.sample.course.end)):
            said = f"{form.interval.time} does not come from its first value to its last one by this law"
            problems.append(Problem(said, key="laws.interval", value=stated, remedy="exchange them, or shorten it"))
    elif not np.all(np.less(form.sample.course.start, form.sample.course.end)):
        problems.append(Problem("ends before it begins", key="laws.interval", value=stated))
    rates = {f"{law}{dots}" for law in form.laws for dots in ("_dot", "_ddot")}
    for i, template in enumerate(form.drivers, start=1):
        if not template.names & rates:
            said = "its rates are those of an instant, and the laws state an interval of time"
            remedy = "state its motion by a law of time too"
            problems.append(Problem(said, key=f"drivers[{i}]", remedy=remedy))
    if problems:
        raise InputError(problems)


def _check_laws(form: Form) -> None:
    """Raise InputError for laws by rates that do not come from their start to the instant of the problem."""
    problems = []
    for name, law in form.laws.items():
        if law.rate is None or law.rate.start is None:
            continue
        if law.rate.is_by_place and law.rate.order == 2 and len(_senses(form, law.rate)) > 1:
            said = (
                "starts now forwards, now backwards: the values of its parameters differ in the sense of the velocity"
            )
            remedy = "give the start one sense for all values, or make a form of each"
            problems.append(Problem(said, key=f"laws.{name}.start", value=law.rate.text, remedy=remedy))
            continue
        values = form.values({given: float(p.si[len(p.si) // 2]) for given, p in form.parameters.items()})
        if not _comes_so_far(form, law, law.rate, values):
            at = values[law.rate.variable]
            said = "does not come from its start to the instant of the problem"
            if law.rate.is_by_place:
                why = "its velocity comes to zero before, or leads away"
                said = f"does not come from its start to the place of the problem: {why}"
            stated, remedy = (
                f"{law.rate.variable} = {at:.6g} (SI)",
                "check the signs, or take a value nearer to the start",
            )
            problems.append(Problem(said, key=f"laws.{name}", value=stated, remedy=remedy))
    if problems:
        raise InputError(problems)


def _comes_so_far(form: Form, law: Law, rate: RateLaw, values: Mapping[str, float]) -> bool:
    """Whether place and velocity are defined all the way from the start, and the velocity of a place keeps its sign."""
    assert rate.start is not None
    size = UNITS[rate.unit].size if rate.unit and rate.is_by_place else 1.0
    begun = float(FamilyExpression("", rate.start.where).value(values)) * size
    way = np.linspace(begun, values[rate.variable], _BETWEEN)
    data: dict[str, Any] = {given: np.full(_BETWEEN, values[given]) for given in form.parameters} | {rate.variable: way}
    found = form.values(data)
    names = [f"{rate.name}_dot"] if rate.is_by_place else [rate.name, f"{rate.name}_dot"]
    if not all(np.all(form.derived[name].defined(found)) and _has_no_pole(form.derived[name], found) for name in names):
        return False
    if not rate.is_by_place or np.ptp(way) == 0:
        return True
    velocity, acceleration = (np.broadcast_to(found[rate.name + dots], (_BETWEEN,)) for dots in ("_dot", "_ddot"))
    leaves = velocity[0] != 0 or abs(acceleration[0]) > _NOTHING * np.max(np.abs(acceleration))
    return bool(leaves and np.all(velocity[1:] * (way[-1] - way[0]) > 0))


def _senses(form: Form, rate: RateLaw) -> set[int]:
    """The senses in which a law by its place starts, for the least and the largest value of each parameter."""
    middle = {name: float(p.si[len(p.si) // 2]) for name, p in form.parameters.items()}
    ends = [{name: float(end)} for name, p in form.parameters.items() for end in (np.min(p.si), np.max(p.si))]
    return {starting_sign(rate, form.values(middle | end)) for end in ends}


def _has_no_pole(expression: FamilyExpression, values: Mapping[str, Any]) -> bool:
    """Whether nothing by which it is divided, and no base of a power or a root there, changes its sign on the way."""
    below = [item.below for item in walk(expression.tree) if isinstance(item, Ratio)]
    while below:
        part = below.pop()
        if isinstance(part, Times | Raised | SquareRoot):
            below += part.operands()
            continue
        signs = np.sign(FamilyExpression("", part).value(values))
        if np.ptp(signs) > 0:
            return False
    return True
