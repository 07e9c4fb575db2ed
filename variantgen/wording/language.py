"""A language: its fixed words, habits and unit names, read from ``templates/words/<language>.toml``.

All that is peculiar to a language stands in that file: its decimal mark, the order of its letters, its name for LaTeX,
its plural rules. A word that has several forms has a key for each, ``body`` and ``body.of``; the names of the forms are
the language's own, a phrase asks for them as ``{body.of}``.
"""

from __future__ import annotations

import re
from collections.abc import Mapping
from decimal import Decimal
from fractions import Fraction
from functools import cache
from math import isfinite

from msgspec import Struct

from variantgen.algebra.decimals import rounded, rounded_to_digits
from variantgen.families.parameters.units import Unit
from variantgen.families.quantities import Quantity, recorded
from variantgen.families.quantities.interval_kinds import INSTANT_OF, ZERO
from variantgen.families.quantities.kinds import ANGLE_OF, ROPE
from variantgen.resources import templates_dir
from variantgen.tables import read_toml
from variantgen.wording.formula import GREEK, Index, Number, Quotient, Symbol, SymbolProperty, UnitText
from variantgen.wording.formula.tree import ANGLE
from variantgen.wording.notation import USUAL, Notation
from variantgen.wording.plurals import plural_category
from variantgen.wording.words import Words, check_language

NATURAL = {"t": "tau", "n": "n"}  # components of an acceleration along its path, as solutions call them
_DIRECTIONS = {"along": "∥", "across": "⟂"}  # before the letters of a line, in the index of a component
_OF_TURN = ("max", "min", "mean")
_TO_AND_FRO = {"stroke": "s", "swing": "psi", "time_ratio": "k"}
_OF_INTERVAL = {
    "way": "s",
    "shift": "d",
    "turned": "theta",
    "average_v": "v",
    "average_a": "a",
    "t_back": "t",
    "duration": "T",
}
_ABOUT = {"abs": "modulus", "angle": "angle", "sense": "sense"}
_ALPHA = {"epsilon": "alpha", "alpha": "delta"}
_DECIMALS, _DENOMINATOR = 12, 999  # digits of a quotient that does not come out, largest denominator that is printed
ANSWER_DIGITS = 4  # significant digits of a printed answer


