"""Laws that a file gives by a velocity or an acceleration: ``s = { a = "6*t - 12", start = { t = 0, s = 0, v = 9 } }``.

Where the law is a parameter (a place), its velocity at that place is wanted: ``s = { a = "-4*s", start = ... }``.
"""

from __future__ import annotations

from collections.abc import Callable, Iterable, Iterator, Mapping
from contextlib import contextmanager
from typing import Any, NamedTuple, TypeAlias

from msgspec.structs import replace

from variantgen.algebra.expression import Constant, Expression, Ratio, Times, Variable
from variantgen.algebra.substitution import substituted
from variantgen.errors import InputError, Problem
from variantgen.families.parameters.dimensions import CONSTANTS, Dimension, dimension_name
from variantgen.families.parameters.expressions import FamilyExpression, parse
from variantgen.families.parameters.laws import Law
from variantgen.families.parameters.rate_law import RateLaw, Start, integrated, starting_sign
from variantgen.families.parameters.solved_law import InitialValue, SolvedLaw
from variantgen.families.parameters.units import Unit, is_number, parse_value, unit
from variantgen.families.reading.definitions import Definitions
from variantgen.tables import Table

_RATES = {"v": 1, "a": 2, "omega": 1, "epsilon": 2}
_LENGTHS = {name for name, (_, dimension) in CONSTANTS.items() if dimension == (1, 0)}
_MEASURES = {
    True: ("length", "velocity", "acceleration"),
    False: ("angle", "angular velocity", "angular acceleration"),
}

Quantity: TypeAlias = Callable[[str, Any], FamilyExpression]  # a number or an expression of a dimension, in SI


class ReadRate(NamedTuple):
    """A law given by a rate: what is stated, and its place, velocity, acceleration in SI.

    The place is None where it is a parameter; a rate where it is the derivative of what stands before it.
    """

    law: Law
    place: FamilyExpression | None
    velocity: FamilyExpression | None
    acceleration: FamilyExpression | None
    plain: FamilyExpression | None  # its plain number, where it has one


def is_rate_law(value: Any) -> bool:
    """Whether a law is stated by its velocity or acceleration."""
    return isinstance(value, dict) and bool(_RATES.keys() & value.keys())


