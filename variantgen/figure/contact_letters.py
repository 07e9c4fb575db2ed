"""The letters that a solution gives to points of contact, pitch points and ends of threads, in its figures."""

from __future__ import annotations

from collections.abc import Sequence
from typing import NamedTuple

from variantgen.figure.drawing import Layer
from variantgen.figure.motion_board import MotionBoard
from variantgen.figure.requests import around
from variantgen.figure.sketch import DOT
from variantgen.methods.contact import place_of
from variantgen.methods.law import touches
from variantgen.methods.task import Task
from variantgen.wording.formula import Symbol
from variantgen.wording.vector_names import absolute

_CENTRE = "P"  # a contact at rest bears the letter of the velocity centre, which is drawn as such


class Contact(NamedTuple):
    """A point of contact with its letter: where it is on the paper (u), its velocity (m/s)."""

    name: str
    place: complex
    velocity: complex


def contacts_of(board: MotionBoard, task: Task) -> list[Contact]:
    """Points of turning bodies that touch others or a thread, if no point is shown there."""
    found: dict[str, Contact] = {}
    for touch in touches(task).values():
        for side in (touch.first, touch.second):
            known = {_CENTRE, *board.shown, *found}
            if not side.lever or side.name in known or side.body not in task.needed.bodies:
                continue
            place = place_of(task, side)
            swing = 1j * task.now.omega[side.body] * (place - task.now.z[side.centre])
            velocity = (task.now.v[side.centre] + swing) * task.length_unit
            found[side.name] = Contact(side.name, board.sketch.scale * place * task.length_unit, velocity)
    return list(found.values())


def draw_contacts(board: MotionBoard, contacts: Sequence[Contact], scale: float) -> None:
    """Add dots with letters and velocities (``scale`` u per m/s) at points of contact."""
    sketch = board.sketch
    for name, place, velocity in contacts:
        sketch.circle(place, DOT, Layer.HINGE, fill="ink")
        sketch.label(around(Symbol(name), place, DOT))
        sketch.at[name] = place
        board.vector(name, scale * velocity, absolute("v", name))
