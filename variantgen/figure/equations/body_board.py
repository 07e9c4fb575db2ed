"""The board of a figure of one step: the bodies concerned, enlarged, with stubs of what is joined to them."""

from __future__ import annotations

import math
from collections.abc import Callable, Iterable, Mapping, Sequence
from itertools import accumulate, repeat
from operator import mul

import numpy as np
from msgspec import Struct
from msgspec.structs import asdict
from numpy.typing import NDArray

from variantgen.families.family import Form
from variantgen.figure.drawing import BOLD, THIN, Layer, Line
from variantgen.figure.equations.surroundings import Surroundings, corners_about, largest
from variantgen.figure.ink import segments_of, spaced
from variantgen.figure.making import Making, Unlettered
from variantgen.figure.motion.contact_letters import draw_dot
from variantgen.figure.motion.motion_board import LEAST, MotionBoard, head_of
from variantgen.figure.motion.motion_data import MovingMechanism
from variantgen.figure.placement.label_requests import along_arrow, around
from variantgen.figure.placement.least_crowded import first_roomy
from variantgen.figure.sketch import Sketch
from variantgen.methods.steps.step_geometry import NOTHING_MARKED, StepGeometry
from variantgen.wording.formula import Formula, Symbol

# Room for a figure but for its labels, and the size with them at which it is still printed with letters that can be
# read; the height of bodies in proportion to that room (u).
WIDE, HIGH = 89.0, 88.0
_WIDEST, _HIGHEST = 104.8, 105.2
_BODIES_HIGH = 0.92
_TRIES, _LESS = 4, 1.3  # rooms that are tried; by how much the next one is smaller, in proportion to what is too much
_SMALLER = 0.93  # steps in which room is sought
_SHORTEST = 24.0  # the longest vector becomes no shorter, u
_LEAST_BODY, _LEAST_RODS = 0.05, 0.5  # of the largest scale: how small bodies, and links between points, become
_LANE = 2.3  # between arrows that would lie on each other, u
_HEAD = 1.5  # end of an arrow that no hinge may hide, u
_TIPS = np.array([[0.5], [0.75], [1.0]])  # parts of an arrow that keep apart from others
_LANES = (0.0, 1.0, -1.0, 2.0, -2.0, 3.0)
_AXIS = 11.0  # length of an axis, u
_FREE = 5.0  # distance of axes from all lines that is enough, u
_AROUND = np.exp(1j * np.radians(np.arange(0, 360, 15)))
_SAMPLES = np.linspace(0.0, 1.0, 12)


class FigureSubject(Struct, frozen=True):
    """A mechanism for figures that mark a ``geometry``.

    ``poses`` are the directions (rad) in which the supports stand in the figure of the statement. With ``true_scale``
    no vector is lengthened to be seen.
    """

    mechanism: MovingMechanism
    poses: Mapping[str, float]
    geometry: StepGeometry = NOTHING_MARKED
    true_scale: bool = False

    @property
    def form(self) -> Form:
        """The form of the family."""
        return self.mechanism.variant.form

    @property
    def least(self) -> float:
        """The length of the shortest vector, u."""
        return 0.0 if self.true_scale else LEAST

    def board(self, scale: float) -> MotionBoard:
        """The mechanism without the data of the statement."""
        return MotionBoard(**asdict(self.mechanism.board(False, scale=scale, poses=self.poses)))


