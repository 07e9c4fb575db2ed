"""Arithmetic in family files: a small safe language, no ``eval``.

Numbers, names of parameters and derived quantities, ``+ - * /``, powers ``^`` or ``**``, brackets, a few functions, the
constants ``pi`` and ``deg`` and the units of length. Everything else is refused when the file is read, with the place.
"""

from __future__ import annotations

import ast
import re
from collections.abc import Callable, Mapping
from functools import cached_property, partial, reduce
from operator import itemgetter
from types import MappingProxyType
from typing import Any

import numpy as np
from msgspec import Struct

from variantgen.algebra.derivative import derivative
from variantgen.algebra.expression import (
    Applied,
    Constant,
    Expression,
    Magnitude,
    Raised,
    Ratio,
    SquareRoot,
    Times,
    Total,
    Variable,
)
from variantgen.algebra.functions import HIGHEST
from variantgen.algebra.substitution import substituted
from variantgen.algebra.values import walk
from variantgen.errors import InputError, Problem, nearest
from variantgen.families.parameters.dimensions import CONSTANTS, Dimension, dimension_of
from variantgen.mechanism.arithmetic import Real

# Functions by their names in a file. In a scene angles are in radians.
_MADE: dict[str, Callable[..., Expression]] = {
    **{name: partial(Applied, name) for name in ("sin", "cos", "tan")},
    **{name: partial(Applied, name.replace("a", "arc", 1)) for name in ("asin", "acos", "atan")},
    "sqrt": SquareRoot,
    **{name: partial(Applied, name) for name in ("exp", "ln")},
    "abs": Magnitude,
    **{name: partial(Applied, name) for name in ("min", "max", "atan2")},
}
FUNCTIONS = tuple(_MADE)
_OF_TWO = ("min", "max", "atan2")
_ROUGH = ("abs", *_OF_TWO)  # without a derivative everywhere
_APPLIED: dict[str, Callable[..., Any]] = {
    "sin": np.sin,
    "cos": np.cos,
    "tan": np.tan,
    "arcsin": lambda x: np.arcsin(np.clip(x, -1.0, 1.0)),
    "arccos": lambda x: np.arccos(np.clip(x, -1.0, 1.0)),
    "arctan": np.arctan,
    "exp": lambda x: np.exp(np.minimum(x, HIGHEST)),
    "ln": lambda x: np.log(np.where(x > 0, x, 1.0)),
    "min": np.minimum,
    "max": np.maximum,
    "atan2": np.arctan2,
}
_BARE = Variable, Constant  # in which nothing is computed
_INCH = re.compile(r"([*/]\s*)in\b")
_MAX_LENGTH, _MAX_POWER, _MAX_NODES = 200, 8, 600

Computation = Callable[[Mapping[str, Real]], Any]  # from SI values to a value


