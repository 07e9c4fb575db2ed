"""Arithmetic in family files: a small safe language, no ``eval``.

Numbers, names of parameters and derived quantities, ``+ - * / **``, brackets, a few functions, the constants ``pi``
and ``deg`` and the units ``m cm mm``. Everything else is refused when the file is read, with the place.
"""

from __future__ import annotations

import ast
from collections.abc import Callable, Mapping
from dataclasses import dataclass
from functools import lru_cache
from operator import itemgetter
from typing import Any

import numpy as np

from variantgen.errors import InputError, Problem, nearest
from variantgen.mechanism.arithmetic import Real

Dimension = tuple[float, float]
_PURE: Dimension = (0, 0)

CONSTANTS: dict[str, tuple[float, Dimension]] = {
    "pi": (float(np.pi), _PURE),
    "deg": (float(np.pi / 180), _PURE),
    "m": (1.0, (1, 0)),
    "cm": (0.01, (1, 0)),
    "mm": (0.001, (1, 0)),
}
_PURE_FUNCTIONS: dict[str, Callable[[Any], Any]] = {
    "sin": np.sin,
    "cos": np.cos,
    "tan": np.tan,
    "asin": lambda x: np.arcsin(np.clip(x, -1.0, 1.0)),
    "acos": lambda x: np.arccos(np.clip(x, -1.0, 1.0)),
    "atan": np.arctan,
}
_CALLED: dict[str, Callable[..., Any]] = {
    **_PURE_FUNCTIONS,
    "sqrt": lambda x: np.sqrt(np.where(x < 0, 0.0, x)),
    "abs": np.abs,
    "min": np.minimum,
    "max": np.maximum,
    "atan2": np.arctan2,
}
FUNCTIONS = tuple(_CALLED)
_OPERATORS: dict[type[ast.operator], Callable[[Any, Any], Any]] = {
    ast.Add: np.add,
    ast.Sub: np.subtract,
    ast.Mult: np.multiply,
    ast.Div: lambda a, b: a / np.where(np.equal(b, 0), np.inf, b),
}
_MAX_LENGTH, _MAX_POWER = 200, 8


@dataclass(frozen=True)
class FamilyExpression:
    """A parsed expression; ``names`` are the quantities it uses.

    ``measures`` says of a number that stands alone (``distance = 60``) what it measures: its value is in SI. Numbers
    within a formula are plain.
    """

    text: str
    tree: ast.expr
    names: frozenset[str]
    measures: str = ""

    def value(self, values: Mapping[str, Real]) -> Real:
        """Evaluate with SI values (scalars or arrays); dividing by zero gives zero, a root of a negative zero."""
        compute = _compiled(self.tree)
        if isinstance(self.tree, ast.Name | ast.Constant):
            plain: Real = compute(values)
            return plain
        with np.errstate(all="ignore"):
            result: Real = compute(values)
        return result

    @property
    def risky(self) -> bool:
        """Whether some values can leave it without a meaning."""
        return any(
            isinstance(node, ast.Div | ast.Pow) or (isinstance(node, ast.Name) and node.id in ("sqrt", "asin", "acos"))
            for node in ast.walk(self.tree)
        )

    def defined(self, values: Mapping[str, Real]) -> Any:
        """Whether it has a meaning: nothing divided by zero, no root of a negative number, no arc sine beyond 1."""
        return _defined(self.tree, values)

    def uses(self, name: str) -> bool:
        """Whether a constant or name stands in it."""
        return any(isinstance(node, ast.Name) and node.id == name for node in ast.walk(self.tree))

    def dimension(self, dimensions: Mapping[str, Dimension]) -> Dimension | None:
        """Exponents of length and time; None for a bare zero, which fits everything. Raises InputError."""
        return _dimension(self.tree, dimensions, self.text)


def parse(text: str) -> FamilyExpression:
    """Parse an expression; raises InputError naming what is not allowed."""
    if len(text) > _MAX_LENGTH:
        raise InputError(
            Problem(f"expression longer than {_MAX_LENGTH} characters", value=text[:40] + "...", remedy="use [derived]")
        )
    try:
        tree = ast.parse(text.strip(), mode="eval").body
    except (SyntaxError, ValueError, MemoryError, RecursionError):
        raise InputError(
            Problem("not an arithmetic expression", value=text, remedy='write it like "OA * cos(phi)"')
        ) from None
    names: set[str] = set()
    _check(tree, text, names)
    return FamilyExpression(text, tree, frozenset(names))


def number(value: float, measures: str = "") -> FamilyExpression:
    """A constant in SI as an expression."""
    return FamilyExpression(str(value), ast.Constant(float(value)), frozenset(), measures)


def _refuse(text: str, what: str) -> InputError:
    return InputError(
        Problem(
            f"{what} is not allowed in an expression", value=text, remedy="only arithmetic and " + ", ".join(FUNCTIONS)
        )
    )