class BodyBoard:
    """Draws some ``bodies`` of a mechanism and the ``points`` of which the figure speaks, as large as there is room.

    ``further`` are places (m) beside these points at which something joins the bodies, ``rods`` links between points
    that are drawn in the place of discs that touch.
    ``room`` is the width and height for all but labels (u).
    """

    def __init__(
        self,
        subject: FigureSubject,
        bodies: Iterable[str],
        points: Iterable[str],
        further: Sequence[complex] = (),
        rods: Sequence[tuple[str, str]] = (),
        room: complex = complex(WIDE, HIGH),
    ) -> None:
        self.subject, self.room = subject, room
        self._rods = tuple(rods)
        self._bodies = tuple(bodies)
        self._further = further
        points = tuple(points)
        self.named = subject.mechanism.shown
        shown = {*self.named, *points}
        members = [subject.form.bodies[body] for body in self._bodies]
        self.points = tuple(dict.fromkeys([*points, *(name for member in members for name in member if name in shown)]))

    def place(self, point: str) -> complex:
        """The place of a point (m)."""
        return self.subject.mechanism.places[point]

    def fitted(
        self, spread: Callable[[float], Sequence[tuple[complex, complex]]], longest: float, size: float = 1.0
    ) -> tuple[float, float]:
        """The largest scale (u per metre) at which the bodies have room, and the length of the longest vector (u).

        They have it with what is ``spread`` about them where the longest vector is so long: each is a place (m) and how
        far from it (u). Vectors ``longest`` at first become shorter until they are no longer than the bodies are large:
        else these would be lost between their arrows.
        """
        z = self.subject.mechanism.places
        bodies = self._surroundings(z, 1.0).extent()
        low, high = corners_about(bodies)
        whole = high - low
        most = largest(bodies, size * self.room.real, size * _BODIES_HIGH * self.room.imag)
        if not math.isfinite(most):
            most = largest([z[p] for p in self.named], size * self.room.real, size * _BODIES_HIGH * self.room.imag)
        steps = math.ceil(math.log(_LEAST_RODS if self._rods else _LEAST_BODY, _SMALLER))
        scales = list(accumulate(repeat(_SMALLER, steps), mul, initial=most))
        number = 0
        while True:
            number = self._roomiest(scales, [(low, 0j), (high, 0j), *spread(longest)], number)
            scale = scales[number]
            shortest = min(longest, max(_SHORTEST, scale * max(whole.real, whole.imag)))
            if not whole or longest <= shortest:
                return scale, longest
            longest = max(_SMALLER * longest, shortest)

    def _roomiest(self, scales: Sequence[float], spots: Sequence[tuple[complex, complex]], first: int) -> int:
        """Which scale is the largest with room for places (m) and what lies so far from them (u); ``first`` is tried.

        Scales with room follow each other, because the extent of it all is a convex function of the scale.
        """

        def is_roomy(number: int) -> bool:
            scale = scales[number]
            x = [scale * place.real + way.real for place, way in spots]
            if max(x) - min(x) > self.room.real:
                return False
            y = [scale * place.imag + way.imag for place, way in spots]
            return max(y) - min(y) <= self.room.imag

        if not is_roomy(first):
            return next(filter(is_roomy, range(len(scales))), len(scales) - 1)
        while first and is_roomy(first - 1):
            first -= 1
        return first

    def drawn(self, scale: float) -> MotionBoard:
        """The board at a scale with the bodies on it."""
        board = self.subject.board(scale)
        kept = self._surroundings(board.sketch.at, scale)
        whole = board.sketch
        board.sketch = Sketch(whole.at, whole.scale, busy=whole.busy, symbol_radius=whole.symbol_radius)
        for piece in kept.pieces(whole.lines):
            board.sketch.add(piece)
        for request in whole.requests:
            if kept.names(request.own):
                board.sketch.label(request)
        board.shown = tuple(name for name in board.shown if name in self.points)
        for rod in self._rods:
            board.sketch.path([board.sketch.at[end] for end in rod], Layer.LINK, BOLD)
        for end in dict.fromkeys(end for rod in self._rods for end in rod):
            draw_point(board, end)
        return board

    def _surroundings(self, at: Mapping[str, complex], scale: float) -> Surroundings:
        """What is drawn, where the points are ``at`` places to a scale."""
        mechanism = self.subject.mechanism
        members = [tuple(at[p] for p in self._drawn_of(body)) for body in self._bodies]
        marked = zip(self.subject.form.figure.discs, mechanism.radii, strict=True)
        discs = [(disc, radius) for disc, radius in marked if not disc.arc]
        own = {disc.body for disc, _ in discs if disc.body in self._bodies or disc.centre == self.points[0]}
        own = set() if self._rods else own
        rims = [(at[disc.centre], scale * radius) for disc, radius in discs if disc.body in own]
        bearings = [name for body in self._bodies for name in self._bearings_of(body)]
        places = (*(at[name] for name in (*self.points, *bearings)), *(scale * place for place in self._further))
        others = tuple(at[name] for name in self.named if name not in self.points)
        return Surroundings(places, tuple(members), tuple(rims), others)

    def _bearings_of(self, body: str) -> list[str]:
        """The points of a body without names at which its rod slides in a bearing."""
        figure = self.subject.form.figure
        return [name for name in self._drawn_of(body) if name in figure.stems and name in figure.hidden]

    def _drawn_of(self, body: str) -> list[str]:
        """The points of a body between which it is drawn: where a single one has a name, those without too.

        They join it to the rest of the figure: the slot of a yoke to the end of its rod.
        """
        form = self.subject.form
        own = [name for name in form.bodies[body] if name in self.points]
        return own if len(own) > 1 else [name for name in form.bodies[body] if name in (*own, *form.figure.hidden)]


def with_room(tries: Callable[[complex], Iterable[Unlettered]]) -> Making:
    """The first roomy one of what is tried in some room (width and height but for labels, u).

    There is less while the labels make the figure too large.
    """
    room = complex(WIDE, HIGH)
    for _ in range(_TRIES):
        drawing = yield from first_roomy(tries(room))
        excess = complex(max(0.0, drawing.width - _WIDEST), max(0.0, drawing.height - _HIGHEST))
        if not excess:
            break
        room -= _LESS * excess
    return drawing


