r"""Plain text of exam files with simple formulas between dollar signs: ``Give $v_B$ in cm/s, take $g = 9.8 m/s^2$``.

A formula has symbols (``v_B``, ``\omega_{OA}``, ``omega_OA``, ``ω``, ``a_B^n``), numbers with units of the language,
``+ - · / ^ ( )``, ``\sqrt{...}`` and the signs ``= ≈ → ∥ ⟂``. Everything else is text and stays what it is; ``\$`` is
the sign itself. The result is the same sequence of strings and formulas that a statement has.
"""

from __future__ import annotations

import re
from functools import cache

from variantgen.errors import InputError, Problem
from variantgen.families.parameters.units import UNITS
from variantgen.wording.formula import (
    GREEK,
    Formula,
    Fraction,
    Index,
    Measured,
    Number,
    Parenthesised,
    Power,
    Product,
    Relation,
    Root,
    Sum,
    Symbol,
    UnitText,
)
from variantgen.wording.language import Language
from variantgen.wording.text import Text

_DOLLAR = re.compile(r"(?<!\\)\$")
_DEEPEST = 8  # parentheses inside each other
_LONGEST = 200  # characters of a formula
_LETTERS = {sign: name for name, sign in GREEK.items() if name != "prime"}
_COMMANDS = {
    **{name: name for name in _LETTERS.values()},
    "varepsilon": "epsilon", "varphi": "phi", "vartheta": "theta",
    "cdot": "·", "approx": "≈", "to": "→", "parallel": "∥", "perp": "⟂", "sqrt": "sqrt",
}  # fmt: skip
_SIGNS = {"=": "=", "≈": "≈", "→": "→", "∥": "∥", "⟂": "⟂"}
_PLUS = {"+": 1, "-": -1, "\N{MINUS SIGN}": -1}
_TOKEN = re.compile(
    r"(?P<space>(?:\s|~|\\,)+)|(?P<number>\d+(?:[.,]\d+)?)|\\(?P<command>[A-Za-z]+)|(?P<word>(?:[A-Z]\d*)+(?![a-z])|[A-Za-z]+\d*)"
    rf"|(?P<greek>[{''.join(_LETTERS)}])|(?P<sign>[-+=≈→∥⟂·*/^_(){{}}\N{{MINUS SIGN}}])"
)
_SCRIPT = re.compile(r"\{([^{}]*)\}|(\\?[^\W\d_][^\W_]*|-?\d+)")  # in braces, or what holds together
_BLANKS = re.compile(r"(?:\s|~|\\,)*")
_PART = re.compile(r"\\?[A-Za-z]+\d*|\d+|[Ѐ-ӿ]+|[Ͱ-Ͽ]")


def inline(text: str, language: Language) -> Text:
    """A text with its formulas read. Raises InputError, which shows the formula that cannot be."""
    pieces = _DOLLAR.split(text)
    if len(pieces) % 2 == 0:
        remedy = r"a formula stands between two of them; the sign itself is  \$  (in a TOML string in quotes  \\$)"
        raise InputError(Problem("a dollar sign without the other one", value=f"${pieces[-1][:40]}", remedy=remedy))
    runs = (_Reader(piece, language).read() if i % 2 else piece.replace(r"\$", "$") for i, piece in enumerate(pieces))
    return tuple(run for run in runs if run != "")


@cache
def _units(language: Language) -> list[tuple[str, UnitText]]:
    """The units as one types them, the longest first: as the language writes them, and by their names in files."""
    found: dict[str, UnitText] = {}
    for name, unit in UNITS.items():
        own = language.tables["units"][name]
        found |= dict.fromkeys((own, own.replace("^2", "²"), name), language.unit(unit)) if own else {}
    return sorted(found.items(), key=lambda pair: -len(pair[0]))


