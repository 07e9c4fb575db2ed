"""The points of contact, pitch points and ends of threads in figures: letters of the solution, velocities."""

from __future__ import annotations

from collections.abc import Collection, Mapping

from msgspec import Struct
from msgspec.structs import replace

from variantgen.algebra.name import Name
from variantgen.figure.board import Board
from variantgen.figure.drawing import MEDIUM, Layer
from variantgen.figure.motion.motion_board import MotionBoard
from variantgen.figure.placement.label_requests import around
from variantgen.figure.sketch import DOT
from variantgen.methods.groups.contact import place_of
from variantgen.methods.groups.contacts_of_scene import contacts_of_scene
from variantgen.methods.linkage.instant import Instant
from variantgen.methods.linkage.problem import Task
from variantgen.wording.formula import Symbol
from variantgen.wording.solution.quantity_symbols import Symbols

_NOTHING = 1e-9  # of the greatest velocity


class ContactPoint(Struct, frozen=True):
    """A point of a body about ``centre`` where it touches another or a thread: its place (m) and velocity (m/s).

    One that ``rests`` on something fixed, and is no point of the mechanism, bears the letter of the velocity centre.
    """

    place: complex
    velocity: complex
    body: str
    centre: str
    rests: bool


def contact_points(task: Task, now: Instant, shown: Collection[str], body: str = "") -> dict[str, ContactPoint]:
    """The points of contact of the bodies that the solution needs, or of one ``body``, where no point is ``shown``.

    By letter; of two bodies that touch the first where none is named.
    """
    needed = task.needed.bodies
    found: dict[str, ContactPoint] = {}
    for contact in contacts_of_scene(task).values():
        for side, other in contact.ways:
            if not side.lever or side.name in (*shown, *found) or side.body not in ([body] if body else needed):
                continue
            place = place_of(task, side) * task.length_unit
            swing = 1j * now.omega[side.body] * (place - now.z[side.centre])
            rests = other.is_rest and side.name not in task.scene.points
            found[side.name] = ContactPoint(place, now.v[side.centre] + swing, side.body, side.centre, rests)
    return found


def draw_contacts(board: MotionBoard, found: Mapping[str, ContactPoint], scale: float, symbols: Symbols) -> None:
    """Add dots with letters and velocities (``scale`` u per m/s)."""
    sketch = board.sketch
    for name, contact in found.items():
        if contact.rests:
            continue  # drawn as the centre
        key = f"contact {name}"
        place = sketch.at[key] = sketch.scale * contact.place
        draw_dot(board, place, name)
        board.vector(key, scale * contact.velocity, symbols.letter(Name("v", name)), MEDIUM)


def touching_points(
    task: Task, now: Instant, shown: Collection[str], body: str, resting: bool
) -> dict[str, ContactPoint]:
    """The points at which a body touches others, by letter: those that move, those that are ``resting`` if wanted."""
    found = contact_points(task, now, shown, body)
    fastest = max(abs(vector) for vector in now.v.values())
    still = {name for name, contact in found.items() if abs(contact.velocity) <= _NOTHING * fastest}
    return {
        name: replace(contact, velocity=0j) if name in still else contact
        for name, contact in found.items()
        if name not in still or resting
    }


def draw_dot(board: Board, place: complex, name: str | Symbol) -> None:
    """Add a dot with the letter of a point that the mechanism is not drawn with (``place`` in u)."""
    board.sketch.circle(place, DOT, Layer.HINGE, fill="ink")
    board.sketch.label(around(Symbol(name) if isinstance(name, str) else name, place, DOT))
