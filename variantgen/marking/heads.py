"""What the columns of a table of answers hold, by their heads."""

from __future__ import annotations

import re
from collections.abc import Mapping, Sequence
from pathlib import Path

from variantgen.errors import InputError, Problem
from variantgen.exam.roster.worksheet import Worksheet
from variantgen.limits import TITLE_ROWS
from variantgen.resources import languages
from variantgen.tables import Table, read_toml
from variantgen.wording.language import load_language

_ANSWER_HEAD = re.compile(r"\s*(\d{1,3})\s*[.:]\s*(\S.*?)\s*(?:,.*|\[.*|\(.*)?")


def asked_by(head: str) -> tuple[int, str] | None:
    """The problem and the quantity of a column, ``1.v_B`` or ``1.v_B, cm/s``."""
    found = _ANSWER_HEAD.fullmatch(head)
    return (int(found[1]), found[2]) if found else None


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
        found.append(Worksheet((*first, *sheet.rows[TITLE_ROWS:]), sheet.title))
    if unknown := [head for head in named if head not in used]:
        raise InputError(Problem("no table has such a column", key="--columns", value=head) for head in unknown)
    return found


def _one_line(text: str) -> str:
    return " ".join(text.split())
