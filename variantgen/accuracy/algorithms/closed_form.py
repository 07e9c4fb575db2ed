"""The closed form of the textbooks in real numbers, by angles."""

from __future__ import annotations

from collections.abc import Callable

from variantgen.accuracy.computed import CaseGroup, Computed

TITLE = "closed form of the textbooks"
SHORT = "textbook closed form"
DOUBLE = True
BATCH = 10_000


def applies(group: CaseGroup) -> str:
    """Where there is one."""
    return "" if group.textbook else "no closed form in the textbooks"


def prepare(group: CaseGroup) -> Callable[[], Computed]:
    """The formulas as they stand."""
    assert group.textbook is not None, "asked before"
    return group.textbook.closed_form
