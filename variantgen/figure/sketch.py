"""A figure in the making: where points are on paper, what is drawn, which directions are taken, what needs a label."""

from __future__ import annotations

import cmath
import math
from collections.abc import Iterable, Sequence
from typing import Any, NamedTuple

import numpy as np
from msgspec import Struct, field
from msgspec.structs import replace
from numpy.typing import NDArray

from variantgen.figure.drawing import BOLD, MEDIUM, Arc, Layer, Line, Path, RotationArc, Strokes
from variantgen.figure.ink import Sides
from variantgen.figure.obstacles import Obstacles, Outline
from variantgen.figure.placement.label_requests import LabelRequest
from variantgen.wording.formula import Symbol

MARGIN = 1.5
HINGE = 1.1  # radius of a hinge circle, u
DOT = 0.65  # radius of a marked point, u
_HATCH_STEP, _HATCH_DEPTH = 1.15, 1.5
_MOST_STROKES = 400


class Wall(NamedTuple):
    """A straight hatched line with the direction (unit) to its hatching; a bearing is as long as it is."""

    start: complex
    end: complex
    normal: complex
    bearing: bool = False


class RoundWall(NamedTuple):
    """A hatched arc: angles in rad; ``outside`` says on which side the hatching is."""

    centre: complex
    radius: float
    start: float
    sweep: float
    outside: bool