class RateReader:
    """Reads the laws by rates of one form.

    ``time`` is the name of the instant, "" where a place is given; ``sample`` are values of the parameters (SI),
    ``length`` is the unit of length of the file.
    """

    def __init__(
        self, form: Definitions, time: str, quantity: Quantity, sample: Mapping[str, float], length: str
    ) -> None:
        self._form, self._time, self._quantity, self._sample = form, time, quantity, sample
        self._length = length

    def read(self, table: Table, name: str) -> ReadRate | None:
        """The law of a name; None for a wrong one, which is noted."""
        found: list[ReadRate] = []
        inner = table.table(name)
        given = [key for key in _RATES if key in inner.data]
        inner.expect(*_RATES, "start", "unit")
        inner.finish()
        if len(given) != 1:
            inner.problem("expected one rate", "", ", ".join(given), "keep one of v, a, omega, epsilon")
            return None
        with table.collecting(name):
            found.append(self._read(inner, name, given[0]))
        return found[0] if found else None

    def _read(self, table: Table, name: str, key: str) -> ReadRate:
        is_length, order = key in ("v", "a"), _RATES[key]
        own_dimension: Dimension = (1, 0) if is_length else (0, 0)
        by_place = not self._time
        if by_place and self._form.dimensions.get(name) != own_dimension:
            said = f"expected the name of a parameter that is {'a length' if is_length else 'an angle'}, the place"
            remedy = 'or state the parameter that is the instant: time = "t"'
            raise InputError(Problem(said, value=name, remedy=remedy))
        stated = self._unit(table, is_length)
        written = self._written(name, key, table.data[key], stated)
        if order == 1 and f"{name}_dot" in written.names:
            remedy = "state it by the time and the place, or an acceleration"
            raise InputError(Problem("a velocity cannot depend on itself", value=written.text, remedy=remedy))
        plain = self._is_plain(written, name)
        measure = stated if plain or "unit" in table.data else None
        if measure is not None and not plain:
            raise InputError(
                Problem("uses parameters, which have units of their own", value=written.text, remedy="leave unit out")
            )
        if measure is None:
            self._check_dimension(written, name, own_dimension, order)
        start = self._start(table, name, order, is_length, measure)
        own = measure.name if measure else ""
        law = RateLaw(name, name if by_place else self._time, order, written.tree, own, start, written.text)
        return self._made(law, measure, is_length, written.text)

    def _written(self, name: str, key: str, value: Any, measure: Unit) -> FamilyExpression:
        """The rate as an expression, in which v (omega) is the velocity of the law itself; a number with its unit as
        one of the law's.
        """
        if not isinstance(value, str):
            value = str(value)
        elif is_number(value):
            own = unit(measure.name + ("/s", "/s^2")[_RATES[key] - 1])
            return FamilyExpression(value, Constant(float(parse_value(value, own, key))))
        found = parse(value)
        letter = "v" if key in ("v", "a") else "omega"
        if letter in found.names and letter not in self._form.dimensions:
            tree = substituted(found.tree, {Variable(letter): Variable(f"{name}_dot")})
            found = FamilyExpression(value, tree or Constant(0.0))
        known = {self._time, name, f"{name}_dot"}
        if by := found.names - known:
            self._form.known_names(FamilyExpression(value, Times(tuple(Variable(other) for other in sorted(by)))))
        return found

    def _is_plain(self, written: FamilyExpression, name: str) -> bool:
        """Whether it is made of plain numbers; a number with a unit is none."""
        own = {self._time, name, f"{name}_dot"}
        return written.names <= own and not any(written.uses(length) for length in _LENGTHS)

    def _unit(self, table: Table, is_length: bool) -> Unit:
        named = table.take("unit", str, self._length if is_length else "rad")
        found = unit(named)
        if found.measures != ("length" if is_length else "angle"):
            expected = "length, as that of the way" if is_length else "angle"
            raise InputError(Problem(f"expected a unit of {expected}", key=table.key("unit"), value=named))
        return found

    def _check_dimension(self, written: FamilyExpression, name: str, own: Dimension, order: int) -> None:
        known = {**self._form.dimensions, name: own, f"{name}_dot": (own[0], -1)}
        found, due = written.dimension(known), (own[0], -order)
        if found is not None and found != due:
            said = f"is {dimension_name(found)}, expected {dimension_name(due)}"
            raise InputError(Problem(said, value=written.text, remedy="check the units of the parameters in it"))

    def _start(self, table: Table, name: str, order: int, is_length: bool, measure: Unit | None) -> Start | None:
        """The start of a law in its own numbers. Raises InputError where something lacks."""
        by_place, velocity = not self._time, "v" if is_length else "omega"
        needed = {self._time: "time"} if self._time else {}
        needed |= {name: _MEASURES[is_length][0]}
        needed |= {velocity: _MEASURES[is_length][1]} if order == 2 else {}
        example = ", ".join(f"{key} = {'0' if key != velocity else '2'}" for key in needed)
        if "start" not in table.data:
            if by_place and order == 1:
                return None
            said = "missing: a rate tells how the law changes, not where it begins"
            raise InputError(Problem(said, key=table.key("start"), remedy=f"write start = {{ {example} }}"))
        inner = table.table("start")
        inner.expect(*needed)
        inner.finish()
        found: dict[str, Expression] = {}
        for key, dimension in needed.items():
            if key not in inner.data:
                if key == self._time:
                    found[key] = Constant(0.0)
                    continue
                raise InputError(
                    Problem("missing", key=inner.key(key), remedy=f"write start = {{ {example} }} with your numbers")
                )
            with _keyed(inner.key(key)):
                found[key] = self._own_number(inner, key, dimension, measure)
        where = found[name if by_place else self._time]
        return Start(where, None if by_place else found[name], found.get(velocity))

    def _own_number(self, table: Table, key: str, dimension: str, measure: Unit | None) -> Expression:
        """A value of a start in the numbers of the law."""
        value = table.data[key]
        if measure is None or dimension == "time":
            stated = self._quantity(dimension, value)
            return Constant(float(stated.value({}))) if stated.measures else stated.tree
        suffix = "" if dimension in ("length", "angle") else "/s"
        if not isinstance(value, str) or is_number(value):
            if dimension == "angle" and measure.name == "rad" and "deg" in str(value):
                return Times((Constant(float(parse_value(str(value), unit("deg"), key))), Variable("deg")))
            return Constant(float(parse_value(str(value), unit(measure.name + suffix), key)))
        return _over(self._quantity(dimension, value).tree, measure)

    def _made(self, law: RateLaw, measure: Unit | None, is_length: bool, text: str) -> ReadRate:
        """What follows from a law, in SI."""
        found = integrated(law, self._sample)

        def si(tree: Expression | None) -> FamilyExpression | None:
            return None if tree is None else FamilyExpression(text, self._in_si(law, tree, measure))

        place, velocity = si(found.value), si(found.rate)
        stated = si(law.tree)
        if found.way == "numerical":
            place, velocity = self._numerical(law, measure, text)
        # What a formula of the time gives is differentiated, unless the rate is one itself.
        of_time = place is not None and found.way not in ("numerical", "antiderivative")
        if law.order == 1 and not of_time:
            velocity = stated
        acceleration = stated if law.order == 2 and not of_time else None
        own = found.value if of_time or found.way == "antiderivative" else _over(Variable(law.name), measure)
        plain = None if measure is None or own is None else FamilyExpression(text, own)
        return ReadRate(Law(law.unit, is_length, law, found), place, velocity, acceleration, plain)

    def _in_si(self, law: RateLaw, tree: Expression, measure: Unit | None) -> Expression:
        if measure is None:
            return tree
        names = [f"{law.name}_dot", law.name]
        own = {Variable(name): _over(Variable(name), measure) for name in names}
        return _scaled(substituted(tree, own) or Constant(0.0), measure)

    def _numerical(
        self, law: RateLaw, measure: Unit | None, text: str
    ) -> tuple[FamilyExpression | None, FamilyExpression | None]:
        """The place and the velocity by an integrator."""
        start = law.start
        assert start is not None, "what is integrated has a start"
        begun = [part for part in (start.where, start.value, start.rate) if part is not None]
        sign = starting_sign(law, self._sample) if law.is_by_place else 1
        problem = InitialValue(
            FamilyExpression(text, law.tree),
            tuple(FamilyExpression(text, part) for part in begun),
            law.variable,
            law.name,
            law.order,
            measure.size if measure else 1.0,
            sign,
        )
        place, velocity = (SolvedLaw(text, Variable("?"), problem, part) for part in (0, 1))
        return None if law.is_by_place else place, velocity if law.order == 2 else None


