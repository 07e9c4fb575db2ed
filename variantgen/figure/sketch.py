"""A figure in the making: where points are on paper, what is drawn, which directions are taken, what needs a label."""

from __future__ import annotations

import cmath
import math
from collections.abc import Iterable, Mapping, Sequence
from dataclasses import dataclass, field
from itertools import chain
from typing import Any

import numpy as np
from numpy.typing import NDArray

from variantgen.figure.drawing import BOLD, MEDIUM, Arc, Drawing, Label, Layer, Line, Path, Strokes, Turn
from variantgen.figure.ink import Sides, boxes_crossed_by, segments_of, spans_of
from variantgen.figure.label_requests import LabelRequest
from variantgen.figure.labels import place_labels
from variantgen.wording.formula import Symbol

MARGIN = 1.5
HINGE = 1.1  # radius of a hinge circle, u
DOT = 0.65  # radius of a marked point, u
_HATCH_STEP, _HATCH_DEPTH = 1.15, 1.5
_MOST_STROKES = 400
_SAGITTA = 0.12  # of the chords that stand for an arc among the obstacles, u


@dataclass
class Sketch:
    """The drawing board. ``at`` holds positions of points in u; ``scale`` is u per metre.

    ``beyond`` collects the letters of points that lie outside the paper, though lines lead to them; ``lengthened``
    notes that a vector is longer than to scale, ``turns`` are the arcs of rotation,
    ``walls`` the ends of hatched lines with the direction (unit) to their hatching.
    """

    at: dict[str, complex]
    scale: float
    lines: list[Line] = field(default_factory=list)
    requests: list[LabelRequest] = field(default_factory=list)
    busy: dict[str, list[float]] = field(default_factory=dict)
    symbol_radius: dict[str, float] = field(default_factory=dict)
    beyond: list[Symbol] = field(default_factory=list)
    lengthened: bool = False
    turns: list[Turn] = field(default_factory=list)
    walls: list[tuple[complex, complex, complex]] = field(default_factory=list)
    _corners: list[complex] = field(default_factory=list)
    _obstacles: list[complex] = field(default_factory=list)  # ends of segments in turn
    _weights: list[float] = field(default_factory=list)  # of the lines of these segments
    _known: NDArray[np.complex128] = field(default_factory=lambda: np.zeros((0, 2), dtype=complex))
    _spans: NDArray[np.float64] = field(default_factory=lambda: np.zeros((6, 0)))

    def path(self, points: Iterable[complex], layer: Layer, weight: float = BOLD, **style: object) -> None:
        """Draw a polyline; it is an obstacle for labels."""
        line = Path(tuple(points), layer, weight, **style)  # type: ignore[arg-type]
        self._add(line, segments_of(line))

    def add(self, line: Line) -> None:
        """Draw a finished line; it is an obstacle for labels."""
        self._add(line, segments_of(line, _SAGITTA))

    def arc(self, arc: Arc) -> None:
        """Draw an arc or a circle; it is an obstacle for labels."""
        self._add(arc, segments_of(arc, _SAGITTA))

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
        length = abs(end - start) - 0.6
        count = min(_MOST_STROKES, max(2, round(length / _HATCH_STEP)))
        feet = [start + way * (0.3 + length * i / count) for i in range(count + 1)]
        first, last = feet[0], feet[-1]
        self.walls.append((start, end, normal))
        outline = [
            (first + stroke, last + stroke),
            (first, first + stroke),
            (last, last + stroke),
            (first + stroke / 2, last + stroke / 2),
        ]
        self._add(Strokes(tuple([(foot, foot + stroke) for foot in feet]), Layer.GROUND), outline)

    def hatch_arc(self, centre: complex, radius: float, start: float, sweep: float, outside: bool) -> None:
        """Hatch an arc on its outer or inner side: strokes at half a right angle to it."""
        count = min(_MOST_STROKES, max(2, round((radius * sweep - 0.6) / _HATCH_STEP)))
        normal = 1.0 if outside else -1.0
        strokes = []
        for i in range(count):
            ray = cmath.rect(1.0, start + sweep * (i + 0.5) / count)
            foot = centre + radius * ray
            strokes.append((foot, foot + _HATCH_DEPTH * (normal + 1j) * ray))
        far = Arc(centre, radius + normal * _HATCH_DEPTH, Layer.GROUND, start=start, sweep=sweep)
        self._add(Strokes(tuple(strokes), Layer.GROUND), [*segments_of(far, _SAGITTA), strokes[0], strokes[-1]])

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

    def _add(self, line: Line, obstacles: Sequence[tuple[complex, complex]]) -> None:
        """Draw a line that stands in the way of labels as the ``obstacles`` say."""
        self.lines.append(line)
        self._corners += _extent(line)
        self._obstacles += chain.from_iterable(obstacles)
        self._weights += [line.weight] * len(obstacles)

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
        """How many of the lines drawn so far cross the box about each place, shape (P,); see :func:`boxes_crossed`."""
        segments = self._segments()
        if self._spans.shape[1] != len(segments):
            self._spans = np.concatenate((self._spans, spans_of(segments[self._spans.shape[1] :])), axis=1)
        return boxes_crossed_by(self._spans, np.asarray(places), half_sides)

    def circle_crossings(
        self, centre: complex, radii: NDArray[np.float64]
    ) -> tuple[NDArray[np.float64], NDArray[np.intp]]:
        """Directions (rad) in which drawn lines cross circles about a centre; which circle: shape (K,) each."""
        segments = self._segments()
        start, step = segments[:, 0] - centre, segments[:, 1] - segments[:, 0]
        # |start + t step| = radius
        a, b = step.real**2 + step.imag**2, start.real * step.real + start.imag * step.imag
        root = (b * b - a * (start.real**2 + start.imag**2))[None, :] + a[None, :] * radii[:, None] ** 2
        circle, line = ((root >= 0) & (a > 0)).nonzero()
        a, b, root = a[line], b[line], np.sqrt(root[circle, line])
        t = np.concatenate(((-b - root) / a, (-b + root) / a))
        on = ((t >= 0) & (t <= 1)).nonzero()[0]
        met = on % max(1, len(line))
        place = start[line[met]] + t[on] * step[line[met]]
        return np.arctan2(place.imag, place.real), circle[met]

    def corners_near_circles(
        self, centre: complex, radii: NDArray[np.float64], margin: float
    ) -> tuple[NDArray[np.float64], NDArray[np.intp]]:
        """Directions (rad) of beginnings of segments near circles about a centre, and which circle; shape (K,) each.

        Near is within ``margin`` (u) of the ``radii``, shape (R,).
        """
        arms = self._segments()[:, 0] - centre
        circle, arm = (np.abs(np.abs(arms) - radii[:, None]) < margin).nonzero()
        return np.arctan2(arms.imag, arms.real)[arm], circle

    def weight_on_rays(
        self, centre: complex, angles: NDArray[np.float64], start: float, end: float
    ) -> NDArray[np.float64]:
        """Weights (u) of the lines drawn so far that each ray from a centre crosses between two distances, shape (A,)."""
        segments = (self._segments() - centre)[None, :, :] * np.exp(-1j * angles)[:, None, None]
        low, high = segments[..., 0], segments[..., 1]
        rise = high.imag - low.imag
        over = (low.imag <= 0) != (high.imag <= 0)
        place = low.real - low.imag * (high.real - low.real) / np.where(over, rise, 1.0)
        result: NDArray[np.float64] = np.sum(self._weights * (over & (place > start) & (place < end)), axis=1)
        return result

    def _segments(self) -> NDArray[np.complex128]:
        if self._known.size != len(self._obstacles):
            new = np.array(self._obstacles[self._known.size :], dtype=complex).reshape(-1, 2)
            self._known = np.concatenate((self._known, new))
        return self._known

    def lanes_met(
        self,
        centre: complex,
        way: complex,
        lanes: NDArray[np.float64],
        half_widths: NDArray[np.float64],
        further: Sequence[tuple[complex, complex]] = (),
    ) -> tuple[NDArray[np.float64], NDArray[np.float64]]:
        """From where to where each line drawn so far (and each of ``further`` ones) runs in each lane, shape (L, S) each.

        A lane is the paper within a half width (shape (L,)) of a line through ``centre`` in the direction ``way`` (unit),
        moved to the left by ``lanes`` (shape (L,)); distances are along the way. A line that is nowhere in a lane goes
        from infinity to minus infinity.
        """
        every = np.concatenate((self._segments(), np.array(further, dtype=complex).reshape(-1, 2)))
        local = (every - centre) * way.conjugate()
        start, step = local[:, 0], local[:, 1] - local[:, 0]
        rise = np.where(np.abs(step.imag) > 1e-9, step.imag, 1e-9)
        edges = lanes[:, None] + np.array((-1.0, 1.0))[:, None, None] * half_widths[:, None]
        first, last = np.sort((edges - start.imag) / rise, axis=0)
        first, last = np.maximum(first, 0.0), np.minimum(last, 1.0)
        ends = np.sort(start.real + np.array((first, last)) * step.real, axis=0)
        within = first <= last
        return np.where(within, ends[0], np.inf), np.where(within, ends[1], -np.inf)

    def label(self, request: LabelRequest) -> None:
        """Ask for a label."""
        self.requests.append(request)

    def corners(self) -> tuple[complex, complex]:
        """Lower left and upper right corner of what is drawn so far."""
        return _box(self._corners)

    def finish(self, named: Mapping[str, complex]) -> Drawing:
        """Place the labels, cut the paper to size and put everything in order."""
        labels, leaders = place_labels(self.requests, self._segments(), list(named.values()))
        corners = [*self._corners, *(point for leader in leaders for point in leader.points)]
        for label in labels:
            half = complex(*label.size) / 2
            corners += [label.at - half, label.at + half]
        low, high = _box(corners)
        low, high = low - complex(MARGIN, MARGIN), high + complex(MARGIN, MARGIN)
        ordered = sorted([*self.lines, *leaders], key=lambda line: line.layer)
        plates = [line.points for line in self.lines if isinstance(line, Path) and line.fill == "shade"]
        return Drawing(
            high.real - low.real,
            high.imag - low.imag,
            tuple(moved(line, -low) for line in ordered),
            tuple(_on_paper(x, -low, plates) for x in labels),
            scale=self.scale,
            origin=-low,
            beyond=tuple(self.beyond),
            lengthened=self.lengthened,
            turns=tuple([turn._replace(arc=_moved_arc(turn.arc, -low)) for turn in self.turns]),
        )


