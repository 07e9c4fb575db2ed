"""What an exam file says of solutions: how much, in which language, in which files."""

from __future__ import annotations

from msgspec import Struct

from variantgen.methods.solution_options import DEPTHS
from variantgen.tables import Table
from variantgen.wording.language import load_language

NONE = "none"
FILES = ("joined", "students")


class Solutions(Struct, frozen=True):
    """``depth``: ``none``, ``answers``, ``short`` or ``full``; ``language`` of the solutions.

    ``files``: ``joined`` in one document, or with ``students`` also one document for each of them. ``true_scale``: no
    vector of a figure is lengthened to be seen.
    """

    depth: str = "full"
    language: str = "en"
    files: str = "joined"
    true_scale: bool = False

    @property
    def wanted(self) -> bool:
        """Whether there are any."""
        return self.depth != NONE

    @property
    def for_students(self) -> bool:
        """Whether every student gets a file."""
        return self.wanted and self.files == "students"


def read_solutions(table: Table, language: str) -> Solutions:
    """The table ``[solutions]`` of an exam whose sheets are in ``language``; mistakes are noted in the table."""
    spoken = table.take("language", str, language)
    found = Solutions(
        table.choice("depth", (NONE, *DEPTHS), "full"),
        spoken,
        table.choice("files", FILES),
        table.take("true_scale", bool, False),
    )
    if "language" in table.data:
        with table.collecting("language"):
            load_language(spoken)
    table.finish()
    return found
