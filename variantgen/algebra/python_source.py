"""Expressions of a solution as text of a Python program."""

from __future__ import annotations

import keyword
import re
from collections.abc import Callable, Mapping

from variantgen.algebra.decimals import SURE_DIGITS, rounded_to_digits
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
from variantgen.algebra.name import Name

_FUNCTIONS = {"cos": "np.cos", "sin": "np.sin", "tan": "np.tan", "exp": "np.exp", "ln": "np.log"}
_OF_NUMBERS = ("exp", "ln")
_LETTERS = {"x": "x", "y": "y", "omega": "omega", "epsilon": "epsilon", "v": "v", "a": "a", "radius": "r"}
_KINDS = {
    "direction": "phi",
    "rotation": "psi",
    "slide": "s",
    "offset": "h",
    "arc": "chi",
    "swing": "theta",
    **_LETTERS,
}

# What the programs call their own variables and functions.
_OWN = ("q", "v", "a", "t", "f", "g", "e", "s", "np", "rate", "jacobian", "names", "circle", "bend", "Q", "V", "A")
_TAKEN = {*_OWN, *keyword.kwlist}


def identifier(name: Name) -> str:
    """A variable for a quantity: ``x_A``, ``phi_OA``, ``OA``; ``v_0`` for a given v, ``s_dot`` for its derivative."""
    if name.kind == "parameter" and name.dots:
        return f"{name.of}_{'d' * name.dots}ot"
    if name.kind == "parameter":
        return f"{name.of}_0" if name.of in _TAKEN else re.sub(r"\W", "_", name.of)  # omega_rod/cart
    if name.kind == "length":
        return name.of + name.about
    return f"{_KINDS[name.kind]}_{name.of}{name.about}"


def number(value: float, measure: str = "") -> str:
    """A number without the rounding of the machine (43, not 42.99999999999999); an angle in degrees becomes radians."""
    if measure != "angle":
        value = value if value == 0 else float(rounded_to_digits(value, SURE_DIGITS))
        return repr(int(value)) if value == int(value) and abs(value) < 1e15 else repr(value)
    return f"np.radians({number(value)})"


def written(item: Expression, names: Mapping[Value, str]) -> str:
    """An expression in Python; values without a variable in ``names`` are written as numbers.

    The variables of angles are in radians, so one that a formula takes in degrees, as ``pi phi / 180`` does, is
    converted. Raises TypeError for an expression that Python has no operation for.
    """
    match item:
        case Value():
            return names[item] if item in names else number(item.exact, _measure(item.measure, names))
        case Constant(value, measure):
            return number(value, _measure(measure, names))
        case Pi():
            return "np.pi"
        case Total(terms):
            return _sum(terms, names, written)
        case Times() | Ratio() if not isinstance(names, _InDegrees) and _takes_degrees(item):
            return written(item, _InDegrees(names))
        case Times(factors):
            return "*".join(enclosed(factor, names) for factor in factors)
        case Ratio(above, below):
            return f"{enclosed(above, names)}/{enclosed(below, names, tight=True)}"
        case Raised(base, exponent):
            return f"{enclosed(base, names, tight=True)}**{exponent}"
        case SquareRoot(inner):
            return f"np.sqrt({written(inner, names)})"
        case Magnitude(inner):
            return f"abs({written(inner, names)})"
        case Applied(function, argument) if function in _FUNCTIONS:
            if function in _OF_NUMBERS:
                return f"{_FUNCTIONS[function]}({written(argument, names)})"
            radians = names.radians if isinstance(names, _InDegrees) else names
            return f"{_FUNCTIONS[function]}({written_angle(argument, radians)})"
    raise TypeError(f"no program for {item!r}")


def written_angle(item: Expression, names: Mapping[Value, str]) -> str:
    """An angle in radians; one in degrees by a formula, as ``180 (3 t) / pi``, is converted."""
    if isinstance(item, Total):
        return _sum(item.terms, names, written_angle)
    above, below = _multiplied(item)
    by_formula = any(isinstance(part, Pi) for part in below) and not any(map(_has_angle, above))
    return f"np.radians({written(item, names)})" if by_formula else written(item, names)


def _takes_degrees(item: Expression) -> bool:
    """Whether a product has a factor pi and angles in degrees, so that it comes to radians."""
    above, _ = _multiplied(item)
    return any(isinstance(part, Pi) for part in above) and any(map(_has_angle, above))


def _multiplied(item: Expression) -> tuple[list[Expression], list[Expression]]:
    """The factors of a product or a fraction, above and below the line."""
    match item:
        case Times(factors):
            found = [_multiplied(factor) for factor in factors]
            return [f for above, _ in found for f in above], [f for _, below in found for f in below]
        case Ratio(top, bottom):
            (above, under), (over, below) = _multiplied(top), _multiplied(bottom)
            return [*above, *below], [*under, *over]
    return [item], []


def _has_angle(item: Expression) -> bool:
    """Whether a factor is an angle, or a sum with one."""
    if isinstance(item, Value | Constant):
        return item.measure == "angle"
    return isinstance(item, Total) and any(_has_angle(f) for _, term in item.terms for f in _multiplied(term)[0])


class _InDegrees(dict[Value, str]):
    """Variables by value, those of angles in degrees."""

    def __init__(self, radians: Mapping[Value, str]) -> None:
        super().__init__({v: f"np.degrees({name})" if v.measure == "angle" else name for v, name in radians.items()})
        self.radians = radians


def _measure(measure: str, names: Mapping[Value, str]) -> str:
    """What a number measures, nothing where an angle stands in degrees."""
    return "" if isinstance(names, _InDegrees) else measure


def _sum(
    terms: tuple[tuple[int, Expression], ...],
    names: Mapping[Value, str],
    write: Callable[[Expression, Mapping[Value, str]], str],
) -> str:
    text = ""
    for sign, term in terms:
        part = write(term, names)
        if isinstance(term, Total) or part.startswith("-"):
            part = f"({part})"
        text += (" - " if text else "-") + part if sign < 0 else (" + " if text else "") + part
    return text


def enclosed(item: Expression, names: Mapping[Value, str], tight: bool = False) -> str:
    """A factor, in parentheses where it needs them; ``tight`` for a base or a divisor."""
    text = written(item, names)
    loose = isinstance(item, Total) or text.startswith("-") or (tight and isinstance(item, Times | Ratio))
    return f"({text})" if loose else text
