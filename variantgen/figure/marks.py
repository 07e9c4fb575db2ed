"""Marks of given data: angles with arcs and reference lines, dimension lines, radii."""

from __future__ import annotations

import cmath
import math
from collections.abc import Sequence

import numpy as np
from numpy.typing import NDArray

from variantgen.families.figure_hints import AngleMark, DiscMark, LengthMark, RightAngle
from variantgen.families.hints import DIRECTIONS
from variantgen.figure.board import Board
from variantgen.figure.drawing import THIN, Arc, Layer
from variantgen.figure.placement.choices import GAP
from variantgen.figure.placement.label_requests import LabelRequest, along_arc, along_line, along_radius, label_size
from variantgen.figure.symbols.gears import contour
from variantgen.figure.symbols.guide import ground_side
from variantgen.mechanism.joints.guide import Guide
from variantgen.wording.formula import Symbol

_OFF_RIM = 3.5  # between an arc and the rim of a disc, u
_HALF_WAY = 0.45  # to a rim an arc is drawn about its centre
_ROOMY = 9.0  # radius of a disc that has room for a name inside, u
_LEAST_RING = 5.0  # width of a ring in which a letter finds room, u
_NEARLY = math.radians(5)  # between a radius and a line that it nearly crosses
_CROSSED, _NEAR = 12.0, 3.5  # costs of lines that a radius crosses or nearly crosses, for each u of their weights
_RADII_APART = math.radians(25)
_ALONG = 1e-6  # cosine of the angle of a ray that is along a guide with the normal of that
_ARC, _REFERENCE, _HEAD = 8.0, 13.0, 1.9
_BEYOND_GROUND = 11.0  # radius of an arc that ends beyond the ground of a slider, u
_SHIFTS = np.array([7.5, 10.0, 13.0, 16.0, 20.0, 25.0, 30.0, 36.0, 42.0])  # of a dimension line, u
_LANE = 25  # places along a dimension line that are looked at
_SQUARE = 3.2  # side of the mark of a right angle: seen beside a hinge circle
# Directions of a radius: those at half a right angle read best, above rather than below.
_FINALISTS = 8
_DIRECTIONS = np.radians(np.arange(0, 360, 15))
_DIRECTION_COSTS = 0.3 * np.abs(np.cos(2 * _DIRECTIONS)) + 0.2 * (1 - np.sin(_DIRECTIONS)) + 0.001 * np.arange(24)


def draw_angle(board: Board, mark: AngleMark) -> None:
    """An arc between two rays; a ray that no link carries is drawn as a thin line."""
    sketch = board.sketch
    corner = sketch.at[mark.at]
    rays = [_ray(board, mark.at, name) for name in (mark.start, mark.end)]
    hatched, opposite = _is_hatched(board, mark.at, rays), [-ray for ray in rays]
    turned = hatched and not _has_link(board, mark.at, opposite)
    rays = opposite if turned else rays
    for name, ray in zip((mark.start, mark.end), rays, strict=True):
        if not sketch.is_taken(mark.at, ray, math.radians(2)):
            leads = name in sketch.at and not turned
            far = sketch.at[name] if leads else corner + _REFERENCE * ray
            sketch.path((corner, far), Layer.GROUND, THIN)
            if leads:
                sketch.occupy(name, corner - far)
    start, sweep = cmath.phase(rays[0]), cmath.phase(rays[1] / rays[0])
    radius = _clear_of_rims(board, corner, _ARC if abs(sweep) > math.radians(25) else 1.4 * _ARC)
    radius = max(radius, _BEYOND_GROUND) if hatched and not turned else radius
    sketch.arc(Arc(corner, radius, Layer.MARK, THIN, start, sweep))
    sketch.label(along_arc(board.symbol(mark.name), corner, radius, start, sweep, inner=True))
    for part in (0.0, 0.25, 0.5, 0.75, 1.0):
        sketch.busy.setdefault(mark.at, []).append(start + part * sweep)


