"""Pages for answers as a class hands them in: a renderer of marks, and one of scanners and phones.

It knows the places of bubbles (:mod:`variantgen.exam.answer_page`) and nothing of how they are read.
"""

from __future__ import annotations

import io
from collections.abc import Sequence
from dataclasses import dataclass

import numpy as np
from PIL import Image, ImageChops, ImageDraw, ImageFilter

from variantgen.exam import answer_page as page

Place = tuple[float, float]

DPI = 300
_MM = DPI / 25.4
# How somebody marks a bubble, and with what: the least and the greatest blackness.
STYLES = {
    "filled, pen": ("fill", 0.72, 0.95),
    "filled, pencil": ("fill", 0.42, 0.75),
    "faint pencil": ("fill", 0.2, 0.38),
    "crosses": ("cross", 0.7, 0.95),
    "strokes": ("stroke", 0.7, 0.95),
    "small fillings": ("small", 0.65, 0.95),
}
_SHARES = (0.36, 0.28, 0.12, 0.12, 0.06, 0.06)
SCANNERS = ("scanner", "copier", "phone")
_HIDDEN = {"scanner": 0.005, "copier": 0.005, "phone": 0.04}  # shares of pages with something on a corner
_SEGMENTS = {  # digits as strokes on a field of 2 x 4, as they are written into boxes
    "0": [(0, 0), (2, 0), (2, 4), (0, 4), (0, 0)],
    "1": [(0, 1), (1.4, 0), (1.4, 4)],
    "2": [(0, 0.6), (1, 0), (2, 0.8), (0, 4), (2, 4)],
    "3": [(0, 0), (2, 0), (0.8, 1.8), (2, 2.8), (0, 4)],
    "4": [(1.6, 4), (1.6, 0), (0, 2.6), (2, 2.6)],
    "5": [(2, 0), (0, 0), (0, 1.8), (2, 2.2), (1.8, 3.8), (0, 4)],
    "6": [(1.8, 0), (0, 2.4), (0.4, 4), (2, 3.6), (1.6, 2.2), (0, 2.6)],
    "7": [(0, 0), (2, 0), (0.8, 4)],
    "8": [(1, 2), (0, 1), (1, 0), (2, 1), (0, 3), (1, 4), (2, 3), (1, 2)],
    "9": [(2, 1), (1, 0), (0, 1), (1, 2), (2, 1), (1.4, 4)],
    "-": [(0, 2), (2, 2)],
}


@dataclass(frozen=True)
class Answered:
    """What a student means to answer: a number like ``-12.5``, or '' for nothing."""

    text: str


@dataclass(frozen=True)
class Filled:
    """A page as it comes from the scanner: JPEG, what was meant, by whom and how it was scanned.

    ``hidden`` is the corner that something lay on: its place in ``page.CORNERS``, None where all are seen.
    """

    jpeg: bytes
    texts: tuple[str, ...]
    style: str
    scanner: str
    hidden: int | None = None


