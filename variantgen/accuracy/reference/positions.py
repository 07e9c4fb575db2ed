"""Positions of one variant to many digits: every construction from its definition, written anew.

A function bears the name of the kind of construction. It finds the point by another formula than the solver does, or by
plain algebra; :mod:`variantgen.accuracy.reference.definitions` checks the point by substitution. All numbers are those
of mpmath; ``at`` holds the points placed so far, in the frame of the scene.
"""

from __future__ import annotations

from collections.abc import Callable, Mapping
from typing import Any

from variantgen.accuracy.precise import mpmath, unit_vector

Places = Mapping[str, Any]


class NoSuchPointError(ArithmeticError):
    """The point that a construction defines does not exist: the variant does not assemble."""


def construction(kind: str) -> Callable[[Any, Places], Any] | None:
    """The function that places a point by a kind of construction, if there is one."""
    found: Callable[[Any, Places], Any] | None = globals().get(kind) if not kind.startswith("_") else None
    return found


def coordinates(item: Any, at: Places) -> Any:
    """``x + i y``."""
    return mpmath().mpc(item.x.value, item.y.value)


def near(item: Any, at: Places) -> Any:
    """The picture, from which :mod:`variantgen.accuracy.reference.simultaneous_positions` goes on."""
    return coordinates(item, at)


def polar(item: Any, at: Places) -> Any:
    """At a distance and an angle from the x axis or from a ray."""
    start = at[item.origin]
    angle = item.angle.value
    if item.towards is not None:
        angle = angle + mpmath().arg(_apart(at[item.towards] - start))
    return start + item.distance.value * mpmath().expj(angle)


def on_body(item: Any, at: Places) -> Any:
    """By coordinates on a body."""
    step = _apart(at[item.towards] - at[item.origin])
    return at[item.origin] + mpmath().mpc(item.along.value, item.across.value) * step / abs(step)


def fraction(item: Any, at: Places) -> Any:
    """Divides a segment."""
    return (1 - item.part.value) * at[item.start] + item.part.value * at[item.end]


def foot(item: Any, at: Places) -> Any:
    """The foot of a perpendicular is the crossing of the line with that through the point at a right angle."""
    ray = line_ray(item, at)
    return _crossing(at[item.through], ray, at[item.of], 1j * ray)


def line_line(item: Any, at: Places) -> Any:
    """The crossing of two lines."""
    first = _ray(at, item.first, item.first_angle, item.first_towards)
    second = _ray(at, item.second, item.second_angle, item.second_towards)
    return _crossing(at[item.first], first, at[item.second], second)


def line_circle(item: Any, at: Places) -> Any:
    """``|through + s u - centre| = r`` is quadratic in s; the branch takes the larger (+1) or smaller (-1) root."""
    ray = line_ray(item, at)
    gap = at[item.through] - at[item.centre]
    half = (ray.conjugate() * gap).real
    rest = abs(gap) ** 2 - item.distance.value**2
    square = half**2 - rest
    if square < 0:
        raise NoSuchPointError("the line does not meet the circle")
    return at[item.through] + (-half + item.branch.value * mpmath().sqrt(square)) * ray


def circle_circle(item: Any, at: Places) -> Any:
    """By the law of cosines: the angle at the first centre between the line of centres and the radius."""
    step = _apart(at[item.second] - at[item.first])
    d, r, s = abs(step), item.first_distance.value, item.second_distance.value
    cosine = (r**2 + d**2 - s**2) / (2 * r * d)
    if abs(cosine) > 1:
        raise NoSuchPointError("the circles do not meet")
    return at[item.first] + r * step / d * mpmath().expj(item.side.value * mpmath().acos(cosine))


def tangent(item: Any, at: Places) -> Any:
    """The end of the radius at a right angle to the thread, which is turned out of the line of centres."""
    step = _apart(at[item.to] - at[item.centre])
    sine = (item.side.value * item.radius.value - item.to_side.value * item.to_radius.value) / abs(step)
    if abs(sine) >= 1:
        raise NoSuchPointError("the drums overlap")
    ray = step / abs(step) * mpmath().expj(-mpmath().asin(sine))
    return at[item.centre] + 1j * item.side.value * item.radius.value * ray


def line_ray(item: Any, at: Places) -> Any:
    """Unit vector of the line ``through`` a point along ``angle`` or ``towards`` another."""
    return _ray(at, item.through, item.angle, item.towards)


def _ray(at: Places, start: str, angle: Any, towards: str | None) -> Any:
    if towards is None:
        return unit_vector(angle.value)
    step = _apart(at[towards] - at[start])
    return step / abs(step)


def _crossing(first: Any, u: Any, second: Any, w: Any) -> Any:
    """``first + s u = second + t w`` solved for s: multiplied by the conjugate of w, the imaginary parts are equal."""
    sine = (w.conjugate() * u).imag
    if sine == 0:
        raise NoSuchPointError("the lines are parallel")
    return first + (w.conjugate() * (second - first)).imag / sine * u


def _apart(step: Any) -> Any:
    if step == 0:
        raise NoSuchPointError("two points coincide")
    return step