class Sketch(Struct):
    """The drawing board. ``at`` holds positions of points in u; ``scale`` is u per metre.

    ``beyond`` collects the letters of points that lie outside the paper, though lines lead to them; ``lengthened``
    notes that a vector is longer than to scale, ``rotations`` are the arcs of rotation,
    ``walls`` and ``round_walls`` the hatched lines and arcs.
    """

    at: dict[str, complex]
    scale: float
    lines: list[Line] = field(default_factory=list)
    requests: list[LabelRequest] = field(default_factory=list)
    busy: dict[str, list[float]] = field(default_factory=dict)
    symbol_radius: dict[str, float] = field(default_factory=dict)
    beyond: list[Symbol] = field(default_factory=list)
    lengthened: bool = False
    rotations: list[RotationArc] = field(default_factory=list)
    walls: list[Wall] = field(default_factory=list)
    round_walls: list[RoundWall] = field(default_factory=list)
    obstacles: Obstacles = field(default_factory=Obstacles)
    _corners: tuple[complex, ...] = ()  # of the box about the first lines
    _bounded: int = 0  # of how many of them

    def path(self, points: Iterable[complex], layer: Layer, weight: float = BOLD, **style: object) -> None:
        """Draw a polyline; it is an obstacle for labels."""
        line = Path(tuple(points), layer, weight, **style)  # type: ignore[arg-type]
        self._add(line, line)

    def add(self, line: Line) -> None:
        """Draw a finished line; it is an obstacle for labels."""
        self._add(line, line)

    def arc(self, arc: Arc) -> None:
        """Draw an arc or a circle; it is an obstacle for labels."""
        self._add(arc, arc)

    def circle(self, centre: complex, radius: float, layer: Layer, weight: float = BOLD, fill: str = "") -> None:
        """Draw a circle."""
        self.arc(Arc(centre, radius, layer, weight, fill=fill))

    def hatch(self, start: complex, end: complex, side: complex, bearing: bool = False) -> None:
        """Hatch a line on the side that a vector points to: strokes leaning right where the line allows."""
        way = (end - start) / abs(end - start)
        normal = 1j * way if (side * (1j * way).conjugate()).real >= 0 else -1j * way
        lean = complex(1, 1) / math.sqrt(2)
        if abs((lean * normal.conjugate()).real) < 0.5:
            lean = (normal + way) / math.sqrt(2)
        lean *= math.copysign(1.0, (lean * normal.conjugate()).real)
        stroke = lean * _HATCH_DEPTH / (lean * normal.conjugate()).real
        length = abs(end - start) - 0.6
        count = min(_MOST_STROKES, max(2, round(length / _HATCH_STEP)))
        feet = [start + way * (0.3 + length * i / count) for i in range(count + 1)]
        first, last = feet[0], feet[-1]
        self.walls.append(Wall(start, end, normal, bearing))
        outline = [
            (first + stroke, last + stroke),
            (first, first + stroke),
            (last, last + stroke),
            (first + stroke / 2, last + stroke / 2),
        ]
        self._add(Strokes(tuple([(foot, foot + stroke) for foot in feet]), Layer.GROUND), *outline)

    def hatch_arc(self, centre: complex, radius: float, start: float, sweep: float, outside: bool) -> None:
        """Hatch an arc on its outer or inner side: strokes at half a right angle to it."""
        count = min(_MOST_STROKES, max(2, round((radius * sweep - 0.6) / _HATCH_STEP)))
        self.round_walls.append(RoundWall(centre, radius, start, sweep, outside))
        normal = 1.0 if outside else -1.0
        strokes = []
        for i in range(count):
            ray = cmath.rect(1.0, start + sweep * (i + 0.5) / count)
            foot = centre + radius * ray
            strokes.append((foot, foot + _HATCH_DEPTH * (normal + 1j) * ray))
        far = Arc(centre, radius + normal * _HATCH_DEPTH, Layer.GROUND, start=start, sweep=sweep)
        self._add(Strokes(tuple(strokes), Layer.GROUND), far, strokes[0], strokes[-1])

    def arrow(
        self, start: complex, end: complex, layer: Layer = Layer.VECTOR, weight: float = BOLD, head: float = 2.6
    ) -> None:
        """A straight arrow with a filled head."""
        way = (end - start) / abs(end - start)
        self.path((start, end - 0.8 * head * way), layer, weight)
        self._head(end, way, layer, head)

    def arc_arrow(self, centre: complex, radius: float, start: float, sweep: float) -> Arc:
        """An arc with a head at its end, in the sense of ``sweep``; returns it with its head."""
        head = 2.3
        sense = math.copysign(1.0, sweep)
        self.arc(Arc(centre, radius, Layer.VECTOR, MEDIUM, start, sweep - sense * 0.8 * head / radius))
        tip = centre + cmath.rect(radius, start + sweep)
        # The head follows the chord of its own length, so that it lies on the arc.
        way = 1j * sense * cmath.rect(1.0, start + sweep - sense * 0.5 * head / radius)
        self._head(tip, way, Layer.VECTOR, head)
        return Arc(centre, radius, Layer.VECTOR, MEDIUM, start, sweep)

    def _head(self, tip: complex, way: complex, layer: Layer, head: float) -> None:
        wing = 0.31 * head * 1j * way
        self.path((tip, tip - head * way + wing, tip - head * way - wing), layer, 0.0, closed=True, fill="ink")

    def _add(self, line: Line, *obstacles: Outline) -> None:
        """Draw a line that stands in the way of labels as the ``obstacles`` say."""
        self.lines.append(line)
        for outline in obstacles:
            self.obstacles.add(outline, line.weight or BOLD)  # heads have no outline

    def occupy(self, point: str, direction: complex) -> None:
        """Note that something leaves a point in a direction."""
        self.busy.setdefault(point, []).append(cmath.phase(direction))

    def is_taken(self, point: str, direction: complex, within: float) -> bool:
        """Whether something leaves a point within an angle (rad) of a direction."""
        angle = cmath.phase(direction)
        gaps = ((angle - taken + math.pi) % math.tau - math.pi for taken in self.busy.get(point, ()))
        return any(abs(gap) <= within for gap in gaps)

    def freedom(self, point: str, angles: NDArray[np.float64]) -> NDArray[np.float64]:
        """Angle from each direction to the nearest taken one at a point (rad), shape (A,)."""
        taken = np.array(self.busy.get(point, ()))
        gaps = np.abs(np.remainder(angles[:, None] - taken + math.pi, math.tau) - math.pi)
        result: NDArray[np.float64] = np.minimum.reduce(gaps, axis=1, initial=math.pi)
        return result

    def crossings(self, places: Sequence[complex] | NDArray[Any], half_sides: tuple[Sides, Sides]) -> NDArray[np.int64]:
        """How many of the lines drawn so far cross the box about each place, shape (P,); see :class:`Obstacles`."""
        return self.obstacles.crossings(places, half_sides)

    def label(self, request: LabelRequest) -> None:
        """Ask for a label."""
        self.requests.append(request)

    def copied(self) -> Sketch:
        """The same on a sheet of its own."""
        return replace(
            self,
            at=dict(self.at),
            lines=[*self.lines],
            requests=[*self.requests],
            busy={point: [*taken] for point, taken in self.busy.items()},
            symbol_radius=dict(self.symbol_radius),
            beyond=[*self.beyond],
            rotations=[*self.rotations],
            walls=[*self.walls],
            round_walls=[*self.round_walls],
            obstacles=self.obstacles.copied(),
        )

    @property
    def width(self) -> float:
        """The width of the paper that the lines so far take (u)."""
        if not self.lines:
            return 0.0
        low, high = self.corners()
        return (high - low).real + 2 * MARGIN

    def corners(self) -> tuple[complex, complex]:
        """Lower left and upper right corner of what is drawn so far."""
        new = self.lines[self._bounded :]
        if new:
            self._corners = box_about([*self._corners, *(place for line in new for place in _extent(line))])
            self._bounded = len(self.lines)
        low, high = self._corners
        return low, high


def box_about(points: Sequence[complex]) -> tuple[complex, complex]:
    """Lower left and upper right corner of the box about points."""
    every = np.array(points)
    x, y = every.real, every.imag
    low, high = np.minimum.reduce, np.maximum.reduce
    return complex(low(x), low(y)), complex(high(x), high(y))


def _extent(line: Line) -> list[complex]:
    if isinstance(line, Path):
        return list(line.points)
    if isinstance(line, Strokes):
        return [point for segment in line.segments for point in segment]
    if line.full:
        return [line.centre - line.radius * (1 + 1j), line.centre + line.radius * (1 + 1j)]
    return [line.centre + cmath.rect(line.radius, line.start + i / 8 * line.sweep) for i in range(9)]


def moved(line: Line, by: complex) -> Line:
    """A line at another place."""
    if isinstance(line, Path):
        return Path(tuple([p + by for p in line.points]), line.layer, line.weight, line.closed, line.fill, line.dash)
    if isinstance(line, Strokes):
        return Strokes(tuple([(p + by, q + by) for p, q in line.segments]), line.layer, line.weight)
    return moved_arc(line, by)


def moved_arc(arc: Arc, by: complex) -> Arc:
    """An arc at another place."""
    return arc._replace(centre=arc.centre + by)