def _on_paper(label: Label, by: complex, plates: Sequence[Sequence[complex]]) -> Label:
    """A label moved to its place on the paper; ``plates`` are where it was placed."""
    arrow = None if label.arrow is None else (label.arrow[0] + by, label.arrow[1] + by)
    return Label(label.formula, label.at + by, label.size, _behind(label, plates), arrow)


def _behind(label: Label, plates: Sequence[Sequence[complex]]) -> str:
    """What lies behind a label, which stands clear of the outlines of plates: their shade or paper."""
    return "shade" if any(_surrounds(corners, label.at) for corners in plates) else "paper"


def _surrounds(corners: Sequence[complex], place: complex) -> bool:
    """Whether a polygon has a place inside: a ray to the right crosses its sides an odd number of times."""
    inside = False
    for start, end in zip(corners, (*corners[1:], corners[0]), strict=True):
        low, high = start - place, end - place
        if (low.imag > 0) != (high.imag > 0):
            inside ^= low.real - low.imag * (high.real - low.real) / (high.imag - low.imag) > 0
    return inside


def _box(points: Sequence[complex]) -> tuple[complex, complex]:
    """Lower left and upper right corner of the box about points."""
    x, y = [p.real for p in points], [p.imag for p in points]
    return complex(min(x), min(y)), complex(max(x), max(y))


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
    return _moved_arc(line, by)


def _moved_arc(arc: Arc, by: complex) -> Arc:
    return arc._replace(centre=arc.centre + by)
