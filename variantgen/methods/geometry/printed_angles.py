"""Points that conditions place together, where the sheet prints angles of the position: each by an angle and a length.

The equations that place them have no solution in closed form. With the printed angles nobody has to solve them: the
direction of a link follows from that of its neighbour, a third point of a plate from the two others.
"""

from __future__ import annotations

from collections.abc import Iterator, Mapping
from typing import Any

from variantgen.families.family import Form
from variantgen.mechanism.conditions.distance import Distance

Way = tuple[str, Mapping[str, Any]]  # the module of the room ``placing``, and its fields


def placed_by_angles(form: Form) -> dict[str, Way]:
    """How points that conditions place together follow from those before them, in an order in which they do.

    Empty where printed angles and given lengths do not suffice for all of them.
    """
    found: dict[str, Way] = {}
    waiting = list(form.plan.together)
    while waiting:
        known = {*form.plan.placing, *found}
        ways = ((point, way(form, point, known)) for way in (_by_angle, _by_plate) for point in waiting)
        point, way = next(((point, way) for point, way in ways if way), ("", None))
        if way is None:
            return {}
        found[point] = way
        waiting.remove(point)
    return found


def _by_angle(form: Form, point: str, known: set[str]) -> Way | None:
    """A point at the end of a link from a known one, at which the angle with another known side is printed."""
    for other, length in _links(form, point):
        corners = ({start, end} for start, at, end in form.figure.found if at == other)
        if other in known and any(point in ends and ends <= {point, *known} for ends in corners):
            return "at_printed_angle", {"origin": other, "distance": length}
    return None


def _by_plate(form: Form, point: str, known: set[str]) -> Way | None:
    """A point of a plate by its distances from two known points of that plate."""
    for plate in form.bodies.values():
        links = [(other, length) for other, length in _links(form, point) if other in known and other in plate]
        if point in plate and len(links) > 1:
            (first, first_length), (second, second_length) = links[:2]
            ends = {"first": first, "second": second}
            return "circle_circle", {**ends, "first_distance": first_length, "second_distance": second_length}
    return None


def _links(form: Form, point: str) -> Iterator[tuple[str, Any]]:
    """The other ends of links that end in a point, with their lengths."""
    for condition in form.conditions:
        fields = condition.fields
        if condition.component is Distance and point in (fields["start"], fields["end"]):
            yield fields["end"] if fields["start"] == point else fields["start"], fields["length"]