class _Reader:
    """Reads one formula."""

    def __init__(self, source: str, language: Language) -> None:
        self._source, self._language = source, language
        self._place = self._depth = 0

    def read(self) -> Formula:
        """The whole formula."""
        if len(self._source) > _LONGEST:
            raise self._wrong(f"a formula of more than {_LONGEST} characters")
        found = self._chain()
        if self._next():
            raise self._wrong("a formula that cannot be read")
        return found

    def _wrong(self, message: str) -> InputError:
        read, rest = self._source[: self._place], self._source[self._place :]
        where = f", from  {rest[:20]}  on" if read.strip() and rest else ""
        remedy = r"known: v_B, \omega_{OA}, a_B^n, numbers with units, + - \cdot / ^ ( ), \sqrt{3}, ="
        return InputError(Problem(f"{message}{where}", value=f"${self._source[:60]}$", remedy=remedy))

    def _next(self) -> re.Match[str] | None:
        """The next token, not taken yet; blanks before it are passed over."""
        match = _TOKEN.match(self._source, self._place)
        if match and match["space"]:
            self._place = match.end()
            match = _TOKEN.match(self._source, self._place)
        if match is None and self._place < len(self._source):
            raise self._wrong("a formula that cannot be read")
        return match

    def _sign(self, known: str) -> str:
        """Take the next token if it is one of these signs."""
        match = self._next()
        text = "" if match is None else match["sign"] or _COMMANDS.get(match["command"] or "", "")
        if not text or text not in known:
            return ""
        assert match is not None
        self._place = match.end()
        return text

    def _chain(self) -> Formula:
        items, signs = [self._sum()], []
        while sign := self._sign("=≈→∥⟂"):
            signs.append(_SIGNS[sign])
            items.append(self._sum())
        return Relation(tuple(items), tuple(signs)) if signs else items[0]

    def _sum(self) -> Formula:
        first = self._sign("-\N{MINUS SIGN}")
        terms = [(_PLUS[first] if first else 1, self._product())]
        while sign := self._sign("+-\N{MINUS SIGN}"):
            terms.append((_PLUS[sign], self._product()))
        return terms[0][1] if len(terms) == 1 and not first else Sum(tuple(terms))

    def _product(self) -> Formula:
        factors = [self._power()]
        while True:
            if self._sign("/"):
                above = factors[0] if len(factors) == 1 else Product(tuple(factors))
                factors = [Fraction(above, self._power())]
            elif self._sign("·*") or self._begins():
                factors.append(self._power())
            else:
                return factors[0] if len(factors) == 1 else Product(tuple(factors))

    def _begins(self) -> bool:
        """Whether a factor follows without a sign."""
        match = self._next()
        if match is None:
            return False
        command = match["command"]
        letter = command is not None and _COMMANDS.get(command, "sqrt") in (*_LETTERS.values(), "sqrt")
        return bool(letter or match["word"] or match["greek"] or match["number"] or match["sign"] == "(")

    def _power(self) -> Formula:
        base = self._factor()
        if isinstance(base, Measured) or not self._sign("^"):
            return base
        exponent = self._braced()
        if re.fullmatch(r"-?\d{1,3}", exponent):
            return Power(base, int(exponent))
        if isinstance(base, Symbol):
            return base._replace(upper=self._indices(exponent))
        raise self._wrong("a power that is no whole number")

    def _factor(self) -> Formula:
        match = self._next()
        if match is None:
            raise self._wrong("a formula that ends too early" if self._source.strip() else "an empty formula")
        if match["number"]:
            self._place = match.end()
            return self._measured(self._language.written(match["number"].replace(",", ".")))
        if match["sign"] == "(":
            return Parenthesised(self._inside("(", ")"))
        if match["command"] == "sqrt":
            self._place = match.end()
            return Root(self._inside("{", "}"))
        return self._symbol(match)

    def _inside(self, left: str, right: str) -> Formula:
        """What stands between brackets."""
        self._depth += 1
        if self._depth > _DEEPEST:
            raise self._wrong("too many parentheses")
        if not self._sign(left):
            raise self._wrong(f"expected  {left}")
        found = self._sum()
        if not self._sign(right):
            raise self._wrong(f"expected  {right}")
        self._depth -= 1
        return found

    def _measured(self, number: Number) -> Formula:
        """A number with the unit behind it, if there is one."""
        match = _BLANKS.match(self._source, self._place)
        start = match.end() if match else self._place
        for text, unit in _units(self._language):
            end = start + len(text)
            if self._source.startswith(text, start) and not re.match(r"[^\W\d_]", self._source[end : end + 1]):
                self._place = end
                return Measured(number, unit)
        return number

    def _symbol(self, match: re.Match[str]) -> Symbol:
        """A letter, Greek by its name or as it is, or a name of points, with its indices."""
        word, command = match["word"] or "", match["command"] or ""
        base = _LETTERS.get(match["greek"] or "", _COMMANDS.get(command, ""))
        if command and base not in _LETTERS.values():
            raise self._wrong(rf"an unknown command \{command}")
        if word:
            base = word if word in _LETTERS.values() or len(word) == 1 or word.isupper() else ""
        if not base:
            raise self._wrong("expected a letter, or points in capitals" if word else "a formula that cannot be read")
        self._place = match.end()
        found = Symbol(base)
        while self._sign("_"):  # v_rel_C, as quantities are called in files
            found = found._replace(index=(*found.index, *self._indices(self._braced())))
        return found

    def _braced(self) -> str:
        """What follows ``_`` or ``^``: in braces, or letters and digits that hold together."""
        match = _SCRIPT.match(self._source, self._place)
        if match is None:
            raise self._wrong("an index or a power that cannot be read")
        self._place = match.end()
        return match[1] if match[1] is not None else match[2]

    def _indices(self, text: str) -> tuple[Index, ...]:
        """The parts of an index: points are slanted, words upright."""
        parts = _PART.findall(text)
        if not parts or re.sub(r"[\s,.~]|\\,", "", text) != "".join(parts):
            raise self._wrong(f"an index that cannot be read: {text[:20]}")
        return tuple(_index(part, self._language) for part in parts)


def _index(part: str, language: Language) -> Index:
    if part in ("tr", "rel", "cor"):
        return Index(language.tables["index"][part], upright=True)
    name = _LETTERS.get(part, _COMMANDS.get(part.removeprefix("\\"), part.removeprefix("\\")))
    is_word = not part.isascii() or (len(part) > 1 and part.islower() and not part.isdecimal())
    return Index(name, upright=is_word and name not in GREEK)
