"""How dark the bubbles of a page are, compared with the paper around them and with empty bubbles of the same page.

Darkness is 1 - I/W for a grey level I and that of the white paper W close by: shadows do not change it. The darkness of
a bubble counts without what is printed in it, which empty bubbles of the page show.
"""

from __future__ import annotations

from functools import cache

import numpy as np
from msgspec import Struct
from numpy.typing import NDArray

from variantgen.exam import answer_page as page
from variantgen.marking.scan.pictures import Grey
from variantgen.marking.scan.registration import Placed

Array = NDArray[np.float64]

_GRID = 0.26  # mm between the points that are looked at
_INSET = 0.38  # of what counts as inside, from the edge of a bubble: its outline may lie a little beside
_SHIFTS = np.arange(-0.6, 0.61, 0.2)  # mm, by which a block may lie beside where the corners say
# Where strokes that cross a bubble out leave it: mm beyond its edge, degrees from the line across.
_BESIDE, _SLOPES = 0.85, np.arange(30.0, 61.0, 6.0)
_LABELS = 0.05  # by how much the print in bubbles may differ from digit to digit


class Darkness(Struct, frozen=True):
    """What was measured of the blocks of a page: arrays of shape (blocks, bubbles) and (blocks, boxes).

    ``bubbles`` is the darkness beyond that of empty ones, ``boxes`` that of the boxes to write in; ``beside`` is that
    of the paper beyond the four corners of each bubble, a last axis more; ``noise`` is how much empty bubbles scatter,
    ``outlines`` how much darker than their surroundings outlines are, by block.
    """

    bubbles: Array
    beside: Array
    boxes: Array
    noise: float
    outlines: Array


def darkness(grey: Grey, where: Placed, blocks: int) -> Darkness:
    """Measure the first blocks of a page."""
    corners = np.array([page.block_corner(place) for place in range(blocks)])
    at = corners[:, None, :] + _centres()[None, :, :]
    shift, outlines = _shifts(grey, where, at)
    at = at + shift[:, None, :]
    white = _white(grey, where, at)
    inside = _ink(grey, where, at, _inside(), white)
    beside = np.clip(1.0 - _levels(grey, where, at, _corners()) / white[..., None], 0.0, 1.0)
    beside = beside.reshape(*inside.shape, 4, len(_SLOPES)).max(axis=-1)
    boxes = corners[:, None, :] + shift[:, None, :] + _box_centres()[None, :, :]
    levels = _levels(grey, where, boxes, _in_box())
    paper = np.maximum(np.percentile(levels, 80, axis=-1), 20.0)  # shadows may fall between a box and its bubbles
    written = np.clip(1.0 - levels / paper[..., None], 0.0, 1.0).mean(axis=-1)
    beyond = inside - _empty(inside)
    low = beyond[beyond <= np.median(beyond)]
    noise = 1.4826 * float(np.median(np.abs(low - np.median(beyond)))) if low.size else 0.0
    return Darkness(beyond, beside, written - np.percentile(written, 15), max(noise, 0.004), outlines)


@cache
def _centres() -> Array:
    return np.array([(bubble.x, bubble.y) for bubble in page.BUBBLES])


@cache
def _box_centres() -> Array:
    middle = page.BOX_TOP + page.BOX_HEIGHT / 2
    return np.array([(page.column_x(k), middle) for k in range(page.DIGITS + 1)])


@cache
def _neighbours() -> NDArray[np.intp]:
    """The places of each bubble and of those next to it, an array of shape (bubbles, 7)."""
    far = np.linalg.norm(_centres()[:, None] - _centres()[None], axis=-1)
    return np.argsort(far, axis=1)[:, :7]


def _stadium(inset: float) -> Array:
    """Points of a bubble without its edge, an array of shape (points, 2)."""
    radius = page.RADIUS - inset
    steps = np.arange(-20, 21) * _GRID
    x, y = np.meshgrid(steps, steps)
    off = np.maximum(np.abs(x) - page.LENGTH / 2, 0.0)
    chosen = off**2 + y**2 <= radius**2
    return np.column_stack([x[chosen], y[chosen]])


@cache
def _inside() -> Array:
    return _stadium(_INSET)


@cache
def _in_box() -> Array:
    half_width, half_height = (page.PITCH - 0.5) / 2 - 0.7, page.BOX_HEIGHT / 2 - 0.7
    x, y = np.meshgrid(np.arange(-half_width, half_width, 0.3), np.arange(-half_height, half_height, 0.3))
    return np.column_stack([x.ravel(), y.ravel()])


