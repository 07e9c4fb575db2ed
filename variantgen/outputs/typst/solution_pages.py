"""Where everything of a solution stands on its pages, from heights that the engine has measured (in millimetres).

A problem has units, which are not parted, and figures. Units stand in two columns, which are as high as they need to
be; what is wide stands between such columns. A figure comes after the unit that it belongs to, or where there is room
for it next. The figure of a statement stands at the head of the right column, beside the statement.
"""

from __future__ import annotations

from collections.abc import Sequence

from msgspec import Struct, field
from msgspec.structs import replace

from variantgen.exam.solution_paper import BETWEEN_COLUMNS, COLUMN, EM, HEIGHT

_ABOUT_COLUMNS, _LEAST_COLUMNS = 2.4, 12.0
_ABOUT_FIGURE, UNDER_FIGURE = 3.0, 1.6
_ABOVE_HEADING, _BELOW_HEADING = (6.0, 3.5), 2.5  # the first one below something else, then at the head of a page
_BELOW_HEAD = 1.2 * EM
_HALVINGS = 5
# Where less than this part of the last page is taken, figures become smaller, if then there is no such page.
_LITTLE = 0.35
_CLOSER = (0.92, 0.83)

# What it is, the numbers of its problem and its own, its place from the left and the top, millimetres of a figure unit.
Standing = tuple[str, int, int, float, float, float]


class Block(Struct, frozen=True):
    """A unit of a problem or, with a ``unit`` of its own, a figure.

    ``figures`` belong to a unit, ``starts`` are where its parts begin, from its top.
    """

    kind: str
    number: int
    high: float
    above: float
    below: float
    wide: bool = False
    figures: tuple[Block, ...] = ()
    starts: tuple[float, ...] = ()
    unit: float = 0.0
    least: float = 0.0
    drawn: float = 0.0  # the height of the drawing in its units

    def smaller(self, part: float) -> Block:
        """A figure in some proportion to its usual size, but not so small that its letters could not be read."""
        unit = max(part * self.unit, self.least)
        return replace(self, unit=unit, high=self.high - self.drawn * (self.unit - unit))


class ProblemBlocks(Struct, frozen=True):
    """The heights of its headings (below something else, at the head of a page), its units, the statement's figure."""

    headings: tuple[float, float]
    units: tuple[Block, ...]
    beside: Block

    def closer(self, part: float) -> ProblemBlocks:
        """With smaller figures, but for that of the statement."""
        units = (replace(u, figures=tuple(f.smaller(part) for f in u.figures)) for u in self.units)
        return replace(self, units=tuple(units))


class _Column(Struct):
    items: list[tuple[Block, float]]
    high: float
    units: Sequence[Block]  # those that are left
    waiting: list[Block]  # figures that are left


class _Columns(Struct):
    left: _Column
    right: _Column

    @property
    def high(self) -> float:
        return max(self.left.high, self.right.high)

    @property
    def done(self) -> bool:
        return not self.right.units and not self.right.waiting


class Pages(Struct):
    """Pages that are filled from above: ``y`` is where the last one ends, ``below`` the space that belongs there."""

    room: float
    pages: list[list[Standing]] = field(default_factory=lambda: [[]])
    y: float = 0.0
    below: float = 0.0

    def under(self, above: float) -> float:
        """Where something with some space above it would begin."""
        return self.y + max(self.below, above) if self.y > 0 else self.y

    def turn(self) -> None:
        """Begin another page."""
        self.pages.append([])
        self.y = 0.0

    def put(self, kind: str, problem: int, number: int, high: float, above: float, below: float) -> None:
        """Set something of the width of the page."""
        top = self.under(above)
        self.pages[-1].append((kind, problem, number, 0.0, round(top, 4), 0.0))
        self.y, self.below = top + high, below

    def put_columns(self, problem: int, found: _Columns) -> None:
        """Set two columns."""
        top = self.under(_ABOUT_COLUMNS)
        for column, x in ((found.left, 0.0), (found.right, COLUMN + BETWEEN_COLUMNS)):
            for block, y in column.items:
                self.pages[-1].append((block.kind, problem, block.number, x, round(top + y, 4), block.unit))
        self.y, self.below = top + found.high, _ABOUT_COLUMNS


def stacked(parts: Sequence[tuple[float, float, float]]) -> tuple[float, tuple[float, ...]]:
    """The height of parts below each other, and where each begins; a part is the space above, below, its height."""
    starts: list[float] = []
    y = space = 0.0
    for above, below, high in parts:
        start = y + max(space, above) if starts else 0.0
        starts.append(round(start, 4))
        y, space = start + high, below
    return y, tuple(starts)


def figure_block(number: int, drawn: float, unit: float, least: float, caption: float) -> Block:
    """A figure: the height of its drawing in units, millimetres of a unit, the fewest of them; its caption's height."""
    high = drawn * unit + UNDER_FIGURE + caption
    return Block("figure", number, high, _ABOUT_FIGURE, _ABOUT_FIGURE, unit=unit, least=least, drawn=drawn)