def _check(node: ast.expr, text: str, names: set[str]) -> None:
    match node:
        case ast.Constant(value=int() | float() as value) if not isinstance(value, bool):
            if not abs(value) < 1e12:
                raise _refuse(text, "a number this large")
        case ast.Name(id=name):
            if name not in CONSTANTS:
                names.add(name)
        case ast.UnaryOp(op=ast.USub() | ast.UAdd(), operand=operand):
            _check(operand, text, names)
        case ast.BinOp(left=left, op=ast.Pow(), right=ast.Constant(value=int() as power)):
            if not 0 <= power <= _MAX_POWER:
                raise _refuse(text, f"a power above {_MAX_POWER}")
            _check(left, text, names)
        case ast.BinOp(left=left, op=op, right=right) if type(op) in _OPERATORS:
            _check(left, text, names)
            _check(right, text, names)
        case ast.Call(func=ast.Name(id=name), args=args, keywords=[]):
            if name not in FUNCTIONS:
                raise InputError(
                    Problem("unknown function", value=f"{name} in {text}", remedy=nearest(name, FUNCTIONS))
                )
            wanted = 2 if name in ("min", "max", "atan2") else 1
            if len(args) != wanted:
                raise _refuse(text, f"{name} with {len(args)} arguments instead of {wanted}")
            for arg in args:
                _check(arg, text, names)
        case _:
            raise _refuse(text, type(node).__name__.lower())


@lru_cache(maxsize=10_000)
def _compiled(node: ast.expr) -> Callable[[Mapping[str, Real]], Any]:
    """A function from SI values to the value of a node; the tree is walked once, not at every value."""
    match node:
        case ast.Constant(value=value):
            constant: Any = np.float64(value)  # type: ignore[arg-type]
            return lambda values: constant
        case ast.Name(id=name) if name in CONSTANTS:
            constant = CONSTANTS[name][0]
            return lambda values: constant
        case ast.Name(id=name):
            return itemgetter(name)
        case ast.UnaryOp(op=op, operand=operand):
            inner = _compiled(operand)
            return (lambda values: -inner(values)) if isinstance(op, ast.USub) else inner
        case ast.BinOp(left=left, op=ast.Pow(), right=ast.Constant(value=power)):
            base = _compiled(left)
            return lambda values: base(values) ** power
        case ast.BinOp(left=left, op=op, right=right):
            join, first, second = _OPERATORS[type(op)], _compiled(left), _compiled(right)
            return lambda values: join(first(values), second(values))
        case ast.Call(func=ast.Name(id=name), args=args):
            apply, inputs = _CALLED[name], [_compiled(arg) for arg in args]
            return lambda values: apply(*[value(values) for value in inputs])
    raise TypeError(f"unchecked expression node {node!r}")


def _defined(node: ast.expr, values: Mapping[str, Real]) -> Any:
    parts = [part for part in ast.iter_child_nodes(node) if isinstance(part, ast.expr)]
    if isinstance(node, ast.Call):
        parts = list(node.args)
    good: Any = np.True_
    for part in parts:
        good = good & _defined(part, values)
    match node:
        case ast.BinOp(op=ast.Div(), right=right):
            return good & np.not_equal(_compiled(right)(values), 0)
        case ast.Call(func=ast.Name(id="sqrt"), args=[arg]):
            return good & np.greater_equal(_compiled(arg)(values), 0)
        case ast.Call(func=ast.Name(id="asin" | "acos"), args=[arg]):
            return good & np.less_equal(np.abs(_compiled(arg)(values)), 1 + 1e-12)
    return good


def _dimension(node: ast.expr, known: Mapping[str, Dimension], text: str) -> Dimension | None:
    match node:
        case ast.Constant(value=value):
            return None if value == 0 else _PURE
        case ast.Name(id=name):
            return CONSTANTS[name][1] if name in CONSTANTS else known[name]
        case ast.UnaryOp(operand=operand):
            return _dimension(operand, known, text)
        case ast.BinOp(left=left, op=ast.Pow(), right=ast.Constant(value=int() as power)):
            length, time = _dimension(left, known, text) or _PURE
            return length * power, time * power
        case ast.BinOp(left=left, op=op, right=right):
            a, b = _dimension(left, known, text), _dimension(right, known, text)
            if isinstance(op, ast.Add | ast.Sub):
                return _same(a, b, text)
            sign = 1 if isinstance(op, ast.Mult) else -1
            if a is None or b is None:
                return None
            return a[0] + sign * b[0], a[1] + sign * b[1]
        case ast.Call(func=ast.Name(id=name), args=args):
            inputs = [_dimension(arg, known, text) for arg in args]
            if name == "sqrt":
                return None if inputs[0] is None else (inputs[0][0] / 2, inputs[0][1] / 2)
            if name in _PURE_FUNCTIONS:
                _same(inputs[0], _PURE, text)
                return _PURE
            joined = inputs[0] if len(inputs) == 1 else _same(inputs[0], inputs[1], text)
            return _PURE if name == "atan2" else joined
    raise TypeError(f"unchecked expression node {node!r}")


def _same(a: Dimension | None, b: Dimension | None, text: str) -> Dimension | None:
    if a is None or b is None:
        return a or b
    if a != b:
        raise InputError(
            Problem(
                f"adds or compares {dimension_name(a)} with {dimension_name(b)}",
                value=text,
                remedy="check the units of the parameters in it",
            )
        )
    return a


def dimension_name(dimension: Dimension) -> str:
    """A dimension in words for messages."""
    names = {
        (0, 0): "a number or an angle",
        (1, 0): "a length",
        (0, 1): "a time",
        (0, -1): "an angular velocity",
        (0, -2): "an angular acceleration",
        (1, -1): "a velocity",
        (1, -2): "an acceleration",
    }
    return names.get((int(dimension[0]), int(dimension[1])), f"length^{dimension[0]:g} time^{dimension[1]:g}")
