"""The drawing language: paths, arcs and labels in figure units, rendered natively by each output.

One figure unit u is a hundredth of the width of the figure; x to the right, y up.
"""

from __future__ import annotations

import cmath
import math
from collections.abc import Callable, Mapping
from enum import IntEnum
from functools import cached_property
from typing import NamedTuple, TypeAlias

from msgspec import Struct, field

from variantgen.wording.formula import Formula, Symbol

BOLD, MEDIUM, THIN = 0.75, 0.45, 0.3  # line weights, u
LETTER = 4.3  # size of the lettering, u


class Layer(IntEnum):
    """Drawing order, back to front."""

    GROUND = 0
    THREAD = 1
    DISC = 2
    LINK = 3
    SLIDER = 4
    HINGE = 5
    MARK = 6
    VECTOR = 7
    LABEL = 8


# Lines and labels are named tuples, because every figure makes many of them, twice: where they are drawn and where they
# are on the paper.


class Path(NamedTuple):
    """A polyline; ``fill`` is '' (none), 'paper', 'ink' or 'shade', ``dash`` '' or 'dashed' or 'dashdot'."""

    points: tuple[complex, ...]
    layer: Layer
    weight: float = BOLD
    closed: bool = False
    fill: str = ""
    dash: str = ""


class Strokes(NamedTuple):
    """Many separate straight strokes of one pen (hatching)."""

    segments: tuple[tuple[complex, complex], ...]
    layer: Layer
    weight: float = THIN


class Arc(NamedTuple):
    """An arc of a circle, counter-clockwise from ``start`` over ``sweep`` (rad); a full turn is a circle."""

    centre: complex
    radius: float
    layer: Layer
    weight: float = BOLD
    start: float = 0.0
    sweep: float = math.tau
    fill: str = ""
    dash: str = ""

    @property
    def full(self) -> bool:
        """Whether it is a whole circle."""
        return abs(self.sweep) >= math.tau - 1e-9

    def at(self, part: float) -> complex:
        """The point at a fraction of the sweep."""
        return self.centre + cmath.rect(self.radius, self.start + part * self.sweep)

    def cubics(self) -> list[tuple[complex, complex, complex]]:
        """Cubic Bezier pieces (two control points, end) that follow ``at(0)``; error below 3e-4 of the radius."""
        count = max(1, math.ceil(abs(self.sweep) / (math.pi / 2) - 1e-9))
        step = self.sweep / count
        handle = 4 / 3 * math.tan(step / 4) * self.radius
        angles = [self.start + i * step for i in range(count + 1)]
        ends = [self.centre + cmath.rect(self.radius, angle) for angle in angles]
        ways = [handle * 1j * cmath.exp(1j * angle) for angle in angles]
        return [(ends[i] + ways[i], ends[i + 1] - ways[i + 1], ends[i + 1]) for i in range(count)]


Line: TypeAlias = Path | Strokes | Arc


class Label(NamedTuple):
    """A formula with its centre at a point; ``size`` (width, height) is what placement counted with.

    ``paper`` is what lies behind it: 'paper', or 'shade' on a shaded plate. ``arrow`` are the ends of the straight
    arrow that it names, if it names one.
    """

    formula: Formula
    at: complex
    size: tuple[float, float]
    paper: str = "paper"
    arrow: tuple[complex, complex] | None = None


class RotationArc(NamedTuple):
    """An arc of rotation: symbol of the rate, the arc with its head, radii (u) of its body's discs about its centre."""

    formula: Formula
    arc: Arc
    rims: tuple[float, ...] = ()


class Drawing(Struct, frozen=True, dict=True):
    """A finished figure: width and height in u, lines back to front, labels; ``tell`` makes its alternative text.

    A place z (m) on paper is drawn at ``scale * z + origin``. ``language`` is that of the words. ``beyond`` are the
    letters of points to which lines lead that lie outside the paper. ``lengthened`` says that a vector is drawn longer
    than to scale, so that it is seen, ``doubtful`` that a label may be hard to read: of others it is known that they
    have room. ``rotations`` are the arcs of rotation among the lines. ``graphs`` is the height of graphs below the
    figure of the mechanism. ``poses`` are the directions (rad) in which its supports stand.
    """

    width: float
    height: float
    lines: tuple[Line, ...]
    labels: tuple[Label, ...]
    tell: Callable[[], str] = str
    scale: float = 1.0
    origin: complex = 0j
    language: str = "en"
    beyond: tuple[Symbol, ...] = ()
    lengthened: bool = False
    doubtful: bool = True
    rotations: tuple[RotationArc, ...] = ()
    graphs: float = 0.0
    poses: Mapping[str, float] = field(default_factory=dict)

    @property
    def _seen(self) -> tuple[object, ...]:
        return tuple(getattr(self, name) for name in self.__struct_fields__ if name not in {"tell", "poses"})

    def __eq__(self, other: object) -> bool:
        return isinstance(other, Drawing) and self._seen == other._seen

    def __hash__(self) -> int:
        return hash(self._seen)

    @cached_property
    def alt(self) -> str:
        """What is seen, in words; empty where nothing tells it.

        It is made when it is first asked for: most documents on paper show it to nobody.
        """
        return self.tell()
