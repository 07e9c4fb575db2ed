"""Numbers as students write them: ``2,95``, ``1 234.5 cm/s``, ``5·10^-2``, ``40√3/3``, ``7/2``, ``−0,8 рад/с``.

A text is a number or it is not: nothing is guessed. Where a comma may part thousands or decimals (``1,234``), both
readings are given, and whoever asks decides.
"""

from __future__ import annotations

import math
import re
from functools import cache

from msgspec import Struct

from variantgen.families.parameters.units import UNITS, Unit, usual_name
from variantgen.resources import languages
from variantgen.wording.language import load_language

LONGEST = 60  # characters of a text that may be a number
_LARGEST_POWER = 12
_LARGEST = 1e100  # no quantity is larger, nor smaller than its inverse: with more, conversions would overflow
_DIGITS = 13
_SUPERSCRIPTS = str.maketrans("⁰¹²³⁴⁵⁶⁷⁸⁹⁻⁺", "0123456789-+")
_ALIKE = str.maketrans(
    {
        "−": "-",
        "–": "-",
        "—": "-",
        "‐": "-",
        "·": "*",
        "×": "*",
        "⋅": "*",
        "∙": "*",
        "÷": "/",
        "⁄": "/",
    }
)
_SPACE = re.compile(r"[\s\u00a0\u2009\u202f]+")
# Thousands parted by spaces or apostrophes, in a whole part alone: of two numbers in a cell none is made one.
_GROUPED = re.compile(r"(?<![\d.,/^])[1-9]\d{0,2}(?:[ '’]\d{3})+(?![\d/])")
_RAISED = re.compile(r"[⁰¹²³⁴⁵⁶⁷⁸⁹⁻⁺]+")
_DIGITS_ALONE = re.compile(r"[-+]?[\d.,]+")
_PLAIN = re.compile(r"\d+(?:\.\d*)?|\.\d+")
_SLASH = re.compile(r" ?/ ?")
_TIMES = re.compile(r"(?<=\d)\s*[xхXХ]\s*(?=10\b|10\^)")  # 2.5x10^3, with a Latin or a Russian letter
_BRACKETED = re.compile(r"([^()]*\d)\s*\(([^()\d][^()]*)\)")
_TOKEN = re.compile(rf"\s*(?:({_PLAIN.pattern})(?:[eE]([+-]?\d{{1,3}})(?![\d.]))?|(sqrt|√|pi|π|[-+*/^()]))")


class TypedNumber(Struct, frozen=True):
    """A number as it was written: its possible readings, and the unit behind it (None where there is none)."""

    values: tuple[float, ...]
    unit: Unit | None = None

    def in_unit(self, own: Unit) -> tuple[float, ...] | None:
        """The readings in another unit; None where the written unit measures something else."""
        if self.unit is None or self.unit.name == own.name:
            return self.values
        if self.unit.dimension != own.dimension:
            return None
        # Digits that only the conversion has made could lie beyond the end of a tolerance.
        return tuple(float(f"{own.from_si(value * self.unit.size):.{_DIGITS}g}") for value in self.values)


def read_number(text: str) -> TypedNumber | None:
    """What a text says, or None where it is no number with or without a unit of the program."""
    if len(text) > LONGEST:
        return None
    plain = _RAISED.sub(lambda found: "^" + found[0].translate(_SUPERSCRIPTS), text)
    plain = _SPACE.sub(" ", plain.translate(_ALIKE)).strip(" ≈~")
    plain = _SLASH.sub("/", _TIMES.sub("*", plain).replace("**", "^"))
    if plain.endswith(")") and (found := _BRACKETED.fullmatch(plain)):
        plain = f"{found[1]} {found[2]}"  # 2.95 (cm/s)
    if _DIGITS_ALONE.fullmatch(plain):  # no unit is looked for
        return TypedNumber(values) if (values := _values(plain)) else None
    for spelled, unit in _spellings():
        if plain.casefold().endswith(spelled) and not (spelled[0].isdecimal() and _is_digit_before(plain, spelled)):
            values = _values(plain[: -len(spelled)].rstrip(" *"))
            if values:
                return TypedNumber(values, unit)
    values = _values(plain)
    return TypedNumber(values) if values else None


def _is_digit_before(text: str, spelled: str) -> bool:
    """Whether what stands before the spelling of a unit goes on in its first digit: 0.51/s is 0.51 of 1/s."""
    return text[: -len(spelled)][-1:].isdecimal() or text[: -len(spelled)][-1:] in (".", ",")


def _values(text: str) -> tuple[float, ...]:
    """The readings of an expression without a unit."""
    text = _GROUPED.sub(lambda found: re.sub(r"\D", "", found[0]), text)
    found = [value for reading in _decimal_points(text) if (value := _Reader(reading).value()) is not None]
    return tuple(dict.fromkeys(found))


