"""A reader with a calculator: evaluates a printed formula from its text, knowing nothing of how it was made.

``3 · (−20.3)``, ``a / b``, ``√(4^2 + 3^2)``, ``cos 12.3°`` (a degree mark belongs to the number before it); functions
whose value is an angle give it in degrees; ``2 ω_BD · v`` is a product. Symbols take the numbers printed before.
"""

from __future__ import annotations

import math
import re
from collections.abc import Mapping

FUNCTIONS = {
    "cos": lambda x: math.cos(math.radians(x)),
    "sin": lambda x: math.sin(math.radians(x)),
    "tan": lambda x: math.tan(math.radians(x)),
    "tg": lambda x: math.tan(math.radians(x)),
    "arctan": lambda x: math.degrees(math.atan(x)),
    "arctg": lambda x: math.degrees(math.atan(x)),
    "arcsin": lambda x: math.degrees(math.asin(x)),
    "arccos": lambda x: math.degrees(math.acos(x)),
}
COMPONENT = re.compile(r"\([va]_[^()]*\)_")  # (a_B/A)_t is one symbol
SPACES = " \u00a0\u2009\u202f"
_SUPERSCRIPTS = str.maketrans("⁰¹²³⁴⁵⁶⁷⁸⁹", "0123456789")


class UnreadableError(ValueError):
    """The text is no arithmetic of numbers and known symbols."""


class Calculator:
    """Evaluates one text."""

    def __init__(self, text: str, known: Mapping[str, float], mark: str) -> None:
        self.text = text
        self.known = sorted(known.items(), key=lambda item: -len(item[0]))
        self.mark = mark
        self.at = 0

    def value(self) -> float:
        found = self.sum()
        self.skip()
        if self.at < len(self.text):
            raise UnreadableError(f"cannot read {self.text[self.at :]!r} of {self.text!r}")
        return found

    def skip(self) -> None:
        while self.at < len(self.text) and self.text[self.at] in SPACES:
            self.at += 1

    def take(self, *marks: str) -> str:
        self.skip()
        for item in marks:
            if self.text.startswith(item, self.at):
                self.at += len(item)
                return item
        return ""

    def sum(self) -> float:
        total = self.signed()
        while sign := self.take("+", "−", "-"):
            total += self.product() if sign == "+" else -self.product()
        return total

    def signed(self) -> float:
        return -self.product() if self.take("−", "-") else self.product()

    def product(self) -> float:
        total = self.power()
        while True:
            if self.take("·"):
                total *= self.power()
            elif self.take("/"):
                total /= self.power()
            elif self.starts_factor():
                total *= self.power()
            else:
                return total

    def starts_factor(self) -> bool:
        self.skip()
        rest = self.text[self.at :]
        return bool(rest) and rest[0] not in "+−-·/)|=^"

    def power(self) -> float:
        base = self.atom()
        if self.take("^"):
            digits = ""
            while self.at < len(self.text) and self.text[self.at].isdecimal():
                digits += self.text[self.at]
                self.at += 1
            return base ** int(digits)
        digits = ""
        while self.at < len(self.text) and self.text[self.at] in "⁰¹²³⁴⁵⁶⁷⁸⁹":
            digits += self.text[self.at].translate(_SUPERSCRIPTS)
            self.at += 1
        return base ** int(digits) if digits else base

    def atom(self) -> float:
        self.skip()
        if COMPONENT.match(self.text, self.at):
            return self.symbol()
        if self.take("("):
            inner = self.sum()
            if not self.take(")"):
                raise UnreadableError(f"no closing bracket in {self.text!r}")
            return inner
        if self.take("|"):
            inner = self.sum()
            if not self.take("|"):
                raise UnreadableError(f"no closing bar in {self.text!r}")
            return abs(inner)
        if self.take("√"):
            return math.sqrt(self.power())
        if self.take("−", "-"):
            return -self.power()
        for name in sorted(FUNCTIONS, key=len, reverse=True):
            if self.text.startswith(name, self.at):
                self.at += len(name)
                self.skip()
                return FUNCTIONS[name](self.argument())
        return self.number() if self.text[self.at : self.at + 1].isdecimal() else self.symbol()

    def argument(self) -> float:
        return self.signed() if self.text.startswith(("−", "-"), self.at) else self.power()

    def number(self) -> float:
        start = self.at
        while self.at < len(self.text) and (self.text[self.at].isdecimal() or self.text[self.at] == self.mark):
            self.at += 1
        number = float(self.text[start : self.at].replace(self.mark, "."))
        self.take("°")
        return number

    def symbol(self) -> float:
        if self.take("π"):
            return math.pi
        for name, value in self.known:
            if self.text.startswith(name, self.at):
                self.at += len(name)
                return value
        raise UnreadableError(f"unknown symbol at {self.text[self.at :]!r} of {self.text!r}")


def evaluate(text: str, known: Mapping[str, float] | None = None, mark: str = ".") -> float:
    """The value of a printed formula. Raises UnreadableError."""
    return Calculator(text, known or {}, mark).value()


def last_unit(text: str, mark: str = ".", fewest: int = 5) -> float:
    """The unit of the last printed digit; zeros at the end are not printed, but ``fewest`` digits are kept."""
    digits = text.replace("−", "").replace(mark, ".")
    number = float(digits)
    if number == 0:
        return 10.0**-fewest
    decimals = len(digits.partition(".")[2])
    return min(10.0**-decimals, 10.0 ** (math.floor(math.log10(number)) - fewest + 1))
