"""A law of time as its file writes it: ``φ = 0.2 t² + 0.1 t``, with its unit, for a problem that has no text."""

from __future__ import annotations

from collections.abc import Mapping
from decimal import Decimal
from types import MappingProxyType
from typing import Any

from variantgen.algebra.expression import (
    Applied,
    Constant,
    Expression,
    Magnitude,
    Raised,
    Ratio,
    SquareRoot,
    Times,
    Total,
    Variable,
)
from variantgen.algebra.normal_form import signed
from variantgen.families.family import Form
from variantgen.families.found_instant import watched
from variantgen.families.parameters.expressions import FamilyExpression, parse
from variantgen.families.parameters.rate_law import RateLaw
from variantgen.families.parameters.units import LENGTHS, UNITS, is_number, short_unit, unit
from variantgen.mechanism.constructions.coordinates import Coordinates
from variantgen.mechanism.constructions.polar import Polar
from variantgen.variants.variant import Variant
from variantgen.wording.formula import (
    Absolute,
    Dotted,
    Equation,
    Formula,
    Fraction,
    Function,
    Index,
    Measured,
    Number,
    Power,
    Product,
    Relation,
    Root,
    Sum,
    Symbol,
    SymbolProperty,
)
from variantgen.wording.language import Language


def law_equations(form: Form, language: Language) -> list[Equation]:
    """The laws of a form, one equation each; the unit of a law of plain numbers stands behind it."""
    found = []
    for name, law in form.laws.items():
        if law.rate is not None:
            found += _RateEquations(form, law.rate, law.is_length, language).all()
            continue
        right = _formula(parse(form.derived[name].text).tree, language, form.symbols)
        if law.plain_unit:
            right = Product((right, language.unit(unit(law.plain_unit))))
        found.append(Equation(_left(form, name, language), right))
    return found


def interval_of(variant: Variant, language: Language) -> Relation:
    """The interval of time of a variant, ``0 ≤ t ≤ 3 s``."""
    form = variant.form
    assert form.interval is not None, "there is an interval"
    values = form.values({name: variant.si(name) for name in form.parameters})
    ends = [float(expression.value(values)) for expression in (form.interval.start, form.interval.end)]
    own = unit("s")
    if form.interval.is_of_place:
        own = unit(variant.family.length_unit if form.laws[form.interval.time].is_length else "deg")
    start, end = (_number(own.from_si(value), language) for value in ends)
    name = language.symbol(form.interval.time, form.symbols)
    is_back = ends[1] < ends[0]  # of a place that is passed from its larger values to the smaller ones
    return Relation((start, name, Measured(end, language.unit(own))), ("≥", "≥") if is_back else ("≤", "≤"))


class _RateEquations:
    """The equations of a law that is given by its velocity or acceleration: what it is, that rate, its start."""

    def __init__(self, form: Form, rate: RateLaw, is_length: bool, language: Language) -> None:
        self._form, self._rate, self._language = form, rate, language
        self._own = language.symbol(rate.name, form.symbols)
        length = next((name for name in LENGTHS if name == rate.unit), "m")
        self._units = (length, f"{length}/s", f"{length}/s^2") if is_length else ("deg", "rad/s", "rad/s^2")
        if rate.unit and not is_length:
            self._units = (rate.unit, f"{rate.unit}/s", f"{rate.unit}/s^2")

    def all(self) -> list[Equation]:
        """All of them."""
        left = _left(self._form, self._rate.name, self._language)
        found = [Equation(left.items[0], self._own)] if isinstance(left, Relation) else []
        found.append(Equation(Dotted(self._own, self._rate.order), self._stated()))
        start = self._rate.start
        if start is None:
            return found
        where = self._rate.name if self._rate.is_by_place else self._rate.variable
        begun = self._language.symbol(where, self._form.symbols)
        found.append(Equation(_at_start(begun), self._number(start.where, 0 if self._rate.is_by_place else None)))
        if start.value is not None:
            found.append(Equation(_at_start(self._own), self._number(start.value, 0)))
        if start.rate is not None:
            found.append(Equation(Dotted(_at_start(self._own), 1), self._number(start.rate, 1)))
        return found

    def _stated(self) -> Formula:
        """The rate as it is written, with the unit of its plain numbers."""
        text, order = self._rate.text, self._rate.order
        if is_number(text):
            si = float(FamilyExpression("", self._rate.tree).value({})) * self._scale
            own = short_unit(si, unit(self._units[order]))
            return Measured(_number(own.from_si(si), self._language), self._language.unit(own))
        right = _formula(parse(text).tree, self._language, self._form.symbols, self._letters)
        return Product((right, self._language.unit(unit(self._units[order])))) if self._rate.unit else right

    @property
    def _letters(self) -> dict[str, Formula]:
        """What the names in the rate stand for: the law, and its velocity as a file calls it in an acceleration."""
        velocity = "omega" if self._units[0] in ("deg", "rad", "rev") else "v"
        found: dict[str, Formula] = {self._rate.name: self._own}
        known = {*self._form.parameters, *self._form.derived}
        return found if velocity in known else {**found, velocity: Dotted(self._own, 1)}

    @property
    def _scale(self) -> float:
        return unit(self._rate.unit).size if self._rate.unit else 1.0

    def _number(self, item: Expression, order: int | None) -> Formula:
        """A value at the start: of the law (order 0), of its velocity (1), or of the time (None)."""
        if self._rate.unit and isinstance(item, Ratio):  # a parameter through the unit of the plain numbers
            item = item.above
        if not isinstance(item, Constant):
            return _formula(item, self._language, self._form.symbols)
        if order is None:
            return Measured(_number(item.value, self._language), self._language.unit(unit("s")))
        si = item.value * self._scale
        own = short_unit(si, unit(self._units[order])) if order else unit(self._units[order])
        return Measured(_number(own.from_si(si), self._language), self._language.unit(own))


