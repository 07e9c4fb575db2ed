"""A strict reader of arithmetic in plain text: exact values, and refusal of whatever could be read in two ways.

Values are whole numbers modulo a prime: sums, products and quotients are exact, and expressions that are not the same
hardly ever have the same value. Functions, roots and moduli are any fixed maps. Only the text is known here.

Refused: ``a / b · c`` and ``a / b / c``, a minus that neither begins an expression nor stands between two terms, and an
exponent after what it could belong to in part, as in ``√a^2`` or ``cos a^2``.
"""

from __future__ import annotations

from collections.abc import Mapping

PRIME = 2**61 - 1
SIGNS = "+−·/^()|√°\xa0"
FUNCTIONS = {"cos": 3, "sin": 5, "arctg": 7}


class AmbiguousError(ValueError):
    """The text is not to be read in one way."""


def quotient(a: int, b: int) -> int:
    """``a / b``. Raises ZeroDivisionError."""
    if b % PRIME == 0:
        raise ZeroDivisionError
    return a * pow(b, -1, PRIME) % PRIME


def power(base: int, exponent: int) -> int:
    """``base^exponent``. Raises ZeroDivisionError."""
    return pow(base, exponent, PRIME) if exponent >= 0 else quotient(1, pow(base, -exponent, PRIME))


def function(name: str, argument: int) -> int:
    """What stands for a function."""
    return (pow(argument + 11, FUNCTIONS[name], PRIME) + 2) % PRIME


def root(value: int) -> int:
    """What stands for a square root."""
    return (pow(value + 5, 11, PRIME) + 1) % PRIME


def modulus(value: int) -> int:
    """What stands for a modulus."""
    return (pow(value + 7, 13, PRIME) + 3) % PRIME


def decimal(text: str) -> int:
    """``20.3``. Raises AmbiguousError."""
    if not text.replace(".", "", 1).isdecimal():
        raise AmbiguousError(text)
    digits = len(text.partition(".")[2])
    return quotient(int(text.replace(".", "")), 10**digits)


def degrees(value: int) -> int:
    """What stands for an angle."""
    return value * 17 % PRIME


def tokens(text: str) -> list[str]:
    """Names, numbers and signs; a common space is around signs only and means nothing.

    ``^`` before a letter is part of a name: of the component ``a^n``.
    """
    found = [""]
    for letter, following in zip(text, text[1:] + " ", strict=True):
        if letter == " ":
            found.append("")
        elif (letter in SIGNS and not (letter == "^" and following.isalpha())) or found[-1] in SIGNS:
            found.append(letter)
        else:
            found[-1] += letter
    return [token for token in found if token]


class Reader:
    """Reads one text; ``names`` are the values of its symbols."""

    def __init__(self, text: str, names: Mapping[str, int]) -> None:
        self.rest = tokens(text)
        self.names = names

    def value(self) -> int:
        found = self.sum()
        if self.rest:
            raise AmbiguousError(self.rest)
        return found

    def next(self) -> str:
        return self.rest[0] if self.rest else ""

    def take(self, sign: str) -> bool:
        if self.next() != sign:
            return False
        del self.rest[0]
        return True

    def need(self, sign: str) -> None:
        if not self.take(sign):
            raise AmbiguousError(f"{sign} expected before {self.rest}")

    def sum(self) -> int:
        total = -self.product() if self.take("−") else self.product()
        while True:
            if self.take("+"):
                total += self.product()
            elif self.take("−"):
                total -= self.product()
            else:
                return total % PRIME

    def product(self) -> int:
        total = self.factor()
        while True:
            if self.take("·") or self.take("\xa0") or self.next() == "√":
                total = total * self.factor() % PRIME
            elif self.take("/"):
                total = quotient(total, self.factor())
                if self.next() in ("·", "\xa0", "/", "√"):
                    raise AmbiguousError(f"{self.rest} after a denominator")
                return total
            else:
                return total

    def factor(self) -> int:
        if self.take("√"):
            return root(self.alone())
        if self.next() in FUNCTIONS:
            name = self.rest.pop(0)
            exponent = self.exponent()
            if self.next() != "(":
                self.need("\xa0")
            return power(function(name, self.alone()), exponent)
        base = self.atom()
        return power(base, self.exponent())

    def alone(self) -> int:
        """What belongs to a root or a function: nothing may follow that could belong to it, too."""
        found = self.atom()
        if self.next() in ("^", "("):
            raise AmbiguousError(f"{self.rest} after the argument")
        return found

    def exponent(self) -> int:
        if not self.take("^"):
            return 1
        if self.take("("):
            self.need("−")
            found = -int(self.rest.pop(0))
            self.need(")")
        else:
            found = int(self.rest.pop(0))
        if self.next() == "^":
            raise AmbiguousError("a power of a power")
        return found

    def atom(self) -> int:
        if self.take("("):
            found = self.sum()
            self.need(")")
            return found
        if self.take("|"):
            found = self.sum()
            self.need("|")
            return modulus(found)
        token = self.rest.pop(0) if self.rest else ""
        if token[:1].isdecimal():
            return degrees(decimal(token)) if self.take("°") else decimal(token)
        if token in self.names:
            return self.names[token]
        raise AmbiguousError(f"{token!r} before {self.rest}")


def read(text: str, names: Mapping[str, int]) -> int:
    """The value of a text. Raises AmbiguousError, ZeroDivisionError."""
    return Reader(text, names).value()
