"""What became of each variant of a batch: solved, or why not.

"Not solvable" is an ordinary value. Where a variant's outcome is not ``SOLVED`` its numbers are finite
placeholders without meaning; they are never NaN, so that one bad variant cannot spoil or warn about a batch.
"""

from __future__ import annotations

from enum import IntEnum


class Outcome(IntEnum):
    """Outcome of one variant; the text gives cause and remedy."""

    SOLVED = 0
    NOT_ASSEMBLED = 1
    DEAD_POINT = 2
    DEGENERATE = 3

    @property
    def text(self) -> str:
        """Cause and remedy in one sentence."""
        return _TEXTS[self]


_TEXTS = {
    Outcome.SOLVED: "solved",
    Outcome.NOT_ASSEMBLED: (
        "the mechanism does not assemble: a link is too short or too long to close the chain; change a length or an"
        " angle"
    ),
    Outcome.DEAD_POINT: (
        "the mechanism is at a dead point: the given motion does not determine the others; move it away from there"
    ),
    Outcome.DEGENERATE: (
        "two points that should be apart coincide, two lines that should cross are parallel, or two circles that should"
        " touch cannot; move one of them or change a radius"
    ),
}
