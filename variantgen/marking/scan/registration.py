"""Where the page for answers lies in a picture: its code, its four corner marks, the map from millimetres to pixels.

The QR code says which page it is, and about where and how large it is. From there the black squares in the corners are
looked for; the four of them give the perspective. With three a map can be had too, but where a page is seen at a slant
it is off by more than a bubble at the fourth corner, and nothing says so.
"""

from __future__ import annotations

from typing import Any

import numpy as np
from msgspec import Struct
from numpy.typing import NDArray

from variantgen.exam import answer_page as page
from variantgen.marking.scan.pictures import Grey

Points = NDArray[np.float64]

_RADIUS = (18.0, 26.0, 40.0)  # mm, within which a corner mark is looked for: the near one, its neighbour, the far ones
_DARK = 0.62  # of the white around: what is less may be a mark
_SIZES = (0.55, 1.6)  # of a mark, as shares of the area it should have
_SOLID, _LONGEST = 0.86, 1.8  # how much of its outline it fills; how much longer than wide perspective makes it
_FINE = 2.4  # pixels to the millimetre that marks are looked for with


class Code(Struct, frozen=True):
    """A QR code of a picture: its text, and its corners in pixels, an array of shape (4, 2), the upper left first."""

    text: str
    corners: Points


class Placed(Struct, frozen=True):
    """How a page lies in a picture: ``matrix`` maps (x, y, 1) in mm to pixels, an array of shape (3, 3)."""

    matrix: Points

    def pixels(self, x: Points, y: Points) -> tuple[Points, Points]:
        """Pixels of places in mm, arrays of any shape."""
        m = self.matrix
        w = m[2, 0] * x + m[2, 1] * y + m[2, 2]
        return (m[0, 0] * x + m[0, 1] * y + m[0, 2]) / w, (m[1, 0] * x + m[1, 1] * y + m[1, 2]) / w


def codes(grey: Grey) -> list[Code]:
    """The QR codes of a picture."""
    import zxingcpp

    kind: Any = zxingcpp.BarcodeFormat.QRCode
    found = zxingcpp.read_barcodes(grey, formats=kind, try_invert=False)
    return [Code(one.text, _corners(one.position)) for one in found if one.valid]


def _corners(position: object) -> Points:
    names = ("top_left", "top_right", "bottom_right", "bottom_left")
    return np.array([[getattr(position, name).x, getattr(position, name).y] for name in names], dtype=np.float64)


def placed(grey: Grey, code: Code) -> Placed | None:
    """How the page of a code lies in a picture; None where a corner mark is not seen."""
    x, y = page.CODE
    side = page.CODE_WIDTH
    known = [np.array([x, y]), np.array([x + side, y]), np.array([x + side, y + side]), np.array([x, y + side])]
    seen = list(code.corners)
    marks: dict[int, Points] = {}
    for number, radius in zip((1, 0, 2, 3), (*_RADIUS, _RADIUS[-1]), strict=True):
        corner = np.array(page.CORNERS[number])
        guess, scale = _guess(known, seen, marks, corner)
        found = _mark(grey, guess, scale, radius)
        if found is None:
            return None
        marks[number] = found
    places = np.array([page.CORNERS[number] for number in marks])
    pixels = np.array(list(marks.values()))
    return Placed(_perspective(places, pixels))


def _guess(known: list[Points], seen: list[Points], marks: dict[int, Points], corner: Points) -> tuple[Points, float]:
    """Where a corner mark should be, and how many pixels a millimetre has there.

    With two marks known, the code matters no more: it is small, and what it says of far places is vague.
    """
    if len(marks) >= 3:
        matrix = _affine(np.array([page.CORNERS[k] for k in marks]), np.array(list(marks.values())))
    elif len(marks) == 2:
        matrix = _similar(np.array([page.CORNERS[k] for k in marks]), np.array(list(marks.values())))
    else:
        own = [np.array(page.CORNERS[k]) for k in marks]
        matrix = _similar(np.array([*known, *own]), np.array([*seen, *marks.values()]))
    at: Points = matrix[:2, :2] @ corner + matrix[:2, 2]
    return at, float(np.sqrt(abs(np.linalg.det(matrix[:2, :2]))))


