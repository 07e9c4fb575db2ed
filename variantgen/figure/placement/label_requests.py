"""Labels that are wanted: what they name and where they may stand."""

from __future__ import annotations

import cmath
import math
from functools import lru_cache

import numpy as np
from msgspec import Struct
from numpy.typing import NDArray

from variantgen.figure.drawing import LETTER
from variantgen.figure.letters.lettering import typeset
from variantgen.wording.formula import Formula, Measured, Number

Places = NDArray[np.complex128]
Costs = NDArray[np.float64]
_WIDE = math.radians(50)


def label_size(formula: Formula) -> tuple[float, float]:
    """Width and height of the ink of a label (u)."""
    found = typeset(formula)
    return LETTER * found.width, LETTER * (found.top - found.bottom)


class LabelRequest(Struct, eq=False):
    """A label to be placed: the formula, the point it names, candidate centres and their own costs, shape (P,).

    ``extent`` are further points of what it names (an arc), that no other label should be nearer to than to its own.
    ``clear`` is the radius (u) of the symbol at the anchor, where a leader would end. ``vector`` says that it names a
    straight arrow, which must not be read with the letter of another one. A leader ends at the anchor or at one of the
    ``further`` places. ``box`` are half width and half height (u), ``own`` are all points of what it names.
    """

    formula: Formula
    anchor: complex
    places: Places
    costs: Costs
    extent: tuple[complex, ...] = ()
    clear: float = 0.0
    vector: bool = False
    further: tuple[complex, ...] = ()
    box: tuple[float, float] = (0.0, 0.0)
    own: tuple[complex, ...] = ()

    def __post_init__(self) -> None:
        width, height = label_size(self.formula)
        self.box = (0.5 * width, 0.5 * height)
        self.own = (self.anchor, *self.extent)

    @property
    def arrow(self) -> tuple[complex, complex] | None:
        """Start and tip of the straight arrow that it names, if it names one."""
        return (self.extent[0], self.anchor) if self.vector else None


# Nearest to its line or symbol: the free space that a label never gives up and the side of a cell.
_OFF = 1.0
_WAYS = np.exp(1j * (math.tau * np.arange(16) / 16 + math.pi / 4))
_RINGS = np.array([0.0, 1.2, 2.6, 4.4])
_AROUND_COSTS = (
    np.array([0.0, 1.5, 4.0, 7.0])[:, None] + (0.3 * (np.arange(16) % 4 != 0) + 0.01 * np.arange(16))[None, :]
).ravel()
_FAR_WAYS = np.exp(1j * math.tau * np.arange(24) / 24)
_FAR_RINGS = np.array([4.0, 6.5, 9.0, 12.0, 16.0, 21.0])[:, None]
_FAR_COSTS = _FAR_RINGS + 0.01 * np.arange(24)
# A level leader that ends before a number reads as its minus sign.
_FAR_COSTS_OF_NUMBERS = _FAR_COSTS + np.where(_FAR_WAYS.real > math.cos(math.radians(20)), 15.0, 0.0)
_AS_SHAFT, _NEARLY_AHEAD = 15.0, math.cos(math.radians(20))  # a leader that goes on past a head reads as its shaft
_NOT_AT_ANCHOR = 2.0  # cost of a leader that ends at a further place
_ON_SHAFT = 0.5  # where such a place is on an arrow
_PARTS = np.array([0.5, 0.42, 0.58, 0.34, 0.66, 0.26, 0.74])
# Beside an arrow: distances, both sides of each part; before its head. The farthest are for want of any other place: a
# leader is better.
_ASIDE = np.array([_OFF, 3.5, 7.0])
_AHEAD = np.array([1.0, 2.5, 5.0, 8.0, 11.0])
# The same along the arrow for its length, for what the label takes aside and ahead of it, and without all that.
_BY_ARROW = np.concatenate(
    (
        [(part, side, 0.0, side * off) for off in _ASIDE for side in (1j, -1j) for part in _PARTS],
        [(1.0, 0.0, 1.0, off) for off in _AHEAD],
    )
)
_ARROW_COSTS = np.concatenate(
    (
        (
            np.array([0.0, 7.0, 35.0])[:, None, None]
            + np.array([0.0, 0.2])[None, :, None]
            + (10 * np.abs(_PARTS - 0.5) + 2 * np.abs(_PARTS - 0.6))[None, None, :]
        ).ravel(),
        [1.5, 3.0, 8.0, 40.0, 50.0],
    )
)
_ARC_PARTS = (0.5, 0.35, 0.65, 0.2, 0.8, 0.0, 1.0)
_OFF_MIDDLE = 4 * np.abs(np.array(_ARC_PARTS) - 0.5)
_ARC_RINGS = np.array([0.0, 1.1, 2.5, 4.3]) + _OFF
_ARC_COSTS = (np.array([0.0, 1.5, 3.0, 6.0])[None, :] + _OFF_MIDDLE[:, None]).ravel()


def _beyond(ways: Places) -> tuple[NDArray[np.float64], NDArray[np.float64]]:
    """How far one goes in each direction to get on by a unit along x and along y."""
    with np.errstate(divide="ignore"):
        return 1.0 / np.abs(ways.real), 1.0 / np.abs(ways.imag)


