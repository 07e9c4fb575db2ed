"""Rows of formulas of a solution in lines: of a column or, where a piece would become too small there, of the page.

The widths of formulas are known before anything is laid out. A row that is longer than the line is broken between its
formulas, and a formula that is longer before its signs; a piece with no room there begins further to the left, and one
that is longer than the whole line is set smaller. Lengths in em of the text of solutions.
"""

from __future__ import annotations

from collections.abc import Sequence

from msgspec import Struct, field

from variantgen.exam import solution_paper
from variantgen.exam.solution_paper import EM, WIDTH
from variantgen.outputs.typst.fragments import FULL, Fragment, LetterLine, PlacedMark, rounded
from variantgen.outputs.typst.markup import Piece
from variantgen.outputs.typst.set_formulas import set_piece, set_whole_piece
from variantgen.outputs.typst.widths import formula_width

COLUMN, PAGE = solution_paper.COLUMN / EM, WIDTH / EM
_FIRST, _NEXT = 1.4, 3.8  # indents of a formula and of its further lines
_LEAST = 0.72  # what would become smaller in a column has the width of the page
_BETWEEN_PIECES, _BETWEEN_FORMULAS = 0.25, 1.6
_AFTER_SIGN = 0.25
_SIGN, _STOP = 0.778, 0.278  # widths of signs as =, and of marks as ;
_ROOM = 0.05  # for what is rounded
_NEARLY = 1.08  # by how much a width that is only estimated may be too small
_TALL = "display("
CAPITALS, LEADING = 0.683, 0.64  # the height of a line of letters, and what is between two lines

# What has room in a column by itself, without being set smaller.
WIDEST = COLUMN - _ROOM - _STOP - (_SIGN + _AFTER_SIGN)

Formulas = Sequence[Sequence[tuple[str, Piece]]]  # in pieces that hold together, with the sign before each


class Line(Struct):
    """A line of a row: what is on it, from its indent."""

    indent: float
    scale: float = 1.0
    items: list[tuple[float, str, Piece | None]] = field(default_factory=list)  # space before it, sign, piece
    end: float = 0.0
    bottom: float = 0.0
    top: float = 0.0
    known: bool = True  # whether all of it is set here

    def has_room(self, width: float, room: float) -> bool:
        """Whether something can follow, with a mark that ends it."""
        return self.indent + self.end + width + _STOP <= room

    def add(self, gap: float, sign: str, piece: Piece, width: float) -> None:
        """Set a piece after what is there: the space before it, its sign, its markup."""
        gap = gap if self.items else 0.0
        self.items.append((gap, sign, piece))
        self.end += width + gap
        made = set_piece(piece)
        self.known = self.known and made is not None
        if made and piece.startswith(_TALL):
            self.bottom, self.top = min(self.bottom, made.lowest), max(self.top, made.highest)

    def stop(self, mark: str) -> None:
        """End a formula."""
        self.items.append((0.0, mark, None))
        self.end += _STOP

    def fragments(self, letters: bool) -> tuple[Fragment, ...]:
        """What is on it, as letters or as formulas for the engine."""
        found = LetterLine()
        for gap, sign, piece in self.items:
            found.space(gap)
            if sign:
                found.letters(FULL, sign)
                found.space(_AFTER_SIGN if piece else 0.0)
            made = set_whole_piece(piece) if piece and letters else None
            if made:
                found.extend(made.fragments)
                found.space(made.rest)
            elif piece:
                found.put((piece,))
        return found.found()

    def apart(self) -> tuple[tuple[Fragment, ...], list[PlacedMark]]:
        """Of a line that is known, its letters, and apart from them, from its indent, its signs that grow and bars."""
        found = LetterLine()
        marks: list[PlacedMark] = []
        x = 0.0
        for gap, sign, piece in self.items:
            found.space(gap)
            x += gap
            if sign:
                found.letters(FULL, sign)
                if piece:
                    found.space(_AFTER_SIGN)
                    x += _SIGN + _AFTER_SIGN
                else:
                    x += _STOP
            if piece and (made := set_piece(piece)):
                found.extend(made.fragments)
                found.space(made.rest)
                marks += [(rounded(x + right), up, what) for right, up, what in made.marks]
                x += made.width
        return found.found(), marks

    @property
    def baseline(self) -> float:
        """How far below its top its letters stand (em)."""
        return self.scale * max(CAPITALS, self.top)

    @property
    def high(self) -> float:
        """Its whole height (em)."""
        return self.scale * (max(CAPITALS, self.top) - self.bottom)


class Row(Struct, frozen=True):
    """A row in lines; ``wide``: as the page."""

    wide: bool
    lines: Sequence[Line]

    def known_height(self, letters: bool) -> float | None:
        """The height (em), or None if the engine has to measure it."""
        return rounded(self.high) if letters and all(line.known for line in self.lines) else None

    @property
    def high(self) -> float:
        """The height of lines of letters (em)."""
        return sum(line.high for line in self.lines) + LEADING * (len(self.lines) - 1)


def in_lines(row: Formulas, mark: str) -> Row:
    """A row for the template; it ends with a mark."""
    widths = [[_width(sign, piece) for sign, piece in pieces] for pieces in row]
    wide = any(_LEAST * width > COLUMN for own in widths for width in own)
    room = (PAGE if wide else COLUMN) - _ROOM
    lines = [Line(_FIRST)]
    for i, (pieces, own) in enumerate(zip(row, widths, strict=True)):
        if i and not lines[-1].has_room(_BETWEEN_FORMULAS + _whole(own), room):
            lines.append(Line(_FIRST))
        _set(lines, pieces, own, room)
        lines[-1].stop(mark if i == len(row) - 1 else ";")
    return Row(wide, lines)


def _set(lines: list[Line], pieces: Sequence[tuple[str, Piece]], widths: Sequence[float], room: float) -> None:
    """Set a formula on the last line; where there is no room, it goes on below."""
    for k, ((sign, piece), width) in enumerate(zip(pieces, widths, strict=True)):
        gap = _BETWEEN_PIECES if k else _BETWEEN_FORMULAS
        if k and not lines[-1].has_room(gap + width, room):
            lines.append(Line(_NEXT))
        line = lines[-1]
        if not Line(line.indent).has_room(width, room):  # it is alone on its line
            line.indent = max(0.0, room - width - _STOP)
            line.scale = min(1.0, room / (width + _STOP))
        line.add(gap, sign, piece, width)


def _whole(widths: Sequence[float]) -> float:
    return sum(widths) + (len(widths) - 1) * _BETWEEN_PIECES


def _width(sign: str, piece: Piece) -> float:
    made = set_piece(piece)
    own = made.width if made else _NEARLY * sum(map(formula_width, piece.formulas))
    return own + (_SIGN + _AFTER_SIGN if sign else 0.0)
