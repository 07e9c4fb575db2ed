"""Derivatives of expressions: motion given by functions of time, at an instant."""

from __future__ import annotations

import ast
import copy
from collections.abc import Mapping

from variantgen.errors import InputError, Problem
from variantgen.families.expressions import CONSTANTS, FamilyExpression

# d f(u) / du as an expression in u.
_CHAIN = {
    "sin": "cos(u)",
    "cos": "-sin(u)",
    "tan": "1 + tan(u)**2",
    "asin": "1 / sqrt(1 - u**2)",
    "acos": "-1 / sqrt(1 - u**2)",
    "atan": "1 / (1 + u**2)",
    "sqrt": "1 / (2 * sqrt(u))",
}
_MAX_NODES = 600
_ZERO, _ONE = ast.Constant(0.0), ast.Constant(1.0)


def inlined(expression: FamilyExpression, definitions: Mapping[str, FamilyExpression]) -> FamilyExpression:
    """The expression with defined names replaced by what they stand for (definitions without each other's names)."""
    used = {name: definitions[name].tree for name in expression.names if name in definitions}
    return _made(_Substitute(used).visit(copy.deepcopy(expression.tree)), expression.text) if used else expression


def derivative(expression: FamilyExpression, name: str) -> FamilyExpression:
    """The derivative of an expression by one of its names, as an expression of the same names.

    Raises InputError for functions that have no derivative everywhere (abs, min, max, atan2), and for expressions whose
    derivative would grow beyond measure.
    """
    return _made(_derivative(expression.tree, name, expression.text), expression.text)


def _made(tree: ast.expr, text: str) -> FamilyExpression:
    if sum(1 for _ in ast.walk(tree)) > _MAX_NODES:
        raise InputError(Problem("too long for a law of motion", value=text, remedy="write it more simply"))
    names = {node.id for node in ast.walk(tree) if isinstance(node, ast.Name)}
    functions = {
        node.func.id for node in ast.walk(tree) if isinstance(node, ast.Call) and isinstance(node.func, ast.Name)
    }
    return FamilyExpression(text, tree, frozenset(names - functions - CONSTANTS.keys()))


def _derivative(node: ast.expr, name: str, text: str) -> ast.expr:
    match node:
        case ast.Constant():
            return _ZERO
        case ast.Name(id=found):
            return _ONE if found == name else _ZERO
        case ast.UnaryOp(op=op, operand=operand):
            inner = _derivative(operand, name, text)
            return inner if inner is _ZERO else ast.UnaryOp(op, inner)
        case ast.BinOp(left=left, op=ast.Pow(), right=ast.Constant(value=int() as power)):
            inner = _derivative(left, name, text)
            if inner is _ZERO or power == 0:
                return _ZERO
            return _times(_times(ast.Constant(power), _power(left, power - 1)), inner)
        case ast.BinOp(left=left, op=op, right=right):
            return _of_operation(left, op, right, (_derivative(left, name, text), _derivative(right, name, text)))
        case ast.Call(func=ast.Name(id=function), args=args):
            rates = [_derivative(arg, name, text) for arg in args]
            if all(rate is _ZERO for rate in rates):
                return _ZERO
            if function not in _CHAIN:
                raise InputError(
                    Problem(
                        f"{function} of the time has no derivative here", value=text, remedy="use a smooth function"
                    )
                )
            outer = _Substitute({"u": args[0]}).visit(ast.parse(_CHAIN[function], mode="eval").body)
            return _times(outer, rates[0])
    raise TypeError(f"unchecked expression node {node!r}")


def _of_operation(left: ast.expr, op: ast.operator, right: ast.expr, rates: tuple[ast.expr, ast.expr]) -> ast.expr:
    """Sum, product and quotient rule, without terms that are zero."""
    first, second = rates
    if isinstance(op, ast.Add):
        return _sum(first, second)
    if isinstance(op, ast.Sub):
        return _difference(first, second)
    if isinstance(op, ast.Mult):
        return _sum(_times(first, right), _times(left, second))
    above = _difference(_times(first, right), _times(left, second))
    return _ZERO if above is _ZERO else ast.BinOp(above, ast.Div(), ast.BinOp(right, ast.Pow(), ast.Constant(2)))


def _sum(first: ast.expr, second: ast.expr) -> ast.expr:
    if first is _ZERO or second is _ZERO:
        return second if first is _ZERO else first
    return ast.BinOp(first, ast.Add(), second)


def _difference(first: ast.expr, second: ast.expr) -> ast.expr:
    if second is _ZERO:
        return first
    return ast.UnaryOp(ast.USub(), second) if first is _ZERO else ast.BinOp(first, ast.Sub(), second)


def _times(first: ast.expr, second: ast.expr) -> ast.expr:
    if first is _ZERO or second is _ZERO:
        return _ZERO
    if first is _ONE:
        return second
    return first if second is _ONE else ast.BinOp(first, ast.Mult(), second)


def _power(base: ast.expr, power: int) -> ast.expr:
    if power == 0:
        return _ONE
    return base if power == 1 else ast.BinOp(base, ast.Pow(), ast.Constant(power))


class _Substitute(ast.NodeTransformer):
    """Puts expressions in the place of names."""

    def __init__(self, inner: Mapping[str, ast.expr]) -> None:
        self._inner = inner

    def visit_Name(self, node: ast.Name) -> ast.expr:
        """Replace a name; functions keep theirs."""
        return self._inner.get(node.id, node)
