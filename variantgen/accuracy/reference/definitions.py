"""What defines a point or a condition, as equations: by what a place misses its definition (m).

A function bears the name of the kind; its equations are sums and products only where the definition is, without a
branch. They check the positions of the reference by substitution, and those of conditions are what Newton's method
solves.
"""

from __future__ import annotations

from collections.abc import Callable
from typing import Any

from variantgen.accuracy.precise import unit_vector
from variantgen.accuracy.reference.positions import Places, line_ray


def definition(kind: str) -> Callable[..., tuple[Any, ...]] | None:
    """The function that gives what is left of a definition, if there is one."""
    found: Callable[..., tuple[Any, ...]] | None = globals().get(kind) if not kind.startswith("_") else None
    return found


def coordinates(item: Any, z: Any, at: Places) -> tuple[Any, ...]:
    """The coordinates."""
    return z.real - item.x.value, z.imag - item.y.value


def near(item: Any, z: Any, at: Places) -> tuple[Any, ...]:
    """Nothing: the conditions of the scene define the point."""
    return ()


def polar(item: Any, z: Any, at: Places) -> tuple[Any, ...]:
    """The vector turned back by the angle lies along the reference ray."""
    back = (z - at[item.origin]) * unit_vector(-item.angle.value)
    if item.towards is None:
        return back.real - item.distance.value, back.imag
    ray = at[item.towards] - at[item.origin]
    product = ray.conjugate() * back
    return (product.real - item.distance.value * abs(ray)) / abs(ray), product.imag / abs(ray)


def on_body(item: Any, z: Any, at: Places) -> tuple[Any, ...]:
    """The coordinates on the body, as scalar and vector product with the ray."""
    ray = at[item.towards] - at[item.origin]
    product = ray.conjugate() * (z - at[item.origin]) / abs(ray)
    return product.real - item.along.value, product.imag - item.across.value


def fraction(item: Any, z: Any, at: Places) -> tuple[Any, ...]:
    """The way to the point is the part of the segment."""
    gap = z - at[item.start] - item.part.value * (at[item.end] - at[item.start])
    return gap.real, gap.imag


def foot(item: Any, z: Any, at: Places) -> tuple[Any, ...]:
    """On the line, and perpendicular to it."""
    ray = line_ray(item, at)
    return _off(z, at[item.through], ray), (ray.conjugate() * (z - at[item.of])).real


def line_line(item: Any, z: Any, at: Places) -> tuple[Any, ...]:
    """On both lines."""
    found = []
    for start, angle, towards in (
        (item.first, item.first_angle, item.first_towards),
        (item.second, item.second_angle, item.second_towards),
    ):
        ray = unit_vector(angle.value) if towards is None else at[towards] - at[start]
        found.append(_off(z, at[start], ray))
    return tuple(found)


def line_circle(item: Any, z: Any, at: Places) -> tuple[Any, ...]:
    """On the line, and at the distance from the centre."""
    return _off(z, at[item.through], line_ray(item, at)), abs(z - at[item.centre]) - item.distance.value


def circle_circle(item: Any, z: Any, at: Places) -> tuple[Any, ...]:
    """At both distances."""
    return (
        abs(z - at[item.first]) - item.first_distance.value,
        abs(z - at[item.second]) - item.second_distance.value,
    )


def tangent(item: Any, z: Any, at: Places) -> tuple[Any, ...]:
    """On the circle; the perpendicular to the radius there passes the other centre at the other radius."""
    radius = z - at[item.centre]
    if item.radius.value == 0:
        return radius.real, radius.imag
    outward = item.side.value * radius / abs(radius)
    projection = (outward.conjugate() * (at[item.to] - z)).real
    return abs(radius) - item.radius.value, projection + item.to_side.value * item.to_radius.value


def distance(item: Any, at: Places) -> tuple[Any, ...]:
    """Condition: two points at a distance."""
    return (abs(at[item.end] - at[item.start]) - item.length.value,)


def line(item: Any, at: Places) -> tuple[Any, ...]:
    """Condition: a point on a line."""
    return (_off(at[item.point], at[item.through], line_ray(item, at)),)


def angle(item: Any, at: Places) -> tuple[Any, ...]:
    """Condition: two links at an angle."""
    first, second = (at[end] - at[start] for start, end in (item.first, item.second))
    return ((first.conjugate() * second * unit_vector(-item.size.value)).imag / abs(first),)


def _off(z: Any, start: Any, ray: Any) -> Any:
    """Distance from a line, positive on its left."""
    return (ray.conjugate() * (z - start)).imag / abs(ray)
