"""Expressions of a solution as formulas: in symbols, and with the printed numbers in their place."""

from __future__ import annotations

from decimal import Decimal

from variantgen.algebra.decimals import ANGLE, DRAWING_LENGTH, PRINTED_DIGITS, rounded
from variantgen.algebra.expression import (
    Applied,
    Constant,
    Expression,
    Magnitude,
    Pi,
    Raised,
    Ratio,
    SquareRoot,
    Times,
    Total,
    Value,
)
from variantgen.algebra.substitution import vanishes
from variantgen.algebra.triples import ratio
from variantgen.families.parameters.units import unit
from variantgen.wording.formula import (
    Absolute,
    Formula,
    Fraction,
    Function,
    Measured,
    Number,
    Power,
    Product,
    Root,
    Sum,
    Surd,
    Symbol,
    UnitText,
)
from variantgen.wording.language import Language, as_fraction
from variantgen.wording.solution.quantity_symbols import Symbols

_SHORT_SUM = 2  # terms
_EXACT = 1e-9  # degrees


class Formulas:
    """Writes the expressions of one variant in a language; ``units`` gives the name of the unit of a measure."""

    def __init__(self, symbols: Symbols, length_unit: str) -> None:
        self.symbols = symbols
        self.language: Language = symbols.language
        self._units = {
            "length": length_unit,
            "velocity": f"{length_unit}/s",
            "acceleration": f"{length_unit}/s^2",
            "angle": "deg",
            "angular velocity": "rad/s",
            "angular acceleration": "rad/s^2",
            "time": "s",
            "drawing length": "mm",
        }

    def number(self, value: float) -> Number:
        """A printed number, with the decimal mark of the language."""
        text = repr(value)
        # What is written out already is quicker than an exact number of the same digits.
        if "e" in text:
            return self.language.decimal(Decimal(text))
        return self.language.written(text.removesuffix(".0"))

    def unit(self, value: Value) -> UnitText:
        """The unit of a value; none for a bare number."""
        name = value.unit or self._units.get(value.measure, "1")
        return self.language.unit(unit(name))

    def measured(self, value: Value) -> Formula:
        """A value as number and unit."""
        return Measured(self.printed(value), self.unit(value))

    def printed(self, value: Value) -> Number:
        """The printed number; what is rounded has zeros at its end too, a length on a drawing always its tenths."""
        places = 1 if value.measure == DRAWING_LENGTH else value.decimals
        return self.language.fixed(value.shown, places) if places > 0 else self.number(value.shown)

    def symbol(self, value: Value) -> Formula:
        """The symbol of a value; one without a name is its number, an angle the short sum that it is."""
        if value.name is not None:
            return self.symbols.of(value.name)
        if value.measure == "angle" and value.expression is not None and _is_short(value.expression):
            return self.symbolic(value.expression)
        return self.measured(value)

    def symbolic(self, item: Expression) -> Formula:
        """An expression in symbols."""
        return self._written(item, numbers=False)

    def numeric(self, item: Expression) -> Formula:
        """An expression with the printed numbers."""
        return self._written(item, numbers=True)

    def _written(self, item: Expression, numbers: bool) -> Formula:
        match item:
            case Value():
                return self._value(item) if numbers else self.symbol(item)
            case Constant(value, measure):
                degrees = measure == "angle"
                if not degrees and (whole := as_fraction(Decimal(repr(value)))) is not None:
                    return Fraction(self.number(whole.numerator), self.number(whole.denominator))
                return Measured(self.number(value), self.language.unit(unit("deg"))) if degrees else self.number(value)
            case Pi():
                return Symbol("pi")
            case Total(terms):
                # In numbers a term that is zero now says nothing; in symbols it belongs to the law.
                kept = [(s, t) for s, t in terms if not vanishes(t)] if numbers else terms
                signed = tuple(self._signed(sign, term, numbers) for sign, term in kept or terms)
                return signed[0][1] if len(signed) == 1 and signed[0][0] > 0 else Sum(signed)
            case Times(factors):
                return Product(tuple(self._written(factor, numbers) for factor in factors))
            case Ratio(Value(measure="angle") as whole, Constant(parts)) if numbers and _comes_out(whole.shown / parts):
                degree = self.language.unit(unit("deg"))
                return Measured(self.number(rounded(whole.shown / parts, PRINTED_DIGITS, ANGLE)), degree)
            case Ratio(above, below):
                return Fraction(self._written(above, numbers), self._written(below, numbers))
            case Raised(base, exponent):
                # The square of a negative number is that of its magnitude.
                bare = without_sign(base) if numbers and exponent % 2 == 0 else base
                return Power(self._written(bare, numbers), exponent)
            case SquareRoot(inner):
                return Root(self._written(inner, numbers))
            case Magnitude(inner):
                return Absolute(self._written(inner, numbers))
            case Applied(function, argument) if numbers and (found := ratio(function, argument.number(True))):
                return Surd(*found, 1)
            case Applied(function, argument):
                return Function(self.symbols.phrases.functions[function], self._written(argument, numbers))
        raise TypeError(f"no formula for {item!r}")

    def _value(self, value: Value) -> Formula:
        """The printed number of a value; only an angle keeps its unit inside a formula."""
        if value.measure == "angle":
            return self.measured(value)
        whole = as_fraction(Decimal(repr(value.shown))) if value.expression is None else None
        if whole is not None:
            return Fraction(self.number(whole.numerator), self.number(whole.denominator))
        return self.printed(value)

    def _signed(self, sign: int, term: Expression, numbers: bool) -> tuple[int, Formula]:
        """A term of a sum; the signs of negative numbers are taken out of it, and of the factors of a product."""
        if not numbers:
            return sign, self._written(term, numbers)
        factors = term.factors if isinstance(term, Times) else (term,)
        bare = tuple(without_sign(factor) for factor in factors)
        for factor, plain in zip(factors, bare, strict=True):
            sign = sign if plain is factor else -sign
        return sign, self._written(Times(bare) if isinstance(term, Times) else bare[0], numbers)


def _comes_out(angle: float) -> bool:
    """Whether a part of a printed angle has no more decimals than an angle is printed with."""
    return abs(angle - rounded(angle, PRINTED_DIGITS, ANGLE)) < _EXACT


def _is_short(item: Expression) -> bool:
    """Whether a sum of angles is short enough to be written in place of its number."""
    terms = [term for _, term in item.terms] if isinstance(item, Total) else [item]
    return (
        not isinstance(item, Constant)
        and len(terms) <= _SHORT_SUM
        and all(isinstance(term, Constant | Ratio | Times | Value) for term in terms)
    )


def without_sign(item: Expression) -> Expression:
    """A negative printed number as its magnitude; anything else as it is, an angle with its sign inside a function."""
    if isinstance(item, Value) and item.shown < 0:
        bare = Value(None, item.measure, -item.exact)
        bare.shown = -item.shown
        return bare
    return item
