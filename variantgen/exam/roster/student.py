"""A student, as the program knows one."""

from __future__ import annotations

from msgspec import Struct


class Student(Struct, frozen=True):
    """One entry of the roster; ``id`` alone decides the variant."""

    id: str
    name: str
    group: str = ""


def numbered(count: int) -> list[Student]:
    """Students without a roster: ids 1 .. count, no names."""
    return [Student(str(i), "") for i in range(1, count + 1)]
