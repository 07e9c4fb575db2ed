"""The letters that a solution gives to points of contact, pitch points and ends of threads, in its figures."""

from __future__ import annotations

from variantgen.figure.board import Board
from variantgen.figure.drawing import Layer
from variantgen.figure.requests import around
from variantgen.figure.sketch import DOT
from variantgen.methods.contact import place_of
from variantgen.methods.law import touches
from variantgen.methods.task import Task
from variantgen.wording.formula import Symbol

_CENTRE = "P"  # a contact at rest bears the letter of the velocity centre, which is drawn as such


def draw_contacts(board: Board, task: Task) -> None:
    """Add dots with letters where points of turning bodies touch others or a thread, if no point is shown there."""
    sketch, metre = board.sketch, task.length_unit
    needed = task.needed.bodies
    done = {_CENTRE, *board.shown}
    for touch in touches(task).values():
        for side in (touch.first, touch.second):
            if not side.lever or side.name in done or side.body not in needed:
                continue
            done.add(side.name)
            place = sketch.scale * place_of(task, side) * metre
            sketch.circle(place, DOT, Layer.HINGE, fill="ink")
            sketch.label(around(Symbol(side.name), place, DOT))