def _is_hatched(board: Board, point: str, rays: Sequence[complex]) -> bool:
    """Whether an angle with the line of a slider is on the side of its ground."""
    joint = next((j for j in board.scene.joints if isinstance(j, Guide) and j.point == point), None)
    if joint is None or point in (*board.form.figure.bare, *board.form.figure.stems):
        return False
    side = ground_side(board, joint)
    along = any(abs((ray * side.conjugate()).real) < _ALONG for ray in rays)
    return along and (_middle(rays) * side.conjugate()).real > 0


def _middle(rays: Sequence[complex]) -> complex:
    """The direction half way between two rays."""
    return rays[0] * cmath.sqrt(rays[1] / rays[0])


def _has_link(board: Board, point: str, rays: Sequence[complex]) -> bool:
    """Whether a link leaves a point between two rays."""
    half = 0.5 * abs(cmath.phase(rays[1] / rays[0]))
    return any(abs(cmath.phase(link / _middle(rays))) < half for link in board.links_at(point))


def draw_right_angle(board: Board, mark: RightAngle) -> None:
    """A small square between two rays at right angles."""
    corner = board.sketch.at[mark.at]
    first, second = (_SQUARE * _ray(board, mark.at, name) for name in (mark.start, mark.end))
    board.sketch.path((corner + first, corner + first + second, corner + second), Layer.MARK, THIN)
    board.sketch.occupy(mark.at, first + second)


def _clear_of_rims(board: Board, corner: complex, radius: float) -> float:
    """The radius of an arc, changed where it would run along the rim of a disc about the same point."""
    for disc in board.form.figure.discs:
        if abs(board.sketch.at[disc.centre] - corner) > 1e-6:
            continue
        for rim in board.discs.get(disc.body, []):
            if rim > radius + 2 * _OFF_RIM:
                continue
            # Half way to the rim, so that the letter finds room between arc and rim; outside a tiny disc.
            return _HALF_WAY * contour(board, disc.centre, rim) if rim > _ARC else rim + _OFF_RIM
    return radius


def _ray(board: Board, corner: str, name: str) -> complex:
    if name in DIRECTIONS:
        return complex(board.frame.place(DIRECTIONS[name]))
    step = board.sketch.at[name] - board.sketch.at[corner]
    return step / abs(step)


def draw_length(board: Board, mark: LengthMark) -> None:
    """A dimension line between two points, moved aside from the mechanism, with extension lines."""
    sketch = board.sketch
    start, end = sketch.at[mark.start], sketch.at[mark.end]
    way = (end - start) / abs(end - start)
    shift = _roomiest_shift(board, start, end)
    aside = shift / abs(shift)
    for point in (start, end):
        sketch.path((point + 0.2 * shift, point + shift + 1.5 * aside), Layer.GROUND, THIN)
    # The line of motion is extended to the dimension.
    hidden = [name for name in (mark.start, mark.end) if name in board.form.figure.hidden]
    for name in hidden:
        partner = min(
            (p for p in board.shown if _level(board, p, name, way)),
            key=lambda p: abs(sketch.at[p] - sketch.at[name]),
            default=None,
        )
        if partner is not None:
            sketch.path((sketch.at[name] + 0.2 * shift, sketch.at[partner]), Layer.GROUND, THIN, dash="dashdot")
    _dimension(board, start + shift, end + shift, mark.name)


def _roomiest_shift(board: Board, start: complex, end: complex) -> complex:
    """How far aside a dimension line crosses least of what is drawn; near, and on the side away from the mechanism."""
    sketch = board.sketch
    way = (end - start) / abs(end - start)
    seen = [sketch.at[name] for name in board.shown]
    middle = sum(seen) / len(seen)
    outward = 1j * way if ((middle - start) * (1j * way).conjugate()).real < 0 else -1j * way
    shifts = np.concatenate((_SHIFTS * outward, -_SHIFTS * outward))
    along = start + np.linspace(0.0, 1.0, _LANE) * (end - start)
    lanes = (along[None, :] + shifts[:, None]).ravel()
    met = sketch.crossings(lanes, (1.5, 1.5)) > 0
    for body in board.form.figure.plates:
        met |= _inside([sketch.at[name] for name in board.form.bodies[body]], lanes)
    crossed = np.sum(met.reshape(len(shifts), -1), axis=1)
    inward = np.repeat((0.0, 2.5), len(_SHIFTS))
    return complex(shifts[int(np.argmin(5.0 * crossed + 0.22 * np.abs(shifts) + inward))])


