"""A figure in the making: where points are on paper, what is drawn, which directions are taken, what needs a label."""

from __future__ import annotations

import cmath
import math
from collections.abc import Iterable, Mapping, Sequence
from dataclasses import dataclass, field
from itertools import pairwise
from typing import Any

import numpy as np
from numpy.typing import NDArray

from variantgen.figure.drawing import BOLD, MEDIUM, Arc, Drawing, Layer, Line, Path, Strokes
from variantgen.figure.labels import Request, boxes_crossed, place_labels

MARGIN = 1.5
HINGE = 1.1  # radius of a hinge circle, u
DOT = 0.65  # radius of a marked point, u
_HATCH_STEP, _HATCH_DEPTH = 1.15, 1.5
_MOST_STROKES = 400


@dataclass
class Sketch:
    """The drawing board. ``at`` holds positions of points in u; ``scale`` is u per metre."""

    at: dict[str, complex]
    scale: float
    lines: list[Line] = field(default_factory=list)
    requests: list[Request] = field(default_factory=list)
    busy: dict[str, list[float]] = field(default_factory=dict)
    reach: dict[str, float] = field(default_factory=dict)
    _obstacles: list[tuple[complex, complex]] = field(default_factory=list)
    _known: NDArray[np.complex128] = field(default_factory=lambda: np.zeros((0, 2), dtype=complex))

    def path(self, points: Iterable[complex], layer: Layer, weight: float = BOLD, **style: object) -> None:
        """Draw a polyline; it is an obstacle for labels."""
        line = Path(tuple(points), layer, weight, **style)  # type: ignore[arg-type]
        self.lines.append(line)
        ends = line.points + line.points[:1] if line.closed else line.points
        self._obstacles += list(pairwise(ends))

    def arc(self, arc: Arc) -> None:
        """Draw an arc or a circle; it is an obstacle for labels."""
        self.lines.append(arc)
        count = max(4, math.ceil(abs(arc.sweep) / 0.35))
        points = [arc.at(i / count) for i in range(count + 1)]
        self._obstacles += list(pairwise(points))

    def circle(self, centre: complex, radius: float, layer: Layer, weight: float = BOLD, fill: str = "") -> None:
        """Draw a circle."""
        self.arc(Arc(centre, radius, layer, weight, fill=fill))

    def hatch(self, start: complex, end: complex, side: complex) -> None:
        """Hatch a line on the side that a vector points to: strokes leaning right where the line allows."""
        way = (end - start) / abs(end - start)
        normal = 1j * way if (side * (1j * way).conjugate()).real >= 0 else -1j * way
        lean = complex(1, 1) / math.sqrt(2)
        if abs((lean * normal.conjugate()).real) < 0.5:
            lean = (normal + way) / math.sqrt(2)
        lean *= math.copysign(1.0, (lean * normal.conjugate()).real)
        stroke = lean * _HATCH_DEPTH / (lean * normal.conjugate()).real
        count = min(_MOST_STROKES, max(2, round((abs(end - start) - 0.6) / _HATCH_STEP)))
        feet = [start + way * (0.3 + (abs(end - start) - 0.6) * i / count) for i in range(count + 1)]
        self.lines.append(Strokes(tuple((foot, foot + stroke) for foot in feet), Layer.GROUND))
        far = normal * _HATCH_DEPTH
        self._obstacles += [
            (start + far, end + far),
            (start, start + far),
            (end, end + far),
            (start + far / 2, end + far / 2),
        ]

    def hatch_arc(self, centre: complex, radius: float, start: float, sweep: float, outside: bool) -> None:
        """Hatch an arc on its outer or inner side: strokes at half a right angle to it."""
        count = min(_MOST_STROKES, max(2, round((radius * sweep - 0.6) / _HATCH_STEP)))
        normal = 1.0 if outside else -1.0
        strokes = []
        for i in range(count):
            ray = cmath.rect(1.0, start + sweep * (i + 0.5) / count)
            foot = centre + radius * ray
            strokes.append((foot, foot + _HATCH_DEPTH * (normal + 1j) * ray))
        self.lines.append(Strokes(tuple(strokes), Layer.GROUND))
        far = Arc(centre, radius + normal * _HATCH_DEPTH, Layer.GROUND, start=start, sweep=sweep)
        pieces = max(4, math.ceil(sweep / 0.35))
        self._obstacles += list(pairwise([far.at(i / pieces) for i in range(pieces + 1)]))

    def arrow(
        self, start: complex, end: complex, layer: Layer = Layer.VECTOR, weight: float = BOLD, head: float = 2.6
    ) -> None:
        """A straight arrow with a filled head."""
        way = (end - start) / abs(end - start)
        self.path((start, end - 0.8 * head * way), layer, weight)
        self._head(end, way, layer, head)

    def arc_arrow(self, centre: complex, radius: float, start: float, sweep: float, weight: float = MEDIUM) -> None:
        """An arc with a head at its end, in the sense of ``sweep``."""
        head = 2.3
        sense = math.copysign(1.0, sweep)
        self.arc(Arc(centre, radius, Layer.VECTOR, weight, start, sweep - sense * 0.8 * head / radius))
        tip = centre + cmath.rect(radius, start + sweep)
        # The head follows the chord of its own length, so that it lies on the arc.
        way = 1j * sense * cmath.rect(1.0, start + sweep - sense * 0.5 * head / radius)
        self._head(tip, way, Layer.VECTOR, head)

    def _head(self, tip: complex, way: complex, layer: Layer, head: float) -> None:
        wing = 0.31 * head * 1j * way
        self.path((tip, tip - head * way + wing, tip - head * way - wing), layer, 0.0, closed=True, fill="ink")

    def occupy(self, point: str, direction: complex) -> None:
        """Note that something leaves a point in a direction."""
        self.busy.setdefault(point, []).append(cmath.phase(direction))

    def freedom(self, point: str, angle: float) -> float:
        """Angle from a direction to the nearest taken one at a point (rad)."""
        taken = self.busy.get(point, [])
        return min((abs(math.remainder(angle - other, math.tau)) for other in taken), default=math.pi)

    def crossings(self, places: Sequence[complex] | NDArray[Any], half_sides: tuple[float, float]) -> NDArray[np.int64]:
        """How many of the lines drawn so far cross the box about each place, shape (P,)."""
        return boxes_crossed(np.asarray(places), half_sides, self._segments())

    def _segments(self) -> NDArray[np.complex128]:
        if len(self._known) != len(self._obstacles):
            self._known = np.array(self._obstacles, dtype=complex).reshape(-1, 2)
        return self._known

    def label(self, request: Request) -> None:
        """Ask for a label."""
        self.requests.append(request)

    def finish(self, named: Mapping[str, complex]) -> Drawing:
        """Place the labels, cut the paper to size and put everything in order."""
        labels = place_labels(self.requests, self._segments(), list(named.values()))
        corners = [point for line in self.lines for point in _extent(line)]
        for label in labels:
            half = complex(*label.size) / 2
            corners += [label.at - half, label.at + half]
        low = complex(min(c.real for c in corners), min(c.imag for c in corners)) - complex(MARGIN, MARGIN)
        high = complex(max(c.real for c in corners), max(c.imag for c in corners)) + complex(MARGIN, MARGIN)
        ordered = sorted(self.lines, key=lambda line: line.layer)
        return Drawing(
            high.real - low.real,
            high.imag - low.imag,
            tuple(_moved(line, -low) for line in ordered),
            tuple(type(label)(label.formula, label.at - low, label.size) for label in labels),
        )


def _extent(line: Line) -> list[complex]:
    if isinstance(line, Path):
        return list(line.points)
    if isinstance(line, Strokes):
        return [point for segment in line.segments for point in segment]
    if line.full:
        return [line.centre - line.radius * (1 + 1j), line.centre + line.radius * (1 + 1j)]
    return [line.at(i / 8) for i in range(9)]


def _moved(line: Line, by: complex) -> Line:
    if isinstance(line, Path):
        return Path(tuple(p + by for p in line.points), line.layer, line.weight, line.closed, line.fill, line.dash)
    if isinstance(line, Strokes):
        return Strokes(tuple((p + by, q + by) for p, q in line.segments), line.layer, line.weight)
    return Arc(line.centre + by, line.radius, line.layer, line.weight, line.start, line.sweep, line.fill, line.dash)