def pages_of(head: float, problems: Sequence[ProblemBlocks], room: float = HEIGHT) -> Pages:
    """The pages: what stands on each, and how high it is on the last one."""
    found = _laid(head, problems, room)
    if len(found.pages) > 1 and found.y < _LITTLE * room:
        for part in _CLOSER:
            tried = _laid(head, [problem.closer(part) for problem in problems], room)
            if len(tried.pages) < len(found.pages):
                found = tried
                break
    return found


def _laid(head: float, problems: Sequence[ProblemBlocks], room: float) -> Pages:
    """The problems on pages, the head above them. No statement stands alone at the foot of a page."""
    found = Pages(room)
    if head:
        found.put("head", 0, 0, head, 0.0, _BELOW_HEAD)
    for i, problem in enumerate(problems):
        _lay(found, i, problem)
    return found


def _lay(pages: Pages, number: int, problem: ProblemBlocks) -> None:
    units: Sequence[Block] = problem.units
    first, second = units[:2]
    after = _LEAST_COLUMNS if first.wide or second.wide else second.above + second.high
    start = max(first.high + after, problem.beside.high)
    at_head = number == 0
    if number and pages.under(_ABOVE_HEADING[0]) + problem.headings[0] + _ABOUT_COLUMNS + start > pages.room:
        pages.turn()
        at_head = True
    if any(problem.headings):
        pages.put("heading", number, int(at_head), problem.headings[at_head], _ABOVE_HEADING[at_head], _BELOW_HEADING)
    waiting: list[Block] = []
    beside = [problem.beside]
    while units or waiting:
        if pages.y > 0 and pages.room - pages.under(_ABOUT_COLUMNS) < _LEAST_COLUMNS:
            pages.turn()
        if units and units[0].wide:
            block = units[0]
            if pages.y > 0 and pages.under(block.above) + block.high > pages.room:
                pages.turn()
            waiting += block.figures
            pages.put("unit", number, block.number, block.high, block.above, block.below)
            units = units[1:]
            continue
        count = next((k for k, block in enumerate(units) if block.wide), len(units))
        room = pages.room - pages.under(_ABOUT_COLUMNS)
        found = _columns(units[:count], waiting, beside, room, pages.y == 0)
        beside = []
        units = [*found.right.units, *units[count:]]
        waiting = found.right.waiting
        pages.put_columns(number, found)
        if not found.done:
            pages.turn()


def _columns(
    units: Sequence[Block], waiting: Sequence[Block], beside: Sequence[Block], room: float, forced: bool
) -> _Columns:
    """Two columns that are as high as they need to be, and no higher than there is room."""
    found = _two_columns(units, waiting, beside, room, forced)
    if not found.done:
        if not found.right.units:
            # Where only figures are left, they come before what they belong to.
            bare = [replace(block, figures=()) for block in units]
            own = [figure for block in units for figure in block.figures]
            early = _two_columns(bare, waiting, [*beside, *own], room, False)
            if early.done:
                return early
        return found
    low, high = found.high / 2, found.high
    for _ in range(_HALVINGS):
        middle = (low + high) / 2
        tried = _two_columns(units, waiting, beside, middle, False)
        if tried.done and tried.high <= middle:
            found, high = tried, tried.high
        else:
            low = middle
    return found


def _two_columns(
    units: Sequence[Block], waiting: Sequence[Block], beside: Sequence[Block], room: float, forced: bool
) -> _Columns:
    """``beside`` are figures at the head of the right column."""
    left = _column(units, waiting, room, forced)
    return _Columns(left, _column(left.units, [*beside, *left.waiting], room, False))


def _column(units: Sequence[Block], waiting: Sequence[Block], room: float, forced: bool) -> _Column:
    """A column of some height: the figures that wait, and units as far as there is room, each with its figures after.

    Figures for which there is none go on waiting. ``forced``: what comes first stands here in any case.
    """
    items: list[tuple[Block, float]] = []
    y = below = 0.0
    left = list(waiting)

    def put(block: Block) -> bool:
        nonlocal y, below
        top = y + (max(below, block.above) if items else 0.0)
        if top + block.high > room and not (forced and not items):
            return False
        items.append((block, top))
        y, below = top + block.high, block.below
        return True

    taken = 0
    while True:
        while left and put(left[0]):
            left.pop(0)
        if taken == len(units) or not put(units[taken]):
            break
        left += units[taken].figures
        taken += 1
    return _Column(items, y, units[taken:], left)


def is_too_high(problems: Sequence[ProblemBlocks], room: float = HEIGHT) -> bool:
    """Whether a unit is higher than a page."""
    return any(block.high > room for problem in problems for block in problem.units)