class Hand:
    """Somebody who fills in pages, with a pen or a pencil."""

    def __init__(self, rng: np.random.Generator, style: str, size: tuple[int, int]) -> None:
        self.rng, (self.kind, low, high) = rng, STYLES[style]
        self.black = rng.uniform(low, high)
        self.erases = "pencil" in style
        self.width = rng.uniform(0.35, 0.6) if self.kind in ("cross", "stroke") else rng.uniform(0.4, 0.7)
        self.jitter = rng.uniform(0.08, 0.3)
        self.habit = rng.choice(["boxes", "some boxes", "no boxes"], p=[0.75, 0.1, 0.15])
        self.ink = Image.new("L", size, 0)
        self.draw = ImageDraw.Draw(self.ink)

    def line(self, points: Sequence[Place], black: float, width: float) -> None:
        """A line through points in mm."""
        own = [(x * _MM, y * _MM) for x, y in points]
        self.draw.line(own, fill=round(255 * black), width=max(1, round(width * _MM)), joint="curve")

    def near(self, x: float, y: float) -> Place:
        """A place about where it was meant."""
        return x + self.rng.normal(0, self.jitter), y + self.rng.normal(0, self.jitter)

    def mark(self, x: float, y: float) -> None:
        """Mark a bubble as this person does."""
        rng, black = self.rng, float(np.clip(self.black * self.rng.normal(1, 0.08), 0.12, 0.98))
        x, y = self.near(x, y)
        a, b = page.LENGTH / 2 + page.RADIUS, page.RADIUS
        if self.kind in ("fill", "small"):
            size = rng.uniform(0.8, 1.05) if self.kind == "fill" else rng.uniform(0.5, 0.68)
            a, b = a * size, b * size
            rows = np.arange(-b + 0.1, b, self.width * rng.uniform(0.6, 0.95))
            points = []
            for i, row in enumerate(rows):
                half = a * np.sqrt(max(1 - (row / b) ** 2, 0.05)) * rng.uniform(0.85, 1.08)
                points.append((x + (half if i % 2 else -half), y + row + rng.normal(0, 0.06)))
            self.line(points, black, self.width)
        elif self.kind == "cross":
            size = rng.uniform(0.75, 1.15)
            for sign in (1, -1):
                end = [self.near(x + s * size * a * 0.8, y + s * sign * size * b * 0.85) for s in (-1, 1)]
                self.line(end, black, self.width)
        else:
            lean = rng.uniform(-0.5, 0.5)
            for k in range(int(rng.integers(1, 3))):
                self.line([(x - a * 0.9, y + lean + 0.5 * k), (x + a * 0.9, y - lean + 0.5 * k)], black, self.width)

    def correct(self, x: float, y: float) -> None:
        """A bubble that was marked by mistake and is taken back."""
        box = tuple(round(v * _MM) for v in (x - 4, y - 4, x + 4, y + 4))
        before = self.ink.crop(box)
        self.mark(x, y)
        if self.erases:
            own = ImageChops.subtract(self.ink.crop(box), before)
            left = self.rng.uniform(0.04, 0.28)
            residue = own.filter(ImageFilter.GaussianBlur(0.25 * _MM)).point(lambda v: round(left * v))
            self.ink.paste(ImageChops.lighter(before, residue), box[:2])
        else:
            for sign in (1, -1):
                end = [self.near(x + s * 2.6, y + s * sign * 2.2) for s in (-1, 1)]
                self.line(end, self.black, self.width)

    def stray(self) -> None:
        """A stroke or a dot that means nothing."""
        rng = self.rng
        x, y = rng.uniform(14, 196), rng.uniform(55, 280)
        turn, length = rng.uniform(0, 2 * np.pi), rng.exponential(2.5)
        black = float(np.clip(self.black * rng.uniform(0.3, 1.0), 0.1, 0.95))
        self.line([(x, y), (x + length * np.cos(turn), y + length * np.sin(turn))], black, rng.uniform(0.2, 0.5))

    def write(self, character: str, x: float, y: float) -> None:
        """A digit or a minus in a box, around a place."""
        size, lean = self.rng.uniform(0.8, 1.15), self.rng.normal(0, 0.1)
        x, y = self.near(x, y)
        points = [
            (x + size * (0.9 * (u - 1) + lean * (2 - v)), y + size * 1.05 * (v - 2)) for u, v in _SEGMENTS[character]
        ]
        self.line([self.near_line(p) for p in points], max(self.black, 0.25), self.rng.uniform(0.3, 0.5))

    def near_line(self, place: Place) -> Place:
        """A point of a written stroke."""
        return place[0] + self.rng.normal(0, 0.1), place[1] + self.rng.normal(0, 0.1)