class FamilyExpression(Struct, frozen=True, eq=False, dict=True):
    """An expression as a file states it: its ``text``, for messages, and what is computed, in SI and radians.

    A number that stands alone (``distance = 60``) has a measure and is in SI, too; numbers within a formula are plain.
    """

    text: str
    tree: Expression

    @cached_property
    def names(self) -> frozenset[str]:
        """The quantities that it uses."""
        return frozenset(_names(self.tree) - CONSTANTS.keys())

    @property
    def measures(self) -> str:
        """What a number that stands alone measures."""
        return self.tree.measure if isinstance(self.tree, Constant) else ""

    @cached_property
    def _computation(self) -> Computation:
        return _computation(self.tree)

    def value(self, values: Mapping[str, Real]) -> Real:
        """Evaluate with SI values (scalars or arrays); dividing by zero gives zero, a root of a negative zero."""
        if isinstance(self.tree, _BARE):
            plain: Real = self._computation(values)
            return plain
        with np.errstate(all="ignore"):
            result: Real = self._computation(values)
        return result

    @property
    def risky(self) -> bool:
        """Whether some values can leave it without a meaning."""
        return bool(self._meanings) or any(isinstance(item, Raised) for item in walk(self.tree))

    @cached_property
    def _meanings(self) -> list[Computation]:
        return [test for item in walk(self.tree) if (test := _meaning(item))]

    def defined(self, values: Mapping[str, Real]) -> Any:
        """Whether it has a meaning: nothing divided by zero, no root of a negative number, no arc sine beyond 1."""
        return reduce(np.logical_and, (test(values) for test in self._meanings), np.True_)

    def uses(self, name: str) -> bool:
        """Whether a constant or name stands in it."""
        return name in _names(self.tree)

    def dimension(self, dimensions: Mapping[str, Dimension]) -> Dimension | None:
        """Exponents of length and time; None for a bare zero, which fits everything. Raises InputError."""
        return dimension_of(self.tree, dimensions, self.text)

    def inlined(self, definitions: Mapping[str, FamilyExpression]) -> FamilyExpression:
        """With defined names replaced by what they stand for (definitions without each other's names)."""
        used = {Variable(name): definitions[name].tree for name in self.names if name in definitions}
        return self._made(lambda: substituted(self.tree, used)) if used else self

    def derivative(self, name: str, rates: Mapping[Variable, Expression] = MappingProxyType({})) -> FamilyExpression:
        """The derivative by one of its names, as an expression of the same names; ``rates`` are those of other names.

        Raises InputError for functions that have no derivative everywhere (abs, min, max, atan2), and for expressions
        whose derivative would grow beyond measure.
        """
        for item in walk(self.tree):
            function = item.function if isinstance(item, Applied) else "abs" if isinstance(item, Magnitude) else ""
            if function in _ROUGH and _names(item) & {name, *(other.name for other in rates)}:
                said = f"{function} of the time has no derivative here"
                raise InputError(Problem(said, value=self.text, remedy="use a smooth function"))
        return self._made(lambda: derivative(self.tree, {Variable(name): Constant(1.0), **rates}))

    def _made(self, work_out: Callable[[], Expression | None]) -> FamilyExpression:
        try:
            tree = work_out() or Constant(0.0)
        except OverflowError:
            raise _refuse(self.text, "a number this large") from None
        if sum(1 for _ in walk(tree)) > _MAX_NODES:
            raise InputError(Problem("too long for a law of motion", value=self.text, remedy="write it more simply"))
        return FamilyExpression(self.text, tree)


def _names(item: Expression) -> set[str]:
    """The names in it, those of constants too."""
    return {part.name for part in walk(item) if isinstance(part, Variable)}


def parse(text: str) -> FamilyExpression:
    """Parse an expression; raises InputError naming what is not allowed."""
    if len(text) > _MAX_LENGTH:
        raise InputError(
            Problem(f"expression longer than {_MAX_LENGTH} characters", value=text[:40] + "...", remedy="use [derived]")
        )
    try:
        # In TOML and in books a power is x^2; "in" is a word of Python.
        tree = ast.parse(_INCH.sub(r"\1inch", text.strip().replace("^", "**")), mode="eval").body
    except (SyntaxError, ValueError, MemoryError, RecursionError):
        raise InputError(
            Problem("not an arithmetic expression", value=text, remedy='write it like "OA * cos(phi)"')
        ) from None
    return FamilyExpression(text, _read(tree, text))


def number(value: float, measures: str = "") -> FamilyExpression:
    """A constant in SI as an expression."""
    return FamilyExpression(str(value), Constant(float(value), measures))


def _refuse(text: str, what: str) -> InputError:
    return InputError(
        Problem(
            f"{what} is not allowed in an expression", value=text, remedy="only arithmetic and " + ", ".join(FUNCTIONS)
        )
    )


