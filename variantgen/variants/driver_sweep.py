"""The motion of a variant over the range of its leading driver, and what that range is called on paper."""

from __future__ import annotations

from collections.abc import Sequence

import numpy as np
from msgspec import Struct

from variantgen.errors import InputError, Problem
from variantgen.families.family import Form
from variantgen.families.figure_hints import AngleMark
from variantgen.families.hints import DIRECTIONS
from variantgen.families.quantities import Quantity
from variantgen.mechanism.arithmetic import cross, dot
from variantgen.mechanism.linkage import Linkage
from variantgen.mechanism.motion import Field, Motion
from variantgen.mechanism.outcome import Outcome
from variantgen.mechanism.scene import references
from variantgen.mechanism.turn.sweep import FULL_TURN, LeadingDriver, Sweep, find_leading_driver, sweep
from variantgen.variants.printed_data import given_names
from variantgen.variants.variant import Variant, solve_variants

# How well an angle on paper must follow the driver to be taken for its angle, and a point lie on a line (of the size).
_SAME = 1e-6


class DriverSweep(Struct, frozen=True):
    """A sweep and its abscissa: ``values`` in degrees or metres, shape (K,).

    ``given`` is the name of the printed angle that the way changes; where it is '' the way is counted from the instant
    of the problem, and ``target`` names the body that turns or the points that move.
    """

    sweep: Sweep
    values: Field
    given: str
    target: tuple[str, ...]


def driver_sweep(variant: Variant, asked: Sequence[Quantity], samples: int = 361) -> DriverSweep:
    """The sweep of a variant over the range of its leading driver.

    Raises InputError where the variant is not solved or nothing moves.
    """
    motion = solve_variants([variant], 2)
    if not motion.solved[0]:
        raise InputError(Problem(Outcome(int(motion.outcome[0])).text, key="motion", value=variant.family.name))
    try:
        leading_driver, _ = find_leading_driver(motion.scene)
    except ValueError:
        raise InputError(
            Problem("nothing moves: all given velocities and accelerations are zero", key="motion", remedy="change one")
        ) from None
    mark, sense = _mark_of_way(variant, asked, motion, leading_driver)
    start = variant.si(mark.name) if mark else 0.0
    # A printed angle runs from 0 to a full turn; an angle turned since the instant has it in the middle.
    before = (start if sense > 0 else FULL_TURN - start) % FULL_TURN if mark else 0.5 * FULL_TURN
    found = sweep(motion, variant.form.plan, before, samples, limits(variant.form, motion))
    values = np.degrees(start + sense * found.way) if leading_driver.angular else found.way
    driver = motion.scene.drivers[leading_driver.number]
    target = references(driver, "body")[:1] if leading_driver.angular else _driven_points(driver)
    return DriverSweep(found, values, mark.name if mark else "", target)


def _driven_points(driver: object) -> tuple[str, ...]:
    """What a driver moves: one point, or two whose distance it changes."""
    named = references(driver, "point")
    return named[:2] if references(driver, "body") == () else named[:1]


def _mark_of_way(
    variant: Variant, asked: Sequence[Quantity], motion: Motion, leading_driver: LeadingDriver
) -> tuple[AngleMark | None, float]:
    """The printed angle of the leading body with a fixed direction, and whether it grows (+1) with the way."""
    if leading_driver.angular:
        body = references(motion.scene.drivers[leading_driver.number], "body")[0]
        given = given_names(variant, asked)
        for mark in variant.form.figure.angles:
            rates = [_turning(motion, mark.at, ray) for ray in (mark.start, mark.end)]
            rays = [_ray(motion, mark.at, ray) for ray in (mark.start, mark.end)]
            angle = float(np.angle(rays[1] / rays[0]))
            growth = np.sign(angle) * (rates[1] - rates[0]) / leading_driver.rate
            carried = {ray for ray in (mark.at, mark.start, mark.end) if ray in motion.scene.bodies[body]}
            if (
                mark.name in given
                and len(carried) == 2
                and min(abs(rate) for rate in rates) < _SAME * leading_driver.rate
                and abs(abs(growth) - 1.0) < _SAME
                and abs(abs(angle) - variant.si(mark.name)) < _SAME
            ):
                return mark, float(np.sign(growth))
    return None, 1.0


def _ray(motion: Motion, at: str, name: str) -> complex:
    """The direction of a ray of an angle mark on paper (any length)."""
    if name in DIRECTIONS:
        return complex(np.ravel(motion.frame.place(DIRECTIONS[name]))[0])
    return complex(motion.z[name][0] - motion.z[at][0])


def _turning(motion: Motion, at: str, name: str) -> float:
    """The angular velocity of a ray (rad/s)."""
    if name in DIRECTIONS:
        return 0.0
    ray = _ray(motion, at, name)
    first, second = (complex(motion.v[point][0]) if point in motion.v else 0.0 for point in (at, name))
    return float(cross(ray, second - first)) / abs(ray) ** 2


def limits(form: Form, motion: Motion) -> list[tuple[str, str, str]]:
    """Triples (point, start, towards) for what the equations do not know: rods, slots and walls have ends.

    A point that slides between two named ends of a rod stays between them, so does one in a slot that is
    drawn and one that the screens keep inside; a point on a wall does not pass the corner with another wall.
    """
    between = list(form.screens.inside)
    for slide in Linkage(motion.scene).slides:
        if slide.line is not None and not set(slide.line) & set(form.figure.hidden):
            between.append((slide.point, *slide.line))
    grooves = [(names[0], names[-1]) for names in form.figure.grooves if {names[0], names[-1]} <= motion.v.keys()]
    for start, end in grooves:
        between += [(p, start, end) for p in motion.v if p not in (start, end) and _is_on(motion, p, start, end)]
    found = [
        (point, start, end)
        for point, one, other in between
        for start, end in ((one, other), (other, one))
        if _is_ahead(motion, point, one, other) and _is_ahead(motion, point, other, one)
    ]
    walls = [names for names in form.figure.walls if len(names) == 2]
    for wall in walls:
        corners = [name for name in wall if sum(name in other for other in walls) > 1]
        for corner in corners:
            far = wall[0] if wall[1] == corner else wall[1]
            found += [(p, corner, far) for p in motion.v if p not in wall and _is_on(motion, p, corner, far)]
    return found


def _is_ahead(motion: Motion, point: str, start: str, towards: str) -> bool:
    z = motion.z
    return bool(dot(z[towards] - z[start], z[point] - z[start])[0] > 0)


def _is_on(motion: Motion, point: str, start: str, towards: str) -> bool:
    """Whether a point lies on a line, ahead of its start."""
    z = motion.z
    aside = cross(z[towards] - z[start], z[point] - z[start])[0]
    return _is_ahead(motion, point, start, towards) and bool(abs(aside) < _SAME * abs(z[towards] - z[start])[0] ** 2)