def fill(base: Image.Image, answers: Sequence[Answered], rng: np.random.Generator) -> Filled:
    """Fill in a printed page of 300 dpi and scan it."""
    style = str(rng.choice(list(STYLES), p=_SHARES))
    hand = Hand(rng, style, base.size)
    for place, answer in enumerate(answers):
        _answer(hand, page.block_corner(place), answer.text)
    for _ in range(rng.poisson(3.0)):
        hand.stray()
    soft = hand.ink.filter(ImageFilter.BoxBlur(0.5))
    paper = ImageChops.multiply(base, ImageChops.invert(soft))
    scanner = str(rng.choice(SCANNERS, p=[0.55, 0.2, 0.25]))
    (chance,) = rng.spawn(1)  # numbers of its own: pages with all corners stay as they are
    hidden = int(chance.integers(4)) if chance.random() < _HIDDEN[scanner] else None
    if hidden is not None:
        paper = with_hidden_corner(paper, hidden, chance)
    return Filled(scanned(paper, scanner, rng), tuple(answer.text for answer in answers), style, scanner, hidden)


def with_hidden_corner(paper: Image.Image, corner: int, rng: np.random.Generator) -> Image.Image:
    """A page of 300 dpi with a thumb, another sheet or a fold over one of its corners."""
    done = paper.copy()
    u, v = page.CORNERS[corner]
    x, y = page.WIDTH * (u > page.WIDTH / 2), page.HEIGHT * (v > page.HEIGHT / 2)
    a, b = rng.uniform(19.0, 26.0, 2)
    box = tuple(round(w * _MM) for w in (x - a, y - b, x + a, y + b))
    draw, grey = ImageDraw.Draw(done), int(rng.choice([40, 120, 200, 250]))
    if rng.random() < 0.5:
        draw.ellipse(box, fill=grey)
    else:
        draw.rectangle(box, fill=grey)
    return done


def _answer(hand: Hand, corner: Place, text: str) -> None:
    """Fill in the block of an answer, with mistakes that are corrected."""
    rng = hand.rng
    values = page.columns_of(text) if text else [None] * page.READ_COLUMNS
    for bubble in page.BUBBLES:
        at = corner[0] + bubble.x, corner[1] + bubble.y
        if values[bubble.column] == bubble.value:
            hand.mark(*at)
        elif text and rng.random() < 0.0012:
            hand.correct(*at)
    if hand.habit == "no boxes":
        return
    middle = corner[1] + page.BOX_TOP + page.BOX_HEIGHT / 2
    for column, value in enumerate(values[: page.DIGITS + 1]):
        if value is not None and (hand.habit == "boxes" or rng.random() < 0.6):
            hand.write("-" if column == page.MINUS else str(value), corner[0] + page.column_x(column), middle)
    point = values[page.POINT]
    if point is not None:
        x = corner[0] + page.column_x(point) + page.PITCH / 2
        hand.line([(x, middle + 2.0), (x - 0.3, middle + 2.9)], hand.black, 0.4)


