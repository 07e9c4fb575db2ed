"""Sums of angles that have a name: each is worked out once, and where it is long before it is used."""

from __future__ import annotations

from itertools import combinations

from msgspec.structs import replace

from variantgen.algebra.expression import Constant, Value
from variantgen.methods.geometry.angle_sums import angle_sum, difference, is_short, is_single, valued
from variantgen.methods.geometry.angles import AngleForm, corner_name, short
from variantgen.methods.solution.book import Book
from variantgen.methods.steps.step import Derived, Fact, Share, VectorOf
from variantgen.variants.printed_data import shown_points

_RIGHT = 90.0  # degrees
_SAME = 1e-6  # degrees within which an angle of the figure is a sum


def _key(form: AngleForm) -> AngleForm:
    return AngleForm(form.parts, short(form.constant))


def by_name(book: Book, angle: Value) -> Value:
    """An angle as one that has a name already, if there is one."""
    found = book.named_angles.get(_key(angle_sum(angle)))
    return angle if found is None else Value(angle.name, "angle", angle.exact, found)


def note_sum(book: Book, angle: Value, same: Value | None = None) -> None:
    """Note that a sum of angles has a name and a line; ``same`` is that sum, where the line finds it another way."""
    book.named_angles.setdefault(_key(angle_sum(angle if same is None else same)), angle)


def named(book: Book, share: Share, line: Fact | None = None, crossed: Fact | None = None) -> Share:
    """A projection whose angle, if it is a long sum or one of corners, has a name: a corner of the figure, a letter.

    ``line`` is the axis in words, a segment or a vector: a letter is said to be the acute angle with it. An axis that
    is neither is told by the line or vector ``crossed``, to which it is perpendicular.
    """
    found = renamed(book, share)
    if found is not share or share.angle is None:
        return found
    form = angle_sum(share.angle)
    if is_short(form) and not _is_of_corners(form):
        return found
    if abs(form.constant) > 2 * _RIGHT:  # 270 degrees in a sum: the angle to 90 degrees is the natural one
        form = form.times(-1.0).turned(_RIGHT)
        share = replace(share, angle=valued(None, form), function=_OTHER[share.function])
        if (again := renamed(book, share)) is not share:
            return again
    known = share.term.size is not None or share.function == "sin"
    opposite = share.sign if share.function == "sin" else -share.sign
    for constant, count, sign, function in (
        (0.0, 1.0, share.sign, share.function),
        (2 * _RIGHT, -1.0, opposite, share.function),
        (_RIGHT, -1.0, share.sign, _OTHER[share.function]),
    ):
        corner = _corner(book, form.times(count).turned(constant)) if known or constant != 2 * _RIGHT else None
        if corner is not None:
            return replace(share, angle=corner, sign=sign, function=function)
    if is_short(form):
        return share
    if _RIGHT < valued(None, form).exact < 2 * _RIGHT:  # the letter is that of the acute angle
        form, share = form.times(-1.0).turned(2 * _RIGHT), replace(share, sign=opposite)
    angle = valued(book.geometry.letter(), form)
    other = crossed if line is None else line
    if other is not None:
        key = "axes.angle" if (share.function == "cos") == (line is not None) else "axes.angle_across"
        book.say(key, False, angle=angle, vector=VectorOf(share.term.name), line=other)
    book.items.append(Derived(angle))
    note_sum(book, angle)
    return replace(share, angle=angle)


def _is_of_corners(form: AngleForm) -> bool:
    """Whether two angles of a sum had to be worked out."""
    expressions = [atom.expression for atom, _ in form.parts if isinstance(atom, Value)]
    return sum([not isinstance(item, Constant) for item in expressions if item is not None]) > 1


def _corner(book: Book, form: AngleForm) -> Value | None:
    """A sum of angles as the angle between two segments of known direction from one point, with its line."""
    geometry, size = book.geometry, valued(None, form).exact
    near = [ends for ends, turn in _corners(book) if abs(turn - size) <= _SAME]
    for vertex, first, second in near:
        if not (geometry.has_direction(vertex, first) and geometry.has_direction(vertex, second)):
            continue
        name = corner_name(vertex, first, second)
        corner = difference(name, geometry.direction(vertex, first), geometry.direction(vertex, second))
        if _key(angle_sum(corner)) == _key(form):
            book.items.append(Derived(corner))
            note_sum(book, corner)
            return corner
    return None


def _corners(book: Book) -> list[tuple[tuple[str, str, str], float]]:
    """The angles (degrees) between the ways from each point of the figure to two others; the task remembers them."""
    geometry, known = book.geometry, book.task.remembered
    if "corners" not in known:
        found = known["corners"] = []
        points = shown_points(book.task.variant, book.task.asked)
        for vertex in points:
            rays = [p for p in points if p != vertex and abs(geometry.vector(vertex, p)) > geometry.nothing]
            for (first, one), (second, other) in combinations([(p, geometry.bearing(vertex, p)) for p in rays], 2):
                turn = abs(one - other)
                found.append(((vertex, first, second), min(turn, 360.0 - turn)))
    corners: list[tuple[tuple[str, str, str], float]] = known["corners"]
    return corners


def renamed(book: Book, share: Share) -> Share:
    """A projection with the angle that has a name, where its sum is that or its complement or supplement."""
    if share.angle is None or not book.named_angles or is_single(form := angle_sum(share.angle)):
        return share
    ways = [(0.0, 1.0, share.function), (_RIGHT, -1.0, _OTHER[share.function])]
    if share.function == "sin":
        ways.append((-_RIGHT, 1.0, "cos"))
    for constant, sign, function in ways:
        found = book.named_angles.get(_key(form.times(sign).turned(constant)))
        if found is not None:
            return replace(share, angle=found, function=function)
    found = book.named_angles.get(_key(form.times(-1.0).turned(180.0)))
    if found is None or (found.exact > _RIGHT and is_short(form) and not _is_of_corners(form)):
        return share
    if share.function == "sin":
        return replace(share, angle=found)
    if share.term.size is not None:
        return replace(share, sign=-share.sign, angle=found)
    rest = Constant(180.0, "angle") - found
    return share if is_short(form) else replace(share, angle=Value(None, "angle", rest.number(True), rest))


_OTHER = {"cos": "sin", "sin": "cos"}
