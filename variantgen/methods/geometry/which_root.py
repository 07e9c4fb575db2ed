"""Which of the two points at given distances from two others is meant: that on the side of their line as in the figure.

It is said where the point is so far from the line that the side is seen: above or below it, or, of a steep line, to the
right or left of it.
"""

from __future__ import annotations

from variantgen.methods.geometry.geometry import Geometry

_SEEN = 0.05  # of the size of the mechanism: a point nearer to a line is not seen beside it
_STEEP = 0.5  # cosine of the inclination of a line of which above and below are no longer said


def on_side(geometry: Geometry, key: str, point: str, first: str, second: str) -> str:
    """The key of the sentence that says on which side of the line through two points another one lies.

    ``key_above``, ``key_below``, ``key_right`` or ``key_left``; the ``key`` itself where the side is not seen.
    """
    line = geometry.vector(first, second)
    off = (line.conjugate() * geometry.vector(first, point)).imag / abs(line)
    if abs(off) < _SEEN * geometry.task.size:
        return key
    across = 1j * line / abs(line) * off  # from the line to the point
    if abs(line.real) > _STEEP * abs(line):
        return f"{key}_above" if across.imag > 0 else f"{key}_below"
    return f"{key}_right" if across.real > 0 else f"{key}_left"