def _inside(corners: Sequence[complex], places: NDArray[np.complex128]) -> NDArray[np.bool_]:
    """Which places lie in a polygon: a ray to the right crosses its sides an odd number of times."""
    inside = np.zeros(len(places), dtype=bool)
    for a, b in zip(corners, [*corners[1:], corners[0]], strict=True):
        if a.imag != b.imag:
            over = (places.imag < a.imag) != (places.imag < b.imag)
            inside ^= over & (places.real < a.real + (places.imag - a.imag) * (b.real - a.real) / (b.imag - a.imag))
    return inside


def _level(board: Board, point: str, name: str, way: complex) -> bool:
    step = board.sketch.at[point] - board.sketch.at[name]
    return abs(step) > 1 and abs((step * way.conjugate()).real) < 0.05


def _dimension(board: Board, start: complex, end: complex, name: str) -> None:
    sketch = board.sketch
    way = (end - start) / abs(end - start)
    if abs(end - start) > 4 * _HEAD:
        middle = (start + end) / 2
        sketch.arrow(middle, end, Layer.MARK, THIN, _HEAD)
        sketch.arrow(middle, start, Layer.MARK, THIN, _HEAD)
    else:
        sketch.arrow(end + 3 * _HEAD * way, end, Layer.MARK, THIN, _HEAD)
        sketch.arrow(start - 3 * _HEAD * way, start, Layer.MARK, THIN, _HEAD)
    sketch.label(along_line(board.symbol(name), start, end))


def draw_radius(board: Board, mark: DiscMark, radius: float, concentric: Sequence[float]) -> None:
    """A radius from the centre to the rim, with its letter, where there is room.

    ``concentric`` are the radii (u) of all discs about this centre.
    """
    sketch = board.sketch
    if mark.arc:
        _draw_radius_of_arc(board, mark, radius)
        return
    centre = sketch.at[mark.centre]
    # Of concentric discs the letter of the larger stands in the ring that is its own.
    inner = max((other for other in concentric if other < radius - 0.1), default=0.0)
    begin = inner if radius - inner > _LEAST_RING else 0.0
    formula = board.symbol(mark.name)
    way = cmath.rect(1.0, _roomiest_radius(board, mark.centre, radius, begin, label_size(formula)))
    rim = centre + radius * way
    sketch.arrow(centre, rim, Layer.MARK, THIN, _HEAD)
    sketch.label(along_radius(formula, centre, rim, centre + begin * way))
    for turn in (-_RADII_APART, 0.0, _RADII_APART):
        sketch.occupy(mark.centre, way * cmath.rect(1.0, turn))


def _roomiest_radius(board: Board, point: str, radius: float, begin: float, letters: tuple[float, float]) -> float:
    """The direction in which a radius and its letter cross least of what is drawn, far from what leaves the centre."""
    sketch = board.sketch
    centre = sketch.at[point]
    ways = np.exp(1j * _DIRECTIONS)
    room = np.maximum(0.0, math.radians(30) - sketch.freedom(point, _DIRECTIONS))
    costs = _lines_on_rays(board, centre, _DIRECTIONS, radius - 0.3) + 8 * room + _DIRECTION_COSTS
    # What the letter would cover is asked only of the directions that are best without it.
    finalists = np.argsort(costs, kind="stable")[:_FINALISTS]
    ways, costs = ways[finalists], costs[finalists]
    half_width, half_height = 0.5 * letters[0], 0.5 * letters[1]
    support = 1.0 + half_width * np.abs(ways.imag) + half_height * np.abs(ways.real)
    beside = [centre + (0.5 * (begin + radius) + side * 1j * support) * ways for side in (1, -1)]
    ahead = centre + (radius + 1.0 + half_width * np.abs(ways.real) + half_height * np.abs(ways.imag)) * ways
    covered = sketch.crossings(np.concatenate((*beside, ahead)), (half_width + GAP, half_height + GAP))
    best = np.min(np.minimum(covered.reshape(3, -1), 4) + np.array([[0.0], [0.0], [0.6]]), axis=0)
    return float(_DIRECTIONS[finalists[int(np.argmin(costs + 2 * best))]])