def scanned(paper: Image.Image, scanner: str, rng: np.random.Generator) -> bytes:
    """The page as a scanner, a bad copier or a phone sees it, as JPEG."""
    dpi = float(rng.choice([150, 200, 300], p=[0.25, 0.5, 0.25]))
    width, height = round(page.WIDTH / 25.4 * dpi), round(page.HEIGHT / 25.4 * dpi)
    turn = np.radians(np.clip(rng.normal(0, 1.0), -3, 3))
    corners = np.array([[0, 0], [1, 0], [1, 1], [0, 1]]) * [width, height] - np.array([width, height]) / 2
    corners = corners @ np.array([[np.cos(turn), np.sin(turn)], [-np.sin(turn), np.cos(turn)]])
    corners *= 1 + rng.normal(0, 0.004, 2)
    size, ground = (width, height), 255
    if scanner == "phone":
        corners = corners * rng.uniform(0.88, 0.97) + rng.normal(0, 0.012, (4, 2)) * [width, height]
        ground = int(rng.integers(20, 150))
    else:
        corners += rng.normal(0, 0.002, 2) * [width, height]
        ground = int(rng.choice([255, 235, 30]))
    corners += np.array([width, height]) / 2
    shape = _coefficients(corners, paper.size)
    image = paper.transform(size, Image.Transform.PERSPECTIVE, shape, Image.Resampling.BILINEAR, fillcolor=ground)
    image = image.filter(ImageFilter.GaussianBlur(rng.uniform(0.4, 1.6 if scanner != "scanner" else 1.1) * dpi / 200))
    grey = np.asarray(image, dtype=np.float32) / 255
    if scanner == "phone":
        grey = _bent(grey, rng)
        grey *= _light(grey.shape, rng, 0.5)
    elif scanner == "copier":
        grey = np.clip((grey - 0.5) * rng.uniform(0.8, 1.4) + 0.5 + rng.uniform(-0.08, 0.08), 0, 1)
        grey *= _light(grey.shape, rng, 0.12)
        for _ in range(rng.poisson(12)):  # specks
            y, x = int(rng.integers(3, grey.shape[0] - 3)), int(rng.integers(3, grey.shape[1] - 3))
            grey[y : y + int(rng.integers(1, 4)), x : x + int(rng.integers(1, 4))] *= 0.3
    grey = np.clip(grey, 0, 1) ** rng.uniform(0.75, 1.3)
    grey += rng.uniform(0.004, 0.02 if scanner == "scanner" else 0.03) * rng.standard_normal(grey.shape, np.float32)
    done = Image.fromarray(np.clip(255 * grey, 0, 255).astype(np.uint8))
    if rng.random() < 0.05:
        done = done.transpose(Image.Transpose.ROTATE_180)
    file = io.BytesIO()
    done.save(file, "JPEG", quality=int(rng.integers(45, 91)))
    return file.getvalue()


def _coefficients(corners: np.ndarray, size: tuple[int, int]) -> list[float]:
    """The map from places of a scan to those of the paper, as Pillow wants it."""
    source = np.array([[0, 0], [1, 0], [1, 1], [0, 1]]) * size
    rows, right = [], []
    for (x, y), (u, v) in zip(corners, source, strict=True):
        rows += [[x, y, 1, 0, 0, 0, -u * x, -u * y], [0, 0, 0, x, y, 1, -v * x, -v * y]]
        right += [u, v]
    return list(np.linalg.solve(np.array(rows), np.array(right)))


def _bent(grey: np.ndarray, rng: np.random.Generator) -> np.ndarray:
    """A page that lies not quite flat, or is seen by a lens that bends straight lines: up to half a millimetre."""
    height, width = grey.shape
    rows, columns = np.arange(height), np.arange(width)
    dx = rng.uniform(-0.5, 0.5) / 297 * height * np.sin(np.pi * rows / height)
    dy = rng.uniform(-0.5, 0.5) / 210 * width * np.sin(np.pi * columns / width)
    moved = grey[np.clip(np.rint(rows[:, None] + dy[None, :]).astype(int), 0, height - 1), columns[None, :]]
    found: np.ndarray = moved[rows[:, None], np.clip(np.rint(columns[None, :] + dx[:, None]).astype(int), 0, width - 1)]
    return found


def _light(shape: tuple[int, ...], rng: np.random.Generator, most: float) -> np.ndarray:
    """Light that falls off to one side, with a shadow over a part."""
    small = np.linspace(-0.5, 0.5, 160, dtype=np.float32)
    turn = rng.uniform(0, 2 * np.pi)
    along = small[None, :] * np.cos(turn) + small[:, None] * np.sin(turn)
    light = 1 - most * rng.uniform(0, 1) * (along + 0.7) / 1.4
    if rng.random() < 0.4:
        edge = rng.uniform(-0.4, 0.4)
        light = light * (1 - 0.6 * most * rng.uniform(0.3, 1) / (1 + np.exp(-(along - edge) * 60)))
    whole = Image.fromarray(light.astype(np.float32)).resize((shape[1], shape[0]), Image.Resampling.BILINEAR)
    return np.asarray(whole)
