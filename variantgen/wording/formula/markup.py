"""The walk over a formula, the same for every markup; a markup says how the pieces are written."""

from __future__ import annotations

from abc import ABC, abstractmethod
from collections.abc import Mapping, Sequence
from enum import Enum
from typing import ClassVar

from msgspec import Struct

from variantgen.wording.formula import precedence
from variantgen.wording.formula.precedence import Between
from variantgen.wording.formula.tree import (
    Absolute,
    Cross,
    Dotted,
    Equation,
    Formula,
    FormulaList,
    Fraction,
    Function,
    Graph,
    Index,
    Measured,
    Number,
    Parenthesised,
    PointCoordinates,
    Power,
    Product,
    Quotient,
    Relation,
    Root,
    Sum,
    Surd,
    Symbol,
    SymbolProperty,
    UnitText,
    Vector,
)


class Signs(Struct, frozen=True):
    """The signs of a markup, with the spaces around them."""

    minus: str  # before a first term
    terms: Mapping[int, str]  # plus and minus between terms
    factors: Mapping[Between, str]
    cross: str
    equals: str
    relations: Mapping[str, str]
    comma: str
    semicolon: str
    before_unit: str


class Mark(Enum):
    """What is above a letter."""

    NONE = "nothing"
    ARROW = "arrow"
    DOT = "one dot"
    DOTS = "two dots"


# As characters that combine with the letter before them.
MARKS_ABOVE = {
    Mark.NONE: "",
    Mark.ARROW: "\N{COMBINING RIGHT ARROW ABOVE}",
    Mark.DOT: "\N{COMBINING DOT ABOVE}",
    Mark.DOTS: "\N{COMBINING DIAERESIS}",
}


