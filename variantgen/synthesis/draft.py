"""A mechanism while it is laid out: points with places and constructions, data, bodies, what the statement will say."""

from __future__ import annotations

import cmath
import copy
import math
from typing import Any, TypeAlias

from msgspec import Struct, field
from msgspec.structs import replace

from variantgen.synthesis.chance import Chance

LETTERS = "ABCDEFGHKLMNQ"  # of moving points in the order of growth; P is the centre of velocities
ANGLES = ("beta", "gamma", "delta", "psi", "theta")  # alpha is an angular acceleration in English
WHEEL = "wheel1"  # the body of a rolling wheel
PINION = "gear1"  # the body of a gear in mesh
CRANK = "OA"  # the body of the driving link
# How the statement tells the first dyad and the position; "turning": the given motion comes first.
OPENINGS = ("driven", "given", "in_position", "turning")
_LENGTH_STEP, _ANGLE_STEP = 2, 5  # cm, degrees
Facts: TypeAlias = dict[str, str]
Component: TypeAlias = tuple[str, dict[str, Any]]
# Lists and tables of a draft whose entries do not change.
_FLAT = (
    *("z", "points", "data", "marks", "inside", "bars", "wheels", "sentences", "position", "asked", "pivots"),
    *("relative", "require", "symbols", "nouns", "called", "along_axes"),
)


class LayoutError(Exception):
    """A choice that leads to no mechanism; another one is tried."""


class Datum(Struct, frozen=True):
    """A printed number: its unit and value; ``spread``: how far its grid goes to either side."""

    unit: str
    value: float
    step: float
    spread: float


class Attachment(Struct, frozen=True):
    """A hinge at which a dyad hangs on a link: the point, how the statement says where it is, the link's far point."""

    point: str
    phrase: str
    facts: Facts
    towards: str = ""


class Wheel(Struct, frozen=True):
    """A circle that others keep off: its centre, radius (cm) and the largest of all variants, points that touch it."""

    centre: str
    radius: float
    largest: float
    touching: tuple[str, ...] = ()


class Link(Struct):
    """A moving link: a bar between two points, or a block on a pin (``end`` is empty).

    ``noun``: what it is called; ``free``: hinges at its ends that no dyad uses yet; ``extra``: it has its third joint.
    Of a block: ``guide``, the direction of its fixed guide (degrees); ``line``, the ends of the bar on which it slides;
    ``arm_only``: nothing else is hinged to this pin.
    """

    start: str
    end: str = ""
    noun: str = "rod"
    free: list[str] = field(default_factory=list)
    body: str = ""
    extra: bool = False
    guide: int | None = None
    line: tuple[str, str] = ("", "")
    arm_only: bool = False


