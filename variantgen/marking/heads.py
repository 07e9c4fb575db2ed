"""What the columns of a table of answers hold, by their heads."""

from __future__ import annotations

import re
from collections.abc import Collection, Mapping, Sequence
from pathlib import Path

from msgspec.structs import replace

from variantgen.errors import InputError, Problem, nearest
from variantgen.exam.roster.worksheet import Worksheet
from variantgen.families.parameters.units import UNITS
from variantgen.limits import TITLE_ROWS
from variantgen.marking.typed_number import read_number
from variantgen.resources import languages
from variantgen.tables import Table, read_toml
from variantgen.wording.language import load_language

_ANSWER_HEAD = re.compile(r"\s*(\d{1,3})\s*[.:]\s*(\S.*?)\s*([,\[(].*)?")
_NO_UNIT = ("", "1", "-", "–", "—")
_REVIEW = ("read", "why", "where")  # columns of the table for review that are there to be read


def asked_by(head: str) -> tuple[int, str] | None:
    """The problem and the quantity of a column, ``1.v_B`` or ``1.v_B, cm/s``."""
    found = _ANSWER_HEAD.fullmatch(head)
    return (int(found[1]), found[2]) if found else None


def unit_of(head: str) -> str:
    """The unit in the head of a column, ``1.v_B, cm/s`` or ``1.v_B (cm/s)``; '' without one. Raises InputError."""
    found = _ANSWER_HEAD.fullmatch(head)
    return known_unit(found[3].strip(" ,[]()"), head) if found and found[3] else ""


def known_unit(text: str, key: str = "") -> str:
    """A unit as its column says it, in the spelling of the program; '' for none. Raises InputError for other words."""
    if text.strip() in _NO_UNIT:
        return ""
    found = read_number(f"1 {text}")
    if found is None or found.unit is None or found.values != (1.0,):
        raise InputError(Problem("unknown unit", key=key, value=text, remedy=nearest(text.strip(), UNITS)))
    return found.unit.name


def in_unit(text: str, unit: str) -> str:
    """An answer with the unit of its column, if it is a number without one."""
    found = read_number(text) if unit else None
    return f"{text} {unit}" if found is not None and found.unit is None else text


def check_heads(cells: Sequence[str], kinds: Sequence[str]) -> None:
    """Raise InputError for a key or marks in place of answers, and for two columns that would hold the same."""
    if "result" in kinds:
        remedy = "name the table that the class has handed in"
        raise InputError(
            Problem("is a key or a table of marks: it has no answers", value=", ".join(cells), remedy=remedy)
        )
    for kind in ("problem", "quantity", "answer", "unit"):
        own = [cell for cell, other in zip(cells, kinds, strict=True) if other == kind]
        if len(own) > 1 and "problem" in kinds and "quantity" in kinds:
            remedy = "leave the one that is meant, or give the other another head"
            raise InputError(Problem(f"several columns hold the {kind}", value=", ".join(own), remedy=remedy))


def unused(cells: Sequence[str], used: Collection[int]) -> list[str]:
    """The heads of columns that nothing is read from."""
    return [cell for place, cell in enumerate(cells) if cell and place not in used and cell not in _REVIEW]


def kind_of(head: str) -> str:
    """What a column holds, by the words of any language (table ``[answer_columns]``); '' for others."""
    word = " ".join(head.casefold().replace("_", " ").split())
    for language in languages():
        for kind, words in load_language(language).words("answer_columns").items():
            if word in (other.strip() for other in words.split(",")):
                return kind
    return ""


def read_columns(path: Path) -> dict[str, str]:
    """What the heads of tables stand for, from a file ``"Speed of B" = "1.v_B"``. Raises InputError."""
    problems: list[Problem] = []
    table = Table(read_toml(path), "", problems)
    found = {head: table.need(head, str, "") for head in table.data}
    problems += [
        Problem("expected a column of a table of answers", key=head, value=word, remedy='write "name" or "1.v_B"')
        for head, word in found.items()
        if word and not kind_of(word) and asked_by(word) is None
    ]
    if problems:
        raise InputError(problem.located(str(path)) for problem in problems)
    return found


def renamed(sheets: Sequence[Worksheet], columns: Mapping[str, str]) -> list[Worksheet]:
    """Tables with the words that their heads stand for. Raises InputError for a head that none of them has."""
    named = {_one_line(head): word for head, word in columns.items()}
    used: set[str] = set()
    found = []
    for sheet in sheets:
        first = []
        for number, cells in sheet.rows[:TITLE_ROWS]:
            used |= named.keys() & {_one_line(cell) for cell in cells}
            first.append((number, [named.get(_one_line(cell), cell) for cell in cells]))
        found.append(replace(sheet, rows=(*first, *sheet.rows[TITLE_ROWS:])))
    if unknown := [head for head in named if head not in used]:
        raise InputError(Problem("no table has such a column", key="--columns", value=head) for head in unknown)
    return found


def _one_line(text: str) -> str:
    return " ".join(text.split())
