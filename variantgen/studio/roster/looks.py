"""Columns of a class list whose heads tell nothing, by what stands in them: a name is two words, an id has digits."""

from __future__ import annotations

import re
from collections.abc import Sequence

from variantgen.exam.roster.reading import only_counts
from variantgen.limits import TITLE_ROWS

_NAME = re.compile(r"[^\W\d_][\w'\u2019.-]*,?(\s+[^\W\d_][\w'\u2019.-]*){1,4}")
_ID = re.compile(r"[\w./-]*\d[\w./-]*")
_MANY = 0.5  # of ids that are different
_MOST = 0.8  # of the cells of a column that look alike, from which on it is what they are


def by_looks(rows: Sequence[Sequence[str]], width: int) -> tuple[int, tuple[str, ...]]:
    """The place of the first student and what each column holds; (0, nothing) where no column looks like names.

    The first column of two-word texts has the names, the first of different words with digits the ids, unless they
    only count the rows. Students begin where the first name stands in a row with as many cells as most have.
    """
    columns = [[cells[k] if k < len(cells) else "" for cells in rows] for k in range(width)]
    usual = sorted(sum(map(bool, cells)) for cells in rows)[len(rows) // 2]
    full = [i for i, cells in enumerate(rows[: TITLE_ROWS + 1]) if sum(map(bool, cells)) >= usual]
    for names, own in enumerate(columns):
        begin = next((i for i in full if _NAME.fullmatch(own[i])), len(rows))
        if _share(own[begin:], _NAME) > _MOST:
            return begin, _kinds(columns, names, begin)
    return 0, ("",) * width


def _kinds(columns: Sequence[Sequence[str]], names: int, begin: int) -> tuple[str, ...]:
    """What columns hold where one has the names of students from a row on."""
    kinds = [""] * len(columns)
    kinds[names] = "name"
    for k, column in enumerate(columns):
        own = column[begin:]
        known = list(filter(None, own))
        if k != names and _share(own, _ID) > _MOST and not only_counts([own]) and len(set(known)) > _MANY * len(known):
            kinds[k] = "id"
            break
    return tuple(kinds)


def _share(cells: Sequence[str], pattern: re.Pattern[str]) -> float:
    """Which part of the cells of a column that are filled look alike; none where hardly any are."""
    filled = list(filter(None, cells))
    return sum(pattern.fullmatch(cell) is not None for cell in filled) / len(filled) if filled else 0.0
