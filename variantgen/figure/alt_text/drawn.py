"""What a figure shows, for those who tell it: its named points, lines and circles, without any words."""

from __future__ import annotations

from collections.abc import Iterable
from functools import cached_property, lru_cache
from itertools import pairwise

from msgspec import Struct

from variantgen.families.figure_hints import DiscMark
from variantgen.figure.board import Board
from variantgen.mechanism.scene import references
from variantgen.wording.formula import letters, to_plain

_ON_LINE = 1e-6  # of the length of a line: how far off it a point of it may be by rounding

Segment = tuple[str, str]


@lru_cache(maxsize=10_000)
def _is_spelled(body: str, points: tuple[str, ...]) -> bool:
    spelled = [letter + number for letter, number in letters(body)]
    return "".join(spelled) == body and set(spelled) <= set(points)


class DrawnCircle(Struct, frozen=True):
    """A circle of the figure: its mark, its radius on paper (u)."""

    mark: DiscMark
    radius: float


class DrawnMechanism(Struct, dict=True):
    """The points and bodies of a figure that has been drawn on ``board``, as the figure names and draws them."""

    board: Board

    def at(self, point: str) -> complex:
        """The place of a point on paper (u)."""
        return self.board.sketch.at[point]

    def is_shown(self, point: str) -> bool:
        """Whether the figure names a point."""
        return point in self._names

    def name(self, point: str) -> str:
        """The name of a point as the figure shows it; nothing for a point that it does not name."""
        return self._names.get(point, "")

    @cached_property
    def _names(self) -> dict[str, str]:
        return {point: to_plain(self.board.symbol(point)) for point in self.board.shown}

    def shown(self, points: Iterable[str]) -> list[str]:
        """Those of some points that the figure names."""
        return [point for point in points if point in self._names]

    @property
    def fixed(self) -> frozenset[str]:
        """Fixed hinges."""
        return self.board.linkage.hinged

    @property
    def resting(self) -> frozenset[str]:
        """Points at rest: fixed hinges, centres of fixed circles."""
        return self.board.linkage.resting

    @property
    def companions(self) -> dict[str, set[str]]:
        """For each point of a body, the points that belong to a body with it."""
        found: dict[str, set[str]] = {}
        for members in self.board.form.bodies.values():
            for point in members:
                found.setdefault(point, set()).update(members)
        return found

    @property
    def coupled(self) -> dict[str, set[str]]:
        """The same by joints: the centres of a wheel and of its track, the stations of a rope."""
        found: dict[str, set[str]] = {}
        for names in (references(joint, "point") for joint in self.board.scene.joints):
            for point in names:
                found.setdefault(point, set()).update(names)
        return found

    @property
    def anchors(self) -> frozenset[str]:
        """Points by which others are found: those at rest and the centres of discs."""
        return self.resting | {circle.mark.centre for circle in self.circles}

    def owners(self, point: str) -> list[str]:
        """Bodies that a point belongs to."""
        return self._owners.get(point, [])

    @property
    def _owners(self) -> dict[str, list[str]]:
        found: dict[str, list[str]] = {}
        for body, members in self.board.form.bodies.items():
            for point in members:
                found.setdefault(point, []).append(body)
        return found

    @property
    def circles(self) -> list[DrawnCircle]:
        """The circles that are drawn as discs, with their radii."""
        rest = {body: iter(radii) for body, radii in self.board.discs.items()}
        return [DrawnCircle(mark, next(rest[mark.body])) for mark in self.board.form.figure.discs if not mark.arc]

    def circles_of(self, body: str) -> list[DrawnCircle]:
        """The circles of one body."""
        return [circle for circle in self.circles if circle.mark.body == body]

    def is_spelled(self, body: str) -> bool:
        """Whether the name of a body is made of names of its points (``OA``, and not ``wheel``)."""
        return _is_spelled(body, self.board.form.bodies[body])

    @property
    def segments(self) -> dict[str, list[Segment]]:
        """The straight lines that are drawn of each body, as pairs of points."""
        form = self.board.form
        found: dict[str, list[Segment]] = {body: [] for body in form.bodies}
        for body, start, end in form.bars:
            found[body].append((start, end))
        for body, members in form.bodies.items():
            for pair in (pair for names in form.figure.lines for pair in pairwise(names)):
                if set(pair) <= set(members) and pair not in found[body]:
                    found[body].append(pair)
        return found

    @property
    def between(self) -> dict[str, dict[str, Segment]]:
        """By body, the points that lie on one of its bars between the ends, which are both named."""
        return {body: self._between(body) for body in self.board.form.bodies}

    def _between(self, body: str) -> dict[str, Segment]:
        found: dict[str, Segment] = {}
        points = self.shown(self.board.form.bodies[body])
        for start, end in self.segments[body] if len(points) > 2 else []:
            foot, step = self.at(start), self.at(end) - self.at(start)
            if step == 0 or not (self.is_shown(start) and self.is_shown(end)):
                continue
            for point in points:
                part = (self.at(point) - foot) / step
                if 0 < part.real < 1 and abs(part.imag) < _ON_LINE and point not in (start, end):
                    found[point] = (start, end)
        return found

    def is_larger(self, body: str, radius: float) -> bool | None:
        """Whether a radius (u) is that of the larger rim of a stepped disc; None for a disc with one rim."""
        radii = [circle.radius for circle in self.circles_of(body)]
        return radius > sum(radii) / len(radii) if len(radii) > 1 else None