def _read(node: ast.expr, text: str) -> Expression:
    """What Python has parsed, as an expression: only what is allowed. Raises InputError."""
    match node:
        case ast.Constant(value=int() | float() as value) if not isinstance(value, bool):
            if not abs(value) < 1e12:
                raise _refuse(text, "a number this large")
            return Constant(float(value))
        case ast.Name(id=name):
            return Variable(name)
        case ast.UnaryOp(op=ast.USub(), operand=operand):
            inner = _read(operand, text)
            if isinstance(inner, Total) and len(inner.terms) == 1:
                return inner.terms[0][1]
            return Total(((-1, inner),))
        case ast.UnaryOp(op=ast.UAdd(), operand=operand):
            return _read(operand, text)
        case ast.BinOp(left=left, op=ast.Pow(), right=ast.Constant(value=int() as power)):
            if not 0 <= power <= _MAX_POWER:
                raise _refuse(text, f"a power above {_MAX_POWER}")
            return Raised(_read(left, text), power)
        case ast.BinOp(op=ast.Pow()):
            raise _refuse(text, "a power that is no whole number, as in t^2 (a root is sqrt(t)),")
        case ast.BinOp(left=left, op=ast.Add() | ast.Sub() as op, right=right):
            return Total(((1, _read(left, text)), (1 if isinstance(op, ast.Add) else -1, _read(right, text))))
        case ast.BinOp(left=left, op=ast.Mult(), right=right):
            return Times((_read(left, text), _read(right, text)))
        case ast.BinOp(left=left, op=ast.Div(), right=right):
            return Ratio(_read(left, text), _read(right, text))
        case ast.Call(func=ast.Name(id=name), args=args, keywords=[]):
            if name not in FUNCTIONS:
                raise InputError(
                    Problem("unknown function", value=f"{name} in {text}", remedy=nearest(name, FUNCTIONS))
                )
            wanted = 2 if name in _OF_TWO else 1
            if len(args) != wanted:
                raise _refuse(text, f"{name} with {len(args)} arguments instead of {wanted}")
            return _MADE[name](*(_read(arg, text) for arg in args))
    raise _refuse(text, type(node).__name__.lower())


def _computation(item: Expression) -> Computation:
    """A function from SI values to the value of an expression; it is walked once, not at every value."""
    parts = [_computation(operand) for operand in item.operands()]
    match item:
        case Constant(value):
            constant: Any = np.float64(value)
            return lambda values: constant
        case Variable(name) if name in CONSTANTS:
            constant = CONSTANTS[name][0]
            return lambda values: constant
        case Variable(name):
            return itemgetter(name)
        case Total(terms):
            if terms[0][0] < 0:
                parts[0] = _joined(np.negative, parts[0])
            found = parts[0]
            for (sign, _), part in zip(terms[1:], parts[1:], strict=True):
                found = _joined(np.add if sign > 0 else np.subtract, found, part)
            return found
        case Times():
            return reduce(partial(_joined, np.multiply), parts)
        case Ratio():
            return _joined(lambda above, below: above / np.where(np.equal(below, 0), np.inf, below), *parts)
        case Raised(_, exponent):
            return _joined(lambda base: base**exponent, *parts)
        case SquareRoot():
            return _joined(lambda square: np.sqrt(np.where(square < 0, 0.0, square)), *parts)
        case Magnitude():
            return _joined(np.abs, *parts)
        case Applied(function):
            return _joined(_APPLIED[function], *parts)
    raise TypeError(f"no value of {item!r}")


def _joined(function: Callable[..., Any], *parts: Computation) -> Computation:
    if len(parts) == 1:
        only = parts[0]
        return lambda values: function(only(values))
    first, second = parts
    return lambda values: function(first(values), second(values))


def _meaning(item: Expression) -> Computation | None:
    """A test whether an operation has a meaning for its operands; None if it always has."""
    match item:
        case Ratio(_, below):
            return _joined(lambda value: np.not_equal(value, 0), _computation(below))
        case SquareRoot(inner):
            return _joined(lambda value: np.greater_equal(value, 0), _computation(inner))
        case Applied("exp", argument):
            return _joined(lambda value: np.less_equal(value, HIGHEST), _computation(argument))
        case Applied("ln", argument):
            return _joined(lambda value: np.greater(value, 0), _computation(argument))
        case Applied("arcsin" | "arccos", argument):
            return _joined(lambda value: np.less_equal(np.abs(value), 1 + 1e-12), _computation(argument))
    return None
