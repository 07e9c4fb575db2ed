"""The work that a solution takes: what its reader has to calculate, counted in the same way for every method.

It is counted in the values that lead to the answers, each of which is a line that is written once. A value that comes
from the statement costs nothing.
"""

from __future__ import annotations

from collections.abc import Iterable

from msgspec import Struct

from variantgen.algebra.expression import Applied, Constant, Raised, Ratio, SquareRoot, Times, Total, Value
from variantgen.algebra.linear import LinearSolution
from variantgen.algebra.values import in_order

_BARE = Value, Constant  # parts of an expression in which nothing is calculated
_RIGHT_ANGLE = 90.0 + 1e-9  # degrees; what is larger by rounding only is not obtuse


class Work(Struct, frozen=True):
    """The work of a solution.

    ``lines``: values that are worked out.
    ``operations``: additions, subtractions, multiplications, divisions and powers in them; a system of equations
    counts with those of its elimination, 9 for two equations, 28 for three.
    ``functions``: roots and values of trigonometric functions and of their inverses.
    ``systems``: systems of equations.
    ``negatives``: values and function values below zero.
    ``obtuse``: angles beyond 90 degrees, given ones and those worked out.
    ``coriolis``: Coriolis accelerations.
    """

    lines: int
    operations: int
    functions: int
    systems: int
    negatives: int
    obtuse: int
    coriolis: int

    @property
    def calculations(self) -> int:
        """Operations and functions together: what is typed into a calculator."""
        return self.operations + self.functions

    @property
    def sizes(self) -> tuple[int, int, int]:
        """Calculations, negative numbers, obtuse angles: by what the variants of a form are compared."""
        return self.calculations, self.negatives, self.obtuse


def work_of(answers: Iterable[Value]) -> Work:
    """The work of the solution that leads to these answers."""
    values = in_order(answers)
    own = [value for value in values if value.expression is not None]
    operations = functions = negatives = 0
    sizes: dict[tuple[int, ...], int] = {}
    waiting = [value.expression for value in own if value.expression is not None]
    while waiting:
        part = waiting.pop()
        match part:
            case Applied():
                functions += 1
                negatives += part.number(True) < 0
            case Times(factors):
                operations += len(factors) - 1
            case Total(terms):
                operations += max(len(terms) - 1, 0)
            case Ratio() | Raised():
                operations += 1
            case SquareRoot():
                functions += 1
            case LinearSolution(_, right):
                sizes[tuple(map(id, right))] = len(right)
        waiting += [operand for operand in part.operands() if not isinstance(operand, _BARE)]
    return Work(
        lines=len(own),
        operations=operations + sum(map(_elimination, sizes.values())),
        functions=functions,
        systems=len(sizes),
        negatives=negatives + sum([value.exact < 0 for value in values]),
        obtuse=sum([value.measure == "angle" and abs(value.exact) > _RIGHT_ANGLE for value in values]),
        coriolis=sum([value.name is not None and value.name.part == "cor" for value in own]),
    )


def _elimination(count: int) -> int:
    """The operations by which so many linear equations are solved: those of Gauss, back substitution included."""
    multiplications = count * (count**2 + 3 * count - 1) // 3
    additions = count * (count - 1) * (2 * count + 5) // 6
    return multiplications + additions
