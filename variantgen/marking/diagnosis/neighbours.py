"""Whose variant wrong answers belong to: the sheet of a neighbour solved in place of one's own."""

from __future__ import annotations

from collections import defaultdict
from collections.abc import Mapping, Sequence

import numpy as np
from numpy.typing import NDArray

from variantgen.exam.sheets import Answer

_LEAST = 2  # wrong answers that must agree: one may do so by chance
_LEAST_OF_ALTERED = 3  # where one of them does not: it was altered, or is a mistake of one's own


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

    def of(self, place: int, wrong: Sequence[tuple[Answer, float]]) -> tuple[int, frozenset[str]] | None:
        """The place of the other student to whose sheet wrong values belong, and the names of those that do.

        All of two or more must agree, or all but one and at least three; values of one size count once. None where no
        sheet agrees so far, or several agree equally well: then nobody can tell.
        """
        asked = [answer.quantity.name for answer, _ in wrong]
        if not wrong:
            return None
        agrees: NDArray[np.bool_] = np.array(
            [
                (self._places != place) & (np.abs(self._values[name] - value) <= self._tolerances[name])
                for name, (_, value) in zip(asked, wrong, strict=True)
            ]
        )
        count = np.count_nonzero(agrees, axis=0)
        most = int(count.max())
        (best,) = np.nonzero(count == most)
        if len(best) > 1:
            return None
        own = agrees[:, best[0]]
        sizes = {round(abs(value), 9) for (_, value), is_theirs in zip(wrong, own, strict=True) if is_theirs}
        least = {0: _LEAST, 1: _LEAST_OF_ALTERED}.get(len(wrong) - most)
        if least is None or len(sizes) < least:
            return None
        return int(self._places[best[0]]), frozenset(np.array(asked)[own].tolist())
