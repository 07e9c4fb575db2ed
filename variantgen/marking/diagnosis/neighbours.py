"""Whose variant wrong answers belong to: the sheet of a neighbour solved in place of one's own."""

from __future__ import annotations

from collections import defaultdict
from collections.abc import Mapping, Sequence

import numpy as np
from numpy.typing import NDArray

from variantgen.exam.sheets import Answer

_LEAST = 2  # wrong answers that must agree: one may do so by chance


class Neighbours:
    """The answers of the class to one problem of one form, as arrays over its students."""

    def __init__(self, answers: Mapping[int, Sequence[Answer]]) -> None:
        """``answers`` are those of the students to the problem, by the place of the student."""
        self._places = np.array(list(answers))
        values: dict[str, list[float]] = defaultdict(list)
        tolerances: dict[str, list[float]] = defaultdict(list)
        names = {answer.quantity.name for own in answers.values() for answer in own}
        for asked in answers.values():
            own = {answer.quantity.name: answer for answer in asked}
            for name in names:
                answer = own.get(name)
                values[name].append(answer.value if answer and answer.value else np.nan)
                tolerances[name].append(answer.tolerance if answer else np.nan)
        self._values = {name: np.array(table) for name, table in values.items()}
        self._tolerances = {name: np.array(table) for name, table in tolerances.items()}

    def of(self, place: int, wrong: Sequence[tuple[Answer, float]]) -> int | None:
        """The place of the one other student to whose sheet all wrong values belong; None where there is none.

        At least two values of different size must agree, and only one student's sheet may have them.
        """
        if len({round(abs(value), 9) for _, value in wrong}) < _LEAST:
            return None
        agrees: NDArray[np.bool_] = self._places != place
        for answer, value in wrong:
            name = answer.quantity.name
            agrees = agrees & (np.abs(self._values[name] - value) <= self._tolerances[name])
        found = self._places[agrees]
        return int(found[0]) if len(found) == 1 else None
