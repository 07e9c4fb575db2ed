"""The points of a mechanism: hinges between links, dots on bodies, and the names."""

from __future__ import annotations

from collections.abc import Sequence

from variantgen.families.family import Form
from variantgen.figure.board import Board
from variantgen.figure.drawing import Layer
from variantgen.figure.placement.label_requests import around
from variantgen.figure.sketch import DOT, HINGE

_ON_LINE = 1e-6  # of a slot: how far off its line a point may be by rounding


def draw_points(board: Board, shown: Sequence[str]) -> None:
    """Hinges between links, dots on bodies, and the names."""
    sketch = board.sketch
    for point in shown:
        if point not in board.clear:
            if _joins_links(board.form, point) or _is_axle(board, point):
                sketch.circle(sketch.at[point], HINGE, Layer.HINGE, fill="paper")
                board.sized(point, HINGE)
            elif point not in _free_ends(board.form) or _is_in_slot(board, point):
                sketch.circle(sketch.at[point], DOT, Layer.HINGE, fill="ink")
                board.sized(point, DOT)
        sketch.label(around(board.symbol(point), sketch.at[point], board.clear.get(point, 0.3)))


def _joins_links(form: Form, point: str) -> bool:
    """Whether a point belongs to several bodies."""
    return sum(point in members for members in form.bodies.values()) > 1


def _is_axle(board: Board, point: str) -> bool:
    """Whether a disc turns about the point: its centre, unless another point of the disc is its fixed axis."""
    if not board.is_disc(point):
        return False
    owners = board.owners(point)
    discs = {disc.body for disc in board.form.figure.discs}
    held = any(name in board.fixed and name != point for body in owners for name in board.form.bodies[body])
    return bool(owners) and discs.issuperset(owners) and not held


def _is_in_slot(board: Board, point: str) -> bool:
    """Whether a point is on the slot of its own body, between the ends: the slot covers the end of a bar there."""
    for start, *_, end in board.form.figure.grooves:
        if any({point, start, end} <= {*members} for members in board.form.bodies.values()):
            part = (board.sketch.at[point] - board.sketch.at[start]) / (board.sketch.at[end] - board.sketch.at[start])
            if 0 < part.real < 1 and abs(part.imag) < _ON_LINE:
                return True
    return False


def _free_ends(form: Form) -> frozenset[str]:
    """The ends of bars and the corners of plates, which need no dots; a slotted bar has no line at its end."""
    corners = (point for body in form.figure.plates for point in form.bodies[body])
    return frozenset(
        (*(point for body, *both in form.bars if body not in form.figure.slotted for point in both), *corners)
    )