def draw_point(board: MotionBoard, point: str) -> None:
    """A dot and its letter for a point that the mechanism is not drawn with."""
    if point not in board.shown:
        draw_dot(board, board.sketch.at[point], point)
        board.shown = (*board.shown, point)


def draw_vectors(
    board: MotionBoard, place: complex, named: Sequence[tuple[Formula, complex, float]], others: list[complex]
) -> list[tuple[complex, complex]]:
    """Arrows (name, vector in u, weight) from one place; those that would lie on each other side by side.

    ``others`` are the places of arrows drawn before; where these arrows are is added to them. Returns their starts and
    tips.
    """
    hinges = [at for at in (board.sketch.at[name] for name in board.shown) if abs(at - place) > _LANE]
    found: list[tuple[complex, complex]] = []
    for name, vector, weight in sorted(named, key=lambda item: -abs(item[1])):
        start = place + _lane(place, vector, others, hinges)
        board.sketch.arrow(start, start + vector, Layer.SLIDER, weight, head_of(vector))
        board.sketch.label(along_arrow(name, start, start + vector))
        others += (start + vector * (0.25 + 0.75 * _SAMPLES)).tolist()
        found.append((start, start + vector))
    return found


def _lane(place: complex, vector: complex, others: Sequence[complex], hinges: Sequence[complex]) -> complex:
    """The least shift across a vector with which it lies on no arrow drawn before and its head on no hinge."""
    if not others and not hinges:
        return 0j
    side = 1j * vector / abs(vector)
    known, end = np.array(others, dtype=complex), place + vector
    best = (-1.0, 0j)
    for lane in _LANES:
        shift = lane * _LANE * side
        tips = place + shift + _TIPS * vector
        free = float(np.minimum.reduce(np.abs(known - tips), axis=None, initial=math.inf))
        head = (end + shift, end + shift - _HEAD * vector / abs(vector))
        free = min([free, *(abs(hinge - at) for hinge in hinges for at in head)])
        if free > 0.8 * _LANE:
            return shift
        best = max(best, (free, shift), key=lambda item: item[0])
    return best[1]


def sizes(lengths: Sequence[float], longest: float, least: float = LEAST) -> tuple[list[float], bool]:
    """Lengths (u) at which vectors of the given magnitudes are drawn, and whether any is lengthened to be seen."""
    scale = longest / max(lengths)
    found = [scale * length for length in lengths]
    return [max(length, least) for length in found], min(found) < least


def draw_axes(board: MotionBoard, place: complex, axes: Sequence[tuple[complex, str]], longest: float) -> None:
    """Thin arrows from one place beside a point, clear of its vectors, with their letters."""
    if not axes:
        return
    drawn = _along(board.sketch.lines)
    low, high = board.sketch.corners()
    arms = np.concatenate([_SAMPLES * (_AXIS + 3.0) * axis for axis, _ in axes])
    radii = np.repeat((0.55 * longest, 0.8 * longest, 1.05 * longest), len(_AROUND))
    origins = place + radii * np.tile(_AROUND, 3)
    # Best within the box of what is drawn: the figure does not grow.
    ends = origins[:, None] + arms
    out = np.maximum(ends.real - high.real, low.real - ends.real).max(axis=1, initial=0.0)
    out += np.maximum(ends.imag - high.imag, low.imag - ends.imag).max(axis=1, initial=0.0)
    costs = 0.08 * radii + 0.15 * out
    best = (-math.inf, place)
    # The best are asked first how far they are from all lines: most of the others cannot be better.
    for at in costs.argsort(kind="stable").tolist():
        if best[0] >= _FREE - costs[at]:
            break
        free = min(_FREE, float(np.abs(ends[at][:, None] - drawn).min()))
        best = max(best, (free - costs[at], complex(origins[at])), key=lambda item: item[0])
    origin = best[1]
    for axis, letter in axes:
        board.sketch.arrow(origin, origin + _AXIS * axis, Layer.MARK, THIN, 1.8)
        if letter:
            board.sketch.label(around(Symbol(board.language.axis(letter)), origin + _AXIS * axis, 0.3))


def _along(lines: Sequence[Line]) -> NDArray[np.complex128]:
    """Places along lines, so near to each other that they stand for all."""
    segments, _ = segments_of(lines, 0.5)
    steps = segments[:, 1] - segments[:, 0]
    counts = np.maximum(1, (np.abs(steps) / 3.0).astype(int))
    return np.append(spaced(segments[:, 0], steps, counts), segments[:, 1])