@contextmanager
def _keyed(key: str) -> Iterator[None]:
    """Put what is wrong inside under this key."""
    try:
        yield
    except InputError as error:
        raise InputError([replace(problem, key=key) for problem in error.problems]) from None


def _over(tree: Expression, measure: Unit | None) -> Expression:
    """A quantity in SI as a plain number in a unit; as it is without one."""
    if measure is None:
        return tree
    if measure.measures == "length":
        return Ratio(tree, Variable("inch" if measure.name == "in" else measure.name))
    return tree if measure.size == 1.0 else Ratio(tree, Constant(measure.size))


def _scaled(tree: Expression, measure: Unit) -> Expression:
    """Plain numbers in a unit as SI."""
    if measure.measures == "length":
        return Times((tree, Variable("inch" if measure.name == "in" else measure.name)))
    return tree if measure.size == 1.0 else Times((tree, Constant(measure.size)))


def rates_of(names: Iterable[str]) -> dict[Variable, Expression]:
    """The rates of names that stand for themselves in laws: ``s`` changes by ``s_dot``, this by ``s_ddot``."""
    found: dict[Variable, Expression] = {}
    for name in names:
        found |= {Variable(name): Variable(f"{name}_dot"), Variable(f"{name}_dot"): Variable(f"{name}_ddot")}
    return found
