"""What the scans of one answer say together, where its page was scanned more than once.

Nothing is decided before all scans are there, so their order does not matter, and no third copy outvotes two that
contradict each other.
"""

from __future__ import annotations

from collections.abc import Sequence

from msgspec import Struct

from variantgen.marking.scan.confirming import Confirmed

DIFFER = "pages differ"


class ScannedAnswer(Struct, frozen=True):
    """An answer on a page: where it was read, how, and for doubtful ones a picture (PNG).

    ``others`` are the numbers that it may say instead, ``seen`` the bubbles of doubtful columns (see
    :class:`~variantgen.marking.scan.numbers.Reading`).
    """

    where: str
    read: Confirmed
    picture: bytes = b""
    others: tuple[str, ...] = ()
    seen: tuple[tuple[int, int, float], ...] = ()


def decided(readings: Sequence[ScannedAnswer]) -> ScannedAnswer:
    """The one answer of one or more scans of it.

    A clear reading settles a doubtful one only if it is a number that the doubtful one allows: a blank one may have
    lost a faint mark. Whatever contradicts itself is for a person to look at.
    """
    texts = {own.read.text for own in readings}
    clear = [own for own in readings if not own.read.why]
    doubtful = [own for own in readings if own.read.why]
    if not doubtful or not clear:
        if len(texts) == 1:
            return readings[0]
    elif len({own.read.text for own in clear}) == 1:
        text = clear[0].read.text
        if text and all(text in (own.read.text, *own.others) for own in doubtful):
            return clear[0]
    shown = next((own for own in reversed(readings) if own.picture), (doubtful or clear)[0])  # what is told is seen
    why = dict.fromkeys([*(one for own in doubtful for one in own.read.why), DIFFER])
    where = ", ".join(dict.fromkeys(own.where for own in readings))
    return ScannedAnswer(where, Confirmed(shown.read.text, tuple(why)), shown.picture, seen=shown.seen)
