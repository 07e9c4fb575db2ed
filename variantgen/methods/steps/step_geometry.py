"""The angles and segments of which a step speaks: what its figure marks."""

from __future__ import annotations

from msgspec import Struct

from variantgen.algebra.expression import Value


class Corner(Struct, frozen=True):
    """An angle: its ``value``, and the ways from its vertex along its sides (printed unit of length).

    ``vertex`` is a point, ``ends`` are those on its sides, of which one must be seen. ``centre`` is the body to whose
    velocity or acceleration centre a side leads, or at whose centre the vertex is (``at_centre``). Of an angle between
    lines the vertical one is as good (``either``). At the points ``carried`` it is again, between parallel lines.
    One that ``is_part`` of what the step shows, and not shown itself, is marked only where all its points are seen.
    """

    value: Value
    vertex: str
    sides: tuple[complex, complex]
    ends: tuple[str, ...] = ()
    centre: str = ""
    at_centre: bool = False
    either: bool = False
    carried: tuple[str, ...] = ()
    is_part: bool = False


class MarkedFoot(Struct, frozen=True):
    """The foot of a perpendicular under a ``letter`` of its own: its place (m), the point from which it is dropped.

    ``line`` are the points of the figure on the line to which it is dropped, one or two.
    """

    letter: str
    place: complex
    apex: str
    line: tuple[str, ...]


class ChainGraph(Struct, frozen=True, dict=True):
    """A chain of links in the notation of graphs, ``O -1-> A -2-> B``: its first point, the end of each link."""

    start: str
    ends: tuple[str, ...]


class StepGeometry(Struct, frozen=True):
    """The ``corners``, the ends of the ``segments`` between points, in the order in which they are met, a ``chain``,
    the ``feet`` of perpendiculars.
    """

    corners: tuple[Corner, ...] = ()
    segments: tuple[tuple[str, str], ...] = ()
    chain: ChainGraph | None = None
    feet: tuple[MarkedFoot, ...] = ()

    @property
    def is_found(self) -> bool:
        """Whether there is more than what is given."""
        found = (corner.value.name is None or corner.value.name.kind != "parameter" for corner in self.corners)
        return bool(self.segments or self.feet) or any(found)

    def __add__(self, other: StepGeometry) -> StepGeometry:
        return StepGeometry(
            (*self.corners, *other.corners),
            (*self.segments, *other.segments),
            self.chain or other.chain,
            (*self.feet, *other.feet),
        )


NOTHING_MARKED = StepGeometry()
