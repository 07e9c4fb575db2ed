"""What can be solved and is hardly meant: a pin off its slot, a rope on the wrong side of a pulley or through a wheel.

Such scenes have answers, so they are no errors; their authors hear of it.
"""

from __future__ import annotations

import math
from collections.abc import Iterator
from itertools import pairwise

import numpy as np
from msgspec.structs import replace

from variantgen.errors import Problem
from variantgen.mechanism.arithmetic import Complex, Real, cross, dot, unit_towards
from variantgen.mechanism.joint import JointCircle
from variantgen.mechanism.joints.guide import Guide
from variantgen.mechanism.joints.rope import Rope
from variantgen.mechanism.joints.slot import Slot
from variantgen.mechanism.motion import Motion
from variantgen.mechanism.rows import Placement
from variantgen.mechanism.scene import label

_OFF = 1e-6  # of the length of a line: less is rounding
_THROUGH = 0.02  # of a radius: how far inside a circle a rope must run to be noticed
_WOUND = math.radians(200)  # more of a pulley than this has no rope on it that is meant
_ALONG = math.radians(0.5)  # a rope that hangs along a guide
_SIDES = {1.0: "left", -1.0: "right"}


def doubts(motion: Motion) -> list[Problem]:
    """What is hardly meant in the first variant of a solved batch, each with its key and a remedy."""
    at = Placement({name: complex(z[0]) for name, z in motion.z.items()}, motion.scene.frame)
    circles = [circle for joint in motion.scene.joints for circle in joint.circles(at)]
    found: list[Problem] = []
    for joint in motion.scene.joints:
        if isinstance(joint, Slot):
            found += _off_its_line(joint, at)
        elif isinstance(joint, Rope) and not joint.parallel:
            guides = {j.point: j for j in motion.scene.joints if isinstance(j, Guide)}
            found += [*_wound(joint, at), *_aslant(joint, guides, at), *_through(joint, circles, at)]
    return found


def _off_its_line(slot: Slot, at: Placement) -> Iterator[Problem]:
    """The point of a slot beside the line it slides along."""
    first, second = (at.z[name] for name in slot.along)
    off = abs(_number(cross(unit_towards(first, second)[0], at.z[slot.point] - first)))
    if off > _OFF * max(abs(second - first), abs(at.z[slot.point] - first)):
        line = "".join(slot.along)
        yield Problem(
            f"{slot.point} is {1000 * off:.4g} mm beside the line {line} that it slides along, and keeps that distance",
            key=f"joints.{label(slot)}",
            value=slot.point,
            remedy=f"if it is on the line, place {slot.point} by it, or {slot.along[1]} towards {slot.point}; where one"
            " name stands for two places, each needs its own",
        )


def _wound(rope: Rope, at: Placement) -> Iterator[Problem]:
    """Pulleys that the rope goes round by much more than half a turn, and by less on their other side."""
    for number in range(1, len(rope.path) - 1):
        turn, other = _turn(rope, number, at), _turn(_turned_over(rope, number), number, at)
        if turn > _WOUND and other < turn:
            bend = rope.path[number]
            yield Problem(
                f"the rope goes round {bend.point} by {math.degrees(turn):.0f} degrees",
                key=f"joints.{label(rope)}.path[{number + 1}].side",
                value=_side(bend.side),
                remedy=f'with side = "{_side(-bend.side)}" it goes round by {math.degrees(other):.0f} degrees',
            )


def _turn(rope: Rope, number: int, at: Placement) -> float:
    """The angle (rad) by which a rope goes round one of its inner stations; 0 at a point."""
    bend = rope.path[number]
    if _number(bend.radius) == 0 or not np.all(rope.sound(at)):
        return 0.0
    pieces = rope.pieces(at)
    arriving, leaving = (complex(np.ravel(pieces[i][0])[0]) for i in (number - 1, number))
    turned = np.angle(leaving / arriving) * -_number(bend.side) * _number(at.frame.sense)
    return 0.0 if math.isclose(turned % math.tau, math.tau, abs_tol=1e-6) else float(turned % math.tau)


def _aslant(rope: Rope, guides: dict[str, Guide], at: Placement) -> Iterator[Problem]:
    """Loads that a rope pulls aslant to their guide, where on the other side of its pulley it would run along it."""
    last = len(rope.path) - 1
    for end, pulley in ((0, 1), (last, last - 1)):
        point, round_it = rope.path[end].point, rope.path[pulley]
        if point not in guides or rope.path[end].body is not None or _number(round_it.radius) == 0:
            continue
        way = at.frame.direction(guides[point].angle)
        over = _turned_over(rope, pulley)
        now, then = (abs(_number(cross(r.pieces(at)[0 if end == 0 else -1][0], way))) for r in (rope, over))
        if np.all(over.sound(at)) and now > math.sin(_ALONG) > then:
            yield Problem(
                f"the rope to {point} makes {math.degrees(math.asin(min(1.0, now))):.0f} degrees with its guide",
                key=f"joints.{label(rope)}.path[{pulley + 1}].side",
                value=_side(round_it.side),
                remedy=f'with side = "{_side(-round_it.side)}" it runs along the guide',
            )


def _through(rope: Rope, circles: list[JointCircle], at: Placement) -> Iterator[Problem]:
    """Wheels and pulleys that a free part of the rope passes through, but those on an axle where the part ends."""
    for (first, second), (ray, length) in zip(pairwise(rope.path), rope.pieces(at), strict=True):
        start: Complex = at.z[first.point] + 1j * at.frame.sense * first.side * first.radius * ray
        ends = [at.z[first.point], at.z[second.point]]
        noticed: set[str] = set()
        for circle in circles:
            radius, step = _number(circle.radius), at.z[circle.centre] - start
            foot = _number(dot(ray, step))
            beside = abs(_number(cross(ray, step)))
            own = min(abs(at.z[circle.centre] - end) for end in ends) <= _OFF * radius
            if own or circle.centre in noticed or not 0 < foot < _number(length) or beside >= (1 - _THROUGH) * radius:
                continue
            noticed.add(circle.centre)
            yield Problem(
                f"the rope from {first.point} to {second.point} passes through the circle about {circle.centre}",
                key=f"joints.{label(rope)}.path",
                value=f"{round(1000 * beside, 3):g} mm from its centre, radius {1000 * radius:.4g} mm",
                remedy="look at the sides and places of its stations, or let the rope pass over that circle, too",
            )


def _turned_over(rope: Rope, number: int) -> Rope:
    """The rope on the other side of one of its stations."""
    path = list(rope.path)
    path[number] = replace(path[number], side=-path[number].side)
    return replace(rope, path=tuple(path))


def _side(side: Real) -> str:
    return _SIDES[_number(side)]


def _number(value: Real) -> float:
    """The value of the first variant."""
    return float(np.ravel(value)[0])
