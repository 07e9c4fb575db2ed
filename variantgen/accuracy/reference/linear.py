"""Linear systems in numbers of many digits: elimination with the largest pivot, kept for several right-hand sides."""

from __future__ import annotations

from collections.abc import Sequence
from typing import Any


class Factors:
    """The factors of a square matrix. Raises ZeroDivisionError where it is singular."""

    def __init__(self, matrix: Sequence[Sequence[Any]]) -> None:
        self.rows = [list(row) for row in matrix]
        self.order = list(range(len(self.rows)))
        rows, count = self.rows, len(self.rows)
        for k in range(count):
            pivot = max(range(k, count), key=lambda i: abs(rows[i][k]))
            rows[k], rows[pivot] = rows[pivot], rows[k]
            self.order[k], self.order[pivot] = self.order[pivot], self.order[k]
            if rows[k][k] == 0:
                raise ZeroDivisionError("the equations are singular")
            for i in range(k + 1, count):
                if rows[i][k] == 0:
                    continue
                factor = rows[i][k] / rows[k][k]
                rows[i][k] = factor
                for j in range(k + 1, count):
                    if rows[k][j] != 0:
                        rows[i][j] -= factor * rows[k][j]

    def solve(self, right: Sequence[Any]) -> list[Any]:
        """The solution for a right-hand side."""
        rows, count = self.rows, len(self.rows)
        x = [right[i] for i in self.order]
        for i in range(count):
            for j in range(i):
                if rows[i][j] != 0:
                    x[i] -= rows[i][j] * x[j]
        for i in reversed(range(count)):
            for j in range(i + 1, count):
                if rows[i][j] != 0:
                    x[i] -= rows[i][j] * x[j]
            x[i] /= rows[i][i]
        return x
