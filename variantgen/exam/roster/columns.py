"""Which column of a class list holds what, by the words in its header; a title may stand above the header."""

from __future__ import annotations

from collections.abc import Mapping, Sequence
from functools import cache

from msgspec import Struct

from variantgen.errors import InputError, Problem, nearest
from variantgen.limits import TITLE_ROWS
from variantgen.resources import languages
from variantgen.wording.language import load_language

NAME_PARTS = ("surname", "first", "middle")
_SHOWN = 60


class Columns(Struct, frozen=True):
    """The places of columns by what they hold: ``id``, ``number``, ``name``, the parts of a name, ``group``.

    ``row`` is the place of the header among the rows, ``heads`` are its cells, ``unused`` those of no known kind.
    """

    places: Mapping[str, int]
    row: int
    heads: Sequence[str]
    unused: tuple[str, ...]

    def head(self, kind: str) -> str:
        """The word in the header of a column."""
        return self.heads[self.places[kind]]

    def name(self, cells: Sequence[str]) -> str:
        """The name in a row: the surname comes first."""
        found = {kind: cell_of(cells, place) for kind, place in self.places.items()}
        if "name" not in found:
            kinds: Sequence[str] = NAME_PARTS
        elif "surname" in found and "first" not in found:  # Surname, Name: the name is the first name
            kinds = ("surname", "name", "middle")
        elif "surname" not in found and found.get("first", "") not in found["name"]:  # Name, First name
            kinds = ("name", "first", "middle")
        else:
            kinds = ("name",)
        return " ".join(filter(None, (found.get(kind) for kind in kinds)))


def cell_of(cells: Sequence[str], place: int) -> str:
    """The cell at a place; nothing where the row is shorter."""
    return cells[place] if place < len(cells) else ""


def known_in(cells: Sequence[str]) -> int:
    """The number of columns of known kinds that a row would head."""
    return sum(_word(cell) in _kinds() for cell in cells)


def find_columns(rows: Sequence[Sequence[str]], id_column: str = "") -> Columns:
    """The header among the first rows: the one with most known columns. Raises InputError.

    ``id_column`` is the word in the header of the column to be used as id.
    """
    first = rows[:TITLE_ROWS]
    best = max(range(len(first)), key=lambda i: (_has_name(first[i]), known_in(first[i]), -i))
    heads, wanted = first[best], _word(id_column)
    if not _has_name(heads):
        remedy = f"the columns are name and, if there are any, id and group; {_heads_in_words(heads)}"
        raise InputError(Problem("no column for the name", key="header", value=_shown(", ".join(heads)), remedy=remedy))
    if wanted and wanted not in map(_word, heads):
        remedy = "its columns are " + ", ".join(filter(None, heads))
        raise InputError(Problem("the roster has no such column", key="--id-column", value=id_column, remedy=remedy))
    places: dict[str, int] = {}
    unused: list[str] = []
    problems: list[Problem] = []
    for place, head in enumerate(heads):
        kind = _kinds().get(_word(head))
        if wanted:
            kind = "id" if _word(head) == wanted else None if kind in ("id", "number") else kind
        if kind is None or (kind == "number" and kind in places):
            unused += [head] if head else []
        elif kind in places:
            problems.append(
                Problem(f"a second column for the {kind}", key="header", value=_shown(head), remedy="keep one")
            )
        else:
            places[kind] = place
    if problems:
        raise InputError(problems)
    return Columns(places, best, heads, tuple(unused))


def unused_columns_note(columns: Columns) -> str:
    """The columns that are not used, with the known words that are close to theirs."""
    return ", ".join(_shown(head) + (f" ({close})" if (close := _close(head)) else "") for head in columns.unused)


def _heads_in_words(heads: Sequence[str]) -> str:
    unknown = [head for head in heads if head and _word(head) not in _kinds()]
    return "; ".join(
        f"unknown column {_shown(head)}" + (f": {close}" if (close := _close(head)) else "") for head in unknown
    )


def _close(head: str) -> str:
    """The known words that a word may have been meant for."""
    found = nearest(_word(head), _kinds())
    return found if found.startswith("did you mean") else ""


def _has_name(cells: Sequence[str]) -> bool:
    return any(_kinds().get(_word(cell)) in ("name", *NAME_PARTS) for cell in cells)


def _word(head: str) -> str:
    return " ".join(head.casefold().replace("_", " ").split())


def _shown(text: str) -> str:
    return text[:_SHOWN]


@cache
def _kinds() -> dict[str, str]:
    """The words that may head a column in any language (table ``[roster]`` of its words), with what it holds."""
    return {
        word.strip(): kind
        for language in languages()
        for kind, words in load_language(language).words("roster").items()
        for word in words.split(",")
    }
