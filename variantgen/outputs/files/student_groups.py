"""Files for groups: which piece of a document belongs to which group, and how the files are named.

Where an output makes a file for each group, a part of the students gives a piece for each of its groups, in the order
of their names; the file of a group has those of its pieces. Thereby no part has to begin where a group does.
"""

from __future__ import annotations

from collections.abc import Iterable, Iterator, Mapping, Sequence
from itertools import islice
from pathlib import Path
from typing import Any, TypeVar

from msgspec import Struct

from variantgen.exam.sheets import Sheet
from variantgen.outputs.files.file_names import file_names

GROUPS = "groups"
_NOBODY = "no-group"  # the name of the file of those without a group

T = TypeVar("T")


def by_group(sheets: Iterable[Sheet]) -> dict[str, list[Sheet]]:
    """The sheets of each group, by their names."""
    found: dict[str, list[Sheet]] = {}
    for sheet in sheets:
        found.setdefault(sheet.student.group, []).append(sheet)
    return {group: found[group] for group in sorted(found)}


def documents(data: Mapping[str, Any], sheets: Sequence[Sheet]) -> Iterator[dict[str, Any]]:
    """The data of a document of sheets as that of one document for each group."""
    students = dict(zip(map(id, sheets), data["students"], strict=True))
    for own in by_group(sheets).values():
        listed = [students[id(sheet)] for sheet in own]
        yield {**data, "students": [*listed[:-1], {**listed[-1], "last": True}]}


class GroupFiles(Struct, frozen=True):
    """The groups of an exam in the order of the sheets: who is in them, and the names of their files (no ending)."""

    places: Mapping[str, Sequence[int]]
    stems: Mapping[str, str]

    @staticmethod
    def of(groups: Iterable[str]) -> GroupFiles:
        """The groups of all students, from that of each."""
        places: dict[str, list[int]] = {}
        for place, group in enumerate(groups):
            places.setdefault(group, []).append(place)
        return GroupFiles(places, dict(zip(places, file_names([group or _NOBODY for group in places]), strict=True)))

    def of_students(self, pieces: Sequence[T]) -> dict[str, list[T]]:
        """The pieces of each group, of a document that has one for every student."""
        return {group: [pieces[place] for place in own] for group, own in self.places.items()}

    def of_parts(self, pieces: Sequence[T], size: int) -> dict[str, list[T]]:
        """The pieces of each group, of a document that has one for every group in each part of ``size`` students."""
        owners = sorted({(place // size, group) for group, own in self.places.items() for place in own})
        found: dict[str, list[T]] = {group: [] for group in self.places}
        for (_, group), piece in zip(owners, pieces, strict=True):
            found[group].append(piece)
        return found


def parts_of(sheets: Iterable[Sheet], size: int) -> Iterator[list[Sheet]]:
    """The sheets by parts of so many students."""
    rest = iter(sheets)
    while part := list(islice(rest, size)):
        yield part


def both_halves(pieces: Sequence[Path], groups: GroupFiles, size: int) -> dict[str, list[Path]]:
    """The pieces of each group of a key, which has two overviews after each other: by student and by problem."""
    half = len(pieces) // 2
    first, second = (groups.of_parts(part, size) for part in (pieces[:half], pieces[half:]))
    return {group: first[group] + second[group] for group in first}
