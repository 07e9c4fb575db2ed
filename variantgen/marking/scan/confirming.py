"""Which readings stand, and which a person has to look at.

The key of every sheet is known. A doubtful reading that is right confirms itself: nobody fills in the right number by
a slip of the reader; but where it would be right in two ways, the key cannot tell which. Every other doubtful one goes
to a person, and so does one without a doubt that is wrong but would be right if a trace in another bubble counted, or a
weak mark did not: what costs a mark is looked at first.
"""

from __future__ import annotations

from collections.abc import Callable

from msgspec import Struct

from variantgen.marking.scan.numbers import Reading


class Confirmed(Struct, frozen=True):
    """A reading that stands (``text``, '' for blank), or one for a person to look at: then ``why``, in short words.

    One that ``may_follow`` stands if it is right given the student's earlier answers.
    """

    text: str
    why: tuple[str, ...] = ()
    may_follow: bool = False


def confirmed(own: Reading, is_right: Callable[[str], bool]) -> Confirmed:
    """What becomes of a reading; ``is_right`` asks the key about a number like ``-12.5``."""
    text = own.text or ""
    one_of_several = bool(own.doubts) and any(map(is_right, own.others))
    if text and own.may_confirm and is_right(text) and not one_of_several:
        return Confirmed(text)
    if own.doubts:
        return Confirmed(text, own.doubts, bool(text) and own.may_confirm)
    if not (text and is_right(text)) and any(map(is_right, own.others)):
        return Confirmed(text, ("near",), bool(text))
    return Confirmed(text)