def _decimal_points(text: str) -> tuple[str, ...]:
    """The text with decimal points alone: which mark parts decimals, where that is plain, and both where it is not."""
    if "," not in text:
        return (text,) if text.count(".") < 2 or "/" in text or "*" in text else ()
    if "." in text:  # the last one of them parts the decimals, the others thousands
        thousands, decimal = (",", ".") if text.rindex(".") > text.rindex(",") else (".", ",")
        grouped = re.fullmatch(rf"[-+]?\d{{1,3}}(?:\{thousands}\d{{3}})+\{decimal}\d*", text)
        return (text.replace(thousands, "").replace(decimal, "."),) if grouped else ()
    comma = text.replace(",", ".")
    if re.search(r"\d,\d+,", text) and not set(text) & set("/*"):
        return (text.replace(",", ""),) if re.fullmatch(r"[-+]?\d{1,3}(,\d{3})+", text) else ()
    return (comma, text.replace(",", "")) if re.fullmatch(r"[-+]?[1-9]\d{0,2},\d{3}", text) else (comma,)


class _Reader:
    """Products, quotients, powers and roots of plain numbers, with one sign in front: what an answer consists of."""

    def __init__(self, text: str) -> None:
        self._tokens: list[str | float] | None = []
        place = 0
        while place < len(text):
            found = _TOKEN.match(text, place)
            if found is None:
                self._tokens = None
                return
            number, exponent, sign = found.groups()
            self._tokens.append(sign if number is None else float(f"{number}e{exponent or 0}"))
            place = found.end()

    def value(self) -> float | None:
        """The value, or None for what is no number, or one beyond all quantities."""
        if not self._tokens:
            return None
        try:
            found = self._signed()
        except (ArithmeticError, ValueError, IndexError):
            return None
        if self._tokens or (found and not 1 / _LARGEST <= abs(found) <= _LARGEST):
            return None
        return float(f"{found:.{_DIGITS}g}")  # a product could lie beyond the end of a tolerance by its last digit

    def _peek(self) -> str | float:
        return self._tokens[0] if self._tokens else ""

    def _next(self) -> str | float:
        assert self._tokens is not None
        return self._tokens.pop(0)

    def _signed(self) -> float:
        sign = 1.0
        if self._peek() in ("-", "+"):
            sign = -1.0 if self._next() == "-" else 1.0
        return sign * self._product()

    def _product(self) -> float:
        found, divided = self._power(), False
        while True:
            ahead = self._peek()
            if ahead in ("*", "/"):
                divided = self._next() == "/"
                other = self._power()
                found = found / other if divided else found * other
            elif ahead in ("sqrt", "√", "pi", "π", "(") and not divided:  # 40√3; 1/2√3 could be meant in two ways
                found *= self._power()
            else:
                return found

    def _power(self) -> float:
        base = self._factor()
        if self._peek() == "^":
            self._next()
            exponent = self._signed_whole()
            if abs(exponent) > _LARGEST_POWER:
                raise ValueError("a power beyond all quantities")
            base = base**exponent
        return base

    def _signed_whole(self) -> int:
        sign = -1 if self._peek() == "-" else 1
        if self._peek() in ("-", "+", "("):
            bracket = self._next() == "("
            found = self._signed_whole() if bracket else sign * self._signed_whole()
            if bracket and self._next() != ")":
                raise ValueError("a bracket is open")
            return found
        number = self._next()
        if not isinstance(number, float) or number != int(number):
            raise ValueError("not a whole power")
        return int(number)

    def _factor(self) -> float:
        part = self._next()
        if isinstance(part, float):
            return part
        if part in ("sqrt", "√"):
            return math.sqrt(self._factor())
        if part in ("pi", "π"):
            return math.pi
        if part == "(":
            found = self._signed()
            if self._next() != ")":
                raise ValueError("a bracket is open")
            return found
        raise ValueError("not a number")


@cache
def _spellings() -> tuple[tuple[str, Unit], ...]:
    """How units are written in any language of the program, longest first: ``см/с^2``, ``rad/s``, ``1/s``, ``s^-1``."""
    found: dict[str, Unit] = {}
    for name, unit in UNITS.items():
        if name == "1":
            continue
        words = {name, *(load_language(language).tables["units"].get(name, name) for language in languages())}
        for word in words:
            found.setdefault(usual_name(word).casefold(), unit)
            found.setdefault(word.casefold(), unit)
    for word, unit in list(found.items()):
        if word.endswith("^2"):
            found.setdefault(word.replace("^2", "2"), unit)  # m/s2
    for second in ("s", "с", "c"):  # the last two look alike on Russian keyboards
        for power, unit in ((1, UNITS["rad/s"]), (2, UNITS["rad/s^2"])):
            whole = second if power == 1 else f"{second}^2"
            for word in (f"1/{whole}", f"/{whole}", f"{second}^-{power}", f"{second}-{power}"):
                found.setdefault(word, unit)
    for word, unit in list(found.items()):
        for written, other in (("с", "c"), ("с", "сек"), ("s", "sec")):
            if re.search(rf"/{written}(?!\w)", word):
                found.setdefault(re.sub(rf"/{written}(?!\w)", f"/{other}", word), unit)
    for word, unit in list(found.items()):
        for second in ("s", "с", "c"):  # m s^-1, м·с^-2
            above, slash, squared = word.partition(f"/{second}")
            if slash and above and squared in ("", "^2"):
                for part in ("*", " "):
                    found.setdefault(f"{above}{part}{second}^-{squared[1:] or 1}", unit)
    found |= {
        "°": UNITS["deg"],
        "град": UNITS["deg"],
        "rev/min": UNITS["rpm"],
        "mph": UNITS["mi/h"],
        "об/мин": UNITS["rpm"],
    }
    return tuple(sorted(found.items(), key=lambda item: -len(item[0])))