class Language(Struct, frozen=True, eq=False):
    """Words by table and key; numbers and units in the habits of the language. There is one of each."""

    name: str
    tables: Mapping[str, Mapping[str, str]]
    notation: Notation

    @property
    def decimal_mark(self) -> str:
        """What stands between whole number and decimals."""
        return self.tables["language"]["decimal_mark"]

    def counted(self, number: int, what: str) -> str:
        """So many of something from the table ``plurals``: ``21 points``, ``21 балл``."""
        category = plural_category(self.tables["plural_rules"], number)
        return f"{number}\N{NO-BREAK SPACE}{self.tables['plurals'][f'{what}.{category}']}"

    def words(self, table: str) -> Mapping[str, str]:
        """All words of one table (``sheet``, ``key``, ...)."""
        return self.tables[table]

    def decimal(self, value: Decimal) -> Number:
        """An exact printed value: ``0,25``, with a true minus sign; a fraction that is no decimal as ``13/6``."""
        whole = as_fraction(value)
        return self.written(str(whole) if whole is not None else f"{value.normalize():f}")

    def written(self, text: str) -> Number:
        """A number that is written out with a point: with the mark of the language, and with a true minus sign."""
        return Number(text.replace("-", "\N{MINUS SIGN}").replace(".", self.decimal_mark))

    def fixed(self, value: float, places: int) -> Number:
        """A reading with so many decimals, zeros kept: ``48,0``."""
        return self.written(f"{value:.{places}f}")

    def rounded(self, value: float, digits: int = ANSWER_DIGITS) -> Number:
        """A computed value with the given number of significant digits, never in exponent form."""
        return self.written(round_text(value, digits))

    def answer(self, quantity: Quantity, value: float) -> Number:
        """The value of an answer as it is recorded; a short decimal has no zeros after it: 15, as in the steps."""
        value, digits = recorded(quantity, value), 1 if quantity.component == "sense" else ANSWER_DIGITS
        exact = isfinite(value) and rounded(value, digits) == value
        return self.decimal(Decimal(repr(value + 0.0))) if exact else self.rounded(value, digits)

    def unit(self, measured: Unit) -> UnitText:
        """A unit as it is printed."""
        return _unit_text(self.tables["units"][measured.name])

    def letter(self, kind: str) -> str:
        """The letter of a kind of quantity; where alpha is an angular acceleration, an angle alpha is written delta."""
        return _ALPHA.get(kind, kind) if self.notation.angular_acceleration == "alpha" else kind

    def axis(self, letter: str) -> str:
        """The letter of an axis and of the component along it: the tangent ``tau`` may be ``t``."""
        return self.tables["axes"].get(letter, letter)

    def with_component(self, symbol: Symbol, part: str) -> Symbol:
        """The symbol of the part ``n`` or ``tau`` of an acceleration: ``a^tau_BA``, ``(a_B/A)_t``."""
        normal = self.notation.components == "normal"
        mark = Index(self.axis(part)) if normal else Index(self.tables["index"][part], True)
        if self.tables["language"]["components"] == "above":
            return symbol._replace(upper=(*symbol.upper, mark))
        return symbol._replace(part=(*symbol.part, mark))

    def carrying(self, point: str) -> tuple[Index, ...]:
        """The index of the place of a moving body at which a point is now: ``C′``, or a word before ``C``."""
        parts = self.tables["language"]["carrying_point"].split()
        return tuple(Index(part.format(point), "{" not in part) for part in parts)

    def relative_to(self, point: str, base_point: str) -> Index:
        """The index of a vector of one point as seen from another: ``BA``, ``B/A``."""
        return Index(self.tables["language"]["base_point"].format(point, base_point))

    def symbol(self, name: str, bodies: Mapping[str, str]) -> Symbol:
        """The symbol of a parameter, point, body or quantity name; ``bodies`` replaces index words (see [symbols])."""
        kind, _, rest = name.partition("_")
        if not rest:
            return Symbol(self.letter(bodies.get(name, name) or name))
        index: list[Index] = []
        if kind in ("v", "a") and rest.startswith(("rel_", "cor_")):
            word, _, rest = rest.partition("_")
            index.append(Index(self.tables["index"][word], True))
        target, _, component = rest.partition(".")
        target = bodies.get(target, target)
        if target:
            target = self.axis(target) if kind in ("v", "a") else target
            index.append(Index(target, len(target) > 1 and target.islower() and target not in GREEK))
        if kind == "a" and component in NATURAL:
            return self.with_component(Symbol(self.letter(kind), tuple(index)), NATURAL[component])
        if component:
            index.append(Index(component))
        return Symbol(self.letter(kind), tuple(index))

    def quantity(self, quantity: Quantity, bodies: Mapping[str, str]) -> Symbol | SymbolProperty | Quotient:
        """The symbol of an asked quantity."""
        target, component = quantity.target, quantity.component
        if quantity.is_of_turn:
            return self._of_turn(quantity, bodies)
        if quantity.is_of_interval:
            return self._of_interval(quantity, bodies)
        if quantity.group == "difference":
            return self._of_pair(quantity)
        if quantity.is_centre:
            body = tuple(Index(name) for name in (bodies.get(target, target),) if name)
            if quantity.is_coordinate:
                return Symbol(component, (Index(quantity.kind), *body))
            return Symbol(component + quantity.kind, body)
        if quantity.group == "rope":
            return self.of_rope(target, component, bodies)
        if quantity.group == "ratio":
            return Quotient(self.symbol(f"omega_{target}", bodies), self.symbol(f"omega_{component}", bodies))
        if quantity.kind == "distance":
            return Symbol(target + component)
        if quantity.kind == "angle":
            corner, _, last = component.partition(".")
            return Symbol(ANGLE + target + corner + last) if component else self.symbol(f"phi_{target}", bodies)
        if quantity.line:
            return self.symbol(f"{quantity.whole_name}.{on_line(component)}", bodies)
        if quantity.component in _ABOUT:
            return SymbolProperty(_ABOUT[quantity.component], self.symbol(quantity.whole_name, bodies))
        return self.symbol(quantity.name, bodies)

    def of_rope(self, start: str, end: str, symbols: Mapping[str, str]) -> Symbol:
        """The speed of a rope between two stations; of a belt, which ``symbols`` name, with the word for one."""
        word = self.tables["index"][symbols.get(f"{ROPE}.{start}.{end}", "rope")]
        return Symbol("v", (Index(word, True), Index(start + end)))

    def _of_pair(self, quantity: Quantity) -> Symbol | SymbolProperty:
        """``v_B/A``, its component ``v_B/A x``, its direction."""
        whole = Symbol(self.letter(quantity.kind), (self.relative_to(*quantity.pair),))
        if quantity.component in _ABOUT:
            return SymbolProperty(_ABOUT[quantity.component], whole)
        part = on_line(quantity.component) if quantity.line else quantity.component
        return whole._replace(index=(*whole.index, Index(part))) if part else whole

    def _of_turn(self, quantity: Quantity, bodies: Mapping[str, str]) -> Symbol:
        """``v_B max``, ``φ_v_B max``, ``ω_BC mean``; the letters of a stroke, a swing and a ratio of times."""
        of, words = quantity.of_instant, self.tables["index"]
        if of is None:
            return self.symbol(f"{_TO_AND_FRO[quantity.kind]}_{quantity.target}", bodies)
        inner = self.quantity(of, bodies)
        assert isinstance(inner, Symbol)
        extreme = Index(words[next(word for word in _OF_TURN if f"{word}_" in quantity.kind)], True)
        if quantity.kind.startswith(ANGLE_OF):
            return Symbol("phi", (Index(inner.base.removeprefix(ANGLE)), *inner.index, extreme))
        return inner._replace(index=(*inner.index, extreme))

    def _of_interval(self, quantity: Quantity, bodies: Mapping[str, str]) -> Symbol | SymbolProperty:
        """``v_B max``, ``t_v_B max``, ``t_v_B 0``, ``v_B mean``, ``s_B``, ``d_B x``, ``θ_AB``, ``v_B av``, ``t_B``."""
        of, words = quantity.of_instant, self.tables["index"]
        if quantity.kind == "instant":
            return self.symbol(quantity.target, bodies)
        if of is None:
            letter = _OF_INTERVAL[quantity.kind]
            index = [Index(bodies.get(quantity.target, quantity.target)), *self._average(quantity)]
            whole = Symbol(letter, tuple(part for part in index if part.text))
            if quantity.component == "angle":
                return SymbolProperty("angle", whole)
            return whole._replace(index=(*whole.index, Index(quantity.component))) if quantity.component else whole
        inner = self.quantity(of, bodies)
        assert isinstance(inner, Symbol)
        if quantity.kind.startswith(ZERO):
            return Symbol("t", (Index(inner.base), *inner.index, Index("0")))
        extreme = Index(words[next(word for word in _OF_TURN if f"{word}_" in quantity.kind)], True)
        if quantity.kind.startswith(INSTANT_OF):
            return Symbol("t", (Index(inner.base.removeprefix(ANGLE)), *inner.index, extreme))
        return inner._replace(index=(*inner.index, extreme))

    def _average(self, quantity: Quantity) -> list[Index]:
        """The index of an average vector."""
        return [Index(self.tables["index"]["average"], True)] if quantity.kind.startswith("average") else []