def _lines_on_rays(board: Board, centre: complex, angles: NDArray[np.float64], end: float) -> NDArray[np.float64]:
    """Cost of the lines that rays from a centre cross before a distance, or nearly cross (a rim beside one)."""
    rays = np.concatenate((angles, angles - _NEARLY, angles + _NEARLY))
    crossed, *beside = board.sketch.obstacles.weight_on_rays(centre, rays, 0.0, end).reshape(3, -1)
    total: NDArray[np.float64] = _CROSSED * crossed + _NEAR * np.maximum(*beside)
    return total


def _draw_radius_of_arc(board: Board, mark: DiscMark, radius: float) -> None:
    """The radius of an arc: from its centre to the place of the arc where it crosses least, beside the mechanism."""
    sketch = board.sketch
    centre = sketch.at[mark.centre]
    arcs = [line for line in sketch.lines if isinstance(line, Arc) and line.layer == Layer.GROUND]
    arc = min(arcs, key=lambda line: abs(line.centre - centre) + abs(line.radius - radius))
    angles = arc.start + arc.sweep * np.linspace(0.06, 0.94, 45)
    ways = np.exp(1j * angles)
    formula = board.symbol(mark.name)
    half_width, half_height = (0.5 * side + GAP for side in label_size(formula))
    aside = 1.0 + half_width * np.abs(ways.imag) + half_height * np.abs(ways.real)
    letters = np.array(
        [centre + (part * radius + side * 1j * aside) * ways for part in (0.4, 0.5, 0.6) for side in (1, -1)]
    )
    covered = sketch.crossings(letters.ravel(), (half_width, half_height)).reshape(len(letters), -1)
    room = np.maximum(0.0, math.radians(20) - sketch.freedom(mark.centre, angles))
    costs = _lines_on_rays(board, centre, angles, radius - 1.5) + 8 * room + 2 * np.minimum(np.min(covered, axis=0), 4)
    rim = centre + radius * complex(ways[int(np.argmin(costs))])
    sketch.arrow(centre, rim, Layer.MARK, THIN, _HEAD)
    sketch.label(along_radius(formula, centre, rim, centre))
    sketch.occupy(mark.centre, rim - centre)


def draw_disc_name(board: Board, mark: DiscMark, radius: float) -> None:
    """The name of a disc (the number of a gear) inside it near its rim, or outside a small one."""
    first = next(disc for disc in board.form.figure.discs if disc.body == mark.body or disc is mark)
    name = mark.label or (board.form.symbols.get(mark.body, "") if mark.body and first is mark else "")
    if not name:
        return
    formula = Symbol(name)
    width, height = label_size(formula)
    half = 0.5 * math.hypot(width, height)
    inner, outer = sorted((radius, contour(board, mark.centre, radius)))
    inside = [inner - half - off for off in (0.9, 2.4, 4.2, 6.5) if inner - half - off > half]
    outside = [outer + half + 0.7, outer + half + 2.0]
    distances = [*inside, *outside] if radius > _ROOMY else [*outside, *inside]
    ways = np.exp(1j * math.tau / 24 * np.arange(24))
    centre = board.sketch.at[mark.centre]
    places = centre + np.array(distances)[:, None] * ways[None, :]
    costs = 1.5 * np.arange(len(distances))[:, None] + np.linspace(0.0, 0.3, 24)[None, :]
    edge = tuple(complex(place) for place in centre + radius * ways[::4])
    board.sketch.label(LabelRequest(formula, edge[0], places.ravel(), costs.ravel(), edge[1:]))