def _mark(grey: Grey, guess: Points, scale: float, radius: float) -> Points | None:
    """The middle of the black square next to a place, in pixels; None where there is none."""
    from scipy import ndimage  # half a second of time: only where there are scans

    height, width = grey.shape
    reach_ = radius * scale
    left, right = int(max(guess[0] - reach_, 0)), int(min(guess[0] + reach_, width))
    top, bottom = int(max(guess[1] - reach_, 0)), int(min(guess[1] + reach_, height))
    step = max(1, int(scale / _FINE))
    levels = grey[top:bottom, left:right]
    rows, columns = levels.shape[0] // step * step, levels.shape[1] // step * step
    if min(rows, columns) < 8 * step:
        return None
    shares = [levels[i:rows:step, j:columns:step].astype(np.float32) for i in range(step) for j in range(step)]
    window = sum(shares[1:], start=shares[0]) / step**2
    fine = scale / step
    white = ndimage.maximum_filter(ndimage.uniform_filter(window, 3), int(2.5 * page.CORNER_SIDE * fine))
    dark = window < _DARK * white
    labels, count = ndimage.label(dark)
    if not count:
        return None
    wanted = (page.CORNER_SIDE * fine) ** 2
    areas = np.bincount(labels.ravel())
    best, nearest = None, np.inf
    for label, box in enumerate(ndimage.find_objects(labels), start=1):
        if not _SIZES[0] * wanted <= areas[label] <= _SIZES[1] * wanted:
            continue
        inside = labels[box] == label
        y, x = np.nonzero(inside)
        spread = np.linalg.eigvalsh(np.cov(np.array([x, y])))
        if spread[0] <= 0 or spread[1] > _LONGEST**2 * spread[0]:
            continue
        if areas[label] < _SOLID * 12.0 * np.sqrt(spread[0] * spread[1]):
            continue
        weights = (white[box] - window[box]) * inside
        across, down = weights.sum(axis=0), weights.sum(axis=1)
        middle = np.array([across @ np.arange(across.size), down @ np.arange(down.size)])
        middle = middle / weights.sum() + [box[1].start, box[0].start]
        at = np.array([left, top]) + step * middle + (step - 1) / 2
        distance = float(np.hypot(*(at - guess)))
        if distance < nearest:
            best, nearest = at, distance
    return best


def _similar(places: Points, pixels: Points) -> Points:
    """The turn, scale and shift that brings places nearest to pixels, as a matrix of shape (3, 3)."""
    z, w = places @ [1, 1j], pixels @ [1, 1j]
    middle, end = z.mean(), w.mean()
    factor = ((w - end) * np.conj(z - middle)).sum() / (np.abs(z - middle) ** 2).sum()
    shift = end - factor * middle
    return np.array([[factor.real, -factor.imag, shift.real], [factor.imag, factor.real, shift.imag], [0.0, 0.0, 1.0]])


def _affine(places: Points, pixels: Points) -> Points:
    """The affine map of three places, as a matrix of shape (3, 3)."""
    rows = np.column_stack([places, np.ones(len(places))])
    return np.vstack([np.linalg.solve(rows, pixels).T, [0.0, 0.0, 1.0]])


def _perspective(places: Points, pixels: Points) -> Points:
    """The projective map of four places, as a matrix of shape (3, 3)."""
    rows, right = [], []
    for (x, y), (u, v) in zip(places, pixels, strict=True):
        rows += [[x, y, 1, 0, 0, 0, -u * x, -u * y], [0, 0, 0, x, y, 1, -v * x, -v * y]]
        right += [u, v]
    return np.append(np.linalg.solve(np.array(rows), np.array(right)), 1.0).reshape(3, 3)
