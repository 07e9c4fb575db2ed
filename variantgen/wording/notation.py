"""The letters a course is used to: of angular acceleration, of the two components of an acceleration."""

from __future__ import annotations

from collections.abc import Iterable, Mapping

from msgspec import Struct
from msgspec.structs import replace

from variantgen.errors import InputError, Problem, nearest
from variantgen.tables import Table

CHOICES: Mapping[str, tuple[str, ...]] = {
    "angular_acceleration": ("epsilon", "alpha"),
    "components": ("normal", "rotational"),
}


class Notation(Struct, frozen=True):
    """``angular_acceleration``: its letter. ``components``: how the two parts of an acceleration are marked.

    ``normal`` writes ``n`` and the letter of the tangent in the language (``tau``, ``t``); ``rotational`` the short
    words for centripetal and rotational of the language. What is empty is as usual in the language. Raises InputError
    for another choice.
    """

    angular_acceleration: str = ""
    components: str = ""

    def __post_init__(self) -> None:
        problems = []
        for name in self.__struct_fields__:
            value, known = getattr(self, name), CHOICES[name]
            if value and value not in known:
                remedy = nearest(value, known)
                problems.append(Problem("unknown notation", key=name, value=value, remedy=remedy))
        if problems:
            raise InputError(problems)

    def filled(self, usual: Mapping[str, str]) -> Notation:
        """The notation with what is usual in a language where it chooses nothing."""
        return Notation(**{name: getattr(self, name) or usual[name] for name in self.__struct_fields__})


USUAL = Notation()


def notation_of(words: Iterable[str]) -> Notation:
    """The notation that words like ``alpha`` and ``rotational`` choose. Raises InputError for an unknown word."""
    chosen: dict[str, str] = {}
    for word in words:
        names = [name for name, known in CHOICES.items() if word in known]
        if not names:
            remedy = nearest(word, [word for known in CHOICES.values() for word in known])
            raise InputError(Problem("unknown notation", key="--notation", value=word, remedy=remedy))
        chosen[names[0]] = word
    return Notation(**chosen)


def read_notation(table: Table) -> Notation:
    """The letters that the course is used to; mistakes are noted in the table."""
    chosen = {name: table.take(name, str, "") for name in CHOICES}
    table.finish()
    try:
        return Notation(**chosen)
    except InputError as error:
        table.problems += [replace(problem, key=table.key(problem.key)) for problem in error.problems]
        return USUAL
