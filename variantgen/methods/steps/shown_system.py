"""Systems of linear equations in unknown values: from their forms to the numbers that are shown and the solution."""

from __future__ import annotations

from collections.abc import Mapping, Sequence

from variantgen.algebra.expression import Constant, Expression, Value
from variantgen.algebra.linear import LinearSolution
from variantgen.algebra.normal_form import Maybe, added
from variantgen.methods.steps.step import LinearSystem

ZERO = Constant(0.0)
_ROUNDING = 1e-10  # of the natural scale: what is smaller is zero

Form = tuple[Mapping[Value, Expression], Maybe]


def coefficients(unknowns: Sequence[Value], forms: Sequence[Form]) -> tuple[list[list[Expression]], list[Expression]]:
    """Rows and right-hand sides of equations ``form = 0``, each given by coefficients and the rest."""
    rows = [[found.get(value, ZERO) for value in unknowns] for found, _ in forms]
    return rows, [added((-1, rest)) or ZERO for _, rest in forms]


def system_of(unknowns: Sequence[Value], forms: Sequence[Form]) -> LinearSystem:
    """The system with its coefficients as values, which are printed as numbers."""
    rows, right = coefficients(unknowns, forms)
    table = []
    for row in rows:
        scale = max(abs(item.number(True)) for item in row)
        table.append(tuple(_number(item, scale) for item in row))
    return LinearSystem(tuple(unknowns), tuple(table), tuple(_number(item, 0.0) for item in right))


def _number(item: Expression, scale: float) -> Value:
    return Value(None, "number", item.number(True), item, scale)


def enter_solution(
    unknowns: Sequence[Value], rows: Sequence[Sequence[Expression]], right: Sequence[Expression]
) -> None:
    """Give the unknowns their numbers. Raises numpy.linalg.LinAlgError for a singular system."""
    table = tuple(tuple(row) for row in rows)
    solutions = [LinearSolution(table, tuple(right), i) for i in range(len(unknowns))]
    numbers = [solution.number(True) for solution in solutions]
    for value, solution, number in zip(unknowns, solutions, numbers, strict=True):
        enter(value, solution, number)


def enter(value: Value, expression: Expression, number: float) -> None:
    """Give an unknown its number and where it comes from."""
    value.exact = 0.0 if abs(number) <= _ROUNDING * value.size else number
    value.expression = expression
