"""Two material points with a common component of velocity: gears and wheels that touch, the ends of a thread.

Where two bodies touch without slip, their points at the contact have the same velocity along the common tangent; the
two ends of an inextensible thread have the same velocity along it. The components of the accelerations are equal too:
the tangential ones, while the normal ones differ, because the points move on different paths (guide, section 4.1).
"""

from __future__ import annotations

from string import ascii_uppercase

from msgspec import Struct

from variantgen.algebra.expression import Value
from variantgen.algebra.name import Name
from variantgen.mechanism.rows import Placement
from variantgen.methods.geometry.geometry import Geometry, degrees, normal_angle
from variantgen.methods.groups.group import PointPath
from variantgen.methods.linkage.problem import Task
from variantgen.methods.solution.book import Book
from variantgen.methods.steps.step import CentreOf, Fact, Point
from variantgen.variants.printed_data import shown_points

_NEAR = 1e-9  # of the size of the mechanism: places closer than that are one
_LETTERS = "KLNSTUVWXYZQ" + ascii_uppercase


class ContactSide(Struct, frozen=True):
    """A material point at the contact, or the end of a thread: ``line.v_T = line.v_centre + radius lever omega_body``.

    ``line`` is the unit vector on paper along which the component is taken, ``radius`` (printed unit of length) the
    distance of the point from ``centre``, ``lever`` +1 or -1 by the sense of the arm, 0 where the point is the centre
    itself. ``centre`` is empty for something at rest. ``name`` is the letter of the point. ``radial`` are the two
    points to whose line the contact's tangent is perpendicular, if that is how it is known. ``belt``: it is the end of
    a part of a belt.
    """

    name: str
    centre: str
    line: complex
    body: str = ""
    radius: float = 0.0
    lever: int = 0
    radial: tuple[str, str] | None = None
    belt: bool = False

    @property
    def is_rest(self) -> bool:
        """Whether it belongs to something at rest."""
        return not self.centre

    def axis(self, book: Book) -> Value:
        """The direction of the line as a value (degrees)."""
        exact = degrees(self.line)
        if self.radial is not None:
            across = book.geometry.direction(*self.radial)
            for by in (90.0, -90.0):
                if abs(normal_angle(across.exact + by - exact)) < 1.0:
                    return Geometry.turned(across, by)
        return Value(None, "angle", exact)


class NoSlipContact(Struct, frozen=True):
    """The two sides of a contact or thread; ``kind`` is the file of its sentences.

    ``point_path`` is the path on which the contact itself keeps the centre of the first side, if it does. ``place``
    is the key of the sentence that says where on a turning body the point is, where that is not plain. ``reason`` is
    that of the sentence which says why velocities are equal; one is enough for all contacts of a step. ``rail`` is the
    body of a moving line that a wheel touches.
    """

    kind: str
    first: ContactSide
    second: ContactSide
    point_path: PointPath | None = None
    place: str = ""
    reason: str = ""
    rail: str = ""

    @property
    def ways(self) -> tuple[tuple[ContactSide, ContactSide], tuple[ContactSide, ContactSide]]:
        """Both ways to go through it: from a side to the other."""
        return (self.first, self.second), (self.second, self.first)


def metres(task: Task) -> Placement:
    """The configuration in SI, as joints with radii expect it."""
    unit = task.length_unit
    return Placement({name: z * unit for name, z in task.now.z.items()}, task.scene.frame)


def letter_at(task: Task, place: complex, bodies: tuple[str, ...], number: int, end: int = 0) -> str:
    """The name of the point of the bodies at a place (printed unit), or a letter that no point has.

    Places without a name are distinguished by the ``number`` of the joint and the ``end``, of which a thread has two.
    """
    for body in bodies:
        for point in task.scene.bodies.get(body, ()):
            if abs(task.now.z[point] - place) < _NEAR * task.size:
                return point
    free = [letter for letter in dict.fromkeys(_LETTERS) if letter not in task.scene.points]
    earlier = (joint.shapes()[0] for joint in task.scene.joints[:number] if joint.shapes())
    rank = sum(bool(shape.points and shape.bodies) for shape in earlier)
    return free[(2 * rank + end) % len(free)]


def resting_letter(task: Task, body: str, letter: str) -> str:
    """The name of a point of a wheel at a contact with something at rest: P, where that means its velocity centre.

    The figure names the centre so if no point has that letter, and no index tells the centres of several bodies apart.
    """
    form = task.form
    if letter in shown_points(task.variant, task.asked):
        return letter
    plane = [name for name, members in form.bodies.items() if not task.fixed & set(members)]
    alone = plane == [body] or not form.symbols.get(body, body)
    return "P" if alone and "P" not in task.scene.points else letter


def place_of(task: Task, side: ContactSide) -> complex:
    """The position of the material point of a side (printed unit of length)."""
    return task.now.z[side.centre] - 1j * side.line * side.radius * side.lever


def letter_of(book: Book, side: ContactSide, rests: bool) -> Fact:
    """A contact in a sentence: one at rest that has no letter in the figure is the velocity centre of its body."""
    if rests and side.lever and side.name not in book.task.scene.points:
        return CentreOf(side.body)
    return Point(side.name)


def contact_name(book: Book, side: ContactSide) -> Name:
    """The name of the vector of a side: tangential for an acceleration of a point of a turning body."""
    return Name(book.letter, side.name, part="tau" if book.order == 2 and side.lever else "")
