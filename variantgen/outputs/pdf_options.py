"""What an exam file says of PDFs: the table ``[pdf]``."""

from __future__ import annotations

from collections.abc import Sequence

from msgspec import Struct

from variantgen.errors import nearest
from variantgen.outputs.files.file_names import NAMINGS
from variantgen.tables import Table

NONE = "none"
ACCESSIBLE = "ua-1"
_FULL = ("a-1a", "a-2a", "a-3a")  # archiving with the structure of the text
_PRINTED = ("a-1b", "a-2b", "a-2u", "a-3b", "a-3u", "a-4")  # archiving of what is seen, or of that and the letters
STANDARDS = (*sorted((*_FULL, *_PRINTED)), ACCESSIBLE)
# Those of other versions of PDF than the one of PDF/UA-1 that the engine writes.
_WITHOUT_ACCESSIBLE = ("a-1a", "a-1b", "a-4")

FILES = ("joined", "students", "both", "groups")


class PdfOptions(Struct, frozen=True):
    """``standards`` to which every PDF conforms; ``files`` for the class, each student, both, or each group.

    ``names`` tells what the files of students are named by.
    """

    standards: tuple[str, ...] = ()
    files: str = FILES[0]
    names: str = NAMINGS[0]

    @property
    def tagged(self) -> bool:
        """Whether a standard wants tags."""
        return any(name in (*_FULL, ACCESSIBLE) for name in self.standards)

    @property
    def joined(self) -> bool:
        """Whether there are files for the whole class."""
        return self.files in ("joined", "both")

    @property
    def for_students(self) -> bool:
        """Whether every student gets files."""
        return self.files in ("students", "both")

    @property
    def for_groups(self) -> bool:
        """Whether every group gets files, and a key."""
        return self.files == "groups"


def read_options(table: Table) -> PdfOptions:
    """The table ``[pdf]``; mistakes are noted in it."""
    found = PdfOptions(
        _standards(table), table.choice("files", FILES, FILES[0]), table.choice("names", NAMINGS, NAMINGS[0])
    )
    table.finish()
    return found


def _standards(table: Table) -> tuple[str, ...]:
    listed = isinstance(table.data.get("standard"), list)
    names = (
        table.strings("standard") if listed else (table.take("standard", str, NONE, "a standard or a list of them"),)
    )
    wanted = tuple(dict.fromkeys(name.lower() for name in names))
    known = (NONE, *STANDARDS)
    for name in wanted:
        if name not in known:
            table.problem(f"expected {', '.join(known)}, or a list of them", "standard", name, nearest(name, known))
            return ()
    if problem := _conflict(wanted):
        table.problem(problem, "standard", ", ".join(wanted), 'for both purposes take ["a-2a", "ua-1"]')
        return ()
    return tuple(name for name in wanted if name != NONE)


def _conflict(names: Sequence[str]) -> str:
    """What is wrong with a choice of standards; nothing if they go together."""
    if NONE in names and len(names) > 1:
        return f'"{NONE}" goes with nothing else'
    archiving = [name for name in names if name in (*_FULL, *_PRINTED)]
    if len(archiving) > 1:
        return "a document conforms to one standard for archiving"
    if ACCESSIBLE in names and any(name in _WITHOUT_ACCESSIBLE for name in archiving):
        return f"{archiving[0]} and {ACCESSIBLE} are of different versions of PDF"
    return ""
