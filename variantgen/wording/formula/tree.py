"""The formula tree: written once, rendered to every markup.

Names come from family files and are checked identifiers; numbers and units are text that is quoted on the way out.
Nothing that comes from a roster or an exam file is ever part of a formula.
"""

from __future__ import annotations

import re
from typing import NamedTuple, TypeAlias

from msgspec import Struct

GREEK = {
    "alpha": "α", "beta": "β", "gamma": "γ", "delta": "δ", "epsilon": "ε", "theta": "θ", "lambda": "λ",
    "mu": "μ", "rho": "ρ", "phi": "φ", "psi": "ψ", "omega": "ω", "tau": "τ", "sigma": "σ", "xi": "ξ", "eta": "η",
    "nu": "ν", "kappa": "κ", "chi": "χ", "pi": "π",
    "prime": "′",  # no letter, but a mark that the markups know by its name in the same way
}  # fmt: skip
ANGLE = "\N{ANGLE}"  # before the letters of the three points of an angle, in the base of a symbol
# Letters, numbers and units are named tuples: they are looked up and compared far more often than they are made. No two
# of them may have fields of the same kinds, because then they would be equal.
_LETTERS = re.compile(r"([A-Za-z/′∥⟂])(\d*)")


class Index(NamedTuple):
    """A part of an index: letters of points (italic) or a word (upright)."""

    text: str
    upright: bool = False


class Symbol(NamedTuple):
    """A letter with an index: ``omega`` with ``OA``, ``v`` with ``B`` and ``x``; the base may be a name like OA.

    ``upper`` is what stands above the index, ``part`` what stands below parentheses around all else: the letter of a
    component of an acceleration, normal or tangential, has its place here or there.
    """

    base: str
    index: tuple[Index, ...] = ()  # type: ignore[assignment]  # hides what tuples call so
    upper: tuple[Index, ...] = ()
    part: tuple[Index, ...] = ()

    @property
    def is_name(self) -> bool:
        """Whether the base is more than one letter: a name of points like OA, or O1."""
        return self.base not in GREEK and len(self.base) > 1


class Number(NamedTuple):
    """A number as it is printed in the language of the document."""

    text: str


class UnitText(NamedTuple):
    """A unit as it is printed: words with powers, ``(("см/с", 2),)``; ``tight`` if it follows without a space."""

    parts: tuple[tuple[str, int], ...]
    tight: bool = False


class Measured(NamedTuple):
    """A number with its unit."""

    number: Number
    unit: UnitText


class Equation(Struct, frozen=True):
    """``left = right``."""

    left: Formula
    right: Formula


class SymbolProperty(Struct, frozen=True):
    """What is asked of a symbol: its ``modulus``, its ``angle`` with the x axis, its ``sense``."""

    what: str
    symbol: Symbol


class Quotient(Struct, frozen=True):
    """``ω_1/ω_2``: two symbols in a line, as a ratio that is asked is called."""

    above: Symbol
    below: Symbol


class FormulaList(Struct, frozen=True):
    """Formulas one after the other: points of a plan that coincide, the arguments of a function.

    Commas stand between symbols; semicolons where a number could have a decimal comma.
    """

    items: tuple[Formula, ...]


class Sum(Struct, frozen=True):
    """``a − b + c``: terms with their signs, +1 or −1."""

    terms: tuple[tuple[int, Formula], ...]

    def __post_init__(self) -> None:
        if not self.terms or any(sign not in (1, -1) for sign, _ in self.terms):
            raise ValueError(f"terms with the signs +1 and −1, not {self.terms}")


class Product(Struct, frozen=True):
    """``ω_OA · OA``, ``v_A cos 30°``, ``2 ω``: factors with a dot or a space, as :func:`precedence.between` says."""

    factors: tuple[Formula, ...]

    def __post_init__(self) -> None:
        if not self.factors:
            raise ValueError("a product without factors")


class Fraction(Struct, frozen=True):
    """Numerator over denominator."""

    numerator: Formula
    denominator: Formula


class Power(Struct, frozen=True):
    """A base with a whole exponent."""

    base: Formula
    exponent: int


class Root(Struct, frozen=True):
    """A square root."""

    radicand: Formula


class Function(Struct, frozen=True):
    """``cos φ``, ``arctg(y/x)``: the name is a word as the language prints it."""

    name: str
    argument: Formula


class Parenthesised(Struct, frozen=True):
    """Parentheses where the structure alone would not ask for them."""

    content: Formula


class Absolute(Struct, frozen=True):
    """``|a|``: a modulus."""

    content: Formula


class Vector(Struct, frozen=True):
    """A letter with an arrow above; its index stands without."""

    symbol: Symbol


class Dotted(Struct, frozen=True):
    """A letter with ``count`` dots above, 1 or 2: derivatives with respect to time."""

    symbol: Symbol
    count: int

    def __post_init__(self) -> None:
        if self.count not in (1, 2):
            raise ValueError(f"one or two dots, not {self.count}")


class Cross(Struct, frozen=True):
    """``ω × r``: a vector product."""

    left: Formula
    right: Formula


class PointCoordinates(Struct, frozen=True):
    """``A(3; 4)``: a point with its coordinates."""

    point: Symbol
    x: Formula
    y: Formula


SIGNS = ("=", "≈", "<", "≤", "≥", "→", "∥", "⟂")


class Relation(Struct, frozen=True):
    """``a = b = c ≈ d``: items with one of ``SIGNS`` between each two of them."""

    items: tuple[Formula, ...]
    signs: tuple[str, ...]

    def __post_init__(self) -> None:
        if len(self.signs) != len(self.items) - 1 or not set(self.signs) <= set(SIGNS):
            raise ValueError(f"{len(self.items)} items cannot have the signs {self.signs} between them")


class Surd(Struct, frozen=True):
    """``numerator / denominator · √radicand``: ``40√3/3``, ``−√2``, ``4/3``; whole numbers, the last two positive."""

    numerator: int
    denominator: int
    radicand: int

    def __post_init__(self) -> None:
        if self.denominator < 1 or self.radicand < 1:
            raise ValueError(f"denominator {self.denominator} and radicand {self.radicand} have to be positive")


class Graph(Struct, frozen=True):
    """A chain of links in the notation of graphs: a start, then legs (number of the link, next point).

    Each leg is an arrow with the number above: ``O —1→ A —2→ B``.
    """

    start: Symbol
    legs: tuple[tuple[Formula, Symbol], ...]


Formula: TypeAlias = (
    Symbol | Number | UnitText | Measured | Equation | SymbolProperty | Quotient | FormulaList | Sum | Product
    | Fraction | Power | Root | Function | Parenthesised | Absolute | Vector | Dotted | Cross | PointCoordinates
    | Relation | Surd | Graph
)  # fmt: skip


def letters(text: str) -> list[tuple[str, str]]:
    """``O1A`` as letter and number pairs: ``[("O", "1"), ("A", "")]``; signs as in ``C′/A`` and ``∥AC`` are letters."""
    return [(match[1], match[2]) for match in _LETTERS.finditer(text)]
