"""An inextensible thread: its ends have the same velocity along it, also where fixed pulleys bend it.

The end may be a load, the centre of a wheel, or a point where the thread runs off a drum or a movable pulley without
slipping: that point of the body has the velocity of the thread (guide, examples 29 and 34).
"""

from __future__ import annotations

from msgspec.structs import replace

from variantgen.mechanism.joints.rope import Bend, Rope
from variantgen.methods.groups.contact import ContactSide, NoSlipContact, letter_at, metres, resting_letter
from variantgen.methods.linkage.problem import Task

_STILL = 1e-9  # of the largest velocity: a piece of thread that turns slower keeps its direction


def contact(task: Task, number: int) -> NoSlipContact | None:
    """The two ends; None where a pulley in between moves, a piece of the thread turns, or it only closes a belt."""
    joint = task.scene.joints[number]
    assert isinstance(joint, Rope)
    if joint.closing:
        return None
    pieces = [complex(ray) for ray, _ in joint.pieces(metres(task))]
    if not all(bend.fixed for bend in joint.path[1:-1]) or not _keeps_direction(task, joint, pieces):
        return None
    ends = (joint.path[0], joint.path[-1])
    first, second = (
        _side(task, joint, bend, ray, number, i)
        for i, (bend, ray) in enumerate(zip(ends, (pieces[0], pieces[-1]), strict=True))
    )
    if first.is_rest:
        second = _tied(task, second)
    elif second.is_rest:
        first = _tied(task, first)
    file = "belt" if joint.belt else "rope"
    return NoSlipContact(file, first, second, place=f"{file}.leaves", reason=f"{file}.inextensible")


def _tied(task: Task, side: ContactSide) -> ContactSide:
    """The end of a thread of which the other one is fixed: the point of a body there has no velocity along it."""
    return replace(side, name=resting_letter(task, side.body, side.name)) if side.lever else side


def _keeps_direction(task: Task, joint: Rope, pieces: list[complex]) -> bool:
    """Whether no straight piece turns: the stations have no velocities across it, or from rest no accelerations."""
    motion = task.now.v if any(task.now.v.values()) or not task.now.a else task.now.a
    top = max(abs(vector) for vector in motion.values())
    swings = [
        abs((1j * ray * motion[bend.point].conjugate()).real)
        for bends, ray in zip(zip(joint.path, joint.path[1:], strict=False), pieces, strict=True)
        for bend in bends
        if not bend.fixed
    ]
    return all(swing <= _STILL * top for swing in swings)


def _side(task: Task, rope: Rope, bend: Bend, ray: complex, number: int, end: int) -> ContactSide:
    """An end of a thread, whose straight piece there has the direction ``ray``."""
    if bend.fixed:
        return ContactSide(bend.point, "", ray)
    if bend.body is None:
        return ContactSide(bend.point, bend.point, ray)
    turn = float(task.scene.frame.sense) * float(bend.side)
    radius = float(bend.radius) / task.length_unit
    place = task.now.z[bend.point] + 1j * turn * radius * ray
    return ContactSide(
        letter_at(task, place, (bend.body,), number, end),
        bend.point,
        ray,
        bend.body,
        radius,
        -round(turn),
        belt=rope.belt,
    )
