"""A law of time as its file writes it: ``φ = 0.2 t² + 0.1 t``, with its unit, for a problem that has no text."""

from __future__ import annotations

from collections.abc import Mapping
from decimal import Decimal
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
from variantgen.families.parameters.units import UNITS, unit
from variantgen.mechanism.constructions.coordinates import Coordinates
from variantgen.mechanism.constructions.polar import Polar
from variantgen.variants.variant import Variant
from variantgen.wording.formula import (
    Absolute,
    Equation,
    Formula,
    Fraction,
    Function,
    Measured,
    Number,
    Power,
    Product,
    Relation,
    Root,
    Sum,
    SymbolProperty,
)
from variantgen.wording.language import Language


def law_equations(form: Form, language: Language) -> list[Equation]:
    """The laws of a form, one equation each; the unit of a law of plain numbers stands behind it."""
    found = []
    for name, law in form.laws.items():
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
    start, end = (float(expression.value(values)) for expression in (form.interval.start, form.interval.end))
    time = language.symbol(form.interval.time, form.symbols)
    last = Measured(_number(end, language), language.unit(unit("s")))
    return Relation((_number(start, language), time, last), ("≤", "≤"))


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


def _formula(item: Expression, language: Language, symbols: Mapping[str, str]) -> Formula:
    def of(part: Expression) -> Formula:
        return _formula(part, language, symbols)

    match item:
        case Constant(value):
            return _number(value, language)
        case Variable(name):
            return language.unit(unit(name)) if name in UNITS and name != "in" else language.symbol(name, symbols)
        case Total(terms):
            return Sum(tuple((sign, of(term)) for sign, term in terms))
        case Times((first, *others)) if (found := signed(first))[0] < 0:
            return Sum(((-1, of(Times((found[1], *others)))),))
        case Ratio(above, below) if (found := signed(above))[0] < 0:
            return Sum(((-1, of(Ratio(found[1], below))),))
        case Times((Constant(value), Variable(name))) if name in UNITS:
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
