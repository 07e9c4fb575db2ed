"""The sign in a question by which its attempts find their way back: ``[CU6-ML5 1.v_B]``.

Platforms name questions in their reports by the text alone, so the text says the code of the sheet, the problem, and
where a question asks for one number which it is.
"""

from __future__ import annotations

import re

from msgspec import Struct

_SIGN = re.compile(r"\[([0-9A-Z]{3}(?:-[0-9A-Z]{3}){1,8})\s+(\d{1,3})(?:\.([^\]\s]+))?\]")


class Reference(Struct, frozen=True):
    """The code of a sheet, the number of a problem, and a quantity or '' for the whole problem."""

    code: str
    problem: int
    quantity: str = ""

    def __str__(self) -> str:
        return f"[{self.code} {self.problem}{'.' if self.quantity else ''}{self.quantity}]"


def reference_in(text: str) -> Reference | None:
    """The last reference in the text of a question."""
    found = _SIGN.findall(text)
    return Reference(found[-1][0], int(found[-1][1]), found[-1][2]) if found else None
