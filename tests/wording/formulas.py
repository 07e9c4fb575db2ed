"""Formulas to test with: short ways to write them, and lines as they stand in solutions."""

from __future__ import annotations

from variantgen.wording.formula import (
    Cross,
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
    UnitText,
    Vector,
)

CM_PER_S = UnitText((("cm/s", 1),))


def sym(base: str, index: str = "", upper: str = "") -> Symbol:
    """``sym("v", "B")``."""
    return Symbol(base, (Index(index),) if index else (), (Index(upper),) if upper else ())


def num(text: str) -> Number:
    """A number; a hyphen stands for the minus sign."""
    return Number(text.replace("-", "\N{MINUS SIGN}"))


def deg(text: str) -> Measured:
    """An angle in degrees."""
    return Measured(num(text), UnitText((("°", 1),), tight=True))


def cos(argument: Formula) -> Function:
    """A cosine."""
    return Function("cos", argument)


def times(*factors: Formula) -> Product:
    """A product."""
    return Product(factors)


def plus(*terms: Formula) -> Sum:
    """A sum with plus signs."""
    return Sum(tuple((1, term) for term in terms))


def minus(first: Formula, second: Formula) -> Sum:
    """A difference."""
    return Sum(((1, first), (-1, second)))


A, B, C, PHI = sym("a"), sym("b"), sym("c"), sym("phi")

LINES: tuple[Formula, ...] = (
    Relation(
        (
            sym("v", "B"),
            Fraction(times(sym("v", "A"), cos(deg("40.02"))), cos(deg("22.5"))),
            Fraction(times(num("120"), cos(deg("40.02"))), cos(deg("22.5"))),
            Measured(num("99.48"), CM_PER_S),
        ),
        ("=", "=", "="),
    ),
    Equation(
        plus(Vector(sym("a", "B", "n")), Vector(sym("a", "B", "tau"))),
        plus(Vector(sym("a", "A")), Vector(sym("a", "BA", "n")), Vector(sym("a", "BA", "tau"))),
    ),
    Equation(
        sym("v", "B"),
        Root(
            plus(
                Power(sym("v", "A"), 2),
                Power(sym("v", "BA"), 2),
                times(num("2"), sym("v", "A"), sym("v", "BA"), cos(PHI)),
            )
        ),
    ),
    Equation(Vector(sym("a", "C")), Product((num("2"), Cross(Vector(sym("omega", "e")), Vector(sym("v", "r")))))),
)