@cache
def _around() -> Array:
    """Points between bubbles, where paper is white."""
    x, y = page.PITCH / 2, page.ROW / 2
    return np.array([(a * x, b * y) for a in (-1.0, -0.85, 0.85, 1.0) for b in (-1.0, 0.0, 1.0) if b or abs(a) == 1.0])


def _rim(beyond: float, degrees: Array) -> Array:
    """Points around a bubble, so far beyond its edge, in some directions."""
    turns = np.radians(degrees)
    x, y = (page.RADIUS + beyond) * np.cos(turns), (page.RADIUS + beyond) * np.sin(turns)
    return np.column_stack([x + np.sign(x) * page.LENGTH / 2, y])


@cache
def _corners() -> Array:
    """Points beyond the four corners of a bubble, corner by corner."""
    return _rim(_BESIDE, np.concatenate([_SLOPES, 180.0 - _SLOPES, 180.0 + _SLOPES, -_SLOPES]))


@cache
def _rims() -> Array:
    """Points along the outline of a bubble, and as many a little outside."""
    around = np.arange(22.5, 360.0, 45.0)
    return np.concatenate([_rim(-0.1, around), _rim(0.36, around)])


def _levels(grey: Grey, where: Placed, at: Array, points: Array) -> NDArray[np.float32]:
    """Grey levels at points around centres: an array of the shape of the centres and, last, of the points."""
    x, y = where.pixels(at[..., 0], at[..., 1])
    right = where.pixels(at[..., 0] + 1.0, at[..., 1])
    down = where.pixels(at[..., 0], at[..., 1] + 1.0)
    px, py = points[:, 0], points[:, 1]
    u = x[..., None] + (right[0] - x)[..., None] * px + (down[0] - x)[..., None] * py
    v = y[..., None] + (right[1] - y)[..., None] * px + (down[1] - y)[..., None] * py
    rows = np.clip((v + 0.5).astype(np.int32), 0, grey.shape[0] - 1)
    columns = np.clip((u + 0.5).astype(np.int32), 0, grey.shape[1] - 1)
    return grey[rows, columns].astype(np.float32)


def _white(grey: Grey, where: Placed, at: Array) -> Array:
    """The white of the paper at each bubble, an array of the shape of the bubbles."""
    levels = _levels(grey, where, at, _around())
    own = np.sort(levels, axis=-1)[..., -3]
    found: Array = np.median(own[..., _neighbours()], axis=-1).astype(np.float64)  # strokes cover some of the points
    return np.maximum(found, 20.0)


def _ink(grey: Grey, where: Placed, at: Array, points: Array, white: Array) -> Array:
    """The mean darkness at points around centres."""
    levels = _levels(grey, where, at, points)
    found: Array = np.clip(1.0 - levels / white[..., None], 0.0, 1.0).mean(axis=-1).astype(np.float64)
    return found


def _empty(inside: Array) -> Array:
    """The darkness of empty bubbles, by what is printed in them: an array of the shape (bubbles).

    Most bubbles of a digit are empty, but on a page with few answers, which all may have the same digit.
    """
    found = np.empty(len(page.BUBBLES))
    usual = float(np.median(inside))
    for kind in {_kind(bubble) for bubble in page.BUBBLES}:
        own = [k for k, bubble in enumerate(page.BUBBLES) if _kind(bubble) == kind]
        found[own] = min(float(np.percentile(inside[:, own], 40)), usual + _LABELS)
    return found


def _kind(bubble: page.Bubble) -> int:
    """What bubbles are printed alike."""
    return bubble.value if bubble.column not in (page.MINUS, page.POINT) else -bubble.column - 1


def _shifts(grey: Grey, where: Placed, at: Array) -> tuple[Array, Array]:
    """By how much each block lies beside its place, and how well its outlines are seen there.

    Outlines are darker than what is close outside them; bubbles that are filled in are no worse for that. First the
    best shift across is taken, then with it the best one down, and across once more.
    """
    some = at[:, ::4, :]
    found = np.zeros((len(at), 2))
    best = np.full(len(at), -np.inf)
    for axis in (0, 1, 0):
        tried = np.repeat(found[None], len(_SHIFTS), axis=0)
        tried[:, :, axis] = _SHIFTS[:, None]
        moved = (some[None] + tried[:, :, None, :]).reshape(-1, some.shape[1], 2)
        levels = _levels(grey, where, moved, _rims())
        half = len(_rims()) // 2
        contrast = levels[..., half:].mean(-1) - levels[..., :half].mean(-1)
        score = np.median(contrast, axis=1).reshape(len(_SHIFTS), -1) - 2.0 * np.abs(_SHIFTS)[:, None]
        chosen = score.argmax(axis=0)
        found[:, axis], best = _SHIFTS[chosen], score.max(axis=0)
    return found, best
