"""What the table ``[figure]`` of a family says: marks of given angles, lengths and circles, how bodies are drawn."""

from __future__ import annotations

from msgspec import Struct

from variantgen.families.parameters.expressions import FamilyExpression


class AngleMark(Struct, frozen=True):
    """An angle to be drawn: at a point, from a ray to a ray; a ray leads to a point or in a direction."""

    name: str
    at: str
    start: str
    end: str


class RightAngle(Struct, frozen=True):
    """A right angle to be marked by a small square: at a point, between two rays (see :class:`AngleMark`)."""

    at: str
    start: str
    end: str


class LengthMark(Struct, frozen=True):
    """A length to be drawn as a dimension line between two points."""

    name: str
    start: str
    end: str


class DiscMark(Struct, frozen=True):
    """A circle to be drawn about a point; ``name`` is the parameter of its radius, ``radius`` its value.

    ``label`` is written into it (a gear's number; by default the symbol of its body). ``arc``: the circle is drawn as
    an arc by its joint, only the radius is marked here.
    """

    centre: str
    radius: FamilyExpression
    name: str = ""
    body: str = ""
    label: str = ""
    arc: bool = False


class FigureHints(Struct, frozen=True):
    """What the drawing cannot know from the scene.

    ``angles``, ``lengths``, ``discs`` with their names; ``hidden`` points; ``plates``: bodies drawn as polygons;
    ``plain``: bodies of which no bar is drawn; ``slotted``: bars drawn as slotted arms; ``lines``: further lines of
    links through points; ``thin``: thin lines of reference; ``axial``: the same in dashes and dots, lines of motion;
    ``grooves``: closed slots between two points; ``walls``: hatched lines between two points; ``bare``: points whose
    guide or slot is not drawn as such (the end of a ladder on a wall); ``stems``: points whose guide is a sleeve about
    a rod along it; ``right_angles`` that the
    text speaks of; ``found``: angles by their three points that the sheet tells because the position follows from a
    system of equations only; ``sketch``: quantities whose curves over a turn of the crank are to be drawn in a grid;
    ``graph``: the parameters of a rate and its acceleration that a graph over time tells in place of numbers;
    ``named``: points at rest that a scene shows by their letters because its data tell where they are.
    """

    angles: tuple[AngleMark, ...] = ()
    lengths: tuple[LengthMark, ...] = ()
    discs: tuple[DiscMark, ...] = ()
    hidden: tuple[str, ...] = ()
    plates: tuple[str, ...] = ()
    plain: tuple[str, ...] = ()
    slotted: tuple[str, ...] = ()
    lines: tuple[tuple[str, ...], ...] = ()
    thin: tuple[tuple[str, ...], ...] = ()
    grooves: tuple[tuple[str, ...], ...] = ()
    walls: tuple[tuple[str, ...], ...] = ()
    bare: tuple[str, ...] = ()
    stems: tuple[str, ...] = ()
    right_angles: tuple[RightAngle, ...] = ()
    found: tuple[tuple[str, ...], ...] = ()
    sketch: tuple[str, ...] = ()
    graph: tuple[str, ...] = ()
    named: tuple[str, ...] = ()
    axial: tuple[tuple[str, ...], ...] = ()

    def discs_of(self, body: str | None, centre: str) -> list[DiscMark]:
        """The discs about a point: of the body (None: of the ground), then those of nobody in particular."""
        found = [disc for disc in self.discs if disc.centre == centre and disc.body in ("", body or "")]
        return sorted(found, key=lambda disc: not disc.body)
