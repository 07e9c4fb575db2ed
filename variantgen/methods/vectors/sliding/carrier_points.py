"""By which of its points the motion of a carrier on which something slides is written."""

from __future__ import annotations

from msgspec.structs import replace

from variantgen.methods.groups.carriers import is_translating
from variantgen.methods.groups.group import SlidingPair
from variantgen.methods.solution.book import Book

_SQUARE = 1e-9  # cosine of an angle that is a right one, but for rounding


def seen(book: Book, group: SlidingPair) -> SlidingPair:
    """The group with the path of a point that the figure names: all points of a translating carrier are alike."""
    point_path, hidden = group.carrier_path, book.task.form.figure.hidden
    if point_path is None or point_path.point not in hidden:
        return group
    if not (point_path.straight and is_translating(book, group.carrier)):
        return group
    shown = (name for name in book.task.scene.bodies[group.carrier] if name not in hidden)
    return replace(group, carrier_path=replace(point_path, point=next(shown, point_path.point)))


def about_corner(book: Book, group: SlidingPair) -> SlidingPair:
    """The group with the corner E of a slot as the pole of a carrier that turns at a known rate about O.

    Where OE and EM are given and the slot EM is square to OE, the vectors of E and those about E are along the slot and
    across it, like the relative ones: no triangle OEM and no oblique vector.
    """
    line = group.path.line
    if line is None or group.turning or group.pole not in book.task.fixed:
        return group
    if book.graphics is not None or not book.style.is_free:
        return group
    now, point, hidden = book.task.now, group.path.point, book.task.form.figure.hidden
    slot = now.z[line[1]] - now.z[line[0]]
    for corner in book.task.scene.bodies[group.carrier]:
        arm, rest = now.z[corner] - now.z[group.pole], now.z[point] - now.z[corner]
        square = abs((arm.conjugate() * slot).real) < _SQUARE * abs(arm * slot)
        along = abs((rest.conjugate() * slot).imag) < _SQUARE * abs(rest * slot)
        ends = ((group.pole, corner), (corner, point))
        if corner not in hidden and square and along and all(book.geometry.stated(*pair) is not None for pair in ends):
            return replace(group, pole=corner)
    return group