def _at_start(symbol: Symbol) -> Symbol:
    """The symbol with the index 0."""
    return symbol._replace(index=(*symbol.index, Index("0")))


def event_of(variant: Variant, language: Language) -> Equation:
    """What happens at the instant that is found, ``v_B = 2 m/s``."""
    form, event = variant.form, variant.form.found_instant
    assert event is not None, "the instant is found"
    quantity = watched(form)
    left = language.symbol(event.name, form.symbols) if quantity is None else language.quantity(quantity, form.symbols)
    return Equation(left, Measured(language.decimal(event.value), language.unit(unit(event.unit))))


def _left(form: Form, law: str, language: Language) -> Formula:
    """The letter of a law, after what it is in the scene: ``OB = s``, the angle of OA with the x axis, ``x_B = s``."""
    own = language.symbol(law, form.symbols)
    for name, template in form.points.items():
        stated = [field for field, value in template.fields.items() if _is_law(value, law)]
        if not stated or template.component not in (Polar, Coordinates):
            continue
        if template.component is Coordinates:
            return Relation((language.symbol(f"{stated[0]}_{name}", form.symbols), own), ("=",))
        line = language.symbol(template.fields["origin"] + name, form.symbols)
        return Relation((SymbolProperty("angle", line) if stated[0] == "angle" else line, own), ("=",))
    return own


def _is_law(value: Any, law: str) -> bool:
    return isinstance(value, FamilyExpression) and value.text.strip() == law


def _formula(
    item: Expression,
    language: Language,
    symbols: Mapping[str, str],
    letters: Mapping[str, Formula] = MappingProxyType({}),
) -> Formula:
    """An expression; ``letters`` are the formulas of names that stand for something else in it."""

    def of(part: Expression) -> Formula:
        return _formula(part, language, symbols, letters)

    match item:
        case Constant(value):
            return _number(value, language)
        case Variable(name) if name in letters:
            return letters[name]
        case Variable(name) if name.endswith("_dot"):
            return Dotted(language.symbol(name.removesuffix("_dot"), symbols), 1)
        case Variable(name):
            return language.unit(unit(name)) if name in UNITS and name != "in" else language.symbol(name, symbols)
        case Total(terms):
            return Sum(tuple((sign, of(term)) for sign, term in terms))
        case Times((first, *others)) if (found := signed(first))[0] < 0:
            return Sum(((-1, of(Times((found[1], *others)))),))
        case Ratio(above, below) if (found := signed(above))[0] < 0:
            return Sum(((-1, of(Ratio(found[1], below))),))
        case Times((Constant(value), Variable(name))) if name in UNITS and name not in letters:
            return Measured(_number(value, language), language.unit(unit(name)))
        case Times(factors):
            return Product(tuple(of(factor) for factor in factors))
        case Ratio(above, below):
            return Fraction(of(above), of(below))
        case Raised(base, exponent):
            return Power(of(base), exponent)
        case SquareRoot(inner):
            return Root(of(inner))
        case Magnitude(inner):
            return Absolute(of(inner))
        case Applied(function, argument):
            from variantgen.wording.solution.phrases import load_phrases  # few laws have functions

            return Function(load_phrases(language.name).functions[function], of(argument))
    raise TypeError(f"no formula for {item!r}")


def _number(value: float, language: Language) -> Number:
    return language.decimal(Decimal(f"{value:.12g}"))
