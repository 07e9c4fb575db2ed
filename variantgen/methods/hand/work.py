"""The work that a solution takes: what its reader has to calculate, counted in the same way for every method.

It is counted in the values that lead to the answers, each of which is a line that is written once. A value that comes
from the statement costs nothing.
"""

from __future__ import annotations

from collections.abc import Iterable

from msgspec import Struct

from variantgen.algebra.expression import Applied, Constant, Expression, Raised, Ratio, SquareRoot, Times, Total, Value
from variantgen.algebra.linear import LinearSolution

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
    lines = operations = functions = negatives = obtuse = coriolis = 0
    sizes: dict[tuple[int, ...], int] = {}
    met: set[Value] = set()
    waiting: list[Expression] = list(answers)
    while waiting:
        part = waiting.pop()
        match part:
            case Value():
                if part in met:
                    continue
                met.add(part)
                negatives += part.exact < 0
                obtuse += part.measure == "angle" and abs(part.exact) > _RIGHT_ANGLE
                if part.expression is not None:
                    lines += 1
                    coriolis += part.name is not None and part.name.part == "cor"
                    waiting.append(part.expression)
                continue
            case Times():
                operations += len(part.factors) - 1
            case Applied():
                functions += 1
                negatives += part.number(True) < 0
            case Total():
                operations += max(len(part.terms) - 1, 0)
            case Constant():
                continue
            case Ratio() | Raised():
                operations += 1
            case SquareRoot():
                functions += 1
            case LinearSolution(_, right):
                sizes[tuple(map(id, right))] = len(right)
        waiting += part.operands()
    return Work(
        lines=lines,
        operations=operations + sum(map(_elimination, sizes.values())),
        functions=functions,
        systems=len(sizes),
        negatives=negatives,
        obtuse=obtuse,
        coriolis=coriolis,
    )


def _elimination(count: int) -> int:
    """The operations by which so many linear equations are solved: those of Gauss, back substitution included."""
    multiplications = count * (count**2 + 3 * count - 1) // 3
    additions = count * (count - 1) * (2 * count + 5) // 6
    return multiplications + additions