_BEYOND, _FAR_BEYOND = _beyond(_WAYS), _beyond(_FAR_WAYS)


def _support(box: tuple[float, float], beyond: tuple[NDArray[np.float64], NDArray[np.float64]]) -> NDArray[np.float64]:
    """How far the centre of a box must be from a point that it touches in each direction (u)."""
    result: NDArray[np.float64] = np.minimum(box[0] * beyond[0], box[1] * beyond[1])
    return result


def around(formula: Formula, point: complex, clear: float) -> LabelRequest:
    """Candidates around a point, whose symbol has the radius ``clear`` (u)."""
    return LabelRequest(formula, point, point + _offsets(formula, clear), _AROUND_COSTS, clear=clear)


@lru_cache(maxsize=1000)
def _offsets(formula: Formula, clear: float) -> Places:
    """From a point to the candidates around it."""
    width, height = label_size(formula)
    support = _support((0.5 * width, 0.5 * height), _BEYOND)
    found: Places = (_WAYS[None, :] * (clear + _OFF + _RINGS[:, None] + support[None, :])).ravel()
    return found


def far_from(request: LabelRequest) -> tuple[Places, Costs, Places]:
    """Candidates far from what is named, which need a leader, their costs, and where it ends: shape (P,) each."""
    ends = np.array([request.anchor, *request.further])
    steps = _FAR_WAYS * (request.clear + _FAR_RINGS + _support(request.box, _FAR_BEYOND))
    own = _FAR_COSTS_OF_NUMBERS if isinstance(request.formula, Number | Measured) else _FAR_COSTS
    costs = np.array([own] * len(ends))
    costs[1:] += _NOT_AT_ANCHOR
    if request.arrow is not None:
        start, tip = request.arrow
        ahead = (_FAR_WAYS * (tip - start).conjugate()).real / abs(tip - start)
        costs[0] += _AS_SHAFT * (ahead > _NEARLY_AHEAD)
        costs[1:] += _AS_SHAFT * (np.abs(ahead) > _NEARLY_AHEAD)
    places = ends[:, None, None] + steps
    return places.ravel(), costs.ravel(), ends.repeat(steps.size)


def along_line(formula: Formula, start: complex, end: complex, clear: float = _OFF) -> LabelRequest:
    """Candidates on both sides of a line, best near its middle."""
    width, height = label_size(formula)
    normal = 1j * (end - start) / abs(end - start)
    support = clear + 0.5 * (width * abs(normal.real) + height * abs(normal.imag))
    middle = start + _PARTS * (end - start)
    costs = 10 * np.abs(_PARTS - 0.5)
    places = np.concatenate((middle + support * normal, middle - support * normal))
    extent = (start + 0.25 * (end - start), start + 0.75 * (end - start))
    return LabelRequest(formula, 0.5 * (start + end), places, np.concatenate((costs, costs + 0.2)), extent)


def along_radius(formula: Formula, centre: complex, rim: complex, start: complex) -> LabelRequest:
    """Candidates beside a radius from ``start`` on, and before its head outside the rim."""
    beside = along_line(formula, start, rim)
    way = (rim - centre) / abs(rim - centre)
    half_width, half_height = beside.box
    support = half_width * abs(way.real) + half_height * abs(way.imag)
    ahead = rim + way * (np.array([_OFF, 2.4]) + support)
    places = np.concatenate((beside.places, ahead))
    return LabelRequest(formula, rim, places, np.concatenate((beside.costs, [3.0, 5.0])), (0.5 * (start + rim),))


def along_arrow(formula: Formula, start: complex, end: complex) -> LabelRequest:
    """Candidates beside an arrow, best near its head, and before its head; less good ones farther aside."""
    width, height = label_size(formula)
    step = end - start
    way = step / abs(step)
    x, y = abs(way.real), abs(way.imag)
    aside, ahead = 0.5 * (width * y + height * x), 0.5 * (width * x + height * y)
    places: Places = start + way * (_BY_ARROW @ np.array([abs(step), aside, ahead, 1.0], dtype=complex))
    extent = tuple(start + part * step for part in (0.0, 0.25, 0.5, 0.75))
    return LabelRequest(formula, end, places, _ARROW_COSTS, extent, vector=True, further=(start + _ON_SHAFT * step,))


def along_arc(
    formula: Formula, centre: complex, radius: float, start: float, sweep: float, inner: bool = False
) -> LabelRequest:
    """Candidates outside an arc, best at its middle; with ``inner`` also inside a wide one."""
    width, height = label_size(formula)
    ways = [cmath.rect(1.0, start + part * sweep) for part in _ARC_PARTS]
    supports = [[0.5 * (width * abs(way.real) + height * abs(way.imag))] for way in ways]
    directions: Places = np.array(ways)
    places: Places = centre + directions[:, None] * (radius + _ARC_RINGS + supports)
    middle = centre + radius * ways[0]
    extent = tuple(centre + cmath.rect(radius, start + part * sweep) for part in (0.0, 0.25, 0.75, 1.0))
    found, costs = places.ravel(), _ARC_COSTS
    if inner and abs(sweep) > _WIDE:
        found = np.concatenate((found, centre + 0.6 * radius * directions))
        costs = np.concatenate((costs, 2.5 + _OFF_MIDDLE))
    return LabelRequest(formula, middle, found, costs, extent)
