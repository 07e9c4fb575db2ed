"""A wheel on a straight line: a rack, belt or plank that translates, or something at rest (guide, section 4.1)."""

from __future__ import annotations

from variantgen.mechanism.joints.rolling import Rolling
from variantgen.methods.groups.contact import ContactSide, NoSlipContact, resting_letter
from variantgen.methods.groups.group import PointPath
from variantgen.methods.linkage.problem import Task

_SIDEWAYS = 1e-9  # of a vector: what is smaller is rounding


def contact(task: Task, number: int) -> NoSlipContact | None:
    """The contact with the line; None where the line turns, because then it carries the contact along."""
    joint = task.scene.joints[number]
    assert isinstance(joint, Rolling)
    if joint.on is not None and joint.on not in task.translating:
        return None
    arm = task.now.z[joint.contact] - task.now.z[joint.centre]
    line = 1j * arm / abs(arm)
    radial = (joint.centre, joint.contact)
    name = joint.contact if joint.on else resting_letter(task, joint.body, joint.contact)
    wheel = ContactSide(name, joint.centre, line, joint.body, abs(arm), 1, radial)
    rail = ContactSide(name, _point_of(task, joint), line, radial=radial)
    point_path = PointPath(joint.centre, line=line) if _is_along(task, joint.centre, line) else None
    return NoSlipContact("rack", wheel, rail, point_path, reason="rack.no_slip", rail=joint.on or "")


def _point_of(task: Task, joint: Rolling) -> str:
    """A point of the translating line: one whose motion is given, if there is one. Empty for a line at rest."""
    if joint.on is None or joint.on_point is None:
        return ""
    given = {point for driver in task.scene.drivers for shape in driver.shapes() for point in shape.points}
    return next((point for point in task.scene.bodies[joint.on] if point in given), joint.on_point)


def _is_along(task: Task, point: str, line: complex) -> bool:
    """Whether a point moves along a line: its rail does not move sideways."""
    vectors = [task.now.v[point], *([task.now.a[point]] if task.now.accelerated else [])]
    return all(abs((vector * line.conjugate()).imag) <= _SIDEWAYS * abs(vector) for vector in vectors)