class Draft(Struct):
    """What is laid out so far. Lengths in cm, directions in degrees, x right and y up."""

    rng: Chance
    opening: str = OPENINGS[0]
    lettered: bool = False  # fixed points have letters in the order of growth, not O1, O2
    brief: bool = False  # the statement is as short as it can be
    base: str = ""  # the point on whose line with O the angle of the driving link is measured; "-": beyond O
    z: dict[str, complex] = field(default_factory=dict)
    points: dict[str, Component] = field(default_factory=dict)
    data: dict[str, Datum] = field(default_factory=dict)
    bodies: dict[str, list[str]] = field(default_factory=dict)
    joints: list[Component] = field(default_factory=list)
    links: dict[int, Link] = field(default_factory=dict)
    marks: list[dict[str, str]] = field(default_factory=list)
    hints: dict[str, list[Any]] = field(default_factory=dict)
    inside: list[tuple[str, str, str]] = field(default_factory=list)
    bars: list[tuple[str, str]] = field(default_factory=list)
    wheels: list[Wheel] = field(default_factory=list)
    sentences: list[tuple[str, Facts]] = field(default_factory=list)
    position: list[tuple[str, Facts]] = field(default_factory=list)
    asked: list[list[str]] = field(default_factory=list)
    pivots: list[str] = field(default_factory=list)
    relative: list[tuple[str, Facts]] = field(default_factory=list)
    require: list[str] = field(default_factory=list)
    symbols: dict[str, str] = field(default_factory=dict)
    nouns: dict[str, str] = field(default_factory=dict)
    called: dict[str, str] = field(default_factory=dict)  # bodies that are cranks or rockers
    along_axes: set[frozenset[str]] = field(default_factory=set)  # two points on a horizontal or vertical line

    @property
    def upright(self) -> bool:
        """Whether the angle of the driving link is measured from the vertical, not from the horizontal."""
        return self.opening == "in_position"

    def copy(self) -> Draft:
        """A draft to go on with in one way, while this one stays as it is."""
        made = copy.copy(self)
        for name in _FLAT:
            setattr(made, name, copy.copy(getattr(self, name)))
        made.bodies = {name: [*points] for name, points in self.bodies.items()}
        made.hints = {key: [*values] for key, values in self.hints.items()}
        made.joints = [(kind, {**fields}) for kind, fields in self.joints]
        made.links = {n: replace(link, free=[*link.free]) for n, link in self.links.items()}
        return made

    def style(self, of: str) -> int:
        """0 or 1: which way to word a statement (or the like) is that of this layout; it depends on its data."""
        return Chance("style", of, *(f"{name}={datum.value:g}" for name, datum in self.data.items())).below(2)

    def letter(self) -> str:
        """The next letter of a moving point. Raises LayoutError where there is none."""
        found = next((letter for letter in LETTERS if letter not in self.points), "")
        if not found:
            raise LayoutError("too many points")
        return found

    def pivot(self) -> str:
        """The next name of a fixed point."""
        return self.letter() if self.lettered else f"O{len(self.pivots)}"

    def link_about(self, pivot: str, end: str) -> str:
        """The name of a link about a fixed point: O1B, but BC in the order of letters."""
        return "".join(sorted((pivot, end))) if self.lettered else pivot + end

    def hint(self, key: str, value: Any) -> None:
        """A line of the table ``[figure]``."""
        if value not in self.hints.setdefault(key, []):
            self.hints[key].append(value)

    def lies_along_axis(self, one: str, other: str) -> bool:
        """Whether two points are said to be on a horizontal or vertical line, by themselves or with their link."""
        pair = {one, other}
        return any(
            pair == ends or any(ends <= {*points} and pair <= {*points} for points in self.bodies.values())
            for ends in self.along_axes
        )

    def length(self, one: str, other: str, value: float, spread: float = 0.3, name: str = "") -> str:
        """A printed length between two points, rounded to its grid; returns its name."""
        name = name or one + other
        rounded = _LENGTH_STEP * round(value / _LENGTH_STEP)
        self.data[name] = Datum("cm", rounded, _LENGTH_STEP, spread * rounded)
        return name

    def radius(self, name: str, value: float, spread: float = 2) -> str:
        """A printed radius under its name, with the spread (cm) of its grid; returns the name."""
        self.data[name] = Datum("cm", value, _LENGTH_STEP, spread)
        return name

    def wheel(self, centre: str, radius: str, *touching: str) -> None:
        """A wheel of a printed radius about a point."""
        datum = self.data[radius]
        self.wheels.append(Wheel(centre, datum.value, datum.value + datum.spread, touching))

    def angle(self, value: float, at: str, start: str, end: str) -> str:
        """A printed angle marked in the figure, the value in whole steps; returns its name."""
        name = next((name for name in ANGLES if name not in self.data), "")
        if not name:
            raise LayoutError("too many angles")
        self.data[name] = Datum("deg", value, _ANGLE_STEP, 15)
        self.marks.append({"name": name, "at": at, "from": start, "to": end})
        return name

    def keep_between(self, part: str, whole: str) -> None:
        """Require of all variants that a point lies well between the ends of a bar, by printed lengths of both."""
        if part in self.data and whole in self.data:
            self.require += [f"{part} < 0.75 * {whole}", f"{part} > 0.25 * {whole}"]

    def bar(self, link: int, noun: str, start: str, end: str, free: tuple[str, ...] = (), name: str = "") -> Link:
        """A link that is a straight bar between two points; its ``name`` is that of its ends."""
        made = Link(start, end, noun, list(free), name or start + end)
        self.links[link] = made
        self.bodies[made.body] = [start, end]
        self.bars.append((start, end))
        return made

    def polar(self, name: str, origin: str, distance: str, angle: float, way: Facts) -> None:
        """A point at a printed distance and in a direction (degrees) from another, which the fields ``way`` say."""
        self.z[name] = self.z[origin] + cmath.rect(self.value(distance), math.radians(angle))
        self.points[name] = "polar", {"origin": origin, "distance": distance, **way}

    def place(self, name: str, origin: str, distance: float, angle: float) -> None:
        """A point at a distance (cm) and in a direction (degrees) from another that no sheet tells."""
        self.z[name] = self.z[origin] + cmath.rect(distance, math.radians(angle))
        self.points[name] = "polar", {"origin": origin, "distance": f"{distance:g}*cm", "angle": f"{angle % 360:g}*deg"}

    def joint(self, kind: str, **fields: Any) -> None:
        """A joint, with its fields as the file has them."""
        self.joints.append((kind, fields))

    def value(self, name: str) -> float:
        """The number of a datum."""
        return self.data[name].value

    def direction(self, one: str, other: str) -> float:
        """The direction from one point to another, in degrees."""
        return math.degrees(cmath.phase(self.z[other] - self.z[one]))

    def distance(self, one: str, other: str) -> float:
        """The distance of two points, in cm."""
        return abs(self.z[other] - self.z[one])