class Markup(ABC):
    """A markup: its signs, and two-dimensional pieces as methods that take markup and return it.

    ``flat`` if fractions and roots are written in the line.
    """

    flat: ClassVar[bool]
    signs: ClassVar[Signs]

    def write(self, formula: Formula) -> str:
        """The markup of a formula."""
        match formula:
            case Symbol():
                return self.symbol(formula)
            case Number(text):
                return self.number(text)
            case Measured() | UnitText():
                return self._measured(formula)
            case Product(factors):
                return self._product(factors)
            case Function(name, argument):
                return self._function(name, argument, None)
            case Sum(terms):
                return self._sum(terms)
            case Fraction(numerator, denominator):
                return self.fraction(
                    self._part(numerator, precedence.as_numerator(numerator, self.flat)),
                    self._part(denominator, precedence.as_denominator(denominator, self.flat)),
                )
            case Power(base, exponent):
                return self._power(base, exponent)
            case Root(radicand):
                return self.root(self._part(radicand, precedence.as_radicand(radicand, self.flat)))
            case Parenthesised(content):
                return self.parentheses(self.write(content))
            case Absolute(content):
                return self.bars(self.write(content))
            case Surd():
                return self._surd(formula)
            case Vector() | Dotted():
                return self._marked(formula, None)
            case Cross(left, right):
                sides = (
                    (left, precedence.as_side_of_cross(left, True, self.flat)),
                    (
                        right,
                        precedence.as_side_of_cross(right, False, self.flat),
                    ),
                )
                return self.signs.cross.join(self._part(*side) for side in sides)
            case _:
                return self._statement(formula)

    def _statement(
        self, formula: Equation | Relation | SymbolProperty | Quotient | FormulaList | PointCoordinates | Graph
    ) -> str:
        """What says something about formulas instead of being a value."""
        match formula:
            case Equation(left, right):
                return self.write(left) + self.signs.equals + self.write(right)
            case Relation(items, signs):
                rest = zip(signs, items[1:], strict=True)
                return self.write(items[0]) + "".join(
                    self.signs.relations[sign] + self.write(item) for sign, item in rest
                )
            case SymbolProperty(what, symbol):
                return self.symbol_property(what, self.symbol(symbol))
            case Quotient(above, below):
                return self.symbol(above) + self.letter(Symbol("/"), None, Mark.NONE) + self.symbol(below)
            case FormulaList(items):
                names = all(isinstance(item, Symbol | UnitText) for item in items)  # no decimal comma among them
                return (self.signs.comma if names else self.signs.semicolon).join(map(self.write, items))
            case PointCoordinates(point, x, y):
                return self.place(
                    self.symbol(point), self.parentheses(self.write(x) + self.signs.semicolon + self.write(y))
                )
            case Graph(start, legs):
                arrows = (self.arrow(self.write(number)) + self.symbol(point) for number, point in legs)
                return self.symbol(start) + "".join(arrows)

    def _part(self, formula: Formula, parentheses: bool) -> str:
        text = self.write(formula)
        return self.parentheses(text) if parentheses else text

    def _measured(self, formula: Measured | UnitText) -> str:
        if isinstance(formula, UnitText):
            return self.unit(formula)
        number, unit = formula.number, formula.unit
        if unit.tight or not unit.parts:
            return self.tight(number, unit)
        return self.number(number.text) + self.signs.before_unit + self.unit(unit)

    def _sum(self, terms: tuple[tuple[int, Formula], ...]) -> str:
        written = []
        for i, (sign, term) in enumerate(terms):
            if i:
                written.append(self.signs.terms[sign])
            elif sign < 0:
                written.append(self.signs.minus)
            written.append(self._part(term, precedence.as_term(sign, term, not i, self.flat)))
        return "".join(written)

    def _product(self, factors: tuple[Formula, ...]) -> str:
        written = []
        for i, factor in enumerate(factors):
            written.append(self._part(factor, precedence.as_factor(factors, i, self.flat)))
            if i + 1 < len(factors):
                written.append(self.signs.factors[precedence.between(factors, i)])
        return "".join(written)

    def _power(self, base: Formula, exponent: int) -> str:
        match base:
            case Function(name, argument) if exponent > 0:  # cos² φ; a negative one would be read as an inverse
                return self._function(name, argument, exponent)
            case _ if precedence.as_base(base, self.flat):
                return self.power(self.parentheses(self.write(base)), exponent)
            case Symbol():
                return self.symbol(base, exponent)
            case Vector() | Dotted():
                return self._marked(base, exponent)
            case _:
                return self.power(self.write(base), exponent)

    def _function(self, name: str, argument: Formula, exponent: int | None) -> str:
        parentheses = precedence.as_argument(argument)
        enclosed = parentheses or isinstance(argument, Parenthesised)
        return self.function(name, exponent, self._part(argument, parentheses), enclosed)

    def _marked(self, formula: Vector | Dotted, exponent: int | None) -> str:
        if isinstance(formula, Vector):
            return self.symbol(formula.symbol, exponent, Mark.ARROW)
        return self.symbol(formula.symbol, exponent, Mark.DOT if formula.count == 1 else Mark.DOTS)

    def _surd(self, surd: Surd) -> str:
        size = str(abs(surd.numerator))
        if surd.radicand == 1:
            text = self.number(size)
        else:
            root = self.root(self.number(str(surd.radicand)))
            text = root if size == "1" else self.coefficient(self.number(size), root)
        if surd.denominator > 1:
            text = self.ratio(text, self.number(str(surd.denominator)))
        return (self.signs.minus if surd.numerator < 0 else "") + text

    def tight(self, number: Number, unit: UnitText) -> str:
        """A number with a unit that follows without a space, or with none."""
        return self.number(number.text) + self.unit(unit)

    def coefficient(self, number: str, root: str) -> str:
        """``40√3``."""
        return number + root

    def ratio(self, numerator: str, denominator: str) -> str:
        """A fraction of a surd: ``√5/2``, where the markup writes in the line narrower than :meth:`fraction`."""
        return self.fraction(numerator, denominator)

    def place(self, point: str, coordinates: str) -> str:
        """``A(3; 4)``."""
        return point + coordinates

    def symbol(self, symbol: Symbol, exponent: int | None = None, mark: Mark = Mark.NONE) -> str:
        """A letter with what is above it, its indices and its exponent; a component in parentheses: ``(a_B/A)_t``."""
        if not symbol.part:
            return self.letter(symbol, exponent, mark)
        whole = self.indexed(self.letter(symbol._replace(part=()), None, mark), symbol.part)
        return whole if exponent is None else self.power(whole, exponent)

    @abstractmethod
    def letter(self, symbol: Symbol, exponent: int | None, mark: Mark) -> str:
        """A letter without parentheses, with what is above it, its indices and its exponent."""

    @abstractmethod
    def indexed(self, whole: str, index: Sequence[Index]) -> str:
        """Parentheses around markup, with an index below them."""

    @abstractmethod
    def number(self, text: str) -> str:
        """A printed number."""

    @abstractmethod
    def unit(self, unit: UnitText) -> str:
        """The words of a unit with their powers."""

    @abstractmethod
    def symbol_property(self, what: str, symbol: str) -> str:
        """What is asked of a symbol, see :class:`SymbolProperty`."""

    @abstractmethod
    def fraction(self, numerator: str, denominator: str) -> str:
        """A fraction."""

    @abstractmethod
    def power(self, base: str, exponent: int) -> str:
        """A power of what is not a letter."""

    @abstractmethod
    def root(self, radicand: str) -> str:
        """A square root."""

    @abstractmethod
    def function(self, name: str, exponent: int | None, argument: str, enclosed: bool) -> str:
        """A function; ``enclosed`` if the argument is in parentheses."""

    @abstractmethod
    def parentheses(self, content: str) -> str:
        """Content in parentheses."""

    @abstractmethod
    def bars(self, content: str) -> str:
        """Content between bars."""

    @abstractmethod
    def arrow(self, above: str) -> str:
        """An arrow of a graph, with what is above it."""