def as_fraction(value: Decimal) -> Fraction | None:
    """The fraction, ``13/6``, of which a printed value has as many digits as are kept; None for a plain decimal."""
    if len(value.as_tuple().digits) <= _DECIMALS:
        return None
    whole = Fraction(value).limit_denominator(_DENOMINATOR)
    return whole if abs(whole - Fraction(value)) * 10**_DECIMALS < abs(whole) else None


def on_line(component: str) -> str:
    """The index of a component along or across a line: ``∥AC`` of ``along_AC``."""
    side, _, line = component.partition("_")
    return _DIRECTIONS[side] + line


def round_text(value: float, digits: int) -> str:
    """A value rounded to significant digits as a plain decimal string, halves away from zero; zero is ``0``."""
    if value == 0:
        return "0"
    if not isfinite(value):
        return f"{Decimal(value):f}"
    return f"{rounded_to_digits(value, digits):f}"


@cache
def _unit_text(text: str) -> UnitText:
    """A unit as words with powers, from ``cm/s^2``."""
    parts = re.findall(r"([^\^\s]+?)(?:\^(-?\d+))?(?:\s|$)", text)
    return UnitText(tuple((word, int(power or 1)) for word, power in parts), text == "°")


@cache
def load_language(name: str, notation: Notation = USUAL) -> Language:
    """A language by name (``ru``, ``en``) with the letters of a notation. Raises InputError for an unknown name."""
    check_language(name)
    return _with_notation(name, notation.filled(_tables(name)["notation"]))


@cache
def _with_notation(name: str, notation: Notation) -> Language:
    return Language(name, _tables(name), notation)


@cache
def _tables(name: str) -> Words[Mapping[str, str]]:
    path = templates_dir() / "words" / f"{name}.toml"
    return Words({table: Words(words, path, table) for table, words in read_toml(path).items()}, path)
